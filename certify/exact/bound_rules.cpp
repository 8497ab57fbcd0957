#include <array>
#include <cmath>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "certify/exact/claim_rules.h"
#include "certify/exact/interval.h"
#include "certify/exact/isometry_rules.h"
#include "certify/exact/loops.h"
#include "certify/exact/pair_search.h"
#include "certify/exact/rough_interval.h"

namespace epsnet::exact {
namespace {

using Claim = BoundDocument::Claim;

/// Elements: 300 MB. Darts of all triangulations together: half a gigabyte.
constexpr std::size_t kMaxElements = 200'000;
constexpr std::size_t kMaxDarts = 25'000'000;
/// Values that take as long as one to all digits, and as the functions of a triangle, for each of its darts.
constexpr std::size_t kAllDigits = 20;
constexpr std::size_t kFunctions = 5;
/// Values that take as long as the motions of one step, and edges that are tried, as one value.
constexpr std::size_t kMotions = 100;
constexpr std::size_t kEdges = 8;
/// Steps that make the base: some 100 MB.
constexpr std::size_t kMaxSteps = 100'000;
/// Cells of a triangle that are cut and not asked yet, 2 kB each: one for each cut on the way to a cell.
constexpr std::size_t kMostOpenCells = 10'000;

/// A triangulation with one vertex: of each dart what is opposite, and the number of its element.
struct Map {
  std::vector<Index> opposite;
  std::vector<std::size_t> element;
};

/// The triangulation that is cut into cells: of each dart the vertex where it starts, and of each vertex a motion of 0
/// to its point.
struct Base : Map {
  std::vector<Index> start;
  std::vector<Motion> frame;
};

template <class Number>
using VectorOf = std::array<Number, 3>;

[[nodiscard]] VectorOf<RoughInterval> rounded(const Vector& u) {
  return {RoughInterval(u[0]), RoughInterval(u[1]), RoughInterval(u[2])};
}

/// sinh²(d(p, gp)/2) = σ + ⟨n, U(p)⟩² for a point p.
template <class Number>
struct Displacement {
  Number sigma;
  VectorOf<Number> n;

  [[nodiscard]] Number at(const VectorOf<Number>& u) const {
    return sigma + square(n[0] * u[0] + n[1] * u[1] + n[2] * u[2]);
  }
};

[[nodiscard]] Displacement<Interval> displacement_of(const Motion& g) {
  return {squared_half_length(g), {-g.b.im, g.b.re, -g.a.im}};
}

/// Elements of the group, each once, and its inverse, by where it takes the vertex of the net (Lemma 21.1).
template <class R>
class Elements {
 public:
  static constexpr std::size_t kIdentity = 0;

  struct Element {
    Motion motion;
    Place place;  ///< Of the vertex.
    std::size_t inverse;
    Displacement<RoughInterval> rough_displacement;

    [[nodiscard]] Displacement<Interval> displacement() const { return displacement_of(motion); }
  };

  /// The identity, and the elements of the net's darts. The rules of the net, which has one vertex, are verified.
  explicit Elements(NetRules<R>& net) {
    const Point<R> z = point<R>(net.net().vertices[0].z);
    const Interval m = enclosure(z.m);
    vertex_ = {{enclosure(z.n.re) / m, enclosure(z.n.im) / m}, {1, 0}};
    std::vector<Motion> motions;
    for (Index dart = 0; dart < net.darts(); ++dart) {
      motions.push_back(enclose(net.element(dart)));
      const Interval length = apart(image(motions.back(), vertex_), vertex_);
      shortest_ = dart == 0 ? length : -max(-shortest_, -length);
    }
    add({});
    for (const Motion& motion : motions) of_dart_.push_back(found_or_added(motion));
    for (const Motion& motion : motions) along_.push_back({motion, about(image(motion, vertex_))});
  }

  [[nodiscard]] std::size_t of_dart(Index dart) const { return of_dart_[dart]; }
  [[nodiscard]] const Element& operator[](std::size_t g) const { return elements_[g]; }
  /// g ∘ f. Throws TooLarge.
  [[nodiscard]] std::size_t product(std::size_t g, std::size_t f) {
    return found_or_added(compose(elements_[g].motion, elements_[f].motion));
  }
  /// The work that ways along edges took, in values of sinh² to a few digits.
  [[nodiscard]] std::size_t work() const { return work_; }

