#include "netgen/isometries/invariants.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "certify/base/text.h"
#include "netgen/surfaces/group.h"

namespace epsnet {
namespace {

constexpr std::uint64_t kPrime = Homology::kPrime;

/// to += factor·vector.
void add(Homology::Vector& to, std::uint64_t factor, const Homology::Vector& vector) {
  if (factor == 0) return;
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = (to[i] + factor * vector[i]) % kPrime;
}

std::uint64_t modulo_prime(std::int64_t x) {
  const auto p = static_cast<std::int64_t>(kPrime);
  return static_cast<std::uint64_t>((x % p + p) % p);
}

/// A pair of sides of a polygon in a relation, and whether it is the first of its sides that is there, 1, or the other
/// one, −1.
struct Term {
  std::size_t pair;
  std::int64_t sign;
};

}  // namespace

Homology::Homology(const Surface& surface) : sign_(surface.side_count()), pair_(surface.side_count()) {
  const PolygonSides polygon = polygon_sides(surface);
  std::size_t pairs = 0;
  for (std::size_t k = 0; k < polygon.side.size(); ++k) {
    const SideId s = polygon.side[k];
    if (polygon.partner[k] < k) continue;
    const SideId other = polygon.side[polygon.partner[k]];
    pair_[s] = pair_[other] = pairs++;
    sign_[s] = 1;
    sign_[other] = -1;
  }
  // Each of two sides of a pair is in one relation: pairs are the edges of a graph of relations. Those of a spanning
  // tree follow from the others, from its leaves on; that the sum at the root is 0 follows from all others.
  std::vector<std::vector<Term>> relations;
  std::vector<std::vector<std::size_t>> relations_of(pairs);
  for (const std::vector<std::uint32_t>& relation : polygon.relations) {
    std::vector<Term>& terms = relations.emplace_back();
    for (const std::uint32_t k : relation) {
      const SideId s = polygon.side[k];
      terms.push_back({pair_[s], sign_[s]});
      relations_of[pair_[s]].push_back(relations.size() - 1);
    }
  }
  struct Branch {
    std::size_t relation;
    Term to_root;
  };
  std::vector<Branch> tree{{0, {pairs, 0}}};
  std::vector<bool> reached(relations.size());
  std::vector<bool> follows(pairs);
  reached[0] = true;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const std::vector<Term>& terms = relations[tree[i].relation];
    for (const auto& [pair, sign] : terms) {
      for (const std::size_t relation : relations_of[pair]) {
        if (reached[relation]) continue;
        reached[relation] = true;
        follows[pair] = true;
        tree.push_back({relation, {pair, -sign}});
      }
    }
  }
  for (std::size_t pair = 0; pair < pairs; ++pair) {
    if (!follows[pair]) basis_.push_back(pair);
  }
  coordinates_.assign(pairs, Vector(basis_.size()));
  for (std::size_t i = 0; i < basis_.size(); ++i) coordinates_[basis_[i]][i] = 1;
  for (std::size_t i = tree.size(); i-- > 1;) {
    const auto& [pair, sign] = tree[i].to_root;
    Vector sum(basis_.size());
    for (const Term& term : relations[tree[i].relation]) {
      if (term.pair != pair) add(sum, modulo_prime(-sign * term.sign), coordinates_[term.pair]);
    }
    coordinates_[pair] = std::move(sum);
  }
}

Homology::Vector Homology::class_of(const Word& word) const {
  std::vector<std::int64_t> times(coordinates_.size());
  for (const SideId s : word) {
    if (sign_[s] != 0) times[pair_[s]] += sign_[s];
  }
  Vector result(basis_.size());
  for (std::size_t pair = 0; pair < times.size(); ++pair) add(result, modulo_prime(times[pair]), coordinates_[pair]);
  return result;
}

HomologyMap::HomologyMap(const Homology& homology, const std::vector<Word>& words, const std::vector<Word>& images) {
  for (std::size_t i = 0; i < homology.dimension(); ++i) {
    const std::size_t pair = homology.basis()[i];
    // The word of a pair is in its class, or in that of the inverse.
    const std::uint64_t sign = homology.class_of(words[pair])[i];
    Homology::Vector column(homology.dimension());
    add(column, sign, homology.class_of(images[pair]));
    columns_.push_back(std::move(column));
  }
}

Homology::Vector HomologyMap::operator()(const Homology::Vector& vector) const {
  // A multiple of p below 2⁶³: sums of products, each less than 2⁶², are kept below it.
  constexpr std::uint64_t kMultiple = kPrime << 32U;
  Homology::Vector result(vector.size());
  for (std::size_t j = 0; j < vector.size(); ++j) {
    const std::uint64_t factor = vector[j];
    const Homology::Vector& column = columns_[j];
    for (std::size_t i = 0; i < result.size(); ++i) {
      const std::uint64_t sum = result[i] + factor * column[i];
      result[i] = sum >= kMultiple ? sum - kMultiple : sum;
    }
  }
  for (std::uint64_t& x : result) x %= kPrime;
  return result;
}

std::int64_t HomologyMap::trace() const {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < columns_.size(); ++i) sum = (sum + columns_[i][i]) % kPrime;
  const auto result = static_cast<std::int64_t>(sum);
  return sum > kPrime / 2 ? result - static_cast<std::int64_t>(kPrime) : result;
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

std::optional<Certified<certify::ComparisonDocument>> proved_difference(const certify::GeodesicsDocument& first,
                                                                        const certify::GeodesicsDocument& other,
                                                                        unsigned threads, const Progress& progress) {
  certify::ComparisonDocument document;
  document.relation = certify::ComparisonDocument::Relation::different;
  static_cast<certify::GeodesicsDocument&>(document) = first;
  document.other = other;
  try {
    return proved(std::move(document), threads, progress);
  } catch (const NotCertifiedError&) {
    return std::nullopt;
  }
}

}  // namespace epsnet
