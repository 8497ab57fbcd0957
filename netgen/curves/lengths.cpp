#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "certify/numbers/interval_arithmetic.h"
#include "netgen/curves/curves.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/isometries/lifted_tiles.h"
#include "netgen/isometries/matches.h"
#include "netgen/nets/certified_net.h"
#include "netgen/pants/pants.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/group.h"

namespace epsnet {
namespace {

using certify::Ball;

constexpr slong kBitsOfDerivatives = 192;

/// A number with its derivatives. One without any is a constant.
template <class T>
struct Jet {
  T value{};
  std::vector<T> derivatives = {};
};

Ball number(double n, const Ball* /*kind*/) { return Ball::exactly(n); }
Ball reciprocal(const Ball& x) { return 1 / x; }
template <class T>
Jet<T> number(double n, const Jet<T>* /*kind*/) {
  return {number(n, static_cast<const T*>(nullptr)), {}};
}

/// f(x, y), of which the derivative is dx · by_x + dy · by_y.
template <class T>
Jet<T> combined(T value, const Jet<T>& x, const T& by_x, const Jet<T>& y, const T& by_y) {
  Jet<T> result{std::move(value), {}};
  for (std::size_t i = 0; i < std::max(x.derivatives.size(), y.derivatives.size()); ++i) {
    if (y.derivatives.empty()) {
      result.derivatives.push_back(x.derivatives[i] * by_x);
    } else if (x.derivatives.empty()) {
      result.derivatives.push_back(y.derivatives[i] * by_y);
    } else {
      result.derivatives.push_back(x.derivatives[i] * by_x + y.derivatives[i] * by_y);
    }
  }
  return result;
}
/// f(x), of which the derivative is `slope`.
template <class T>
Jet<T> composed(T value, const Jet<T>& x, const T& slope) {
  Jet<T> result{std::move(value), {}};
  for (const T& dx : x.derivatives) result.derivatives.push_back(dx * slope);
  return result;
}

template <class T>
Jet<T> operator+(const Jet<T>& x, const Jet<T>& y) {
  const T one = number(1, static_cast<const T*>(nullptr));
  return combined(T(x.value + y.value), x, one, y, one);
}
template <class T>
Jet<T> operator-(const Jet<T>& x) {
  return composed(T(-x.value), x, number(-1, static_cast<const T*>(nullptr)));
}
template <class T>
Jet<T> operator-(const Jet<T>& x, const Jet<T>& y) {
  return x + (-y);
}
template <class T>
Jet<T> operator*(const Jet<T>& x, const Jet<T>& y) {
  return combined(T(x.value * y.value), x, y.value, y, x.value);
}
template <class T>
Jet<T> reciprocal(const Jet<T>& x) {
  const T value = reciprocal(x.value);
  return composed(value, x, T(-(value * value)));
}
template <class T>
Jet<T> operator/(const Jet<T>& x, const Jet<T>& y) {
  return x * reciprocal(y);
}
template <class T>
Jet<T> sqrt(const Jet<T>& x) {
  const T value = sqrt(x.value);
  return composed(value, x, reciprocal(T(value + value)));
}
template <class T>
Jet<T> exp(const Jet<T>& x) {
  const T value = exp(x.value);
  return composed(value, x, value);
}
template <class T>
Jet<T> acosh(const Jet<T>& x) {
  const T one = number(1, static_cast<const T*>(nullptr));
  return composed(T(acosh(x.value)), x, reciprocal(T(sqrt(T(x.value * x.value - one)))));
}

/// About the value.
double rough(const Ball& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR); }
template <class T>
double rough(const Jet<T>& x) {
  return rough(x.value);
}

/// A matrix of positive determinant, which acts on the upper half-plane.
template <class T>
struct HalfPlaneMatrix {
  T a, b, c, d;

