#include "netgen/pants/curve_system.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <string>
#include <tuple>
#include <utility>

#include "kernel/plane.h"
#include "netgen/base/gmp.h"
#include "netgen/surfaces/exact_isometries.h"
#include "triangulation/surface/surface.h"

namespace epsnet {
namespace {

using Number = CurveSystem::Number;
using Vector = CurveSystem::Vector;

/// Samples of a curve are not farther apart.
constexpr double kSpacing = 0.5;
constexpr std::size_t kMostLifts = 200'000;
constexpr std::size_t kMostLetters = 100'000;

/// Numbers that differ by less are taken for equal.
Number tolerance() { return boost::multiprecision::ldexp(Number(1), -100); }

/// f with Re a ≥ 0.
Isometry<Number> with_positive_trace(const Isometry<Number>& f) { return f.a.x < 0 ? Isometry<Number>{-f.a, -f.b} : f; }

Vector minus(const Vector& v) { return Number(-1) * v; }

/// The place of a vector's projection along a line with a point and a direction there; the vector is timelike.
Number place_along(const Vector& point, const Vector& forward, const Vector& v) {
  const Number a = -lorentz_product(v, point);
  const Number b = lorentz_product(v, forward);
  return log(Number((a + b) / (a - b))) / 2;
}

}  // namespace

CurveSystem::CurveSystem(const Surface& surface)
    : surface_(surface), tiles_(surface), samples_in_(surface.tiles().size()) {
  for (const Tile& tile : surface_.tiles()) {
    std::vector<Vector>& corners = corners_.emplace_back();
    for (const Complex<Rational>& z : tile) corners.push_back(on_hyperboloid(convert<Number>(z)));
  }
  for (const SideId s : surface_.side_ids()) back_.push_back(inverse(tiles_.crossing(s)));
}

/// Lifts of tiles on and to the left of an axis, up to its translation, in the order of their distances.
class CurveSystem::Exploration {
 public:
  Exploration(const CurveSystem& system, const Axis& axis) : system_(system), axis_(axis) {
    add(Isometry<Number>{}, axis.path.tile, 0, SideId(0));
  }

  /// Calls visit(meeting) for all lifts of samples in lifts of tiles for which sinh of the distance is at most
  /// `bound()`, which is asked again and again. Throws LimitError.
  template <class Bound, class Visit>
  void run(const Bound& bound, const Visit& visit) {
    while (!queue_.empty() && queue_.top().first <= bound()) {
      const std::uint32_t number = queue_.top().second;
      queue_.pop();
      const TileId tile = lifts_[number].tile;
      const Isometry<Number> frame = lifts_[number].frame;
      for (const std::uint32_t s : system_.samples_in_[tile]) {
        const Sample& sample = system_.samples_[s];
        Meeting meeting{s, number, image(frame, sample.point), image(frame, sample.normal), 0, 0};
        meeting.product = lorentz_product(meeting.normal, axis_.normal);
        meeting.height = lorentz_product(meeting.point, axis_.normal);
        visit(meeting);
      }
      go_on_from(number);
    }
  }

  /// The path to the curve of a sample that was met.
  [[nodiscard]] Word way(const Meeting& meeting) const {
    const Surface& surface = system_.surface_;
    return concatenated(surface, path_to(meeting.lift), reversed(surface, system_.samples_[meeting.sample].way));
  }

  /// The axis, as seen from each lift that was found so far.
  [[nodiscard]] std::vector<Chord> chords() const {
    const Surface& surface = system_.surface_;
    std::vector<Chord> result;
    for (std::uint32_t i = 0; i < lifts_.size(); ++i) {
      const Word path = path_to(i);
      result.push_back({lifts_[i].tile, image(inverse(lifts_[i].frame), axis_.normal),
                        concatenated(surface, concatenated(surface, reversed(surface, path), axis_.path.word), path)});
    }
    return result;
  }

 private:
  struct Lift {
    Isometry<Number> frame;  ///< From the coordinates of the tile.
    TileId tile;
    std::uint32_t before;  ///< The lift from which it was reached,
    SideId side;           ///< the side crossed,
    std::int64_t shift;    ///< and how many periods of the axis it was moved then.
  };

