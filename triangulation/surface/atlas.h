#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "kernel/numbers.h"
#include "kernel/plane.h"
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

/// A point of the surface as a vertex, lifted to a chart of reference: a chart, coordinates with |z| ≤ kChartRadius
/// there, and the label from that chart to the chart of reference.
struct LiftedPoint {
  ChartId chart;
  Complex<double> z;
  LabelId label;
};

/// The charts of a surface and the isometries between them ("labels"): exactly as words, rounded to binary64, and to
/// 200 bits or more on request.
///
/// Three parts: the charts, the table of the labels, and the evaluator of words. The atlas makes labels from words,
/// from products and inverses, which it memoises, and from points. There are only hundreds to thousands of labels,
/// whatever the number of triangles.
class Atlas {
 public:
  /// Throws LimitError, which names the tile, if closed geodesics may be too short to distinguish labels (about 10⁻²⁶).
  explicit Atlas(const Surface& surface);

  /// The surface whose charts these are.
  [[nodiscard]] const Surface& surface() const { return charts_.surface(); }
  /// The charts.
  [[nodiscard]] const Charts& charts() const { return charts_; }
  /// The labels that there are so far.
  [[nodiscard]] const LabelTable& labels() const { return labels_; }
  /// Returns the number of isometries multiplied so far to evaluate words, which is the cost of new labels.
  [[nodiscard]] std::uint64_t factor_count() const { return words_.factor_count(); }

  /// As Charts::add.
  ChartId add_chart(Chart chart) { return charts_.add(std::move(chart)); }

  /// The label of a word from the tile of chart `from` to the tile of chart `to`. Throws LimitError if the word leads
  /// too far to be evaluated.
  [[nodiscard]] LabelId label(ChartId from, ChartId to, Word word);
  /// Returns f ∘ g. Requires: g leads to the chart that f leads from.
  [[nodiscard]] LabelId product(LabelId f, LabelId g) {
    if (f == kIdentity) {
      return g;
    }
    if (g == kIdentity) {
      return f;
    }
    return product_of_others(f, g);
  }
  /// The label of the inverse isometry.
  [[nodiscard]] LabelId inverse(LabelId f) {
    const LabelId known = known_inverse(f);
    return known != kUnknownLabel ? known : inverse_of_other(f);
  }
  /// Returns f ∘ f ∘ … ∘ f, n times. Requires: f leads from a chart to itself. O(log n) products.
  [[nodiscard]] LabelId power(LabelId f, std::uint64_t n);
  /// Returns f ∘ g if it was computed before, or if binary64 proves it equal to an existing label; else kUnknownLabel.
  /// Of the functions that multiply, only this and known_inverse() may be called concurrently.
  [[nodiscard]] LabelId known_product(LabelId f, LabelId g) const;
  /// Returns the label of the inverse isometry if it was computed before, else kUnknownLabel.
  [[nodiscard]] LabelId known_inverse(LabelId f) const { return f == kIdentity ? kIdentity : labels_.inverse(f); }

  /// The isometry of a label, not the identity, in binary64.
  [[nodiscard]] const Isometry<double>& isometry(LabelId l) const { return labels_.isometry(l); }
  /// Bounds the Euclidean distance of the image of a point with |z| ≤ 0.75 that is computed with `isometry` from the
  /// true image.
  [[nodiscard]] double error(LabelId l) const { return labels_.image_error(l); }
  /// Returns the isometry of a label, scaled to determinant 1, in Mp256 (about 200 bits), Mp1024 (620 bits, relative to
  /// the entries) or Mp4096 (2020 bits). Evaluated on first use. Requires: the label is not the identity.
  template <class T>
  [[nodiscard]] const Isometry<T>& isometry_in(LabelId l);
  /// The image of a point with |z| ≤ 0.75 under a label, to within `lift_error<T>()`.
  template <class T>
  [[nodiscard]] Complex<T> lift(LabelId l, const Complex<double>& z);
  /// The error of `lift` in T.
  template <class T>
  [[nodiscard]] static T lift_error();

