#include "certify/exact/net_rules.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace epsnet::exact {
namespace {

/// Bits of one number that is brought to lowest terms, and of all of them, with some more for each triangle: half a
/// minute.
constexpr std::size_t kMaxBits = std::size_t{1} << 22;
constexpr std::size_t kMaxBitsInAll = std::size_t{1} << 26;
constexpr std::size_t kBitsOfATriangle = std::size_t{1} << 13;
/// Bits of the directions around one corner, which are only multiplied.
constexpr std::size_t kMaxBitsOfDirections = std::size_t{1} << 32;

/// each_neighbour(i, visit) calls visit for every neighbour of number i.
template <class EachNeighbour>
void expect_connected(std::size_t count, const char* what, const EachNeighbour& each_neighbour) {
  std::vector<bool> reached(count);
  std::vector<Index> open;
  std::size_t seen = 0;
  const auto visit = [&](Index i) {
    if (!reached[i]) open.push_back(i);
    reached[i] = true;
  };
  for (visit(0); !open.empty(); ++seen) {
    const Index i = open.back();
    open.pop_back();
    each_neighbour(i, visit);
  }
  if (seen != count) throw Refutation{std::string("the ") + what + " are not connected"};
}

}  // namespace

void expect_less(std::size_t index, std::size_t size, const char* what) {
  if (index >= size) throw Malformed(std::string(what) + ' ' + number(index) + " does not exist");
}

NetRules::NetRules(const Net& net)
    : net_(net), bits_left_(kMaxBitsInAll + kBitsOfATriangle * net.triangles.size()), in_collar_(net.triangles.size()) {
  if (net_.epsilon <= 0) throw Malformed("epsilon is not positive");
  number_sides();
  for (const auto& [tile, centre] : net_.charts) {
    expect_less(tile, net_.tiles.size(), "tile");
    if (gap(centre) <= 0) throw Malformed("the centre of a chart is not in the disk");
  }
  for (const Label& label : net_.labels) {
    expect_less(label.from, net_.charts.size(), "chart");
    expect_less(label.to, net_.charts.size(), "chart");
    expect_path(label.word, net_.charts[label.from].first, net_.charts[label.to].first);
  }
  for (const Vertex& vertex : net_.vertices) {
    expect_less(vertex.chart, net_.charts.size(), "chart");
    if (gap(vertex.z) <= 0) throw Malformed("a vertex is not in the disk");
  }
  for (const Triangle& triangle : net_.triangles) check_triangle_structure(triangle);
  for (const Collar& collar : net_.collars.value_or(std::vector<Collar>())) check_collar_structure(collar);
}

std::vector<Rule> NetRules::rules() {
  std::vector<Rule> rules{{"surface", [this] { check_surface(); }},
                          {"map", [this] { check_map(); }},
                          {"gluing", [this] { check_gluing(); }}};
  if (net_.collars) rules.push_back({"collars", [this] { check_collars(); }});
  rules.push_back({"orientation", [this] { check_orientation(); }});
  rules.push_back({"delaunay", [this] { check_delaunay(); }});
  rules.push_back({"covering", [this] { check_covering(); }});
  rules.push_back({"packing", [this] { check_packing(); }});
  if (net_.collars) rules.push_back({"thick", [this] { check_thick(); }});
  return rules;
}

void NetRules::expect_path(const std::vector<Index>& word, Index from, Index to) const {
  Index tile = from;
  for (const Index side : word) {
    expect_less(side, tile_of_.size(), "side");
    if (tile_of_[side] != tile) throw Malformed("a word is no path");
    tile = tile_of_[partner_[side]];
  }
  if (tile != to) throw Malformed("a word ends in a wrong tile");
}

void NetRules::spend(std::size_t bits) {
  if (bits > kMaxBits || bits > bits_left_) throw TooLarge{"its exact numbers are too large"};
  bits_left_ -= bits;
}

