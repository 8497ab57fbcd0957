#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <queue>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "certify/numbers/parallel.h"
#include "netgen/distances/distances.h"
#include "netgen/distances/vertex_triangulation.h"
#include "netgen/isometries/fundamental_domain.h"
#include "netgen/isometries/isometries.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "netgen/nets/triangulations.h"
#include "netgen/prove/certified.h"

namespace epsnet {
namespace {

using certify::BoundDocument;

/// Returns the length whose sinh² is s.
double length_of(double s) { return std::asinh(std::sqrt(s)); }

using Number = EdgeElements::Number;
using Point = LorentzVector<Number>;

/// The most edges of all triangulations, different elements of the group: some 2 GB. Where the genus is large, few
/// triangulations have so many.
constexpr std::size_t kMostElements = 1'000'000;

Point unit(const Point& p) { return Number(Number(1) / sqrt(Number(-lorentz_product(p, p)))) * p; }

Point centre_of(const PlacedTriangle& triangle) {
  return unit(triangle.corner[0] + triangle.corner[1] + triangle.corner[2]);
}

/// Whether the greatest value is sought, or compared with that at the vertex of the base.
enum class Climb { yes, no };

/// What one search is for.
struct Goal {
  BoundDocument::Claim claim;
  Climb climb;
  double width;
};

/// The triangulations of a document, each of all parts once.
class Triangulations {
 public:
  using Rows = std::vector<BoundDocument::Triangulation>;

  /// The number of what flips make of the triangulation of number `parent`. Equal means dart by dart.
  std::uint32_t add(std::uint32_t parent, const std::vector<std::uint32_t>& flips, const VertexTriangulation& map,
                    const EdgeElements& elements) {
    std::vector<std::uint32_t> key;
    for (const EdgeElements::Id id : map.element) key.push_back(elements_.add(elements.isometry(id)));
    const auto next = static_cast<std::uint32_t>(rows_.size()) + 1;
    const auto [found, is_new] = numbers_.try_emplace(std::move(key), next);
    if (is_new) rows_.push_back({parent, flips});
    return found->second;
  }
  [[nodiscard]] Rows take() { return std::move(rows_); }

 private:
  EdgeElements elements_;
  std::map<std::vector<std::uint32_t>, std::uint32_t> numbers_;
  Rows rows_;
};

/// A place of the vertex, with the numbers of a triangulation that is Delaunay there and of a frame nearby.
struct Site {
  Point point;
  std::uint32_t triangulation;
  std::uint32_t frame;
};

/// Triangulations with one vertex that are Delaunay at places of it, each made from an earlier one by flips.
class Sites {
 public:
  /// Starts at the vertex of the base, which is Delaunay.
  explicit Sites(Triangulation& base) {
    known_.push_back({vertex_triangulation(base, elements_), 0, {}});
    start_at(on_hyperboloid(convert<Number>(base.vertex(VertexId(0)).z)));
  }
  /// Starts at one of the sites of another, with elements of its own.
  Sites(const Sites& other, const Site& site) {
    VertexTriangulation map = other.known_[site.triangulation].map;
    for (EdgeElements::Id& id : map.element) id = elements_.add(other.elements_.isometry(id));
    known_.push_back({std::move(map), 0, {}});
    start_at(site.point);
  }
  Sites(const Sites&) = delete;
  Sites& operator=(const Sites&) = delete;

  [[nodiscard]] Site start() const { return {start_, 0, 0}; }
  [[nodiscard]] EdgeElements& elements() { return elements_; }
  [[nodiscard]] const EdgeElements& elements() const { return elements_; }
  [[nodiscard]] const VertexTriangulation& map(std::uint32_t k) const { return known_[k].map; }
  [[nodiscard]] std::size_t size() const { return known_.size(); }

  [[nodiscard]] PlacedTriangulation placed(std::uint32_t k, std::uint32_t frame, const Point& p) {
    return {known_[k].map, frames_[frame], p};
  }

