#include "netgen/lifts/lifts.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "certify/check.h"
#include "certify/net/numbering.h"
#include "kernel/plane.h"
#include "netgen/base/gmp.h"
#include "netgen/nets/triangulations.h"
#include "netgen/surfaces/surfaces.h"
#include "triangulation/mesh/operations.h"
#include "triangulation/mesh/triangulation.h"
#include "triangulation/surface/surface.h"

namespace epsnet {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

/// The labels of the corner where a dart starts: in the dart's triangle, and in the triangle on the other side.
std::pair<std::uint32_t, std::uint32_t> labels_across(const NetGeometry& geometry, std::uint32_t dart) {
  const certify::NetDocument& net = geometry.document();
  return {certify::corner_label(net, dart),
          certify::corner_label(net, certify::next_dart(certify::opposite(net, dart)))};
}

/// The isometries from the charts of corners to the disk. Corners with the same isometry share one.
class Placements {
 public:
  explicit Placements(const NetGeometry& geometry) : geometry_(geometry) {}

  std::uint32_t add(const Isometry<Mp256>& isometry) {
    placements_.emplace_back(normalized(isometry));
    return static_cast<std::uint32_t>(placements_.size() - 1);
  }

  /// Returns the placement of corner 0 of the triangle across a dart, from that of the dart's triangle.
  std::uint32_t across(std::uint32_t placement, std::uint32_t dart) {
    const auto [here, there] = labels_across(geometry_, dart);
    if (here == there) return placement;
    return add(placements_[placement].precise * geometry_.label(here).precise *
               inverse(geometry_.label(there).precise));
  }

  /// Returns the placement of a corner with this label, from that of corner 0 of its triangle. It has 256 bits: in a
  /// thin collar the corners of a triangle are so far apart that binary64 cannot distinguish one, seen from the other,
  /// from a point of the unit circle.
  std::uint32_t of_corner(std::uint32_t placement, std::uint32_t label) {
    if (label == 0) return placement;
    const auto [known, is_new] = of_corners_.try_emplace({placement, label}, 0);
    if (is_new) known->second = add(placements_[placement].precise * geometry_.label(label).precise);
    return known->second;
  }

  [[nodiscard]] const Isometry<double>& rounded(std::uint32_t placement) const {
    return placements_[placement].rounded;
  }
  [[nodiscard]] std::vector<PreciseIsometry> all() && { return std::move(placements_); }

 private:
  const NetGeometry& geometry_;
  std::vector<PreciseIsometry> placements_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> of_corners_;  ///< By placement and label.
};

/// Grows the set of lifted triangles.
class Lifter {
 public:
  Lifter(const NetGeometry& geometry, DrawOrder order, std::uint32_t centre)
      : geometry_(geometry),
        triangles_(geometry.document().triangles),
        order_(order),
        centre_(centre),
        placements_(geometry) {
    lifts_.place.assign(triangles_.size(), kNone);
  }

  [[nodiscard]] Lifts run() {
    lift_first();
    while (!edges_.empty()) {
      const std::uint32_t dart = edges_.top().second;
      edges_.pop();
      const std::uint32_t other = triangles_[dart / 3].opposite[dart % 3] / 3;
      if (lifts_.place[other] != kNone) continue;
      lift(other, placements_.across(lifts_.lifted[lifts_.place[dart / 3]].placement[0], dart));
    }
    if (lifts_.lifted.size() != triangles_.size())
      throw NetGeometryError("only " + std::to_string(lifts_.lifted.size()) + " of " +
                             std::to_string(triangles_.size()) + " triangles are connected");
    lifts_.placements = std::move(placements_).all();
    return std::move(lifts_);
  }

 private:
  void lift_first() {
    const Placement first = placement_at(geometry_, centre_, to_centre(geometry_, centre_));
    lift(first.triangle, placements_.add(first.isometry));
  }

  void lift(std::uint32_t triangle, std::uint32_t placement) {
    Lifts::LiftedTriangle lifted{triangle, {}, {}};
    for (std::uint32_t i = 0; i < 3; ++i) {
      const certify::NetDocument::Vertex& v = geometry_.document().vertices[triangles_[triangle].vertex[i]];
      lifted.placement[i] =
          placements_.of_corner(placement, certify::corner_label(geometry_.document(), 3 * triangle + i));
      lifted.corner[i] = placements_.rounded(lifted.placement[i])({v.x, v.y});
      // Points that round to the circle are allowed, as they are no farther from it than rounding.
      if (!(norm(lifted.corner[i]) < 1 + 1e-12))
        throw NetGeometryError("triangles[" + std::to_string(triangle) + "]: a corner is not in the disk");
    }
    lifts_.place[triangle] = static_cast<std::uint32_t>(lifts_.lifted.size());
    lifts_.lifted.push_back(lifted);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const double weight = order_ == DrawOrder::weight ? norm(lifted.corner[i]) + norm(lifted.corner[(i + 1) % 3])
                                                        : static_cast<double>(lifts_.place[triangle]);
      edges_.push({weight, 3 * triangle + i});
    }
  }

