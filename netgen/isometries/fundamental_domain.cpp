#include "netgen/isometries/fundamental_domain.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <utility>

#include "netgen/isometries/lifted_tiles.h"
#include "netgen/isometries/matches.h"
#include "netgen/surfaces/group.h"

namespace epsnet {
namespace {

using Number = LiftedTiles::Number;
using Vector = LiftedTiles::Vector;

/// The most tiles near a point that are looked at, and letters of the words that lead to its images. Where the surface
/// is thin its domains are long.
constexpr std::uint64_t kMostTilesNear = 5'000;
constexpr std::size_t kMostLetters = 20'000;

double distance_of(double cosh) { return std::acosh(std::max(1.0, cosh)); }

}  // namespace

/// The corners of the points that are not farther from a centre than from its images, in Klein coordinates with the
/// centre in the middle, where bisectors are straight.
class DomainPolygon {
 public:
  struct Corner {
    Complex<double> at;
    std::size_t side;  ///< Of the edge that starts here; kNone for those of the square that all points are in at first.
  };
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  DomainPolygon() : corners_{{{-1, -1}, kNone}, {{1, -1}, kNone}, {{1, 1}, kNone}, {{-1, 1}, kNone}} {}

  /// Keeps the points for which ⟨n, (x, y, 1)⟩ ≥ 0, and those that are hardly beyond.
  void cut(const LorentzVector<double>& n, std::size_t side) {
    constexpr double kHardly = 1e-9;
    const double size = std::hypot(n.x, n.y);
    const auto depth = [&](const Corner& c) { return (n.x * c.at.x + n.y * c.at.y - n.t) / size; };
    if (std::all_of(corners_.begin(), corners_.end(), [&](const Corner& c) { return depth(c) > -kHardly; })) return;
    std::vector<Corner> kept;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Corner& here = corners_[i];
      const Corner& next = corners_[(i + 1) % corners_.size()];
      const double from = depth(here);
      const double to = depth(next);
      const Complex<double> crossing = here.at + from / (from - to) * (next.at - here.at);
      if (from >= 0) kept.push_back(here);
      if (from >= 0 && to < 0) kept.push_back({crossing, side});
      if (from < 0 && to >= 0) kept.push_back({crossing, here.side});
    }
    corners_ = std::move(kept);
  }

  [[nodiscard]] const std::vector<Corner>& corners() const { return corners_; }
  /// The distance of the farthest corner from the centre; infinite if there is one at infinity.
  [[nodiscard]] double radius() const {
    double square = 0;
    for (const Corner& c : corners_) square = std::max(square, norm(c.at));
    return square < 1 ? std::atanh(std::sqrt(square)) : std::numeric_limits<double>::infinity();
  }
  /// Requires: a finite radius.
  [[nodiscard]] double area() const {
    double result = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Complex<double> p = from_klein(corners_[i].at);
      const Complex<double> q = from_klein(corners_[(i + 1) % corners_.size()].at);
      // tan(A/2) for a triangle with the corners 0, p, q.
      const Complex<double> product = conj(p) * q;
      result += 2 * std::atan2(product.y, 1 - product.x);
    }
    return result;
  }

 private:
  std::vector<Corner> corners_;
};

/// Looks for a domain with a centre near a point. Everything is in the coordinates of tile 0.
class DomainSearch {
 public:
  DomainSearch(const Surface& surface, const IsometryGroup& group, const Chart& chart,
               const LorentzVector<Mp1024>& point)
      : surface_(surface), lifts_(*group.lifts_), tiles_(lifts_.tiles()) {
    const Word back = reversed(surface, polygon_paths(surface)[chart.tile]);
    to_chart_ = normalized(inverse(tiles_.value(back) * Isometry<Number>::translation(convert<Number>(chart.centre))));
    point_ = image(inverse(to_chart_), Vector{Number(point.x), Number(point.y), Number(point.t)});
    const double genus = surface.genus();
    area_ = 4 * std::numbers::pi * (genus - 1) / static_cast<double>(group.size());
    home_ = tiles_.walk(TileId(0), point_);
    home_tile_ = tiles_.end_of(TileId(0), home_);
    home_point_ = image(tiles_.value(home_), point_);
    from_middle_ =
        motion(normalized(inverse(tiles_.value(home_)) * Isometry<Number>::translation(in_disk(home_point_))));
    for (const IsometryGroup::Step& step : group.steps_) {
      const bool is_first = motions_.empty();
      motions_.push_back(is_first ? Motion<Number>()
                                  : lifts_.near(lifts_.generators[step.generator] * motions_[step.then]));
      const Vector lift = motions_.back()(point_);
      Word way = tiles_.walk(TileId(0), lift);
      const LorentzVector<double> seen = rounded(image(tiles_.value(way), lift));
      const TileId tile = tiles_.end_of(TileId(0), way);
      places_.push_back({std::move(way), tile, seen});
    }
  }

