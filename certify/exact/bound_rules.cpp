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

/// A triangulation with one vertex: of each dart what is opposite, and the number of its element.
struct Map {
  std::vector<Index> opposite;
  std::vector<std::size_t> element;
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

Middle middle_of(const Cell& cell, Index side) {
  const Index end = (side + 1) % 3;
  const Interval half = sqrt((cell.cosh[side] + 1) / 2);
  Vector point;
  for (std::size_t i = 0; i < 3; ++i) point[i] = (cell.corner[side][i] + cell.corner[end][i]) / (2 * half);
  return {point, half, (cell.cosh[end] + cell.cosh[(side + 2) % 3]) / (2 * half)};
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
  }

  void check_cells() {
    for (const Isometry<R>& element : elements_) displacements_.push_back(displacement_of(element));
    const Interval end(document_.value[document_.claim == Claim::radius ? 0 : 1]);
    most_ = square(sinh(end));
    for (Index t = 0; t < document_.cells.size(); ++t) {
      std::vector<Cell> open{triangle(t)};
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

  Cell triangle(Index t) {
    std::array<Point<R>, 3> z{net_.corner(3 * t), net_.corner(3 * t + 1), net_.corner(3 * t + 2)};
    Cell cell;
    for (std::size_t i = 0; i < 3; ++i) {
      cell.corner[i] = unit_vector(z[i]);
      const Point<R>& w = z[(i + 1) % 3];
      cell.cosh[i] = 2 * (enclosure(squared_difference(z[i], w)) / enclosure(R(gap(z[i]) * gap(w)))) + 1;
    }
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
      for (std::size_t t = 0; t < h.size(); t += 3) result = both(result, fits(h[t], h[t + 1], h[t + 2]));
    }
    return result;
  }

  [[nodiscard]] Answer fits(const Interval& a, const Interval& b, const Interval& c) const {
    const Answer is_short = both(both(!is_less(most_, a), !is_less(most_, b)), !is_less(most_, c));
    const Answer acute = both(both(is_less(a, b + c), is_less(b, c + a)), is_less(c, a + b));
    const Interval k = 4 * a * b - square(a + b - c);
    // Lemma 20: a disk around the circumcentre, or around the middle of the longest side.
    const Answer around_centre = both(is_less(0, k), !is_less(k * most_, 4 * a * b * c));
    return both(is_short, either(around_centre, !acute));
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
    // D: to either end of the side, and to the corner opposite.
    const Interval reach = arcosh(max(middle.half, middle.median));
    return is_delaunay_and_wide(map.opposite, h, square(sinh(Interval(document_.value[0]) + reach)));
  }

  const BoundDocument& document_;
  NetRules<R>& net_;
  std::vector<Isometry<R>> elements_;
  std::vector<Map> maps_;
  std::vector<Displacement> displacements_;
  Interval most_;  ///< sinh² of the bound for cells.
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

}  // namespace

Answer is_delaunay_and_wide(const std::vector<Index>& opposite, const std::vector<Interval>& h, const Interval& least) {
  std::vector<Interval> kappa(h.size()), areas;
  Interval all = -Interval(static_cast<long>(h.size() / 3) - 2) * Interval::pi();
  Answer result = Answer::yes;
  Answer wide = Answer::no;
  for (std::size_t t = 0; t < h.size(); t += 3) {
    const std::array<Interval, 3> x{h[t], h[t + 1], h[t + 2]};
    const Interval k = 4 * x[0] * x[1] - square(x[0] + x[1] - x[2]);
    const Interval product = 4 * x[0] * x[1] * x[2];
    result = both(result, is_less(0, k));
    for (std::size_t i = 0; i < 3; ++i) kappa[t + i] = (x[(i + 1) % 3] + x[(i + 2) % 3] - x[i]) / sqrt(k);
    areas.push_back(2 * arctan(sqrt(k + product) / (2 + x[0] + x[1] + x[2])));
    all = all + areas.back();
    wide = either(wide, !is_less(product, k * least));
  }
  for (std::size_t dart = 0; dart < h.size(); ++dart) {
    result = both(result, is_less(0, kappa[dart] + kappa[opposite[dart]]));
  }
  for (const Interval& area : areas) result = both(result, is_less(all, area));
  return both(result, wide);
}

template <class R>
std::vector<Rule> bound_rules(const BoundDocument& document, NetRules<R>& net) {
  if (document.value[0] == 0) throw Malformed("the value is not positive");
  for (std::size_t k = 0; k < document.triangulations.size(); ++k) {
    expect_less(document.triangulations[k].parent, k + 1, "an earlier triangulation");
    for (const Index dart : document.triangulations[k].flips) expect_less(dart, net.darts(), "dart");
  }
  if (document.cells.size() != document.net.triangles.size()) throw Malformed("cells: not one row for each triangle");
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

}  // namespace epsnet::exact