  HalfPlaneMatrix operator*(const HalfPlaneMatrix& n) const {
    return {a * n.a + b * n.c, a * n.b + b * n.d, c * n.a + d * n.c, c * n.b + d * n.d};
  }
  [[nodiscard]] T determinant() const { return a * d - b * c; }
};

/// The inverse, but for a factor.
template <class T>
HalfPlaneMatrix<T> adjugate(const HalfPlaneMatrix<T>& m) {
  return {m.d, -m.b, -m.c, m.a};
}

/// The crossings of the sides of heptagons, as docs/fenchel-nielsen.md makes them, but with base points that do not
/// matter: only the products of their heights do.
template <class T>
class Heptagons {
 public:
  using M = HalfPlaneMatrix<T>;

  Heptagons(const PantsGraph& graph, const std::vector<T>& coordinates) {
    const std::size_t edges = graph.edges().size();
    std::vector<T> r;
    for (std::size_t e = 0; e < edges; ++e) r.push_back(exp(coordinates[e] / of(2)));
    std::vector<Pants> pants;
    for (std::uint32_t p = 0; p < graph.pants_count(); ++p) {
      pants.emplace_back(std::array<T, 3>{r[graph.edge_at(p, 0)], r[graph.edge_at(p, 1)], r[graph.edge_at(p, 2)]});
      const auto& [first, second] = pants.back().generators;
      crossings_.resize(crossings_.size() + kSides, M{of(1), of(0), of(0), of(1)});
      crossing(p, 0) = second;
      crossing(p, 2) = adjugate(second);
      crossing(p, 5) = second * first;
      crossing(p, 3) = adjugate(second * first);
    }
    for (std::size_t e = 0; e < edges; ++e) {
      const auto& [one, other] = graph.edges()[e];
      const Cuff& from = pants[one.pants].cuffs[one.cuff];
      const Cuff& to = pants[other.pants].cuffs[other.cuff];
      // The product of the heights of the ends that meet: f f′ e^τ times r² or r⁻², from base points to ends of sides.
      T product = from.mark * to.mark * exp(coordinates[edges + e]);
      const T square = r[e] * r[e];
      if (one.cuff == 0 && other.cuff == 0) product = product / square;
      if (one.cuff != 0 && other.cuff != 0) product = product * square;
      const M across = to.frame * M{of(0), -product, of(1), of(0)} * adjugate(from.frame);
      crossing(one.pants, kCuffSides[one.cuff]) = across;
      crossing(other.pants, kCuffSides[other.cuff]) = adjugate(across);
    }
  }

  /// The length of the closed geodesic of a path.
  ///
  /// Between frames that have the axis for an axis each step is nearly a diagonal matrix, so that errors of steps are
  /// added; in the product of the crossings themselves each would be multiplied by the norms of all others.
  [[nodiscard]] T length(const Word& word) const {
    const std::vector<M> frames = axis_frames(word);
    M product{of(1), of(0), of(0), of(1)};
    T determinant = of(1);
    for (std::size_t i = 0; i < word.size(); ++i) {
      const M step = adjugate(frames[(i + 1) % frames.size()]) * crossings_[word[i].number()] * frames[i];
      determinant = determinant * step.determinant();
      product = step * product;
    }
    const T trace = product.a + product.d;
    return acosh(trace * trace / (of(2) * determinant) - of(1));
  }

 private:
  static constexpr std::uint32_t kSides = 7;
  static constexpr std::array<std::uint32_t, 3> kCuffSides{6, 1, 4};

  static T of(double n) { return number(n, static_cast<const T*>(nullptr)); }