  using Edge = std::pair<double, std::uint32_t>;  ///< Weight and dart; the dart breaks ties.

  const NetGeometry& geometry_;
  const std::vector<certify::NetDocument::Triangle>& triangles_;
  DrawOrder order_;
  std::uint32_t centre_;
  Placements placements_;
  Lifts lifts_;
  std::priority_queue<Edge, std::vector<Edge>, std::greater<>> edges_;
};

}  // namespace

Isometry<Mp256> to_centre(const NetGeometry& geometry, std::uint32_t vertex) {
  if (vertex >= geometry.document().vertices.size())
    throw NetGeometryError("there is no vertex " + std::to_string(vertex));
  const certify::NetDocument::Vertex& v = geometry.document().vertices[vertex];
  return Isometry<Mp256>::translation({Mp256(-v.x), Mp256(-v.y)});
}

Placement placement_at(const NetGeometry& geometry, std::uint32_t vertex, const Isometry<Mp256>& frame) {
  const std::vector<certify::NetDocument::Triangle>& triangles = geometry.document().triangles;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (triangles[t].vertex[i] == vertex)
        return {t, frame * inverse(geometry.label(certify::corner_label(geometry.document(), 3 * t + i)).precise)};
    }
  }
  throw NetGeometryError("vertex " + std::to_string(vertex) + " is a corner of no triangle");
}

Placement neighbour(const NetGeometry& geometry, const Placement& placement, std::uint32_t side) {
  assert(placement.triangle < geometry.document().triangles.size() && side < 3);
  const std::uint32_t dart = 3 * placement.triangle + side;
  const std::uint32_t other = geometry.document().triangles[placement.triangle].opposite[side] / 3;
  const auto [here, there] = labels_across(geometry, dart);
  if (here == there) return {other, placement.isometry};
  return {other,
          normalized(placement.isometry * geometry.label(here).precise * inverse(geometry.label(there).precise))};
}

Lifts lift_triangles(const NetGeometry& geometry, DrawOrder order, std::uint32_t centre) {
  return Lifter(geometry, order, centre).run();
}

std::vector<bool> boundary_darts(const NetGeometry& geometry, const Lifts& lifts) {
  const std::vector<certify::NetDocument::Triangle>& triangles = geometry.document().triangles;
  const auto corner = [&](std::uint32_t dart) { return lifts.lifted[lifts.place[dart / 3]].corner[dart % 3]; };
  // Two lifts of a point are the same or far apart, at the scale of the place.
  const auto same = [](const Complex<double>& u, const Complex<double>& v) {
    return std::sqrt(norm(u - v)) < 1e-6 * std::max(1 - norm(u), 1e-9);
  };
  std::vector<bool> result(3 * triangles.size());
  for (std::uint32_t dart = 0; dart < result.size(); ++dart) {
    const std::uint32_t other = triangles[dart / 3].opposite[dart % 3];
    result[dart] = !(same(corner(dart), corner(certify::next_dart(other))) &&
                     same(corner(certify::next_dart(dart)), corner(other)));
  }
  return result;
}

namespace {

/// The labels of a document at one precision.
template <class T>
class Evaluator {
 public:
  Evaluator(const certify::NetDocument& document, const certify::SurfaceSides& sides) : parts_(document, sides) {}

  /// Returns the label to 120 bits; nullopt if this precision does not suffice for that.
  [[nodiscard]] std::optional<Isometry<Mp256>> label(const certify::NetDocument::Label& label) const {
    // With determinants 1 a product of k factors is off by at most about k 2^−p times the product of their sizes; a
    // factor itself, made from points as far out as its size says, loses twice its size. The bound is this sum and not
    // the size of the result, as a path may lead far away and return.
    double bits = std::log2(static_cast<double>(label.word.size() + 2)) + 8;
    double largest = 0;
    const auto count = [&](const Isometry<T>& f) {
      const double size = size_in_bits(f);
      bits += size;
      largest = std::max(largest, size);
    };
    Isometry<T> result = parts_.frames[label.from];
    count(result);
    for (const std::uint32_t side : label.word) {
      count(parts_.crossings[side]);
      result = parts_.crossings[side] * result;
    }
    count(parts_.frames[label.to]);
    constexpr double kWanted = 120;
    if (!(bits + 4 * largest + kWanted < kMantissaBits<T>)) return std::nullopt;
    return normalized(convert<Mp256>(inverse(parts_.frames[label.to]) * result));
  }