 private:
  struct Along {
    Motion motion;
    PlaceOf<double> place;  ///< About.
  };

  [[nodiscard]] static PlaceOf<double> about(const Place& z) {
    const auto middle = [](const Interval& x) { return x.lower() / 2 + x.upper() / 2; };
    return {{middle(z.n.re), middle(z.n.im)}, {middle(z.d.re), middle(z.d.im)}};
  }

  /// sinh²(d/2) of two lifts of the vertex, times a constant.
  [[nodiscard]] static Interval apart(const Place& x, const Place& y) { return norm(x.n * y.d - y.n * x.d); }
  /// About the most that it may be, as far as binary64 tells.
  [[nodiscard]] static double most_apart(const PlaceOf<double>& x, const PlaceOf<double>& y) {
    const Complex<double> difference = x.n * y.d - y.n * x.d;
    const auto size = [](const Complex<double>& z) { return std::abs(z.re) + std::abs(z.im); };
    const double error = (size(x.n) * size(y.d) + size(y.n) * size(x.d)) * 0x1p-50;
    const double re = std::abs(difference.re) + error;
    const double im = std::abs(difference.im) + error;
    return re * re + im * im;
  }
  /// Whether two lifts of the vertex are nearer to each other than the ends of every edge, so equal. Others are not
  /// nearer than those, so half of that decides.
  [[nodiscard]] Answer are_same(const Place& x, const Place& y) const { return is_less(2 * apart(x, y), shortest_); }

  [[nodiscard]] std::size_t found_or_added(const Motion& g) {
    const Place place = image(g, vertex_);
    const auto known = table_.find(0, place, [&](std::size_t k) { return are_same(elements_[k].place, place); });
    return known ? *known : add(along_edges(g, place));
  }

  /// The same element as a product of few edges of the net, each the next one on a way from the vertex to its image:
  /// what products of products are not known well lose is not handed on. As it is, if there is no such way.
  [[nodiscard]] Motion along_edges(const Motion& g, const Place& place) {
    Motion way;
    PlaceOf<double> rest = about(place);
    double left = most_apart(rest, about(vertex_));
    constexpr int kMostEdges = 1000;
    for (int edges = 0; edges < kMostEdges; ++edges) {
      const Along* nearest = nullptr;
      for (const Along& dart : along_) {
        const double distance = most_apart(rest, dart.place);
        if (distance >= left) continue;
        left = distance;
        nearest = &dart;
      }
      work_ += along_.size() / kEdges + kMotions;
      if (nearest == nullptr) return are_same(image(way, vertex_), place) == Answer::yes ? way : g;
      way = compose(way, nearest->motion);
      rest = about(image(inverse(way), place));
    }
    return g;
  }

  std::size_t add(const Motion& g) {
    if (elements_.size() > kMaxElements) throw TooLarge{"its triangulations have too many elements for this checker"};
    const std::size_t number = elements_.size();
    const bool is_identity = number == kIdentity;
    add_one(g, is_identity ? number : number + 1);
    if (!is_identity) add_one(inverse(g), number);
    return number;
  }
  void add_one(const Motion& g, std::size_t inverse) {
    const Displacement<Interval> displacement = displacement_of(g);
    const Place place = image(g, vertex_);
    table_.insert(0, place, elements_.size());
    elements_.push_back({g, place, inverse, {RoughInterval(displacement.sigma), rounded(displacement.n)}});
  }

