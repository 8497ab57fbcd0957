#include "netgen/exchange/anchor_search.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "netgen/base/disjoint_sets.h"

namespace epsnet {

namespace {

constexpr unsigned kMostBits = 20'000;
constexpr unsigned kMostPrimeBits = 4096;
constexpr std::uint32_t kSmallPrimes = 1U << 16;
/// A round takes a composite number for a prime with a probability below 1/4; the result is checked in any case.
constexpr int kPrimalityRounds = 32;
constexpr std::uint32_t kMostBases = 200;

bool is_prime(const Integer& n) { return mpz_probab_prime_p(n.backend().data(), kPrimalityRounds) != 0; }

/// Returns a Gaussian integer of norm p, for a prime p that is 1 modulo 4; nullopt if p turns out not to be prime.
std::optional<Complex<Integer>> prime_root(const Integer& p) {
  // Half of all bases give a square root of −1.
  for (std::uint32_t base = 2; base < kMostBases; ++base) {
    const Integer x = powm(Integer(base), Integer((p - 1) / 4), p);
    if ((x * x + 1) % p != 0) continue;
    const Complex<Integer> root = gaussian_gcd({p, 0}, {x, 1});
    if (norm(root) == p) return root;
  }
  return std::nullopt;
}

class Search {
 public:
  explicit Search(const Integer& n) : rest_(n) {}

  TwoSquares run(const std::vector<Complex<Integer>>& hints) {
    while (rest_ % 2 == 0) divide_by(2, {1, 1});
    for (const Complex<Integer>& hint : hints) use(hint);
    take_square();
    for (std::uint32_t p = 3; p < kSmallPrimes && rest_ != 1; p += 2) {
      // Composite p no longer divide the rest, as their prime factors have been divided out.
      if (mpz_divisible_ui_p(rest_.backend().data(), p) != 0 && !take_small_prime(p)) return {{}, Integer(p)};
    }
    take_square();
    if (rest_ == 1) return {root_, {}};
    if (rest_ % 4 == 3) return {{}, rest_};
    if (msb(rest_) < kMostPrimeBits && is_prime(rest_)) {
      if (const auto root = prime_root(rest_)) return {*root * root_, {}};
    }
    return {};
  }

 private:
  void divide_by(const Integer& divisor, const Complex<Integer>& root) {
    rest_ /= divisor;
    root_ = root_ * root;
  }

  /// Splits off factors that the rest has in common with a hint. A Gaussian divisor g of the rest without a rational
  /// factor is coprime to its conjugate, which also divides the rest; so its norm divides the rest. (A common factor
  /// would divide 2x and 2y, and the rest is odd.)
  void use(const Complex<Integer>& hint) {
    if (hint == Complex<Integer>{0, 0}) return;
    for (;;) {
      Complex<Integer> g = gaussian_gcd({rest_, 0}, hint);
      const Integer rational = gcd(g.x, g.y);
      g = {g.x / rational, g.y / rational};
      const Integer divisor = norm(g);
      if (divisor == 1) return;
      divide_by(divisor, g);
    }
  }

  void take_square() {
    const Integer root = sqrt(rest_);
    if (root * root == rest_) divide_by(rest_, {root, 0});
  }

  /// Divides the rest by p as often as possible; false if p is 3 modulo 4 and divides it an odd number of times.
  bool take_small_prime(std::uint32_t p) {
    const std::optional<Complex<Integer>> root = p % 4 == 1 ? prime_root(p) : std::nullopt;
    while (rest_ % p == 0) {
      if (root) {
        divide_by(p, *root);
      } else if (rest_ % (std::uint64_t{p} * p) == 0) {
        divide_by(std::uint64_t{p} * p, {p, 0});
      } else {
        return false;
      }
    }
    return true;
  }

