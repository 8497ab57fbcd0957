#pragma once

#include <cassert>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "kernel/double_double.h"
#include "kernel/isometry.h"
#include "kernel/numbers.h"
#include "triangulation/surface/error.h"
#include "triangulation/surface/surface.h"

namespace epsnet {

/// A surface or a triangulation is beyond a limit: too many triangles or labels, a path too long to be evaluated.
class LimitError : public Error {
 public:
  using Error::Error;
};

/// A chart: the Poincaré disk of a tile with the origin moved to `centre`; the point z of the chart has the coordinate
/// (z + centre)/(1 + conj(centre) z) in the tile.
struct Chart {
  std::uint32_t tile;
  Complex<Rational> centre;
};

/// The number of a label in an atlas. Two labels between the same charts are the same isometry if and only if they have
/// the same number.
using LabelId = std::uint32_t;

/// The identity, of whatever chart it is used in.
inline constexpr LabelId kIdentity = 0;
/// No label: the result is not known.
inline constexpr LabelId kUnknownLabel = ~LabelId{0};

/// No point of a chart that is used as a vertex is farther from the origin than this (Euclidean, Poincaré disk).
inline constexpr double kChartRadius = 0.7;

/// The charts of a surface and the isometries between them ("labels"): exactly as words, rounded to binary64, and to
/// 200 bits or more on request.
///
/// There are only hundreds to thousands of labels, whatever the number of triangles. Products and inverses are
/// memoised.
class Atlas {
 public:
  /// Throws LimitError, which names the tile, if closed geodesics may be too short to distinguish labels (about 10⁻²⁶).
  explicit Atlas(const Surface& surface);

  /// The surface whose charts these are.
  [[nodiscard]] const Surface& surface() const { return surface_; }

  /// Appends a chart without checking for duplicates; returns its number.
  [[nodiscard]] std::uint32_t add_chart(Chart chart);
  /// Returns the number of charts. They are numbered from 0.
  [[nodiscard]] std::uint32_t chart_count() const { return static_cast<std::uint32_t>(charts_.size()); }
  /// Returns chart c.
  [[nodiscard]] const Chart& chart(std::uint32_t c) const {
    assert(c < chart_count());
    return charts_[c].chart;
  }
  /// The isometry from the coordinates of a chart to those of its tile.
  template <class T>
  [[nodiscard]] Isometry<T> frame(std::uint32_t c) const;

  /// The label of a word from the tile of chart `from` to the tile of chart `to`. Throws LimitError if the word leads
  /// too far to be evaluated.
  [[nodiscard]] LabelId label(std::uint32_t from, std::uint32_t to, Word word);
  /// The number of labels, the identity included.
  [[nodiscard]] std::uint32_t label_count() const { return static_cast<std::uint32_t>(labels_.size()) + 1; }
  /// The chart that the label leads from. Requires: it is not the identity.
  [[nodiscard]] std::uint32_t from(LabelId l) const {
    assert(is_other(l));
    return labels_[l - 1].from;
  }
  /// The chart that the label leads to. Requires: it is not the identity.
  [[nodiscard]] std::uint32_t to(LabelId l) const {
    assert(is_other(l));
    return labels_[l - 1].to;
  }
  /// The word of a label, from the tile of its first chart to the tile of its second chart. Requires: it is not the
  /// identity.
  [[nodiscard]] const Word& word(LabelId l) const {
    assert(is_other(l));
    return labels_[l - 1].word;
  }
  /// The labels that lead to a chart, without the identity.
  [[nodiscard]] std::span<const LabelId> labels_to(std::uint32_t c) const {
    assert(c < chart_count());
    return charts_[c].incoming;
  }
  /// Returns the number of isometries multiplied so far to evaluate words, which is the cost of new labels.
  [[nodiscard]] std::uint64_t factor_count() const { return factor_count_; }

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
  /// Returns f ∘ g if it was computed before, or if binary64 proves it equal to an existing label; else kUnknownLabel.
  /// Only this and known_inverse() may be called concurrently.
  [[nodiscard]] LabelId known_product(LabelId f, LabelId g) const;
  /// Returns the label of the inverse isometry if it was computed before, else kUnknownLabel.
  [[nodiscard]] LabelId known_inverse(LabelId f) const {
    assert(f == kIdentity || is_other(f));
    return f == kIdentity ? kIdentity : rounded_[f - 1].inverse;
  }
  /// Returns f ∘ f ∘ … ∘ f, n times. Requires: f leads from a chart to itself. O(log n) products.
  [[nodiscard]] LabelId power(LabelId f, std::uint64_t n);

