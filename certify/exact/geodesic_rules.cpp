#include "certify/exact/geodesic_rules.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "certify/exact/claim_rules.h"

namespace epsnet::exact {
namespace {

/// ⟨m, X⟩ for m = (−Im b, Re b, Im a) and the point n/d: with Re a > 0, positive on the left of the axis.
template <class R>
R height(const Isometry<R>& g, const Complex<R>& n, const Complex<R>& d) {
  const Complex<R> z = n * conjugate(d);
  return R(2) * (g.b.re * z.im - g.b.im * z.re) - g.a.im * (norm(n) + norm(d));
}

template <class R>
class Cutter {
 public:
  Cutter(NetRules<R>& net, const Loops<R>& loops, const std::vector<std::size_t>& geodesics)
      : net_(net), loops_(loops), elements_(net.net().vertices.size()), sides_(2 * geodesics.size(), kNone) {
    find_elements(geodesics);
    for (Index dart = 0; dart < net_.darts(); ++dart) {
      count_on(dart);
      first_.push_back(parent_.size());
      const std::size_t segments = dart < net_.opposite(dart) ? crossings_[dart].size() + 1 : 0;
      for (std::size_t k = 0; k < segments; ++k) parent_.push_back(parent_.size());
    }
    for (Index dart = 0; dart < net_.darts(); ++dart) {
      for (std::size_t k = 0; k <= around(dart); ++k) join(segment(dart, k), segment(edge_before(dart), k));
    }
  }

  [[nodiscard]] std::vector<Piece> run() {
    find_sides();
    std::vector<Piece> pieces;
    for (const auto& [root, euler] : euler_characteristics()) {
      std::vector<std::array<Index, 2>> boundaries;
      for (Index k = 0; k < sides_.size(); ++k) {
        if (sides_[k] == root) boundaries.push_back({k / 2, k % 2});
      }
      const long twice_genus = 2 - euler - static_cast<long>(boundaries.size());
      if (twice_genus < 0 || twice_genus % 2 != 0) give_up("a piece has no genus");
      pieces.push_back({static_cast<Index>(twice_genus / 2), std::move(boundaries)});
    }
    return pieces;
  }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  struct Element {
    Index geodesic;
    std::size_t loop;
  };
  /// Where a lift of a geodesic counts on an edge, from where a dart starts.
  struct Crossing {
    Index geodesic;
    bool from_left;
    Interval t;
  };
  struct End {
    Interval height;
    bool is_left;
  };

  /// All that edges lead to from the one that is given.
  void find_elements(const std::vector<std::size_t>& geodesics) {
    std::vector<bool> known(loops_.all().size());
    for (Index i = 0; i < geodesics.size(); ++i) {
      std::vector<std::size_t> found{geodesics[i]};
      known[geodesics[i]] = true;
      for (std::size_t k = 0; k < found.size(); ++k) {
        const Index v = loops_.all()[found[k]].vertex;
        elements_[v].push_back({i, found[k]});
        for (const Index dart : loops_.leaving(v)) {
          const auto other = loops_.along(found[k], dart);
          if (!other || known[*other]) continue;
          known[*other] = true;
          found.push_back(*other);
        }
      }
    }
  }

  /// Those at the start of the dart, and those at its end that are not found at both.
  void count_on(Index dart) {
    auto& crossings = crossings_.emplace_back();
    const Index other = net_.opposite(dart);
    if (other < dart) return;
    for (const Index from : {dart, other}) {
      for (const Element& element : elements_[net_.start(from)]) {
        End start = end_of(element, from, false);
        End end = end_of(element, from, true);
        if (start.is_left == end.is_left || (from == other && loops_.along(element.loop, other))) continue;
        if (from == other) std::swap(start, end);
        Crossing crossing{element.geodesic, start.is_left, start.height / (start.height - end.height)};
        const auto is_before = [](const Crossing& x, const Crossing& y) {
          return decided(is_less(x.t, y.t), "which of two geodesics crosses an edge first");
        };
        crossings.insert(std::lower_bound(crossings.begin(), crossings.end(), crossing, is_before), crossing);
      }
    }
  }

