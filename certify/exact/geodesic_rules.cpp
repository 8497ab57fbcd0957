#include "certify/exact/geodesic_rules.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "certify/exact/claim_rules.h"
#include "certify/exact/pieces.h"

namespace epsnet::exact {
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
    if (document.claim == Claim::spectrum && document.up_to <= 0) throw Malformed("up_to is not positive");
    expect_runs(document);
    if (is_thick_thin()) expect_sides(document);
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
  for (std::size_t i = 0; i < document_.geodesics.size(); ++i) {
    const ClosedGeodesic& row = document_.geodesics[i];
    const Index chart = net_.net().vertices[row.vertex].chart;
    elements_.push_back(net_.product(inverse(net_.frame(chart)), net_.value(chart, row.word)));
    lengths_.emplace_back(elements_.back());
    expect_less(i, row.length[0], false);
    expect_less(i, row.length[1], true);
    if (document_.claim == Claim::spectrum) expect_less(i, document_.up_to, true);
    if (is_thick_thin() && !is_small(lengths_[i])) throw Refutation{name(i) + " is longer than 2 arsinh 1"};
  }
}

template <class R>
void GeodesicRules<R>::expect_less(std::size_t i, const mpq_class& length, bool wanted) {
  const Answer less = is_less(lengths_[i].numerator, lengths_[i].denominator, squared_sinh(length / 2));
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
    const auto& loop = loops_->all()[i];
    const std::string where = ", that of a loop at vertex " + number(loop.vertex);
    if (document_.claim == Claim::systole) {
      const Answer shorter = is_less(squared_half_length(loop.g), systole);
      if (shorter == Answer::no ||
          (shorter == Answer::unknown && compare(HalfLength<R>(loops_->exact(loop)), lengths_[0]) >= 0))
        continue;
      throw Refutation{"a closed geodesic is shorter" + where};
    }
    const std::size_t representative = loops_->representative(i);
    if (classes_[representative].exponent == 1 && !is_listed[representative]) {
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
