#include "netgen/geodesics/cutting_search.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <unordered_map>

#include "kernel/numbers.h"
#include "netgen/base/disjoint_sets.h"
#include "netgen/nets/certified_net.h"

namespace epsnet {

namespace {

// Values of lines are compared with 0 up to this, relative to the largest at a triangle: rounding grows with the length
// of the way and stays far below, also 16 units away.
constexpr double kSlack = 1e-9;
// An axis that is known in the middle of a period only up to rounding on half of its length.
constexpr double kAxisSlack = 1e-10;
// Bounds of lengths are widened by this, relatively.
constexpr double kLengthSlack = 1e-7;

using Vector1024 = LorentzVector<Mp1024>;

double largest(double a, double b, double c) { return std::max({std::abs(a), std::abs(b), std::abs(c)}); }

Mp1024 determinant(const Vector1024& u, const Vector1024& v, const Vector1024& w) {
  return lorentz_product(lorentz_cross(u, v), w);
}

/// Whether the way back from an n-th dart, the opposite of the first, begins with less than the way from the first one.
bool way_back_is_less(const std::vector<std::uint32_t>& codes, std::size_t n) {
  for (std::size_t i = 1; i < n; ++i) {
    const std::uint32_t reverse = codes[n - i] ^ 1U;
    if (reverse != codes[i]) return reverse < codes[i];
  }
  return false;
}

/// The same for a closed way and all of its rotations backwards.
bool way_back_is_less(const std::vector<std::uint32_t>& codes) {
  const std::size_t count = codes.size();
  for (std::size_t n = 0; n < count; ++n) {
    if (codes[n] != (codes[0] ^ 1U)) continue;
    for (std::size_t i = 1; i < count; ++i) {
      const std::uint32_t reverse = codes[(n + count - i) % count] ^ 1U;
      if (reverse < codes[i]) return true;
      if (reverse > codes[i]) break;
    }
  }
  return false;
}

LorentzVector<double> rounded(const Vector1024& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.t)};
}

}  // namespace

/// A way across edges, and the lines that cross all of them: a cone of functionals, the ends of the edges on the left
/// hand not negative and those on the right not positive, by its extreme rays in cyclic order.
class CuttingSearch::Way {
 public:
  explicit Way(const CuttingSearch& search) : search_(search) {}

  [[nodiscard]] const std::vector<std::uint32_t>& codes() const { return codes_; }

  /// Walks from a dart across darts of codes not less than `least`, depth first. `enter(code, cosh, n)` is asked before
  /// the n-th dart is crossed (the first is number 0), cosh that of the distance between its edge and the first one.
  template <class Enter>
  void walk(Dart first, std::uint32_t least, const Enter& enter) {
    nodes_.clear();
    rays_.clear();
    codes_.assign(1, search_.code_[index(first)]);
    first_cosh_ = search_.cosh_[index(first)];
    // cosh of the distances from the two ends of the first edge.
    const auto& corner = search_.corners_[triangle_of(first)];
    const std::uint32_t right = corner_of(first);
    const std::array<std::uint32_t, 3> order{next(right), right, previous(right)};
    const auto from = [&](std::uint32_t end) {
      const auto value = [&](std::uint32_t k) { return -lorentz_product(corner[end], corner[order[k]]); };
      return Values{value(0), value(1), value(2)};
    };
    push(first, from(order[0]), from(order[1]), {});
    while (!nodes_.empty()) {
      Node& node = nodes_.back();
      if (node.next_branch == 2) {
        rays_.resize(node.first_ray);
        nodes_.pop_back();
        codes_.pop_back();
        continue;
      }
      branch(node.next_branch++ == 0, least, enter);
    }
  }

 private:
  /// Beyond a dart: values at its ends and at the third corner of the triangle entered.
  struct Node {
    Dart crossed;
    int next_branch;
    std::size_t first_ray;
    Values from_left;
    Values from_right;
  };

