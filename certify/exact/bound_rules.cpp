#include <array>
#include <memory>
#include <string>
#include <utility>

#include "certify/exact/claim_rules.h"
#include "certify/exact/interval.h"

namespace epsnet::exact {
namespace {

using Claim = BoundDocument::Claim;

/// Values of sinh² that one bound file may ask for: a quarter of a minute. And darts of all triangulations together:
/// half a gigabyte.
constexpr std::size_t kMaxValues = 10'000'000;
/// Values that take as long as the functions of a triangle, for each of its darts.
constexpr std::size_t kFunctions = 10;
constexpr std::size_t kMaxDarts = 25'000'000;
/// Steps that make the base: some 100 MB.
constexpr std::size_t kMaxSteps = 100'000;

/// A triangulation with one vertex: of each dart what is opposite, and the number of its element.
struct Map {
  std::vector<Index> opposite;
  std::vector<std::size_t> element;
};

/// The triangulation that is cut into cells: of each dart the vertex where it starts, and of each vertex its point.
struct Base : Map {
  std::vector<Index> start;
  std::vector<Vector> point;
};

/// sinh²(d(p, gp)/2) = σ + ⟨n, U(p)⟩² for a point p.
struct Displacement {
  Interval sigma;
  Vector n;

  [[nodiscard]] Interval at(const Vector& u) const { return sigma + square(n[0] * u[0] + n[1] * u[1] + n[2] * u[2]); }
};

template <class R>
Displacement displacement_of(const Isometry<R>& g) {
  const Interval d = enclosure(R(norm(g.a) - norm(g.b)));
  const Interval root = sqrt(d);
  const auto scaled = [&](const R& x) { return enclosure(x) / root; };
  return {enclosure(R(norm(g.b) - g.a.im * g.a.im)) / d, {scaled(-g.b.im), scaled(g.b.re), scaled(-g.a.im)}};
}

template <class R>
Vector unit_vector(const Point<R>& z) {
  const Interval m = enclosure(gap(z));
  const auto quotient = [&](const R& n) { return enclosure(n) / m; };
  return {quotient(2 * z.n.re * z.m), quotient(2 * z.n.im * z.m), quotient(z.m * z.m + norm(z.n))};
}

/// The image of a unit vector under an isometry: with w = x + iy, of (a²w + b²w̄ + 2abt, (|a|² + |b|²)t + 2 Re(ab̄w)).
template <class R>
Vector moved(const Isometry<R>& g, const Vector& p) {
  const Interval d = enclosure(R(norm(g.a) - norm(g.b)));
  const auto quotient = [&](const R& x) { return enclosure(x) / d; };
  const Complex<R> a2 = g.a * g.a;
  const Complex<R> b2 = g.b * g.b;
  const Complex<R> ab = g.a * g.b;
  const Complex<R> c = g.a * conjugate(g.b);
  return {quotient(a2.re + b2.re) * p[0] + quotient(b2.im - a2.im) * p[1] + 2 * quotient(ab.re) * p[2],
          quotient(a2.im + b2.im) * p[0] + quotient(a2.re - b2.re) * p[1] + 2 * quotient(ab.im) * p[2],
          2 * quotient(c.re) * p[0] - 2 * quotient(c.im) * p[1] + quotient(norm(g.a) + norm(g.b)) * p[2]};
}

Interval cosh_distance(const Vector& p, const Vector& q) { return p[2] * q[2] - p[0] * q[0] - p[1] * q[1]; }

/// Three points and the cosh of the distances from each to the next.
struct Cell {
  std::array<Vector, 3> corner;
  std::array<Interval, 3> cosh;
};

/// The midpoint of a side, the cosh of half of it, and that of the way from the midpoint to the corner opposite.
struct Middle {
  Vector point;
  Interval half;
  Interval median;
};

Vector midpoint(const Vector& p, const Vector& q, const Interval& cosh_of_half) {
  Vector point;
  for (std::size_t i = 0; i < 3; ++i) point[i] = (p[i] + q[i]) / (2 * cosh_of_half);
  return point;
}

Middle middle_of(const Cell& cell, Index side) {
  const Index end = (side + 1) % 3;
  const Interval half = sqrt((cell.cosh[side] + 1) / 2);
  return {midpoint(cell.corner[side], cell.corner[end], half), half,
          (cell.cosh[end] + cell.cosh[(side + 2) % 3]) / (2 * half)};
}

template <class R>
class BoundRules {
 public:
  BoundRules(const BoundDocument& document, NetRules<R>& net) : document_(document), net_(net) {}