 private:
  Parts<T> parts_;
};

/// Returns the document if it is sound enough for NetGeometry.
const certify::NetDocument& checked(const certify::NetDocument& document) {
  if (const auto problem = certify::malformation(document)) throw NetGeometryError(*problem);
  if (const auto dart = unpaired_dart(document)) {
    throw NetGeometryError("triangles[" + std::to_string(*dart / 3) + "]: dart " + std::to_string(*dart) +
                           " and its opposite " + std::to_string(certify::opposite(document, *dart)) +
                           " do not belong together");
  }
  return document;
}

/// Returns the genus; 0 if V − E + F gives none.
std::uint32_t genus_of(const certify::SurfaceSides& sides) {
  // Corner s is where side s starts. Across the side before it, the same point is where the partner starts. This is a
  // permutation, whose cycles are the points of the surface.
  std::vector<bool> seen(sides.partner.size(), false);
  std::int64_t points = 0;
  for (std::uint32_t start = 0; start < seen.size(); ++start) {
    if (seen[start]) continue;
    ++points;
    for (std::uint32_t corner = start; !seen[corner]; corner = sides.partner[sides.previous[corner]])
      seen[corner] = true;
  }
  const std::int64_t characteristic =
      points - static_cast<std::int64_t>(seen.size() / 2) + static_cast<std::int64_t>(sides.first.size());
  return characteristic <= 2 && characteristic % 2 == 0 ? static_cast<std::uint32_t>((2 - characteristic) / 2) : 0;
}

/// Evaluates the labels with more and more bits, each with no more than it needs.
class StagedEvaluator {
 public:
  StagedEvaluator(const certify::NetDocument& document, const certify::SurfaceSides& sides)
      : document_(document), sides_(sides), at_256_(document, sides) {}

  [[nodiscard]] Isometry<Mp256> label(std::size_t row) {
    const certify::NetDocument::Label& label = document_.labels[row];
    if (const auto result = at_256_.label(label)) return *result;
    if (!at_1024_) at_1024_.emplace(document_, sides_);
    if (const auto result = at_1024_->label(label)) return *result;
    if (!at_4096_) at_4096_.emplace(document_, sides_);
    if (const auto result = at_4096_->label(label)) return *result;
    throw NetGeometryError("labels[" + std::to_string(row) + "]: needs more than 4096 bits");
  }

 private:
  const certify::NetDocument& document_;
  const certify::SurfaceSides& sides_;
  Evaluator<Mp256> at_256_;
  std::optional<Evaluator<Mp1024>> at_1024_;
  std::optional<Evaluator<Mp4096>> at_4096_;
};

}  // namespace

certify::SurfaceDocument with_rounded_tiles(const certify::SurfaceDocument& surface) {
  if (!surface.tiles.empty()) return surface;
  const Surface regular = from_document(surface);
  certify::SurfaceDocument result;
  for (const Tile& tile : regular.tiles()) {
    certify::SurfaceDocument::Tile& copy = result.tiles.emplace_back();
    for (const Complex<Rational>& z : tile) copy.push_back(to_gmp(z));
  }
  for (const Gluing& g : regular.gluing()) result.gluing.push_back({g.tile, g.side, g.other_tile, g.other_side});
  return result;
}

std::optional<std::uint32_t> unpaired_dart(const certify::NetDocument& document) {
  for (std::uint32_t dart = 0; dart < 3 * document.triangles.size(); ++dart) {
    const std::uint32_t other = certify::opposite(document, dart);
    assert(other < 3 * document.triangles.size());
    if (other == dart || certify::opposite(document, other) != dart) return dart;
  }
  return std::nullopt;
}

template <class T>
double size_in_bits(const Isometry<T>& f) {
  const double size = std::sqrt(static_cast<double>(norm(f.a))) + std::sqrt(static_cast<double>(norm(f.b)));
  return std::isfinite(size) ? std::log2(size) : std::numeric_limits<double>::infinity();
}

