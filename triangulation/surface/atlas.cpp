#include "triangulation/surface/atlas.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "kernel/plane.h"
#include "triangulation/surface/surface.h"
#include "triangulation/surface/words.h"

namespace epsnet {
namespace {

std::uint64_t pair_key(std::uint32_t first, std::uint32_t second) { return (std::uint64_t{first} << 32) | second; }

/// See LabelTable::image_error and docs/error-bounds.md, E5.
double error_of_images(const Isometry<double>& f) {
  const double a = std::sqrt(norm(f.a));
  const double b = std::sqrt(norm(f.b));
  return kUnitRoundoff * (16 * (a + b) / (a - 0.75 * b) + 16);
}

}  // namespace

LabelId LabelTable::product(LabelId f, LabelId g) const {
  const auto known = products_.find(pair_key(f, g));
  return known != products_.end() ? known->second : kUnknownLabel;
}

template <class T>
const Isometry<T>* LabelTable::isometry_in(LabelId l) const {
  const auto& values = std::get<Values<T>>(values_);
  const auto found = values.find(l);
  return found != values.end() ? &found->second : nullptr;
}

std::span<const LabelId> LabelTable::to(ChartId chart) const {
  return chart.number() < to_.size() ? std::span<const LabelId>(to_[chart]) : std::span<const LabelId>{};
}

std::span<const LabelId> LabelTable::between(ChartId from, ChartId to) const {
  const auto found = between_.find(pair_key(from.number(), to.number()));
  return found != between_.end() ? std::span<const LabelId>(found->second) : std::span<const LabelId>{};
}

std::optional<LabelId> LabelTable::find(ChartId from, ChartId to, const Charts::Disk& disk, const Isometry<double>& h,
                                        double size) const {
  // Two isometries are the same if they take the centre of a disk that the group moves off itself to points nearer than
  // twice its radius: sinh of half of the distance of n/d and n'/d' is |n d' − n' d|/(1 − |centre|²).
  const double gap = 1 - norm(disk.centre);
  struct Image {
    Complex<double> n;
    Complex<double> d;
  };
  const auto image = [&](const Isometry<double>& f) {
    return Image{f.a * disk.centre + f.b, conj(f.b) * disk.centre + conj(f.a)};
  };
  const Image wanted = image(h);
  // docs/error-bounds.md, E6.
  const auto is_exact_enough = [&](double size_of_other) {
    return 64 * kUnitRoundoff * size * size_of_other <= 0.25 * disk.sinh_radius * gap;
  };
  if (!is_exact_enough(1)) {
    return std::nullopt;
  }
  const auto is_same = [&](const Isometry<double>& f) -> std::optional<bool> {
    if (!is_exact_enough(size_of(f))) {
      return std::nullopt;
    }
    const Image other = image(f);
    return norm(wanted.n * other.d - other.n * wanted.d) < 0.25 * disk.sinh_radius * disk.sinh_radius * gap * gap;
  };
  if (from == to) {
    if (const auto same = is_same({}); !same || *same) {
      return same ? std::optional(kIdentity) : std::nullopt;
    }
  }
  for (const LabelId l : between(from, to)) {
    if (const auto same = is_same(isometry(l)); !same || *same) {
      return same ? std::optional(l) : std::nullopt;
    }
  }
  return kUnknownLabel;
}

LabelId LabelTable::add(Entry entry) {
  const Isometry<double> isometry = convert<double>(entry.value);
  const auto id = static_cast<LabelId>(entries_.size() + 1);
  rounded_.push_back({isometry, error_of_images(isometry), kUnknownLabel});
  between_[pair_key(entry.from.number(), entry.to.number())].push_back(id);
  if (entry.to.number() >= to_.size()) to_.resize(std::size_t{entry.to.number()} + 1);
  to_[entry.to].push_back(id);
  entries_.push_back(std::move(entry));
  return id;
}

void LabelTable::set_product(LabelId f, LabelId g, LabelId product) { products_.emplace(pair_key(f, g), product); }

const Evaluated<Mp256>& LabelTable::set_precise(LabelId l, Evaluated<Mp256> value) {
  assert(has(l));
  return entries_[l - 1].precise.emplace(std::move(value));
}

template <class T>
const Isometry<T>& LabelTable::set_isometry(LabelId l, const Isometry<T>& value) {
  assert(has(l));
  return std::get<Values<T>>(values_).emplace(l, value).first->second;
}

template const Isometry<Mp1024>* LabelTable::isometry_in<Mp1024>(LabelId) const;
template const Isometry<Mp4096>* LabelTable::isometry_in<Mp4096>(LabelId) const;
template const Isometry<Mp1024>& LabelTable::set_isometry<Mp1024>(LabelId, const Isometry<Mp1024>&);
template const Isometry<Mp4096>& LabelTable::set_isometry<Mp4096>(LabelId, const Isometry<Mp4096>&);

namespace {

/// Sides and the sinh of distances, up to factors that are put right at the end.
template <class T>
struct Measured {
  explicit Measured(const Tile& tile) {
    for (const Complex<Rational>& z : tile) {
      vertices.push_back(on_hyperboloid(convert<T>(z)));
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const LorentzVector<T>& start = vertices[i];
      const LorentzVector<T>& end = vertices[next(i)];
      normals.push_back(lorentz_cross(start, end));
      cosh.push_back(-lorentz_product(start, end));
      farthest = std::max(farthest, start.t);
    }
  }

