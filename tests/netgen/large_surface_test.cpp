#include <gtest/gtest.h>
#include <sstream>
#include <string>

#include "certify/file/file.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet::large_surface_test {
namespace {

// The text `about` would have more than the 1 MiB that a file may have.
TEST(DeepLargeSurface, OfGenus6500HasAFileThatIsRead) {
  const Surface surface = fenchel_nielsen_surface(random_coordinates(PantsGraph::random(6500, 1), 1));
  EXPECT_LE(surface.about().size(), std::size_t{1} << 20);
  EXPECT_NE(surface.about().find(" more edges"), std::string::npos);
  std::ostringstream file;
  certify::write_file(to_document(surface), file);
  EXPECT_EQ(parse_surface_file(file.str(), "the file").genus(), 6500U);
}

}  // namespace
}  // namespace epsnet::large_surface_test