Point NetRules::image(const Isometry& f, const Point& z) {
  spend(bits(f) + bits(z));
  const Gaussian n = f.a * z.n + z.m * f.b;
  const Gaussian d = conjugate(f.b) * z.n + z.m * conjugate(f.a);
  return lowest_terms(n * conjugate(d), norm(d));
}

Isometry NetRules::product(std::span<const Isometry* const> path) {
  if (path.empty()) return {};
  if (path.size() == 1) return *path[0];
  const Isometry first = product(path.first(path.size() / 2));
  Isometry result = compose(product(path.subspan(path.size() / 2)), first);
  spend(bits(result));
  reduce(result);
  return result;
}

Isometry NetRules::product(const Isometry& g, const Isometry& f) {
  const std::array<const Isometry*, 2> path{&f, &g};
  return product(path);
}

Isometry NetRules::value(Index from, const std::vector<Index>& word) {
  const Isometry frame = translation_to(net_.charts[from].second);
  std::vector<const Isometry*> path{&frame};
  for (const Index side : word) path.push_back(&crossings_[side]);
  return product(path);
}

void NetRules::number_sides() {
  for (Index t = 0; t < net_.tiles.size(); ++t) {
    const std::size_t size = net_.tiles[t].size();
    if (size < 3) throw Malformed("a tile has less than three vertices");
    first_side_.push_back(static_cast<Index>(tile_of_.size()));
    tile_of_.insert(tile_of_.end(), size, t);
  }
  if (tile_of_.empty()) throw Malformed("there is no tile");
  constexpr Index kNone = 0xFFFFFFFFU;
  partner_.assign(tile_of_.size(), kNone);
  const auto side = [&](Index tile, Index k) {
    expect_less(tile, net_.tiles.size(), "tile");
    expect_less(k, net_.tiles[tile].size(), "side");
    return first_side_[tile] + k;
  };
  for (const auto& [t, k, other_t, other_k] : net_.gluing) {
    const Index s = side(t, k);
    const Index other = side(other_t, other_k);
    if (s == other || partner_[s] != kNone || partner_[other] != kNone) throw Malformed("a side is glued twice");
    partner_[s] = other;
    partner_[other] = s;
  }
  if (std::find(partner_.begin(), partner_.end(), kNone) != partner_.end()) throw Malformed("a side is not glued");
}

void NetRules::check_triangle_structure(const Triangle& triangle) const {
  for (const Index v : triangle.vertex) expect_less(v, net_.vertices.size(), "vertex");
  for (const Index dart : triangle.opposite) expect_less(dart, 3 * net_.triangles.size(), "dart");
  const Index chart = net_.vertices[triangle.vertex[0]].chart;
  for (const std::size_t i : {1U, 2U}) {
    const Index own = net_.vertices[triangle.vertex[i]].chart;
    const Index label = triangle.label[i];
    expect_less(label, net_.labels.size() + 1, "label number");
    const bool fits =
        label == 0 ? own == chart : net_.labels[label - 1].from == own && net_.labels[label - 1].to == chart;
    if (!fits) throw Malformed("a label does not connect its triangle's charts");
  }
}

std::string NetRules::triangle_name(std::size_t t) const {
  const auto& v = net_.triangles[t].vertex;
  return "triangle " + number(t) + " (vertices " + number(v[0]) + ", " + number(v[1]) + ", " + number(v[2]) + ")";
}

std::string NetRules::edge_name(Index dart) const {
  return "the edge of dart " + number(dart) + " from vertex " + number(start(dart)) + " to vertex " +
         number(start(next(dart)));
}

Index NetRules::side_after(Index s) const {
  return vertex_of(s) + 1 < net_.tiles[tile_of_[s]].size() ? s + 1 : s - vertex_of(s);
}

Index NetRules::side_before(Index s) const {
  return vertex_of(s) > 0 ? s - 1 : s + static_cast<Index>(net_.tiles[tile_of_[s]].size()) - 1;
}

std::string NetRules::side_name(Index s) const {
  return "side " + number(vertex_of(s)) + " of tile " + number(tile_of_[s]);
}

