#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "certify/base/interval.h"
#include "certify/base/text.h"
#include "certify/claims/bound/fields.h"
#include "certify/claims/bound/triangles.h"
#include "certify/claims/isometries/conjugation.h"
#include "certify/claims/net/claim.h"
#include "certify/lifted/lifted_plane.h"
#include "certify/net/labels.h"
#include "certify/net/lifted_triangle.h"
#include "certify/net/numbering.h"
#include "certify/net/structure.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/parallel.h"

namespace epsnet::certify {
namespace {

Problem triangulations_problem(const BoundDocument& document) {
  const std::size_t darts = 3 * document.net.triangles.size();
  for (std::size_t k = 0; k < document.triangulations.size(); ++k) {
    const BoundDocument::Triangulation& row = document.triangulations[k];
    if (row.parent > k) {
      return at("triangulations", k) + "is made from number " + std::to_string(row.parent) +
             ", expected one before its own, " + std::to_string(k + 1);
    }
    for (const std::uint32_t dart : row.flips) {
      if (dart >= darts) return at("triangulations", k) + "dart " + std::to_string(dart) + " does not exist";
    }
  }
  return std::nullopt;
}

/// Counts the triangles of the base.
Problem base_problem(const BoundDocument& document, std::uint64_t& triangles) {
  triangles = document.net.triangles.size();
  for (std::size_t k = 0; k < document.base.size(); ++k) {
    const std::uint32_t dart = document.base[k] / 2;
    if (dart >= 3 * triangles) return at("base", k) + "dart " + std::to_string(dart) + " does not exist";
    if (document.base[k] % 2 != 0) triangles += 2;
  }
  if (3 * triangles > std::numeric_limits<std::uint32_t>::max()) return "base: more than 2^32 darts";
  return std::nullopt;
}

/// Counts the triangles around the centre.
Problem symmetry_problem(const BoundDocument& document, std::uint64_t& triangles) {
  const BoundSymmetry& symmetry = *document.symmetry;
  triangles = symmetry.isometries.size();
  if (!document.base.empty()) return "base: expected none beside a symmetry";
  const auto [x, y] = symmetry.centre;
  if (!inside_disk(x, y)) return "symmetry: centre: not in the disk";
  if (triangles < 3) return "symmetry: isometries: " + std::to_string(triangles) + " rows, expected at least 3";
  if (const auto problem = isometries_problem(SurfaceSides(document.net.surface), symmetry)) {
    return "symmetry: " + *problem;
  }
  return std::nullopt;
}

Problem cells_problem(const BoundDocument& document) {
  std::uint64_t in_base = 0;
  if (auto problem = document.symmetry ? symmetry_problem(document, in_base) : base_problem(document, in_base)) {
    return problem;
  }
  if (document.cells.size() != in_base) {
    return "cells: " + std::to_string(document.cells.size()) + " elements, expected one for each of the " +
           std::to_string(in_base) + " triangles";
  }
  const std::uint64_t triangles = document.net.triangles.size();
  const std::uint64_t of_each = document.claim == BoundDocument::Claim::diameter ? 1
                                : document.claim == BoundDocument::Claim::radius ? 3
                                                                                 : 3 * triangles;
  const std::uint64_t bounds = (document.triangulations.size() + 1) * of_each;
  return first_row_problem("cells", document.cells, [&](const std::vector<std::uint32_t>& row) -> Problem {
    std::size_t open = 1;
    for (const std::uint32_t entry : row) {
      if (open == 0) return "more numbers than the subdivision has";
      if (entry >= 3 && entry - 3 >= bounds) return std::to_string(entry) + " names nothing that bounds a cell";
      open = entry < 3 ? open + 1 : open - 1;
    }
    if (open == 0) return std::nullopt;
    return "the subdivision ends early, " + std::to_string(open) + " cells are missing";
  });
}

}  // namespace

Problem structure_problem(const BoundDocument& document) {
  if (auto problem = one_vertex_problem(document.net)) return problem;
  if (!is_length(document.value) || document.value.lower == 0) {
    return "value: " + to_string(document.value) + " is not 0 < lo <= hi";
  }
  if (auto problem = triangulations_problem(document)) return problem;
  return cells_problem(document);
}

std::uint64_t least_bytes(const BoundDocument& document) {
  std::uint64_t bytes = least_bytes(document.net) + least_bytes(document.base);
  if (document.symmetry) bytes += least_bytes(static_cast<const IsometryRows&>(*document.symmetry));
  for (const BoundDocument::Triangulation& row : document.triangulations) bytes += 4 + least_bytes(row.flips);
  for (const std::vector<std::uint32_t>& row : document.cells) bytes += 2 + least_bytes(row);
  return bytes;
}

namespace {

constexpr const char* kIsometries = "isometries";
constexpr const char* kDomain = "domain";

/// Bits that cells are asked with first.
constexpr slong kFirstPrecisionForCells = 256;
/// Operations of balls for an edge at a point, a triangle at a point, and a cut.
constexpr std::uint64_t kEdgeOperations = 6;
constexpr std::uint64_t kTriangleOperations = 16;
constexpr std::uint64_t kCutOperations = 12;
constexpr std::uint64_t kFlipOperations = 40;
constexpr std::uint64_t kPlaceOperations = 180;
/// Bytes of a step of the base.
constexpr std::uint64_t kStepBytes = 100;
constexpr std::uint64_t kFunctionOperations = 60;
/// The work of an operation of intervals, and the operations of balls and the bytes for an element in a frame.
constexpr std::uint64_t kIntervalWork = 5;
constexpr std::uint64_t kMoveOperations = 12;
constexpr std::uint64_t kMovedBytes = 128;
/// And for a triangle at the net's vertex.
constexpr std::uint64_t kVertexOperations = 150;
/// Balls that an open cell keeps.
constexpr std::uint64_t kCellBalls = 12;

/// The corners of a cell as unit vectors, and the cosh of its sides' lengths, side i from corner i to corner i + 1.
struct Cell {
  std::array<BallVector, 3> corner;
  std::array<Ball, 3> cosh;
};

/// (U + V)/(2 cosh(d/2)), d the distance of U and V.
BallVector midpoint(const BallVector& u, const BallVector& v, const Ball& cosh_half) {
  BallVector result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = half((u[i] + v[i]) / cosh_half);
  return result;
}

/// The two parts of a cell that is cut from the midpoint of a side to the corner opposite to it.
std::array<Cell, 2> halves(const Cell& cell, std::uint32_t side) {
  const std::uint32_t end = (side + 1) % 3;
  const std::uint32_t far = (side + 2) % 3;
  // cosh(d/2), the midpoint, and the cosh of its distance from the corner opposite.
  Ball half = sqrt(certify::half(cell.cosh[side] + 1));
  BallVector middle = midpoint(cell.corner[side], cell.corner[end], half);
  Ball median = certify::half((cell.cosh[end] + cell.cosh[far]) / half);
  Cell first = cell;
  first.corner[end] = middle;
  first.cosh[side] = half;
  first.cosh[end] = median;
  Cell second = cell;
  second.corner[side] = std::move(middle);
  second.cosh[side] = std::move(half);
  second.cosh[far] = std::move(median);
  return {std::move(first), std::move(second)};
}

class BoundCheck {
 public:
  using Claim = BoundDocument::Claim;

