#include "triangulation/surface/atlas.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <string>
#include <type_traits>

#include "kernel/lorentz.h"
#include "kernel/plane.h"
#include "kernel/predicates.h"
#include "triangulation/surface/curve_bound.h"

namespace epsnet {
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

std::uint64_t pair_key(std::uint32_t first, std::uint32_t second) { return (std::uint64_t{first} << 32) | second; }

/// The integer e with 2^e ≤ |x| < 2^(e+1); a very small one for 0.
template <class T>
double binary_exponent(const T& x) {
  return x == 0 ? -1e18 : static_cast<double>(mpfr_get_exp(x.backend().data()) - 1);
}

/// An upper bound of log2 of the operator norm |a| + |b| ≤ 2|a| of a normalised isometry, at most 2.5 too large. No
/// arithmetic, exponents only.
template <class T>
double log2_norm(const Isometry<T>& f) {
  return 2.5 + std::max(binary_exponent(f.a.x), binary_exponent(f.a.y));
}

/// ν(f) = |a| + |b|.
double size_of(const Isometry<double>& f) { return std::sqrt(norm(f.a)) + std::sqrt(norm(f.b)); }

/// For every factor an upper bound of log2 of the norm of the product of those that come after it, computed in
/// binary64; nothing if binary64 may be off by more than a factor of 2.
template <class T>
std::optional<std::vector<double>> sizes_from_the_end(const std::vector<Isometry<T>>& factors) {
  std::vector<double> sizes(factors.size());
  Isometry<double> product;
  double error = 0;  // Of the product, as a norm.
  for (std::size_t i = factors.size(); i-- > 0;) {
    const double size = size_of(product);
    if (!(error <= size / 2)) {
      return std::nullopt;
    }
    sizes[i] = 1 + std::log2(size);
    const Isometry<double> factor = convert<double>(factors[i]);
    error = (error + 16 * kUnitRoundoff * size) * 1.001 * size_of(factor);
    product = product * factor;
  }
  return sizes;
}

/// See Atlas::error and docs/error-bounds.md, E5.
double image_error(const Isometry<double>& f) {
  const double a = std::sqrt(norm(f.a));
  const double b = std::sqrt(norm(f.b));
  return kUnitRoundoff * (16 * (a + b) / (a - 0.75 * b) + 16);
}

/// A path that turns around a vertex crosses one side after the other of those that end there.
enum class Turn { counterclockwise, clockwise };
constexpr std::size_t turn_index(Turn turn) { return turn == Turn::clockwise ? 1 : 0; }

/// The crossing that continues a turn after side s: next to the partner of s in its tile.
std::uint32_t next_crossing(const Surface& surface, std::uint32_t s, Turn turn) {
  const std::uint32_t partner = surface.partner(s);
  return turn == Turn::counterclockwise ? surface.next_side(partner) : surface.previous_side(partner);
}

[[noreturn]] void throw_too_far(std::size_t sides) {
  throw LimitError("a path of " + std::to_string(sides) + " sides leads too far to be evaluated");
}

std::string two_digits(double value) {
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%.1e", value);
  return text.data();
}

/// How many crossings of a word, from the i-th on, turn around one vertex.
std::size_t turn_length(const Surface& surface, const Word& word, std::size_t i, Turn turn) {
  std::size_t end = i + 1;
  while (end < word.size() && next_crossing(surface, word[end - 1], turn) == word[end]) ++end;
  return end - i;
}

/// A path that turns around a vertex with as many crossings as this is one factor of a product.
constexpr std::uint32_t kLongTurn = 16;

/// The field in which the crossings around a vertex are multiplied up for products in T.
template <class T>
using TurnField = std::conditional_t<std::is_same_v<T, Mp256>, Mp1024, T>;

/// The crossings of one full turn that goes on from side s.
std::uint32_t crossings_around(const Surface& surface, std::uint32_t s, Turn turn) {
  return surface.corners_around(turn == Turn::counterclockwise ? s : surface.next_side(s));
}

/// The points p, q of the disk, rounded to nearest, have certainly |z|² > square, z being q with p moved to the origin.
bool certainly_farther(const Complex<double>& p, const Complex<double>& q, double square) {
  // |z|²/(1 − |z|²) = |p − q|²/((1 − |p|²)(1 − |q|²)). Each rounded point is within u of the true one, so the
  // distance is off by less than 2u, and by 4u with its own rounding, and a factor of the denominator by less than 5u.
  constexpr double kError = 8 * kUnitRoundoff;
  const double distance = std::sqrt(norm(p - q)) - kError;
  const double heights = (1 - norm(p) + kError) * (1 - norm(q) + kError);
  constexpr double kMargin = 1.001;  // For the roundings that are relative.
  return distance > 0 && distance * distance * (1 - square) > kMargin * square * heights;
}

/// Whether a word is a path from one tile to another: what `Atlas::label` requires.
[[maybe_unused]] bool is_path(const Surface& surface, std::uint32_t from, std::uint32_t to, const Word& word) {
  std::uint32_t tile = from;
  for (const std::uint32_t s : word) {
    if (s >= surface.side_count() || surface.tile_of_side(s) != tile) return false;
    tile = surface.tile_of_side(surface.partner(s));
  }
  return tile == to;
}

template <class T>
Complex<T> dyadic(const Complex<double>& z) {
  return {T(z.x), T(z.y)};
}

}  // namespace

