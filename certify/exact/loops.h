#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "certify/exact/interval.h"
#include "certify/exact/net_rules.h"

/// Section 11.1 of docs/proof.md: elements of the group as loops at vertices of the net, and their classes. In
/// intervals.
namespace epsnet::exact {

using Motion = Isometry<Interval>;

/// Gives a question up: TooLarge.
[[noreturn]] void give_up(const std::string& why);
/// Leaves a list that is too long to others: LeftOut.
[[noreturn]] void leave_loops_out();

/// Whether the answer is yes; unknown is too close.
bool decided(Answer answer, const char* what);

/// The point n/d of the disk of a chart; |d|² − |n|² is 1 − |z|² of the vertex of which it is a lift.
template <class Number>
struct PlaceOf {
  Complex<Number> n;
  Complex<Number> d;
};
using Place = PlaceOf<Interval>;
using RoughPlace = PlaceOf<RoughInterval>;

template <class Number>
[[nodiscard]] PlaceOf<Number> image(const Isometry<Number>& g, const PlaceOf<Number>& z) {
  return {g.a * z.n + g.b * z.d, conjugate(g.b) * z.n + conjugate(g.a) * z.d};
}

/// The same numbers, to a few digits.
[[nodiscard]] inline Complex<RoughInterval> rounded(const Complex<Interval>& x) {
  return {RoughInterval(x.re), RoughInterval(x.im)};
}
[[nodiscard]] inline Isometry<RoughInterval> rounded(const Motion& f) { return {rounded(f.a), rounded(f.b)}; }
[[nodiscard]] inline RoughPlace rounded(const Place& z) { return {rounded(z.n), rounded(z.d)}; }

/// sinh²(l/2) of a motion of determinant 1, if that is positive.
[[nodiscard]] inline Interval squared_half_length(const Motion& g) { return norm(g.b) - square(g.a.im); }

/// The normal of the axis of a motion of determinant 1, with the square sinh²(l/2).
[[nodiscard]] inline Vector axis_normal(const Motion& g) { return {-g.b.im, g.b.re, g.a.im}; }
[[nodiscard]] inline Interval lorentz_product(const Vector& u, const Vector& v) {
  return u[0] * v[0] + u[1] * v[1] - u[2] * v[2];
}

/// The same, exactly: a quotient.
template <class R>
struct HalfLength {
  explicit HalfLength(const Isometry<R>& g)
      : numerator(norm(g.b) - g.a.im * g.a.im), denominator(norm(g.a) - norm(g.b)) {}
  R numerator;
  R denominator;
};

/// Whether the length is at most 2 arsinh 1.
template <class R>
bool is_small(const HalfLength<R>& x) {
  return sgn(R(x.numerator - x.denominator)) <= 0;
}

/// The sign of the difference of two lengths.
template <class R>
int compare(const HalfLength<R>& x, const HalfLength<R>& y) {
  return sgn(R(x.numerator * y.denominator - y.numerator * x.denominator));
}

/// An isometry with intervals as entries, of determinant 1.
template <class R>
[[nodiscard]] Motion enclose(const Isometry<R>& g) {
  const Interval root = sqrt(enclosure(R(norm(g.a) - norm(g.b))));
  const auto entry = [&](const R& x) { return enclosure(x) / root; };
  return {{entry(g.a.re), entry(g.a.im)}, {entry(g.b.re), entry(g.b.im)}};
}

/// An element of the group at tile 0, in the chart of a vertex, given paths from tile 0 to all tiles.
template <class R>
[[nodiscard]] Motion element_at_vertex(NetRules<R>& net, const std::vector<Index>& word, Index v,
                                       const std::vector<std::vector<Index>>& paths) {
  const Index chart = net.net().vertices[v].chart;
  const Isometry<R> to_tile = net.value(paths[net.net().charts[chart].first]);
  const Isometry<R> to_chart = net.product(inverse(net.frame(chart)), to_tile);
  return enclose(net.product(to_chart, net.product(net.value(word), inverse(to_chart))));
}

/// Points of vertices, found again by where they are.
class PointTable {
 public:
  template <class Number>
  void insert(Index vertex, const PlaceOf<Number>& place, std::size_t number);
  /// The number of which is_same(number) is yes; all those of points that may be equal are asked. Throws TooLarge if
  /// one is unknown, and LeftOut if these are too many, for all points together.
  [[nodiscard]] std::optional<std::size_t> find(Index vertex, const Place& place,
                                                const std::function<Answer(std::size_t)>& is_same) const;
  /// As find, but an answer that is unknown is no error: then the answer is unknown, also if the place is not known
  /// well enough.
  struct Found {
    Answer answer;
    std::size_t number;  ///< If the answer is yes.
  };
  [[nodiscard]] Found find_roughly(Index vertex, const RoughPlace& place,
                                   const std::function<Answer(std::size_t)>& is_same) const;