  /// The rules `lower` and `upper`: at the vertex of the net.
  void check_vertex() {
    const bool is_upper = document_.claim == Claim::radius;
    const SquaredSinh s = squared_sinh(document_.value[is_upper ? 1 : 0]);
    const bool disk = document_.claim == Claim::embedded_disk;
    Answer less = disk ? Answer::no : Answer::yes;
    for (Index dart = 0; dart < net_.darts(); dart += disk ? 1 : 3) {
      less = disk ? either(less, net_.half_edge_is_less(dart, s)) : both(less, net_.circumradius_is_less(dart / 3, s));
    }
    if (less == Answer::unknown) throw TooLarge{"the value at the vertex is too close to the bound"};
    if ((less == Answer::yes) != is_upper)
      throw Refutation{"the value at the vertex is on the other side of the bound"};
  }

  void check_triangulations() {
    const std::size_t darts = (document_.triangulations.size() + 1) * net_.darts();
    if (darts > kMaxDarts)
      throw TooLarge{"the triangulations have " + number(darts) + " darts, and this checker takes " +
                     number(kMaxDarts)};
    Map first{std::vector<Index>(net_.darts()), std::vector<std::size_t>(net_.darts())};
    for (Index dart = 0; dart < net_.darts(); ++dart) {
      first.opposite[dart] = net_.opposite(dart);
      first.element[dart] = elements_.size();
      elements_.push_back(net_.element(dart));
    }
    maps_.push_back(std::move(first));
    for (const BoundDocument::Triangulation& row : document_.triangulations) {
      Map map = maps_[row.parent];
      for (const Index dart : row.flips) flip(map, dart);
      maps_.push_back(std::move(map));
    }
    make_base();
  }

  void check_cells() {
    for (std::size_t k = 0; k < in_triangulations_; ++k) displacements_.push_back(displacement_of(elements_[k]));
    const Interval end(document_.value[document_.claim == Claim::radius ? 0 : 1]);
    sinh_ = sinh(end);
    cosh_ = cosh(end);
    most_ = square(sinh_);
    for (Index t = 0; t < document_.cells.size(); ++t) {
      std::vector<Cell> open{triangle(3 * t)};
      for (const Index entry : document_.cells[t]) {
        const Cell cell = std::move(open.back());
        open.pop_back();
        if (entry < 3) {
          const Index end_of_side = (entry + 1) % 3;
          const Index far = (entry + 2) % 3;
          const Middle middle = middle_of(cell, entry);
          Cell first = cell;
          first.corner[end_of_side] = middle.point;
          first.cosh[entry] = middle.half;
          first.cosh[end_of_side] = middle.median;
          Cell second = cell;
          second.corner[entry] = middle.point;
          second.cosh[entry] = middle.half;
          second.cosh[far] = middle.median;
          open.push_back(std::move(second));
          open.push_back(std::move(first));
          continue;
        }
        const Answer holds = is_bounded(cell, entry - 3);
        if (holds == Answer::no) throw Refutation{"a cell of triangle " + number(t) + " is not bounded"};
        if (holds == Answer::unknown) throw TooLarge{"a cell of triangle " + number(t) + " is bounded too closely"};
      }
    }
  }

 private:
  void make_base() {
    if (document_.base.size() > kMaxSteps)
      throw TooLarge{"the base has " + number(document_.base.size()) + " steps, and this checker takes " +
                     number(kMaxSteps)};
    in_triangulations_ = elements_.size();
    static_cast<Map&>(base_) = maps_[0];
    base_.start.resize(net_.darts());
    base_.point.push_back(unit_vector(net_.corner(0)));
    for (const Index step : document_.base) {
      if (step % 2 == 0) {
        flip_base(step / 2);
      } else {
        split_base(step / 2);
      }
    }
  }