void NetRules::check_surface() {
  for (std::size_t t = 0; t < net_.tiles.size(); ++t) check_tile(t);
  // (d)
  expect_connected(net_.tiles.size(), "tiles", [&](Index t, const auto& visit) {
    for (Index k = 0; k < net_.tiles[t].size(); ++k) visit(tile_of_[partner_[first_side_[t] + k]]);
  });
  check_lengths();
  const std::size_t cycles = check_corners();
  const auto euler =
      static_cast<std::int64_t>(cycles + net_.tiles.size()) - static_cast<std::int64_t>(tile_of_.size() / 2);
  // Implied by the angles around the corners, with Gauss–Bonnet (docs/proof.md, section 12).
  if (euler >= 0 || euler % 2 != 0) throw Refutation{"the Euler characteristic is " + std::to_string(euler)};
  euler_ = euler;
}

void NetRules::check_tile(std::size_t t) const {
  const std::vector<Point>& v = net_.tiles[t];
  const std::size_t n = v.size();
  const std::string name = "tile " + number(t);
  for (const Point& z : v) {
    if (gap(z) <= 0) throw Refutation{name + " has a vertex outside of the disk"};
  }
  for (std::size_t k = 0; k < n; ++k) {
    const bool left_turn = orientation(v[k], v[(k + 1) % n], v[(k + 2) % n]) > 0;
    const bool left_of_first = k < 2 || orientation(v[0], v[1], v[k]) > 0;
    const bool in_order = k < 1 || k + 1 >= n || orientation(v[0], v[k], v[k + 1]) > 0;
    if (!left_turn || !left_of_first || !in_order) {
      throw Refutation{name + " is not strictly convex and counterclockwise at its vertex " + number(k)};
    }
  }
}

void NetRules::check_lengths() {
  crossings_.resize(tile_of_.size());
  for (Index s = 0; s < tile_of_.size(); ++s) {
    const Index other = partner_[s];
    if (other < s) continue;
    const Point& p = side_start(s);
    const Point& q = side_end(s);
    const Point& p_other = side_start(other);
    const Point& q_other = side_end(other);
    // sinh² of half the length is |p − q|²/((1 − |p|²)(1 − |q|²)).
    if (squared_difference(p, q) * (gap(p_other) * gap(q_other)) !=
        squared_difference(p_other, q_other) * (gap(p) * gap(q))) {
      throw Refutation{side_name(s) + " is glued to " + side_name(other) + ", which is not of equal length"};
    }
    crossings_[s] = crossing(p, q, p_other, q_other);
    crossings_[other] = inverse(crossings_[s]);
  }
}

Isometry NetRules::crossing(const Point& p, const Point& q, const Point& p_other, const Point& q_other) {
  const Isometry first = inverse(translation_to(p));
  const Isometry last = translation_to(q_other);
  const Point from = image(first, q);
  const Point to = image(inverse(last), p_other);
  // |from| = |to|. The turn by to/from is z ↦ ρz/ρ̄ with ρ = 1 + to/from up to a real factor, or i if that is 0.
  Gaussian root = (from.m * to.n + to.m * from.n) * conjugate(from.n);
  if (root.re == 0 && root.im == 0) root = {0, 1};
  Isometry result = compose(last, compose(Isometry{root, {0, 0}}, first));
  spend(bits(result));
  reduce(result);
  return result;
}

std::size_t NetRules::check_corners() {
  std::vector<bool> seen(tile_of_.size());
  std::size_t cycles = 0;
  for (Index first = 0; first < seen.size(); ++first) {
    if (seen[first]) continue;
    ++cycles;
    const std::string name = "vertex " + number(vertex_of(first)) + " of tile " + number(tile_of_[first]);
    std::vector<const Isometry*> path;
    Gaussian direction{1, 0};
    int turns = 0;
    std::size_t size = 0;
    Index s = first;
    do {
      seen[s] = true;
      // Each corner turns by less than π: it completes a turn if it leads from the lower half-plane to the upper one.
      const bool was_below = is_below(direction);
      direction = direction * interior_angle(s);
      if (was_below && !is_below(direction)) ++turns;
      size += bits(direction);
      if (size > kMaxBitsOfDirections) throw TooLarge{"too many corners around " + name};
      path.push_back(&crossings_[s]);
      s = side_after(partner_[s]);
    } while (s != first);
    if (!is_identity(product(path))) throw Refutation{"the corners around " + name + " do not close up"};
    if (turns != 1 || direction.im != 0) {
      throw Refutation{"the angles around " + name + " add up to " + std::to_string(turns) + " full turns"};
    }
  }
  return cycles;
}