Word reversed(const Surface& surface, const Word& word) {
  Word result(word.rbegin(), word.rend());
  for (std::uint32_t& s : result) {
    s = surface.partner(s);
  }
  return result;
}

Word concatenated(const Surface& surface, Word first, const Word& then) {
  Word& word = first;
  // For every letter and both turns, how many letters up to this one turn around one vertex.
  std::vector<std::array<std::uint32_t, 2>> runs;
  const auto append_runs = [&] {
    const std::size_t i = runs.size();
    runs.push_back({1, 1});
    for (const Turn turn : {Turn::counterclockwise, Turn::clockwise}) {
      if (i > 0 && next_crossing(surface, word[i - 1], turn) == word[i]) {
        runs[i][turn_index(turn)] = runs[i - 1][turn_index(turn)] + 1;
      }
    }
  };
  while (runs.size() < word.size()) append_runs();
  // Letters still to come, the next one last.
  Word rest(then.rbegin(), then.rend());
  while (!rest.empty()) {
    word.push_back(rest.back());
    append_runs();
    rest.pop_back();
    if (word.size() >= 2 && word[word.size() - 2] == surface.partner(word.back())) {
      word.resize(word.size() - 2);
      runs.resize(word.size());
      continue;
    }
    for (const Turn turn : {Turn::counterclockwise, Turn::clockwise}) {
      // The end of the word that turns around one vertex, and the crossings that complete the turn.
      const std::uint32_t run = runs.back()[turn_index(turn)];
      const std::uint32_t all = crossings_around(surface, word.back(), turn);
      const std::uint32_t completion = (all - run % all) % all;
      if (completion < run) {
        // More than half of the way around: go around the other way.
        std::uint32_t s = word.back();
        for (std::uint32_t k = 0; k < completion; ++k) {
          s = next_crossing(surface, s, turn);
          rest.push_back(surface.partner(s));
        }
        word.resize(word.size() - run);
        runs.resize(word.size());
        break;
      }
    }
  }
  return first;
}

Atlas::Atlas(const Surface& surface_of_atlas) : surface_(surface_of_atlas) {
  const Surface& surface = surface_;
  for (std::uint32_t t = 0; t < surface.tiles().size() && !surface.is_regular(); ++t) {
    if (const double shortest = curve_bound(surface.tiles()[t]); shortest < kShortestCurve) {
      throw LimitError("tile " + std::to_string(t) + " is too thin: closed geodesics through it may be as short as " +
                       two_digits(shortest) + ", expected at least " + two_digits(kShortestCurve));
    }
  }
  crossings_.reserve(surface.side_count());
  for (std::uint32_t s = 0; s < surface.side_count(); ++s) {
    const std::uint32_t partner = surface.partner(s);
    crossings_.push_back(partner < s ? epsnet::inverse(crossings_[partner])
                                     : convert<Mp256>(surface.crossing_as<Mp1024>(s)));
  }
  const auto is_long = [&](std::uint32_t corner) { return surface.corners_around(corner) >= 2 * kLongTurn; };
  constexpr std::uint32_t kUnset = ~std::uint32_t{0};
  for (std::uint32_t corner = 0; corner < surface.side_count(); ++corner) {
    if (!is_long(corner)) continue;
    if (place_in_turn_.empty()) place_in_turn_.assign(surface.side_count(), kUnset);
    std::uint32_t place = 0;
    for (std::uint32_t s = corner; place_in_turn_[s] == kUnset; s = next_crossing(surface, s, Turn::counterclockwise)) {
      place_in_turn_[s] = place++;
    }
  }
  disks_.reserve(surface.tiles().size());
  for (const Tile& tile : surface.tiles()) {
    const std::size_t first = corners_.size();
    for (const Complex<Rational>& corner : tile) {
      corners_.push_back(convert<double>(corner));
    }
    disks_.push_back(disk_inside(std::span(corners_).subspan(first)));
  }
}