  /// The values at the corners of the triangle in the order of the dart to the right, which has the third corner on its
  /// left hand, or of the other.
  static Values turned(const Values& v, bool to_right) {
    return to_right ? Values{v.apex, v.right, v.left} : Values{v.left, v.apex, v.right};
  }

  template <class Enter>
  void branch(bool to_right, std::uint32_t least, const Enter& enter) {
    const Node node = nodes_.back();
    const Dart back = search_.triangulation_.opposite(node.crossed);
    const Dart dart = to_right ? next_dart(back) : previous_dart(back);
    const std::uint32_t code = search_.code_[index(dart)];
    if (code < least || !clip(node, to_right)) return;
    const Values from_left = turned(node.from_left, to_right);
    const Values from_right = turned(node.from_right, to_right);
    const double cosh = nodes_.size() == 1 ? 1.0 : cosh_distance(from_left, from_right, search_.cosh_[index(dart)]);
    if (!enter(code, cosh, nodes_.size())) return;
    codes_.push_back(code);
    push(dart, from_left, from_right, clipped_);
  }

  void push(Dart dart, const Values& from_left, const Values& from_right, const std::vector<Values>& rays) {
    const Values& k = search_.beyond_[index(dart)];
    const auto carried = [&](const Values& v) {
      return Values{v.left, v.right, k.left * v.left + k.right * v.right + k.apex * v.apex};
    };
    nodes_.push_back({dart, 0, rays_.size(), carried(from_left), carried(from_right)});
    for (const Values& ray : rays) rays_.push_back(carried(ray));
  }

  /// The lines that have the third corner on the left hand, or on the right, in the order of the corners there.
  bool clip(const Node& node, bool to_right) {
    clipped_.clear();
    const double wanted = to_right ? 1 : -1;
    if (nodes_.size() == 1) {
      // The first edge leaves a cone with a line in it; with three ends it is a trihedron.
      for (const Values& ray : {Values{1, 0, 0}, Values{0, -1, 0}, Values{0, 0, wanted}}) {
        clipped_.push_back(turned(ray, to_right));
      }
      return true;
    }
    const std::size_t count = rays_.size() - node.first_ray;
    const Values* rays = rays_.data() + node.first_ray;
    const auto side = [&](const Values& v) {
      const double value = wanted * v.apex;
      const double slack = kSlack * largest(v.left, v.right, v.apex);
      return value > slack ? 1 : value < -slack ? -1 : 0;
    };
    int here = side(rays[0]);
    for (std::size_t i = 0; i < count; ++i) {
      const Values& ray = rays[i];
      const Values& after = rays[i + 1 == count ? 0 : i + 1];
      const int there = side(after);
      if (here >= 0) clipped_.push_back(scaled(turned(ray, to_right)));
      if (here * there < 0) {
        const double a = std::abs(after.apex);
        const double b = std::abs(ray.apex);
        clipped_.push_back(scaled(
            turned({a * ray.left + b * after.left, a * ray.right + b * after.right, a * ray.apex + b * after.apex},
                   to_right)));
      }
      here = there;
    }
    return !clipped_.empty();
  }

  static Values scaled(const Values& v) {
    const double scale = 1 / largest(v.left, v.right, v.apex);
    return {scale * v.left, scale * v.right, scale * v.apex};
  }