  [[nodiscard]] std::size_t size() const { return vertices.size(); }
  [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }

  /// sinh² of the length of side i.
  [[nodiscard]] T side(std::size_t i) const { return cosh[i] * cosh[i] - 1; }

  /// sinh² of the distance of side j from the line of side i.
  [[nodiscard]] T distance(std::size_t i, std::size_t j) const {
    // The distances of its ends, times sinh of side i. In between their sinh is A cosh t + B sinh t.
    const T start = lorentz_product(normals[i], vertices[j]);
    const T end = lorentz_product(normals[i], vertices[next(j)]);
    const T low = std::min(start, end);
    const T high = std::max(start, end);
    const T least =
        high >= low * cosh[j] ? T(low * low) : T((2 * low * high * cosh[j] - low * low - high * high) / side(j));
    return least / side(i);
  }

  /// sinh² of the distance from the midpoint of side j to side i; corner `far` is the end of j that is not on i,
  /// `other` the end of i that is not on j.
  [[nodiscard]] T from_midpoint(std::size_t i, std::size_t j, std::size_t far, std::size_t other) const {
    if (-lorentz_product(vertices[far], vertices[other]) >= cosh[i] * cosh[j]) {
      return (cosh[j] - 1) / 2;  // The angle is not acute: half of side j.
    }
    const T end = lorentz_product(normals[i], vertices[far]);
    return end * end / (side(i) * (2 * cosh[j] + 2));
  }