Atlas::Disk Atlas::disk_inside(std::span<const Complex<double>> tile) {
  std::vector<LorentzVector<double>> corners;  // In the Klein model, t = 1.
  LorentzVector<double> sum;
  for (const Complex<double>& z : tile) {
    const double scale = 2 / (1 + norm(z));
    corners.push_back({scale * z.x, scale * z.y, 1});
    sum = sum + corners.back();
  }
  const double square = -lorentz_product(sum, sum);
  const double height = sum.t * sum.t;
  // Far from the origin, and for sides whose ends are near each other and the unit circle, binary64 has lost too much.
  if (!(square > 1e-4 * height)) {
    return {{}, 0};
  }
  const LorentzVector<double> centre = 1 / std::sqrt(square) * sum;
  double sinh_radius = 1;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const LorentzVector<double> normal = lorentz_cross(corners[k], corners[k + 1 < corners.size() ? k + 1 : 0]);
    const double normal_square = lorentz_product(normal, normal);
    if (!(normal_square > std::max(1e-12, 1e-8 * normal.t * normal.t))) {
      return {{}, 0};
    }
    sinh_radius = std::min(sinh_radius, lorentz_product(normal, centre) / std::sqrt(normal_square));
  }
  // Half of it makes up for all rounding, which is below a thousandth of it: products and normals are off by a few
  // 1e-16 times sizes below 100, squares by 1e-5 of themselves.
  return {in_disk(centre), sinh_radius > 1e-4 ? sinh_radius / 2 : 0};
}

std::uint32_t Atlas::add_chart(Chart chart) {
  assert(chart.tile < surface_.tiles().size() && norm(chart.centre) < 1);
  const std::uint32_t c = chart_count();
  charts_of_tile_[chart.tile].push_back(c);
  Disk disk = disks_[chart.tile];
  const Complex<double> centre = convert<double>(chart.centre);
  disk.centre = epsnet::inverse(Isometry<double>::translation(centre))(disk.centre);
  constexpr double kFarthest = 0.999;
  if (!(norm(disk.centre) < kFarthest)) {
    disk.sinh_radius = 0;
  }
  charts_.push_back({std::move(chart), centre, disk, {}, {}});
  charts_.back().unit_frame = normalized(frame<Mp256>(c));
  return c;
}

template <class T>
Isometry<T> Atlas::frame(std::uint32_t c) const {
  assert(c < chart_count());
  return Isometry<T>::translation(convert<T>(charts_[c].chart.centre));
}

template <class T>
Isometry<T> Atlas::unit_frame(std::uint32_t c) const {
  if constexpr (std::is_same_v<T, Mp256>) {
    return charts_[c].unit_frame;
  } else {
    return normalized(frame<T>(c));
  }
}

template <class T>
const Isometry<T>& Atlas::crossing(std::uint32_t s) const {
  if constexpr (std::is_same_v<T, Mp256>) {
    return crossings_[s];
  } else {
    auto& known = std::get<Known<T>>(known_).crossings;
    const auto found = known.find(s);
    return found != known.end() ? found->second : known.emplace(s, surface_.crossing_as<T>(s)).first->second;
  }
}

