#include "certify/claims/geodesics/cut_surface.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "certify/net/numbering.h"

namespace epsnet::certify {
namespace {

/// Where a geodesic separates a corner of a triangle from the other two.
struct Arc {
  std::uint32_t geodesic;
  bool corner_is_left;
  Ball distance;  ///< sinh of that of the corner from the geodesic.
};

/// Sets of numbers that are joined.
class Partition {
 public:
  explicit Partition(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::size_t find(std::size_t x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  void join(std::size_t x, std::size_t y) { parent_[std::max(find(x), find(y))] = std::min(find(x), find(y)); }

 private:
  std::vector<std::size_t> parent_;
};

class Cutter {
 public:
  Cutter(const MovedNet& net, const std::vector<AxisCrossings>& geodesics)
      : moved_(net), net_(net.plane().net()), geodesics_(geodesics), arcs_(3 * net_.triangles.size()) {}

  std::optional<std::vector<GeodesicsDocument::Piece>> run() {
    for (std::uint32_t i = 0; i < geodesics_.size(); ++i) add_arcs(i);
    // Arcs are disjoint: one that lies between another and the corner is nearer to it.
    for (std::vector<Arc>& arcs : arcs_) {
      if (!sort_certainly(arcs, [](const Arc& arc) -> const Ball& { return arc.distance; })) return std::nullopt;
    }
    number_cells();
    return pieces();
  }

 private:
  /// Between two darts that follow each other a geodesic cuts off the corner that they have in common.
  void add_arcs(std::uint32_t geodesic) {
    const auto& [darts, axes] = geodesics_[geodesic];
    moved_.plane().spend(10, darts.size());
    for (std::size_t k = 0; k < darts.size(); ++k) {
      const std::uint32_t entry = opposite(net_, darts[k == 0 ? darts.size() - 1 : k - 1]);
      // Darts are crossed with their starts on the right.
      const bool corner_is_left = darts[k] != next_dart(entry);
      const std::uint32_t corner = corner_is_left ? entry : darts[k];
      Ball distance;
      dot(distance, axes[k], moved_.corner(corner), moved_.plane().precision());
      arcs_[corner].push_back({geodesic, corner_is_left, abs(std::move(distance))});
    }
  }

  /// Cells of triangle t: the central one, then those around corner 0 outward from it, then corner 1, corner 2.
  void number_cells() {
    for (std::uint32_t t = 0; t < net_.triangles.size(); ++t) {
      central_.push_back(cells_++);
      for (std::uint32_t i = 0; i < 3; ++i) {
        around_.push_back(cells_);
        cells_ += arcs_[3 * t + i].size();
      }
    }
  }

  /// The cell that is number `k` from the corner where the dart starts.
  [[nodiscard]] std::size_t cell(std::uint32_t dart, std::size_t k) const {
    return k < arcs_[dart].size() ? around_[dart] + k : central_[dart / 3];
  }

  /// The cell at segment k of the dart's edge, counted from where it starts.
  [[nodiscard]] std::size_t cell_at(std::uint32_t dart, std::size_t k) const {
    const std::size_t here = arcs_[dart].size();
    return k <= here ? cell(dart, k) : cell(next_dart(dart), segments(dart) - 1 - k);
  }

  [[nodiscard]] std::size_t segments(std::uint32_t dart) const {
    return arcs_[dart].size() + arcs_[next_dart(dart)].size() + 1;
  }

  std::optional<std::vector<GeodesicsDocument::Piece>> pieces() {
    Partition partition(cells_);
    for (std::uint32_t dart = 0; dart < arcs_.size(); ++dart) {
      const std::uint32_t other = opposite(net_, dart);
      const std::size_t count = segments(dart);
      // Never, if all sides and orders are certain: then the arcs of two triangles fit across their edge.
      if (segments(other) != count) return std::nullopt;
      for (std::size_t k = 0; k < count; ++k) partition.join(cell_at(dart, k), cell_at(other, count - 1 - k));
    }
    // χ of each component: vertices − segments of edges + cells, all open.
    std::map<std::size_t, long> euler;
    for (std::size_t c = 0; c < cells_; ++c) ++euler[partition.find(c)];
    for (const std::uint32_t dart : first_darts(net_)) ++euler[partition.find(cell_at(dart, 0))];
    for (std::uint32_t dart = 0; dart < arcs_.size(); ++dart) {
      if (opposite(net_, dart) < dart) continue;
      for (std::size_t k = 0; k < segments(dart); ++k) --euler[partition.find(cell_at(dart, k))];
    }
    return components(partition, euler);
  }

  std::optional<std::vector<GeodesicsDocument::Piece>> components(Partition& partition,
                                                                  const std::map<std::size_t, long>& euler) const {
    std::map<std::size_t, GeodesicsDocument::Piece> by_root;
    for (const auto& [root, unused] : euler) by_root[root];
    std::vector<std::size_t> component(2 * geodesics_.size(), cells_);
    for (std::uint32_t dart = 0; dart < arcs_.size(); ++dart) {
      for (std::size_t k = 0; k < arcs_[dart].size(); ++k) {
        const Arc& arc = arcs_[dart][k];
        const std::size_t inner = partition.find(cell(dart, k));
        const std::size_t outer = partition.find(cell(dart, k + 1));
        for (const std::uint32_t side : {0U, 1U}) {
          const std::size_t found = arc.corner_is_left == (side == 0) ? inner : outer;
          std::size_t& known = component[2 * std::size_t{arc.geodesic} + side];
          if (known == cells_) by_root[found].boundaries.emplace_back(arc.geodesic, side);
          // Never, if all sides and orders are certain: a side of a geodesic is in one component.
          if (known != cells_ && known != found) return std::nullopt;
          known = found;
        }
      }
    }
    std::vector<GeodesicsDocument::Piece> result;
    for (auto& [root, piece] : by_root) {
      const long twice_genus = 2 - euler.at(root) - static_cast<long>(piece.boundaries.size());
      if (twice_genus < 0 || twice_genus % 2 != 0) return std::nullopt;
      piece.genus = static_cast<std::uint32_t>(twice_genus / 2);
      std::sort(piece.boundaries.begin(), piece.boundaries.end());
      result.push_back(std::move(piece));
    }
    return result;
  }

  const MovedNet& moved_;
  const NetDocument& net_;
  const std::vector<AxisCrossings>& geodesics_;
  std::vector<std::vector<Arc>> arcs_;  ///< By dart: those around the corner where it starts.
  std::vector<std::size_t> central_;    ///< By triangle.
  std::vector<std::size_t> around_;     ///< By dart: the first cell around its corner.
  std::size_t cells_ = 0;
};

}  // namespace

std::optional<std::vector<GeodesicsDocument::Piece>> cut_surface(const MovedNet& net,
                                                                 const std::vector<AxisCrossings>& geodesics) {
  return Cutter(net, geodesics).run();
}

}  // namespace epsnet::certify