  [[nodiscard]] Word path_to(std::uint32_t number) const {
    const Surface& surface = system_.surface_;
    std::vector<std::uint32_t> numbers;
    for (; number != 0; number = lifts_[number].before) numbers.push_back(number);
    Word result;
    for (auto lift = numbers.rbegin(); lift != numbers.rend(); ++lift) {
      result.push_back(lifts_[*lift].side);
      const std::int64_t shift = lifts_[*lift].shift;
      if (static_cast<std::size_t>(std::abs(shift)) * axis_.path.word.size() > kMostLetters) {
        throw LimitError("a path around a short closed geodesic would have more than " + std::to_string(kMostLetters) +
                         " letters");
      }
      const Word once = shift < 0 ? reversed(surface, axis_.path.word) : axis_.path.word;
      Word moved;
      for (std::int64_t i = 0; i < std::abs(shift); ++i) moved.insert(moved.end(), once.begin(), once.end());
      result = concatenated(surface, concatenated(surface, {}, moved), result);
    }
    return result;
  }

  void add(const Isometry<Number>& frame, TileId tile, std::uint32_t before, SideId side) {
    const Vector centre = image(frame, system_.tiles_.centre(tile));
    const Number periods = place_along(axis_.point, axis_.forward, centre) / axis_.length;
    // Not at 0, where the centre of the first tile may be.
    const Number shift = -floor(Number(periods + Number(0.37)));
    if (abs(shift) > 1e9) throw LimitError("a tile goes around a short closed geodesic too often");
    const double place = static_cast<double>(Number(periods + shift));
    const double height = std::asinh(static_cast<double>(lorentz_product(centre, axis_.normal)));
    if (!is_new(tile, height, place)) return;
    if (lifts_.size() >= kMostLifts) {
      throw LimitError("more than " + std::to_string(kMostLifts) + " tiles are near a closed geodesic");
    }
    const auto count = static_cast<std::int64_t>(shift);
    lifts_.push_back({shifted(frame, count), tile, before, side, count});
    queue_.emplace(height_of(lifts_.back()), static_cast<std::uint32_t>(lifts_.size() - 1));
  }

  /// Moved along the axis by so many periods.
  [[nodiscard]] Isometry<Number> shifted(const Isometry<Number>& frame, std::int64_t count) const {
    Isometry<Number> power = count < 0 ? inverse(axis_.element) : axis_.element;
    Isometry<Number> result = frame;
    for (auto rest = static_cast<std::uint64_t>(std::abs(count)); rest != 0; rest /= 2) {
      if (rest % 2 != 0) result = power * result;
      power = power * power;
    }
    return result;
  }

  /// Whether no other lift of the tile has its centre there, up to rounding.
  bool is_new(TileId tile, double height, double place) {
    constexpr double kCell = 1e-8;
    const auto column = static_cast<std::int64_t>(std::floor(height / kCell));
    const auto row = static_cast<std::int64_t>(std::floor(place / kCell));
    constexpr std::int64_t kRows = 100'000'000;  // The period.
    for (std::int64_t i = column - 1; i <= column + 1; ++i) {
      for (std::int64_t j = row - 1; j <= row + 1; ++j) {
        if (seen_.contains({tile, i, (j % kRows + kRows) % kRows})) return false;
      }
    }
    seen_[{tile, column, (row % kRows + kRows) % kRows}] = true;
    return true;
  }

  void go_on_from(std::uint32_t number) {
    const TileId tile = lifts_[number].tile;
    const Isometry<Number> frame = lifts_[number].frame;
    const std::vector<double> heights = side_heights(lifts_[number]);
    for (std::uint32_t k = 0; k < heights.size(); ++k) {
      if (heights[k] < 0) continue;
      const SideId s = system_.surface_.side_number(tile, k);
      const TileId beyond = system_.surface_.tile_of_side(system_.surface_.partner(s));
      add(frame * system_.back_[s], beyond, number, s);
    }
  }

