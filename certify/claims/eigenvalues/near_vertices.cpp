#include "certify/claims/eigenvalues/near_vertices.h"

#include <iterator>
#include <map>
#include <utility>

#include "certify/base/text.h"
#include "certify/net/darts.h"
#include "certify/numbers/parallel.h"

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

/// The lifts around one vertex.
class Neighbourhood {
 public:
  Neighbourhood(const std::vector<std::vector<NearVertex>>& edges, const Ball& shortest, const Ball& near,
                const Ball& far, const Budget& budget)
      : edges_(edges), shortest_(shortest), near_(near), far_(far), budget_(budget) {}

  [[nodiscard]] std::optional<std::vector<NearVertex>> around(std::uint32_t centre) const {
    const std::uint64_t work = 40 * ball_work(static_cast<std::uint64_t>(Precision::bits()));
    std::vector<NearVertex> found{{centre, identity_isometry(), {}}};
    std::multimap<std::uint32_t, std::size_t> of_vertex{{centre, 0}};  // Their numbers.
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (const NearVertex& edge : edges_[found[i].vertex]) {
        const auto [first, last] = of_vertex.equal_range(edge.vertex);
        budget_.spend(work, static_cast<std::uint64_t>(std::distance(first, last)) + 1);
        BallIsometry isometry = product(found[i].isometry, edge.isometry);
        const Ball sinh_squared = displacement(isometry);
        if (certainly_less(far_, sinh_squared) == Tri::yes) continue;
        bool known = false;
        for (auto other = first; other != last && !known; ++other) {
          // Two lifts are the same, or at least as far from each other as the shortest edge is long.
          const Ball apart = displacement(product(inverse(found[other->second].isometry), isometry));
          known = certainly_less(apart, shortest_) == Tri::yes;
          if (!known && certainly_positive(apart) != Tri::yes) return std::nullopt;
        }
        if (known) continue;
        budget_.spend(memory_work(500));
        of_vertex.emplace(edge.vertex, found.size());
        found.push_back({edge.vertex, std::move(isometry), sinh_squared});
      }
    }
    std::vector<NearVertex> result;
    for (std::size_t i = 1; i < found.size(); ++i) {
      if (certainly_less(found[i].sinh_squared, near_) != Tri::no) result.push_back(std::move(found[i]));
    }
    return result;
  }

 private:
  const std::vector<std::vector<NearVertex>>& edges_;
  const Ball& shortest_;
  const Ball& near_;
  const Ball& far_;
  const Budget& budget_;
};

}  // namespace

std::optional<std::vector<std::vector<NearVertex>>> near_vertices(const NetDocument& net,
                                                                  const std::vector<BallIsometry>& labels,
                                                                  const Ball& distance, const Budget& budget,
                                                                  unsigned threads) {
  budget.spend(400 * ball_work(static_cast<std::uint64_t>(Precision::bits())), net.triangles.size());
  const auto edges = neighbours(net, labels);
  const Ball near = sqr(sinh(half(distance)));
  const Ball far = sqr(sinh(half(distance) + Ball::rounded(decimal(net.epsilon))));
  Ball shortest = far;
  for (const auto& ends : edges) {
    for (const NearVertex& end : ends) shortest = min(shortest, displacement(end.isometry));
  }
  const Neighbourhood neighbourhood(edges, shortest, near, far, budget);
  std::vector<std::optional<std::vector<NearVertex>>> found(net.vertices.size());
  for_each_parallel(found.size(), threads, [&](unsigned, std::size_t vertex) {
    found[vertex] = neighbourhood.around(static_cast<std::uint32_t>(vertex));
  });
  std::vector<std::vector<NearVertex>> result;
  for (auto& lifts : found) {
    if (!lifts) return std::nullopt;
    result.push_back(*std::move(lifts));
  }
  return result;
}

}  // namespace epsnet::certify
