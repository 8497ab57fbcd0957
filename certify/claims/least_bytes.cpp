#include "certify/claims/least_bytes.h"

namespace epsnet::certify {
namespace {

std::uint64_t digits(const mpq_class& x) {
  const std::uint64_t numerator = mpz_sizeinbase(x.get_num_mpz_t(), 10);
  return x.get_den() == 1 ? numerator : numerator + mpz_sizeinbase(x.get_den_mpz_t(), 10);
}

std::uint64_t digits(const RationalPoint& z) { return digits(z.x) + digits(z.y); }

/// A letter of a word and its comma.
std::uint64_t letters(const std::vector<std::uint32_t>& word) { return 2 * word.size(); }

}  // namespace

std::uint64_t least_bytes(const NetDocument& document) {
  std::uint64_t bytes = document.epsilon.size();
  for (const SurfaceDocument::Tile& tile : document.surface.tiles) {
    for (const RationalPoint& vertex : tile) bytes += 8 + digits(vertex);
  }
  bytes += 10 * document.surface.gluing.size();
  for (const NetDocument::Chart& chart : document.charts) bytes += 10 + digits(chart.centre);
  for (const NetDocument::Label& label : document.labels) bytes += 9 + letters(label.word);
  bytes += 8 * document.vertices.size() + 18 * document.triangles.size();
  if (document.collars) {
    for (const NetDocument::Collar& collar : *document.collars) bytes += 64 + letters(collar.core);
  }
  return bytes;
}

std::uint64_t least_bytes(const GeodesicsDocument& document) {
  std::uint64_t bytes = least_bytes(document.net) + document.up_to.size();
  for (const GeodesicsDocument::ClosedGeodesic& geodesic : document.geodesics) bytes += 52 + letters(geodesic.word);
  bytes += 34 * document.clusters.size();
  for (const GeodesicsDocument::Piece& piece : document.pieces) bytes += 26 + 6 * piece.boundaries.size();
  return bytes;
}

std::uint64_t least_bytes(const DistanceDocument& document) {
  std::uint64_t bytes = least_bytes(document.net) + 64 + digits(document.point.z);
  for (const std::vector<std::uint32_t>& path : document.paths) bytes += 3 + letters(path);
  return bytes;
}

std::uint64_t least_bytes(const BoundDocument& document) {
  std::uint64_t bytes = least_bytes(document.net);
  for (const BoundDocument::Triangulation& row : document.triangulations) bytes += 4 + letters(row.flips);
  for (const std::vector<std::uint32_t>& row : document.cells) bytes += 2 + letters(row);
  return bytes;
}

}  // namespace epsnet::certify