  /// Of the sides of a lift: sinh of the distance from the axis, as far as they are not on the right; −1 if they are.
  [[nodiscard]] std::vector<double> side_heights(const Lift& lift) const {
    const std::vector<Vector>& corners = system_.corners_[lift.tile];
    std::vector<Vector> ends;
    ends.reserve(corners.size());
    for (const Vector& corner : corners) ends.push_back(image(lift.frame, corner));
    std::vector<double> result;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::size_t next = (k + 1) % corners.size();
      result.push_back(height_of(ends[k], ends[next], corners[k], corners[next]));
    }
    return result;
  }

  /// sinh of the distance of a lift from the axis, which is not on its left. A tile beside the one through which the
  /// axis leaves it may be met first across a side that is farther away.
  [[nodiscard]] double height_of(const Lift& lift) const {
    double least = HUGE_VAL;
    for (const double height : side_heights(lift)) {
      if (height >= 0) least = std::min(least, height);
    }
    return least;
  }

  /// sinh of the distance of a segment from the axis, as far as it is not on the right; −1 if it is.
  [[nodiscard]] double height_of(const Vector& start, const Vector& end, const Vector& tile_start,
                                 const Vector& tile_end) const {
    const Number p = lorentz_product(start, axis_.normal);
    const Number q = lorentz_product(end, axis_.normal);
    const Number nothing = tolerance();
    if (p < -nothing && q < -nothing) return -1;
    if (p <= nothing || q <= nothing) return 0;
    // Along the segment it is p cosh t + v sinh t.
    const Number cosh_length = -lorentz_product(tile_start, tile_end);
    const Number sinh_length = sqrt(Number(cosh_length * cosh_length - 1));
    const Number v = (q - p * cosh_length) / sinh_length;
    if (v < 0 && p * sinh_length + v * cosh_length > 0) {
      const Number square = p * p - v * v;
      return square > 0 ? static_cast<double>(sqrt(square)) : 0;
    }
    return static_cast<double>(p < q ? p : q);
  }

  const CurveSystem& system_;
  const Axis& axis_;
  std::vector<Lift> lifts_;
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
  std::map<std::tuple<TileId, std::int64_t, std::int64_t>, bool> seen_;
};

ClosedPath CurveSystem::directed(Side side) const {
  const ClosedPath& path = curve(side.curve);
  return side.reversed ? ClosedPath{path.tile, reversed(surface_, path.word)} : path;
}

bool CurveSystem::is_trivial(const ClosedPath& path) const {
  return isometry_discriminant(element(path.word)) < tolerance() * tolerance();
}

CurveSystem::Axis CurveSystem::axis_of(const ClosedPath& path) const {
  Axis axis{path, with_positive_trace(element(path.word)), 0, {}, {}, {}};
  const Number square = isometry_discriminant(axis.element);
  if (!(square > 0)) throw LimitError("a path is not a translation, to 512 bits");
  axis.length = 2 * asinh(Number(sqrt(square)));
  axis.normal = Number(1 / sqrt(square)) * axis_normal(axis.element);
  const Vector& centre = tiles_.centre(path.tile);
  const Number height = lorentz_product(centre, axis.normal);
  axis.point = Number(1 / sqrt(Number(1 + height * height))) * (centre + Number(-height) * axis.normal);
  axis.forward = lorentz_cross(axis.normal, axis.point);
  if (lorentz_product(axis.forward, image(axis.element, axis.point)) < 0) axis.forward = minus(axis.forward);
  return axis;
}

CurveSystem::Moved CurveSystem::onto_geodesic(const ClosedPath& path) const {
  Word way = tiles_.walk(path.tile, axis_of(path).point);
  if (way.empty()) return {path, way};
  const TileId tile = surface_.tile_of_side(surface_.partner(way.back()));
  Word word = concatenated(surface_, concatenated(surface_, reversed(surface_, way), path.word), way);
  return {{tile, std::move(word)}, std::move(way)};
}

