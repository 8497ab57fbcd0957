#include "certify/claims/geodesics/chords.h"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "certify/lifted/interval_index.h"
#include "certify/net/darts.h"

namespace epsnet::certify {
namespace {

/// Operations of balls that a chord takes, and a comparison of two.
constexpr std::uint64_t kChordOperations = 150;
constexpr std::uint64_t kComparisonOperations = 4;

/// T g T⁻¹.
BallIsometry conjugate_by(const BallIsometry& t, const BallIsometry& g, slong precision) {
  BallIsometry result = compose(compose(t, g, precision), inverse(t), precision);
  choose_sign(result);
  return result;
}

/// |⟨w, n⟩| for the unit normal n of an axis: the same for both directions of the axis, so lines with different values
/// differ. The weights w lie on no symmetry of the surfaces that people make, so that different lines rarely have one
/// value; nothing depends on that but the time.
Interval axis_key(const BallVector& axis, slong precision) {
  constexpr std::array<slong, 3> kWeights{577, 341, 199};
  Ball value;
  for (std::size_t i = 0; i < 3; ++i) arb_addmul_si(value.get(), axis[i].get(), kWeights[i], precision);
  return outer_interval(abs(value));
}

bool all_finite(const BallVector& x) { return is_finite(x[0]) && is_finite(x[1]) && is_finite(x[2]); }

class ChordSearch {
 public:
  explicit ChordSearch(const LiftedPlane& plane) : plane_(plane), net_(plane.net()) {}

  /// From the first triangle of the vertex to a triangle that the axis possibly meets; false if it is not found.
  bool approach(std::uint32_t first_dart, const BallIsometry& element) {
    const slong precision = plane_.precision();
    Chord chord;
    chord.triangle = first_dart / 3;
    chord.element = conjugate_by(plane_.label(corner_label(net_, first_dart)), element, precision);
    if (!measure(chord)) return false;
    BallVector foot = foot_of(plane_.corner(first_dart), chord.axis);
    while (misses(chord)) {
      const std::uint32_t dart = dart_towards(chord.triangle, foot);
      if (dart == Chord::kNone) return false;
      list_.approach.push_back(dart);
      chord = across(chord, dart);
      if (!measure(chord)) return false;
      if (const auto* transition = plane_.transition(dart)) foot = apply(transition->matrix, foot, precision);
    }
    list_.chords.push_back(std::move(chord));
    return true;
  }

  /// All chords from the first one, up to where `visit` says false; false if balls do not decide.
  bool flood(const std::function<bool(const Chord&)>& visit) {
    by_triangle_[list_.chords[0].triangle].insert(list_.chords[0].key, 0);
    for (std::uint32_t i = 0; i < list_.chords.size(); ++i) {
      if (visit && !visit(list_.chords[i])) return true;
      for (std::uint32_t edge = 0; edge < 3; ++edge) {
        const Chord& chord = list_.chords[i];
        const int here = chord.side[edge];
        if (here != 0 && here == chord.side[(edge + 1) % 3]) continue;
        Chord next = across(chord, 3 * chord.triangle + edge);
        next.parent = i;
        next.dart = 3 * chord.triangle + edge;
        if (!measure(next) || !add(std::move(next))) return false;
      }
    }
    return lies_on_both_sides();
  }

  ChordList list() && { return std::move(list_); }

 private:
  /// The orthogonal projection of x to the axis, X − ⟨X, n⟩ n.
  [[nodiscard]] BallVector foot_of(const BallVector& x, const BallVector& axis) const {
    const slong precision = plane_.precision();
    const Precision scope(precision);
    Ball distance;
    dot(distance, axis, x, precision);
    // The row (n₀, n₁, −n₂) belongs to the vector n.
    return {x[0] - distance * axis[0], x[1] - distance * axis[1], x[2] + distance * axis[2]};
  }