template <class T>
const Atlas::Turns<T>& Atlas::turns(std::uint32_t corner) const {
  auto& known = std::get<Known<T>>(known_).turns;
  const std::uint32_t vertex = surface_.vertex_class(corner);
  if (const auto found = known.find(vertex); found != known.end()) {
    return found->second;
  }
  std::uint32_t s = corner;
  while (place_in_turn_[s] != 0) s = next_crossing(surface_, s, Turn::counterclockwise);
  Turns<T> result{{Isometry<T>{}}, 0};
  double largest_product = 1;
  double largest_crossing = 1;
  for (std::uint32_t i = 1; i < surface_.corners_around(corner); ++i) {
    const Isometry<T>& next = crossing<T>(s);
    result.products.push_back(next * result.products.back());
    largest_product = std::max(largest_product, log2_norm(result.products.back()));
    largest_crossing = std::max(largest_crossing, log2_norm(next));
    s = next_crossing(surface_, s, Turn::counterclockwise);
  }
  factor_count_ += result.products.size();
  // docs/error-bounds.md, E5.
  result.bits_lost =
      4 * largest_product + largest_crossing + std::log2(static_cast<double>(result.products.size())) + 5;
  return known.emplace(vertex, std::move(result)).first->second;
}

template <class T>
double Atlas::append_factors(const Word& word, std::vector<Isometry<T>>& factors) const {
  double missing = 0;
  const auto product_of_turn = [&](std::uint32_t first, std::size_t length) {
    const Turns<TurnField<T>>& around = turns<TurnField<T>>(first);
    const std::size_t n = around.products.size();
    const std::size_t start = place_in_turn_[first];
    missing = std::max(missing, around.bits_lost + kMantissaBits<T> - kMantissaBits<TurnField<T>>);
    return convert<T>(around.products[(start + length) % n] * epsnet::inverse(around.products[start]));
  };
  for (std::size_t i = 0; i < word.size();) {
    if (!place_in_turn_.empty()) {
      const std::size_t forward = turn_length(surface_, word, i, Turn::counterclockwise);
      const std::size_t backward = turn_length(surface_, word, i, Turn::clockwise);
      if (forward >= kLongTurn) {
        factors.push_back(product_of_turn(word[i], forward));
        i += forward;
        continue;
      }
      if (backward >= kLongTurn) {
        // The path backwards turns counterclockwise.
        const std::uint32_t last = word[i + backward - 1];
        factors.push_back(epsnet::inverse(product_of_turn(surface_.partner(last), backward)));
        i += backward;
        continue;
      }
    }
    factors.push_back(crossing<T>(word[i]));
    ++i;
  }
  return missing;
}

template <class T>
Atlas::Evaluation<T> Atlas::evaluate(std::uint32_t from, std::uint32_t to, const Word& word) const {
  // The value is a product M_n … M_0; an error in M_i is magnified by the partial products on its two sides. Factors
  // have determinant 1, the product is not normalised again: |a|² − |b|² has lost its bits where |a| is large.
  std::vector<Isometry<T>> factors{unit_frame<T>(from)};
  const double missing = append_factors<T>(word, factors);
  factors.push_back(epsnet::inverse(unit_frame<T>(to)));
  factor_count_ += factors.size();
  Isometry<T> product = factors.front();
  std::vector<double> before{log2_norm(product)};
  double lost = 2 * before.front();
  for (std::size_t i = 1; i < factors.size(); ++i) {
    before.push_back(log2_norm(product) + log2_norm(factors[i]));
    product = factors[i] * product;
    // A product that has come out too small through cancellation has lost as much as went into it.
    lost = std::max(lost, before.back() + log2_norm(product));
  }
  // From the other end only the sizes of the products are needed, which binary64 sees unless the factors cancel.
  const std::optional<std::vector<double>> seen = sizes_from_the_end(factors);
  Isometry<T> after;
  for (std::size_t i = factors.size(); i-- > 0;) {
    lost = std::max(lost, before[i] + (seen ? (*seen)[i] : log2_norm(after)));
    if (!seen) {
      after = after * factors[i];
    }
  }
  // The factors' own rounding, about 8 operations deep, and their number.
  return {product, lost + missing + 8 + std::log2(static_cast<double>(factors.size()))};
}

template <class T>
std::optional<Atlas::Value<T>> Atlas::evaluate_to(double bits, std::uint32_t from, std::uint32_t to,
                                                  const Word& word) const {
  const auto rounded = [](const auto& value, double field_bits) {
    return Value<T>{convert<T>(value.isometry), std::min(field_bits - value.bits_lost, kMantissaBits<T> - 4.0)};
  };
  if constexpr (kMantissaBits<T> <= 256) {
    if (const auto value = evaluate<Mp256>(from, to, word); value.bits_lost + bits <= 256) {
      return rounded(value, 256);
    }
  }
  if constexpr (kMantissaBits<T> <= 1024) {
    if (const auto value = evaluate<Mp1024>(from, to, word); value.bits_lost + bits <= 1024) {
      return rounded(value, 1024);
    }
  }
  // Where triangles start so far from Delaunay that their words grow and grow, this is where it ends: the paths of nets
  // have a few dozen sides, or as many as a polygon.
  const std::size_t longest = 500 + surface_.side_count();
  if (word.size() <= longest) {
    if (const auto value = evaluate<Mp4096>(from, to, word); value.bits_lost + bits <= 4096) {
      return rounded(value, 4096);
    }
  }
  return std::nullopt;
}