  std::vector<LorentzVector<T>> vertices;
  std::vector<LorentzVector<T>> normals;
  std::vector<T> cosh;
  T farthest = 0;  ///< cosh of the largest distance of a vertex from 0.
};

/// sinh² of the bound.
template <class T>
T squared_bound(const Measured<T>& tile) {
  T bound = 1;
  for (std::size_t i = 0; i < tile.size(); ++i) {
    const std::size_t j = tile.next(i);
    bound = std::min({bound, T((tile.cosh[i] - 1) / 2), tile.from_midpoint(i, j, tile.next(j), i),
                      tile.from_midpoint(j, i, i, tile.next(j))});
    for (std::size_t k = 0; k + 1 < i; ++k) {
      if (tile.next(i) != k) {
        bound = std::min(bound, std::max(tile.distance(i, k), tile.distance(k, i)));
      }
    }
  }
  return bound;
}

/// The bound from its sinh².
double bound_from(double square) { return 0.99 * std::asinh(std::sqrt(square)); }

/// The bound, computed in T, if no vertex is farther than `farthest` (cosh of the distance from 0) and the bound is at
/// least `least` (sinh²).
template <class T>
std::optional<double> bound_in(const Tile& tile, double farthest, double least) {
  const Measured<T> measured(tile);
  if (!(measured.farthest <= farthest)) {
    return std::nullopt;
  }
  const auto square = static_cast<double>(squared_bound(measured));
  return square >= least ? std::optional(bound_from(square)) : std::nullopt;
}

}  // namespace

double curve_bound(const Tile& tile) {
  // Where vertices are near and the bound is large, few bits are off by less than a hundredth.
  if (const auto bound = bound_in<double>(tile, 100, 1e-4)) {
    return *bound;
  }
  if (const auto bound = bound_in<Mp256>(tile, 1e10, 1e-20)) {
    return *bound;
  }
  // 300 digits are enough for vertices so near and bounds so large.
  constexpr double kLeast = 1e-90;
  return std::max(kLeast, bound_in<Mp1024>(tile, 1e95, 0).value_or(kLeast));
}

namespace {

/// Bits that the precise value of a label keeps at least, relative to its entries; and, for entries of size N, beyond
/// log2 N. Products that would have fewer are evaluated from their word again.
constexpr double kLabelAccuracy = 150;
constexpr double kAbsoluteAccuracy = 100;
/// A product of labels in double-double may be off by this, in units of its size; what is off by more is multiplied in
/// more bits. The bounds for labels that are rounded to binary64 have more than that to spare.
constexpr double kValueError = 0x1p-64;
/// Two labels g and gh between the same charts are equal if the coordinates of their matrices agree to 2⁻⁹⁰: for h ≠ 1
/// of length ℓ the difference g(h − 1) has the determinant 2 − tr h = −4 sinh²(ℓ/4), whatever the size of g, so that
/// some coordinate of it is larger than ℓ/√8.
constexpr int kSameLabelBits = 90;
/// So closed geodesics must certainly be this long, 3·10⁻²⁷.
constexpr double kShortestCurve = 0x1p-88;

[[noreturn]] void throw_too_far(std::size_t sides) {
  throw LimitError("a path of " + std::to_string(sides) + " sides leads too far to be evaluated");
}

std::string with_exponent(double value) {
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%.1e", value);
  return text.data();
}

template <class T>
Complex<T> dyadic(const Complex<double>& z) {
  return {T(z.x), T(z.y)};
}

}  // namespace

Atlas::Atlas(const Surface& surface) : charts_(surface), words_(surface) {
  if (surface.is_regular()) return;
  for (const TileId t : surface.tile_ids()) {
    if (const double shortest = curve_bound(surface.tile(t)); shortest < kShortestCurve) {
      throw LimitError("tile " + to_string(t) + " is too thin: closed geodesics through it may be as short as " +
                       with_exponent(shortest) + ", expected at least " + with_exponent(kShortestCurve));
    }
  }
}

std::optional<Evaluated<Mp256>> Atlas::evaluate_label(ChartId from, ChartId to, const Word& word) const {
  std::optional<Evaluated<Mp256>> value = words_.value<Mp256>(kLabelAccuracy + 10, charts_, from, to, word);
  if (value && value->accuracy < kAbsoluteAccuracy + log2_norm(value->isometry)) {
    value = words_.value<Mp256>(240, charts_, from, to, word);
  }
  return value;
}

const Evaluated<Mp256>& Atlas::precise(LabelId l) {
  const LabelTable::Entry& entry = labels_[l];
  if (entry.precise) return *entry.precise;
  std::optional<Evaluated<Mp256>> value = evaluate_label(entry.from, entry.to, entry.word);
  if (!value) throw_too_far(entry.word.size());
  return labels_.set_precise(l, std::move(*value));
}

std::optional<LabelId> Atlas::find_label(ChartId from, ChartId to, Word word) {
  assert(is_path(surface(), charts_[from].tile, charts_[to].tile, word));
  const std::optional<Evaluated<Mp256>> value = evaluate_label(from, to, word);
  return value ? std::optional(find_or_add(from, to, *value, std::move(word))) : std::nullopt;
}

LabelId Atlas::label(ChartId from, ChartId to, Word word) {
  const std::size_t sides = word.size();
  const std::optional<LabelId> result = find_label(from, to, std::move(word));
  if (!result) throw_too_far(sides);
  return *result;
}

LabelId Atlas::find_or_add(ChartId from, ChartId to, const Evaluated<Mp256>& value, Word word) {
  const Isometry<Mp256>& isometry = value.isometry;
  const auto small = [](const Mp256& x) { return binary_exponent(x) < -kSameLabelBits; };
  const auto equal = [&](const Isometry<Mp256>& f, const Isometry<Mp256>& g) {
    return (small(f.a.x - g.a.x) && small(f.a.y - g.a.y) && small(f.b.x - g.b.x) && small(f.b.y - g.b.y)) ||
           (small(f.a.x + g.a.x) && small(f.a.y + g.a.y) && small(f.b.x + g.b.x) && small(f.b.y + g.b.y));
  };
  if (from == to && equal(isometry, Isometry<Mp256>{})) {
    return kIdentity;
  }
  const Isometry<double> rounded = convert<double>(isometry);
  for (const LabelId l : labels_.between(from, to)) {
    const Complex<double> b = this->isometry(l).b;
    const double tolerance = 1e-12 * (norm(rounded.a) + 1);
    const bool close = std::min(norm(b - rounded.b), norm(b + rounded.b)) <= tolerance;
    if (close && equal(precise(l).isometry, isometry)) {
      return l;
    }
  }
  return labels_.add({from, to, std::move(word), convert<DoubleDouble>(isometry), 0x1p-104 * size_of(rounded), value});
}

std::optional<LabelId> Atlas::find_product(LabelId f, LabelId g) const {
  assert(labels_[g].to == labels_[f].from);
  const ChartId from = labels_[g].from;
  return labels_.find(from, labels_[f].to, charts_.disk(from), isometry(f) * isometry(g),
                      size_of(isometry(f)) * size_of(isometry(g)));
}

LabelId Atlas::product_of_others(LabelId f, LabelId g) {
  assert(labels_[g].to == labels_[f].from);
  if (const LabelId known = labels_.product(f, g); known != kUnknownLabel) {
    return known;
  }
  const auto product = [&] {
    const std::optional<LabelId> found = find_product(f, g);
    if (found && *found != kUnknownLabel) {
      return *found;
    }
    const LabelTable::Entry& left = labels_[f];
    const LabelTable::Entry& right = labels_[g];
    Word word = concatenated(surface(), right.word, left.word);
    if (found) {
      const Isometry<DoubleDouble> value = left.value * right.value;
      // docs/error-bounds.md, E5.
      const double left_size = size_of(isometry(f));
      const double right_size = size_of(isometry(g));
      const double error = 1.001 * (left.error * (right_size + right.error) + left_size * right.error +
                                    0x1p-101 * left_size * right_size);
      if (error <= kValueError * size_of(convert<double>(value))) {
        return labels_.add({right.from, left.to, std::move(word), value, error, std::nullopt});
      }
    }
    const Isometry<Mp256>& left_isometry = precise(f).isometry;
    const Isometry<Mp256>& right_isometry = precise(g).isometry;
    const double size = log2_norm(left_isometry) + log2_norm(right_isometry);
    const double accuracy = std::min(precise(f).accuracy, precise(g).accuracy) - size - 3;
    if (accuracy >= std::max(kLabelAccuracy, kAbsoluteAccuracy + size)) {
      return find_or_add(right.from, left.to, {left_isometry * right_isometry, accuracy}, std::move(word));
    }
    return label(right.from, left.to, std::move(word));
  };
  const LabelId result = product();
  labels_.set_product(f, g, result);
  return result;
}

LabelId Atlas::known_product(LabelId f, LabelId g) const {
  assert(labels_[g].to == labels_[f].from);
  const LabelId known = labels_.product(f, g);
  return known != kUnknownLabel ? known : find_product(f, g).value_or(kUnknownLabel);
}

LabelId Atlas::inverse_of_other(LabelId f) {
  const LabelTable::Entry& entry = labels_[f];
  const Isometry<double> wanted = epsnet::inverse(isometry(f));
  const std::optional<LabelId> found =
      labels_.find(entry.to, entry.from, charts_.disk(entry.to), wanted, size_of(wanted));
  const auto inverse = [&] {
    if (found && *found != kUnknownLabel) {
      return *found;
    }
    Word word = reversed(surface(), entry.word);
    if (found) {
      return labels_.add(
          {entry.to, entry.from, std::move(word), epsnet::inverse(entry.value), entry.error, std::nullopt});
    }
    const Evaluated<Mp256>& value = precise(f);
    return find_or_add(entry.to, entry.from, {epsnet::inverse(value.isometry), value.accuracy}, std::move(word));
  };
  const LabelId result = inverse();
  labels_.set_inverse(f, result);
  return result;
}

LabelId Atlas::power(LabelId f, std::uint64_t n) {
  assert(f == kIdentity || labels_[f].from == labels_[f].to);
  LabelId result = kIdentity;
  for (LabelId square = f; n > 0; n /= 2) {
    if (n % 2 != 0) result = product(square, result);
    if (n > 1) square = product(square, square);
  }
  return result;
}

template <class T>
const Isometry<T>& Atlas::isometry_in(LabelId l) {
  if constexpr (std::is_same_v<T, double>) {
    return labels_.isometry(l);
  } else if constexpr (std::is_same_v<T, Mp256>) {
    return precise(l).isometry;
  } else {
    if (const Isometry<T>* known = labels_.isometry_in<T>(l)) return *known;
    const LabelTable::Entry& entry = labels_[l];
    constexpr double kBits = std::is_same_v<T, Mp1024> ? 620 : 2020;
    const auto value = words_.value<T>(kBits, charts_, entry.from, entry.to, entry.word);
    if (!value) throw_too_far(entry.word.size());
    return labels_.set_isometry<T>(l, value->isometry);
  }
}

template <class T>
Complex<T> Atlas::lift(LabelId l, const Complex<double>& z) {
  assert(norm(z) <= 0.75 * 0.75);
  const Complex<T> point = dyadic<T>(z);
  return l == kIdentity ? point : isometry_in<T>(l)(point);
}

template <class T>
T Atlas::lift_error() {
  // Labels are evaluated to more bits than this, and |z| ≤ 0.75 keeps the denominator away from 0.
  if constexpr (std::is_same_v<T, Mp256>) {
    return boost::multiprecision::pow(T(2), -135);
  } else if constexpr (std::is_same_v<T, Mp1024>) {
    return boost::multiprecision::pow(T(2), -600);
  } else {
    return boost::multiprecision::pow(T(2), -2000);
  }
}

std::optional<LiftedPoint> Atlas::lifted_point_nearby(ChartId c, const Complex<double>& z) const {
  constexpr double kRadius2 = kChartRadius * kChartRadius;
  std::optional<LiftedPoint> best;
  double best_norm = kRadius2;
  for (const LabelId l : labels_.to(c)) {
    const Complex<double> w = epsnet::inverse(isometry(l))(z);
    if (norm(w) < best_norm) {
      best_norm = norm(w);
      best = LiftedPoint{labels_[l].from, w, l};
    }
  }
  return best;
}

std::optional<Atlas::TilePoint> Atlas::walk_through_tiles(TileId tile, const Complex<Mp1024>& z) const {
  constexpr std::size_t kLongestPath = 10'000;
  TilePoint point{tile, z, {}};
  std::optional<SideId> entered;
  // At a corner of tiles every tile may seem to have the point beyond a side, as corners are rounded: the way leads
  // around the corner, and back to where it was. (Other lifts of a point are farther away than any rounding.)
  const Mp1024 rounding = ldexp(Mp1024(1), -200);
  TilePoint before = point;
  std::size_t next_before = 1;
  while (const std::optional<SideId> s = charts_.side_before(point.tile, point.z, entered)) {
    point.z = words_.crossing<Mp1024>(*s)(point.z);
    point.path.push_back(*s);
    entered = surface().partner(*s);
    point.tile = surface().tile_of_side(*entered);
    if (point.path.size() > kLongestPath) {
      return std::nullopt;
    }
    if (point.tile == before.tile && norm(point.z - before.z) < rounding * rounding) {
      return before;
    }
    if (point.path.size() == next_before) {
      before = point;
      next_before *= 2;
    }
  }
  return point;
}

std::optional<LiftedPoint> Atlas::lifted_point(ChartId c, const Complex<Mp1024>& z, Precision precision) {
  assert(norm(z) < 1);
  // In the tile whose coordinates it has: far from the origin bits are worth less, so there are many.
  const std::optional<TilePoint> point = walk_through_tiles(charts_[c].tile, charts_.frame<Mp1024>(c)(z));
  if (!point) {
    return std::nullopt;
  }
  const bool exact = precision == Precision::bits_256;
  std::optional<ChartId> chart = exact ? std::nullopt : charts_.nearest(point->tile, point->z);
  if (!chart) {
    // Short centres where binary64 places them well, else all the bits there are.
    const bool round = !exact && norm(point->z) < 0.999999;
    const Complex<Rational> centre =
        round ? convert<Rational>(convert<double>(point->z)) : convert<Rational>(convert<Mp256>(point->z));
    chart = charts_.add({point->tile, centre});
  }
  const Complex<double> rounded =
      exact ? Complex<double>{0, 0} : convert<double>(epsnet::inverse(charts_.frame<Mp1024>(*chart))(point->z));
  const std::optional<LabelId> to_c = find_label(*chart, c, reversed(surface(), point->path));
  return to_c ? std::optional(LiftedPoint{*chart, rounded, *to_c}) : std::nullopt;
}

template const Isometry<Mp256>& Atlas::isometry_in<Mp256>(LabelId);
template const Isometry<Mp1024>& Atlas::isometry_in<Mp1024>(LabelId);
template Complex<Mp256> Atlas::lift<Mp256>(LabelId, const Complex<double>&);
template Complex<Mp1024> Atlas::lift<Mp1024>(LabelId, const Complex<double>&);
template Complex<Mp4096> Atlas::lift<Mp4096>(LabelId, const Complex<double>&);
template Mp256 Atlas::lift_error<Mp256>();
template Mp1024 Atlas::lift_error<Mp1024>();
template Mp4096 Atlas::lift_error<Mp4096>();

}  // namespace epsnet