  Place vertex_;
  Interval shortest_;  ///< Of `apart`, among the edges of the net.
  std::deque<Element> elements_;
  std::vector<std::size_t> of_dart_;
  std::vector<Along> along_;  ///< By dart.
  PointTable table_;
  std::size_t work_ = 0;
};

template <class R>
Vector unit_vector(const Point<R>& z) {
  const Interval m = enclosure(gap(z));
  const auto quotient = [&](const R& n) { return enclosure(n) / m; };
  return {quotient(2 * z.n.re * z.m), quotient(2 * z.n.im * z.m), quotient(z.m * z.m + norm(z.n))};
}

/// cosh of the distance of 0 from its image.
Interval cosh_of(const Motion& g) { return norm(g.a) + norm(g.b); }
/// The vector of the image of 0.
Vector vector_of(const Motion& g) {
  const Complex<Interval> z = g.a * g.b;
  return {2 * z.re, 2 * z.im, cosh_of(g)};
}

/// The translation of 0 to the midpoint of 0 and its image: g is a rotation, and then the translation by (|a|, ab/|a|).
Motion half_of(const Motion& g) {
  const Interval a = sqrt(norm(g.a));
  const Interval cosh_of_quarter = sqrt((a + 1) / 2);
  const Interval scale = 1 / (2 * cosh_of_quarter * a);
  const Complex<Interval> ab = g.a * g.b;
  return {{cosh_of_quarter, 0}, {scale * ab.re, scale * ab.im}};
}

/// The translation of 0 to a point near its image that is known exactly.
Motion translation_near(const Motion& g) {
  const Interval square = norm(g.a);
  const Complex<Interval> ab = g.a * g.b;
  const Complex<Interval> z{(ab.re / square).middle(), (ab.im / square).middle()};
  const Interval gap = 1 - norm(z);
  if (is_less(0, gap) != Answer::yes) throw TooLarge{"a vertex of the base is not known well enough"};
  const Interval scale = 1 / sqrt(gap);
  return {{scale, 0}, {scale * z.re, scale * z.im}};
}

Interval cosh_distance(const Vector& p, const Vector& q) { return p[2] * q[2] - p[0] * q[0] - p[1] * q[1]; }

Vector difference(const Vector& p, const Vector& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }

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
  BoundRules(const BoundDocument& document, NetRules<R>& net, std::size_t most_work)
      : document_(document), net_(net), work_left_(most_work) {}

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
    elements_.emplace(net_);
    Map first{std::vector<Index>(net_.darts()), std::vector<std::size_t>(net_.darts())};
    for (Index dart = 0; dart < net_.darts(); ++dart) {
      first.opposite[dart] = net_.opposite(dart);
      first.element[dart] = elements_->of_dart(dart);
    }
    maps_.push_back(std::move(first));
    for (const BoundDocument::Triangulation& row : document_.triangulations) {
      Map map = maps_[row.parent];
      for (const Index dart : row.flips) flip(map, dart);
      maps_.push_back(std::move(map));
    }
    make_base();
  }

  void check_isometries() { expect_isometries(net_, document_.symmetry->rows); }

  /// Lemma 21.3: the points that are as far from the centre as from two of its images.
  void check_domain() {
    const auto& [centre, rows] = *document_.symmetry;
    const Vector from = unit_vector(point<R>(centre));
    const auto basis = [&](const std::vector<Index>& x, const std::vector<Index>& y) {
      return Basis(hyperbolic_at_vertex(x), hyperbolic_at_vertex(y));
    };
    const Vector coordinates = basis(rows.pair[0], rows.pair[1]).coordinates(from);
    std::vector<Vector> normal;
    for (const IsometryRows::Row& row : rows.isometries) {
      const Vector image = basis(row.images[0], row.images[1]).combination(coordinates);
      normal.push_back(row.preserves_orientation ? difference(from, image)
                                                 : difference(from, {-image[0], -image[1], -image[2]}));
    }
    const std::size_t count = normal.size();
    std::vector<Vector> corner;
    for (std::size_t i = 0; i < count; ++i) {
      const std::string sides = "the sides of isometry " + number(i) + " and the next one";
      const std::string whether = "whether " + sides + " meet";
      Vector c = cross_product(normal[i], normal[(i + 1) % count]);
      const Interval square = -lorentz_product(c, c);
      if (!decided(is_less(0, square), whether.c_str())) throw Refutation{sides + " do not meet"};
      const Interval scale = (decided(is_less(0, c[2]), whether.c_str()) ? 1 : -1) / sqrt(square);
      corner.push_back({scale * c[0], scale * c[1], scale * c[2]});
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Vector& next = corner[(i + 1) % count];
      const std::string corners = "the corners at the sides of isometry " + number(i) + " and the next two";
      const std::string whether = "whether " + corners + " are counterclockwise";
      if (!decided(is_less(0, lorentz_product(cross_product(from, corner[i]), next)), whether.c_str()))
        throw Refutation{corners + " are not counterclockwise around the centre"};
      around_.push_back(cell_of({from, corner[i], next}));
    }
  }

