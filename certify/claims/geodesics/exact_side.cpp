#include "certify/claims/geodesics/exact_side.h"

#include <algorithm>

#include "certify/net/darts.h"

namespace epsnet::certify {
namespace {

/// The side of an axis on which a corner of one of its chords lies, over the ring of one kind of crossings.
template <class CrossingsOfAKind>
class ExactSide {
 public:
  using Number = typename CrossingsOfAKind::Number;

  ExactSide(const NetDocument& net, const LabelEvaluator& evaluator, const CrossingsOfAKind& crossings)
      : net_(net), evaluator_(evaluator), crossings_(crossings) {}

  /// The sign of ⟨n, X⟩, X the corner where `dart` starts; the element is the inverse of label `number` at the vertex
  /// that `first_dart` leaves, carried along the path. Nothing if the numbers are too large.
  [[nodiscard]] std::optional<int> sign_at(std::uint32_t number, std::uint32_t first_dart,
                                           const std::vector<std::uint32_t>& path, std::uint32_t dart) const {
    if (size(number, first_dart, path, dart) > CrossingsOfAKind::kMaxExactBits) return std::nullopt;
    Isometry<Number> to_chart = label(corner_label(net_, first_dart));
    for (const std::uint32_t crossed : path) {
      const std::uint32_t here = corner_label(net_, crossed);
      const std::uint32_t there = corner_label(net_, next_dart(opposite(net_, crossed)));
      if (here == there) continue;
      to_chart = compose(label(there), compose(inverse(label(here)), to_chart));
      reduce(to_chart);
    }
    const Isometry<Number> element = compose(to_chart, compose(inverse(label(number)), inverse(to_chart)));
    const NetDocument::Vertex& vertex = net_.vertices[start(net_, dart)];
    const auto x = hyperboloid_vector(moved(label(corner_label(net_, dart)), exact_point(vertex.x, vertex.y)));
    // The normal is (−Im b, Re b, Im a), with the sign of Re a.
    const int value =
        sign(twice_real(element.b) * x.y - twice_imaginary(element.b) * x.x - twice_imaginary(element.a) * x.t);
    return sign(twice_real(element.a)) * value;
  }

 private:
  [[nodiscard]] Isometry<Number> label(std::uint32_t number) const {
    return evaluator_.evaluate_exactly(crossings_, number);
  }

  [[nodiscard]] std::size_t size(std::uint32_t number, std::uint32_t first_dart, const std::vector<std::uint32_t>& path,
                                 std::uint32_t dart) const {
    std::size_t bits = evaluator_.exact_bits(number) + evaluator_.exact_bits(corner_label(net_, dart)) +
                       2 * evaluator_.exact_bits(corner_label(net_, first_dart));
    for (const std::uint32_t crossed : path) {
      bits += 2 * evaluator_.exact_bits(corner_label(net_, crossed));
      bits += 2 * evaluator_.exact_bits(corner_label(net_, next_dart(opposite(net_, crossed))));
    }
    return bits;
  }

  const NetDocument& net_;
  const LabelEvaluator& evaluator_;
  const CrossingsOfAKind& crossings_;
};

/// The darts that are crossed from the first triangle of a geodesic to a chord.
std::vector<std::uint32_t> path_to(const ChordList& list, std::uint32_t chord) {
  std::vector<std::uint32_t> path;
  for (std::uint32_t k = chord; list.chords[k].parent != Chord::kNone; k = list.chords[k].parent) {
    path.push_back(list.chords[k].dart);
  }
  path.insert(path.end(), list.approach.rbegin(), list.approach.rend());
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace

std::optional<int> exact_side(const NetDocument& net, const LabelEvaluator& evaluator, const ChordTable& table,
                              std::uint32_t number, ChordTable::Place place, std::uint32_t corner) {
  const std::vector<std::uint32_t> path = path_to(table.list(place.geodesic), place.chord);
  const std::uint32_t dart = 3 * table.chord(place).triangle + corner;
  const std::optional<int> sign = std::visit(
      [&](const auto& crossings) {
        return ExactSide(net, evaluator, crossings).sign_at(number, table.first_dart(place.geodesic), path, dart);
      },
      evaluator.crossings());
  if (!sign) return std::nullopt;
  return *sign < 0 ? -1 : 1;
}

}  // namespace epsnet::certify