std::uint32_t CurveSystem::add(const ClosedPath& path) {
  const std::uint32_t number = size();
  const Moved moved = onto_geodesic(path);
  const Axis axis = axis_of(moved.path);
  curves_.push_back({moved.path, axis.length});
  const double length = static_cast<double>(axis.length);
  const double count = std::max(1.0, std::ceil(length / kSpacing));
  const Number step = axis.length / count;
  const Number c = cosh(step);
  const Number s = sinh(step);
  Vector point = axis.point;
  Vector forward = axis.forward;
  Vector normal = axis.normal;
  TileId tile = moved.path.tile;
  Word way;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    if (i > 0) {
      const Vector next = c * point + s * forward;
      forward = s * point + c * forward;
      point = next;
    }
    const Word walk = tiles_.walk(tile, point);
    if (!walk.empty()) {
      const Isometry<Number> value = tiles_.value(walk);
      for (Vector* v : {&point, &forward, &normal}) *v = image(value, *v);
      tile = surface_.tile_of_side(surface_.partner(walk.back()));
      way = concatenated(surface_, std::move(way), walk);
    }
    samples_in_[tile].push_back(static_cast<std::uint32_t>(samples_.size()));
    samples_.push_back({number, tile, way, point, normal});
  }
  return number;
}

bool CurveSystem::is_same_axis(const Meeting& meeting) const {
  return abs(meeting.height) < tolerance() && abs(Number(abs(meeting.product) - 1)) < tolerance();
}

std::optional<std::uint32_t> CurveSystem::crossed(const ClosedPath& path) const {
  const Axis axis = axis_of(onto_geodesic(path).path);
  Exploration exploration(*this, axis);
  std::optional<std::uint32_t> result;
  const double far = std::sinh(kSpacing) * (1 + 1e-9);
  exploration.run([&] { return result ? -1.0 : far; },
                  [&](const Meeting& meeting) {
                    if (is_same_axis(meeting) || abs(meeting.product) >= 1) return;
                    result = samples_[meeting.sample].curve;
                  });
  return result;
}

std::uint32_t CurveSystem::exponent(std::uint32_t number) const {
  const Axis axis = axis_of(curve(number));
  Exploration exploration(*this, axis);
  std::map<std::uint32_t, std::uint32_t> count;
  exploration.run([] { return 0.0; },
                  [&](const Meeting& meeting) {
                    if (samples_[meeting.sample].curve == number && is_same_axis(meeting)) ++count[meeting.sample];
                  });
  // A sample on the common side of two tiles is in one of them, so each is met once for each time around.
  return count.begin()->second;
}

std::optional<CurveSystem::Lift> CurveSystem::lift_on(const ClosedPath& path) const {
  const Moved moved = onto_geodesic(path);
  const Axis axis = axis_of(moved.path);
  Exploration exploration(*this, axis);
  std::optional<Meeting> found;
  exploration.run([&] { return found ? -1.0 : 0.0; },
                  [&](const Meeting& meeting) {
                    if (!found && is_same_axis(meeting)) found = meeting;
                  });
  if (!found) return std::nullopt;
  return Lift{{samples_[found->sample].curve, found->product < 0},
              concatenated(surface_, moved.way, exploration.way(*found))};
}

std::vector<CurveSystem::Chord> CurveSystem::chords(std::uint32_t number) const {
  const Axis axis = axis_of(curve(number));
  Exploration exploration(*this, axis);
  exploration.run([] { return 0.0; }, [](const Meeting&) {});
  return exploration.chords();
}

