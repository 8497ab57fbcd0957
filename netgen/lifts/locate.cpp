#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/lorentz.h"
#include "kernel/plane.h"
#include "netgen/lifts/lifts.h"
#include "netgen/nets/net_document.h"
#include "triangulation/mesh/operations.h"
#include "triangulation/mesh/triangulation.h"
#include "triangulation/surface/points.h"

namespace epsnet {

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