  Integer rest_;
  Complex<Integer> root_{1, 0};
};

}  // namespace

TwoSquares two_squares(const Integer& n, const std::vector<Complex<Integer>>& hints) {
  if (n <= 0 || msb(n) >= kMostBits) return {};
  TwoSquares result = Search(n).run(hints);
  if (result.root && norm(*result.root) != n) result.root.reset();
  return result;
}

namespace {

constexpr std::uint32_t kNoTriangle = ~std::uint32_t{0};
/// Any corner of any triangle can be the origin; this many triangles are tried, as some have simpler numbers.
constexpr std::size_t kMostTriangles = 16;
// Limits that no triangulation of a surface reaches; numbers beyond them would take minutes.
constexpr std::size_t kMostLoopBits = std::size_t{1} << 22;
constexpr std::size_t kMostBitsOfAllPaths = std::size_t{1} << 30;
/// Euclid's algorithm takes quadratic time.
constexpr std::size_t kMostStarBits = std::size_t{1} << 13;

using Gaussian = Complex<Integer>;

/// A point u/v of the complex plane with infinity.
struct Projective {
  Gaussian u;
  Gaussian v;
};

/// 0 if and only if the points are equal.
Gaussian bracket(const Projective& p, const Projective& q) { return p.u * q.v - p.v * q.u; }

Projective combination(const Gaussian& s, const Projective& p, const Gaussian& t, const Projective& q) {
  return {s * p.u + t * q.u, s * p.v + t * q.v};
}

/// A Möbius map of the plane up to a factor, by its columns: the images of infinity and 0, scaled.
struct Moebius {
  Projective infinity{{1, 0}, {0, 0}};
  Projective zero{{0, 0}, {1, 0}};

  Projective operator()(const Projective& p) const { return combination(p.u, infinity, p.v, zero); }
  [[nodiscard]] Gaussian determinant() const { return bracket(infinity, zero); }
};

using epsnet::bits;
std::size_t bits(const Gaussian& z) { return bits(z.x) + bits(z.y); }
std::size_t bits(const Moebius& m) { return bits(m.infinity.u) + bits(m.infinity.v) + bits(m.zero.u) + bits(m.zero.v); }

/// Returns the map without a common integer factor.
Moebius reduced(Moebius m) {
  Integer content = 0;
  const auto visit = [&](const auto& action) {
    for (Projective* p : {&m.infinity, &m.zero}) {
      for (Gaussian* z : {&p->u, &p->v}) {
        action(z->x);
        action(z->y);
      }
    }
  };
  visit([&](Integer& x) { content = gcd(content, x); });
  if (content > 1) visit([&](Integer& x) { x /= content; });
  return m;
}

Moebius operator*(const Moebius& f, const Moebius& g) { return {f(g.infinity), f(g.zero)}; }
Moebius inverse(const Moebius& m) { return {{m.zero.v, -m.infinity.v}, {-m.zero.u, m.infinity.u}}; }

/// The map that takes infinity, 0 and 1 to three different points.
Moebius map_to(const std::array<Projective, 3>& points) {
  const auto& [p, q, r] = points;
  const Gaussian s = bracket(r, q);
  const Gaussian t = bracket(p, r);
  return reduced(Moebius{{s * p.u, s * p.v}, {t * q.u, t * q.v}});
}

/// Returns infinity, 0 and 1, rotated so that number i comes first.
std::array<Projective, 3> frame_from(std::uint32_t i) {
  std::array<Projective, 3> result{{{{1, 0}, {0, 0}}, {{0, 0}, {1, 0}}, {{1, 0}, {1, 0}}}};
  std::rotate(result.begin(), result.begin() + i, result.end());
  return result;
}

/// A Hermitian form a|u|² + 2 Re(b ū v) + c|v|², up to a positive factor.
struct Hermitian {
  Integer a;
  Gaussian b;
  Integer c;