std::optional<Atlas::Value<Mp256>> Atlas::evaluate_label(std::uint32_t from, std::uint32_t to, const Word& word) const {
  std::optional<Value<Mp256>> value = evaluate_to<Mp256>(kLabelAccuracy + 10, from, to, word);
  if (value && value->accuracy < kAbsoluteAccuracy + log2_norm(value->isometry)) {
    value = evaluate_to<Mp256>(240, from, to, word);
  }
  return value;
}

const Atlas::Value<Mp256>& Atlas::precise(LabelId l) {
  assert(is_other(l));
  LabelEntry& entry = labels_[l - 1];
  if (!entry.precise) {
    entry.precise = evaluate_label(entry.from, entry.to, entry.word);
    if (!entry.precise) throw_too_far(entry.word.size());
  }
  return *entry.precise;
}

std::optional<LabelId> Atlas::find_label(std::uint32_t from, std::uint32_t to, Word word) {
  assert(is_path(surface_, chart(from).tile, chart(to).tile, word));
  const std::optional<Value<Mp256>> value = evaluate_label(from, to, word);
  return value ? std::optional(find_or_add(from, to, *value, std::move(word))) : std::nullopt;
}

LabelId Atlas::label(std::uint32_t from, std::uint32_t to, Word word) {
  const std::size_t sides = word.size();
  const std::optional<LabelId> result = find_label(from, to, std::move(word));
  if (!result) throw_too_far(sides);
  return *result;
}

LabelId Atlas::find_or_add(std::uint32_t from, std::uint32_t to, const Value<Mp256>& value, Word word) {
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
  for (const LabelId l : by_charts_[pair_key(from, to)]) {
    const Complex<double> b = this->isometry(l).b;
    const double tolerance = 1e-12 * (norm(rounded.a) + 1);
    const bool close = std::min(norm(b - rounded.b), norm(b + rounded.b)) <= tolerance;
    if (close && equal(precise(l).isometry, isometry)) {
      return l;
    }
  }
  const LabelId result = add(from, to, convert<DoubleDouble>(isometry), 0x1p-104 * size_of(rounded), std::move(word));
  labels_.back().precise = value;
  return result;
}

LabelId Atlas::add(std::uint32_t from, std::uint32_t to, const Isometry<DoubleDouble>& value, double error, Word word) {
  const Isometry<double> rounded = convert<double>(value);
  labels_.push_back({from, to, std::move(word), value, error, std::nullopt});
  rounded_.push_back({rounded, image_error(rounded), kUnknownLabel});
  const auto id = static_cast<LabelId>(labels_.size());
  by_charts_[pair_key(from, to)].push_back(id);
  charts_[to].incoming.push_back(id);
  return id;
}

std::optional<LabelId> Atlas::find(std::uint32_t from, std::uint32_t to, const Isometry<double>& h, double size) const {
  // Two isometries are the same if they take the centre of a disk that the group moves off itself to points nearer than
  // twice its radius: sinh of half of the distance of n/d and n'/d' is |n d' − n' d|/(1 − |centre|²).
  const Disk& disk = charts_[from].disk;
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
  if (const auto same_charts = by_charts_.find(pair_key(from, to)); same_charts != by_charts_.end()) {
    for (const LabelId l : same_charts->second) {
      if (const auto same = is_same(isometry(l)); !same || *same) {
        return same ? std::optional(l) : std::nullopt;
      }
    }
  }
  return kUnknownLabel;
}

std::optional<LabelId> Atlas::find_product(LabelId f, LabelId g) const {
  assert(to(g) == from(f));
  return find(from(g), to(f), isometry(f) * isometry(g), size_of(isometry(f)) * size_of(isometry(g)));
}