template <class T>
Parts<T>::Parts(const certify::NetDocument& document, const certify::SurfaceSides& sides) {
  std::optional<Surface> irrational;
  if (document.surface.tiles.empty()) irrational = from_document(document.surface);
  for (std::uint32_t side = 0; side < sides.partner.size(); ++side) {
    if (irrational) {
      crossings.push_back(irrational->crossing_as<T>(SideId(side)));
      continue;
    }
    // The isometry takes side k, from p to q, to side j, from p' to q': p to q' and q to p'.
    const auto corner = [&](std::uint32_t s, std::uint32_t offset) {
      const certify::SurfaceDocument::Tile& corners = document.surface.tiles[sides.tile[s]];
      return rounded<T>(corners[(sides.corner[s] + offset) % corners.size()]);
    };
    const std::uint32_t other = sides.partner[side];
    crossings.push_back(
        normalized(segment_to_segment(corner(side, 0), corner(side, 1), corner(other, 1), corner(other, 0))));
  }
  for (const certify::NetDocument::Chart& chart : document.charts)
    frames.push_back(normalized(Isometry<T>::translation(rounded<T>(chart.centre))));
}

template struct Parts<Mp256>;
template struct Parts<Mp1024>;
template struct Parts<Mp4096>;
template double size_in_bits(const Isometry<Mp256>& f);
template double size_in_bits(const Isometry<Mp1024>& f);
template double size_in_bits(const Isometry<Mp4096>& f);

NetGeometry::NetGeometry(const certify::NetDocument& document)
    : document_(&checked(document)),
      sides_(std::make_shared<const certify::SurfaceSides>(document.surface)),
      genus_(genus_of(*sides_)),
      epsilon_(*certify::parse_decimal(document.epsilon)) {
  StagedEvaluator evaluator(document, *sides_);
  labels_.resize(document.labels.size() + 1);
  for (std::size_t row = 0; row < document.labels.size(); ++row)
    labels_[row + 1] = PreciseIsometry(evaluator.label(row));
}

std::array<Complex<double>, 3> NetGeometry::corners(std::uint32_t triangle) const {
  assert(triangle < document_->triangles.size());
  std::array<Complex<double>, 3> result;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const certify::NetDocument::Vertex& v = document_->vertices[document_->triangles[triangle].vertex[i]];
    const std::uint32_t number = certify::corner_label(*document_, 3 * triangle + i);
    result[i] = number == 0 ? Complex<double>{v.x, v.y} : labels_[number].rounded({v.x, v.y});
  }
  return result;
}

std::array<Complex<double>, 3> NetGeometry::centred_corners(std::uint32_t triangle) const {
  std::array<Complex<double>, 3> z = corners(triangle);
  const std::optional<Complex<double>> centre = circumcentre(z[0], z[1], z[2]);
  const Isometry<double> move = Isometry<double>::translation(-centre.value_or(z[0]));
  for (Complex<double>& corner : z) corner = move(corner);
  const double radius = std::sqrt(norm(z[0]));
  if (radius == 0) return z;
  const Complex<double> turn = (1 / radius) * conj(z[0]);
  for (Complex<double>& corner : z) corner = turn * corner;
  z[0] = {radius, 0};
  return z;
}

double NetGeometry::circumradius(std::uint32_t triangle) const {
  const auto z = corners(triangle);
  const auto sinh2 = sinh2_circumradius(z[0], z[1], z[2]);
  return sinh2.denominator > 0 ? std::asinh(std::sqrt(sinh2.numerator / sinh2.denominator))
                               : std::numeric_limits<double>::infinity();
}

double NetGeometry::edge_length(std::uint32_t dart) const {
  assert(dart < 3 * document_->triangles.size());
  const certify::NetDocument::Vertex& u = document_->vertices[certify::start(*document_, dart)];
  const certify::NetDocument::Vertex& v = document_->vertices[certify::start(*document_, certify::next_dart(dart))];
  const std::uint32_t at_u = certify::corner_label(*document_, dart);
  const std::uint32_t at_v = certify::corner_label(*document_, certify::next_dart(dart));
  if (at_u == at_v) return distance(Complex<double>{u.x, u.y}, Complex<double>{v.x, v.y});
  // More bits are used if the ends are in different charts, which may be far from each other.
  const Isometry<Mp256> label = inverse(labels_[at_u].precise) * labels_[at_v].precise;
  return static_cast<double>(distance(Complex<Mp256>{Mp256(u.x), Mp256(u.y)}, label({Mp256(v.x), Mp256(v.y)})));
}