  /// A dart of the triangle that has the point certainly on its other side.
  [[nodiscard]] std::uint32_t dart_towards(std::uint32_t triangle, const BallVector& point) const {
    Ball value;
    for (std::uint32_t dart = 3 * triangle; dart < 3 * triangle + 3; ++dart) {
      dot(value, plane_.line(dart), point, plane_.precision());
      if (certainly_negative(value) == Tri::yes) return dart;
    }
    return Chord::kNone;
  }

  [[nodiscard]] Chord across(const Chord& chord, std::uint32_t dart) const {
    Chord next;
    next.triangle = opposite(net_, dart) / 3;
    if (const auto* transition = plane_.transition(dart)) {
      next.element = conjugate_by(transition->isometry, chord.element, plane_.precision());
    } else {
      next.element = chord.element;
    }
    return next;
  }

  /// The axis and the sides of the corners; false if there is no axis to this precision.
  [[nodiscard]] bool measure(Chord& chord) const {
    plane_.spend(kChordOperations);
    // The sides of the axis are told apart only by an element whose sign is chosen.
    if (certainly_positive(real(chord.element.a)) != Tri::yes) return false;
    chord.axis = axis_row(chord.element, plane_.precision());
    if (!all_finite(chord.axis)) return false;
    chord.key = axis_key(chord.axis, plane_.precision());
    Ball value;
    for (std::uint32_t i = 0; i < 3; ++i) {
      dot(value, chord.axis, plane_.corner(3 * chord.triangle + i), plane_.precision());
      chord.side[i] = certain_sign(value);
    }
    return true;
  }

  static bool misses(const Chord& chord) {
    return chord.side[0] != 0 && chord.side[0] == chord.side[1] && chord.side[1] == chord.side[2];
  }

  /// The lifted triangles are connected, so if they have corners on both sides the axis truly meets one of them; and
  /// from there no other is missed.
  [[nodiscard]] bool lies_on_both_sides() const {
    const auto has_corner = [&](int side) {
      return std::any_of(list_.chords.begin(), list_.chords.end(), [&](const Chord& chord) {
        return std::find(chord.side.begin(), chord.side.end(), side) != chord.side.end();
      });
    };
    return has_corner(1) && has_corner(-1);
  }

  /// Adds a chord that is not there yet.
  bool add(Chord&& chord) {
    IntervalIndex& known = by_triangle_[chord.triangle];
    const std::uint32_t chart = chart_of_triangle(net_, chord.triangle);
    const std::vector<std::uint32_t> near = known.near(chord.key);
    plane_.spend(kComparisonOperations, near.size());
    for (const std::uint32_t i : near) {
      const Tri same = plane_.same(chart, list_.chords[i].element, chord.element);
      if (same == Tri::yes) return true;
      if (same == Tri::unknown) return false;
    }
    plane_.keep(10);
    known.insert(chord.key, static_cast<std::uint32_t>(list_.chords.size()));
    list_.chords.push_back(std::move(chord));
    return true;
  }

  const LiftedPlane& plane_;
  const NetDocument& net_;
  ChordList list_;
  std::unordered_map<std::uint32_t, IntervalIndex> by_triangle_;  ///< By the chords' keys.
};

}  // namespace

Interval translation_length(const BallIsometry& element, slong precision) {
  const Precision scope(precision);
  const Interval interval = outer_interval(twice(acosh(cosh_half_length(element))));
  return {std::max(interval.lower, 0.0), interval.upper};
}

std::vector<std::uint32_t> first_darts(const NetDocument& net) {
  std::vector<std::uint32_t> darts(net.vertices.size());
  for (std::uint32_t dart = 3 * static_cast<std::uint32_t>(net.triangles.size()); dart-- > 0;) {
    darts[start(net, dart)] = dart;
  }
  return darts;
}

std::optional<ChordList> find_chords(const LiftedPlane& plane, std::uint32_t first_dart, const BallIsometry& element,
                                     const std::function<bool(const Chord&)>& visit) {
  ChordSearch search(plane);
  if (!search.approach(first_dart, element) || !search.flood(visit)) return std::nullopt;
  return std::move(search).list();
}

}  // namespace epsnet::certify