LabelId Atlas::product_of_others(LabelId f, LabelId g) {
  assert(to(g) == from(f));
  if (const auto known = products_.find(pair_key(f, g)); known != products_.end()) {
    return known->second;
  }
  const auto product = [&] {
    const std::optional<LabelId> found = find_product(f, g);
    if (found && *found != kUnknownLabel) {
      return *found;
    }
    const LabelEntry& left = labels_[f - 1];
    const LabelEntry& right = labels_[g - 1];
    Word word = concatenated(surface_, right.word, left.word);
    if (found) {
      const Isometry<DoubleDouble> value = left.value * right.value;
      // docs/error-bounds.md, E5.
      const double left_size = size_of(isometry(f));
      const double right_size = size_of(isometry(g));
      const double error = 1.001 * (left.error * (right_size + right.error) + left_size * right.error +
                                    0x1p-101 * left_size * right_size);
      if (error <= kValueError * size_of(convert<double>(value))) {
        return add(right.from, left.to, value, error, std::move(word));
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
  products_.emplace(pair_key(f, g), result);
  return result;
}

LabelId Atlas::known_product(LabelId f, LabelId g) const {
  assert(to(g) == from(f));
  const auto known = products_.find(pair_key(f, g));
  return known != products_.end() ? known->second : find_product(f, g).value_or(kUnknownLabel);
}

LabelId Atlas::inverse_of_other(LabelId f) {
  const Isometry<double> wanted = epsnet::inverse(isometry(f));
  const std::optional<LabelId> found = find(to(f), from(f), wanted, size_of(wanted));
  const auto inverse = [&] {
    if (found && *found != kUnknownLabel) {
      return *found;
    }
    const LabelEntry& entry = labels_[f - 1];
    Word word = reversed(surface_, entry.word);
    if (found) {
      return add(entry.to, entry.from, epsnet::inverse(entry.value), entry.error, std::move(word));
    }
    const Value<Mp256>& value = precise(f);
    return find_or_add(entry.to, entry.from, {epsnet::inverse(value.isometry), value.accuracy}, std::move(word));
  };
  const LabelId result = inverse();
  rounded_[f - 1].inverse = result;
  rounded_[result - 1].inverse = f;
  return result;
}

LabelId Atlas::power(LabelId f, std::uint64_t n) {
  assert(f == kIdentity || from(f) == to(f));
  LabelId result = kIdentity;
  for (LabelId square = f; n > 0; n /= 2) {
    if (n % 2 != 0) result = product(square, result);
    if (n > 1) square = product(square, square);
  }
  return result;
}

template <class T>
const Isometry<T>& Atlas::isometry_in(LabelId l) {
  assert(is_other(l));
  if constexpr (std::is_same_v<T, double>) {
    return rounded_[l - 1].isometry;
  } else if constexpr (std::is_same_v<T, Mp256>) {
    return precise(l).isometry;
  } else {
    auto& known = std::get<Known<T>>(known_).labels;
    const auto found = known.find(l);
    if (found != known.end()) {
      return found->second;
    }
    const LabelEntry& entry = labels_[l - 1];
    constexpr double kBits = std::is_same_v<T, Mp1024> ? 620 : 2020;
    const auto value = evaluate_to<T>(kBits, entry.from, entry.to, entry.word);
    if (!value) throw_too_far(entry.word.size());
    return known.emplace(l, value->isometry).first->second;
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

std::optional<Atlas::Place> Atlas::place_nearby(std::uint32_t c, const Complex<double>& z) {
  constexpr double kRadius2 = kChartRadius * kChartRadius;
  std::optional<Place> best;
  double best_norm = kRadius2;
  for (const LabelId l : labels_to(c)) {
    const Complex<double> w = epsnet::inverse(isometry(l))(z);
    if (norm(w) < best_norm) {
      best_norm = norm(w);
      best = Place{from(l), w, l};
    }
  }
  return best;
}

std::optional<std::uint32_t> Atlas::side_before(std::uint32_t tile, const Complex<Mp1024>& z,
                                                std::optional<std::uint32_t> entered) const {
  const Tile& vertices = surface_.tiles()[tile];
  const auto n = static_cast<std::uint32_t>(vertices.size());
  const std::uint32_t first = surface_.side_number(tile, 0);
  // Most sides are seen in binary64 to have the point on their left.
  const auto is_left_of = [&](std::uint32_t k, std::uint32_t next) {
    constexpr double kRounding = 2 * kUnitRoundoff;
    const StageSign seen =
        orientation_stage<double>(corners_[first + k], corners_[first + next], convert<double>(z), kRounding);
    return seen.certain
               ? seen.sign > 0
               : orientation_determinant(convert<Mp1024>(vertices[k]), convert<Mp1024>(vertices[next]), z) >= 0;
  };
  for (std::uint32_t k = 0; k < n; ++k) {
    if (entered != first + k && !is_left_of(k, (k + 1) % n)) {
      return first + k;
    }
  }
  return std::nullopt;
}

std::optional<Atlas::TilePoint> Atlas::walk_through_tiles(std::uint32_t tile, const Complex<Mp1024>& z) const {
  constexpr std::size_t kLongestPath = 10'000;
  TilePoint point{tile, z, {}};
  std::optional<std::uint32_t> entered;
  while (const std::optional<std::uint32_t> s = side_before(point.tile, point.z, entered)) {
    point.z = crossing<Mp1024>(*s)(point.z);
    point.path.push_back(*s);
    entered = surface_.partner(*s);
    point.tile = surface_.tile_of_side(*entered);
    if (point.path.size() > kLongestPath) {
      return std::nullopt;
    }
  }
  return point;
}

std::optional<std::uint32_t> Atlas::chart_near(const TilePoint& point) const {
  const auto charts = charts_of_tile_.find(point.tile);
  if (charts == charts_of_tile_.end()) {
    return std::nullopt;
  }
  std::optional<std::uint32_t> nearest;
  double best = 0.6 * 0.6;
  // Most charts are seen in binary64 to be farther than that.
  const Complex<double> seen = convert<double>(point.z);
  for (const std::uint32_t candidate : charts->second) {
    if (certainly_farther(charts_[candidate].centre, seen, best)) {
      continue;
    }
    const double distance2 = static_cast<double>(norm(epsnet::inverse(frame<Mp1024>(candidate))(point.z)));
    if (distance2 < best) {
      best = distance2;
      nearest = candidate;
    }
  }
  return nearest;
}

std::optional<Atlas::Place> Atlas::place(std::uint32_t c, const Complex<Mp1024>& z, Precision precision) {
  assert(norm(z) < 1);
  // In the tile whose coordinates it has: far from the origin bits are worth less, so there are many.
  const std::optional<TilePoint> point = walk_through_tiles(charts_[c].chart.tile, frame<Mp1024>(c)(z));
  if (!point) {
    return std::nullopt;
  }
  const bool exact = precision == Precision::bits_256;
  std::optional<std::uint32_t> chart = exact ? std::nullopt : chart_near(*point);
  if (!chart) {
    // Short centres where binary64 places them well, else all the bits there are.
    const bool round = !exact && norm(point->z) < 0.999999;
    const Complex<Rational> centre =
        round ? convert<Rational>(convert<double>(point->z)) : convert<Rational>(convert<Mp256>(point->z));
    chart = add_chart({point->tile, centre});
  }
  const Complex<double> rounded =
      exact ? Complex<double>{0, 0} : convert<double>(epsnet::inverse(frame<Mp1024>(*chart))(point->z));
  const std::optional<LabelId> to_c = find_label(*chart, c, reversed(surface_, point->path));
  return to_c ? std::optional(Place{*chart, rounded, *to_c}) : std::nullopt;
}

template Isometry<Mp256> Atlas::frame<Mp256>(std::uint32_t) const;
template Isometry<Mp1024> Atlas::frame<Mp1024>(std::uint32_t) const;
template Isometry<Mp4096> Atlas::frame<Mp4096>(std::uint32_t) const;
template const Isometry<Mp256>& Atlas::isometry_in<Mp256>(LabelId);
template const Isometry<Mp1024>& Atlas::isometry_in<Mp1024>(LabelId);
template Complex<Mp256> Atlas::lift<Mp256>(LabelId, const Complex<double>&);
template Complex<Mp1024> Atlas::lift<Mp1024>(LabelId, const Complex<double>&);
template Complex<Mp4096> Atlas::lift<Mp4096>(LabelId, const Complex<double>&);
template Mp256 Atlas::lift_error<Mp256>();
template Mp1024 Atlas::lift_error<Mp1024>();
template Mp4096 Atlas::lift_error<Mp4096>();

}  // namespace epsnet
