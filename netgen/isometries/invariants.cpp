#include "netgen/isometries/invariants.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "certify/base/text.h"
#include "netgen/surfaces/group.h"

namespace epsnet {
namespace {

constexpr std::int64_t kPrime = (std::int64_t{1} << 31) - 1;

std::int64_t reduced(std::int64_t x) { return (x % kPrime + kPrime) % kPrime; }

std::int64_t inverse(std::int64_t x) {
  std::int64_t result = 1;
  for (std::int64_t power = kPrime - 2; power != 0; power >>= 1) {
    if ((power & 1) != 0) result = result * x % kPrime;
    x = x * x % kPrime;
  }
  return result;
}

/// from −= factor·vector.
void subtract(std::vector<std::int64_t>& from, std::int64_t factor, const std::vector<std::int64_t>& vector) {
  for (std::size_t i = 0; i < from.size(); ++i) from[i] = reduced(from[i] - factor * vector[i] % kPrime);
}

}  // namespace

Homology::Homology(const Surface& surface) : sign_(surface.side_count()), pair_(surface.side_count()) {
  const PolygonSides polygon = polygon_sides(surface);
  for (std::size_t k = 0; k < polygon.side.size(); ++k) {
    const SideId s = polygon.side[k];
    if (polygon.partner[k] < k) continue;
    const SideId other = polygon.side[polygon.partner[k]];
    pair_[s] = pair_[other] = pairs_++;
    sign_[s] = 1;
    sign_[other] = -1;
  }
  for (const std::vector<std::uint32_t>& relation : polygon.relations) {
    Word word;
    for (const std::uint32_t k : relation) word.push_back(polygon.side[k]);
    Row row = class_of(word);
    for (std::size_t i = 0; i < relations_.size(); ++i) subtract(row, row[pivots_[i]], relations_[i]);
    const auto pivot = std::find_if(row.begin(), row.end(), [](std::int64_t x) { return x != 0; });
    if (pivot == row.end()) continue;
    const auto column = static_cast<std::size_t>(pivot - row.begin());
    const std::int64_t scale = inverse(*pivot);
    for (std::int64_t& x : row) x = x * scale % kPrime;
    for (Row& earlier : relations_) subtract(earlier, earlier[column], row);
    relations_.push_back(std::move(row));
    pivots_.push_back(column);
  }
}

Homology::Row Homology::class_of(const Word& word) const {
  Row result(pairs_);
  for (const SideId s : word) {
    if (sign_[s] != 0) result[pair_[s]] = reduced(result[pair_[s]] + sign_[s]);
  }
  return result;
}

std::int64_t Homology::trace(const std::vector<Word>& words, const std::vector<Word>& images) const {
  std::int64_t sum = 0;
  for (std::size_t k = 0; k < words.size(); ++k) {
    // The classes of the pairs without pivots are a basis; the word of pair k is that class or its inverse.
    if (std::find(pivots_.begin(), pivots_.end(), k) != pivots_.end()) continue;
    Row image = class_of(images[k]);
    for (std::size_t i = 0; i < relations_.size(); ++i) subtract(image, image[pivots_[i]], relations_[i]);
    sum = reduced(sum + class_of(words[k])[k] * image[k]);
  }
  return sum > kPrime / 2 ? sum - kPrime : sum;
}

namespace {

/// The lower and upper bounds of all lengths, each in order.
struct Bounds {
  std::vector<double> lower;
  std::vector<double> upper;

  explicit Bounds(const certify::GeodesicsDocument& spectrum) {
    for (const auto& geodesic : spectrum.geodesics) {
      lower.push_back(geodesic.length.lower);
      upper.push_back(geodesic.length.upper);
    }
    std::sort(lower.begin(), lower.end());
    std::sort(upper.begin(), upper.end());
  }
};

std::size_t count_up_to(const std::vector<double>& sorted, double length) {
  return static_cast<std::size_t>(std::upper_bound(sorted.begin(), sorted.end(), length) - sorted.begin());
}

/// Whether one surface has certainly more closed geodesics of length at most ℓ than the other one, for some ℓ up to
/// which the list of the other one is complete.
std::optional<std::string> certainly_more(const Bounds& some, const char* name, const Bounds& others,
                                          const char* other_name, const std::string& complete_up_to) {
  const mpq_class limit = certify::decimal(complete_up_to);
  for (const double length : some.upper) {
    if (mpq_class(length) > limit) return std::nullopt;
    const std::size_t least = count_up_to(some.upper, length);
    const std::size_t most = count_up_to(others.lower, length);
    if (least <= most) continue;
    return std::string(name) + " has at least " + std::to_string(least) +
           " primitive closed geodesics of length at most " + certify::shortest(length) + ", " + other_name +
           " at most " + std::to_string(most);
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> certain_difference(const certify::GeodesicsDocument& first,
                                              const certify::GeodesicsDocument& second) {
  const Bounds of_first(first);
  const Bounds of_second(second);
  const auto found = certainly_more(of_first, "the first surface", of_second, "the second one", second.up_to);
  return found ? found : certainly_more(of_second, "the second surface", of_first, "the first one", first.up_to);
}

}  // namespace epsnet