  /// The cuff as seen from the pants: in its frame it runs from 0 to ∞, and the mark is at this height.
  struct Cuff {
    M frame;
    T mark;
  };
  struct Pants {
    explicit Pants(const std::array<T, 3>& r) {
      const auto& [r1, r2, r3] = r;
      const T t2 = r2 + of(1) / r2;
      const T t3 = r3 + of(1) / r3;
      const T a = -(t3 + t2 / r1) / (r1 - of(1) / r1);
      const T d = t2 - a;
      const M first{r1, of(0), of(0), of(1) / r1};
      const M second{a, a * d - of(1), of(1), d};
      const auto axis = [](const T& from, const T& to) { return M{to, from, of(1), of(1)}; };
      const std::array<M, 3> axes{M{of(1), of(0), of(0), of(1)}, axis(of(1) / r2 - d, r2 - d),
                                  axis(-(r1 * r3) - d, -(r1 / r3) - d)};
      for (std::size_t k = 0; k < 3; ++k) {
        const M next = adjugate(axes[k]) * axes[(k + 1) % 3];
        const T mark = sqrt(next.b / next.d * (next.a / next.c));
        cuffs.push_back({k == 2 ? second * axes[k] : axes[k], mark});
      }
      generators = {first, second};
    }

    std::array<M, 2> generators;  ///< D₁ and D₂.
    std::vector<Cuff> cuffs;
  };

  /// By step of a closed path, in the heptagon where it begins: the ends of the axis, roughly, as columns of length 1.
  /// Any constant matrices that have inverses would do.
  [[nodiscard]] std::vector<M> axis_frames(const Word& word) const {
    constexpr int kRounds = 20;
    constexpr double kLeastAngle = 1e-9;
    using Direction = std::array<double, 2>;
    const auto image = [](const HalfPlaneMatrix<double>& m, const Direction& u) {
      const Direction v{m.a * u[0] + m.b * u[1], m.c * u[0] + m.d * u[1]};
      const double size = std::sqrt(v[0] * v[0] + v[1] * v[1]);  // The same on every machine.
      return Direction{v[0] / size, v[1] / size};
    };
    std::vector<HalfPlaneMatrix<double>> steps;
    for (const SideId s : word) {
      const M& m = crossings_[s.number()];
      steps.push_back({rough(m.a), rough(m.b), rough(m.c), rough(m.d)});
    }
    // Whatever goes around and around comes to an end of the axis, and backwards to the other one.
    std::vector<Direction> ahead(word.size());
    std::vector<Direction> behind(word.size());
    Direction u{0.8, 0.6};
    Direction v{0.6, -0.8};
    for (int round = 0; round < kRounds; ++round) {
      for (std::size_t i = 0; i < steps.size(); ++i) {
        ahead[i] = u;
        u = image(steps[i], u);
      }
      for (std::size_t i = steps.size(); i-- > 0;) behind[i] = v = image(adjugate(steps[i]), v);
    }
    std::vector<M> frames;
    for (std::size_t i = 0; i < word.size(); ++i) {
      const auto& [x, y] = ahead[i];
      const auto& [z, w] = behind[i];
      const bool is_frame = std::abs(x * w - y * z) > kLeastAngle;
      frames.push_back(is_frame ? M{of(x), of(z), of(y), of(w)} : M{of(1), of(0), of(0), of(1)});
    }
    return frames;
  }

  M& crossing(std::uint32_t pants, std::uint32_t side) { return crossings_[std::size_t{kSides} * pants + side]; }

  std::vector<M> crossings_;  ///< By side: from the coordinates of its heptagon to those of the neighbour.
};

template <class T>
Jet<T> variable(T value, std::size_t i, std::size_t count) {
  Jet<T> result{std::move(value), std::vector<T>(count, number(0, static_cast<const T*>(nullptr)))};
  result.derivatives[i] = number(1, static_cast<const T*>(nullptr));
  return result;
}

Ball ball_of_interval(const certify::Interval& x) {
  const Ball middle = certify::half(Ball::exactly(x.lower) + Ball::exactly(x.upper));
  Ball result = middle;
  const Ball radius = certify::half(Ball::exactly(x.upper) - Ball::exactly(x.lower));
  arb_add_error(result.get(), radius.get());
  return result;
}

}  // namespace