  /// p*Hq.
  [[nodiscard]] Gaussian operator()(const Projective& p, const Projective& q) const {
    const Gaussian first = a * q.u + b * q.v;
    const Gaussian second = conj(b) * q.u + c * q.v;
    return conj(p.u) * first + conj(p.v) * second;
  }
  /// p*Hp.
  [[nodiscard]] Integer operator()(const Projective& p) const { return (*this)(p, p).x; }
};

Hermitian reduced(Hermitian h) {
  const Integer content = gcd(gcd(h.a, h.c), gcd(h.b.x, h.b.y));
  if (content > 1) h = {h.a / content, {h.b.x / content, h.b.y / content}, h.c / content};
  return h;
}

/// Returns m*Hm: the form in the coordinates from which m leads.
Hermitian pulled_back(const Hermitian& h, const Moebius& m) {
  return reduced(Hermitian{h(m.infinity), h(m.infinity, m.zero), h(m.zero)});
}

/// Rows of linear equations for four rational unknowns, in echelon form.
class Equations {
 public:
  using Row = std::array<Rational, 4>;

  void add(Row row) {
    for (const auto& [pivot, known] : rows_) {
      if (row[pivot] != 0) subtract(row, Rational(row[pivot] / known[pivot]), known);
    }
    const auto pivot = static_cast<std::size_t>(
        std::find_if(row.begin(), row.end(), [](const Rational& x) { return x != 0; }) - row.begin());
    if (pivot == row.size()) return;
    for (auto& [other, known] : rows_) {
      if (known[pivot] != 0) subtract(known, Rational(known[pivot] / row[pivot]), row);
    }
    rows_.emplace_back(pivot, std::move(row));
  }

  [[nodiscard]] std::size_t rank() const { return rows_.size(); }

  /// Returns a solution other than 0. Requires: rank 3.
  [[nodiscard]] Row solution() const {
    std::array<bool, 4> is_pivot{};
    for (const auto& [pivot, row] : rows_) is_pivot[pivot] = true;
    const auto free = static_cast<std::size_t>(std::find(is_pivot.begin(), is_pivot.end(), false) - is_pivot.begin());
    Row result{};
    result[free] = 1;
    for (const auto& [pivot, row] : rows_) result[pivot] = -row[free] / row[pivot];
    return result;
  }

 private:
  static void subtract(Row& from, const Rational& factor, const Row& row) {
    for (std::size_t i = 0; i < from.size(); ++i) from[i] -= factor * row[i];
  }

  std::vector<std::pair<std::size_t, Row>> rows_;
};

/// n/d in lowest terms.
GaussianFraction in_lowest_terms(const Complex<Rational>& z) {
  const ScaledPoint point = scaled(z);
  const Gaussian denominator{point.m, 0};
  const Gaussian common = gaussian_gcd(denominator, point.n);
  return {nearest(point.n, common), nearest(denominator, common)};
}

/// Each triangle has a frame: the coordinates of the plane in which its darts start at infinity, 0 and 1.
class AnchorSearch {
 public:
  AnchorSearch(const TriangulationStream& stream, std::string_view name)
      : stream_(stream),
        name_(name),
        place_(std::size_t{3} * count()),
        edge_(std::size_t{3} * count()),
        parent_(count(), kNoTriangle) {
    for (std::uint32_t t = 0; t < count(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) place_[stream.triangles[t][i]] = {t, i};
    }
    for (std::uint32_t e = 0; e < stream.edges.size(); ++e) {
      edge_[stream.edges[e].dart] = edge_[stream.edges[e].opposite] = e;
    }
  }

  TriangulationStream::Anchor anchor() {
    grow_tree();
    std::vector<Hermitian> forms{invariant_form()};
    const std::size_t tries = std::min(kMostTriangles, order_.size());
    for (std::size_t k = 0; k < tries; ++k) {
      const std::uint32_t t = order_[k];
      if (k > 0) {
        const auto parent = std::find(order_.begin(), order_.end(), place_[parent_[t]].triangle) - order_.begin();
        forms.push_back(pulled_back(forms[static_cast<std::size_t>(parent)], transition(parent_[t])));
      }
      for (std::uint32_t i = 0; i < 3; ++i) {
        if (const auto found = anchor_at(stream_.triangles[t][i], forms.back())) return *found;
      }
    }
    fail_to_find();
  }