  /// The isometry of a label, not the identity, in binary64.
  [[nodiscard]] Isometry<double> isometry(LabelId l) const {
    assert(is_other(l));
    return rounded_[l - 1].isometry;
  }
  /// Bounds the Euclidean distance of the image of a point with |z| ≤ 0.75 that is computed with `isometry` from the
  /// true image (docs/error-bounds.md, E5).
  [[nodiscard]] double error(LabelId l) const {
    assert(is_other(l));
    return rounded_[l - 1].error;
  }

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

  /// The point of the surface with coordinate z in chart c as a vertex: a chart, coordinates with |z| ≤ kChartRadius
  /// there, and the label from that chart to c.
  struct Place {
    std::uint32_t chart;
    Complex<double> z;
    LabelId label;
  };
  /// How exactly `place` keeps a point.
  enum class Precision {
    binary64,  ///< Coordinates near the origin of a chart, rounded to binary64.
    bits_256,  ///< The point becomes the origin of its own chart, which keeps 256 bits of z.
  };
  /// Returns the point with coordinate z in chart c as a vertex; nullopt if it is too far away: 10,000 tiles, or
  /// farther than labels can be evaluated.
  [[nodiscard]] std::optional<Place> place(std::uint32_t c, const Complex<Mp1024>& z, Precision precision);
  /// Like `place`, for a point known in binary64, and with existing labels only. Returns nullopt if no label takes the
  /// point near the origin of a chart.
  [[nodiscard]] std::optional<Place> place_nearby(std::uint32_t c, const Complex<double>& z);

 private:
  /// A point in the coordinates of the tile that contains it, and the path to that tile.
  struct TilePoint {
    std::uint32_t tile;
    Complex<Mp1024> z;
    Word path;
  };
  /// The point with the coordinate z in a tile; nullopt if it is too many tiles away.
  [[nodiscard]] std::optional<TilePoint> walk_through_tiles(std::uint32_t tile, const Complex<Mp1024>& z) const;
  /// A side of a tile on whose right z lies, other than `entered`, the one through which a walk came; nullopt if z is
  /// in the tile.
  [[nodiscard]] std::optional<std::uint32_t> side_before(std::uint32_t tile, const Complex<Mp1024>& z,
                                                         std::optional<std::uint32_t> entered) const;
  /// The chart of the tile whose origin is nearest to the point, if that is near.
  [[nodiscard]] std::optional<std::uint32_t> chart_near(const TilePoint& point) const;

  /// A disk (its interior) that meets none of its images under the group: an isometry of the group other than 1 moves
  /// its centre by twice its radius or more.
  struct Disk {
    Complex<double> centre;
    double sinh_radius;  ///< 0 where binary64 does not see such a disk.
  };
  struct ChartEntry {
    Chart chart;
    Complex<double> centre;  ///< chart.centre, rounded.
    Disk disk;               ///< In the coordinates of the chart.
    Isometry<Mp256> unit_frame;
    std::vector<LabelId> incoming;
  };
  /// An isometry that is within 2^−accuracy, relative to its entries.
  template <class T>
  struct Value {
    Isometry<T> isometry;
    double accuracy;
  };
  struct LabelEntry {
    std::uint32_t from;
    std::uint32_t to;
    Word word;
    Isometry<DoubleDouble> value;
    double error;                         ///< Bounds ν of the error of `value`, ν(a, b) = |a| + |b|.
    std::optional<Value<Mp256>> precise;  ///< Evaluated when first asked for.
  };

  struct Rounded {
    Isometry<double> isometry;
    double error;
    LabelId inverse;  ///< kUnknownLabel until computed.
  };