 private:
  /// Of a square of width 2⁻³⁰, and a vertex.
  struct Square {
    Index vertex;
    long x;
    long y;
    bool operator==(const Square&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Square& square) const {
      constexpr std::size_t kFactor = 0x9E3779B97F4A7C15;
      std::size_t result = square.vertex;
      for (const long part : {square.x, square.y}) result = (result ^ static_cast<std::size_t>(part)) * kFactor;
      return result ^ result >> 32U;
    }
  };
  /// Calls use(number) for all points that may be at a place, as long as it says so.
  void for_each_near(Index vertex, const std::array<double, 2>& in_squares,
                     const std::function<bool(std::size_t)>& use) const;
  void count_different() const;

  std::unordered_map<Square, std::vector<std::size_t>, Hash> numbers_;
  mutable std::size_t different_ = 0;  ///< That were compared.
};

/// The elements of the group at all vertices of a net that can be closed geodesics of length at most L. The rules of
/// the net are verified, and it must live as long.
template <class R>
class Loops {
 public:
  /// An element of the group at a vertex, not the identity.
  struct Loop {
    Index vertex;
    Motion g;
    Place place;       ///< Where g takes the vertex.
    std::size_t path;  ///< Along which it is a product.
    std::size_t inverse = 0;
    Isometry<RoughInterval> rough_g;
    RoughPlace rough_place;
  };
  /// From a vertex along a dart: the lift of its end, and what takes coordinates of the end's chart to those of the
  /// start's.
  struct Step {
    Index end;
    Motion motion;
    Place place;
    Isometry<RoughInterval> rough_motion;
    RoughPlace rough_place;
  };

  /// Finds them: those of length at most L, sinh²(L/2) = bound, that move their vertex by at most D,
  /// sinh²(D/2) = bound cosh²ε. Throws TooLarge, and LeftOut if that takes more lifted vertices than `most_lifts`.
  Loops(NetRules<R>& net, const Interval& bound, long most_lifts);

  struct Lift {
    Index vertex;
    Motion frame;  ///< To the chart of the first vertex.
    std::size_t parent;
    Index dart;  ///< From the parent.
    Isometry<RoughInterval> rough_frame;
    RoughPlace rough_place;
  };

  [[nodiscard]] const std::deque<Loop>& all() const { return loops_; }
  /// Elements of one closed geodesic, run through equally often, have one representative.
  [[nodiscard]] std::size_t representative(std::size_t i) const;
  /// Those that have this representative.
  [[nodiscard]] const std::vector<std::size_t>& members(std::size_t representative) const {
    return members_[representative];
  }
  /// The loop at the end of a dart from the loop's vertex that is the same element, if that is one of them.
  [[nodiscard]] std::optional<std::size_t> along(std::size_t i, Index dart) const;
  /// The loop at this vertex of an element that takes it so far. Throws TooLarge if it is none of them.
  [[nodiscard]] std::size_t at(Index v, const Place& place) const;
  /// Whether an element that takes vertex v so far may be one of them.
  [[nodiscard]] bool is_reached(Index v, const Place& place) const { return is_farther(v, place, v) != Answer::yes; }
  /// Whether the axis is not certainly farther than ε from the vertex.
  [[nodiscard]] bool is_near_axis(std::size_t i) const;