 private:
  struct Place {
    std::uint32_t triangle = kNoTriangle;
    std::uint32_t side = 0;
  };

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(stream_.triangles.size()); }
  [[nodiscard]] std::uint32_t opposite(std::uint32_t dart) const {
    const TriangulationStream::Edge& edge = stream_.edges[edge_[dart]];
    return edge.dart == dart ? edge.opposite : edge.dart;
  }
  /// Returns the dart k steps after this one, counterclockwise in its triangle.
  [[nodiscard]] std::uint32_t turned(std::uint32_t dart, std::uint32_t k) const {
    const auto [triangle, side] = place_[dart];
    return stream_.triangles[triangle][(side + k) % 3];
  }

  /// Grows a tree of triangles, breadth first from triangle 0; `parent_` has the dart across which each was reached.
  void grow_tree() {
    order_.push_back(0);
    for (std::size_t k = 0; k < order_.size(); ++k) {
      for (const std::uint32_t d : stream_.triangles[order_[k]]) {
        const std::uint32_t t = place_[opposite(d)].triangle;
        if (t == 0 || parent_[t] != kNoTriangle) continue;
        parent_[t] = d;
        order_.push_back(t);
      }
    }
    if (order_.size() == count()) return;
    std::uint32_t t = 1;
    while (parent_[t] != kNoTriangle) ++t;
    fail("the surface is not connected: no path of edges leads from triangle 0 to triangle " + std::to_string(t));
  }

  /// Returns a dart of each of the 2g edges that neither the tree of triangles crosses nor a tree of edges contains.
  /// The closed paths that follow the tree of triangles and cross one of these edges generate the group.
  [[nodiscard]] std::vector<std::uint32_t> generators() const {
    std::vector<bool> is_crossed(stream_.edges.size());
    for (const std::uint32_t d : parent_) {
      if (d != kNoTriangle) is_crossed[edge_[d]] = true;
    }
    // The sets of darts with the same start.
    DisjointSets vertices(std::size_t{3} * count());
    for (std::uint32_t d = 0; d < vertices.size(); ++d) vertices.join(d, turned(opposite(d), 1));
    std::vector<std::uint32_t> result;
    for (std::uint32_t e = 0; e < stream_.edges.size(); ++e) {
      if (is_crossed[e]) continue;
      const auto& edge = stream_.edges[e];
      if (vertices.find(edge.dart) == vertices.find(edge.opposite)) {
        result.push_back(edge.dart);
      } else {
        vertices.join(edge.dart, edge.opposite);
      }
    }
    // The shortest paths come first, as their isometries have the smallest numbers.
    std::vector<std::uint32_t> depth(count());
    for (const std::uint32_t t : order_) {
      if (t != 0) depth[t] = depth[place_[parent_[t]].triangle] + 1;
    }
    const auto length = [&](std::uint32_t d) {
      return depth[place_[d].triangle] + depth[place_[opposite(d)].triangle];
    };
    std::stable_sort(result.begin(), result.end(),
                     [&](std::uint32_t d, std::uint32_t e) { return length(d) < length(e); });
    return result;
  }

  /// Returns the map from the frame of the triangle beyond a dart to the frame of the dart's triangle.
  [[nodiscard]] Moebius transition(std::uint32_t dart) const {
    const auto& [a, b, c] = frame_from(place_[dart].side);
    const ScaledPoint ratio = scaled(stream_.edges[edge_[dart]].cross_ratio);
    // [a, d, b, c] = R is R [c,a][b,d] = [c,d][b,a] with brackets of homogeneous coordinates, linear in d.
    const Projective d = combination(ratio.n * bracket(c, a), b, -(ratio.m * bracket(b, a)), c);
    std::array<Projective, 3> points;
    const std::uint32_t other = place_[opposite(dart)].side;
    points[other] = b;
    points[(other + 1) % 3] = a;
    points[(other + 2) % 3] = d;
    Moebius result = map_to(points);
    if (result.determinant() == Gaussian{0, 0}) {
      fail("the edge of darts " + std::to_string(dart) + " and " + std::to_string(opposite(dart)) +
           " has a cross-ratio that makes the third vertex of a triangle one of its ends");
    }
    return result;
  }