  /// Returns the frame to use at a point: the given one, or a new one if that is far away.
  [[nodiscard]] std::uint32_t frame_at(std::uint32_t frame, const Point& p) {
    constexpr double kFar = 1.5;  // cosh of the distance.
    if (frames_[frame].cosh_distance(p) <= kFar) return frame;
    for (std::uint32_t f = 0; f < frames_.size(); ++f) {
      if (frames_[f].cosh_distance(p) <= kFar) return f;
    }
    frames_.emplace_back(elements_, unit(p));
    return static_cast<std::uint32_t>(frames_.size()) - 1;
  }

  /// Returns the site with the vertex moved along a line. It moves as far as the triangles stay counterclockwise, the
  /// triangulation is made Delaunay again, and so on. Returns nullopt if that takes too many steps or flips, as may
  /// happen where closed curves are short.
  [[nodiscard]] std::optional<Site> moved(const Site& from, const Point& to) {
    Site here = from;
    std::vector<Point> way{to};
    constexpr std::size_t kMostHalvings = 1000;
    for (std::size_t halvings = 0; !way.empty();) {
      const std::uint32_t frame = frame_at(here.frame, way.back());
      if (placed(here.triangulation, frame, way.back()).counterclockwise()) {
        const std::optional<std::uint32_t> there = delaunay(here.triangulation, frame, way.back());
        if (!there) return std::nullopt;
        here = {way.back(), *there, frame};
        way.pop_back();
      } else if (++halvings > kMostHalvings) {
        return std::nullopt;
      } else {
        way.push_back(unit(here.point + unit(way.back())));
      }
    }
    return here;
  }

  /// Adds the triangulations of these numbers and those that they are made from, of which number 0 is known as `first`.
  /// Returns all numbers there.
  [[nodiscard]] std::vector<std::uint32_t> describe(const std::vector<std::uint32_t>& used, std::uint32_t first,
                                                    Triangulations& triangulations) const {
    std::vector<bool> is_used(known_.size());
    for (std::uint32_t k : used) {
      for (; !is_used[k]; k = known_[k].parent) is_used[k] = true;
    }
    std::vector<std::uint32_t> number(known_.size());
    number[0] = first;
    for (std::uint32_t k = 1; k < known_.size(); ++k) {
      if (is_used[k])
        number[k] = triangulations.add(number[known_[k].parent], known_[k].flips, known_[k].map, elements_);
    }
    return number;
  }

 private:
  struct Known {
    VertexTriangulation map;
    std::uint32_t parent;
    std::vector<std::uint32_t> flips;
  };

  void start_at(const Point& point) {
    start_ = point;
    numbers_[known_[0].map.key()] = 0;
    frames_.emplace_back(elements_, point);
  }

  /// Makes a triangulation Delaunay at a point by flips; returns the number of the result.
  [[nodiscard]] std::optional<std::uint32_t> delaunay(std::uint32_t k, std::uint32_t frame, const Point& p) {
    std::vector<std::uint32_t> flips = placed(k, frame, p).flips();
    if (flips.empty()) return k;
    Known next{known_[k].map, k, {}};
    constexpr std::size_t kMostFlips = 5000;
    for (; !flips.empty(); flips = PlacedTriangulation(next.map, frames_[frame], p).flips()) {
      for (const std::uint32_t d : flips) next.map.flip(elements_, d);
      next.flips.insert(next.flips.end(), flips.begin(), flips.end());
      if (next.flips.size() > kMostFlips) return std::nullopt;
    }
    const auto [found, is_new] = numbers_.try_emplace(next.map.key(), static_cast<std::uint32_t>(known_.size()));
    if (is_new) known_.push_back(std::move(next));
    return found->second;
  }