std::string NetGeometry::epsilon_text() const {
  constexpr std::size_t kShort = 40;
  return document_->epsilon.size() <= kShort ? document_->epsilon : "about " + certify::shortest(epsilon_.get_d());
}

std::uint32_t PointLocation::nearest_corner() const {
  return static_cast<std::uint32_t>(std::min_element(distances.begin(), distances.end()) - distances.begin());
}

/// The triangulation of the net, and where to begin in it.
class Locator::Triangles {
 public:
  explicit Triangles(const certify::NetDocument& net) : net_(triangulation_of(net)), used_(net_.clone()) {
    starts_.resize(net_.surface().tiles().size());
    ById<ChartId, bool> seen(net_.atlas().charts().count());
    for (const TriangleId t : net_.triangles()) {
      const ChartId c = net_.chart_of(t);
      if (seen[c]) continue;
      seen[c] = true;
      const Chart& chart = net_.atlas().charts()[c];
      starts_[chart.tile].push_back({t, convert<double>(chart.centre)});
    }
  }

  PointLocation locate(const BasePoint& point);

 private:
  /// A triangle, and the centre of its chart.
  struct Start {
    TriangleId triangle;
    Complex<double> centre;
  };

  Triangulation net_;
  Triangulation used_;  ///< Gets a chart and labels for each point; replaced by a fresh copy when these are many.
  ById<TileId, std::vector<Start>> starts_;
};

Locator::Locator(const certify::NetDocument& net) : triangles_(std::make_unique<Triangles>(net)) {}
Locator::Locator(Locator&&) noexcept = default;
Locator& Locator::operator=(Locator&&) noexcept = default;
Locator::~Locator() = default;

PointLocation Locator::locate(const BasePoint& point) { return triangles_->locate(point); }

PointLocation Locator::Triangles::locate(const BasePoint& point) {
  const Surface& surface = net_.surface();
  require_on_surface(surface, point);
  constexpr std::uint32_t kMostLabels = 100'000;
  if (used_.atlas().labels().count() > net_.atlas().labels().count() + kMostLabels) used_ = net_.clone();

  TriangleId start(0);
  const Complex<double> z = convert<double>(point.z);
  if (const std::vector<Start>& starts = starts_[point.tile]; !starts.empty()) {
    start = std::min_element(starts.begin(), starts.end(), [&](const Start& a, const Start& b) {
              return sinh2_half_distance(a.centre, z) < sinh2_half_distance(b.centre, z);
            })->triangle;
  }
  const LiftedPoint lifted_point = used_.lifted_point(point, start);
  const Location location = epsnet::locate(used_, start, lifted_point, Walk::straight);

  const TriangleId t = triangle_of(location.dart);
  PointLocation result{};
  result.place = location.type == Location::Type::vertex ? PointLocation::Place::corner
                 : location.type == Location::Type::edge ? PointLocation::Place::side
                                                         : PointLocation::Place::inside;
  result.triangle = t.number();
  result.number = result.place == PointLocation::Place::inside ? 0 : corner_of(location.dart);
  // The path leads from the chart of the triangle to that of the start, and on to that of the point.
  const LabelId to_point = used_.product(used_.inverse(lifted_point.label), location.transition);
  if (to_point != kIdentity) result.word = reversed(surface, used_.atlas().labels()[to_point].word);
  // In the point's own chart it is at 0.
  std::array<Complex<Mp256>, 3> corner;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Corner lifted = used_.moved(to_point, used_.corner(t, i));
    corner[i] = used_.lift_in<Mp256>(lifted);
    result.distances[i] = static_cast<double>(distance(Complex<Mp256>{}, corner[i]));
  }
  // The point is (0, 0, 1) on the hyperboloid: the first two coordinates of the weighted corners cancel.
  std::array<Mp256, 3> weight;
  Mp256 sum(0);
  for (std::uint32_t i = 0; i < 3; ++i) {
    const auto a = on_hyperboloid(corner[(i + 1) % 3]);
    const auto b = on_hyperboloid(corner[(i + 2) % 3]);
    weight[i] = a.x * b.y - a.y * b.x;
    sum += weight[i];
  }
  for (std::uint32_t i = 0; i < 3; ++i) result.weights[i] = static_cast<double>(Mp256(weight[i] / sum));
  if (result.place == PointLocation::Place::corner) {
    result.weights = {};
    result.weights[result.number] = 1;
    result.distances[result.number] = 0;
  } else if (result.place == PointLocation::Place::side) {
    result.weights[(result.number + 2) % 3] = 0;
  }
  return result;
}

}  // namespace epsnet