  /// Where the start of a dart, or its end, is from the axis of an element at the start.
  [[nodiscard]] End end_of(const Element& element, Index dart, bool at_end) const {
    const auto& loop = loops_.all()[element.loop];
    const Place place = at_end ? loops_.step(dart).place : loops_.self(loop.vertex);
    const Interval h = height(loop.g, place.n, place.d);
    const bool is_turned = decided(is_less(loop.g.a.re, Interval(0)), "the direction of an axis");
    const Interval oriented = is_turned ? -h : h;
    const Answer is_right = is_less(oriented, Interval(0));
    if (is_right != Answer::unknown) return {oriented, is_right == Answer::no};
    const Isometry<R> g = loops_.exact(loop);
    Point<R> z = point<R>(net_.net().vertices[at_end ? loops_.step(dart).end : loop.vertex].z);
    if (at_end) z = net_.image(net_.element(dart), z);
    return {oriented, sgn(height(g, z.n, {z.m, R(0)})) * sgn(g.a.re) >= 0};
  }

  [[nodiscard]] std::size_t count(Index dart) const { return crossings_[std::min(dart, net_.opposite(dart))].size(); }
  /// The other edge at the corner where the dart starts, from there.
  [[nodiscard]] Index edge_before(Index dart) const { return net_.opposite(previous(dart)); }
  /// How many cut off this corner.
  [[nodiscard]] std::size_t around(Index dart) const {
    const std::array counts{count(dart), count(next(dart)), count(previous(dart))};
    const std::size_t twice = counts[0] + counts[1] + counts[2];
    // Implied by Lemma 15.4.
    if (twice % 2 != 0 || 2 * *std::max_element(counts.begin(), counts.end()) > twice) give_up("half an arc");
    return twice / 2 - counts[1];
  }
  /// Segment number k from where the dart starts.
  [[nodiscard]] std::size_t segment(Index dart, std::size_t k) const {
    const Index other = net_.opposite(dart);
    return dart < other ? first_[dart] + k : first_[other] + count(dart) - k;
  }

  [[nodiscard]] std::size_t root(std::size_t i) {
    for (; parent_[i] != i; i = parent_[i]) parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) { parent_[root(i)] = root(j); }

  void find_sides() {
    for (Index dart = 0; dart < net_.darts(); ++dart) {
      for (std::size_t k = 0; k < crossings_[dart].size(); ++k) {
        const Crossing& crossing = crossings_[dart][k];
        for (const bool is_right : {false, true}) {
          const std::size_t here = root(segment(dart, crossing.from_left == is_right ? k + 1 : k));
          std::size_t& side = sides_[2 * std::size_t{crossing.geodesic} + (is_right ? 1 : 0)];
          // Implied by Lemma 15.4.
          if (side != kNone && side != here) give_up("a side of a geodesic is in two pieces");
          side = here;
        }
      }
    }
  }

  /// By component.
  [[nodiscard]] std::map<std::size_t, long> euler_characteristics() {
    std::map<std::size_t, long> euler;
    for (Index v = 0; v < elements_.size(); ++v) ++euler[root(segment(loops_.leaving(v).front(), 0))];
    for (std::size_t i = 0; i < parent_.size(); ++i) --euler[root(i)];
    for (Index dart = 0; dart < net_.darts(); ++dart) {
      const std::size_t cells = around(dart) + (dart % 3 == 0 ? 1 : 0);
      for (std::size_t k = 0; k < cells; ++k) ++euler[root(segment(dart, k))];
    }
    return euler;
  }

