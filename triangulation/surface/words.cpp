#include "triangulation/surface/words.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "kernel/plane.h"
#include "kernel/predicates.h"
#include "triangulation/surface/surface.h"

namespace epsnet {
namespace {

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

}  // namespace

Charts::Charts(const Surface& surface) : surface_(surface) {
  disks_.reserve(surface.tiles().size());
  for (const Tile& tile : surface.tiles()) {
    const std::size_t first = corners_.size();
    for (const Complex<Rational>& corner : tile) {
      corners_.push_back(convert<double>(corner));
    }
    disks_.push_back(disk_inside(std::span(corners_).subspan(first)));
  }
}

Charts::Disk Charts::disk_inside(std::span<const Complex<double>> tile) {
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

ChartId Charts::add(Chart chart) {
  assert(chart.tile.number() < surface_.tiles().size() && norm(chart.centre) < 1);
  const ChartId c = entries_.end_id();
  of_tile_[chart.tile].push_back(c);
  Disk disk = disks_[chart.tile];
  const Complex<double> centre = convert<double>(chart.centre);
  disk.centre = epsnet::inverse(Isometry<double>::translation(centre))(disk.centre);
  constexpr double kFarthest = 0.999;
  if (!(norm(disk.centre) < kFarthest)) {
    disk.sinh_radius = 0;
  }
  entries_.push_back({std::move(chart), centre, disk, {}});
  entries_.back().unit_frame = normalized(frame<Mp256>(c));
  return c;
}

template <class T>
Isometry<T> Charts::frame(ChartId c) const {
  return Isometry<T>::translation(convert<T>(entry(c).chart.centre));
}

template <class T>
Isometry<T> Charts::unit_frame(ChartId c) const {
  if constexpr (std::is_same_v<T, Mp256>) {
    return entry(c).unit_frame;
  } else {
    return normalized(frame<T>(c));
  }
}

std::optional<ChartId> Charts::nearest(TileId tile, const Complex<Mp1024>& z) const {
  const auto charts = of_tile_.find(tile);
  if (charts == of_tile_.end()) {
    return std::nullopt;
  }
  std::optional<ChartId> nearest;
  double best = 0.6 * 0.6;
  // Most charts are seen in binary64 to be farther than that.
  const Complex<double> seen = convert<double>(z);
  for (const ChartId candidate : charts->second) {
    if (certainly_farther(entries_[candidate].centre, seen, best)) {
      continue;
    }
    const double distance2 = static_cast<double>(norm(epsnet::inverse(frame<Mp1024>(candidate))(z)));
    if (distance2 < best) {
      best = distance2;
      nearest = candidate;
    }
  }
  return nearest;
}

std::optional<SideId> Charts::side_before(TileId tile, const Complex<Mp1024>& z, std::optional<SideId> entered) const {
  const Tile& vertices = surface_.tile(tile);
  // Most sides are seen in binary64 to have the point on their left.
  const auto is_left_of = [&](SideId s) {
    const SideId next = surface_.next_side(s);
    constexpr double kRounding = 2 * kUnitRoundoff;
    const StageSign seen = orientation_stage<double>(corners_[s], corners_[next], convert<double>(z), kRounding);
    if (seen.certain) return seen.sign > 0;
    const auto corner = [&](SideId c) { return convert<Mp1024>(vertices[surface_.place_in_tile(c)]); };
    return orientation_determinant(corner(s), corner(next), z) >= 0;
  };
  for (const SideId s : surface_.sides_of(tile)) {
    if (entered != s && !is_left_of(s)) {
      return s;
    }
  }
  return std::nullopt;
}

template Isometry<Mp256> Charts::frame<Mp256>(ChartId) const;
template Isometry<Mp1024> Charts::frame<Mp1024>(ChartId) const;
template Isometry<Mp4096> Charts::frame<Mp4096>(ChartId) const;
template Isometry<Mp256> Charts::unit_frame<Mp256>(ChartId) const;
template Isometry<Mp1024> Charts::unit_frame<Mp1024>(ChartId) const;
template Isometry<Mp4096> Charts::unit_frame<Mp4096>(ChartId) const;

namespace {

constexpr std::size_t turn_index(Turn turn) { return turn == Turn::clockwise ? 1 : 0; }

/// The crossings of one full turn that goes on from side s.
std::uint32_t crossings_around(const Surface& surface, SideId s, Turn turn) {
  return surface.corners_around(turn == Turn::counterclockwise ? s : surface.next_side(s));
}

/// The sides of a tile between `entry` and `exit` in the direction of a turn, if they are one or two and three tiles
/// meet at each of their ends; none otherwise.
std::vector<SideId> sides_between(const Surface& surface, SideId entry, SideId exit, Turn turn) {
  std::vector<SideId> sides;
  for (SideId s = entry; sides.size() <= 2; sides.push_back(s)) {
    if (crossings_around(surface, surface.partner(s), turn) != 3) return {};
    s = turn == Turn::counterclockwise ? surface.next_side(s) : surface.previous_side(s);
    if (s == exit) return sides;
  }
  return {};
}

/// The word with one letter less, where the path passes a row of tiles that are side by side with the tiles of a
/// shorter one: at the first and the last tile it leaves one side on one hand, at those between two. Nothing if it does
/// not.
///
/// Where three tiles meet at a vertex, a path may go around a tile again and again, and no vertex is on it for long.
std::optional<Word> straightened(const Surface& surface, const Word& word) {
  // Across the vertex at which a path turns with this crossing and the one before: one crossing instead of both.
  const auto shortcut = [&](SideId second, Turn turn) { return surface.partner(next_crossing(surface, second, turn)); };
  for (const Turn turn : {Turn::counterclockwise, Turn::clockwise}) {
    std::optional<std::size_t> start;
    Word row;
    for (std::size_t k = 0; k + 1 < word.size(); ++k) {
      const std::vector<SideId> sides = sides_between(surface, surface.partner(word[k]), word[k + 1], turn);
      if (sides.size() == 1 && start) {
        row.push_back(shortcut(word[k + 1], turn));
        row.insert(row.begin(), word.data(), word.data() + *start);
        row.insert(row.end(), word.data() + k + 2, word.data() + word.size());
        return row;
      }
      if (sides.size() == 1) {
        start = k;
        row = {shortcut(sides[0], turn)};
      } else if (sides.size() == 2 && start) {
        row.push_back(shortcut(sides[1], turn));
      } else {
        start.reset();
      }
    }
  }
  return std::nullopt;
}

}  // namespace

Word word_of_letters(const std::vector<std::uint32_t>& letters) {
  Word word;
  word.reserve(letters.size());
  for (const std::uint32_t letter : letters) word.emplace_back(letter);
  return word;
}

std::vector<std::uint32_t> letters_of(const Word& word) {
  std::vector<std::uint32_t> letters;
  letters.reserve(word.size());
  for (const SideId s : word) letters.push_back(s.number());
  return letters;
}

Word reversed(const Surface& surface, const Word& word) {
  Word result(word.rbegin(), word.rend());
  for (SideId& s : result) {
    s = surface.partner(s);
  }
  return result;
}

namespace {

/// Dehn's algorithm.
Word shortened(const Surface& surface, Word word, const Word& then) {
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
        SideId s = word.back();
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
  return word;
}

}  // namespace

Word concatenated(const Surface& surface, Word first, const Word& then) {
  // Short words are left as they are: nothing is gained there.
  constexpr std::size_t kLong = 64;
  Word word = shortened(surface, std::move(first), then);
  while (word.size() > kLong) {
    const std::optional<Word> shorter = straightened(surface, word);
    if (!shorter) break;
    word = shortened(surface, {}, *shorter);
  }
  return word;
}

Word path_between_tiles(const Surface& surface, TileId from, TileId to) {
  assert(from.number() < surface.tiles().size() && to.number() < surface.tiles().size());
  // The side through which a tile was reached.
  ById<TileId, std::optional<SideId>> entered(surface.tiles().size());
  std::vector<TileId> queue{to};
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const TileId tile = queue[i];
    for (const SideId s : surface.sides_of(tile)) {
      const SideId partner = surface.partner(s);
      const TileId next = surface.tile_of_side(partner);
      if (next == to || entered[next]) continue;
      entered[next] = partner;
      queue.push_back(next);
    }
  }
  Word word;
  for (TileId tile = from; tile != to; tile = surface.tile_of_side(surface.partner(word.back()))) {
    word.push_back(*entered[tile]);
  }
  return word;
}

bool is_path(const Surface& surface, TileId from, TileId to, const Word& word) {
  TileId tile = from;
  for (const SideId s : word) {
    if (s.number() >= surface.side_count() || surface.tile_of_side(s) != tile) return false;
    tile = surface.tile_of_side(surface.partner(s));
  }
  return tile == to;
}

std::optional<std::string> closed_path_problem(const Surface& surface, const Word& word) {
  for (std::size_t i = 0; i < word.size(); ++i) {
    const std::string letter = "letter " + std::to_string(i) + " is side " + to_string(word[i]);
    if (word[i].number() >= surface.side_count()) {
      return letter + ", the surface has " + std::to_string(surface.side_count()) + " sides";
    }
    const SideId before = word[i == 0 ? word.size() - 1 : i - 1];
    if (before.number() >= surface.side_count()) continue;  // Its own turn comes.
    const TileId tile = surface.tile_of_side(surface.partner(before));
    if (surface.tile_of_side(word[i]) != tile) {
      return letter + ", no side of tile " + to_string(tile) +
             (i == 0 ? ", where the path ends" : ", where the letters before it lead");
    }
  }
  return std::nullopt;
}

namespace {

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

}  // namespace

WordEvaluator::WordEvaluator(const Surface& surface) : surface_(surface) {
  crossings_.reserve(surface.side_count());
  for (const SideId s : surface.side_ids()) {
    const SideId partner = surface.partner(s);
    crossings_.push_back(partner < s ? epsnet::inverse(crossings_[partner])
                                     : convert<Mp256>(surface.crossing_as<Mp1024>(s)));
  }
  const auto is_long = [&](SideId corner) { return surface.corners_around(corner) >= 2 * kLongTurn; };
  constexpr std::uint32_t kNoRank = ~std::uint32_t{0};
  for (const SideId corner : surface.side_ids()) {
    if (!is_long(corner)) continue;
    if (rank_in_turn_.empty()) rank_in_turn_.assign(surface.side_count(), kNoRank);
    std::uint32_t rank = 0;
    for (SideId s = corner; rank_in_turn_[s] == kNoRank; s = next_crossing(surface, s, Turn::counterclockwise)) {
      rank_in_turn_[s] = rank++;
    }
  }
}

template <class T>
const Isometry<T>& WordEvaluator::crossing(SideId s) const {
  if constexpr (std::is_same_v<T, Mp256>) {
    return crossings_[s];
  } else {
    auto& known = std::get<Known<T>>(known_).crossings;
    const auto found = known.find(s);
    return found != known.end() ? found->second : known.emplace(s, surface_.crossing_as<T>(s)).first->second;
  }
}

template <class T>
const WordEvaluator::FullTurn<T>& WordEvaluator::full_turn(SideId corner) const {
  auto& known = std::get<Known<T>>(known_).full_turns;
  const std::uint32_t vertex = surface_.vertex_class(corner);
  if (const auto found = known.find(vertex); found != known.end()) {
    return found->second;
  }
  SideId s = corner;
  while (rank_in_turn_[s] != 0) s = next_crossing(surface_, s, Turn::counterclockwise);
  FullTurn<T> result{{Isometry<T>{}}, 0};
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
double WordEvaluator::append_factors(const Word& word, std::vector<Isometry<T>>& factors) const {
  double missing = 0;
  const auto product_of_turn = [&](SideId first, std::size_t length) {
    const FullTurn<TurnField<T>>& around = full_turn<TurnField<T>>(first);
    const std::size_t n = around.products.size();
    const std::size_t start = rank_in_turn_[first];
    missing = std::max(missing, around.bits_lost + kMantissaBits<T> - kMantissaBits<TurnField<T>>);
    return convert<T>(around.products[(start + length) % n] * epsnet::inverse(around.products[start]));
  };
  for (std::size_t i = 0; i < word.size();) {
    if (!rank_in_turn_.empty()) {
      const std::size_t forward = turn_length(surface_, word, i, Turn::counterclockwise);
      const std::size_t backward = turn_length(surface_, word, i, Turn::clockwise);
      if (forward >= kLongTurn) {
        factors.push_back(product_of_turn(word[i], forward));
        i += forward;
        continue;
      }
      if (backward >= kLongTurn) {
        // The path backwards turns counterclockwise.
        const SideId last = word[i + backward - 1];
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
WordEvaluator::Product<T> WordEvaluator::product(const Charts& charts, ChartId from, ChartId to,
                                                 const Word& word) const {
  // The value is a product M_n … M_0; an error in M_i is magnified by the partial products on its two sides. Factors
  // have determinant 1, the product is not normalised again: |a|² − |b|² has lost its bits where |a| is large.
  std::vector<Isometry<T>> factors{charts.unit_frame<T>(from)};
  const double missing = append_factors<T>(word, factors);
  factors.push_back(epsnet::inverse(charts.unit_frame<T>(to)));
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
std::optional<Evaluated<T>> WordEvaluator::value(double bits, const Charts& charts, ChartId from, ChartId to,
                                                 const Word& word) const {
  const auto rounded = [](const auto& value, double field_bits) {
    return Evaluated<T>{convert<T>(value.isometry), std::min(field_bits - value.bits_lost, kMantissaBits<T> - 4.0)};
  };
  if constexpr (kMantissaBits<T> <= 256) {
    if (const auto value = product<Mp256>(charts, from, to, word); value.bits_lost + bits <= 256) {
      return rounded(value, 256);
    }
  }
  if constexpr (kMantissaBits<T> <= 1024) {
    if (const auto value = product<Mp1024>(charts, from, to, word); value.bits_lost + bits <= 1024) {
      return rounded(value, 1024);
    }
  }
  // Where triangles start so far from Delaunay that their words grow and grow, this is where it ends: the paths of nets
  // have a few dozen sides, or as many as a polygon.
  const std::size_t longest = 500 + surface_.side_count();
  if (word.size() <= longest) {
    if (const auto value = product<Mp4096>(charts, from, to, word); value.bits_lost + bits <= 4096) {
      return rounded(value, 4096);
    }
  }
  return std::nullopt;
}

template std::optional<Evaluated<Mp256>> WordEvaluator::value<Mp256>(double, const Charts&, ChartId, ChartId,
                                                                     const Word&) const;
template std::optional<Evaluated<Mp1024>> WordEvaluator::value<Mp1024>(double, const Charts&, ChartId, ChartId,
                                                                       const Word&) const;
template std::optional<Evaluated<Mp4096>> WordEvaluator::value<Mp4096>(double, const Charts&, ChartId, ChartId,
                                                                       const Word&) const;
template const Isometry<Mp1024>& WordEvaluator::crossing<Mp1024>(SideId) const;

}  // namespace epsnet
