#pragma once

#include <cstdint>
#include <vector>

/// Triangulations as combinatorial data, and what makes one of another (docs/proof.md, section 15).
namespace epsnet::certify {

/// What is across each dart, and the element that leads from the dart's start to its end: 2k for element k and 2k + 1
/// for its inverse.
struct Map {
  std::vector<std::uint32_t> opposite;
  std::vector<std::uint32_t> element;
};

/// Two elements one after the other: what becomes of the diagonal of a flip.
struct Product {
  std::uint32_t first;
  std::uint32_t second;
};

/// Replaces the edge of dart d by the other diagonal, the element of number `diagonal`; its product is returned. The
/// triangles abc and bax, d from a to b, become xca and cxb: d is then from x to c. They are different.
Product flip(Map& map, std::uint32_t d, std::uint32_t diagonal);

/// A triangulation with more vertices than one, which is cut into cells. A dart from a to b with the element g leads
/// from the point of a to g of that of b.
struct Base {
  /// The point of a new vertex: in the middle between that of `from` and what the element makes of that of `to`.
  struct Midpoint {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t element;
  };

  Map map;
  std::vector<std::uint32_t> start;  ///< By dart: its vertex.
  std::vector<Midpoint> midpoints;   ///< Of vertex 1 and so on.
};

Product flip(Base& base, std::uint32_t d, std::uint32_t diagonal);

/// Splits the edge of dart d, `one` the number of the identity: the triangles abc and bax, d from a to b, become amc,
/// bmx and the last ones mbc, max. They are different.
void split(Base& base, std::uint32_t d, std::uint32_t one);

}  // namespace epsnet::certify
