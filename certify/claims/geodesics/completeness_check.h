#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "certify/claims/geodesics/chord_table.h"
#include "certify/claims/geodesics/crossing_pass.h"
#include "certify/claims/geodesics/document.h"
#include "certify/numbers/precision.h"
#include "certify/verdict/report.h"

namespace epsnet::certify {

/// Rule `complete`: every primitive closed geodesic of length at most L is in the list, or, for a systole, none is
/// shorter than the one listed (docs/proof.md, section 11).
///
/// Vertex by vertex: what one precision decides is not asked again at the next. L is the `up_to` of a spectrum, 2
/// arsinh 1 for a thick-thin decomposition, and the length of the geodesic listed for a systole. Lengths that balls do
/// not tell apart are compared exactly.
class CompletenessCheck {
 public:
  /// All must outlive the check. The document has no structure problem and its net is verified. The evaluator's
  /// document is that net with the words of the geodesics as further labels, in the order of the list.
  CompletenessCheck(const GeodesicsDocument& document, const LabelEvaluator& evaluator, const CheckOptions& options);

  /// Whether the search across edges should be asked, as long as it does not take too long.
  [[nodiscard]] bool crosses_edges() const { return crosses_edges_; }
  /// By the search across edges, of a list that is complete(). Nothing if it takes too long, and the search around
  /// vertices should be asked.
  [[nodiscard]] std::optional<RuleReport> check(const CrossingPass& crossings, slong precision, unsigned threads);
  /// No more searches across edges.
  void give_up_crossings();

  /// By the search around vertices: continues with those that are still open; the table is that of the list's geodesics
  /// at the precision of the plane. The report does not depend on the number of threads.
  [[nodiscard]] RuleReport check(const LiftedPlane& plane, const ChordTable& table, unsigned threads);

  /// Whether a vertex needs more visits than are allowed: more bits do not help.
  [[nodiscard]] bool limit_reached() const;
  [[nodiscard]] std::uint64_t visits() const;
  [[nodiscard]] std::uint64_t candidates() const;
  [[nodiscard]] std::uint64_t deep_vertices() const;

  /// The least precision at which it makes sense to ask.
  [[nodiscard]] slong first_precision() const { return crosses_edges_ ? 128 : kFirstPrecision; }

  /// cosh(L/2). The plane is of the evaluator's document.
  [[nodiscard]] Ball cosh_half_bound(const LiftedPlane& plane) const;
  /// L in words.
  [[nodiscard]] std::string bound_name() const;

 private:
  class Pass;

  [[nodiscard]] RuleReport verified() const;
  template <class Count>
  [[nodiscard]] std::uint64_t sum(const Count& count) const;

  /// The label number of the first geodesic's word.
  [[nodiscard]] std::uint32_t first_element() const {
    return static_cast<std::uint32_t>(document_.net.labels.size()) + 1;
  }

  const GeodesicsDocument& document_;
  const LabelEvaluator& evaluator_;
  mpq_class up_to_;                                         ///< Of a spectrum.
  std::function<void(std::string_view, double)> progress_;  ///< As in CheckOptions.
  std::uint64_t max_visits_;
  std::uint64_t limit_;  ///< Visits for one vertex.
  std::vector<SearchPart> vertices_;
  std::vector<SearchPart> crossings_;              ///< Of the last precision, if the search is across edges.
  bool crosses_edges_;                             ///< Whether that search is tried first.
  std::vector<std::vector<std::uint32_t>> loops_;  ///< By vertex: darts from it to itself.
};

}  // namespace epsnet::certify