  void flip_base(Index d) {
    const Index e = base_.opposite[d];
    const Index a = base_.start[d];
    const Index b = base_.start[e];
    const Index c = base_.start[previous(d)];
    const Index x = base_.start[previous(e)];
    flip(base_, d);
    base_.start[d] = x;
    base_.start[next(d)] = c;
    base_.start[previous(d)] = a;
    base_.start[e] = c;
    base_.start[next(e)] = x;
    base_.start[previous(e)] = b;
  }

  /// Dart d from a to b, of the triangles abc and bax: they become amc and bmx, and mbc and max, the last ones. The
  /// point of m is in the middle of the edge that starts at the point of a.
  void split_base(Index d) {
    const Index e = base_.opposite[d];
    if (d / 3 == e / 3) throw Refutation{"dart " + number(d) + " has one triangle on both sides"};
    const Index a = base_.start[d];
    const Index b = base_.start[e];
    const Index c = base_.start[previous(d)];
    const Index x = base_.start[previous(e)];
    const auto mbc = static_cast<Index>(base_.start.size());
    const Index max = mbc + 3;
    const std::size_t from_b = base_.element[next(d)];
    const std::size_t from_c = base_.element[previous(d)];
    const std::size_t to_b = base_.element[d];
    const std::size_t to_x = base_.element[next(e)];
    const std::size_t one = elements_.size();
    const std::size_t to_c = one + 1;
    const std::size_t from_x = one + 2;
    elements_.push_back(Isometry<R>());
    elements_.push_back(inverse(Isometry<R>(elements_[from_c])));
    elements_.push_back(inverse(Isometry<R>(elements_[to_x])));
    const Vector& from = base_.point[a];
    const Vector to = moved(elements_[to_b], base_.point[b]);
    base_.point.push_back(midpoint(from, to, sqrt((cosh_distance(from, to) + 1) / 2)));
    const auto m = static_cast<Index>(base_.point.size() - 1);
    base_.opposite.resize(max + 3);
    base_.start.resize(max + 3);
    base_.element.resize(max + 3);
    const auto set = [&](Index dart, Index origin, std::size_t along) {
      base_.start[dart] = origin;
      base_.element[dart] = along;
    };
    set(d, a, one);
    set(next(d), m, to_c);
    set(next(e), m, to_x);
    set(mbc, m, to_b);
    set(mbc + 1, b, from_b);
    set(mbc + 2, c, from_c);
    set(max, m, one);
    set(max + 1, a, to_x);
    set(max + 2, x, from_x);
    const auto glue = [&](Index dart, Index other) {
      base_.opposite[dart] = other;
      base_.opposite[other] = dart;
    };
    // If bc and ax are one edge, next(e) is opposite to mbc + 1 after the first of these.
    glue(mbc + 1, base_.opposite[next(d)]);
    glue(max + 1, base_.opposite[next(e)]);
    glue(d, max);
    glue(next(d), mbc + 2);
    glue(e, mbc);
    glue(next(e), max + 2);
  }

  /// Dart d from a to b, of the triangles abc and bax: it becomes the dart from x to c.
  void flip(Map& map, Index d) {
    const Index e = map.opposite[d];
    if (d / 3 == e / 3) throw Refutation{"dart " + number(d) + " has one triangle on both sides"};
    // c → a, a → x, x → b, b → c.
    const std::array<Index, 4> from{previous(d), next(e), previous(e), next(d)};
    std::array<Index, 4> across{};
    std::array<std::size_t, 4> element{};
    for (std::size_t i = 0; i < 4; ++i) {
      across[i] = map.opposite[from[i]];
      element[i] = map.element[from[i]];
    }
    const std::array<Index, 4> to{next(d), previous(d), next(e), previous(e)};
    const auto moved = [&](Index dart) {
      for (std::size_t i = 0; i < 4; ++i) {
        if (from[i] == dart) return to[i];
      }
      return dart;
    };
    for (std::size_t i = 0; i < 4; ++i) {
      const Index other = moved(across[i]);
      map.opposite[to[i]] = other;
      map.opposite[other] = to[i];
      map.element[to[i]] = element[i];
    }
    const Isometry<R> product = net_.product(elements_[element[0]], elements_[element[1]]);
    map.element[e] = elements_.size();
    map.element[d] = elements_.size() + 1;
    elements_.push_back(product);
    elements_.push_back(inverse(product));
  }