std::array<ClosedPath, 3> CurveSystem::pants_beside(Side side) const {
  const Axis axis = axis_of(directed(side));
  Exploration exploration(*this, axis);
  std::optional<Meeting> nearest;
  double bound = std::numeric_limits<double>::infinity();
  exploration.run([&] { return bound; },
                  [&](const Meeting& meeting) {
                    const Number size = abs(meeting.product);
                    if (meeting.height <= tolerance() || size <= 1) return;
                    if (nearest && size >= abs(nearest->product) * (1 - tolerance())) return;
                    nearest = meeting;
                    // The sample is not far from the end of the arc.
                    bound = static_cast<double>(sqrt(Number(size * size - 1))) * std::cosh(kSpacing) * (1 + 1e-9);
                  });
  if (!nearest) throw LimitError("no arc was found from a closed geodesic to another one");
  const Word way = exploration.way(*nearest);
  // With the axis on its left.
  const Side other{samples_[nearest->sample].curve, nearest->product > 0};
  const Word& first = axis.path.word;
  const auto path = [&](Word word) { return ClosedPath{axis.path.tile, std::move(word)}; };
  const auto product = [&](const Word& x, const Word& y) { return concatenated(surface_, x, y); };
  if (other != side) {
    const Word second = product(product(way, directed(other).word), reversed(surface_, way));
    return {axis.path, path(second), path(reversed(surface_, product(first, second)))};
  }
  // The arc returns to the curve. What goes along it and back along the curve, on either side, is another cuff.
  const Vector start = nearest->normal + Number(-nearest->product) * axis.normal;
  const Vector end = axis.normal + Number(-nearest->product) * nearest->normal;
  const Vector end_here = image(inverse(element(way)), end);
  const Number turns = floor(Number(
      (place_along(axis.point, axis.forward, end_here) - place_along(axis.point, axis.forward, start)) / axis.length));
  if (abs(turns) * first.size() > kMostLetters) throw LimitError("an arc goes around a closed geodesic too often");
  Word third = way;
  const Word once = turns < 0 ? reversed(surface_, first) : first;
  for (Number i = 0; i < abs(turns); i += 1) third = product(third, once);
  return {axis.path, path(reversed(surface_, product(third, first))), path(third)};
}

namespace {

using certify::Ball;
using certify::BallIsometry;
using BallVector = LorentzVector<Ball>;

constexpr slong kFirstBallBits = 256;
constexpr slong kMostBallBits = 1 << 15;
/// Letters of a path of which the length is perhaps known exactly.
constexpr std::size_t kMostExactLetters = 1000;

/// The normal of the axis of an element with Re a > 0, not of length 1.
BallVector normal(const BallIsometry& f) {
  return {-certify::imaginary(f.b), certify::real(f.b), certify::imaginary(f.a)};
}

/// Values of paths in balls: the isometry from the lift of the tile at the end to that at the start.
class Values {
 public:
  Values(const Surface& surface, slong precision) : surface_(surface), precision_(precision) {}

  [[nodiscard]] BallIsometry operator()(const Word& word) const {
    return certify::inverse(ball_isometry(surface_, word, precision_));
  }

  [[nodiscard]] BallIsometry times(const BallIsometry& f, const BallIsometry& g) const {
    return certify::compose(f, g, precision_);
  }