  Point start_{};
  EdgeElements elements_;
  std::deque<Frame> frames_;
  std::vector<Known> known_;
  std::map<std::vector<std::uint32_t>, std::uint32_t> numbers_;  ///< By key.
};

/// The function at a site, for a radius minus it.
double value_at(BoundDocument::Claim claim, Sites& sites, const Site& site) {
  const PlacedTriangulation there = sites.placed(site.triangulation, site.frame, site.point);
  switch (claim) {
    case BoundDocument::Claim::diameter:
      return length_of(there.largest_enclosure());
    case BoundDocument::Claim::radius:
      return -length_of(there.largest_enclosure());
    case BoundDocument::Claim::embedded_disk:
      break;
  }
  return length_of(there.shortest_edge());
}

/// The part of a search that one triangle is: it is cut into cells.
///
/// The function is evaluated at points of cells, where the Delaunay triangulation gives it exactly. Two triangulations
/// bound it at the corners of a cell, that of the cell's own point and that of the cell it was cut from; the better one
/// is the bound of the cell. For a radius the bound is the function at the midpoint of a side plus the distance from
/// there to the farthest corner.
class PartSearch {
 public:
  using Claim = BoundDocument::Claim;

  /// The triangle, and a site near it.
  PartSearch(const PlacedTriangle& triangle, const Sites& sites, const Site& near, const Goal& goal)
      : goal_(goal), sites_(sites, near) {
    add_cell({triangle}, sites_.start());
  }

  /// Cuts up to `most` of its cells, those with the greatest bounds first, whose bounds are at least `level` and too
  /// great.
  void cut_above(double level, std::size_t most) {
    for (; most > 0 && upper() >= level && !is_narrow(); --most) {
      const std::uint32_t top = queue_.top().second;
      queue_.pop();
      cut(top);
    }
  }

  /// Whether the bounds of its cells are as near to the greatest value as wanted.
  [[nodiscard]] bool is_narrow() const {
    // The lower bound of a radius must be positive.
    constexpr double kLeastRadius = 1e-3;
    return upper() - highest_ <= goal_.width && (goal_.claim != Claim::radius || upper() <= -kLeastRadius);
  }
  /// Tells it of a value that was found elsewhere.
  void raise(double value) {
    if (value > highest_) highest_ = value;
  }
  [[nodiscard]] double lower() const { return highest_; }
  [[nodiscard]] double upper() const { return queue_.top().first; }
  [[nodiscard]] std::size_t cells() const { return cells_.size(); }
  [[nodiscard]] std::size_t elements() const { return sites_.elements().size(); }
  /// The greatest value that it found itself, and where, in the chart of the base's vertex.
  [[nodiscard]] double found() const { return found_; }
  [[nodiscard]] const Point& summit() const { return summit_; }

  /// Its cells, and the triangulations that they use, of which the first is known as `first`.
  [[nodiscard]] std::vector<std::uint32_t> describe(std::uint32_t first, Triangulations& triangulations) const {
    std::vector<std::uint32_t> used;
    for (const Cell& cell : cells_) {
      if (cell.edge == kNotCut) used.push_back(cell.bound_by);
    }
    const std::vector<std::uint32_t> number = sites_.describe(used, first, triangulations);
    const auto darts = static_cast<std::uint32_t>(sites_.map(0).opposite.size());
    std::vector<std::uint32_t> cells;
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
      const Cell& cell = cells_[open.back()];
      open.pop_back();
      if (cell.edge != kNotCut) {
        cells.push_back(cell.edge);
        open.push_back(cell.first_part + 1);
        open.push_back(cell.first_part);
      } else {
        const std::uint32_t of_each = goal_.claim == Claim::diameter ? 1 : goal_.claim == Claim::radius ? 3 : darts;
        cells.push_back(3 + number[cell.bound_by] * of_each + cell.bound_by_part);
      }
    }
    return cells;
  }

 private:
  struct Bound {
    double value;
    std::uint32_t dart;  ///< For an embedded disk, the dart of the edge.
  };
  /// The midpoint of a side, the cosh of half its length and of the median.
  struct Midpoint {
    Point point;
    Number half;
    Number median;
  };
  static constexpr std::uint32_t kNotCut = 3;
  struct Place : PlacedTriangle {
    [[nodiscard]] std::uint32_t longest_side() const {
      return static_cast<std::uint32_t>(std::max_element(cosh.begin(), cosh.end()) - cosh.begin());
    }
    [[nodiscard]] Midpoint midpoint(std::uint32_t side) const {
      const std::uint32_t end = (side + 1) % 3;
      // With d the length of the side: cosh(d/2), the midpoint, and the cosh of the median.
      const Number half = sqrt(Number((1 + cosh[side]) / 2));
      const Number scale = 1 / (2 * half);
      return {scale * (corner[side] + corner[end]), half, scale * (cosh[end] + cosh[(side + 2) % 3])};
    }
  };
  struct Cell {
    Place place;
    Site site;                        ///< A point inside.
    std::uint32_t bound_by = 0;       ///< The triangulation that bounds the function in the cell.
    std::uint32_t bound_by_part = 0;  ///< The dart of the edge, for an embedded disk; the side, for a radius.
    std::uint32_t edge = kNotCut;     ///< The edge at which it is cut.
    std::uint32_t first_part = 0;     ///< The number of its first part; the second follows.
  };