  /// Returns the map from the frame of a triangle to that of triangle 0, along the tree.
  [[nodiscard]] Moebius frame(std::uint32_t triangle, std::size_t& work) const {
    Moebius result;
    for (std::uint32_t t = triangle; t != 0; t = place_[parent_[t]].triangle) {
      result = transition(parent_[t]) * result;
      work += bits(result);
      if (work > kMostBitsOfAllPaths) fail_to_find();
    }
    return reduced(result);
  }

  [[nodiscard]] Hermitian invariant_form() const {
    Equations equations;
    std::size_t work = 0;
    for (const std::uint32_t d : generators()) {
      const Moebius there = frame(place_[d].triangle, work);
      const Moebius beyond = frame(place_[opposite(d)].triangle, work);
      const Moebius loop = there * transition(d) * inverse(beyond);
      if (bits(loop) > kMostLoopBits) fail_to_find();
      add_equations(reduced(loop), equations);
      if (equations.rank() >= 3) break;
    }
    if (equations.rank() != 3) fail_without_circle();
    const Equations::Row x = equations.solution();
    const Integer m = lcm(lcm(Integer(denominator(x[0])), Integer(denominator(x[1]))),
                          lcm(Integer(denominator(x[2])), Integer(denominator(x[3]))));
    const auto integer = [&](const Rational& q) { return Integer(numerator(q) * (m / denominator(q))); };
    return reduced(Hermitian{integer(x[0]), {integer(x[1]), integer(x[2])}, integer(x[3])});
  }

  /// g*Hg = |det g|H, in the unknowns a, Re b, Im b, c of H.
  void add_equations(const Moebius& g, Equations& equations) const {
    const Integer square = norm(g.determinant());
    const Integer scale = sqrt(square);
    if (scale * scale != square) fail_without_circle();
    const std::array<Hermitian, 4> basis{{{1, {0, 0}, 0}, {0, {1, 0}, 0}, {0, {0, 1}, 0}, {0, {0, 0}, 1}}};
    std::array<Equations::Row, 4> rows;
    for (std::size_t k = 0; k < 4; ++k) {
      const Hermitian& h = basis[k];
      const Gaussian b = h(g.infinity, g.zero) - scale * h.b;
      rows[0][k] = h(g.infinity) - scale * h.a;
      rows[1][k] = b.x;
      rows[2][k] = b.y;
      rows[3][k] = h(g.zero) - scale * h.c;
    }
    for (Equations::Row& row : rows) equations.add(std::move(row));
  }