  BoundCheck(const BoundDocument& document, Verification& run, Crossings crossings)
      : document_(document),
        run_(run),
        options_(run.options()),
        threads_(run.threads()),
        budget_(run.budget()),
        parts_(label_parts(std::move(crossings), document.net.charts, run.budget())),
        evaluator_(document.net, parts_),
        darts_(static_cast<std::uint32_t>(3 * document.net.triangles.size())) {}

  void ask() {
    run_.report(at_vertex());
    if (run_.report(triangulations()) != Verdict::verified) return;
    if (document_.symmetry) {
      run_.progress(kIsometries);
      const SurfaceSides sides(document_.net.surface);
      if (run_.report(isometries_report(parts_.crossings, sides, *document_.symmetry, budget_)) != Verdict::verified) {
        return;
      }
      domain_.emplace(document_.net, *document_.symmetry, parts_);
      if (run_.report(domain()) != Verdict::verified) return;
    }
    run_.report(cells());
  }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  /// The rule `lower`, or `upper` for a radius.
  RuleReport at_vertex() {
    const bool lower = document_.claim != Claim::radius;
    const double bound = lower ? document_.value.lower : document_.value.upper;
    Tri less = Tri::unknown;
    with_rising_precision(options_.max_precision, [&](slong precision) {
      begin(precision);
      less = is_less_at_vertex(bound);
      return less != Tri::unknown;
    });
    // The function is never equal to the bound: sinh² of the bound, a binary64, is not algebraic.
    const Tri holds = lower ? !less : less;
    const char* const rule = lower ? "lower" : "upper";
    // Inward: who misses the bound misses the decimal.
    const std::string expected = lower ? "at least " + decimal_above(bound) : "at most " + decimal_below(bound);
    const std::string text = text_at_vertex();
    if (holds == Tri::yes) return {rule, Verdict::verified, text};
    if (holds == Tri::no) return {rule, Verdict::refuted, text + ", expected " + expected};
    return {rule, Verdict::undecided, text + ", not decided whether " + expected + ", with " + bits()};
  }