  /// Evaluates the function at a point where the triangulation is Delaunay.
  void look_at(const Site& site) {
    const double value = value_at(goal_.claim, sites_, site);
    if (goal_.climb == Climb::yes) raise(value);
    if (value <= found_) return;
    found_ = value;
    summit_ = site.point;
  }

  [[nodiscard]] Bound bound(const Place& place, std::uint32_t frame, std::uint32_t k) {
    const std::array<PlacedTriangulation, 3> at{sites_.placed(k, frame, place.corner[0]),
                                                sites_.placed(k, frame, place.corner[1]),
                                                sites_.placed(k, frame, place.corner[2])};
    if (goal_.claim == Claim::diameter) {
      double most = 0;
      for (const PlacedTriangulation& corner : at) most = std::max(most, corner.largest_enclosure());
      return {length_of(most), 0};
    }
    Bound least{std::numeric_limits<double>::infinity(), 0};
    for (std::uint32_t d = 0; d < sites_.map(k).opposite.size(); ++d) {
      const double most = std::max({at[0].displacement(d), at[1].displacement(d), at[2].displacement(d)});
      const double value = length_of(most);
      if (value < least.value) least = {value, d};
    }
    return least;
  }

  /// Bounds minus the eccentricity, from the midpoint of the longest side at which nothing is nearly a tie.
  void add_cell_of_radius(Place place, const Site& near) {
    Cell cell{.place = std::move(place), .site = near};
    double bound = std::numeric_limits<double>::infinity();
    std::array<std::uint32_t, 3> sides{0, 1, 2};
    std::sort(sides.begin(), sides.end(),
              [&](std::uint32_t i, std::uint32_t k) { return cell.place.cosh[i] > cell.place.cosh[k]; });
    for (const std::uint32_t side : sides) {
      const Midpoint middle = cell.place.midpoint(side);
      const std::optional<Site> site = sites_.moved(near, middle.point);
      if (!site) continue;
      const PlacedTriangulation there = sites_.placed(site->triangulation, site->frame, site->point);
      look_at(*site);
      if (!there.is_strictly_delaunay()) continue;
      // sinh²(d/2) of the distance to the farthest corner.
      const auto farthest = static_cast<double>(Number((std::max(middle.half, middle.median) - 1) / 2));
      bound = 2 * length_of(farthest) - length_of(there.largest_enclosure());
      cell.site = *site;
      cell.bound_by = site->triangulation;
      cell.bound_by_part = side;
      break;
    }
    queue_.emplace(bound, static_cast<std::uint32_t>(cells_.size()));
    cells_.push_back(std::move(cell));
  }

  void add_cell(Place place, const Site& near) {
    if (goal_.claim == Claim::radius) {
      add_cell_of_radius(std::move(place), near);
      return;
    }
    const Point centre = centre_of(place);
    const std::uint32_t frame = sites_.frame_at(near.frame, centre);
    Cell cell{.place = std::move(place), .site = near};
    Bound best = bound(cell.place, frame, near.triangulation);
    cell.bound_by = near.triangulation;
    const std::optional<Site> own_site =
        best.value > highest_ + goal_.width ? sites_.moved(near, centre) : std::nullopt;
    if (own_site) {
      cell.site = *own_site;
      look_at(cell.site);
      if (cell.site.triangulation != near.triangulation) {
        const Bound own = bound(cell.place, frame, cell.site.triangulation);
        if (own.value < best.value) {
          best = own;
          cell.bound_by = cell.site.triangulation;
        }
      }
    }
    cell.bound_by_part = best.dart;
    queue_.emplace(best.value, static_cast<std::uint32_t>(cells_.size()));
    cells_.push_back(std::move(cell));
  }

