#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <tuple>
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
struct Place {
  Complex<Interval> n;
  Complex<Interval> d;
};

[[nodiscard]] Place image(const Motion& g, const Place& z);

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

/// Points of vertices, found again by where they are.
class PointTable {
 public:
  void insert(Index vertex, const Place& place, std::size_t number);
  /// The number of which is_same(number) is yes; all those of points that may be equal are asked. Throws LeftOut if
  /// these are too many, for all points together.
  [[nodiscard]] std::optional<std::size_t> find(Index vertex, const Place& place,
                                                const std::function<Answer(std::size_t)>& is_same) const;

 private:
  std::map<std::tuple<Index, long, long>, std::vector<std::size_t>> numbers_;  ///< In squares of width 2⁻³⁰.
  mutable std::size_t different_ = 0;                                          ///< That were compared.
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
    Place place;               ///< Where g takes the vertex.
    std::vector<Index> darts;  ///< A path along which it is a product.
    std::size_t inverse = 0;
  };
  /// From a vertex along a dart: the lift of its end, and what takes coordinates of the end's chart to those of the
  /// start's.
  struct Step {
    Index end;
    Motion motion;
    Place place;
  };

  /// Finds them: those of length at most L, sinh²(L/2) = bound, that move their vertex by at most D,
  /// sinh²(D/2) = bound cosh²ε. Throws TooLarge, and LeftOut if that takes more lifted vertices than `most_lifts`.
  Loops(NetRules<R>& net, const Interval& bound, long most_lifts);

  struct Lift {
    Index vertex;
    Motion frame;  ///< To the chart of the first vertex.
    Place place;
    std::size_t parent;
    Index dart;  ///< From the parent.
  };

  [[nodiscard]] const std::vector<Loop>& all() const { return loops_; }
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
  /// sinh² of half the distance of a lift of vertex w from vertex v itself, in the chart of v.
  [[nodiscard]] Interval half_distance(Index v, const Place& place, Index w) const {
    return moved(v, place) / (gap_[v] * gap_[w]);
  }
  [[nodiscard]] Isometry<R> exact(const Loop& loop) const;
  /// The vertex itself, and all lifts of vertices no farther from it than D, sinh²(D/2) = reach, and perhaps some that
  /// are hardly farther. Throws TooLarge, and LeftOut.
  [[nodiscard]] std::vector<Lift> lifts(Index first, const Interval& reach);
  /// To the disk with the vertex in its centre.
  [[nodiscard]] Motion to_centre(Index v) const {
    const Interval scale = 1 / sqrt(gap_[v]);
    return {{scale, 0}, -(scale * origin_[v])};
  }

 private:
  void prepare();
  void find_at(Index first);
  void join_all();
  /// |n − zd|² for the point z of v.
  [[nodiscard]] Interval moved(Index v, const Place& place) const { return norm(place.n - origin_[v] * place.d); }
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
  long lifts_left_;
  std::vector<std::vector<Index>> leaving_;  ///< Darts, by vertex.
  std::vector<Step> steps_;                  ///< By dart.
  std::vector<Complex<Interval>> origin_;    ///< By vertex: where it is in its chart, and 1 − |z|².
  std::vector<Interval> gap_;
  std::vector<Interval> apart_;  ///< By vertex: sinh² of half the shortest edge, times the square of the gap.
  std::vector<Loop> loops_;
  PointTable table_;
  mutable std::vector<std::size_t> parent_;  ///< Of a class.
  std::vector<std::vector<std::size_t>> members_;
};

extern template class Loops<mpz_class>;
extern template class Loops<Algebraic>;
extern template class Loops<FieldNumber>;

}  // namespace epsnet::exact
