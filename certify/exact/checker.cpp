#include "certify/exact/checker.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "certify/exact/json.h"

namespace epsnet::exact {
namespace {

using Index = std::uint32_t;

/// A question that is too large for exact numbers.
struct TooLarge {
  std::string what;
};

/// What is wrong with the net.
struct Refutation {
  std::string what;
};

std::string number(std::size_t n) { return std::to_string(n); }

// ---- Gaussian integers, points, isometries -----------------------------------------------------------------------

struct Gaussian {
  mpz_class re;
  mpz_class im;
};

Gaussian operator+(const Gaussian& x, const Gaussian& y) { return {x.re + y.re, x.im + y.im}; }
Gaussian operator-(const Gaussian& x, const Gaussian& y) { return {x.re - y.re, x.im - y.im}; }
Gaussian operator-(const Gaussian& x) { return {-x.re, -x.im}; }
Gaussian operator*(const Gaussian& x, const Gaussian& y) {
  return {x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
}
Gaussian operator*(const mpz_class& n, const Gaussian& x) { return {n * x.re, n * x.im}; }
Gaussian conjugate(const Gaussian& x) { return {x.re, -x.im}; }
mpz_class norm(const Gaussian& x) { return x.re * x.re + x.im * x.im; }

/// The point n/m of the complex plane, m > 0.
struct Point {
  Gaussian n;
  mpz_class m;
};

Point lowest_terms(Gaussian n, mpz_class m) {
  mpz_class common = gcd(gcd(n.re, n.im), m);
  if (common > 1) {
    for (mpz_class* x : {&n.re, &n.im, &m}) *x /= common;
  }
  return {std::move(n), std::move(m)};
}

/// m² − |n|²: positive inside of the disk.
mpz_class gap(const Point& z) { return z.m * z.m - norm(z.n); }

/// |z − w|² times the squares of both denominators.
mpz_class squared_difference(const Point& z, const Point& w) { return norm(w.m * z.n - z.m * w.n); }

/// The sign of det(X(u), X(v), X(w)), X(z) = (2 Re z, 2 Im z, 1 + |z|²): 1 for counterclockwise.
int orientation(const Point& u, const Point& v, const Point& w) {
  const auto last = [](const Point& z) { return mpz_class(z.m * z.m + norm(z.n)); };
  const auto minor = [](const Point& z, const Point& other) {
    return mpz_class((z.n.re * other.n.im - z.n.im * other.n.re) * z.m * other.m);
  };
  return sgn(mpz_class(minor(u, v) * last(w) + minor(v, w) * last(u) + minor(w, u) * last(v)));
}

/// z ↦ (az + b)/(b̄z + ā), |a| > |b|; real multiples are the same.
struct Isometry {
  Gaussian a{1, 0};
  Gaussian b{0, 0};
};

Isometry compose(const Isometry& f, const Isometry& g) {
  return {f.a * g.a + f.b * conjugate(g.b), f.a * g.b + f.b * conjugate(g.a)};
}

Isometry inverse(const Isometry& f) { return {conjugate(f.a), -f.b}; }

void reduce(Isometry& f) {
  const mpz_class common = gcd(gcd(f.a.re, f.a.im), gcd(f.b.re, f.b.im));
  if (common <= 1) return;
  for (mpz_class* x : {&f.a.re, &f.a.im, &f.b.re, &f.b.im}) *x /= common;
}

bool is_identity(const Isometry& f) { return f.a.im == 0 && f.b.re == 0 && f.b.im == 0; }

/// z ↦ (z + c)/(1 + c̄z).
Isometry translation_to(const Point& c) { return {{c.m, 0}, c.n}; }

std::size_t bits(const mpz_class& n) { return mpz_sizeinbase(n.get_mpz_t(), 2); }
std::size_t bits(const Gaussian& x) { return bits(x.re) + bits(x.im); }
std::size_t bits(const Isometry& f) { return bits(f.a) + bits(f.b); }
std::size_t bits(const Point& z) { return bits(z.n) + bits(z.m); }

// ---- The document ------------------------------------------------------------------------------------------------

struct Label {
  Index from;
  Index to;
  std::vector<Index> word;
};

struct Vertex {
  Index chart;
  Point z;
};

struct Triangle {
  std::array<Index, 3> vertex;
  std::array<Index, 3> opposite;
  std::array<Index, 3> label;  ///< By corner; corner 0 has the identity.
};

struct Net {
  std::vector<std::vector<Point>> tiles;
  std::vector<std::array<Index, 4>> gluing;
  mpq_class epsilon;
  std::vector<std::pair<Index, Point>> charts;
  std::vector<Label> labels;
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
};

/// The member of an object, if it has one of this name.
const Json* find(const Json& object, const char* name) {
  for (const Json::Member& member : object.members) {
    if (member.name == name) return &member.value;
  }
  return nullptr;
}

const Json& member(const Json& object, const char* name) {
  const Json* found = find(object, name);
  if (found == nullptr) throw Malformed(std::string("no member \"") + name + '"');
  return *found;
}

void expect_members(const Json& value, std::initializer_list<std::string_view> names) {
  if (value.kind != Json::Kind::object) throw Malformed("expected an object");
  for (const Json::Member& found : value.members) {
    if (std::find(names.begin(), names.end(), found.name) == names.end()) {
      throw Malformed("unknown member \"" + found.name.substr(0, 40) + '"');
    }
  }
}

const std::vector<Json>& array(const Json& value, const char* what) {
  if (value.kind != Json::Kind::array) throw Malformed(std::string(what) + ": expected an array");
  return value.elements;
}

const std::vector<Json>& tuple(const Json& value, std::size_t size, const char* what) {
  const std::vector<Json>& elements = array(value, what);
  if (elements.size() != size) throw Malformed(std::string(what) + ": expected " + number(size) + " elements");
  return elements;
}

bool is_text(const Json& value, std::string_view text) {
  return value.kind == Json::Kind::string && value.text == text;
}

void expect_text(const Json& value, std::string_view text, const char* what) {
  if (!is_text(value, text)) throw Malformed("unexpected value for " + std::string(what));
}

Point read_rational_point(const Json& x, const Json& y) {
  const mpq_class re = to_rational(x);
  const mpq_class im = to_rational(y);
  const mpz_class m = lcm(re.get_den(), im.get_den());
  return {{re.get_num() * (m / re.get_den()), im.get_num() * (m / im.get_den())}, m};
}

Point read_binary_point(const Json& x, const Json& y) {
  const Binary64 re = to_binary64(x);
  const Binary64 im = to_binary64(y);
  const long shift = std::max({0L, -re.exponent, -im.exponent});
  const auto scaled = [&](const Binary64& n) {
    return mpz_class(n.mantissa << static_cast<mp_bitcnt_t>(n.exponent + shift));
  };
  return lowest_terms({scaled(re), scaled(im)}, mpz_class(1) << static_cast<mp_bitcnt_t>(shift));
}

Net read(const Json& root) {
  expect_members(root, {"format", "version", "surface", "epsilon", "charts", "labels", "vertices", "triangles"});
  if (to_index(member(root, "version")) != 1) throw Malformed("the version is not 1");
  Net net;
  const Json& surface = member(root, "surface");
  expect_members(surface, {"kind", "tiles", "gluing", "about"});
  expect_text(member(surface, "kind"), "tiles", "the kind of the surface");
  if (const Json* about = find(surface, "about");
      about != nullptr && (about->kind != Json::Kind::string || about->text.size() > (std::size_t{1} << 20))) {
    throw Malformed("about: expected a string of at most 1 MiB");
  }
  for (const Json& row : array(member(surface, "tiles"), "tiles")) {
    net.tiles.emplace_back();
    for (const Json& vertex : array(row, "a tile")) {
      const auto& pair = tuple(vertex, 2, "a vertex of a tile");
      net.tiles.back().push_back(read_rational_point(pair[0], pair[1]));
    }
  }
  for (const Json& row : array(member(surface, "gluing"), "gluing")) {
    const auto& four = tuple(row, 4, "gluing");
    net.gluing.push_back({to_index(four[0]), to_index(four[1]), to_index(four[2]), to_index(four[3])});
  }
  net.epsilon = to_decimal(member(root, "epsilon"));
  for (const Json& row : array(member(root, "charts"), "charts")) {
    const auto& three = tuple(row, 3, "a chart");
    net.charts.emplace_back(to_index(three[0]), read_rational_point(three[1], three[2]));
  }
  std::size_t letters = 0;
  for (const Json& row : array(member(root, "labels"), "labels")) {
    const auto& three = tuple(row, 3, "a label");
    Label label{to_index(three[0]), to_index(three[1]), {}};
    for (const Json& side : array(three[2], "a word")) label.word.push_back(to_index(side));
    letters += label.word.size();
    if (label.word.size() > 1'000'000 || letters > 10'000'000) throw Malformed("too many letters");
    net.labels.push_back(std::move(label));
  }
  for (const Json& row : array(member(root, "vertices"), "vertices")) {
    const auto& three = tuple(row, 3, "a vertex");
    net.vertices.push_back({to_index(three[0]), read_binary_point(three[1], three[2])});
  }
  for (const Json& row : array(member(root, "triangles"), "triangles")) {
    const auto& n = tuple(row, 8, "a triangle");
    const auto at = [&](std::size_t i) { return to_index(n[i]); };
    net.triangles.push_back({{at(0), at(1), at(2)}, {at(3), at(4), at(5)}, {0, at(6), at(7)}});
  }
  return net;
}

// ---- The rules ---------------------------------------------------------------------------------------------------

/// Bits of one number that is brought to lowest terms, and of all of them, with some more for each triangle: half a
/// minute.
constexpr std::size_t kMaxBits = std::size_t{1} << 22;
constexpr std::size_t kMaxBitsInAll = std::size_t{1} << 26;
constexpr std::size_t kBitsOfATriangle = std::size_t{1} << 13;
/// Bits of the directions around one corner, which are only multiplied.
constexpr std::size_t kMaxBitsOfDirections = std::size_t{1} << 32;

Index next(Index dart) { return dart % 3 == 2 ? dart - 2 : dart + 1; }
Index previous(Index dart) { return dart % 3 == 0 ? dart + 2 : dart - 1; }

class Checker {
 public:
  explicit Checker(const Net& net) : net_(net), bits_left_(kMaxBitsInAll + kBitsOfATriangle * net.triangles.size()) {}

  /// Throws Malformed.
  void check_structure() {
    if (net_.epsilon <= 0) throw Malformed("epsilon is not positive");
    number_sides();
    for (const auto& [tile, centre] : net_.charts) {
      expect_less(tile, net_.tiles.size(), "tile");
      if (gap(centre) <= 0) throw Malformed("the centre of a chart is not in the disk");
    }
    for (const Label& label : net_.labels) {
      expect_less(label.from, net_.charts.size(), "chart");
      expect_less(label.to, net_.charts.size(), "chart");
      Index tile = net_.charts[label.from].first;
      for (const Index side : label.word) {
        expect_less(side, tile_of_.size(), "side");
        if (tile_of_[side] != tile) throw Malformed("a word is no path");
        tile = tile_of_[partner_[side]];
      }
      if (tile != net_.charts[label.to].first) throw Malformed("a word ends in a wrong tile");
    }
    for (const Vertex& vertex : net_.vertices) {
      expect_less(vertex.chart, net_.charts.size(), "chart");
      if (gap(vertex.z) <= 0) throw Malformed("a vertex is not in the disk");
    }
    for (const Triangle& triangle : net_.triangles) check_triangle_structure(triangle);
  }

  /// The rules, in the order of docs/proof.md. Each throws Refutation or TooLarge.
  Result run() {
    using Rule = void (Checker::*)();
    const std::array<std::pair<const char*, Rule>, 7> rules{{{"surface", &Checker::check_surface},
                                                             {"map", &Checker::check_map},
                                                             {"gluing", &Checker::check_gluing},
                                                             {"orientation", &Checker::check_orientation},
                                                             {"delaunay", &Checker::check_delaunay},
                                                             {"covering", &Checker::check_covering},
                                                             {"packing", &Checker::check_packing}}};
    for (const auto& [name, rule] : rules) {
      try {
        (this->*rule)();
      } catch (const Refutation& refutation) {
        return {Verdict::refuted, name, refutation.what};
      } catch (const TooLarge& question) {
        return {Verdict::undecided, name, question.what};
      }
    }
    return {Verdict::verified, "", ""};
  }

 private:
  // Exact numbers, as long as they are not too large.

  void spend(std::size_t bits) {
    if (bits > kMaxBits || bits > bits_left_) throw TooLarge{"its exact numbers are too large"};
    bits_left_ -= bits;
  }

  Point image(const Isometry& f, const Point& z) {
    spend(bits(f) + bits(z));
    const Gaussian n = f.a * z.n + z.m * f.b;
    const Gaussian d = conjugate(f.b) * z.n + z.m * conjugate(f.a);
    return lowest_terms(n * conjugate(d), norm(d));
  }

  /// path.back() ∘ … ∘ path.front(), halves first, so that most products are of small numbers.
  Isometry product(std::span<const Isometry* const> path) {
    if (path.empty()) return {};
    if (path.size() == 1) return *path[0];
    const Isometry first = product(path.first(path.size() / 2));
    Isometry result = compose(product(path.subspan(path.size() / 2)), first);
    spend(bits(result));
    reduce(result);
    return result;
  }

  // Structure.

  static void expect_less(std::size_t index, std::size_t size, const char* what) {
    if (index >= size) throw Malformed(std::string(what) + ' ' + number(index) + " does not exist");
  }

  /// Sides are numbered through all tiles.
  void number_sides() {
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

  void check_triangle_structure(const Triangle& triangle) const {
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

  // Darts.

  [[nodiscard]] std::size_t darts() const { return 3 * net_.triangles.size(); }
  [[nodiscard]] Index opposite(Index dart) const { return net_.triangles[dart / 3].opposite[dart % 3]; }
  [[nodiscard]] Index start(Index dart) const { return net_.triangles[dart / 3].vertex[dart % 3]; }
  [[nodiscard]] Index label_number(Index dart) const { return net_.triangles[dart / 3].label[dart % 3]; }

  [[nodiscard]] std::string triangle_name(std::size_t t) const {
    const auto& v = net_.triangles[t].vertex;
    return "triangle " + number(t) + " (vertices " + number(v[0]) + ", " + number(v[1]) + ", " + number(v[2]) + ")";
  }
  [[nodiscard]] std::string edge_name(Index dart) const {
    return "the edge of dart " + number(dart) + " from vertex " + number(start(dart)) + " to vertex " +
           number(start(next(dart)));
  }

  /// each_neighbour(i, visit) calls visit for every neighbour of number i.
  template <class EachNeighbour>
  static void expect_connected(std::size_t count, const char* what, const EachNeighbour& each_neighbour) {
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

  // Section 2: the surface.

  /// The vertex of its tile where a side starts.
  [[nodiscard]] Index vertex_of(Index s) const { return s - first_side_[tile_of_[s]]; }
  [[nodiscard]] const Point& side_start(Index s) const { return net_.tiles[tile_of_[s]][vertex_of(s)]; }
  [[nodiscard]] Index side_after(Index s) const {
    return vertex_of(s) + 1 < net_.tiles[tile_of_[s]].size() ? s + 1 : s - vertex_of(s);
  }
  [[nodiscard]] Index side_before(Index s) const {
    return vertex_of(s) > 0 ? s - 1 : s + static_cast<Index>(net_.tiles[tile_of_[s]].size()) - 1;
  }
  [[nodiscard]] const Point& side_end(Index s) const { return side_start(side_after(s)); }
  [[nodiscard]] std::string side_name(Index s) const {
    return "side " + number(vertex_of(s)) + " of tile " + number(tile_of_[s]);
  }

  void check_surface() {
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

  /// (a): in the disk, a left turn at every corner, and seen from vertex 0 in counterclockwise order.
  void check_tile(std::size_t t) const {
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

  /// (c), and the crossings.
  void check_lengths() {
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

  /// p ↦ q′ and q ↦ p′: p to 0, a turn, 0 to q′.
  Isometry crossing(const Point& p, const Point& q, const Point& p_other, const Point& q_other) {
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

  /// (f) and (g): around every cycle of corners the crossings multiply to 1 and the angles add up to one full turn. The
  /// number of cycles.
  std::size_t check_corners() {
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

  /// Whether the argument in [0, 2π) is at least π. Any half-plane would do to count full turns: the walk ends in the
  /// direction in which it starts.
  static bool is_below(const Gaussian& z) { return sgn(z.im) < 0 || (sgn(z.im) == 0 && sgn(z.re) < 0); }

  /// A number whose argument, between 0 and π, is the interior angle where the side starts.
  [[nodiscard]] Gaussian interior_angle(Index s) {
    const Isometry to_origin = inverse(translation_to(side_start(s)));
    const Point from = image(to_origin, side_end(s));
    const Point to = image(to_origin, side_start(side_before(s)));
    return to.n * conjugate(from.n);
  }

  // Section 3: the abstract surface.

  void check_map() {
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
    const auto euler = static_cast<std::int64_t>(net_.vertices.size() + net_.triangles.size()) -
                       static_cast<std::int64_t>(darts() / 2);
    if (euler != euler_) throw Refutation{"V - E + F = " + std::to_string(euler) + ", not that of the surface"};
  }

  // Section 4: gluing and orientation.

  /// The value of a label number, F_to⁻¹ ∘ word ∘ F_from.
  const Isometry& label(Index number_of_label) {
    const auto [found, is_new] = labels_.try_emplace(number_of_label);
    if (!is_new || number_of_label == 0) return found->second;
    const Label& l = net_.labels[number_of_label - 1];
    const auto [from, to] =
        std::pair(translation_to(net_.charts[l.from].second), translation_to(net_.charts[l.to].second));
    std::vector<const Isometry*> path{&from};
    for (const Index side : l.word) path.push_back(&crossings_[side]);
    const Isometry back = inverse(to);
    path.push_back(&back);
    return found->second = product(path);
  }

  /// (∗): L_a L_b⁻¹ = L_c L_d⁻¹ across every edge, each equation once.
  void check_gluing() {
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

  /// The corner where the dart starts, in the chart of its triangle.
  Point corner(Index dart) {
    const Point& z = net_.vertices[start(dart)].z;
    return label_number(dart) == 0 ? z : image(label(label_number(dart)), z);
  }

  void check_orientation() {
    for (Index t = 0; t < net_.triangles.size(); ++t) {
      if (orientation(corner(3 * t), corner(3 * t + 1), corner(3 * t + 2)) <= 0) {
        throw Refutation{triangle_name(t) + " is not strictly counterclockwise"};
      }
    }
  }

  // Section 5: Delaunay.

  /// The corner of the neighbour across the dart that is not on it, in the chart of the dart's triangle.
  Point far_corner(Index dart) {
    const Index other = opposite(dart);
    const Index far = previous(other);
    const Index here = label_number(dart);
    const Index there = label_number(next(other));
    const Point z = corner(far);
    return here == there ? z : image(label(here), image(inverse(label(there)), z));
  }

  /// Lemma 3.1: the sign of the determinant with the rows (x, y, |z|², 1) of the edge's two ends, the third corner of
  /// the triangle and the far corner; the last one is taken for the origin.
  void check_delaunay() {
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

  // Sections 6 and 7: covering and packing.

  /// Two rational numbers below and above sinh²x, n/2^k, (cosh 2x − 1)/2 = Σ 2^(2i−1) x^(2i)/(2i)!.
  struct Bounds {
    mpz_class lower;
    mpz_class upper;
    mp_bitcnt_t k;
  };

  static Bounds squared_sinh(const mpq_class& x) {
    if (x > 1000) throw TooLarge{"epsilon is greater than 1000"};
    // So many bits that the first term, x², has 256.
    const auto size = static_cast<long>(bits(x.get_den())) - static_cast<long>(bits(x.get_num()));
    const auto k = static_cast<mp_bitcnt_t>(256 + 2 * std::max(size, 0L));
    if (k > 100'000) throw TooLarge{"epsilon is too small"};
    const mpz_class scale = mpz_class(1) << k;
    const mpz_class low = x.get_num() * x.get_num() * scale / (x.get_den() * x.get_den());
    const mpz_class high = low + 1;
    // Terms t_1 = x² and t_(i+1) = t_i 4x²/((2i + 1)(2i + 2)), rounded down and up; quotients of integers are rounded
    // down.
    mpz_class lower = low, upper = high, t = low, u = high;
    for (unsigned long i = 1;; ++i) {
      const mpz_class divisor = mpz_class((2 * i + 1) * (2 * i + 2)) << k;
      t = t * low * 4 / divisor;
      u = u * high * 4 / divisor + 1;
      lower += t;
      upper += u;
      // From here on each term is less than half of the one before: the rest is less than the last one.
      if (t == 0 && high * 8 < divisor) break;
    }
    return {lower, upper + u, k};
  }

  void check_covering() {
    const Bounds s = squared_sinh(net_.epsilon);
    for (Index t = 0; t < net_.triangles.size(); ++t) {
      const std::array<Point, 3> z{corner(3 * t), corner(3 * t + 1), corner(3 * t + 2)};
      const std::array<mpz_class, 3> d{squared_difference(z[0], z[1]), squared_difference(z[1], z[2]),
                                       squared_difference(z[2], z[0])};
      const mpz_class x = d[0] * gap(z[2]);
      const mpz_class y = d[1] * gap(z[0]);
      const mpz_class w = d[2] * gap(z[1]);
      const mpz_class sum = x + y - w;
      const mpz_class discriminant = 4 * x * y - sum * sum;
      // (∗∗): 4 d₀ d₁ d₂ < sinh²ε · discriminant.
      const mpz_class product = (4 * d[0] * d[1] * d[2]) << s.k;
      if (product < s.lower * discriminant) continue;
      // The discriminant is positive after rule delaunay (docs/proof.md, Lemma 4).
      if (discriminant <= 0 || product >= s.upper * discriminant) {
        throw Refutation{triangle_name(t) + " has a circumradius greater than epsilon"};
      }
      throw TooLarge{triangle_name(t) + " has a circumradius that is nearly epsilon"};
    }
  }

  void check_packing() {
    const Bounds s = squared_sinh(net_.epsilon / 2);
    for (Index dart = 0; dart < darts(); ++dart) {
      if (opposite(dart) < dart || start(dart) == start(next(dart))) continue;
      const Point p = corner(dart);
      const Point q = corner(next(dart));
      const mpz_class length = squared_difference(p, q) << s.k;
      const mpz_class gaps = gap(p) * gap(q);
      if (length >= s.upper * gaps) continue;
      if (length < s.lower * gaps) throw Refutation{edge_name(dart) + " is shorter than epsilon"};
      throw TooLarge{edge_name(dart) + " is nearly epsilon long"};
    }
  }

  const Net& net_;
  std::vector<Index> first_side_;  ///< By tile.
  std::vector<Index> tile_of_;     ///< By side.
  std::vector<Index> partner_;     ///< By side.
  std::vector<Isometry> crossings_;
  std::int64_t euler_ = 0;
  std::map<Index, Isometry> labels_;
  std::size_t bits_left_;
};

/// Whether the file is one of those that this checker leaves to the other.
std::optional<std::string> not_for_this_checker(const Json& root) {
  if (root.kind != Json::Kind::object) throw Malformed("expected an object");
  const Json& format = member(root, "format");
  for (const std::string kind : {"geodesics", "distance", "cover", "eigenvalues"})
    if (is_text(format, "epsnet-" + kind)) return "a " + kind + " file";
  expect_text(format, "epsnet-net", "the format");
  if (find(root, "collars") != nullptr) return "a pseudo net";
  const Json* surface = find(root, "surface");
  const Json* kind = surface == nullptr ? nullptr : find(*surface, "kind");
  if (kind != nullptr && is_text(*kind, "regular")) return "a regular surface";
  if (kind != nullptr && is_text(*kind, "map")) return "a map of regular tiles";
  return std::nullopt;
}

}  // namespace

Result check(std::string_view text) {
  if (text.starts_with("\211EPSNET\n")) return {Verdict::undecided, "document", "not for this checker: a compact file"};
  try {
    const Json root = parse_json(text);
    if (const auto reason = not_for_this_checker(root)) {
      return {Verdict::undecided, "document", "not for this checker: " + *reason};
    }
    const Net net = read(root);
    Checker checker(net);
    checker.check_structure();
    return checker.run();
  } catch (const Malformed& error) {
    return {Verdict::malformed, "", error.what()};
  }
}

}  // namespace epsnet::exact