  /// Whether there is a label of this number, and it is not the identity.
  [[nodiscard]] bool is_other(LabelId l) const { return l != kIdentity && l <= labels_.size(); }
  [[nodiscard]] LabelId product_of_others(LabelId f, LabelId g);
  [[nodiscard]] LabelId inverse_of_other(LabelId f);
  /// A disk inside of a tile, from its corners, in its coordinates.
  [[nodiscard]] static Disk disk_inside(std::span<const Complex<double>> tile);
  /// The label of an isometry h among those that exist, kUnknownLabel if it is certainly none of them; nothing if
  /// binary64 does not tell. h is off by at most 6u·size, size ≥ ν(h) (docs/error-bounds.md, E6).
  [[nodiscard]] std::optional<LabelId> find(std::uint32_t from, std::uint32_t to, const Isometry<double>& h,
                                            double size) const;
  /// The same for f ∘ g.
  [[nodiscard]] std::optional<LabelId> find_product(LabelId f, LabelId g) const;
  /// Adds a label that is certainly different from all existing ones; `error` as in LabelEntry.
  LabelId add(std::uint32_t from, std::uint32_t to, const Isometry<DoubleDouble>& value, double error, Word word);
  /// The label of a value, a new one or not.
  [[nodiscard]] LabelId find_or_add(std::uint32_t from, std::uint32_t to, const Value<Mp256>& value, Word word);
  /// The value of a word, computed in a field, and how many of the field's bits it lost.
  template <class T>
  struct Evaluation {
    Isometry<T> isometry;
    double bits_lost;
  };
  template <class T>
  [[nodiscard]] Evaluation<T> evaluate(std::uint32_t from, std::uint32_t to, const Word& word) const;
  /// The crossings around a vertex, multiplied up: products[i] is the product of the first i of them.
  template <class T>
  struct Turns {
    std::vector<Isometry<T>> products;
    double bits_lost;  ///< A quotient of two of them is within 2^(bits_lost − bits of T).
  };
  /// Those around the vertex of a corner.
  template <class T>
  [[nodiscard]] const Turns<T>& turns(std::uint32_t corner) const;
  /// Appends the crossings of a word to a list of factors; where the word turns around a vertex with many of them, one
  /// factor for all. Returns by how many bits the worst factor misses the accuracy of a rounded one.
  template <class T>
  [[nodiscard]] double append_factors(const Word& word, std::vector<Isometry<T>>& factors) const;
  /// The value to within 2^−accuracy relative to its entries, accuracy ≥ bits, computed in a field that is large
  /// enough; nullopt if no field is.
  template <class T>
  [[nodiscard]] std::optional<Value<T>> evaluate_to(double bits, std::uint32_t from, std::uint32_t to,
                                                    const Word& word) const;
  /// The value that labels are compared by; nullopt if the word leads too far to be evaluated.
  [[nodiscard]] std::optional<Value<Mp256>> evaluate_label(std::uint32_t from, std::uint32_t to,
                                                           const Word& word) const;
  /// That of a label. Throws LimitError if its word leads too far.
  [[nodiscard]] const Value<Mp256>& precise(LabelId l);
  /// As `label`; nullopt if the word leads too far to be evaluated.
  [[nodiscard]] std::optional<LabelId> find_label(std::uint32_t from, std::uint32_t to, Word word);
  /// The frame of a chart, of determinant 1.
  template <class T>
  [[nodiscard]] Isometry<T> unit_frame(std::uint32_t c) const;
  template <class T>
  [[nodiscard]] const Isometry<T>& crossing(std::uint32_t s) const;

  /// What was asked for in one field above Mp256.
  template <class T>
  struct Known {
    std::unordered_map<LabelId, Isometry<T>> labels;
    std::unordered_map<std::uint32_t, Isometry<T>> crossings;
    std::unordered_map<std::uint32_t, Turns<T>> turns;  ///< By vertex class.
  };

  Surface surface_;
  std::vector<Isometry<Mp256>> crossings_;
  /// By side: which one it is of those that are crossed one after the other around its vertex. Empty if there is no
  /// vertex with so many that paths turn far around it.
  std::vector<std::uint32_t> place_in_turn_;
  mutable std::uint64_t factor_count_ = 0;
  std::vector<Complex<double>> corners_;  ///< Of all tiles, by the side that starts there; rounded.
  std::vector<Disk> disks_;               ///< By tile.
  std::vector<ChartEntry> charts_;
  std::deque<LabelEntry> labels_;
  std::vector<Rounded> rounded_;  ///< By label; apart, as the fast path wants nothing else.
  std::unordered_map<std::uint64_t, LabelId> products_;
  std::unordered_map<std::uint64_t, std::vector<LabelId>> by_charts_;
  mutable std::tuple<Known<Mp1024>, Known<Mp4096>> known_;
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> charts_of_tile_;
};

/// The word of the reversed path.
[[nodiscard]] Word reversed(const Surface& surface, const Word& word);
/// The word of the path `first` followed by `then`, shortened (Dehn's algorithm): a crossing followed by its inverse is
/// removed, and a path that turns around a vertex takes the shorter way.
[[nodiscard]] Word concatenated(const Surface& surface, Word first, const Word& then);

}  // namespace epsnet