  /// Whether the eccentricity of the net's vertex, its largest circumradius, is less than the bound; or the injectivity
  /// radius, half of its shortest edge (docs/proof.md, section 15).
  [[nodiscard]] Tri is_less_at_vertex(double bound) const {
    const NetDocument& net = document_.net;
    spend(kVertexOperations, net.triangles.size());
    const LabelTable labels = all_labels(precision_);
    const Ball squared = sqr(sinh(Ball::exactly(bound)));
    const bool disk = document_.claim == Claim::embedded_disk;
    Tri less = disk ? Tri::no : Tri::yes;
    LiftedTriangle lifted;
    for (std::uint32_t t = 0; t < net.triangles.size(); ++t) {
      lifted.load(net, labels, t, precision_);
      if (disk) {
        for (std::uint32_t edge = 0; edge < 3; ++edge) {
          less = either(less, certainly_positive(lifted.measure_edge(squared.get(), edge, precision_).lack));
        }
      } else {
        less = both(less, certainly_positive(lifted.measure_circumradius(squared.get(), precision_).slack));
      }
    }
    return less;
  }

  [[nodiscard]] std::string text_at_vertex() const {
    const Enclosures net = value_of(run_.certificate().enclosures, "a verified net without enclosures");
    if (document_.claim != Claim::embedded_disk) {
      return "the eccentricity of the net's vertex lies in " + to_string(net.largest_circumradius);
    }
    const Interval loop = value_of(net.shortest_loop, "a net with one vertex and without loop");
    return "the injectivity radius of the net's vertex lies in " + to_string(Interval{loop.lower / 2, loop.upper / 2});
  }

  /// Makes all triangulations, and the base.
  RuleReport triangulations() {
    budget_.spend(memory_work(8 * std::uint64_t{darts_}), document_.triangulations.size() + 2);
    Map first;
    for (std::uint32_t d = 0; d < darts_; ++d) {
      first.opposite.push_back(opposite(document_.net, d));
      first.element.push_back(kNone);
    }
    for (std::uint32_t d = 0; d < darts_; ++d) {
      const std::uint32_t e = first.opposite[d];
      if (first.element[d] != kNone) continue;
      first.element[d] = 2 * static_cast<std::uint32_t>(edges_.size());
      first.element[e] = first.element[d] + 1;
      edges_.push_back(d);
    }
    maps_.push_back(std::move(first));
    for (std::size_t k = 0; k < document_.triangulations.size(); ++k) {
      const BoundDocument::Triangulation& row = document_.triangulations[k];
      Map map = map_at(row.parent);
      budget_.spend(50, row.flips.size());
      for (const std::uint32_t d : row.flips) {
        if (d / 3 == map.opposite[d] / 3) {
          return {"triangulations", Verdict::refuted,
                  "triangulation " + std::to_string(k + 1) + ": " + one_triangle(d) + "flipped"};
        }
        products_.push_back(flip(map, d, next_element()));
      }
      maps_.push_back(std::move(map));
    }
    const std::string made =
        counted(maps_.size(), "triangulation", "triangulations") + ", " + counted(products_.size(), "flip", "flips");
    if (const std::optional<std::string> wrong = make_base()) return {"triangulations", Verdict::refuted, *wrong};
    const std::string steps =
        document_.base.empty() ? "" : "; the base: " + counted(document_.base.size(), "step", "steps");
    return {"triangulations", Verdict::verified, made + steps};
  }