Gaussian NetRules::interior_angle(Index s) {
  const Isometry to_origin = inverse(translation_to(side_start(s)));
  const Point from = image(to_origin, side_end(s));
  const Point to = image(to_origin, side_start(side_before(s)));
  return to.n * conjugate(from.n);
}

void NetRules::check_map() {
  if (net_.vertices.empty() || net_.triangles.empty()) throw Refutation{"there is no vertex or no triangle"};
  for (Index dart = 0; dart < darts(); ++dart) {
    const Index other = opposite(dart);
    if (other == dart || opposite(other) != dart || start(dart) != start(next(other))) {
      throw Refutation{"dart " + number(dart) + " and dart " + number(other) + " are not opposite to each other"};
    }
  }
  std::vector<bool> seen(darts());
  std::vector<bool> met(net_.vertices.size());
  for (Index first = 0; first < darts(); ++first) {
    if (seen[first]) continue;
    if (met[start(first)]) throw Refutation{"vertex " + number(start(first)) + " has several cycles of darts"};
    met[start(first)] = true;
    for (Index dart = first; !seen[dart]; dart = opposite(previous(dart))) seen[dart] = true;
  }
  const auto lonely = std::find(met.begin(), met.end(), false);
  if (lonely != met.end()) throw Refutation{"vertex " + std::to_string(lonely - met.begin()) + " is in no triangle"};
  expect_connected(net_.triangles.size(), "triangles", [&](Index t, const auto& visit) {
    for (const Index dart : net_.triangles[t].opposite) visit(dart / 3);
  });
  const auto euler =
      static_cast<std::int64_t>(net_.vertices.size() + net_.triangles.size()) - static_cast<std::int64_t>(darts() / 2);
  if (euler != euler_) throw Refutation{"V - E + F = " + std::to_string(euler) + ", not that of the surface"};
}

const Isometry& NetRules::label(Index number_of_label) {
  const auto [found, is_new] = labels_.try_emplace(number_of_label);
  if (!is_new || number_of_label == 0) return found->second;
  const Label& l = net_.labels[number_of_label - 1];
  return found->second = product(inverse(translation_to(net_.charts[l.to].second)), value(l.from, l.word));
}

void NetRules::check_gluing() {
  std::set<std::array<Index, 4>> known;
  for (Index dart = 0; dart < darts(); ++dart) {
    const Index other = opposite(dart);
    if (other < dart) continue;
    const std::array<Index, 4> equation{label_number(dart), label_number(next(other)), label_number(next(dart)),
                                        label_number(other)};
    const auto& [a, b, c, d] = equation;
    if ((a == c && b == d) || (a == b && c == d) || !known.insert(equation).second) continue;
    const Isometry left = compose(label(a), inverse(label(b)));
    const Isometry right = compose(label(c), inverse(label(d)));
    if (!is_identity(compose(inverse(left), right))) throw Refutation{edge_name(dart) + ": the labels differ"};
  }
}

Point NetRules::corner(Index dart) {
  const Point& z = net_.vertices[start(dart)].z;
  return label_number(dart) == 0 ? z : image(label(label_number(dart)), z);
}

void NetRules::check_orientation() {
  for (Index t = 0; t < net_.triangles.size(); ++t) {
    if (orientation(corner(3 * t), corner(3 * t + 1), corner(3 * t + 2)) <= 0) {
      throw Refutation{triangle_name(t) + " is not strictly counterclockwise"};
    }
  }
}