 private:
  const Surface& surface_;
  slong precision_;
};

/// The one of ±f with Re a > 0, if that is certain.
std::optional<BallIsometry> positive(const BallIsometry& f) {
  const int sign = certify::certain_sign(certify::real(f.a));
  if (sign == 0) return std::nullopt;
  return sign > 0 ? f : BallIsometry{-f.a, -f.b};
}

/// The elements of the three cuffs.
using Cuffs = std::array<BallIsometry, 3>;

/// One path after the other.
Word joined(Word first, const Word& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

/// e^{l/2} for an element of length l, if it is rational.
std::optional<Rational> rational_root(const Surface& surface, const Word& path) {
  if (!surface.is_rational() || path.empty() || path.size() > kMostExactLetters) return std::nullopt;
  const certify::ExactIsometry f = integer_isometry(surface, path);
  // cosh(l/2) = |Re a|/√det, and sinh²(l/2) = (|b|² − (Im a)²)/det.
  const mpz_class square = f.b.re * f.b.re + f.b.im * f.b.im - f.a.im * f.a.im;
  const mpz_class determinant = f.a.re * f.a.re - square;
  if (mpz_perfect_square_p(square.get_mpz_t()) == 0 || mpz_perfect_square_p(determinant.get_mpz_t()) == 0) {
    return std::nullopt;
  }
  mpq_class root(mpz_class(abs(f.a.re) + sqrt(square)), sqrt(determinant));
  root.canonicalize();
  return from_gmp(root);
}

class Coordinates {
 public:
  Coordinates(const Surface& surface, const PantsGraph& graph, const std::vector<PantsPaths>& pants,
              const std::vector<Word>& across, bool reduced)
      : surface_(surface), graph_(graph), across_(across), reduced_(reduced) {
    for (const auto& [cuffs] : pants) {
      paths_.insert(paths_.end(), {cuffs[0], cuffs[1], reversed(surface, joined(cuffs[0], cuffs[1]))});
    }
    for (const PantsGraph::Edge& edge : graph.edges()) {
      result_.push_back({{}, {}, rational_root(surface, path(edge[0]))});
    }
  }

  [[nodiscard]] std::vector<CuffCoordinates> enclose() {
    std::vector<bool> done(across_.size());
    for (slong bits = kFirstBallBits;; bits *= 2) {
      const certify::Precision precision(bits);
      const Values value(surface_, bits);
      bool all = true;
      for (std::size_t e = 0; e < across_.size(); ++e) {
        if (!done[e]) done[e] = enclose(value, e);
        all = all && done[e];
      }
      if (all) return std::move(result_);
      if (bits >= kMostBallBits) throw LimitError("the twists are not known with " + std::to_string(bits) + " bits");
    }
  }

 private:
  [[nodiscard]] const Word& path(const PantsGraph::End& end) const {
    return paths_[3 * std::size_t{end.pants} + end.cuff];
  }

  [[nodiscard]] std::optional<Cuffs> cuffs(const Values& value, std::uint32_t pants) const {
    Cuffs result;
    for (std::uint32_t k = 0; k < 3; ++k) {
      auto f = positive(value(path({pants, k})));
      if (!f) return std::nullopt;
      result[k] = *std::move(f);
    }
    return result;
  }

  /// Whether length and twist of an edge are known to almost the last digit.
  bool enclose(const Values& value, std::size_t e) {
    const auto& [first, second] = graph_.edges()[e];
    const auto own = cuffs(value, first.pants);
    const auto others = cuffs(value, second.pants);
    if (!own || !others) return false;
    const BallIsometry there = value(across_[e]);
    const BallIsometry& next = (*others)[(second.cuff + 1) % 3];
    const BallVector n = normal((*own)[first.cuff]);
    const BallVector left = normal((*own)[(first.cuff + 1) % 3]);
    const BallVector right = normal(value.times(value.times(there, next), certify::inverse(there)));
    const Ball sinh_half = certify::sqrt(lorentz_product(n, n));
    const Ball length = certify::twice(certify::asinh(sinh_half));
    // The normals of the two perpendiculars, and sinh of their distance along the axis.
    const BallVector u = lorentz_cross(n, left);
    const BallVector v = lorentz_cross(n, right);
    const Ball sizes = certify::sqrt(lorentz_product(u, u) * lorentz_product(v, v));
    Ball twist = certify::asinh(lorentz_product(lorentz_cross(n, v), u) / (sinh_half * sizes));
    const Ball turns = twist / length;
    if (!certify::is_finite(turns)) return false;
    const double whole = std::nearbyint(arf_get_d(arb_midref(turns.get()), ARF_RND_NEAR));
    if (!(std::abs(whole) < 0x1p53)) return false;
    if (reduced_) twist = twist - Ball::exactly(whole) * length;
    const Ball least = certify::scaled(length, -70);
    for (const Ball& x : {length, twist}) {
      if (certify::certainly_less(radius(x), least) != certify::Tri::yes) return false;
    }
    result_[e].length = certify::outer_interval(length);
    result_[e].twist = certify::outer_interval(twist);
    return true;
  }

  static Ball radius(const Ball& x) {
    Ball result;
    arb_get_rad_arb(result.get(), x.get());
    return result;
  }

  const Surface& surface_;
  const PantsGraph& graph_;
  const std::vector<Word>& across_;
  bool reduced_;
  std::vector<Word> paths_;  ///< By cuff of all pairs of pants.
  std::vector<CuffCoordinates> result_;
};

}  // namespace

std::vector<CuffCoordinates> cuff_coordinates(const Surface& surface, const PantsGraph& graph,
                                              const std::vector<PantsPaths>& pants, const std::vector<Word>& across,
                                              bool reduced) {
  return Coordinates(surface, graph, pants, across, reduced).enclose();
}

}  // namespace epsnet
