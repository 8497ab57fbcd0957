#pragma once

#include <optional>
#include <vector>

#include "certify/lifted/lorentz.h"
#include "certify/net/labels.h"

/// The lifted triangulation at one precision: each triangle in its chart, and what leads across its darts.
namespace epsnet::certify {

/// One precision's view of a net that passed `check`. Reads only after construction, so threads may share it. Fault, if
/// there is no such label, dart, triangle or chart.
class LiftedPlane {
 public:
  /// `net`, which must outlive the plane, may have labels that no triangle uses. O(size of the net) time and memory,
  /// about 1 kB a triangle.
  LiftedPlane(const NetDocument& net, const LabelEvaluator& evaluator, const LabelParts& parts, slong precision,
              slong cap, unsigned threads);
  LiftedPlane(const NetDocument&& net, const LabelEvaluator& evaluator, const LabelParts& parts, slong precision,
              slong cap, unsigned threads) = delete;

  [[nodiscard]] slong precision() const { return precision_; }
  [[nodiscard]] const NetDocument& net() const { return net_; }
  /// Takes the work of so many operations of balls off the budget.
  void spend(std::uint64_t operations, std::uint64_t times = 1) const {
    budget_.spend(operations * ball_work(static_cast<std::uint64_t>(precision_)), times);
  }
  /// The same for memory for so many balls.
  void keep(std::uint64_t balls, std::uint64_t times = 1) const {
    budget_.spend(memory_work(balls * (48 + static_cast<std::uint64_t>(precision_) / 8)), times);
  }

  /// The value of a label number; 0 is the identity.
  [[nodiscard]] const BallIsometry& label(std::uint32_t number) const {
    return looked_up(labels_, number, "there is no value of label number");
  }
  /// The corner where the dart starts, as a unit vector in the chart of its triangle.
  [[nodiscard]] const BallVector& corner(std::uint32_t dart) const { return looked_up(corners_, dart, kNoDart); }

  /// From the chart of a dart's triangle to that of the triangle across.
  struct Transition {
    BallIsometry isometry;
    BallMatrix matrix;
  };
  /// Nothing where the two charts are the same and the transition is the identity.
  [[nodiscard]] const Transition* transition(std::uint32_t dart) const {
    const std::uint32_t number = looked_up(transition_of_, dart, kNoDart);
    return number == 0 ? nullptr : &transitions_[number - 1];
  }

  /// Whether two elements of the surface's group, written in one chart, are the same; signs are chosen (choose_sign).
  ///
  /// `yes` by discreteness (docs/proof.md, Lemma 2), `no` by disjoint balls.
  [[nodiscard]] Tri same(std::uint32_t chart, const BallIsometry& f, const BallIsometry& g) const;

 private:
  static constexpr const char* kNoDart = "there is no dart";

  void evaluate_labels(const LabelEvaluator& evaluator, slong cap, unsigned threads);
  void find_transitions();
  void find_disks(const LabelParts& parts, slong cap);

  const NetDocument& net_;
  const Budget& budget_;
  slong precision_;
  std::vector<BallIsometry> labels_;
  std::vector<BallVector> corners_;
  std::vector<Transition> transitions_;
  std::vector<std::uint32_t> transition_of_;  ///< By dart, plus 1; 0 for the identity.

  /// A disk inside the tile of a chart: `base` takes 0 to its centre, in the chart's coordinates.
  struct Disk {
    BallIsometry base;
    Ball sinh_radius;
  };
  std::vector<std::optional<Disk>> disks_;  ///< By chart.
};

}  // namespace epsnet::certify