  /// Makes the triangulation that is cut into cells. What is wrong with a step, if something is.
  [[nodiscard]] std::optional<std::string> make_base() {
    base_ = {maps_[0], std::vector<std::uint32_t>(darts_), {}};
    budget_.spend(50 + memory_work(kStepBytes), document_.base.size());
    std::optional<std::uint32_t> one;
    for (const std::uint32_t step : document_.base) {
      const std::uint32_t d = step / 2;
      const bool splits = step % 2 != 0;
      if (d / 3 == base_.map.opposite[d] / 3) return "base: " + one_triangle(d) + (splits ? "split" : "flipped");
      if (!splits) {
        products_.push_back(flip(base_, d, next_element()));
        continue;
      }
      if (!one) {
        one = 2 * next_element();
        products_.push_back({base_.map.element[d], base_.map.element[d] ^ 1U});
      }
      split(base_, d, *one);
    }
    return std::nullopt;
  }

  [[nodiscard]] static std::string one_triangle(std::uint32_t dart) {
    return "dart " + std::to_string(dart) + " has the same triangle on both sides and cannot be ";
  }

  [[nodiscard]] std::uint32_t next_element() const {
    return static_cast<std::uint32_t>(edges_.size() + products_.size());
  }

  /// The triangles around the centre.
  [[nodiscard]] Domain::Placed placed_domain() const {
    return value_of(domain_, "there is no domain").place(precision_, most_bits(), threads_);
  }

  RuleReport domain() {
    Domain::Placed placed;
    with_rising_precision(options_.max_precision, [&](slong precision) {
      begin(precision);
      placed = placed_domain();
      return placed.surrounds != Tri::unknown;
    });
    const std::string rows = "isometries " + std::to_string(placed.row) + " and on";
    if (placed.surrounds == Tri::yes) {
      return {kDomain, Verdict::verified, std::to_string(placed.triangles.size()) + " sides around the centre"};
    }
    if (placed.surrounds == Tri::no) {
      return {kDomain, Verdict::refuted, "the sides of " + rows + " do not follow each other around the centre"};
    }
    return {kDomain, Verdict::undecided, "the sides of " + rows + " are not told with " + bits()};
  }

  RuleReport cells() {
    RuleReport report;
    with_rising_precision(
        options_.max_precision,
        [&](slong precision) {
          begin(precision);
          report = pass();
          return report.verdict != Verdict::undecided;
        },
        kFirstPrecisionForCells);
    return report;
  }

  void begin(slong precision) {
    precision_ = precision;
    run_.used(static_cast<std::uint64_t>(precision));
  }

  [[nodiscard]] std::string bits() const { return std::to_string(precision_) + " bits"; }

  void spend(std::uint64_t operations, std::uint64_t times = 1) const {
    budget_.spend(operations * ball_work(static_cast<std::uint64_t>(precision_)), times);
  }

  [[nodiscard]] LabelTable all_labels(slong precision) const {
    std::vector<std::uint32_t> numbers(document_.net.labels.size());
    std::iota(numbers.begin(), numbers.end(), 1U);
    return {numbers, evaluator_.evaluate(numbers, precision, most_bits(), threads_), numbers.size()};
  }

  /// The most that words are worked out with.
  [[nodiscard]] slong most_bits() const { return std::min<slong>(4 * precision_, 2 * options_.max_precision); }

  /// All elements of all triangulations, at the vertex' chart. Whether that is worth to go on with: with more bits an
  /// element that comes again is recognized, and what follows takes less time.
  [[nodiscard]] bool evaluate() {
    const slong fine = Elements::path_precision(precision_);
    const LabelTable labels = all_labels(fine);
    const auto label = [&](std::uint32_t dart) {
      const std::uint32_t number = corner_label(document_.net, dart);
      return number == 0 ? identity_isometry() : labels[number];
    };
    spend(kFlipOperations, edges_.size() + products_.size());
    budget_.spend(memory_work(8 * (48 + static_cast<std::uint64_t>(precision_) / 8)), edges_.size() + products_.size());
    const NetDocument::Vertex& vertex = document_.net.vertices[0];
    const BallVector place = unit_vector(identity_isometry(), vertex.x, vertex.y, precision_);
    std::vector<BallIsometry> edges;
    for (const std::uint32_t d : edges_) edges.push_back(compose(inverse(label(d)), label(next_dart(d)), fine));
    elements_.emplace(place, least_displacement(edges, place, precision_), edges, precision_, budget_);
    ids_.clear();
    for (BallIsometry& g : edges) ids_.push_back(elements_->add(std::move(g)));
    for (const auto& [first, second] : products_) {
      const BallIsometry product =
          compose(elements_->isometry(id_of(first)), elements_->isometry(id_of(second)), precision_);
      ids_.push_back(elements_->add(product));
      if (!elements_->all_told() && precision_ < options_.max_precision) return false;
    }
    most_ = sqr(sinh(Ball::exactly(document_.value.upper)));
    if (!document_.symmetry) {
      triangles_ = placed_base(place);
      return true;
    }
    const Domain::Placed placed = placed_domain();
    triangles_.clear();
    for (const auto& corners : placed.triangles) triangles_.push_back(cell_of(corners));
    return placed.surrounds == Tri::yes;
  }