  /// Cuts a cell at the midpoint of its longest edge.
  void cut(std::uint32_t number) {
    const Place& place = cells_[number].place;
    const std::uint32_t edge = place.longest_side();
    const std::uint32_t end = (edge + 1) % 3;
    const std::uint32_t far = (edge + 2) % 3;
    cells_[number].edge = edge;
    cells_[number].first_part = static_cast<std::uint32_t>(cells_.size());
    const Site site = cells_[number].site;
    const Midpoint middle = place.midpoint(edge);
    Place first = place;
    first.corner[end] = middle.point;
    first.cosh[edge] = middle.half;
    first.cosh[end] = middle.median;
    Place second = place;
    second.corner[edge] = middle.point;
    second.cosh[edge] = middle.half;
    second.cosh[far] = middle.median;
    add_cell(std::move(first), site);
    add_cell(std::move(second), site);
  }

  Goal goal_;
  Sites sites_;
  std::deque<Cell> cells_;                                       ///< Large; they stay where they are.
  std::priority_queue<std::pair<double, std::uint32_t>> queue_;  ///< Cells that are not cut, by bound.
  double highest_ = -std::numeric_limits<double>::infinity();
  double found_ = -std::numeric_limits<double>::infinity();
  Point summit_{};
};

/// The triangles around the centre of a domain, as a file numbers them.
std::vector<PlacedTriangle> triangles_of(const FundamentalDomain& domain) {
  const auto cosh_distance = [](const Point& p, const Point& q) { return Number(-lorentz_product(p, q)); };
  const Point centre = on_hyperboloid(Complex<Number>{Number(domain.centre[0]), Number(domain.centre[1])});
  std::vector<PlacedTriangle> result;
  for (std::size_t i = 0; i < domain.corners.size(); ++i) {
    const Point& p = domain.corners[i];
    const Point& q = domain.corners[(i + 1) % domain.corners.size()];
    result.push_back({{centre, p, q}, {cosh_distance(centre, p), cosh_distance(p, q), cosh_distance(q, centre)}});
  }
  return result;
}

/// Branch and bound: the triangles of a triangulation with one vertex, or of a domain of isometries, are cut until the
/// bounds of all cells are at most the greatest value that was found plus the width. For a radius the function is minus
/// the eccentricity.
///
/// Each triangle of a base is a part with elements and triangulations of its own. Parts go on in rounds, and tell each
/// other between rounds how great a value they found; so the result does not depend on the number of threads.
class BoundSearch {
 public:
  /// Requires: the base is Delaunay. With a domain, in the chart of its vertex, only that is searched.
  BoundSearch(Triangulation& base, std::optional<FundamentalDomain> domain, const Goal& goal,
              const BoundOptions& options)
      : goal_(goal),
        options_(options),
        threads_(certify::thread_count(options.threads)),
        sites_(base),
        domain_(std::move(domain)),
        at_vertex_(value_at(goal.claim, sites_, sites_.start())) {
    std::vector<PlacedTriangle> triangles;
    if (domain_) {
      triangles = triangles_of(*domain_);
    } else {
      CellBase cells(sites_.map(0), sites_.start().point, sites_.elements());
      cells.refine(options.most_cells);
      for (std::uint32_t t = 0; t < cells.triangle_count(); ++t) triangles.push_back(cells.triangle(t));
      base_ = cells.steps();
    }
    place(triangles);
    for (std::size_t t = 0; t < triangles.size(); ++t) parts_.emplace_back(triangles[t], sites_, near_[t], goal);
    share();
  }