  /// cosh d for the distance d of an edge, of which the cosh of the length is given, from the first one: the least
  /// distance of an end of one from the other, or the distance of their lines, if that is between two points of them.
  [[nodiscard]] double cosh_distance(const Values& p, const Values& q, double cosh_edge) const {
    const double first = first_cosh_;
    double least2 = std::min({end_to_edge2(p.left, q.left, first), end_to_edge2(p.right, q.right, first),
                              end_to_edge2(p.left, p.right, cosh_edge), end_to_edge2(q.left, q.right, cosh_edge)});
    // From a short edge no point is nearer than an end by more than its length.
    if (is_short(first) || is_short(cosh_edge))
      return std::sqrt(std::max(least2 * nearer(std::min(first, cosh_edge)), 1.0));
    // Of the distance from a line sinh² has its minimum on an edge inside if neither end has cosh² of its
    // length times as much as the other.
    const auto has_foot = [](double x2, double y2, double edge) {
      return x2 - 1 < edge * edge * (y2 - 1) && y2 - 1 < edge * edge * (x2 - 1);
    };
    if (has_foot(line2(p.left, q.left, first), line2(p.right, q.right, first), cosh_edge) &&
        has_foot(line2(p.left, p.right, cosh_edge), line2(q.left, q.right, cosh_edge), first)) {
      const double lines2 =
          square(p.left * q.right - p.right * q.left) / ((first * first - 1) * (cosh_edge * cosh_edge - 1));
      if (lines2 > 1) least2 = std::min(least2, lines2);
    }
    return std::sqrt(std::max(least2, 1.0));
  }

  static double square(double x) { return x * x; }

  /// An edge so short that the distance from its line is lost by cancellation.
  static bool is_short(double edge) { return edge < 1 + 1e-8; }
  /// A lower bound of cosh² (d - l) / cosh² d, for the length l of an edge of which cosh l is given.
  static double nearer(double edge) {
    const double exp_length = edge + std::sqrt(edge * edge - 1);
    return 1 / (exp_length * exp_length);
  }

  /// cosh² of the distance of a point from an edge, or from its line, of the distances of whose ends from the point and
  /// from each other the cosh are given.
  static double end_to_edge2(double p, double q, double edge) {
    if (p >= edge * q) return q * q;
    if (q >= edge * p) return p * p;
    if (is_short(edge)) return std::min(p * p, q * q) * nearer(edge);
    return line2(p, q, edge);
  }
  static double line2(double p, double q, double edge) {
    return (2 * edge * p * q - p * p - q * q) / (edge * edge - 1);
  }

  const CuttingSearch& search_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> codes_;
  std::vector<Values> rays_;  ///< Of all nodes, one after the other.
  std::vector<Values> clipped_;
  double first_cosh_ = 1;
};

/// Whether closed sequences of darts are those of closed geodesics.
class CuttingSearch::Judge {
 public:
  Judge(const CuttingSearch& search, double length)
      : search_(search), most_cosh_(std::cosh(length / 2 * (1 + kLengthSlack))) {}

  /// The closed path of a sequence, unless it certainly is none of a geodesic that is short enough.
  std::optional<CuttingPath> judge(const std::vector<std::uint32_t>& codes) {
    Isometry<double> element;
    for (const std::uint32_t code : codes) {
      const std::uint32_t step = search_.step_[index(search_.dart_[code])];
      if (step != 0) element = element * search_.isometries_[step];
    }
    if (element.a.x < 0) element = {-element.a, -element.b};
    if (!(element.a.x <= most_cosh_)) return std::nullopt;
    const double discriminant = isometry_discriminant(element);
    CuttingPath path{{}, false, std::nullopt};
    for (const std::uint32_t code : codes) path.darts.push_back(search_.dart_[code]);
    if (!(discriminant > 0)) return path;
    follow((1 / std::sqrt(discriminant)) * axis_normal(element), path.darts);
    path.certain = true;
    for (std::size_t i = 0; i < path.darts.size(); ++i) {
      const std::uint32_t right = corner_of(path.darts[i]);
      const double least = std::min(values_[i][next(right)], -values_[i][right]);
      if (least < -kAxisSlack) return std::nullopt;
      path.certain = path.certain && least > kAxisSlack;
    }
    path.simple = is_simple(path.darts);
    return path;
  }