  NetRules<R>& net_;
  const Loops<R>& loops_;
  std::vector<std::vector<Element>> elements_;    ///< By vertex.
  std::vector<std::size_t> sides_;                ///< The component at side s of geodesic i, by 2i + s.
  std::vector<std::vector<Crossing>> crossings_;  ///< By dart, of the lesser dart of an edge: in their order.
  std::vector<std::size_t> first_;                ///< Likewise, its first segment.
  std::vector<std::size_t> parent_;               ///< Of a segment, in a set.
};

}  // namespace

template <class R>
std::vector<Piece> pieces(NetRules<R>& net, const Loops<R>& loops, const std::vector<std::size_t>& geodesics) {
  return Cutter<R>(net, loops, geodesics).run();
}

template std::vector<Piece> pieces(NetRules<mpz_class>&, const Loops<mpz_class>&, const std::vector<std::size_t>&);
template std::vector<Piece> pieces(NetRules<Algebraic>&, const Loops<Algebraic>&, const std::vector<std::size_t>&);
template std::vector<Piece> pieces(NetRules<FieldNumber>&, const Loops<FieldNumber>&, const std::vector<std::size_t>&);

namespace {

using Claim = GeodesicsDocument::Claim;

std::string name(std::size_t i) { return "geodesic " + number(i); }

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

/// Every side of every geodesic once.
void expect_sides(const GeodesicsDocument& document) {
  std::set<std::array<Index, 2>> sides;
  for (const Piece& piece : document.pieces) {
    for (const auto& side : piece.boundaries) {
      expect_less(side[0], document.geodesics.size(), "geodesic");
      expect_less(side[1], 2, "side");
      if (!sides.insert(side).second) throw Malformed("pieces: a side occurs twice");
    }
  }
  if (sides.size() != 2 * document.geodesics.size()) throw Malformed("pieces: a side is missing");
}

/// Of a local maximum: the first run is one of equal lengths; some of it, in order, as many as there are coordinates of
/// surfaces; and a weight for each other one.
void expect_basis(const GeodesicsDocument& document) {
  if (document.clusters.empty() || !document.clusters[0].equal) throw Malformed("clusters: the first are not equal");
  const Index shortest = document.clusters[0].count;
  // 2 - 2g is the number of vertices less half that of triangles.
  if (2 * document.basis.size() + 6 * document.net.vertices.size() != 3 * document.net.triangles.size()) {
    throw Malformed("basis: not 6g - 6 geodesics");
  }
  for (std::size_t k = 0; k < document.basis.size(); ++k) {
    expect_less(document.basis[k], shortest, "geodesic of the basis");
    if (k > 0 && document.basis[k] <= document.basis[k - 1]) throw Malformed("basis: not in order");
  }
  if (document.basis.size() + document.weights.size() != shortest) throw Malformed("weights: not one for each other");
  for (const Index weight : document.weights) {
    if (weight == 0) throw Malformed("weights: one is 0");
  }
}

/// In one order, whatever that of the file.
std::vector<Piece> sorted(std::vector<Piece> pieces) {
  for (Piece& piece : pieces) std::sort(piece.boundaries.begin(), piece.boundaries.end());
  std::sort(pieces.begin(), pieces.end());
  return pieces;
}

}  // namespace

template <class R>
GeodesicRules<R>::GeodesicRules(const GeodesicsDocument& document, NetRules<R>& net, long most_lifts)
    : document_(document), net_(net), most_lifts_(most_lifts) {
  const std::vector<ClosedGeodesic>& rows = document.geodesics;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    exact::expect_less(rows[i].vertex, net.net().vertices.size(), "vertex");
    const Index tile = net.net().charts[net.net().vertices[rows[i].vertex].chart].first;
    net.expect_path(rows[i].word, tile, tile);
    if (rows[i].length[0] <= 0) throw Malformed("a length is not positive");
    if (i > 0 && rows[i].length[0] < rows[i - 1].length[0]) throw Malformed("lo decreases");
  }
  if (document.claim == Claim::systole) {
    if (rows.size() != 1 || rows[0].length[1] >= 2 * rows[0].length[0]) throw Malformed("not one systole");
  } else {
    if (document.has_up_to() && document.up_to <= 0) throw Malformed("up_to is not positive");
    expect_runs(document);
    if (is_thick_thin()) expect_sides(document);
    if (document.claim == Claim::local_maximum) expect_basis(document);
  }
}