  /// Cuts cells until the bounds are as near to each other as wanted, a limit is reached, or the vertex of the base is
  /// not where the greatest value is.
  void run() {
    double first_gap = 0;
    while (!is_narrow() && !at_limit() && !is_greater_elsewhere()) {
      round();
      if (first_gap == 0 && std::isfinite(upper())) first_gap = upper() - lower();
      if (options_.progress && first_gap > 0) {
        options_.progress("covering", std::log(first_gap / (upper() - lower())) / std::log(first_gap / goal_.width));
      }
    }
  }

  /// Throws NetError unless the bounds are as near to each other as wanted.
  void require_narrow() const {
    if (is_narrow()) return;
    const bool negated = goal_.claim == BoundDocument::Claim::radius;  // The maximum of the negative.
    const certify::Interval found =
        negated ? certify::Interval{-upper(), -lower()} : certify::Interval{lower(), upper()};
    throw NetError("not enclosed to the width wanted with " + std::to_string(cells()) + " cells and " +
                   std::to_string(elements()) + " edges of triangulations, only by " + to_string(found));
  }

  /// Whether a value was found that is too great to be assumed at the vertex of the base.
  [[nodiscard]] bool is_greater_elsewhere() const {
    return goal_.climb == Climb::no && best().found() > at_vertex_ + goal_.width / 2;
  }

  [[nodiscard]] double lower() const { return parts_.front().lower(); }
  [[nodiscard]] double upper() const {
    double result = parts_.front().upper();
    for (const PartSearch& part : parts_) result = std::max(result, part.upper());
    return result;
  }
  /// Where the greatest value was found, in the chart of the base's vertex.
  [[nodiscard]] const Point& summit() const { return best().found() > at_vertex_ ? best().summit() : vertex_; }

  /// The cells and the triangulations that they use.
  void describe(BoundDocument& document) const {
    Triangulations triangulations;
    std::vector<std::uint32_t> used;
    for (const Site& site : near_) used.push_back(site.triangulation);
    const std::vector<std::uint32_t> number = sites_.describe(used, 0, triangulations);
    for (std::size_t t = 0; t < parts_.size(); ++t) {
      document.cells.push_back(parts_[t].describe(number[near_[t].triangulation], triangulations));
    }
    document.base = base_;
    if (domain_) document.symmetry = {domain_->rows, domain_->centre};
    document.triangulations = triangulations.take();
  }

 private:
  /// The part that found the greatest value.
  [[nodiscard]] const PartSearch& best() const {
    return *std::max_element(parts_.begin(), parts_.end(),
                             [](const PartSearch& a, const PartSearch& b) { return a.found() < b.found(); });
  }
  [[nodiscard]] std::size_t cells() const {
    std::size_t result = 0;
    for (const PartSearch& part : parts_) result += part.cells();
    return result;
  }
  [[nodiscard]] std::size_t elements() const {
    std::size_t result = 0;
    for (const PartSearch& part : parts_) result += part.elements();
    return result;
  }
  [[nodiscard]] bool is_narrow() const {
    return std::all_of(parts_.begin(), parts_.end(), [](const PartSearch& part) { return part.is_narrow(); });
  }
  [[nodiscard]] bool at_limit() const { return cells() >= options_.most_cells || elements() > kMostElements; }

  /// Finds a site near each triangle, from that which is nearest among those that are found already.
  void place(const std::vector<PlacedTriangle>& triangles) {
    struct Open {
      Point centre;
      Number distance;  ///< The cosh of that to the nearest site.
      Site from;
    };
    std::vector<Open> open;
    for (const PlacedTriangle& triangle : triangles) {
      const Point centre = centre_of(triangle);
      open.push_back({centre, -lorentz_product(centre, vertex_), sites_.start()});
    }
    near_.resize(triangles.size());
    std::vector<bool> is_placed(triangles.size());
    for (std::size_t n = 0; n < triangles.size(); ++n) {
      std::size_t t = triangles.size();
      for (std::size_t k = 0; k < triangles.size(); ++k) {
        if (!is_placed[k] && (t == triangles.size() || open[k].distance < open[t].distance)) t = k;
      }
      is_placed[t] = true;
      const std::optional<Site> site = sites_.moved(open[t].from, open[t].centre);
      near_[t] = site.value_or(open[t].from);
      if (!site) continue;
      for (std::size_t k = 0; k < triangles.size(); ++k) {
        if (is_placed[k]) continue;
        const Number distance = -lorentz_product(open[k].centre, site->point);
        if (distance < open[k].distance) {
          open[k].distance = distance;
          open[k].from = *site;
        }
      }
    }
  }