  [[nodiscard]] std::optional<FundamentalDomain> find() {
    // Of a disk of the domain's area. Domains are wider, and their centres elsewhere; the images that bound them are
    // within twice the sum of these distances.
    const double radius = std::acosh(1 + area_ / (2 * std::numbers::pi));
    constexpr int kMostTries = 8;
    double reach = std::min(6 * radius, 2 * radius + 2);
    for (int tries = 0; tries < kMostTries; ++tries, reach += radius / 2 + 0.3) {
      const std::vector<Image> images = images_near(reach);
      std::optional<Choice> best;
      for (const Complex<double>& centre : centres(radius)) {
        Choice choice = around(centre, images);
        if (choice.is_domain && (!best || choice.polygon.radius() < best->polygon.radius())) best = std::move(choice);
      }
      if (best) return domain(*best, images);
    }
    return std::nullopt;
  }

 private:
  /// A point in the tile that contains it, and the path there from tile 0.
  struct Place {
    Word way;
    TileId tile;
    LorentzVector<double> seen;
  };
  /// A lift of an isometry that moves the point not far.
  struct Image {
    Motion<Number> motion;
    Motion<double> moved;  ///< The same, in coordinates with the point in the middle.
  };
  struct Choice {
    Complex<double> centre;  ///< With the point in the middle.
    DomainPolygon polygon;
    bool is_domain = false;
  };

  /// Some points within about a distance from the middle, with few digits: the same ones on every machine.
  [[nodiscard]] static std::vector<Complex<double>> centres(double distance) {
    constexpr std::size_t kCentres = 40;
    constexpr int kGrid = 64;
    const double scale = std::ldexp(1.0, std::ilogb(std::tanh(distance / 2)) + 1);
    std::vector<Complex<double>> result;
    std::mt19937 random;
    while (result.size() < kCentres) {
      const auto share = [&] { return (static_cast<double>(random() % (2 * kGrid + 1)) - kGrid) / kGrid; };
      const double x = share();
      const Complex<double> centre{x, share()};
      if (norm(centre) < 1) result.push_back(scale * centre);
    }
    return result;
  }

