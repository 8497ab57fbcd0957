#include "netgen/isometries/homology.h"

#include <algorithm>

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

}  // namespace epsnet