  /// Places the triangle of the dart with the dart's start at 0; nullopt if no place for its end was found. H is the
  /// form in the frame of the triangle.
  [[nodiscard]] std::optional<TriangulationStream::Anchor> anchor_at(std::uint32_t dart, const Hermitian& h) const {
    const auto& [a, b, c] = frame_from(place_[dart].side);
    // w is the reflection of a in the circle: a*Hw = 0.
    const Gaussian first = h(a, {{1, 0}, {0, 0}});
    const Gaussian second = h(a, {{0, 0}, {1, 0}});
    const Projective w{-second, first};
    const Integer inside = h(a);
    const Integer outside = h(w);
    if (inside * outside >= 0 || inside * h(b) <= 0 || inside * h(c) <= 0) fail_without_circle();
    // The coordinate [p,a]/[p,w] is 0 at a; scaled so that b is at 1, the square of the circle's radius is 1/t.
    const Rational t(-outside * norm(bracket(b, a)), inside * norm(bracket(b, w)));
    const Complex<Rational> sigma = value({bracket(c, a) * bracket(b, w), bracket(c, w) * bracket(b, a)});
    // All neighbours are at κz with z known. With κ = n/m, |n|² and |m|² are the terms of t, and factors of n and m
    // occur in the z.
    std::vector<Gaussian> numerators;
    std::vector<Gaussian> denominators;
    for (const Complex<Rational>& z : star(dart, sigma)) {
      if (bits(scaled(z).n) > kMostStarBits || bits(scaled(z).m) > kMostStarBits) break;
      const GaussianFraction fraction = in_lowest_terms(z);
      numerators.push_back(fraction.n);
      denominators.push_back(fraction.d);
    }
    const TwoSquares n = two_squares(Integer(numerator(t)), denominators);
    const TwoSquares m = two_squares(Integer(denominator(t)), numerators);
    if (n.obstacle) fail_for(*n.obstacle);
    if (m.obstacle) fail_for(*m.obstacle);
    if (!n.root || !m.root) return std::nullopt;
    const Complex<Rational> kappa = value({*n.root, *m.root});
    return TriangulationStream::Anchor{dart, {Complex<Rational>{0, 0}, kappa, kappa * sigma}};
  }

  /// Returns up to kMost neighbours of the start of a dart, in coordinates with the start at 0, the dart's end at 1 and
  /// the third vertex at `sigma`.
  [[nodiscard]] std::vector<Complex<Rational>> star(std::uint32_t dart, const Complex<Rational>& sigma) const {
    constexpr std::size_t kMost = 32;
    const Complex<Rational> start{0, 0};
    std::vector<Complex<Rational>> result{sigma};
    Complex<Rational> end{1, 0};
    for (std::uint32_t d = dart; result.size() < kMost;) {
      // Crosses the side from the third vertex to the start.
      const std::uint32_t side = turned(d, 2);
      d = opposite(side);
      if (d == dart) break;
      const Complex<Rational> third = result.back();
      const GaussianFraction next =
          fourth_point(scaled(third), scaled(start), scaled(end), scaled(stream_.edges[edge_[side]].cross_ratio));
      if (next.d == Gaussian{0, 0}) break;
      result.push_back(value(next));
      end = third;
    }
    return result;
  }

  [[noreturn]] void fail_without_circle() const {
    fail(
        "there is no anchor, and the cross-ratios keep no circle of the plane that could be the boundary of the disk: "
        "these cross-ratios are not those of a closed hyperbolic surface");
  }

  [[noreturn]] void fail_to_find() const {
    fail(
        "there is no anchor, and the numbers are too large to find one; expected, in place of \"no\": \"yes\", a dart "
        "and the three points of its triangle (its start, its end and the third vertex) in the unit disk; CGAL's "
        "Delaunay class writes the anchors of all triangles with its member to_stream, operator<< none");
  }

  [[noreturn]] void fail_for(const Integer& obstacle) const {
    std::string number = obstacle.str();
    if (number.size() > 40) number = "a number of " + std::to_string(number.size()) + " digits";
    fail("there is no anchor, and there can be none: no disk has rational points with these cross-ratios, as " +
         number +
         ", which is 3 modulo 4, keeps tanh^2 of half the length of an edge from being a sum of two rational squares");
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw ExchangeError(certify::ErrorParts{.file = std::string(name_), .problem = message});
  }

  const TriangulationStream& stream_;
  std::string_view name_;
  std::vector<Place> place_;         ///< By dart.
  std::vector<std::uint32_t> edge_;  ///< By dart.
  /// By triangle: the dart across which it was reached, of a triangle nearer to triangle 0.
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> order_;
};

}  // namespace

TriangulationStream::Anchor find_anchor(const TriangulationStream& stream, std::string_view name) {
  return AnchorSearch(stream, name).anchor();
}

}  // namespace epsnet
