#include "certify/claims/eigenvalues/halved_net.h"

#include "certify/lifted/lorentz.h"
#include "certify/net/darts.h"

namespace epsnet::certify {
namespace {

/// By dart its opposite, and by triangle its vertices.
struct Triangles {
  std::vector<std::uint32_t> opposite;
  std::vector<std::array<std::uint32_t, 3>> vertices;
};

/// By dart the number of its side: the place of the smaller of its two darts among all of these.
std::vector<std::uint32_t> sides_of(const std::vector<std::uint32_t>& opposite) {
  std::vector<std::uint32_t> result(opposite.size());
  std::uint32_t sides = 0;
  for (std::uint32_t dart = 0; dart < opposite.size(); ++dart)
    result[dart] = dart < opposite[dart] ? sides++ : result[opposite[dart]];
  return result;
}

/// Triangle t becomes 4t + i = (v_i, m_i, m_{i−1}), and 4t + 3 = (m_0, m_1, m_2).
Triangles halved(const Triangles& whole, std::uint32_t vertices) {
  const std::vector<std::uint32_t> side = sides_of(whole.opposite);
  Triangles result;
  result.opposite.resize(4 * whole.opposite.size());
  result.vertices.resize(4 * whole.vertices.size());
  for (std::uint32_t dart = 0; dart < whole.opposite.size(); ++dart) {
    const std::uint32_t t = dart / 3;
    const std::uint32_t i = dart % 3;
    const std::uint32_t before = (i + 2) % 3;
    const std::uint32_t small = 4 * t + i;
    const std::uint32_t inner = 4 * t + 3;
    const std::uint32_t middle = vertices + side[dart];
    result.vertices[small] = {whole.vertices[t][i], middle, vertices + side[3 * t + before]};
    result.vertices[inner][i] = middle;
    // The half of the dart at corner i, and the other half of its opposite, at the corner where that ends.
    const std::uint32_t across = whole.opposite[dart];
    const std::uint32_t other = 3 * (4 * (across / 3) + next_dart(across) % 3) + 2;
    const std::uint32_t half = 3 * small;
    const std::uint32_t inner_dart = 3 * inner + before;
    result.opposite[half] = other;
    result.opposite[other] = half;
    result.opposite[half + 1] = inner_dart;
    result.opposite[inner_dart] = half + 1;
  }
  return result;
}

using Corners = std::array<BallVector, 3>;

/// ⟨v − w, v − w⟩ = 4 sinh²(d/2)
Ball squared_distance(const BallVector& v, const BallVector& w) {
  return sqr(v[0] - w[0]) + sqr(v[1] - w[1]) - sqr(v[2] - w[2]);
}

/// The unit vector of the point in the middle, where |v + w|² is 4 + 4 sinh²(d/2).
BallVector middle(const BallVector& v, const BallVector& w) {
  const Ball scale = rsqrt(4 + squared_distance(v, w));
  return {scale * (v[0] + w[0]), scale * (v[1] + w[1]), scale * (v[2] + w[2])};
}

void add_flat_sides(const Corners& v, std::uint32_t halvings, std::vector<std::array<Ball, 3>>& result) {
  if (halvings == 0) {
    result.push_back({squared_distance(v[1], v[2]), squared_distance(v[2], v[0]), squared_distance(v[0], v[1])});
    return;
  }
  const Corners m{middle(v[0], v[1]), middle(v[1], v[2]), middle(v[2], v[0])};
  for (std::size_t i = 0; i < 3; ++i) add_flat_sides({v[i], m[i], m[(i + 2) % 3]}, halvings - 1, result);
  add_flat_sides(m, halvings - 1, result);
}

}  // namespace

HalvedSizes halved_sizes(const NetDocument& net, std::uint32_t halvings) {
  std::uint64_t sides = 3 * std::uint64_t{net.triangles.size()} / 2;
  std::uint64_t vertices = net.vertices.size();
  for (std::uint32_t i = 0; i < halvings; ++i) {
    vertices += sides;
    sides *= 4;
  }
  return {sides, vertices};
}

HalvedNet halved_net(const NetDocument& net, std::uint32_t halvings) {
  Triangles triangles;
  for (const NetDocument::Triangle& triangle : net.triangles) {
    triangles.opposite.insert(triangles.opposite.end(), triangle.opposite.begin(), triangle.opposite.end());
    triangles.vertices.push_back(triangle.vertex);
  }
  for (std::uint32_t i = 0; i < halvings; ++i)
    triangles = halved(triangles, static_cast<std::uint32_t>(halved_sizes(net, i).vertices));
  HalvedNet result;
  const std::vector<std::uint32_t> side = sides_of(triangles.opposite);
  for (std::size_t dart = 0; dart < side.size(); dart += 3)
    result.sides.push_back({side[dart], side[dart + 1], side[dart + 2]});
  result.vertices = std::move(triangles.vertices);
  return result;
}

std::vector<std::array<Ball, 3>> flat_sides(const NetDocument& net, const std::vector<BallIsometry>& labels,
                                            std::uint32_t t, std::uint32_t halvings) {
  Corners corners;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const NetDocument::Vertex& vertex = looked_up(net.vertices, start(net, 3 * t + i), "there is no vertex");
    const std::uint32_t label = corner_label(net, 3 * t + i);
    corners[i] = unit_vector(label == 0 ? identity_isometry() : looked_up(labels, label - 1, "there is no label"),
                             vertex.x, vertex.y, Precision::bits());
  }
  std::vector<std::array<Ball, 3>> result;
  add_flat_sides(corners, halvings, result);
  return result;
}

}  // namespace epsnet::certify
