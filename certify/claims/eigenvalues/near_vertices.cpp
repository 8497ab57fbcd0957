#include "certify/claims/eigenvalues/near_vertices.h"

#include <utility>

#include "certify/base/text.h"
#include "certify/net/darts.h"

namespace epsnet::certify {
namespace {

BallIsometry product(const BallIsometry& f, const BallIsometry& g) { return compose(f, g, Precision::bits()); }

/// sinh²(d/2), d the distance of 0 and f(0).
Ball displacement(const BallIsometry& f) {
  Ball result;
  half_displacement_squared(result.get(), f, Precision::bits());
  return result;
}

/// From the disk of the vertex's chart to the one with the vertex in its centre.
BallIsometry to_centre(const NetDocument::Vertex& vertex) {
  const Ball x = Ball::exactly(vertex.x);
  const Ball y = Ball::exactly(vertex.y);
  const Ball scale = rsqrt(Ball::exactly(1) - sqr(x) - sqr(y));
  return {{scale, Ball()}, {-(scale * x), -(scale * y)}};
}

/// By vertex: the ends of its edges, as they are seen from it.
std::vector<std::vector<NearVertex>> neighbours(const NetDocument& net, const std::vector<BallIsometry>& labels) {
  std::vector<BallIsometry> frames;
  for (const NetDocument::Vertex& vertex : net.vertices) frames.push_back(to_centre(vertex));
  // From the disk around the start of a dart to the chart of its triangle.
  const auto placed = [&](std::uint32_t dart) {
    const std::uint32_t label = corner_label(net, dart);
    const BallIsometry from = inverse(looked_up(frames, start(net, dart), "there is no vertex"));
    return label == 0 ? from : product(looked_up(labels, label - 1, "there is no label"), from);
  };
  std::vector<std::vector<NearVertex>> result(net.vertices.size());
  for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); ++dart) {
    const std::uint32_t next = next_dart(dart);
    result[start(net, dart)].push_back({start(net, next), product(inverse(placed(dart)), placed(next)), {}});
  }
  return result;
}

}  // namespace

std::optional<std::vector<std::vector<NearVertex>>> near_vertices(const GeodesicsDocument& spectrum,
                                                                  const std::vector<BallIsometry>& labels,
                                                                  const Ball& distance, const Budget& budget) {
  const NetDocument& net = spectrum.net;
  const std::uint64_t work = 40 * ball_work(static_cast<std::uint64_t>(Precision::bits()));
  budget.spend(10 * work, net.triangles.size());
  const auto edges = neighbours(net, labels);
  const Ball systole = spectrum.geodesics.empty() ? Ball::rounded(decimal(spectrum.up_to))
                                                  : Ball::exactly(spectrum.geodesics.front().length.lower);
  const Ball near = sqr(sinh(half(distance)));
  const Ball far = sqr(sinh(half(distance) + Ball::rounded(decimal(net.epsilon))));
  const Ball shortest = sqr(sinh(half(systole)));
  std::vector<std::vector<NearVertex>> result(net.vertices.size());
  for (std::uint32_t centre = 0; centre < net.vertices.size(); ++centre) {
    std::vector<NearVertex> found{{centre, identity_isometry(), {}}};
    std::vector<std::vector<std::size_t>> of_vertex(net.vertices.size());  // Their numbers.
    of_vertex[centre].push_back(0);
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (const NearVertex& edge : edges[found[i].vertex]) {
        auto& others = of_vertex[edge.vertex];
        budget.spend(work, others.size() + 1);
        BallIsometry isometry = product(found[i].isometry, edge.isometry);
        const Ball sinh_squared = displacement(isometry);
        if (certainly_less(far, sinh_squared) == Tri::yes) continue;
        bool known = false;
        for (const std::size_t other : others) {
          // Two lifts of one vertex are the same, or at least as far from each other as a closed geodesic is long.
          const Ball apart = displacement(product(inverse(found[other].isometry), isometry));
          known = certainly_less(apart, shortest) == Tri::yes;
          if (known) break;
          if (certainly_positive(apart) != Tri::yes) return std::nullopt;
        }
        if (known) continue;
        budget.spend(memory_work(500));
        others.push_back(found.size());
        found.push_back({edge.vertex, std::move(isometry), sinh_squared});
      }
    }
    for (std::size_t i = 1; i < found.size(); ++i) {
      if (certainly_less(found[i].sinh_squared, near) != Tri::no) result[centre].push_back(std::move(found[i]));
    }
  }
  return result;
}

}  // namespace epsnet::certify