  /// The triangle of the base with this dart as the first.
  Cell triangle(Index dart) {
    const auto corner = [&](Index d) -> const Vector& { return base_.point[base_.start[d]]; };
    Cell cell;
    cell.corner = {corner(dart), moved(elements_[base_.element[dart]], corner(dart + 1)),
                   moved(inverse(elements_[base_.element[dart + 2]]), corner(dart + 2))};
    for (std::size_t i = 0; i < 3; ++i) cell.cosh[i] = cosh_distance(cell.corner[i], cell.corner[(i + 1) % 3]);
    return cell;
  }

  /// The values of sinh²(d(p, gp)/2) of all darts at a point.
  std::vector<Interval> values(const Map& map, const Vector& p) {
    spend(net_.darts());
    std::vector<Interval> h(net_.darts());
    for (Index dart = 0; dart < net_.darts(); ++dart) {
      const Index other = map.opposite[dart];
      h[dart] = other < dart ? h[other] : displacements_[map.element[dart]].at(p);
    }
    return h;
  }

  void spend(std::size_t values) {
    if (values > values_left_) throw TooLarge{"there are too many cells and triangles for this checker"};
    values_left_ -= values;
  }

  Answer is_bounded(const Cell& cell, Index by) {
    const auto darts = static_cast<Index>(net_.darts());
    switch (document_.claim) {
      case Claim::diameter:
        return is_covered(cell, maps_[by]);
      case Claim::radius:
        return is_far(cell, maps_[by / 3], by % 3);
      case Claim::embedded_disk:
        break;
    }
    return has_short_loop(cell, displacements_[maps_[by / darts].element[by % darts]]);
  }

  /// At the corners of the cell every triangle lies in a disk of radius HI.
  Answer is_covered(const Cell& cell, const Map& map) {
    Answer result = Answer::yes;
    for (const Vector& p : cell.corner) {
      const std::vector<Interval> h = values(map, p);
      for (std::size_t t = 0; t < h.size(); t += 3)
        result = both(result, fits_in_disk(h[t], h[t + 1], h[t + 2], most_));
    }
    return result;
  }

  /// d(p, gp) <= 2 HI at the corners, and g is not the identity.
  Answer has_short_loop(const Cell& cell, const Displacement& g) {
    spend(3);
    Answer is_short = Answer::yes;
    Answer moves = Answer::unknown;
    for (const Vector& p : cell.corner) {
      const Interval h = g.at(p);
      is_short = both(is_short, !is_less(most_, h));
      moves = either(moves, is_less(0, h));
    }
    return both(is_short, moves);
  }

  /// Lemma 25 at the middle of a side, with a triangle whose circumradius is at least LO + D.
  Answer is_far(const Cell& cell, const Map& map, Index side) {
    const Middle middle = middle_of(cell, side);
    spend(kFunctions * net_.darts());
    const std::vector<Interval> h = values(map, middle.point);
    // D: to either end of the side, and to the corner opposite. sinh(LO + D) from cosh D.
    const Interval reach = max(middle.half, middle.median);
    return is_delaunay_and_wide(map.opposite, h, square(sinh_ * reach + cosh_ * sqrt(square(reach) - 1)));
  }