template <class R>
std::vector<Rule> GeodesicRules<R>::rules() {
  std::vector<Rule> rules{{"geodesics", [this] { check_lengths(); }}};
  const bool is_list = document_.claim != Claim::systole;
  if (is_list) rules.push_back({"distinct", [this] { check_distinct(); }});
  rules.push_back({"simple", [this] { check_simple(); }});
  if (is_list) rules.push_back({"equal", [this] { check_equal(); }});
  rules.push_back({"complete", [this] { check_complete(); }});
  if (is_thick_thin()) rules.push_back({"pieces", [this] { check_pieces(); }});
  if (document_.claim == Claim::local_maximum) rules.push_back({"maximal", [this] { check_maximal(); }});
  return rules;
}

template <class R>
Loops<R>& GeodesicRules<R>::loops() {
  if (loops_) return *loops_;
  const std::vector<ClosedGeodesic>& rows = document_.geodesics;
  const bool is_systole = document_.claim == Claim::systole;
  // Powers of the first geodesic, both ways, are lifts at a vertex near its axis. 2 arsinh 1 is more than 1.
  const mpq_class longest = is_thick_thin() ? mpq_class(1) : is_systole ? rows[0].length[1] : document_.up_to;
  if (!rows.empty() && 2 * longest > most_lifts_ * rows[0].length[1]) leave_loops_out();
  // Of a thick-thin decomposition more than 1, as lengths may be 2 arsinh 1 exactly.
  bound_ = is_thick_thin() ? 1 + Interval(1, 1, 32) : square(sinh(Interval(longest) / 2));
  loops_.emplace(net_, bound_, most_lifts_);
  find_powers();
  for (std::size_t i = 0; i < elements_.size(); ++i) listed_.push_back(near_its_axis(i));
  return *loops_;
}

template <class R>
void GeodesicRules<R>::check_lengths() {
  const auto sinh_of_half = [](const mpq_class& length) { return squared_sinh(length / 2); };
  std::optional<SquaredSinh> up_to;  // Once for all geodesics: it may have many digits.
  for (std::size_t i = 0; i < document_.geodesics.size(); ++i) {
    const ClosedGeodesic& row = document_.geodesics[i];
    const Index chart = net_.net().vertices[row.vertex].chart;
    elements_.push_back(net_.product(inverse(net_.frame(chart)), net_.value(chart, row.word)));
    lengths_.emplace_back(elements_.back());
    expect_less(i, sinh_of_half(row.length[0]), false);
    expect_less(i, sinh_of_half(row.length[1]), true);
    if (document_.has_up_to()) {
      if (!up_to) up_to = sinh_of_half(document_.up_to);
      expect_less(i, *up_to, true);
    }
    if (is_thick_thin() && !is_small(lengths_[i])) throw Refutation{name(i) + " is longer than 2 arsinh 1"};
  }
}

template <class R>
void GeodesicRules<R>::expect_less(std::size_t i, const SquaredSinh& bound, bool wanted) {
  const Answer less = is_less(lengths_[i].numerator, lengths_[i].denominator, bound);
  if (less == Answer::unknown) give_up(name(i) + " has a length that is nearly a bound");
  if ((less == Answer::yes) != wanted) throw Refutation{name(i) + " has another length, or one beyond the bound"};
}

template <class R>
void GeodesicRules<R>::check_distinct() {
  static_cast<void>(loops());
  std::map<std::size_t, std::vector<std::size_t>> of_root;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    std::vector<std::size_t>& before = of_root[class_of(i).root];
    for (const std::size_t j : before) {
      const unsigned x = class_of(i).exponent;
      const unsigned y = class_of(j).exponent;
      if (x % y == 0 || y % x == 0) {
        throw Refutation{name(i) + " is a power of " + name(j) + ", or the other way around"};
      }
    }
    before.push_back(i);
  }
}

template <class R>
void GeodesicRules<R>::check_simple() {
  static_cast<void>(loops());
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    if (is_simple(listed_[i]) != document_.geodesics[i].simple) {
      throw Refutation{name(i) + (document_.geodesics[i].simple ? " is not simple" : " is simple")};
    }
  }
}