  /// Lifts of all isometries, the identity among them, that move the point by at most `reach`.
  [[nodiscard]] std::vector<Image> images_near(double reach) const {
    const auto near = lifts_.source.search.elements(home_tile_, home_point_, reach, kMostTilesNear);
    const auto tile_lifts = near.tile_lifts();
    if (!tile_lifts) throw LimitError("tiles are too long");
    std::vector<Image> result;
    std::size_t letters = 0;
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      const Place& place = places_[i];
      for (const auto& [frame, lift] : (*tile_lifts)[place.tile]) {
        if (distance_of(image(frame, place.seen).t) > reach) continue;
        const Word back = concatenated(surface_, reversed(surface_, near.way(lift)), reversed(surface_, home_));
        letters += place.way.size() + back.size();
        if (letters > kMostLetters) throw LimitError("the domain is too long");
        const Motion<Number> f = motion(tiles_.value(concatenated(surface_, place.way, back))) * motions_[i];
        const Motion<Number> moved = inverse(from_middle_) * f * from_middle_;
        result.push_back({f, {rounded(moved.x), rounded(moved.y), rounded(moved.t)}});
      }
    }
    return result;
  }

  [[nodiscard]] Choice around(const Complex<double>& centre, const std::vector<Image>& images) const {
    const LorentzVector<double> from = on_hyperboloid(centre);
    const Motion<double> to_middle = motion(normalized(inverse(Isometry<double>::translation(centre))));
    std::vector<std::pair<double, std::size_t>> by_distance;
    std::vector<LorentzVector<double>> normal;
    for (std::size_t k = 0; k < images.size(); ++k) {
      const LorentzVector<double> image_of = to_middle(images[k].moved(from));
      normal.push_back({-image_of.x, -image_of.y, 1 - image_of.t});
      constexpr double kFixed = 1e-6;
      // The identity, which is among them, and what nearly leaves the centre where it is.
      if (const double far = distance_of(image_of.t); far > kFixed) by_distance.emplace_back(far, k);
    }
    std::sort(by_distance.begin(), by_distance.end());
    Choice result{centre, {}, false};
    for (const auto& [far, k] : by_distance) {
      if (far > 2 * result.polygon.radius() + 1e-6) break;
      result.polygon.cut(normal[k], k);
    }
    const auto& corners = result.polygon.corners();
    const bool is_finite = std::isfinite(result.polygon.radius()) && corners.size() >= 3 &&
                           std::none_of(corners.begin(), corners.end(),
                                        [](const DomainPolygon::Corner& c) { return c.side == DomainPolygon::kNone; });
    constexpr double kError = 1e-6;
    result.is_domain = is_finite && std::fabs(result.polygon.area() - area_) < kError * area_;
    return result;
  }

  /// Its centre is rounded, and its corners are computed anew.
  [[nodiscard]] std::optional<FundamentalDomain> domain(const Choice& choice, const std::vector<Image>& images) const {
    const Motion<Number> to_chart = motion(to_chart_);
    const Vector chosen = to_chart(from_middle_(on_hyperboloid(convert<Number>(choice.centre))));
    const Complex<double> centre = convert<double>(in_disk(chosen));
    FundamentalDomain result{{centre.x, centre.y}, {}, {}};
    const Vector in_chart = on_hyperboloid(convert<Number>(centre));
    const Motion<Number> from_chart = inverse(to_chart);
    std::vector<SurfaceIsometry> sides;
    std::vector<Vector> normal;
    for (const DomainPolygon::Corner& corner : choice.polygon.corners()) {
      const Motion<Number>& f = images[corner.side].motion;
      std::optional<std::vector<Word>> words = lifts_.source.images(tiles_, f);
      if (!words) return std::nullopt;
      sides.push_back({preserves_orientation(f), *std::move(words)});
      normal.push_back(in_chart - to_chart(f(from_chart(in_chart))));
    }
    result.rows = isometry_rows(surface_, sides);
    for (std::size_t i = 0; i < normal.size(); ++i) {
      const Vector c = lorentz_cross(normal[i], normal[(i + 1) % normal.size()]);
      const Number square = -lorentz_product(c, c);
      if (!(square > 0)) return std::nullopt;
      const Vector unit = Number((c.t > 0 ? 1 : -1) / sqrt(square)) * c;
      result.corners.push_back({Mp1024(unit.x), Mp1024(unit.y), Mp1024(unit.t)});
    }
    return result;
  }

  const Surface& surface_;
  const IsometryLifts& lifts_;
  const LiftedTiles& tiles_;
  Isometry<Number> to_chart_;
  Vector point_;
  double area_;
  Word home_;  ///< From tile 0 to the tile that contains the point.
  TileId home_tile_{0};
  Vector home_point_;                    ///< In the coordinates of that tile.
  Motion<Number> from_middle_;           ///< Takes the centre of the disk to the point.
  std::vector<Motion<Number>> motions_;  ///< By isometry: a lift.
  std::vector<Place> places_;            ///< Of what the lifts make of the point.
};

std::optional<FundamentalDomain> fundamental_domain(const Surface& surface, const IsometryGroup& group,
                                                    const Chart& chart, const LorentzVector<Mp1024>& point) {
  try {
    return DomainSearch(surface, group, chart, point).find();
  } catch (const LimitError&) {
    return std::nullopt;
  }
}

}  // namespace epsnet