Point NetRules::far_corner(Index dart) {
  const Index other = opposite(dart);
  const Index far = previous(other);
  const Index here = label_number(dart);
  const Index there = label_number(next(other));
  const Point z = corner(far);
  return here == there ? z : image(label(here), image(inverse(label(there)), z));
}

void NetRules::check_delaunay() {
  for (Index dart = 0; dart < darts(); ++dart) {
    if (opposite(dart) < dart) continue;
    const Point far = far_corner(dart);
    struct Row {
      Gaussian z;
      mpz_class square;
    };
    const auto row = [&](const Point& z) {
      const Gaussian difference = far.m * z.n - z.m * far.n;
      return Row{mpz_class(z.m * far.m) * difference, norm(difference)};
    };
    const Row p = row(corner(dart));
    const Row q = row(corner(next(dart)));
    const Row r = row(corner(previous(dart)));
    const auto area = [](const Row& u, const Row& v) { return mpz_class(u.z.re * v.z.im - u.z.im * v.z.re); };
    if (sgn(area(p, q) * r.square + area(q, r) * p.square + area(r, p) * q.square) > 0) {
      throw Refutation{edge_name(dart) + " is not Delaunay"};
    }
  }
}

Answer NetRules::circumradius_is_less(Index t, const SquaredSinh& s) {
  const std::array<Point, 3> z{corner(3 * t), corner(3 * t + 1), corner(3 * t + 2)};
  const std::array<mpz_class, 3> d{squared_difference(z[0], z[1]), squared_difference(z[1], z[2]),
                                   squared_difference(z[2], z[0])};
  const mpz_class x = d[0] * gap(z[2]);
  const mpz_class y = d[1] * gap(z[0]);
  const mpz_class w = d[2] * gap(z[1]);
  const mpz_class sum = x + y - w;
  const mpz_class discriminant = 4 * x * y - sum * sum;
  if (discriminant <= 0) return Answer::no;
  // (∗∗): 4 d₀ d₁ d₂ < sinh² · discriminant.
  return is_less(4 * d[0] * d[1] * d[2], discriminant, s);
}

Answer NetRules::half_edge_is_less(Index dart, const SquaredSinh& s) {
  const Point p = corner(dart);
  const Point q = corner(next(dart));
  return is_less(squared_difference(p, q), gap(p) * gap(q), s);
}

void NetRules::check_covering() {
  const SquaredSinh s = squared_sinh(net_.epsilon);
  for (Index t = 0; t < net_.triangles.size(); ++t) {
    // The triangles of collars need no more than a circumcircle: sinh² of its radius is less than infinity.
    const Answer less = circumradius_is_less(t, in_collar_[t] ? kInfiniteSinh : s);
    if (less == Answer::no) throw Refutation{triangle_name(t) + " has a circumradius greater than epsilon"};
    if (less == Answer::unknown) throw TooLarge{triangle_name(t) + " has a circumradius that is nearly epsilon"};
  }
}

bool NetRules::are_partners(Index u, Index v) const {
  const auto found = partners_.find(u);
  return found != partners_.end() && found->second == v;
}

void NetRules::expect_long(Index dart, const SquaredSinh& s) {
  const Answer less = half_edge_is_less(dart, s);
  if (less == Answer::yes) throw Refutation{edge_name(dart) + " is shorter than epsilon"};
  if (less == Answer::unknown) throw TooLarge{edge_name(dart) + " is nearly epsilon long"};
}

void NetRules::check_packing() {
  const SquaredSinh s = squared_sinh(net_.epsilon / 2);
  for (Index dart = 0; dart < darts(); ++dart) {
    const Index p = start(dart);
    const Index q = start(next(dart));
    if (dart < opposite(dart) && p != q && !are_partners(p, q)) expect_long(dart, s);
  }
}

void NetRules::check_thick() {
  const SquaredSinh s = squared_sinh(net_.epsilon / 2);
  for (Index dart = 0; dart < darts(); ++dart) {
    const Index p = start(dart);
    if (dart < opposite(dart) && p == start(next(dart)) && !partners_.contains(p)) expect_long(dart, s);
  }
}

}  // namespace epsnet::exact
