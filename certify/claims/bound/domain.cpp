#include <algorithm>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

#include "certify/claims/bound/triangles.h"

namespace epsnet::certify {
namespace {

using Word = IsometryRows::Word;

/// Operations of balls for the image of the centre, and for a corner and its turn.
constexpr std::uint64_t kRowOperations = 120;

/// The words of the pair and then of its images, from the chart of the net's vertex to itself.
NetDocument words_of(const NetDocument& net, const BoundSymmetry& symmetry, const Budget& budget) {
  const SurfaceSides sides(net.surface);
  const std::uint32_t chart = net.vertices[0].chart;
  NetDocument result;
  result.surface = net.surface;
  result.charts = net.charts;
  const Word& path = symmetry.paths[net.charts[chart].tile];
  const auto add = [&](const Word& word) {
    // The evaluator keeps a copy.
    budget.spend(memory_work(2 * sizeof(std::uint32_t)), 2 * path.size() + word.size());
    Word whole;
    whole.reserve(2 * path.size() + word.size());
    std::transform(path.rbegin(), path.rend(), std::back_inserter(whole), [&](auto s) { return sides.partner[s]; });
    whole.insert(whole.end(), word.begin(), word.end());
    whole.insert(whole.end(), path.begin(), path.end());
    result.labels.push_back({chart, chart, std::move(whole)});
  };
  for (const Word& word : symmetry.pair) add(word);
  for (const IsometryRows::Isometry& row : symmetry.isometries) {
    for (std::size_t k = 0; k < 2; ++k) add(row.images[k]);
  }
  return result;
}

/// The vector of a row.
BallVector vector_of(BallVector row) {
  row[2] = -row[2];
  return row;
}

/// ⟨u × v, w⟩ = det(u, v, w).
BallVector lorentz_cross(const BallVector& u, const BallVector& v) {
  return vector_of(cross_product(u, v, Precision::bits()));
}

/// The traceless parts of two elements with Re a > 0, and their product: a basis if the axes cross.
using AxisBasis = std::array<BallVector, 3>;

/// Nothing if balls do not tell the signs of the elements.
std::optional<AxisBasis> axis_basis(BallIsometry x, BallIsometry y) {
  choose_sign(x);
  choose_sign(y);
  if (certainly_positive(real(x.a)) != Tri::yes || certainly_positive(real(y.a)) != Tri::yes) return std::nullopt;
  BallVector u = vector_of(traceless_row(x));
  BallVector v = vector_of(traceless_row(y));
  BallVector w = lorentz_cross(u, v);
  return AxisBasis{std::move(u), std::move(v), std::move(w)};
}

BallVector combination(const std::array<Ball, 3>& c, const AxisBasis& basis) {
  BallVector result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = c[0] * basis[0][i] + c[1] * basis[1][i] + c[2] * basis[2][i];
  return result;
}

BallVector difference(const BallVector& u, const BallVector& v) { return {u[0] - v[0], u[1] - v[1], u[2] - v[2]}; }

/// The point of the hyperboloid on a line through 0, if the line meets it.
struct Meet {
  Tri exists;
  BallVector point;
};

Meet meet(BallVector c, slong precision) {
  const Ball square = -lorentz_product(c, c, precision);
  const Tri is_timelike = certainly_positive(square);
  const int side = certain_sign(c[2]);
  if (is_timelike != Tri::yes || side == 0) return {is_timelike == Tri::no ? Tri::no : Tri::unknown, {}};
  const Ball scale = side / sqrt(square);
  for (Ball& x : c) x = x * scale;
  return {Tri::yes, std::move(c)};
}

}  // namespace

Domain::Domain(const NetDocument& net, const BoundSymmetry& symmetry, const LabelParts& parts)
    : symmetry_(symmetry), words_(words_of(net, symmetry, parts.budget)), evaluator_(words_, parts) {}

Domain::Placed Domain::place(slong precision, slong cap, unsigned threads) const {
  const Precision scope(precision);
  const std::size_t rows = symmetry_.isometries.size();
  evaluator_.budget().spend(kRowOperations * ball_work(static_cast<std::uint64_t>(precision)), rows + 1);
  std::vector<std::uint32_t> numbers(words_.labels.size());
  std::iota(numbers.begin(), numbers.end(), 1U);
  const std::vector<BallIsometry> value = evaluator_.evaluate(numbers, precision, cap, threads);
  const auto open = [](std::size_t row) { return Placed{Tri::unknown, row, {}}; };

  const BallVector centre = unit_vector(identity_isometry(), symmetry_.centre[0], symmetry_.centre[1], precision);
  const std::optional<AxisBasis> basis = axis_basis(value[0], value[1]);
  if (!basis) return open(0);
  // The dual basis is (v × w, w × u, w)/⟨w, w⟩.
  const auto& [u, v, w] = *basis;
  const Ball square = lorentz_product(w, w, precision);
  std::array<Ball, 3> weights;
  const std::array<BallVector, 3> dual{lorentz_cross(v, w), lorentz_cross(w, u), w};
  for (std::size_t i = 0; i < 3; ++i) weights[i] = lorentz_product(dual[i], centre, precision) / square;

  // By isometry f, the normal of the points that are as far from the centre as from its image.
  std::vector<BallVector> normal;
  for (std::size_t i = 0; i < rows; ++i) {
    const std::optional<AxisBasis> images = axis_basis(value[2 * i + 2], value[2 * i + 3]);
    if (!images) return open(i);
    BallVector image = combination(weights, *images);
    if (!symmetry_.isometries[i].preserves_orientation) image = {-image[0], -image[1], -image[2]};
    normal.push_back(difference(centre, image));
  }
  std::vector<BallVector> corner;
  for (std::size_t i = 0; i < rows; ++i) {
    Meet found = meet(lorentz_cross(normal[i], normal[(i + 1) % rows]), precision);
    if (found.exists != Tri::yes) return {found.exists, i, {}};
    corner.push_back(std::move(found.point));
  }
  Placed result;
  for (std::size_t i = 0; i < rows; ++i) {
    const BallVector& next = corner[(i + 1) % rows];
    const Tri turns = certainly_positive(lorentz_product(lorentz_cross(centre, corner[i]), next, precision));
    if (turns != Tri::yes) return {turns, i, {}};
    result.triangles.push_back({centre, corner[i], next});
  }
  return result;
}

}  // namespace epsnet::certify
