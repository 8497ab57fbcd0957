#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "certify/exact/claim_rules.h"
#include "certify/exact/interval.h"

/// Section 11.1: systoles and spectra, by the loops at all vertices.
namespace epsnet::exact {
namespace {

/// Lifted vertices that one file may ask for: a quarter of a minute.
constexpr long kMaxLifts = 100'000;
constexpr const char* kTooMany = "there are too many loops of such lengths for this checker";

using Motion = Isometry<Interval>;
using Vector = Complex<Interval>;

[[noreturn]] void give_up(const std::string& why) { throw TooLarge{why}; }

/// Whether the answer is yes; unknown is too close.
bool decided(Answer answer, const char* what) {
  if (answer == Answer::unknown) give_up(std::string(what) + " is not decided by the digits used");
  return answer == Answer::yes;
}

/// The point n/d of the disk of a chart; |d|² − |n|² is 1 − |z|² of the vertex of which it is a lift.
struct Place {
  Vector n;
  Vector d;
};

Place image(const Motion& g, const Place& z) {
  return {g.a * z.n + g.b * z.d, conjugate(g.b) * z.n + conjugate(g.a) * z.d};
}

/// sinh²(l/2) of a motion of determinant 1, if that is positive.
Interval squared_half_length(const Motion& g) { return norm(g.b) - square(g.a.im); }

/// The same, exactly: a quotient.
template <class R>
struct HalfLength {
  explicit HalfLength(const Isometry<R>& g)
      : numerator(norm(g.b) - g.a.im * g.a.im), denominator(norm(g.a) - norm(g.b)) {}
  R numerator;
  R denominator;
};

/// The sign of the difference of two lengths.
template <class R>
int compare(const HalfLength<R>& x, const HalfLength<R>& y) {
  return sgn(R(x.numerator * y.denominator - y.numerator * x.denominator));
}

/// Numbers in cells of width 2⁻³⁰, to find points that are equal.
class PointTable {
 public:
  void insert(Index vertex, const Place& place, std::size_t number) { numbers_[key(vertex, place)].push_back(number); }

  /// The number of which is_same(number) is yes; all those of points that may be equal are asked.
  template <class IsSame>
  std::optional<std::size_t> find(Index vertex, const Place& place, const IsSame& is_same) const {
    const auto [v, x, y] = key(vertex, place);
    for (const long i : {-1L, 0L, 1L}) {
      for (const long j : {-1L, 0L, 1L}) {
        const auto found = numbers_.find({v, x + i, y + j});
        if (found == numbers_.end()) continue;
        for (const std::size_t number : found->second) {
          if (decided(is_same(number), "whether two lifts of a vertex are the same")) return number;
        }
      }
    }
    return std::nullopt;
  }

 private:
  using Key = std::tuple<Index, long, long>;

  static long cell(const Interval& x) {
    if (!(x.upper() - x.lower() < std::ldexp(1, -40))) give_up("a point is not known well enough");
    return std::lround(std::ldexp(x.lower(), 30));
  }
  static Key key(Index vertex, const Place& place) {
    const Vector z = place.n * conjugate(place.d);
    const Interval d = norm(place.d);
    return {vertex, cell(z.re / d), cell(z.im / d)};
  }

  std::map<Key, std::vector<std::size_t>> numbers_;
};

template <class R>
class GeodesicRules {
 public:
  GeodesicRules(const GeodesicsDocument& document, NetRules<R>& net) : document_(document), net_(net) {}

  void check_lengths() {
    for (std::size_t i = 0; i < document_.geodesics.size(); ++i) {
      const ClosedGeodesic& row = document_.geodesics[i];
      const Index chart = net_.net().vertices[row.vertex].chart;
      elements_.push_back(net_.product(inverse(net_.frame(chart)), net_.value(chart, row.word)));
      lengths_.emplace_back(elements_.back());
      expect_less(i, squared_sinh(row.length[0] / 2), false);
      expect_less(i, squared_sinh(row.length[1] / 2), true);
      if (document_.up_to) expect_less(i, squared_sinh(*document_.up_to / 2), true);
    }
  }