template <class R>
bool GeodesicRules<R>::is_simple(std::size_t loop) {
  std::map<Index, std::vector<std::size_t>> near;
  for (const std::size_t i : loops().members(loops().representative(loop))) {
    const auto& x = loops().all()[i];
    if (!loops().is_near_axis(i)) continue;
    const Interval sigma = squared_half_length(x.g);
    for (const std::size_t j : near[x.vertex]) {
      const auto& y = loops().all()[j];
      if (y.inverse == i) continue;
      const Interval product = lorentz_product(axis_normal(x.g), axis_normal(y.g));
      if (decided(is_less(square(product), sigma * squared_half_length(y.g)), "whether two axes cross")) return false;
    }
    near[x.vertex].push_back(i);
  }
  return true;
}

template <class R>
void GeodesicRules<R>::check_equal() const {
  for (const Cluster& cluster : document_.clusters) {
    if (!cluster.equal) continue;
    for (std::size_t i = cluster.first + 1; i < cluster.first + cluster.count; ++i) {
      if (compare(lengths_[i], lengths_[cluster.first]) != 0) throw Refutation{name(i) + " has another length"};
    }
  }
}

template <class R>
void GeodesicRules<R>::check_complete() {
  std::vector<bool> is_listed(loops().all().size());
  for (const std::size_t loop : listed_) is_listed[loops_->representative(loop)] = true;
  const Interval systole = document_.claim == Claim::systole
                               ? enclosure(lengths_[0].numerator) / enclosure(lengths_[0].denominator)
                               : Interval();
  for (std::size_t i = 0; i < is_listed.size(); ++i) {
    if (loops_->representative(i) != i) continue;  // As long as its representative.
    const auto& loop = loops_->all()[i];
    const std::string where = ", that of a loop at vertex " + number(loop.vertex);
    if (document_.claim == Claim::systole) {
      const Answer shorter = is_less(squared_half_length(loop.g), systole);
      if (shorter == Answer::no ||
          (shorter == Answer::unknown && compare(HalfLength<R>(loops_->exact(loop)), lengths_[0]) >= 0))
        continue;
      throw Refutation{"a closed geodesic is shorter" + where};
    }
    if (classes_[i].exponent == 1 && !is_listed[i]) {
      if (is_thick_thin() && !is_small(HalfLength<R>(loops_->exact(loop)))) continue;
      throw Refutation{"a closed geodesic is missing" + where};
    }
  }
}

template <class R>
void GeodesicRules<R>::check_pieces() {
  std::vector<std::size_t> directed;  // A word leads from z to where its value takes z from.
  for (const std::size_t loop : listed_) directed.push_back(loops().all()[loop].inverse);
  const std::vector<Piece> found = sorted(pieces(net_, loops(), directed));
  if (found == sorted(document_.pieces)) return;
  std::string text = "the pieces are, with their genera and boundaries:";
  for (const Piece& piece : found) text += " (" + number(piece.genus) + ", " + number(piece.boundaries.size()) + ")";
  throw Refutation{text};
}

template <class R>
void GeodesicRules<R>::check_maximal() {
  const std::vector<std::vector<Interval>> derivatives = twist_derivatives();
  std::vector<std::vector<Interval>> of_basis;
  std::vector<Interval> of_others;
  for (const std::vector<Interval>& row : derivatives) {
    of_basis.emplace_back();
    of_others.emplace_back(0);
    auto weight = document_.weights.begin();
    for (Index j = 0; j < row.size(); ++j) {
      if (std::binary_search(document_.basis.begin(), document_.basis.end(), j)) {
        of_basis.back().push_back(row[j]);
      } else {
        of_others.back() = of_others.back() - Interval(static_cast<long>(*weight++)) * row[j];
      }
    }
  }
  const auto weights = solution(std::move(of_basis), std::move(of_others));
  if (!weights) give_up("whether the gradients of the basis span is not decided by the digits used");
  for (std::size_t k = 0; k < weights->size(); ++k) {
    if (is_less(Interval(0), (*weights)[k]) != Answer::no) continue;
    throw Refutation{name(document_.basis[k]) + " has a weight that is not positive"};
  }
  for (const Interval& weight : *weights) {
    if (is_less(Interval(0), weight) != Answer::yes) give_up("whether a weight is positive is not decided");
  }
}