 private:
  /// The values of the axis at the corners of every triangle on the way, carried from its nearer end.
  void follow(const LorentzVector<double>& axis, const std::vector<Dart>& darts) {
    const std::size_t count = darts.size();
    values_.resize(count + 1);
    for (std::uint32_t k = 0; k < 3; ++k) {
      values_[0][k] = lorentz_product(axis, search_.corners_[triangle_of(darts[0])][k]);
    }
    values_[count] = values_[0];
    for (std::size_t i = 0; i < count / 2; ++i) values_[i + 1] = carried(values_[i], darts[i]);
    for (std::size_t i = count; i-- > count / 2 + 1;) {
      values_[i] = carried(values_[i + 1], search_.triangulation_.opposite(darts[i]));
    }
  }

  [[nodiscard]] std::array<double, 3> carried(const std::array<double, 3>& v, Dart d) const {
    const std::uint32_t i = corner_of(d);
    const std::uint32_t j = corner_of(search_.triangulation_.opposite(d));
    const Values& k = search_.beyond_[index(d)];
    std::array<double, 3> result{};
    result[j] = v[next(i)];
    result[next(j)] = v[i];
    result[previous(j)] = k.left * v[next(i)] + k.right * v[i] + k.apex * v[previous(i)];
    return result;
  }

  /// Two chords of one triangle cross if their normals, of length 1, have a product between −1 and 1.
  [[nodiscard]] std::optional<bool> is_simple(const std::vector<Dart>& darts) const {
    constexpr double kMargin = 1e-7;
    bool known = true;
    for (std::size_t j = 0; j < darts.size(); ++j) {
      for (std::size_t i = 0; i < j; ++i) {
        if (triangle_of(darts[i]) != triangle_of(darts[j])) continue;
        const Corners& dual = search_.dual_[triangle_of(darts[i])];
        double product = 0;
        double size = 0;
        for (std::uint32_t k = 0; k < 3; ++k) {
          const double row = dual[k].x * values_[j][0] + dual[k].y * values_[j][1] + dual[k].t * values_[j][2];
          product += values_[i][k] * row;
          size += std::abs(values_[i][k]) * (std::abs(dual[k].x * values_[j][0]) + std::abs(dual[k].y * values_[j][1]) +
                                             std::abs(dual[k].t * values_[j][2]));
        }
        const double margin = kMargin * std::max(1.0, size / 100);
        if (std::abs(product) < 1 - margin) return false;
        known = known && std::abs(product) > 1 + margin;
      }
    }
    return known ? std::optional(true) : std::nullopt;
  }

  const CuttingSearch& search_;
  double most_cosh_;
  std::vector<std::array<double, 3>> values_;
};

CuttingSearch::CuttingSearch(Triangulation& triangulation, const std::vector<bool>& inner)
    : triangulation_(triangulation), step_(4 * std::size_t{triangulation.triangle_count()}) {
  std::unordered_map<LabelId, std::uint32_t> number{{kIdentity, 0}};
  for (const TriangleId t : triangulation.triangles()) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const LabelId label = triangulation.transition(make_dart(t, i));
      const auto [entry, is_new] = number.try_emplace(label, static_cast<std::uint32_t>(isometries_.size()));
      if (is_new) isometries_.push_back(triangulation.atlas().isometry(label));
      step_[index(make_dart(t, i))] = entry->second;
    }
  }
  place_corners(triangulation);
  number_darts(inner);
}