  void check_distinct() {
    find_loops();
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Class& x = class_of(i);
        const Class& y = class_of(j);
        if (x.root == y.root && (x.exponent % y.exponent == 0 || y.exponent % x.exponent == 0)) {
          throw Refutation{name(i) + " is a power of " + name(j) + ", or the other way around"};
        }
      }
    }
  }

  void check_simple() {
    find_loops();
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      if (is_simple(listed_[i]) != document_.geodesics[i].simple) {
        throw Refutation{name(i) + (document_.geodesics[i].simple ? " is not simple" : " is simple")};
      }
    }
  }

  void check_equal() const {
    for (const Cluster& cluster : document_.clusters) {
      if (!cluster.equal) continue;
      for (std::size_t i = cluster.first + 1; i < cluster.first + cluster.count; ++i) {
        if (compare(lengths_[i], lengths_[cluster.first]) != 0) throw Refutation{name(i) + " has another length"};
      }
    }
  }

  void check_complete() {
    find_loops();
    if (document_.up_to) {
      std::vector<bool> is_listed(loops_.size());
      for (const std::size_t loop : listed_) is_listed[representative(loop)] = true;
      for (std::size_t i = 0; i < loops_.size(); ++i) {
        if (classes_[representative(i)].exponent == 1 && !is_listed[representative(i)]) {
          throw Refutation{"a closed geodesic is missing, that of a loop at vertex " + number(loops_[i].vertex)};
        }
      }
      return;
    }
    const Interval systole = enclosure(lengths_[0].numerator) / enclosure(lengths_[0].denominator);
    for (const Loop& loop : loops_) {
      const Answer shorter = is_less(squared_half_length(loop.g), systole);
      if (shorter == Answer::no ||
          (shorter == Answer::unknown && compare(HalfLength<R>(exact(loop)), lengths_[0]) >= 0))
        continue;
      throw Refutation{"a closed geodesic is shorter, that of a loop at vertex " + number(loop.vertex)};
    }
  }

 private:
  /// From a vertex along a dart: the lift of its end, and what takes coordinates of the end's chart to those of the
  /// start's.
  struct Step {
    Index end;
    Motion motion;
    Place place;
  };
  struct Lift {
    Index vertex;
    Motion frame;  ///< To the chart of the first vertex.
    Place place;
    std::size_t parent;
    Index dart;  ///< From the parent.
  };
  /// An element of the group at a vertex, not the identity.
  struct Loop {
    Index vertex;
    Motion g;
    Place place;               ///< Where g takes the vertex.
    std::vector<Index> darts;  ///< A path along which it is a product.
    std::size_t inverse = 0;
  };
  /// Of elements that are conjugate, or inverse to that: powers of what root.
  struct Class {
    std::size_t root;
    unsigned exponent = 1;
  };

  static std::string name(std::size_t i) { return "geodesic " + number(i); }

  void expect_less(std::size_t i, const SquaredSinh& s, bool wanted) {
    const Answer less = is_less(lengths_[i].numerator, lengths_[i].denominator, s);
    if (less == Answer::unknown) give_up(name(i) + " has a length that is nearly a bound");
    if ((less == Answer::yes) != wanted) throw Refutation{name(i) + " has another length, or one beyond the bound"};
  }

  static Motion enclose(const Isometry<R>& g) {
    const Interval root = sqrt(enclosure(R(norm(g.a) - norm(g.b))));
    const auto entry = [&](const R& x) { return enclosure(x) / root; };
    return {{entry(g.a.re), entry(g.a.im)}, {entry(g.b.re), entry(g.b.im)}};
  }

  /// sinh² of half the distance of a lift of vertex w from vertex v itself, in the chart of v.
  Interval half_distance(Index v, const Place& place, Index w) const {
    return norm(place.n - origin_[v] * place.d) / (gap_[v] * gap_[w]);
  }
  /// Two lifts of a vertex are the same if they are nearer than the shortest edge.
  Answer are_same(const Place& x, const Place& y, Index v) const {
    return is_less(norm(x.n * y.d - y.n * x.d) / square(gap_[v]), shortest_);
  }
  Place self(Index v) const { return {origin_[v], {1, 0}}; }
  /// Whether an element that takes vertex v so far is one of loops_, of which it must be decided.
  bool is_reached(Index v, const Place& place) const {
    return is_less(reach_, half_distance(v, place, v)) != Answer::yes;
  }
  std::size_t find(Index v, const Place& place) const {
    const auto found = table_.find(v, place, [&](std::size_t i) { return are_same(loops_[i].place, place, v); });
    if (!found) give_up("a loop at vertex " + number(v) + " is nearly as long as the longest that are looked for");
    return *found;
  }

  /// All elements of the group at all vertices that move them by at most D, sinh²(D/2) = sinh²(L/2) cosh²ε, and whose
  /// length is at most L; their classes, and those of the list.
  void find_loops() {
    if (!steps_.empty()) return;
    prepare();
    const Interval longest(document_.up_to ? *document_.up_to : document_.geodesics[0].length[1]);
    bound_ = square(sinh(longest / 2));
    reach_ = bound_ * (1 + square(sinh(Interval(net_.net().epsilon))));
    // As many as fit into so many disks by area: 2π(cosh D − 1), cosh D = 1 + 2 sinh²(D/2), of −2πχ each V.
    const auto vertices = static_cast<long>(origin_.size());
    const auto minus_euler = static_cast<long>(net_.net().triangles.size() / 2) - vertices;
    if (is_less(Interval(kMaxLifts), 2 * reach_ * vertices * vertices / minus_euler) == Answer::yes) give_up(kTooMany);
    for (Index v = 0; v < origin_.size(); ++v) find_loops_at(v);
    parent_.resize(loops_.size());
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      Loop& loop = loops_[i];
      loop.inverse = find(loop.vertex, image(inverse(loop.g), self(loop.vertex)));
      join(i, loop.inverse);
      for (const Index dart : leaving_[loop.vertex]) {
        const Place place = image(inverse(steps_[dart].motion), image(loop.g, steps_[dart].place));
        if (is_reached(steps_[dart].end, place)) join(i, find(steps_[dart].end, place));
      }
    }
    find_powers();
    for (std::size_t i = 0; i < elements_.size(); ++i) listed_.push_back(near_its_axis(i));
  }

  void prepare() {
    const Net& net = net_.net();
    leaving_.resize(net.vertices.size());
    for (const Vertex& vertex : net.vertices) {
      const auto m = enclosure(vertex.z.m);
      origin_.push_back({enclosure(vertex.z.n.re) / m, enclosure(vertex.z.n.im) / m});
      gap_.push_back(enclosure(gap(vertex.z)) / square(m));
    }
    std::optional<std::array<R, 2>> shortest;
    for (Index dart = 0; dart < net_.darts(); ++dart) {
      const Index end = net_.start(next(dart));
      leaving_[net_.start(dart)].push_back(dart);
      const Motion motion = enclose(net_.element(dart));
      steps_.push_back({end, motion, image(motion, self(end))});
      const Point<R> p = net_.corner(dart);
      const Point<R> q = net_.corner(next(dart));
      std::array<R, 2> half{squared_difference(p, q), R(gap(p) * gap(q))};
      if (!shortest || sgn(R(half[0] * (*shortest)[1] - (*shortest)[0] * half[1])) < 0) shortest = std::move(half);
    }
    shortest_ = enclosure((*shortest)[0]) / enclosure((*shortest)[1]);
  }

  void find_loops_at(Index first) {
    std::vector<Lift> lifts{{first, {}, self(first), 0, 0}};
    PointTable table;
    table.insert(first, lifts[0].place, 0);
    for (std::size_t i = 0; i < lifts.size(); ++i) {
      for (const Index dart : leaving_[lifts[i].vertex]) {
        const Step& step = steps_[dart];
        const Place place = image(lifts[i].frame, step.place);
        if (is_less(reach_, half_distance(first, place, step.end)) == Answer::yes) continue;
        if (table.find(step.end, place, [&](std::size_t k) { return are_same(lifts[k].place, place, step.end); }))
          continue;
        if (++lifts_ > kMaxLifts) give_up(kTooMany);
        table.insert(step.end, place, lifts.size());
        lifts.push_back({step.end, compose(lifts[i].frame, step.motion), place, i, dart});
      }
    }
    for (std::size_t i = 1; i < lifts.size(); ++i) {
      const Lift& lift = lifts[i];
      if (lift.vertex != first ||
          !decided(is_less(squared_half_length(lift.frame), bound_), "whether a loop is too long"))
        continue;
      Loop loop{first, lift.frame, lift.place, {}};
      for (std::size_t k = i; k != 0; k = lifts[k].parent) loop.darts.push_back(lifts[k].dart);
      table_.insert(first, lift.place, loops_.size());
      loops_.push_back(std::move(loop));
    }
  }

  std::size_t representative(std::size_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }
  void join(std::size_t i, std::size_t j) {
    i = representative(i);
    j = representative(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

  void find_powers() {
    for (std::size_t i = 0; i < loops_.size(); ++i) classes_.push_back({i});
    for (const Loop& loop : loops_) {
      const std::size_t own = representative(static_cast<std::size_t>(&loop - loops_.data()));
      Motion power = loop.g;
      for (unsigned exponent = 2;; ++exponent) {
        power = compose(loop.g, power);
        const Place place = image(power, self(loop.vertex));
        if (!decided(is_less(squared_half_length(power), bound_), "whether a power is too long") ||
            !is_reached(loop.vertex, place))
          break;
        // Of all roots the primitive one has the largest exponent.
        Class& found = classes_[representative(find(loop.vertex, place))];
        if (found.exponent < exponent) found = {own, exponent};
      }
    }
  }

  const Class& class_of(std::size_t i) const { return classes_[representative(listed_[i])]; }

  /// The element of the list, at a vertex where it is one of loops_: moved along edges to where its loop is shorter.
  std::size_t near_its_axis(std::size_t i) {
    Index v = document_.geodesics[i].vertex;
    Isometry<R> exact = elements_[i];
    Motion g = enclose(exact);
    Interval distance = half_distance(v, image(g, self(v)), v);
    for (bool moved = true; moved;) {
      moved = false;
      for (const Index dart : leaving_[v]) {
        const Step& step = steps_[dart];
        const Interval other = half_distance(step.end, image(inverse(step.motion), image(g, step.place)), step.end);
        if (is_less(other, distance) != Answer::yes) continue;
        const Isometry<R> element = net_.element(dart);
        exact = net_.product(inverse(element), net_.product(exact, element));
        g = enclose(exact);
        v = step.end;
        distance = other;
        moved = true;
        break;
      }
    }
    return find(v, image(g, self(v)));
  }

  /// Whether no two axes of the class cross near a vertex.
  bool is_simple(std::size_t loop) const {
    const Interval thick = 1 + square(sinh(Interval(net_.net().epsilon)));
    std::map<Index, std::vector<std::size_t>> near;
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      if (representative(i) != representative(loop)) continue;
      const Loop& x = loops_[i];
      const Interval sigma = squared_half_length(x.g);
      if (is_less(sigma * thick, half_distance(x.vertex, x.place, x.vertex)) == Answer::yes) continue;
      for (const std::size_t j : near[x.vertex]) {
        if (loops_[j].inverse == i) continue;
        const Motion& y = loops_[j].g;
        const Interval mixed = x.g.b.im * y.b.im + x.g.b.re * y.b.re - x.g.a.im * y.a.im;
        if (decided(is_less(square(mixed), sigma * squared_half_length(y)), "whether two axes cross")) return false;
      }
      near[x.vertex].push_back(i);
    }
    return true;
  }

  Isometry<R> exact(const Loop& loop) {
    Isometry<R> result;
    for (const Index dart : loop.darts) result = net_.product(net_.element(dart), result);
    return result;
  }

  const GeodesicsDocument& document_;
  NetRules<R>& net_;
  std::vector<Isometry<R>> elements_;  ///< Of the list.
  std::vector<HalfLength<R>> lengths_;
  std::vector<std::vector<Index>> leaving_;  ///< Darts, by vertex.
  std::vector<Step> steps_;                  ///< By dart.
  std::vector<Vector> origin_;               ///< By vertex: where it is in its chart, and 1 − |z|².
  std::vector<Interval> gap_;
  Interval shortest_;  ///< sinh² of half the shortest edge, of L/2, and of D/2.
  Interval bound_;
  Interval reach_;
  long lifts_ = 0;
  std::vector<Loop> loops_;
  PointTable table_;
  std::vector<std::size_t> parent_;  ///< Of a class.
  std::vector<Class> classes_;       ///< By representative.
  std::vector<std::size_t> listed_;  ///< Loops of the elements of the list.
};

