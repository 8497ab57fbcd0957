#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "certify/net/rules.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace

/// Any bytes are matrices or give a MatricesError. With tiles, few and small, they make a surface or give one; the
/// certifier agrees that it is a surface, its matrices are read back, and make a surface of the same genus.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) try {
  constexpr std::size_t kMostBytes = 4000;
  constexpr std::size_t kMostGenerators = 8;
  constexpr std::uint32_t kMostSides = 30;
  const auto matrices = epsnet::parse_matrices(std::string(reinterpret_cast<const char*>(data), size));
  if (size > kMostBytes || !matrices.tile || matrices.numbers.size() > kMostGenerators) return 0;
  if (matrices.tile->p > kMostSides || matrices.tile->q > kMostSides) return 0;
  const epsnet::Surface surface = epsnet::surface_of_matrices(matrices).surface;
  require(surface.regular_tile() == matrices.tile);
  require(epsnet::certify::check_surface(epsnet::to_document(surface)).report.verdict ==
          epsnet::certify::Verdict::verified);
  const auto again = epsnet::surface_of_matrices(epsnet::parse_matrices(epsnet::write_matrices(surface)));
  require(again.surface.genus() == surface.genus() && again.surface.gluing().size() == surface.gluing().size());
  return 0;
} catch (const epsnet::MatricesError&) {
  return 0;
}