  void check_cells() {
    const Interval end(document_.value[document_.claim == Claim::radius ? 0 : 1]);
    sinh_ = sinh(end);
    cosh_ = cosh(end);
    most_ = square(sinh_);
    for (Index t = 0; t < document_.cells.size(); ++t) {
      std::vector<Cell> open{document_.symmetry ? around_[t] : triangle(3 * t)};
      for (const Index entry : document_.cells[t]) {
        const Cell cell = std::move(open.back());
        open.pop_back();
        if (entry < 3) {
          if (open.size() > kMostOpenCells) throw TooLarge{"triangle " + number(t) + " is cut too often in one place"};
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
    static_cast<Map&>(base_) = maps_[0];
    base_.start.resize(net_.darts());
    base_.frame.push_back(enclose(translation_to(point<R>(net_.net().vertices[0].z))));
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
  /// point of m is as near to the middle of the edge that starts at the point of a as numbers tell: any point would do.
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
    constexpr std::size_t one = Elements<R>::kIdentity;
    const std::size_t to_c = element(from_c).inverse;
    const std::size_t from_x = element(to_x).inverse;
    base_.frame.push_back(translation_near(compose(base_.frame[a], half_of(along(d, b)))));
    const auto m = static_cast<Index>(base_.frame.size() - 1);
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
    std::array<std::size_t, 4> along{};
    for (std::size_t i = 0; i < 4; ++i) {
      across[i] = map.opposite[from[i]];
      along[i] = map.element[from[i]];
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
      map.element[to[i]] = along[i];
    }
    const std::size_t before = elements_->work();
    map.element[e] = elements_->product(along[0], along[1]);
    map.element[d] = element(map.element[e]).inverse;
    spend(elements_->work() - before);
  }

  /// f_a⁻¹gf_b for a dart of the base from vertex a to vertex b with the element g (docs/proof.md, section 15). Frames
  /// are translations to points that are known exactly: so they are known well also far from 0.
  [[nodiscard]] Motion along(Index dart, Index b) {
    spend(kMotions);
    const Motion& from = base_.frame[base_.start[dart]];
    return compose(inverse(from), compose(element(base_.element[dart]).motion, base_.frame[b]));
  }

  /// The triangle of the base with this dart as the first.
  Cell triangle(Index dart) {
    std::array<Motion, 3> side;
    for (Index i = 0; i < 3; ++i) side[i] = along(dart + i, base_.start[dart + (i + 1) % 3]);
    const Motion& first = base_.frame[base_.start[dart]];
    return {{vector_of(first), vector_of(compose(first, side[0])), vector_of(compose(first, inverse(side[2])))},
            {cosh_of(side[0]), cosh_of(side[1]), cosh_of(side[2])}};
  }

  static Cell cell_of(std::array<Vector, 3> corners) {
    Cell cell{std::move(corners), {}};
    for (std::size_t i = 0; i < 3; ++i) cell.cosh[i] = cosh_distance(cell.corner[i], cell.corner[(i + 1) % 3]);
    return cell;
  }

  /// An element of the group at tile 0, in the chart of the net's vertex, with a trace that certainly is not 0.
  Motion hyperbolic_at_vertex(const std::vector<Index>& word) {
    Motion g = element_at_vertex(net_, word, 0, document_.symmetry->rows.paths);
    if (is_less(1, square(g.a.re)) != Answer::yes) throw TooLarge{"the trace of an element is not known well"};
    return g;
  }

  [[nodiscard]] const typename Elements<R>::Element& element(std::size_t g) const { return (*elements_)[g]; }
  template <class Number>
  [[nodiscard]] Displacement<Number> displacement(std::size_t g) const {
    if constexpr (std::is_same_v<Number, Interval>) {
      return element(g).displacement();
    } else {
      return element(g).rough_displacement;
    }
  }

  /// The values of sinh²(d(p, gp)/2) of all darts at a point.
  template <class Number>
  std::vector<Number> values(const Map& map, const VectorOf<Number>& p) {
    spend(net_.darts() * (std::is_same_v<Number, Interval> ? kAllDigits : 1));
    std::vector<Number> h(net_.darts());
    for (Index dart = 0; dart < net_.darts(); ++dart) {
      const Index other = map.opposite[dart];
      h[dart] = other < dart ? h[other] : displacement<Number>(map.element[dart]).at(p);
    }
    return h;
  }

  void spend(std::size_t work) {
    if (work > work_left_) throw TooLarge{"there are too many cells and triangles for this checker"};
    work_left_ -= work;
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
    return has_short_loop(cell, element(maps_[by / darts].element[by % darts]).displacement());
  }

  /// At the corners of the cell every triangle lies in a disk of radius HI.
  Answer is_covered(const Cell& cell, const Map& map) {
    Answer result = Answer::yes;
    for (const Vector& p : cell.corner) {
      Answer here = all_fit(values(map, rounded(p)), RoughInterval(most_));
      if (here == Answer::unknown) here = all_fit(values(map, p), most_);
      result = both(result, here);
    }
    return result;
  }

  template <class Number>
  static Answer all_fit(const std::vector<Number>& h, const Number& most) {
    Answer result = Answer::yes;
    for (std::size_t t = 0; t < h.size(); t += 3) result = both(result, fits_in_disk(h[t], h[t + 1], h[t + 2], most));
    return result;
  }

  /// d(p, gp) <= 2 HI at the corners, and g is not the identity.
  Answer has_short_loop(const Cell& cell, const Displacement<Interval>& g) {
    spend(3 * kAllDigits);
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
    // D: to either end of the side, and to the corner opposite. sinh(LO + D) from cosh D.
    const Interval reach = max(middle.half, middle.median);
    const Interval least = square(sinh_ * reach + cosh_ * sqrt(square(reach) - 1));
    spend(kFunctions * net_.darts());
    const Answer roughly = is_delaunay_and_wide(map.opposite, values(map, rounded(middle.point)), RoughInterval(least));
    if (roughly != Answer::unknown) return roughly;
    spend(kFunctions * kAllDigits * net_.darts());
    return is_delaunay_and_wide(map.opposite, values(map, middle.point), least);
  }

  const BoundDocument& document_;
  NetRules<R>& net_;
  std::optional<Elements<R>> elements_;
  std::vector<Map> maps_;
  Base base_;
  std::vector<Cell> around_;  ///< The triangles of the domain, if there is a symmetry.
  // Of the bound for cells.
  Interval sinh_;
  Interval cosh_;
  Interval most_;  ///< sinh².
  std::size_t work_left_;
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

/// Whether ΣA < A + π(F − 2) for each of the areas A of F triangles, of which e^{iA/2} is given, 0 < A < π.
template <class Number>
Answer all_counterclockwise(const std::vector<Complex<Number>>& halves) {
  // ΣA/2 = φ + quarters·π/2, with e^{iφ} and −π/4 < φ < 3π/4. A factor e^{iA/2} adds less than π/2, and −i takes π/2
  // off where φ is more than that, or nearly: 2π lie between what else it might be.
  Complex<Number> sum{1, 0};
  auto quarters = 2 - static_cast<long>(halves.size());
  const auto take_off = [&] {
    sum = {sum.im, -sum.re};
    ++quarters;
  };
  for (const Complex<Number>& half : halves) {
    sum = sum * half;
    if (sum.re.lower() + sum.re.upper() < 0) take_off();
    if (is_less(0, sum.re + sum.im) != Answer::yes) return Answer::unknown;
  }
  if (quarters == -1) take_off();
  if (quarters > 1 || (quarters == 1 && is_less(sum.im, 0) == Answer::no))
    return Answer::no;  // ΣA/2 > π/2 + π(F − 2)/2
  if (quarters != 0) return Answer::unknown;
  // φ − A/2 is between −5π/4 and 3π/4, so its sine is negative only if φ < A/2.
  Answer result = Answer::yes;
  for (const Complex<Number>& half : halves) result = both(result, is_less((sum * conjugate(half)).im, 0));
  return result;
}

}  // namespace

template <class Number>
Answer fits_in_disk(const Number& a, const Number& b, const Number& c, const Number& most) {
  const Answer is_short = both(both(!is_less(most, a), !is_less(most, b)), !is_less(most, c));
  const Answer acute = both(both(is_less(a, b + c), is_less(b, c + a)), is_less(c, a + b));
  const Number k = 4 * a * b - square(a + b - c);
  // A disk around the circumcentre, or around the middle of the longest side.
  const Answer around_centre = both(is_less(0, k), !is_less(k * most, 4 * a * b * c));
  return both(is_short, either(around_centre, !acute));
}

template <class Number>
Answer is_delaunay_and_wide(const std::vector<Index>& opposite, const std::vector<Number>& h, const Number& least) {
  std::vector<Number> kappa(h.size());
  std::vector<Complex<Number>> halves;
  Answer result = Answer::yes;
  Answer wide = Answer::no;
  for (std::size_t t = 0; t < h.size(); t += 3) {
    const std::array<Number, 3> x{h[t], h[t + 1], h[t + 2]};
    const Number k = 4 * x[0] * x[1] - square(x[0] + x[1] - x[2]);
    const Number product = 4 * x[0] * x[1] * x[2];
    result = both(result, is_less(0, k));
    const Number scale = 1 / sqrt(k);
    for (std::size_t i = 0; i < 3; ++i) kappa[t + i] = (x[(i + 1) % 3] + x[(i + 2) % 3] - x[i]) * scale;
    // tan(A/2) = √(K + 4abc)/(2 + a + b + c), and the sum of the squares of both is 4(1 + a)(1 + b)(1 + c).
    const Number unit = 1 / (2 * sqrt((1 + x[0]) * (1 + x[1]) * (1 + x[2])));
    halves.push_back({(2 + x[0] + x[1] + x[2]) * unit, sqrt(k + product) * unit});
    wide = either(wide, !is_less(product, k * least));
  }
  for (std::size_t dart = 0; dart < h.size(); ++dart) {
    result = both(result, is_less(0, kappa[dart] + kappa[opposite[dart]]));
  }
  return both(both(result, all_counterclockwise(halves)), wide);
}

template Answer fits_in_disk(const RoughInterval&, const RoughInterval&, const RoughInterval&, const RoughInterval&);
template Answer fits_in_disk(const Interval&, const Interval&, const Interval&, const Interval&);
template Answer is_delaunay_and_wide(const std::vector<Index>&, const std::vector<RoughInterval>&,
                                     const RoughInterval&);
template Answer is_delaunay_and_wide(const std::vector<Index>&, const std::vector<Interval>&, const Interval&);

template <class R>
std::vector<Rule> bound_rules(const BoundDocument& document, NetRules<R>& net, long most_work) {
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
  if (document.symmetry) {
    const auto& [centre, rows] = *document.symmetry;
    if (!document.base.empty()) throw Malformed("a base beside a symmetry");
    if (gap(centre) <= 0) throw Malformed("the centre is not in the disk");
    if (rows.isometries.size() < 3) throw Malformed("a domain of less than three sides");
    net.expect_words(rows);
    darts = 3 * rows.isometries.size();
  }
  if (3 * document.cells.size() != darts) throw Malformed("cells: not one row for each triangle");
  const std::size_t of_each = document.claim == Claim::diameter ? 1 : document.claim == Claim::radius ? 3 : net.darts();
  for (const std::vector<Index>& row : document.cells) {
    expect_subdivision(row, (document.triangulations.size() + 1) * of_each);
  }
  const auto rules = std::make_shared<BoundRules<R>>(document, net, static_cast<std::size_t>(most_work));
  std::vector<Rule> result{{document.claim == Claim::radius ? "upper" : "lower", [rules] { rules->check_vertex(); }},
                           {"triangulations", [rules] { rules->check_triangulations(); }}};
  if (document.symmetry) {
    result.push_back({"isometries", [rules] { rules->check_isometries(); }});
    result.push_back({"domain", [rules] { rules->check_domain(); }});
  }
  result.push_back({"cells", [rules] { rules->check_cells(); }});
  return result;
}

template std::vector<Rule> bound_rules(const BoundDocument& document, NetRules<mpz_class>& net, long);
template std::vector<Rule> bound_rules(const BoundDocument& document, NetRules<Algebraic>& net, long);
template std::vector<Rule> bound_rules(const BoundDocument& document, NetRules<FieldNumber>& net, long);

}  // namespace epsnet::exact