  /// All parts learn of the greatest value.
  void share() {
    double highest = std::max(lower(), at_vertex_);
    for (const PartSearch& part : parts_) highest = std::max(highest, part.lower());
    for (PartSearch& part : parts_) part.raise(highest);
  }

  /// Cuts cells whose bounds are in the upper half of the gap, a few of each part.
  void round() {
    constexpr std::size_t kMostOfPart = 16;
    const double level = lower() + (upper() - lower()) / 2;
    std::vector<PartSearch*> open;
    for (PartSearch& part : parts_) {
      if (part.upper() >= level) open.push_back(&part);
    }
    std::stable_sort(open.begin(), open.end(),
                     [](const PartSearch* a, const PartSearch* b) { return a->upper() > b->upper(); });
    // A cut makes two cells.
    const std::size_t left = (static_cast<std::size_t>(options_.most_cells) - cells() + 1) / 2;
    certify::for_each_parallel(open.size(), threads_, [&](unsigned, std::size_t i) {
      const std::size_t most = left / open.size() + (i < left % open.size() ? 1 : 0);
      open[i]->cut_above(level, std::min(most, kMostOfPart));
    });
    share();
  }

  Goal goal_;
  const BoundOptions& options_;
  unsigned threads_;
  Sites sites_;
  Point vertex_ = sites_.start().point;
  std::optional<FundamentalDomain> domain_;
  std::vector<std::uint32_t> base_;  ///< Its steps, if there is no domain.
  double at_vertex_;
  std::vector<Site> near_;  ///< By triangle of the base.
  std::deque<PartSearch> parts_;
};

/// Returns a point at a distance of less than a thousandth of the width, with as few digits as that allows; the same
/// one if that is not inside of the tile.
BasePoint with_few_digits(const Surface& surface, const BasePoint& point, double width) {
  const Complex<Number> z = convert<Number>(point.z);
  const int bits = 12 - std::ilogb(width) + std::ilogb(static_cast<double>(Number(1 / (1 - norm(z)))));
  const auto rounded = [&](const Number& x) {
    return Rational(Number(ldexp(Number(floor(Number(ldexp(x, bits)) + Number(0.5))), -bits)));
  };
  BasePoint result{point.tile, {rounded(z.x), rounded(z.y)}};
  try {
    require_inside(surface, result);
  } catch (const SurfaceError&) {
    return point;
  }
  return result;
}

/// Returns the Delaunay triangulation whose one vertex is near a point of the chart of another's vertex, with few
/// digits.
Triangulation delaunay_near(const Surface& surface, const Triangulation& triangulation, const Point& point,
                            double width) {
  const Chart& chart = triangulation.atlas().charts()[triangulation.vertex(VertexId(0)).chart];
  const Complex<Number> z = Isometry<Number>::translation(convert<Number>(chart.centre))(in_disk(unit(point)));
  return delaunay_start_of_point(surface, with_few_digits(surface, rounded_point(surface, chart.tile, z), width))
      .triangulation;
}

/// Returns the Delaunay triangulation with one vertex as a net whose ε is above the eccentricity.
certify::NetDocument net_above_eccentricity(Triangulation& triangulation) {
  EdgeElements elements;
  const VertexTriangulation map = vertex_triangulation(triangulation, elements);
  const LorentzVector<EdgeElements::Number> place =
      on_hyperboloid(convert<EdgeElements::Number>(triangulation.vertex(VertexId(0)).z));
  Frame frame(elements, place);
  const double eccentricity = length_of(PlacedTriangulation(map, frame, place).largest_enclosure());
  return net_document(triangulation, Length(std::ceil(eccentricity) + 2));
}

/// The isometries of a surface, if they are found easily.
std::optional<IsometryGroup> symmetries(const Surface& surface, const BoundOptions& options) {
  try {
    return isometries(surface, {.threads = options.threads, .progress = options.progress});
  } catch (const Error&) {
    return std::nullopt;
  }
}

BoundDocument bound_document(const Surface& surface, BoundDocument::Claim claim, const BoundOptions& options) {
  if (!(options.width >= kLeastBoundWidth)) throw std::invalid_argument("the width is less than 1e-12");
  const std::optional<IsometryGroup> group = symmetries(surface, options);
  const auto domain_near_vertex = [&](const Triangulation& base) -> std::optional<FundamentalDomain> {
    if (!group || group->size() == 1) return std::nullopt;
    const Vertex& vertex = base.vertex(VertexId(0));
    return fundamental_domain(surface, *group, base.atlas().charts()[vertex.chart],
                              on_hyperboloid(convert<Number>(vertex.z)));
  };
  Triangulation base = delaunay_start_of_point(surface, std::nullopt).triangulation;
  // What a coarse search finds is good enough if the fine one succeeds, whatever the coarse one is short of.
  std::optional<BoundSearch> search(std::in_place, base, domain_near_vertex(base),
                                    Goal{claim, Climb::yes, 2 * options.width}, options);
  search->run();
  constexpr int kMostBases = 20;
  for (int bases = 0; bases == 0 || (search->is_greater_elsewhere() && bases < kMostBases); ++bases) {
    // Each time but the first, the value at the vertex is greater by half of the width.
    base = delaunay_near(surface, base, search->summit(), options.width);
    search.emplace(base, domain_near_vertex(base), Goal{claim, Climb::no, options.width * (1 - 1e-3)}, options);
    search->run();
  }
  search->require_narrow();
  BoundDocument document;
  document.claim = claim;
  document.net = net_above_eccentricity(base);
  // Lengths are rounded a few times; certify proves the result, with its own bounds of the value at the vertex.
  constexpr double kRounding = 2e-15;
  const certify::Certificate certificate = proof_of(document.net);
  if (claim == BoundDocument::Claim::radius) {
    const double proved = certificate.enclosures->largest_circumradius.upper;
    // The bound of a cell is a difference of two lengths, each at most the diameter.
    document.value = {-search->upper() - 4 * kRounding * proved, std::max(-search->lower() * (1 + kRounding), proved)};
    search->describe(document);
    return document;
  }
  const double proved = claim == BoundDocument::Claim::diameter ? certificate.enclosures->largest_circumradius.lower
                                                                : certificate.enclosures->shortest_loop->lower / 2;
  document.value = {std::min(search->lower() * (1 - kRounding), proved), search->upper() * (1 + kRounding)};
  search->describe(document);
  return document;
}

}  // namespace