EnclosedCoordinates enclosed_coordinates(const PantsDecomposition& pants) {
  if (!pants.own) {
    throw SurfaceError(
        "its tiles are not the heptagons of Fenchel-Nielsen coordinates; surface fenchel-nielsen --from makes them of "
        "a pants file");
  }
  EnclosedCoordinates result{pants.graph, {}};
  for (const PantsDecomposition::Cuff& cuff : pants.cuffs) result.values.push_back(cuff.length);
  for (const PantsDecomposition::Cuff& cuff : pants.cuffs) {
    // The sides of the heptagons meet as for a twist of at least −½ and less than ½ of the length.
    const bool is_half = 2 * cuff.twist.upper >= cuff.length.lower;
    result.values.push_back(is_half ? certify::Interval{-cuff.twist.upper, -cuff.twist.lower} : cuff.twist);
  }
  return result;
}

namespace {

using BallJet = Jet<Ball>;

/// The length with its first and second derivatives, at all points of a box.
Jet<BallJet> length_over(const PantsGraph& graph, const std::vector<Ball>& box, const Word& word) {
  std::vector<Jet<BallJet>> variables;
  for (std::size_t i = 0; i < box.size(); ++i)
    variables.push_back(variable(variable(box[i], i, box.size()), i, box.size()));
  return Heptagons<Jet<BallJet>>(graph, variables).length(word);
}

Ball derivative(const BallJet& x, std::size_t i) { return x.derivatives.empty() ? Ball() : x.derivatives[i]; }

certify::Interval checked(const Ball& x) {
  const certify::Interval result = certify::outer_interval(x);
  if (!std::isfinite(result.lower) || !std::isfinite(result.upper))
    throw LimitError("coordinates are not known well enough for a derivative of a length");
  return result;
}

}  // namespace

LengthDerivatives length_derivatives(const EnclosedCoordinates& coordinates, const Word& word, bool second) {
  const certify::Precision scope(kBitsOfDerivatives);
  std::vector<Ball> box;
  std::vector<BallJet> middle;
  std::vector<Ball> errors;
  const std::size_t count = coordinates.values.size();
  for (const certify::Interval& x : coordinates.values) {
    box.push_back(ball_of_interval(x));
    const Ball centre = certify::half(Ball::exactly(x.lower) + Ball::exactly(x.upper));
    errors.push_back(box.back() - centre);
    middle.push_back(variable(centre, middle.size(), count));
  }
  const BallJet at_middle = Heptagons<BallJet>(coordinates.graph, middle).length(word);
  const bool is_point =
      std::all_of(errors.begin(), errors.end(), [](const Ball& x) { return certify::is_exactly_zero(x); });
  LengthDerivatives result;
  if (is_point && !second) {
    result.length = checked(at_middle.value);
    for (std::size_t i = 0; i < count; ++i) result.gradient.push_back(checked(derivative(at_middle, i)));
    return result;
  }
  // By the mean value theorem: products of many matrices over a box would be far too wide.
  const Jet<BallJet> over = length_over(coordinates.graph, box, word);
  const auto second_over = [&](std::size_t i, std::size_t j) {
    return over.derivatives.empty() ? Ball() : derivative(over.derivatives[i], j);
  };
  Ball length = at_middle.value;
  for (std::size_t i = 0; i < count; ++i) {
    length += derivative(over.value, i) * errors[i];
    Ball slope = derivative(at_middle, i);
    auto& row = result.second.emplace_back();
    for (std::size_t j = 0; j < count; ++j) {
      slope += second_over(i, j) * errors[j];
      row.push_back(checked(second_over(i, j)));
    }
    result.gradient.push_back(checked(slope));
  }
  result.length = checked(length);
  if (!second) result.second.clear();
  return result;
}