  [[nodiscard]] Cell cell_of(std::array<BallVector, 3> corners) const {
    Cell cell{std::move(corners), {}};
    for (std::size_t i = 0; i < 3; ++i) {
      cell.cosh[i] = -lorentz_product(cell.corner[i], cell.corner[(i + 1) % 3], precision_);
    }
    return cell;
  }

  /// The triangles of the base, in the chart of the net's vertex.
  [[nodiscard]] std::vector<Cell> placed_base(const BallVector& vertex) const {
    // From midpoint to midpoint bits are lost, where elements lead far and back.
    const slong fine = Elements::path_precision(precision_);
    const Precision scope(fine);
    std::map<Elements::Id, BallMatrix> matrices;
    const auto moved = [&](std::uint32_t number, const BallVector& p) {
      const auto [found, is_new] = matrices.try_emplace(id_of(number));
      if (is_new) found->second = lorentz_matrix(elements_->along_edges(id_of(number)), fine);
      return apply(found->second, p, fine);
    };
    spend(kPlaceOperations, base_.midpoints.size() + base_.start.size());
    std::vector<BallVector> points{vertex};
    for (const Base::Midpoint& middle : base_.midpoints) {
      const BallVector& p = points[middle.from];
      const BallVector q = moved(middle.element, points[middle.to]);
      points.push_back(midpoint(p, q, sqrt(half(1 - lorentz_product(p, q, fine)))));
    }
    std::vector<Cell> result;
    for (std::uint32_t d = 0; d < base_.start.size(); d += 3) {
      const auto corner = [&](std::uint32_t i) -> const BallVector& { return points[base_.start[d + i]]; };
      const BallVector second = moved(base_.map.element[d], corner(1));
      const BallVector third = moved(base_.map.element[d + 2] ^ 1U, corner(2));
      result.push_back(cell_of({corner(0), second, third}));
    }
    return result;
  }

  RuleReport pass() {
    if (!evaluate())
      return {"cells", Verdict::undecided, "the elements of triangulations or the domain are not told with " + bits()};
    struct Outcome {
      Tri within = Tri::yes;
      std::size_t cell = 0;  ///< The first that is not, else the first that is open.
      std::size_t cells = 0;
    };
    std::vector<Outcome> outcomes(document_.cells.size());
    for_each_parallel(outcomes.size(), threads_, [&](unsigned worker, std::size_t t) {
      if (worker == 0 && options_.progress) {
        options_.progress("cells", static_cast<double>(t) / static_cast<double>(outcomes.size()));
      }
      Outcome& outcome = outcomes[t];
      Frames frames(precision_);
      std::vector<Cell> open{looked_up(triangles_, t, "there is no triangle")};
      for (const std::uint32_t entry : document_.cells[t]) {
        const Cell cell = std::move(open.back());
        open.pop_back();
        if (entry < 3) {
          spend(kCutOperations);
          budget_.spend(memory_work(kCellBalls * (48 + static_cast<std::uint64_t>(precision_) / 8)));
          std::array<Cell, 2> parts = halves(cell, entry);
          open.push_back(std::move(parts[1]));
          open.push_back(std::move(parts[0]));
          continue;
        }
        const Tri within = both(outcome.within, is_bounded(cell, entry - 3, frames));
        if (within != outcome.within) outcome.cell = outcome.cells;
        outcome.within = within;
        ++outcome.cells;
        // The others are asked with more bits.
        if (within == Tri::unknown && precision_ < options_.max_precision) break;
      }
    });
    std::size_t cells = 0;
    for (const Outcome& outcome : outcomes) cells += outcome.cells;
    for (const Tri wanted : {Tri::no, Tri::unknown}) {
      for (std::size_t t = 0; t < outcomes.size(); ++t) {
        if (outcomes[t].within != wanted) continue;
        const std::string place = "cell " + std::to_string(outcomes[t].cell) + " of triangle " + std::to_string(t);
        if (wanted == Tri::no) return {"cells", Verdict::refuted, place + " is not bounded by " + bound(false)};
        return {"cells", Verdict::undecided,
                place + ": not decided whether it is bounded by " + bound(false) + ", with " + bits()};
      }
    }
    return {"cells", Verdict::verified, std::to_string(cells) + " cells are bounded by " + bound(true)};
  }