void CuttingSearch::place_corners(Triangulation& triangulation) {
  const std::uint32_t triangles = triangulation.triangle_count();
  const auto moved_by = [&](LabelId label, const Vector1024& x) {
    return label == kIdentity ? x : image(triangulation.isometry_in<Mp1024>(label), x);
  };
  ById<TriangleId, std::array<Vector1024, 3>> corner(triangles);
  const auto place = [&](const ById<VertexId, Complex<double>>& points) {
    bool counterclockwise = true;
    for (const TriangleId t : triangulation.triangles()) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const auto [vertex, label] = triangulation.corner(t, i);
        corner[t][i] = moved_by(label, on_hyperboloid(convert<Mp1024>(points[vertex])));
      }
      counterclockwise = counterclockwise && determinant(corner[t][0], corner[t][1], corner[t][2]) > 0;
    }
    return counterclockwise;
  };
  ById<VertexId, Complex<double>> points = triangulation.mesh().points;
  (void)place(points);
  // The shortest edge at each vertex, as cosh d − 1 = 2 sinh²(d/2).
  ById<VertexId, double> shortest(points.size(), std::numeric_limits<double>::infinity());
  for (const TriangleId t : triangulation.triangles()) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto excess = static_cast<double>(Mp1024(-lorentz_product(corner[t][i], corner[t][next(i)]) - 1));
      for (const std::uint32_t k : {i, next(i)}) {
        double& known = shortest[triangulation.corner(t, k).vertex];
        known = std::min(known, excess);
      }
    }
  }
  // Each vertex moves by a part of that, in some direction, as far as no triangle turns over.
  constexpr double kShare = 0.125;
  constexpr int kTries = 20;
  double share = kShare;
  for (int tries = 0;; ++tries, share /= 2) {
    if (tries == kTries) throw NetError("the vertices of a net could not be moved to general position");
    std::mt19937 random;
    for (const VertexId v : points.ids()) {
      const Complex<double>& z = triangulation.point(v);
      const double size = share * std::sqrt(shortest[v] / 2) * (1 - norm(z));
      const auto coordinate = [&] { return size * (static_cast<double>(random()) / 0x1p31 - 1); };
      const double x = coordinate();
      points[v] = {z.x + x, z.y + coordinate()};
    }
    if (place(points)) break;
  }

  corners_.resize(triangles);
  dual_.resize(triangles);
  beyond_.resize(4 * std::size_t{triangles});
  cosh_.resize(beyond_.size());
  for (const TriangleId t : triangulation.triangles()) {
    const Mp1024 volume = determinant(corner[t][0], corner[t][1], corner[t][2]);
    std::array<Vector1024, 3> normal;
    for (std::uint32_t i = 0; i < 3; ++i) {
      corners_[t][i] = rounded(corner[t][i]);
      normal[i] = Mp1024(1 / volume) * lorentz_cross(corner[t][next(i)], corner[t][previous(i)]);
    }
    for (std::uint32_t i = 0; i < 3; ++i) {
      dual_[t][i] = rounded({lorentz_product(normal[i], normal[0]), lorentz_product(normal[i], normal[1]),
                             lorentz_product(normal[i], normal[2])});
      const Dart d = make_dart(t, i);
      const Dart across = triangulation.opposite(d);
      const Vector1024 x =
          moved_by(triangulation.transition(d), corner[triangle_of(across)][previous(corner_of(across))]);
      const auto coefficient = [&](std::uint32_t k) { return static_cast<double>(lorentz_product(normal[k], x)); };
      beyond_[index(d)] = {coefficient(next(i)), coefficient(i), coefficient(previous(i))};
      cosh_[index(d)] = static_cast<double>(Mp1024(-lorentz_product(corner[t][i], corner[t][next(i)])));
    }
  }
}

void CuttingSearch::number_darts(const std::vector<bool>& inner) {
  for (const TriangleId t : triangulation_.triangles()) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Dart d = make_dart(t, i);
      if (d < triangulation_.opposite(d)) dart_.push_back(d);
    }
  }
  // Short edges first: fewer geodesics cross them, and what begins later has fewer edges to cross.
  std::stable_sort(dart_.begin(), dart_.end(), [&](Dart x, Dart y) {
    return inner[index(x)] != inner[index(y)] ? inner[index(y)] : cosh_[index(x)] < cosh_[index(y)];
  });
  starts_ = static_cast<std::size_t>(std::find_if(dart_.begin(), dart_.end(), [&](Dart d) { return inner[index(d)]; }) -
                                     dart_.begin());
  const std::vector<Dart> edges = std::move(dart_);
  dart_.clear();
  code_.resize(cosh_.size());
  for (const Dart d : edges) {
    for (const Dart x : {d, triangulation_.opposite(d)}) {
      code_[index(x)] = static_cast<std::uint32_t>(dart_.size());
      dart_.push_back(x);
    }
  }
}