/// The runs that lengths make: a new one starts where lo is greater than all hi before.
void expect_runs(const GeodesicsDocument& document) {
  std::vector<std::array<std::size_t, 2>> runs;
  mpq_class most;
  for (const ClosedGeodesic& row : document.geodesics) {
    if (runs.empty() || row.length[0] > most) runs.push_back({runs.empty() ? 0 : runs.back()[0] + runs.back()[1], 0});
    ++runs.back()[1];
    most = std::max(most, row.length[1]);
  }
  const bool same =
      std::equal(runs.begin(), runs.end(), document.clusters.begin(), document.clusters.end(),
                 [](const auto& run, const Cluster& c) { return run[0] == c.first && run[1] == c.count; });
  if (!same) throw Malformed("clusters: not the runs that the lengths make");
}

}  // namespace

template <class R>
std::vector<Rule> geodesic_rules(const GeodesicsDocument& document, NetRules<R>& net) {
  const std::vector<ClosedGeodesic>& rows = document.geodesics;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    expect_less(rows[i].vertex, net.net().vertices.size(), "vertex");
    const Index tile = net.net().charts[net.net().vertices[rows[i].vertex].chart].first;
    net.expect_path(rows[i].word, tile, tile);
    if (rows[i].length[0] <= 0) throw Malformed("a length is not positive");
    if (i > 0 && rows[i].length[0] < rows[i - 1].length[0]) throw Malformed("lo decreases");
  }
  const auto rules = std::make_shared<GeodesicRules<R>>(document, net);
  const Rule lengths{"geodesics", [rules] { rules->check_lengths(); }};
  const Rule simple{"simple", [rules] { rules->check_simple(); }};
  const Rule complete{"complete", [rules] { rules->check_complete(); }};
  if (!document.up_to) {
    if (rows.size() != 1 || rows[0].length[1] >= 2 * rows[0].length[0]) throw Malformed("not one systole");
    return {lengths, simple, complete};
  }
  if (*document.up_to <= 0) throw Malformed("up_to is not positive");
  expect_runs(document);
  return {lengths,
          {"distinct", [rules] { rules->check_distinct(); }},
          simple,
          {"equal", [rules] { rules->check_equal(); }},
          complete};
}

template std::vector<Rule> geodesic_rules(const GeodesicsDocument& document, NetRules<mpz_class>& net);
template std::vector<Rule> geodesic_rules(const GeodesicsDocument& document, NetRules<Algebraic>& net);

}  // namespace epsnet::exact