  /// The end of the value that bounds the cells: outward, so that what holds for it holds for the decimal; or inward,
  /// so that what fails for it fails for the decimal.
  [[nodiscard]] std::string bound(bool outward) const {
    const bool is_lower = document_.claim == Claim::radius;
    const double end = is_lower ? document_.value.lower : document_.value.upper;
    return is_lower == outward ? decimal_below(end) : decimal_above(end);
  }

  [[nodiscard]] const Map& map_at(std::uint32_t number) const {
    return looked_up(maps_, number, "there is no triangulation");
  }

  /// The element of a number in the maps, which counts equal products as different ones.
  [[nodiscard]] Elements::Id id_of(std::uint32_t number) const {
    return looked_up(ids_, number / 2, "there is no element") ^ (number % 2);
  }

  /// The arithmetic in which cells are asked: balls.
  struct InBalls {
    using Number = Ball;
    const BoundCheck& check;

    void spend(std::uint64_t operations, std::uint64_t times = 1) const { check.spend(operations, times); }
    [[nodiscard]] static const Ball& number(const Ball& x) { return x; }
    /// sinh²(d/2) for the edge of an element at a point.
    [[nodiscard]] auto displacement_at(const BallVector& p) const {
      return [this, &p](std::uint32_t number) {
        return displacement(check.elements_->element(check.id_of(number)), p, check.precision_);
      };
    }
  };

  /// Intervals, which decide nearly all.
  struct InIntervals {
    using Number = Interval;
    const BoundCheck& check;
    Frames& frames;

    void spend(std::uint64_t operations, std::uint64_t times = 1) const {
      check.budget_.spend(kIntervalWork * operations, times);
    }
    [[nodiscard]] static Interval number(const Ball& x) { return fast_interval(x); }
    [[nodiscard]] auto displacement_at(const BallVector& p) const {
      check.spend(kMoveOperations, frames.size() + 1);
      Frame& frame = frames.near(p);
      return [this, &frame, place = frame.point(p)](std::uint32_t number) {
        const Elements::Id id = check.id_of(number);
        const std::size_t before = frame.elements();
        const Interval result = frame.displacement(id / 2, check.elements_->element(id), place);
        if (frame.elements() > before) {
          check.spend(kMoveOperations);
          check.budget_.spend(memory_work(kMovedBytes));
        }
        return result;
      };
    }
  };

  [[nodiscard]] Tri is_bounded(const Cell& cell, std::uint32_t by, Frames& frames) const {
    if (options_.filter) {
      const Tri answer = is_bounded(cell, by, InIntervals{*this, frames});
      if (answer != Tri::unknown) return answer;
    }
    return is_bounded(cell, by, InBalls{*this});
  }

  template <class Arithmetic>
  [[nodiscard]] Tri is_bounded(const Cell& cell, std::uint32_t by, const Arithmetic& arithmetic) const {
    switch (document_.claim) {
      case Claim::diameter:
        return is_bounded_by_triangulation(cell, by, arithmetic);
      case Claim::radius:
        return is_bounded_from_midpoint(cell, by / 3, by % 3, arithmetic);
      case Claim::embedded_disk:
        return is_bounded_by_edge(cell, by, arithmetic);
    }
    return Tri::unknown;
  }

  /// sinh²(d/2) of every dart at a point.
  template <class Arithmetic>
  [[nodiscard]] auto displacements(const Map& map, const BallVector& p, const Arithmetic& arithmetic) const {
    const auto displacement = arithmetic.displacement_at(p);
    std::vector<typename Arithmetic::Number> h(darts_);
    for (std::uint32_t d = 0; d < darts_; ++d) {
      const std::uint32_t e = map.opposite[d];
      if (d < e) h[d] = displacement(map.element[d]);
      if (d > e) h[d] = h[e];
    }
    return h;
  }

