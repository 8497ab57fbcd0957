#include "certify/claims/eigenvalues/forms.h"

#include <array>
#include <gmpxx.h>

#include "certify/base/error.h"
#include "certify/lifted/lifted_plane.h"
#include "certify/net/numbering.h"
#include "certify/net/structure.h"

namespace epsnet::certify {
namespace {

/// By dart its opposite, and by triangle its vertices and the phases from their frames to the triangle's.
struct Triangles {
  std::vector<std::uint32_t> opposite;
  std::vector<std::array<std::uint32_t, 3>> vertices;
  std::vector<std::array<Phase, 3>> phases;
};

/// From the frame of a dart's side, which is that of the triangle of the smaller of its two darts, to that of the
/// dart's triangle: by the end of the side where the dart starts.
Phase side_phase(const Triangles& triangles, std::uint32_t dart, const LineBundle& bundle) {
  const std::uint32_t other = triangles.opposite[dart];
  if (dart < other) return 0;
  const std::uint32_t same = next_dart(other);
  return bundle.difference(triangles.phases[dart / 3][dart % 3], triangles.phases[same / 3][same % 3]);
}

/// By dart the number of its side: the place of the smaller of its two darts among all of these.
std::vector<std::uint32_t> sides_of(const std::vector<std::uint32_t>& opposite) {
  std::vector<std::uint32_t> result(opposite.size());
  std::uint32_t sides = 0;
  for (std::uint32_t dart = 0; dart < opposite.size(); ++dart)
    result[dart] = dart < opposite[dart] ? sides++ : result[opposite[dart]];
  return result;
}

/// Triangle t becomes 4t + i = (v_i, m_i, m_{i−1}), and 4t + 3 = (m_0, m_1, m_2). These have its frame, and m_i that of
/// its side.
Triangles halved(const Triangles& whole, std::uint32_t vertices, const LineBundle& bundle) {
  const std::vector<std::uint32_t> side = sides_of(whole.opposite);
  Triangles result;
  result.opposite.resize(4 * whole.opposite.size());
  result.vertices.resize(4 * whole.vertices.size());
  result.phases.resize(4 * whole.phases.size());
  for (std::uint32_t dart = 0; dart < whole.opposite.size(); ++dart) {
    const std::uint32_t t = dart / 3;
    const std::uint32_t i = dart % 3;
    const std::uint32_t before = (i + 2) % 3;
    const std::uint32_t small = 4 * t + i;
    const std::uint32_t inner = 4 * t + 3;
    const std::uint32_t middle = vertices + side[dart];
    result.vertices[small] = {whole.vertices[t][i], middle, vertices + side[3 * t + before]};
    result.vertices[inner][i] = middle;
    const Phase middle_phase = side_phase(whole, dart, bundle);
    result.phases[small] = {whole.phases[t][i], middle_phase, side_phase(whole, 3 * t + before, bundle)};
    result.phases[inner][i] = middle_phase;
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

HalvedNet halved_net(const NetDocument& net, std::uint32_t halvings, const LineBundle& bundle) {
  std::vector<Phase> of_label{0};  // By number.
  for (const NetDocument::Label& label : net.labels) of_label.push_back(bundle.of(label.word));
  Triangles triangles;
  for (const NetDocument::Triangle& triangle : net.triangles) {
    triangles.opposite.insert(triangles.opposite.end(), triangle.opposite.begin(), triangle.opposite.end());
    triangles.vertices.push_back(triangle.vertex);
    const auto& [second, third] = triangle.label;
    triangles.phases.push_back({0, of_label[second], of_label[third]});
  }
  for (std::uint32_t i = 0; i < halvings; ++i)
    triangles = halved(triangles, static_cast<std::uint32_t>(halved_sizes(net, i).vertices), bundle);
  HalvedNet result;
  const std::vector<std::uint32_t> side = sides_of(triangles.opposite);
  for (std::uint32_t dart = 0; dart < side.size(); dart += 3) {
    result.sides.push_back({side[dart], side[dart + 1], side[dart + 2]});
    result.side_phases.push_back({side_phase(triangles, dart, bundle), side_phase(triangles, dart + 1, bundle),
                                  side_phase(triangles, dart + 2, bundle)});
  }
  result.vertices = std::move(triangles.vertices);
  result.vertex_phases = std::move(triangles.phases);
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

namespace {

constexpr std::array<std::array<std::size_t, 2>, 3> kOthers{{{1, 2}, {2, 0}, {0, 1}}};

Ball sum(const std::array<Ball, 3>& x) { return x[0] + x[1] + x[2]; }

/// 180/|T| times the integrals of x_i x_j times products of two values, where i, j are the ends of a side and k is the
/// third corner.
struct Integrals {
  long square_beside;    ///< Of the value of i, or of j,
  long square_opposite;  ///< of that of k,
  long product_beside;   ///< of those of i and j,
  long product_across;   ///< of that of k and one of the others.
};
/// Values in the midpoint opposite to each corner.
constexpr Integrals kMidpoints{3, 7, -1, 1};
/// Values in the corners.
constexpr Integrals kCorners{3, 1, 2, 1};

/// factor·∫ ω v² (Lemma 31).
SymmetricForm power_mass(const std::array<Ball, 3>& squares, const Integrals& integrals, const Ball& factor) {
  SymmetricForm result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [j, k] = kOthers[i];
    // The side opposite to i has ends j and k; i is at an end of the others.
    const Ball others = squares[j] + squares[k];
    result.square[i] = factor * (integrals.square_opposite * squares[i] + integrals.square_beside * others);
    result.product[i] = factor * (integrals.product_beside * squares[i] + integrals.product_across * others);
  }
  return result;
}

/// factor·∫ |∇v|² for the values in the corners, or a fourth of that for those in the midpoints.
SymmetricForm energy(const std::array<Ball, 3>& cotangents, const Ball& factor) {
  SymmetricForm result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [j, k] = kOthers[i];
    result.square[i] = factor * half(cotangents[j] + cotangents[k]);
    result.product[i] = -(factor * half(cotangents[i]));
  }
  return result;
}

}  // namespace

std::optional<FlatTriangle> FlatTriangle::of(const std::array<Ball, 3>& squares) {
  FlatTriangle triangle(squares);
  // Of no triangle 16|T|² is not positive, or all l_i² are negative: then |T| or R is NaN.
  if (certainly_less(triangle.cosh_, 1 + triangle.radius_) != Tri::yes) return std::nullopt;
  return triangle;
}

FlatTriangle::FlatTriangle(const std::array<Ball, 3>& squares)
    : squares_(squares),
      area_(scaled(sqrt(4 * squares[0] * squares[1] - sqr(squares[0] + squares[1] - squares[2])), -2)) {
  const Ball squared_radius = squares[0] * squares[1] * squares[2] / (16 * sqr(area_));
  radius_ = sqrt(squared_radius);
  cosh_ = sqrt(1 + squared_radius);
  mean_power_ = sum(squares) / 12;
  trace_ = squared_radius - mean_power_;
  Ball parts;  // ΣA_k²
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [i, j] = kOthers[k];
    cotangents_[k] = (squares[i] + squares[j] - squares[k]) / (4 * area_);
    parts += sqr(scaled(squares[k] * cotangents_[k], -2));
  }
  greater_ = half(trace_) + sqrt_of_nonnegative(scaled(sqr(trace_), -2) - (4 * parts - sqr(area_)) / 36);
}

Ball FlatTriangle::mean_of_inverse(const Ball& c) const {
  const Ball across = 1 - c;
  const Ball beyond = cosh_ - c;
  return 1 / across - trace_ / (2 * cosh_ * across * beyond) + greater_ / ((1 - c * cosh_) * beyond);
}

SymmetricForm FlatTriangle::least_energy() const {
  const Ball c = 1 / (1 + radius_);
  return energy(cotangents_, 4 * (c + 1 / mean_of_inverse(c)));
}

SymmetricForm FlatTriangle::greatest_mass() const {
  const Ball squared = sqr(cosh_);
  const Ball kappa = (squared + cosh_ + 1) / (squared * (cosh_ + 1));
  SymmetricForm result = power_mass(squares_, kMidpoints, -(kappa * area_ / 180));
  for (Ball& x : result.square) x += cosh_ * area_ / 3;
  return result;
}

Ball FlatTriangle::interpolation_constant() const {
  const Ball kappa = Ball::exactly(1893) / 10'000;
  return sqr(kappa) * max(max(squares_[0], squares_[1]), squares_[2]) * cosh_ * (1 + radius_);
}

Ball FlatTriangle::greatest_slope(const std::array<Ball, 3>& values) const {
  Ball twice_energy;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [i, j] = kOthers[k];
    twice_energy += cotangents_[k] * sqr(values[i] - values[j]);
  }
  return cosh_ * sqrt_of_nonnegative(twice_energy / twice(area_));
}

SymmetricForm FlatTriangle::greatest_energy() const { return energy(cotangents_, mean_of_inverse(Ball())); }

SymmetricForm FlatTriangle::least_mass() const {
  const Ball mean = 1 + mean_power_;
  const Ball density = cosh_ / (mean * sqrt(mean));
  const Ball slope = half(Ball::exactly(3)) / mean;
  SymmetricForm result = power_mass(squares_, kCorners, -(density * slope * area_ / 180));
  const Ball constant = density * (1 + slope * mean_power_) * area_ / 12;
  for (Ball& x : result.square) x += twice(constant);
  for (Ball& x : result.product) x += constant;
  return result;
}

namespace {

constexpr std::size_t kMostCharacters = 40;

/// Of a number less than 2⁶⁴, also where `unsigned long` is shorter.
std::uint64_t to_uint64(const mpz_class& x) { return std::stoull(x.get_str()); }

mpq_class in_turns(Phase phase, std::uint64_t denominator) {
  mpq_class turns(std::to_string(phase) + "/" + std::to_string(denominator));
  turns.canonicalize();
  return turns;
}

std::string sum_text(Phase sum, std::uint64_t denominator) {
  return " add up to " + in_turns(sum, denominator).get_str() + " modulo 1, not to an integer";
}

}  // namespace

Problem phases_problem(const std::vector<std::string>& phases, std::size_t sides) {
  if (phases.size() != sides)
    return "phases: " + std::to_string(phases.size()) + " elements, expected one for each of " +
           counted(sides, "side", "sides");
  const mpz_class most("1000000000000000000");
  mpz_class denominator = 1;
  return first_row_problem("phases", phases, [&](const std::string& text) -> Problem {
    const bool plain = text.size() <= kMostCharacters && text.find_first_of("eE") == std::string::npos;
    const auto phase = plain ? parse_decimal(text) : std::nullopt;
    if (!phase) return in_quotes(text) + " is not a decimal without exponent or a rational of at most 40 characters";
    if (abs(*phase) >= 1) return in_quotes(text) + " is not between -1 and 1";
    denominator = lcm(denominator, phase->get_den());
    if (denominator > most) return "the least common denominator is more than 10^18";
    return std::nullopt;
  });
}

LineBundle::LineBundle(const std::vector<std::string>& phases) {
  std::vector<mpq_class> values;
  mpz_class denominator = 1;
  for (const std::string& text : phases) denominator = lcm(denominator, values.emplace_back(decimal(text)).get_den());
  denominator_ = to_uint64(denominator);
  for (const mpq_class& value : values) {
    mpz_class numerator = value.get_num() * (denominator / value.get_den());
    if (numerator < 0) numerator += denominator;
    phases_.push_back(to_uint64(numerator));
  }
}

ComplexBall LineBundle::turn(Phase phase) const {
  const mpq_class half_turns = 2 * in_turns(phase, denominator_);
  ComplexBall result;
  fmpq_t exact;
  fmpq_init(exact);
  fmpq_set_mpq(exact, half_turns.get_mpq_t());
  arb_sin_cos_pi_fmpq(result.im(), result.re(), exact, Precision::bits());
  fmpq_clear(exact);
  return result;
}

Phase LineBundle::of(std::span<const std::uint32_t> word) const {
  Phase result = 0;
  if (phases_.empty()) return result;
  for (const std::uint32_t side : word) result = sum(result, looked_up(phases_, side, "there is no side"));
  return result;
}

Problem LineBundle::problem(const SurfaceSides& sides) const {
  const auto name = [&](const char* what, std::uint32_t side) {
    return what + std::to_string(sides.corner[side]) + " of tile " + std::to_string(sides.tile[side]);
  };
  for (std::uint32_t side = 0; side < sides.partner.size(); ++side) {
    const std::uint32_t other = sides.partner[side];
    if (const Phase both = of(std::array{side, other}); both != 0)
      return "those of " + name("side ", side) + " and " + name("side ", other) + sum_text(both, denominator_);
  }
  for (const std::uint32_t first : sides.vertices()) {
    Phase around = 0;
    std::uint32_t side = first;
    do {
      around = sum(around, of(std::array{side}));
      side = sides.next_around(side);
    } while (side != first);
    if (around != 0)
      return "those of the sides crossed around " + name("vertex ", first) + sum_text(around, denominator_);
  }
  return std::nullopt;
}

}  // namespace epsnet::certify
