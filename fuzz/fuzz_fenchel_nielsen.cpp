#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "fuzz/nets.h"
#include "netgen/surfaces/fenchel_nielsen.h"

namespace {

using epsnet::FenchelNielsen;
using epsnet::PantsGraph;
using epsnet::Rational;
using fuzz::Bytes;

/// Returns a graph of genus 2 or 3, mostly 2: pairs the ends of all pants in an order that the bytes choose. Returns
/// nullopt if the graph is not connected.
std::optional<PantsGraph> graph(Bytes& bytes) {
  const std::uint32_t nodes = bytes.byte() % 4 == 3 ? 4 : 2;
  std::vector<std::uint32_t> ends;
  for (std::uint32_t node = 0; node < nodes; ++node) ends.insert(ends.end(), 3, node);
  for (std::size_t i = ends.size(); i > 1; --i) std::swap(ends[i - 1], ends[bytes.byte() % i]);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t i = 0; i < ends.size(); i += 2) edges.emplace_back(ends[i], ends[i + 1]);
  try {
    return PantsGraph(edges);
  } catch (const epsnet::PantsGraphError&) {
    return std::nullopt;
  }
}

/// Returns a length between 1e-12 and 30.
Rational length(Bytes& bytes) {
  const unsigned exponent = bytes.byte() % 14;
  const Rational mantissa(1 + bytes.byte() % 30, 10);
  return exponent == 0 ? Rational(10 * mantissa)
                       : Rational(mantissa / pow(boost::multiprecision::mpz_int(10), exponent - 1));
}

}  // namespace

/// All Fenchel–Nielsen coordinates give a surface, and for every ε a net of it is found and proved. The nets have only
/// some tens of triangles, as with sanitizers a net of ε = 1/2 on a surface of genus 4 takes seconds.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  auto pants = graph(bytes);
  if (!pants) return 0;
  FenchelNielsen coordinates{*std::move(pants), {}, {}};
  for (std::size_t e = 0; e < coordinates.graph.edges().size(); ++e) {
    coordinates.lengths.push_back(length(bytes));
    coordinates.twists.push_back(coordinates.lengths.back() * Rational(bytes.integer(), 1000));
  }
  const epsnet::Surface surface = fenchel_nielsen_surface(coordinates);  // An exception is a finding.
  fuzz::require(surface.genus() == coordinates.graph.genus());
  fuzz::require_net(surface, 2, bytes);
  return 0;
}
