#include "certify/claims/curves/crossings.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace epsnet::certify {
namespace {

/// Crossing points of one geodesic that follow each other and that balls cannot tell apart.
struct Passage {
  std::uint32_t geodesic;
  std::vector<const CrossingPoint*> points;
  std::size_t next = 0;  ///< The passage after it on the geodesic.
};

/// The graph of the geodesics, drawn on the surface: passages that cross each other are a vertex. An *end* is a passage
/// as it leaves its vertex, 2i + 1, or as it comes to it, 2i.
class CrossingGraph {
 public:
  CrossingGraph(const LiftedPlane& plane, const std::vector<std::vector<CrossingPoint>>& points,
                std::span<const std::uint32_t> geodesics)
      : plane_(plane), points_(points), is_in_(points.size()), passage_of_(points.size()) {
    plane_.spend(1, points.size());
    for (const std::uint32_t geodesic : geodesics) is_in_[geodesic] = true;
    for (const std::uint32_t geodesic : geodesics) add_passages(geodesic);
    after_.resize(2 * passages_.size());
    known_ = add_vertices();
  }

  [[nodiscard]] bool known() const { return known_; }
  /// That of a neighbourhood of the geodesics.
  [[nodiscard]] std::int64_t euler() const {
    return static_cast<std::int64_t>(vertices_) - static_cast<std::int64_t>(passages_.size());
  }

  /// The number of closed curves that bound it.
  [[nodiscard]] std::int64_t boundaries() const {
    std::vector<std::size_t> across(after_.size());
    for (std::size_t i = 0; i < passages_.size(); ++i) {
      across[2 * i + 1] = 2 * passages_[i].next;
      across[2 * passages_[i].next] = 2 * i + 1;
    }
    std::int64_t result = 2 * circles_;
    std::vector<bool> seen(after_.size());
    for (std::size_t first = 0; first < seen.size(); ++first) {
      if (seen[first]) continue;
      ++result;
      for (std::size_t end = first; !seen[end]; end = after_[across[end]]) seen[end] = true;
    }
    return result;
  }

 private:
  /// Those of one geodesic, in order.
  void add_passages(std::uint32_t geodesic) {
    std::vector<const CrossingPoint*> sorted;
    plane_.spend(10, points_[geodesic].size());
    for (const CrossingPoint& point : points_[geodesic]) {
      if (is_in_[point.other]) sorted.push_back(&point);
    }
    passage_of_[geodesic].resize(points_[geodesic].size());
    if (sorted.empty()) {
      ++circles_;
      return;
    }
    std::sort(sorted.begin(), sorted.end(), [](const CrossingPoint* x, const CrossingPoint* y) {
      if (x->chord != y->chord) return x->chord < y->chord;
      return arf_cmp(arb_midref(x->along.get()), arb_midref(y->along.get())) < 0;
    });
    // From the least of those from k on in one chord.
    std::vector<Ball> least(sorted.size());
    for (std::size_t k = sorted.size(); k-- > 0;) {
      const bool is_last = k + 1 == sorted.size() || sorted[k + 1]->chord != sorted[k]->chord;
      least[k] = is_last ? sorted[k]->along : min(sorted[k]->along, least[k + 1]);
    }
    const std::size_t first = passages_.size();
    Ball greatest;
    for (std::size_t k = 0; k < sorted.size(); ++k) {
      const bool is_same_chord = k > 0 && sorted[k]->chord == sorted[k - 1]->chord;
      if (!is_same_chord || certainly_less(greatest, least[k]) == Tri::yes) {
        passages_.push_back({geodesic, {}});
        greatest = sorted[k]->along;
      } else {
        greatest = max(greatest, sorted[k]->along);
      }
      passages_.back().points.push_back(sorted[k]);
      passage_of_[geodesic][number_of(geodesic, sorted[k])] = passages_.size() - 1;
    }
    for (std::size_t i = first; i < passages_.size(); ++i) passages_[i].next = i + 1 < passages_.size() ? i + 1 : first;
  }

  [[nodiscard]] std::size_t number_of(std::uint32_t geodesic, const CrossingPoint* point) const {
    return static_cast<std::size_t>(point - points_[geodesic].data());
  }

