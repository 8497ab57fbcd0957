#pragma once

#include <cassert>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "triangulation/surface/charts.h"
#include "triangulation/surface/surface.h"
#include "triangulation/surface/words.h"

namespace epsnet {

/// The number of a label in an atlas. Two labels between the same charts are the same isometry if and only if they have
/// the same number.
using LabelId = std::uint32_t;

/// The identity, of whatever chart it is used in.
inline constexpr LabelId kIdentity = 0;
/// No label: the result is not known.
inline constexpr LabelId kUnknownLabel = ~LabelId{0};

/// The labels of an atlas, with what is known of each and of their products. Multiplies nothing: `Atlas` does.
///
/// Invariant: labels between the same two charts are different isometries, as whoever adds one promises.
class LabelTable {
 public:
  /// A label other than the identity.
  struct Entry {
    ChartId from;
    ChartId to;
    Word word;
    Isometry<DoubleDouble> value;
    double error;                             ///< Bounds ν of the error of `value`, ν(a, b) = |a| + |b|.
    std::optional<Evaluated<Mp256>> precise;  ///< Evaluated when first asked for.
  };

  /// The number of labels, the identity included.
  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(entries_.size()) + 1; }
  /// Whether there is a label of this number, and it is not the identity.
  [[nodiscard]] bool has(LabelId l) const { return l != kIdentity && l <= entries_.size(); }
  /// Requires, as all below that take a label: has(l).
  [[nodiscard]] const Entry& operator[](LabelId l) const {
    assert(has(l));
    return entries_[l - 1];
  }
  /// The isometry in binary64.
  [[nodiscard]] const Isometry<double>& isometry(LabelId l) const { return rounded(l).isometry; }
  /// Bounds the Euclidean distance of the image of a point with |z| ≤ 0.75 that is computed with `isometry` from the
  /// true image (docs/error-bounds.md, E5).
  [[nodiscard]] double image_error(LabelId l) const { return rounded(l).error; }
  /// kUnknownLabel until set.
  [[nodiscard]] LabelId inverse(LabelId l) const { return rounded(l).inverse; }
  /// f ∘ g, kUnknownLabel until set.
  [[nodiscard]] LabelId product(LabelId f, LabelId g) const;
  /// The isometry in T (Mp1024, Mp4096); null until set.
  template <class T>
  [[nodiscard]] const Isometry<T>* isometry_in(LabelId l) const;
  /// The labels that lead to a chart, in the order of their numbers.
  [[nodiscard]] std::span<const LabelId> to(ChartId chart) const;
  /// The labels between two charts, in the order of their numbers.
  [[nodiscard]] std::span<const LabelId> between(ChartId from, ChartId to) const;
  /// The label of an isometry h between two charts among those that exist, the identity included; kUnknownLabel if it
  /// is certainly none of them; nothing if binary64 does not tell. The disk is that of chart `from`; h is off by at
  /// most 6u·size, size ≥ ν(h) (docs/error-bounds.md, E6).
  [[nodiscard]] std::optional<LabelId> find(ChartId from, ChartId to, const Charts::Disk& disk,
                                            const Isometry<double>& h, double size) const;

  /// Adds a label. Requires: it is certainly different from all existing ones between its charts.
  LabelId add(Entry entry);
  /// Makes two labels inverse to each other.
  void set_inverse(LabelId f, LabelId inverse) {
    assert(has(f) && has(inverse));
    rounded_[f - 1].inverse = inverse;
    rounded_[inverse - 1].inverse = f;
  }
  /// Remembers f ∘ g.
  void set_product(LabelId f, LabelId g, LabelId product);
  /// Remembers the precise value of a label, and returns it.
  const Evaluated<Mp256>& set_precise(LabelId l, Evaluated<Mp256> value);
  /// Remembers the isometry of a label in T, and returns it.
  template <class T>
  const Isometry<T>& set_isometry(LabelId l, const Isometry<T>& value);

 private:
  struct Rounded {
    Isometry<double> isometry;
    double error;
    LabelId inverse;
  };
  [[nodiscard]] const Rounded& rounded(LabelId l) const {
    assert(has(l));
    return rounded_[l - 1];
  }

  std::deque<Entry> entries_;
  std::vector<Rounded> rounded_;  ///< Apart, as the fast path wants nothing else.
  ById<ChartId, std::vector<LabelId>> to_;
  std::unordered_map<std::uint64_t, std::vector<LabelId>> between_;
  std::unordered_map<std::uint64_t, LabelId> products_;
  template <class T>
  using Values = std::unordered_map<LabelId, Isometry<T>>;
  std::tuple<Values<Mp1024>, Values<Mp4096>> values_;
};

}  // namespace epsnet