certify::NetDocument unproved::eccentricity_net(const Surface& surface, const BasePoint& vertex) {
  Triangulation triangulation = delaunay_start_of_point(surface, vertex).triangulation;
  return net_above_eccentricity(triangulation);
}

BoundDocument unproved::diameter(const Surface& surface, const BoundOptions& options) {
  return bound_document(surface, BoundDocument::Claim::diameter, options);
}

BoundDocument unproved::radius(const Surface& surface, const BoundOptions& options) {
  return bound_document(surface, BoundDocument::Claim::radius, options);
}

BoundDocument unproved::largest_embedded_disk(const Surface& surface, const BoundOptions& options) {
  return bound_document(surface, BoundDocument::Claim::embedded_disk, options);
}

Certified<certify::NetDocument> eccentricity_net(const Surface& surface, const BasePoint& vertex) {
  return proved(unproved::eccentricity_net(surface, vertex));
}

Certified<BoundDocument> diameter(const Surface& surface, const BoundOptions& options) {
  return proved(unproved::diameter(surface, options), options.threads, options.progress);
}

Certified<BoundDocument> radius(const Surface& surface, const BoundOptions& options) {
  return proved(unproved::radius(surface, options), options.threads, options.progress);
}

Certified<BoundDocument> largest_embedded_disk(const Surface& surface, const BoundOptions& options) {
  return proved(unproved::largest_embedded_disk(surface, options), options.threads, options.progress);
}

}  // namespace epsnet