  /// The passage of the other geodesic.
  [[nodiscard]] std::size_t other_passage(const CrossingPoint& point) const {
    return passage_of_[point.other][point.place];
  }

  /// False if some of the passages that points join do not cross each other.
  [[nodiscard]] bool add_vertices() {
    std::vector<bool> seen(passages_.size());
    for (std::size_t first = 0; first < passages_.size(); ++first) {
      if (seen[first]) continue;
      std::vector<std::size_t> joined{first};
      seen[first] = true;
      for (std::size_t i = 0; i < joined.size(); ++i) {
        for (const CrossingPoint* point : passages_[joined[i]].points) {
          const std::size_t other = other_passage(*point);
          if (seen[other]) continue;
          seen[other] = true;
          joined.push_back(other);
        }
      }
      // Two passages cross once, so each crosses all others if their number is right.
      if (std::any_of(joined.begin(), joined.end(),
                      [&](std::size_t i) { return passages_[i].points.size() + 1 != joined.size(); })) {
        return false;
      }
      ++vertices_;
      add_vertex(joined);
    }
    return true;
  }

  /// The ends counterclockwise: that which leaves along the first passage; on its left, an end of each of the others,
  /// in the order in which each is on the left of those before; the first passage as it comes; the other ends.
  void add_vertex(const std::vector<std::size_t>& joined) {
    plane_.spend(1, joined.size() * joined.size());
    const std::size_t first = joined.front();
    std::map<std::size_t, int> turn_of;  // By other passage: 1 if it leaves on the left of the first one.
    for (const CrossingPoint* point : passages_[first].points) turn_of[other_passage(*point)] = point->turn;
    std::vector<std::size_t> left(joined.size() - 1);  // The ends on the left.
    for (const auto& [passage, turn] : turn_of) {
      // How many of the others come before it.
      std::size_t before = 0;
      for (const CrossingPoint* point : passages_[passage].points) {
        const std::size_t other = other_passage(*point);
        if (other != first && turn * turn_of.at(other) * point->turn < 0) ++before;
      }
      left[before] = 2 * passage + (turn > 0 ? 1 : 0);
    }
    std::vector<std::size_t> around{2 * first + 1};
    around.insert(around.end(), left.begin(), left.end());
    const std::size_t half = around.size();
    for (std::size_t k = 0; k < half; ++k) around.push_back(around[k] ^ 1U);
    for (std::size_t k = 0; k < around.size(); ++k) after_[around[k]] = around[(k + 1) % around.size()];
  }

  const LiftedPlane& plane_;
  const std::vector<std::vector<CrossingPoint>>& points_;
  std::vector<bool> is_in_;                           ///< By geodesic.
  std::vector<std::vector<std::size_t>> passage_of_;  ///< By geodesic and point.
  std::vector<Passage> passages_;
  std::vector<std::size_t> after_;  ///< By end: the next one counterclockwise.
  std::int64_t circles_ = 0;        ///< Geodesics that cross none, nor themselves.
  std::size_t vertices_ = 0;
  bool known_ = false;
};

}  // namespace

CrossingNumbers crossing_numbers(const LiftedPlane& plane, const std::vector<std::vector<CrossingPoint>>& points) {
  const std::size_t count = points.size();
  plane.keep(1, count * count);
  CrossingNumbers result{std::vector(count, std::vector<std::uint64_t>(count)),
                         std::vector(count, std::vector<std::int64_t>(count))};
  for (std::size_t i = 0; i < count; ++i) {
    plane.spend(1, points[i].size());
    for (const CrossingPoint& point : points[i]) {
      ++result.points[i][point.other];
      result.signs[i][point.other] += point.turn;
    }
  }
  return result;
}

std::optional<bool> fill(const LiftedPlane& plane, const std::vector<std::vector<CrossingPoint>>& points,
                         std::span<const std::uint32_t> geodesics, std::int64_t euler) {
  const CrossingGraph graph(plane, points, geodesics);
  if (!graph.known()) return std::nullopt;
  return graph.euler() + graph.boundaries() == euler;
}

}  // namespace epsnet::certify