  /// How exactly `lifted_point` keeps a point.
  enum class Precision {
    binary64,  ///< Coordinates near the origin of a chart, rounded to binary64.
    bits_256,  ///< The point becomes the origin of its own chart, which keeps 256 bits of z.
  };
  /// Returns the point with coordinate z in chart c as a vertex; nullopt if it is too far away: 10,000 tiles, or
  /// farther than labels can be evaluated.
  [[nodiscard]] std::optional<LiftedPoint> lifted_point(ChartId c, const Complex<Mp1024>& z, Precision precision);
  /// Like `lifted_point`, for a point known in binary64, and with existing labels only. Returns nullopt if no label
  /// takes the point near the origin of a chart.
  [[nodiscard]] std::optional<LiftedPoint> lifted_point_nearby(ChartId c, const Complex<double>& z) const;

 private:
  /// A point in the coordinates of the tile that contains it, and the path to that tile.
  struct TilePoint {
    TileId tile;
    Complex<Mp1024> z;
    Word path;
  };
  /// The point with the coordinate z in a tile; nullopt if it is too many tiles away.
  [[nodiscard]] std::optional<TilePoint> walk_through_tiles(TileId tile, const Complex<Mp1024>& z) const;

  [[nodiscard]] LabelId product_of_others(LabelId f, LabelId g);
  [[nodiscard]] LabelId inverse_of_other(LabelId f);
  /// LabelTable::find for f ∘ g.
  [[nodiscard]] std::optional<LabelId> find_product(LabelId f, LabelId g) const;
  /// The label of a value, a new one or not.
  [[nodiscard]] LabelId find_or_add(ChartId from, ChartId to, const Evaluated<Mp256>& value, Word word);
  /// As `label`; nullopt if the word leads too far to be evaluated.
  [[nodiscard]] std::optional<LabelId> find_label(ChartId from, ChartId to, Word word);
  /// The value that labels are compared by; nullopt if the word leads too far to be evaluated.
  [[nodiscard]] std::optional<Evaluated<Mp256>> evaluate_label(ChartId from, ChartId to, const Word& word) const;
  /// That of a label. Throws LimitError if its word leads too far.
  [[nodiscard]] const Evaluated<Mp256>& precise(LabelId l);

  Charts charts_;
  LabelTable labels_;
  WordEvaluator words_;
};

/// Products and inverses of labels of an atlas, as far as it has them: several threads may have an object each
/// as long as nobody adds labels. The other way round, an object stays right when labels are added.
class KnownLabels {
 public:
  explicit KnownLabels(const Atlas& atlas) : atlas_(&atlas) {}

  /// f ∘ g; kUnknownLabel if it is not known or if f or g is not.
  [[nodiscard]] LabelId product(LabelId f, LabelId g) {
    if (f == kIdentity) return g;
    if (g == kIdentity) return f;
    Recent& recent = recent_[slot(f, g)];
    if (recent.f != f || recent.g != g) {
      if (f == kUnknownLabel || g == kUnknownLabel) return kUnknownLabel;
      const LabelId known = atlas_->known_product(f, g);
      if (known == kUnknownLabel) return kUnknownLabel;
      recent = {f, g, known};
    }
    return recent.product;
  }
  [[nodiscard]] LabelId inverse(LabelId f) const { return atlas_->known_inverse(f); }
  [[nodiscard]] const Atlas& atlas() const { return *atlas_; }

 private:
  struct Recent {
    LabelId f = kIdentity;
    LabelId g = kIdentity;
    LabelId product = kIdentity;
  };
  static constexpr unsigned kBits = 12;
  [[nodiscard]] static std::size_t slot(LabelId f, LabelId g) {
    constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;  // Multiplicative hashing.
    return static_cast<std::size_t>((((std::uint64_t{f} << 32) | g) * kGolden) >> (64 - kBits));
  }

  const Atlas* atlas_;
  std::vector<Recent> recent_ = std::vector<Recent>(std::size_t{1} << kBits);
};

/// A lower bound of the lengths of closed geodesics, from one tile: no geodesic of the surface is shorter than the
/// smallest of its tiles' bounds (docs/error-bounds.md). Near the length of a short geodesic that crosses the tile; at
/// least 10⁻⁹⁰, which also stands for less.
///
/// Quadratic in the number of sides.
[[nodiscard]] double curve_bound(const Tile& tile);

}  // namespace epsnet