std::vector<CuttingPath> CuttingSearch::paths(std::size_t start, double length, std::uint64_t most,
                                              const std::function<void()>& tick) const {
  assert(start < starts_);
  constexpr std::uint64_t kTickEvery = 1U << 14;
  const auto first = static_cast<std::uint32_t>(2 * start);
  std::uint64_t visits = 0;
  const auto count = [&] {
    if (++visits > most) {
      throw NetError("to find all closed geodesics up to length " + std::to_string(length) +
                     " takes a search across more edges than the limit, " + std::to_string(most));
    }
    if (tick && visits % kTickEvery == 0) tick();
  };
  Way way(*this);
  // Lower bounds for the way back from each dart, by a search backwards; what it does not reach is half the length
  // away.
  std::vector<double> back(dart_.size(), length / 2);
  back[first] = 0;
  const double half = std::cosh(length / 2);
  way.walk(dart_[first + 1], first, [&](std::uint32_t code, double cosh, std::size_t) {
    if (cosh >= half) return false;
    count();
    back[code ^ 1U] = std::min(back[code ^ 1U], std::acosh(cosh));
    return true;
  });
  std::vector<double> most_cosh(back.size());
  for (std::size_t i = 0; i < back.size(); ++i) most_cosh[i] = std::cosh((length - back[i]) * (1 + kLengthSlack));

  std::vector<CuttingPath> found;
  Judge judge(*this, length);
  // periods[n]: the period of the first n darts as the beginning of a least rotation (Duval).
  std::vector<std::uint32_t> periods{0, 1};
  way.walk(dart_[first], first, [&](std::uint32_t code, double cosh, std::size_t n) {
    if (cosh > most_cosh[code]) return false;
    const std::vector<std::uint32_t>& codes = way.codes();
    std::uint32_t period = periods[n];
    const std::uint32_t rival = codes[n - period];
    if (code < rival) return false;
    if (code > rival) period = static_cast<std::uint32_t>(n + 1);
    periods.resize(n + 1);
    periods.push_back(period);
    if (code == (first ^ 1U) && way_back_is_less(codes, n)) return false;
    if (code == first && periods[n] == n && !way_back_is_less(codes)) {
      if (std::optional<CuttingPath> path = judge.judge(codes)) found.push_back(*std::move(path));
    }
    count();
    return true;
  });
  return found;
}

namespace {

/// The cells of the triangles when they are cut along arcs, and which of them are connected.
class Cells {
 public:
  Cells(const Triangulation& triangulation, const std::vector<std::vector<CornerArc>>& curves)
      : triangulation_(triangulation), arcs_(triangulation.triangle_count()), first_(triangulation.triangle_count()) {
    for (const auto& curve : curves) {
      for (const CornerArc& arc : curve) ++arcs_[arc.triangle][arc.corner];
    }
    std::uint32_t count = 0;
    for (const TriangleId t : triangulation.triangles()) {
      first_[t] = count;
      count += arcs_[t][0] + arcs_[t][1] + arcs_[t][2] + 1;
    }
    components_ = DisjointSets(count);
    for_each_segment([&](std::uint32_t cell, std::uint32_t beyond) { components_.join(cell, beyond); });
  }

  [[nodiscard]] std::uint32_t size() const { return components_.size(); }
  [[nodiscard]] std::uint32_t component(std::uint32_t cell) { return components_.find(cell); }