  /// At the midpoint of a side, the triangulation is Delaunay, and its largest circumradius is at least LO more than
  /// the distance to any point of the cell.
  template <class Arithmetic>
  [[nodiscard]] Tri is_bounded_from_midpoint(const Cell& cell, std::uint32_t by, std::uint32_t side,
                                             const Arithmetic& arithmetic) const {
    const Map& map = map_at(by);
    spend(kCutOperations + 2 * kFunctionOperations);
    arithmetic.spend(kEdgeOperations + 2 * kTriangleOperations, darts_ / 2);
    arithmetic.spend(kFunctionOperations, darts_ / 3);
    const Cell half = halves(cell, side)[0];
    const std::uint32_t end = (side + 1) % 3;
    // No point of the cell is farther from the midpoint than a corner is.
    const Ball reach = acosh(max(half.cosh[side], half.cosh[end]));
    const auto least = arithmetic.number(sqr(sinh(Ball::exactly(document_.value.lower) + reach)));
    const std::vector<typename Arithmetic::Number> h = displacements(map, half.corner[end], arithmetic);
    return is_delaunay_and_wide(map.opposite, h, least);
  }

  /// d(p, gp) ≤ 2hi at the corners, and g ≠ 1, which is implied (docs/proof.md, section 12).
  template <class Arithmetic>
  [[nodiscard]] Tri is_bounded_by_edge(const Cell& cell, std::uint32_t by, const Arithmetic& arithmetic) const {
    arithmetic.spend(kEdgeOperations, 3);
    const auto most = arithmetic.number(most_);
    Tri within = Tri::yes;
    Tri moves = Tri::unknown;
    for (const BallVector& p : cell.corner) {
      const auto h = arithmetic.displacement_at(p)(map_at(by / darts_).element[by % darts_]);
      if (certainly_positive(h) == Tri::yes) moves = Tri::yes;
      within = both(within, !certainly_less(most, h));
    }
    return both(within, moves);
  }

  /// At the corners of the cell, every triangle lies in a disk of radius hi.
  template <class Arithmetic>
  [[nodiscard]] Tri is_bounded_by_triangulation(const Cell& cell, std::uint32_t by,
                                                const Arithmetic& arithmetic) const {
    const Map& map = map_at(by);
    arithmetic.spend(3 * (kEdgeOperations + kTriangleOperations), darts_ / 2);
    const auto most = arithmetic.number(most_);
    Tri result = Tri::yes;
    for (const BallVector& p : cell.corner) {
      const std::vector<typename Arithmetic::Number> h = displacements(map, p, arithmetic);
      for (std::uint32_t d = 0; d < darts_ && result != Tri::no; d += 3) {
        result = both(result, fits(SidesIn<typename Arithmetic::Number>(&h[d], 3), most));
      }
    }
    return result;
  }

  const BoundDocument& document_;
  Verification& run_;
  const CheckOptions& options_;
  unsigned threads_;
  const Budget& budget_;
  LabelParts parts_;
  LabelEvaluator evaluator_;
  std::uint32_t darts_;
  std::vector<Map> maps_;
  Base base_;
  std::vector<std::uint32_t> edges_;  ///< The net's: a dart of each.
  std::vector<Product> products_;     ///< Number edges_.size() + k is product k.
  std::optional<Elements> elements_;
  std::vector<Elements::Id> ids_;  ///< By number.
  std::optional<Domain> domain_;   ///< If there is a symmetry.
  std::vector<Cell> triangles_;    ///< Of the base, or the domain.
  Ball most_;                      ///< sinh² of the upper bound.
  slong precision_ = kFirstPrecision;
};

std::string text_of(const BoundDocument& document) {
  using Claim = BoundDocument::Claim;
  const std::string what = document.claim == Claim::diameter ? "the diameter"
                           : document.claim == Claim::radius ? "the radius"
                                                             : "the radius of the largest embedded disk";
  return what + " lies in " + to_string(document.value);
}

}  // namespace

RuleNames own_rules(const BoundDocument& document) {
  RuleNames rules{document.claim == BoundDocument::Claim::radius ? "upper" : "lower", "triangulations"};
  if (document.symmetry) rules.insert(rules.end(), {kIsometries, kDomain});
  rules.push_back("cells");
  return rules;
}

Claim claim_of(const BoundDocument& document) {
  const auto ask = [&](Verification& run, Crossings crossings) {
    BoundCheck(document, run, std::move(crossings)).ask();
  };
  return {document.net, text_of(document), own_rules(document), ask};
}

}  // namespace epsnet::certify