template <class R>
std::vector<std::vector<Interval>> GeodesicRules<R>::twist_derivatives() {
  struct Near {
    Index geodesic;
    std::size_t loop;
  };
  std::map<Index, std::vector<Near>> near;
  for (Index j = 0; j < document_.clusters[0].count; ++j) {
    for (const std::size_t i : loops().members(loops().representative(listed_[j]))) {
      if (loops().is_near_axis(i)) near[loops().all()[i].vertex].push_back({j, i});
    }
  }
  std::vector<std::vector<Interval>> result(document_.basis.size(), std::vector<Interval>(document_.clusters[0].count));
  for (const auto& [vertex, elements] : near) {
    for (const Near& x : elements) {
      const auto row = std::lower_bound(document_.basis.begin(), document_.basis.end(), x.geodesic);
      if (row == document_.basis.end() || *row != x.geodesic) continue;
      const Motion& f = loops().all()[x.loop].g;
      const Vector m = axis_normal(f);
      for (const Near& y : elements) {
        if (y.geodesic == x.geodesic) continue;
        const Motion& g = loops().all()[y.loop].g;
        const Vector n = axis_normal(g);
        const Interval product = lorentz_product(m, n);
        const Interval squares = squared_half_length(f) * squared_half_length(g);
        if (!decided(is_less(square(product), squares), "whether two axes cross")) continue;
        const bool to_right = decided(is_less(m[0] * n[1], m[1] * n[0]), "from which side one axis crosses another");
        result[static_cast<std::size_t>(row - document_.basis.begin())][y.geodesic] = to_right ? -product : product;
      }
    }
  }
  return result;
}

template <class R>
void GeodesicRules<R>::find_powers() {
  const auto& loops = loops_->all();
  for (std::size_t i = 0; i < loops.size(); ++i) classes_.push_back({i});
  for (std::size_t i = 0; i < loops.size(); ++i) {
    Motion power = loops[i].g;
    for (unsigned exponent = 2;; ++exponent) {
      power = compose(loops[i].g, power);
      const Place place = image(power, loops_->self(loops[i].vertex));
      if (!decided(is_less(squared_half_length(power), bound_), "whether a power is too long") ||
          !loops_->is_reached(loops[i].vertex, place))
        break;
      // Of all roots the primitive one has the largest exponent.
      Class& found = classes_[loops_->representative(loops_->at(loops[i].vertex, place))];
      if (found.exponent < exponent) found = {loops_->representative(i), exponent};
    }
  }
}

template <class R>
std::size_t GeodesicRules<R>::near_its_axis(std::size_t i) {
  Index v = document_.geodesics[i].vertex;
  Isometry<R> exact = elements_[i];
  Motion g = enclose(exact);
  Interval distance = loops_->half_distance(v, image(g, loops_->self(v)), v);
  for (bool moved = true; moved;) {
    moved = false;
    for (const Index dart : loops_->leaving(v)) {
      const auto& step = loops_->step(dart);
      const Interval other =
          loops_->half_distance(step.end, image(inverse(step.motion), image(g, step.place)), step.end);
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
  return loops_->at(v, image(g, loops_->self(v)));
}

template <class R>
std::vector<Rule> geodesic_rules(const GeodesicsDocument& document, NetRules<R>& net, long most_lifts) {
  const auto rules = std::make_shared<GeodesicRules<R>>(document, net, most_lifts);
  return kept(rules, rules->rules());
}

template std::vector<Rule> geodesic_rules(const GeodesicsDocument& document, NetRules<mpz_class>& net, long);
template std::vector<Rule> geodesic_rules(const GeodesicsDocument& document, NetRules<Algebraic>& net, long);
template std::vector<Rule> geodesic_rules(const GeodesicsDocument& document, NetRules<FieldNumber>& net, long);

template class GeodesicRules<mpz_class>;
template class GeodesicRules<Algebraic>;
template class GeodesicRules<FieldNumber>;

}  // namespace epsnet::exact