namespace {

using Number = LiftedTiles::Number;

/// The paths of a surface in heptagons that have about its coordinates.
class InHeptagons {
 public:
  InHeptagons(const Surface& surface, const PantsDecomposition& pants, unsigned threads)
      : from_(surface),
        from_tile_0_(polygon_paths(surface)),
        to_(fenchel_nielsen_surface(pants.coordinates())),
        own_(pants_decomposition(to_.surface(), {.threads = threads})),
        // Elements of one pair of pants tell how the one plane lies on the other.
        motion_(motion_of_pairs(positive(from_.value(loop(pants.pants[0][0]))),
                                positive(from_.value(loop(pants.pants[0][1]))), positive(to_.value(own_.pants[0][0])),
                                positive(to_.value(own_.pants[0][1])))) {}

  /// The coordinates of the surface, with twists that are as the sides of the heptagons meet.
  [[nodiscard]] EnclosedCoordinates coordinates(const PantsDecomposition& pants) const {
    EnclosedCoordinates result = enclosed_coordinates(own_);
    const std::size_t cuffs = pants.cuffs.size();
    for (std::size_t e = 0; e < cuffs; ++e) {
      const certify::Interval& length = pants.cuffs[e].length;
      const certify::Interval& twist = pants.cuffs[e].twist;
      const double turns = std::round((result.values[cuffs + e].lower - twist.lower) / length.lower);
      const certify::Precision scope(kBitsOfDerivatives);
      const Ball moved = ball_of_interval(twist) + Ball::exactly(turns) * ball_of_interval(length);
      result.values[e] = length;
      result.values[cuffs + e] = turns == 0 ? twist : certify::outer_interval(moved);
    }
    return result;
  }

  /// Letter by letter: each is moved by little, so that it is found although the heptagons are rounded.
  [[nodiscard]] Word word(const Word& path) const {
    constexpr double kTolerance = 1e-3;
    Word result;
    for (const SideId letter : path) {
      const std::optional<Word> image = image_word(to_, motion_, from_.value(loop({letter})), kTolerance);
      if (!image) fail();
      result = concatenated(to_.surface(), std::move(result), *image);
    }
    return result;
  }

  /// Throws LimitError unless a length may be that of the closed geodesic of a path.
  void check_length(const certify::Interval& length, const Word& path) const {
    const double expected = 2 * static_cast<double>(acosh(abs(from_.value(path).a.x)));
    const double rounding = 1e-9 * (1 + expected);
    if (!(length.lower - rounding <= expected && expected <= length.upper + rounding)) fail();
  }

 private:
  [[noreturn]] static void fail() {
    throw LimitError("a path is not found again in heptagons with the coordinates of the surface");
  }

  /// The path from tile 0 to the start of a path, along it, and back from its end.
  [[nodiscard]] Word loop(const Word& path) const {
    const Surface& surface = from_.surface();
    const TileId start = surface.tile_of_side(path.front());
    const Word there = concatenated(surface, from_tile_0_[start], path);
    return concatenated(surface, there, reversed(surface, from_tile_0_[from_.end_of(start, path)]));
  }
  /// The same isometry, with Re a > 0.
  static Isometry<Number> positive(const Isometry<Number>& f) { return f.a.x < 0 ? Isometry<Number>{-f.a, -f.b} : f; }

  LiftedTiles from_;
  ById<TileId, Word> from_tile_0_;
  LiftedTiles to_;
  PantsDecomposition own_;
  Motion<Number> motion_;
};

}  // namespace

LengthDerivatives length_derivatives(const Surface& surface, const PantsDecomposition& pants, const Word& word,
                                     bool second, unsigned threads) {
  if (CurveTopology(surface).curve(word).is_null_homotopic())
    throw SurfaceError("null-homotopic, so there is no closed geodesic");
  if (pants.own) return length_derivatives(enclosed_coordinates(pants), word, second);
  InHeptagons heptagons(surface, pants, threads);
  LengthDerivatives result = length_derivatives(heptagons.coordinates(pants), heptagons.word(word), second);
  heptagons.check_length(result.length, word);
  return result;
}

}  // namespace epsnet