  const BoundDocument& document_;
  NetRules<R>& net_;
  std::vector<Isometry<R>> elements_;
  std::size_t in_triangulations_ = 0;  ///< Elements before those of the base.
  std::vector<Map> maps_;
  Base base_;
  std::vector<Displacement> displacements_;
  // Of the bound for cells.
  Interval sinh_;
  Interval cosh_;
  Interval most_;  ///< sinh².
  std::size_t values_left_ = kMaxValues;
};

/// The cells of a triangle in preorder: as many as the cuts need, and each bounded by something.
void expect_subdivision(const std::vector<Index>& cells, std::size_t bounds) {
  std::size_t open = 1;
  for (const Index entry : cells) {
    if (open == 0) throw Malformed("more cells than the subdivision has");
    if (entry >= 3) expect_less(entry - 3, bounds, "bound of a cell");
    open = entry < 3 ? open + 1 : open - 1;
  }
  if (open != 0) throw Malformed("a subdivision ends early");
}

/// Whether the areas of triangles, of which tan(A/2) is given, sum up to less than that of the surface and any one of
/// them.
template <class Arctan>
Answer all_counterclockwise(const std::vector<Interval>& tangent, const Arctan& arctan_of) {
  Interval all = -Interval(static_cast<long>(tangent.size()) - 2) * Interval::pi();
  std::vector<Interval> areas;
  for (const Interval& x : tangent) {
    areas.push_back(2 * arctan_of(x));
    all = all + areas.back();
  }
  Answer result = Answer::yes;
  for (const Interval& area : areas) result = both(result, is_less(all, area));
  return result;
}

}  // namespace

Answer fits_in_disk(const Interval& a, const Interval& b, const Interval& c, const Interval& most) {
  const Answer is_short = both(both(!is_less(most, a), !is_less(most, b)), !is_less(most, c));
  const Answer acute = both(both(is_less(a, b + c), is_less(b, c + a)), is_less(c, a + b));
  const Interval k = 4 * a * b - square(a + b - c);
  // A disk around the circumcentre, or around the middle of the longest side.
  const Answer around_centre = both(is_less(0, k), !is_less(k * most, 4 * a * b * c));
  return both(is_short, either(around_centre, !acute));
}

Answer is_delaunay_and_wide(const std::vector<Index>& opposite, const std::vector<Interval>& h, const Interval& least) {
  std::vector<Interval> kappa(h.size()), tangent;
  Answer result = Answer::yes;
  Answer wide = Answer::no;
  for (std::size_t t = 0; t < h.size(); t += 3) {
    const std::array<Interval, 3> x{h[t], h[t + 1], h[t + 2]};
    const Interval k = 4 * x[0] * x[1] - square(x[0] + x[1] - x[2]);
    const Interval product = 4 * x[0] * x[1] * x[2];
    result = both(result, is_less(0, k));
    const Interval scale = 1 / sqrt(k);
    for (std::size_t i = 0; i < 3; ++i) kappa[t + i] = (x[(i + 1) % 3] + x[(i + 2) % 3] - x[i]) * scale;
    tangent.push_back(sqrt(k + product) / (2 + x[0] + x[1] + x[2]));
    wide = either(wide, !is_less(product, k * least));
  }
  for (std::size_t dart = 0; dart < h.size(); ++dart) {
    result = both(result, is_less(0, kappa[dart] + kappa[opposite[dart]]));
  }
  // Few digits decide but where a triangle is very small.
  Answer counterclockwise = all_counterclockwise(tangent, [](const Interval& x) { return rough_arctan(x); });
  if (counterclockwise == Answer::unknown) {
    counterclockwise = all_counterclockwise(tangent, [](const Interval& x) { return arctan(x); });
  }
  return both(both(result, counterclockwise), wide);
}

template <class R>
std::vector<Rule> bound_rules(const BoundDocument& document, NetRules<R>& net) {
  if (document.value[0] == 0) throw Malformed("the value is not positive");
  for (std::size_t k = 0; k < document.triangulations.size(); ++k) {
    expect_less(document.triangulations[k].parent, k + 1, "an earlier triangulation");
    for (const Index dart : document.triangulations[k].flips) expect_less(dart, net.darts(), "dart");
  }
  std::size_t darts = net.darts();
  for (const Index step : document.base) {
    expect_less(step / 2, darts, "dart");
    if (step % 2 == 1) darts += 6;
  }
  if (3 * document.cells.size() != darts) throw Malformed("cells: not one row for each triangle");
  const std::size_t of_each = document.claim == Claim::diameter ? 1 : document.claim == Claim::radius ? 3 : net.darts();
  for (const std::vector<Index>& row : document.cells) {
    expect_subdivision(row, (document.triangulations.size() + 1) * of_each);
  }
  const auto rules = std::make_shared<BoundRules<R>>(document, net);
  return {{document.claim == Claim::radius ? "upper" : "lower", [rules] { rules->check_vertex(); }},
          {"triangulations", [rules] { rules->check_triangulations(); }},
          {"cells", [rules] { rules->check_cells(); }}};
}

template std::vector<Rule> bound_rules(const BoundDocument& document, NetRules<mpz_class>& net);
template std::vector<Rule> bound_rules(const BoundDocument& document, NetRules<Algebraic>& net);
template std::vector<Rule> bound_rules(const BoundDocument& document, NetRules<FieldNumber>& net);

}  // namespace epsnet::exact