  [[nodiscard]] const std::vector<Index>& leaving(Index v) const { return leaving_[v]; }
  [[nodiscard]] const Step& step(Index dart) const { return steps_[dart]; }
  [[nodiscard]] Place self(Index v) const { return {origin_[v], {1, 0}}; }
  [[nodiscard]] Place place(const Lift& lift) const { return image(lift.frame, self(lift.vertex)); }
  /// sinh² of half the distance of a lift of vertex w from vertex v itself, in the chart of v.
  [[nodiscard]] Interval half_distance(Index v, const Place& place, Index w) const {
    return moved(v, place) / (gap_[v] * gap_[w]);
  }
  [[nodiscard]] Isometry<R> exact(const Loop& loop) const;
  /// The vertex itself, and all lifts of vertices no farther from it than D, sinh²(D/2) = reach, and perhaps some that
  /// are hardly farther. Throws TooLarge, and LeftOut.
  [[nodiscard]] std::deque<Lift> lifts(Index first, const Interval& reach);
  /// To the disk with the vertex in its centre.
  [[nodiscard]] Motion to_centre(Index v) const {
    const Interval scale = 1 / sqrt(gap_[v]);
    return {{scale, 0}, -(scale * origin_[v])};
  }

 private:
  void prepare();
  void find_at(Index first);
  /// Whether a lift of vertex w is farther from vertex v than the number says or one of those known, by a few digits.
  [[nodiscard]] Answer is_left_out(Index v, const RoughPlace& place, Index w, const RoughInterval& farthest,
                                   const std::deque<Lift>& lifts, const PointTable& known) const;
  void join_all();
  /// |n − zd|² for the point z of v.
  [[nodiscard]] Interval moved(Index v, const Place& place) const { return norm(place.n - origin_[v] * place.d); }
  /// As `along`, by a few digits; unknown if they do not tell.
  [[nodiscard]] PointTable::Found along_roughly(std::size_t i, Index dart) const;
  /// The same for two lifts of a vertex.
  [[nodiscard]] Answer are_same(const RoughPlace& x, const RoughPlace& y, Index v) const {
    return is_less(norm(x.n * y.d - y.n * x.d), rough_apart_[v]);
  }
  /// Whether this lift of vertex w is farther than D from vertex v itself.
  [[nodiscard]] Answer is_farther(Index v, const Place& place, Index w) const {
    return is_less(reach_ * gap_[w] * gap_[v], moved(v, place));
  }
  /// Two lifts of a vertex are the same if they are nearer than the shortest edge.
  [[nodiscard]] Answer are_same(const Place& x, const Place& y, Index v) const {
    return is_less(norm(x.n * y.d - y.n * x.d), apart_[v]);
  }

  NetRules<R>& net_;
  Interval bound_;
  Interval thick_;  ///< cosh²ε
  Interval reach_;  ///< sinh²(D/2)
  RoughInterval rough_reach_;
  long lifts_left_;
  long darts_left_;
  std::vector<std::vector<Index>> leaving_;  ///< Darts, by vertex.
  std::vector<Step> steps_;                  ///< By dart.
  std::vector<Complex<Interval>> origin_;    ///< By vertex: where it is in its chart, and 1 − |z|².
  std::vector<Interval> gap_;
  std::vector<Interval> apart_;  ///< By vertex: sinh² of half the shortest edge, times the square of the gap.
  std::vector<Complex<RoughInterval>> rough_origin_;
  std::vector<RoughInterval> rough_gap_;
  std::vector<RoughInterval> rough_apart_;
  /// Paths from vertices, each one dart longer than another one; the empty ones are their own. Those of the powers of a
  /// short loop would have millions of darts, each for itself.
  struct Path {
    std::size_t before;
    Index dart;
  };
  std::vector<Path> paths_;
  std::deque<Loop> loops_;  ///< Of a kilobyte and more each: a vector would take twice as much memory when it grows.
  PointTable table_;
  mutable std::vector<std::size_t> parent_;  ///< Of a class.
  std::vector<std::vector<std::size_t>> members_;
};

extern template class Loops<mpz_class>;
extern template class Loops<Algebraic>;
extern template class Loops<FieldNumber>;

}  // namespace epsnet::exact