  /// Returns the cell with `rank` arcs between it and a corner. The central cell is the last one of every corner.
  [[nodiscard]] std::uint32_t at_corner(TriangleId t, std::uint32_t corner, std::uint32_t rank) const {
    if (rank == arcs_[t][corner]) return first_[t] + arcs_[t][0] + arcs_[t][1] + arcs_[t][2];
    std::uint32_t cell = first_[t] + rank;
    for (std::uint32_t i = 0; i < corner; ++i) cell += arcs_[t][i];
    return cell;
  }

  /// Calls visit(cell, cell beyond) for each of the segments into which arcs cut the edges.
  template <class Visit>
  void for_each_segment(const Visit& visit) const {
    for (const TriangleId t : triangulation_.triangles()) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const Dart d = make_dart(t, i);
        const Dart e = triangulation_.opposite(d);
        if (e < d) continue;
        const std::uint32_t crossings = arcs_[t][i] + arcs_[t][next(i)];
        for (std::uint32_t s = 0; s <= crossings; ++s) visit(along(d, s), along(e, crossings - s));
      }
    }
  }

 private:
  /// Returns the cell beside segment s of a dart.
  [[nodiscard]] std::uint32_t along(Dart d, std::uint32_t s) const {
    const TriangleId t = triangle_of(d);
    const std::uint32_t i = corner_of(d);
    return s <= arcs_[t][i] ? at_corner(t, i, s) : at_corner(t, next(i), arcs_[t][i] + arcs_[t][next(i)] - s);
  }

  const Triangulation& triangulation_;
  ById<TriangleId, std::array<std::uint32_t, 3>> arcs_;  ///< By triangle and corner: how many arcs cut it off.
  ById<TriangleId, std::uint32_t> first_;
  DisjointSets components_{0};
};

}  // namespace

std::vector<certify::GeodesicsDocument::Piece> cut_surface(const Triangulation& triangulation,
                                                           const std::vector<std::vector<CornerArc>>& curves) {
  Cells cells(triangulation, curves);
  // The curves are circles, of characteristic 0, so the characteristic of a piece is that of its interior.
  std::vector<int> characteristic(cells.size());
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) ++characteristic[cells.component(cell)];
  cells.for_each_segment([&](std::uint32_t cell, std::uint32_t) { --characteristic[cells.component(cell)]; });
  ById<VertexId, bool> counted(triangulation.vertex_count());
  for (const TriangleId t : triangulation.triangles()) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const VertexId v = triangulation.corner(t, i).vertex;
      if (!counted[v]) ++characteristic[cells.component(cells.at_corner(t, i, 0))];
      counted[v] = true;
    }
  }

  constexpr std::uint32_t kNone = ~0U;
  std::vector<std::uint32_t> piece_of(cells.size(), kNone);
  std::vector<std::uint32_t> component_of;
  std::vector<certify::GeodesicsDocument::Piece> pieces;
  const auto piece = [&](std::uint32_t cell) -> certify::GeodesicsDocument::Piece& {
    const std::uint32_t component = cells.component(cell);
    if (piece_of[component] == kNone) {
      piece_of[component] = static_cast<std::uint32_t>(pieces.size());
      pieces.emplace_back();
      component_of.push_back(component);
    }
    return pieces[piece_of[component]];
  };
  for (std::uint32_t c = 0; c < curves.size(); ++c) {
    const CornerArc& arc = curves[c].front();
    for (const std::uint32_t side : {0U, 1U}) {
      const bool at_corner = arc.corner_is_left == (side == 0);
      piece(cells.at_corner(arc.triangle, arc.corner, at_corner ? arc.rank : arc.rank + 1))
          .boundaries.emplace_back(c, side);
    }
  }
  if (curves.empty()) (void)piece(0);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const int boundaries = static_cast<int>(pieces[p].boundaries.size());
    pieces[p].genus = static_cast<std::uint32_t>((2 - characteristic[component_of[p]] - boundaries) / 2);
  }
  return pieces;
}

}  // namespace epsnet
