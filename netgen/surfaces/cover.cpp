#include <algorithm>
#include <array>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <numeric>
#include <optional>
#include <utility>

#include "certify/file/json.h"
#include "netgen/surfaces/exact_isometries.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/relations.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet {
namespace {

using Engine = boost::random::mt19937_64;

constexpr std::uint64_t kMostSides = 1U << 20;

Permutation identity(std::size_t degree) {
  Permutation result(degree);
  std::iota(result.begin(), result.end(), 0U);
  return result;
}

Permutation inverse_of(const Permutation& p) {
  Permutation result(p.size());
  for (std::uint32_t i = 0; i < p.size(); ++i) result[p[i]] = i;
  return result;
}

/// The sheets that are reached from sheet 0.
std::size_t reached(const std::vector<Permutation>& permutations, std::size_t degree) {
  std::vector<bool> seen(degree);
  std::vector<std::uint32_t> found{0};
  seen[0] = true;
  for (std::size_t next = 0; next < found.size(); ++next) {
    for (const Permutation& p : permutations) {
      const std::uint32_t sheet = p[found[next]];
      if (!seen[sheet]) found.push_back(sheet);
      seen[sheet] = true;
    }
  }
  return found.size();
}

void require_permutations(const std::vector<Permutation>& permutations, std::size_t pairs) {
  if (permutations.size() != pairs) {
    throw CoverError(std::to_string(permutations.size()) + " permutations found, expected " + std::to_string(pairs) +
                     ", one for each pair of sides of the fundamental polygon");
  }
  const std::size_t degree = permutations.front().size();
  if (degree == 0) throw CoverError("permutation 0 is empty, expected the images of the sheets 0, 1, ...");
  std::size_t number = 0;
  for (const Permutation& permutation : permutations) {
    const std::string name = "permutation " + std::to_string(number++);
    if (permutation.size() != degree) {
      throw CoverError(name + ": " + std::to_string(permutation.size()) + " sheets found, expected " +
                       std::to_string(degree) + " as in permutation 0");
    }
    std::vector<bool> seen(degree);
    for (const std::uint32_t sheet : permutation) {
      if (sheet >= degree || seen[sheet]) {
        throw CoverError(
            name + ": sheet " + std::to_string(sheet) +
            (sheet >= degree ? " found, expected 0 to " + std::to_string(degree - 1) : " is the image of two sheets"));
      }
      seen[sheet] = true;
    }
  }
}

/// By side of the polygon: where one gets across it.
std::vector<Permutation> both_ways(const PolygonSides& polygon, const std::vector<Permutation>& permutations) {
  std::vector<Permutation> across(polygon.side.size());
  std::size_t pair = 0;
  for (std::uint32_t k = 0; k < across.size(); ++k) {
    if (k > polygon.partner[k]) continue;
    across[k] = permutations[pair++];
    across[polygon.partner[k]] = inverse_of(across[k]);
  }
  return across;
}

void require_relations(const PolygonSides& polygon, const std::vector<Permutation>& across) {
  for (const SidesOfPolygon& relation : polygon.relations) {
    Permutation around = identity(across.front().size());
    for (const std::uint32_t k : relation) around = composed(around, across[k]);
    for (std::uint32_t i = 0; i < around.size(); ++i) {
      if (around[i] == i) continue;
      std::string sides;
      for (const std::uint32_t k : relation) sides += " " + std::to_string(k);
      throw CoverError("around the vertex where the sides" + sides + " of the fundamental polygon are crossed, sheet " +
                       std::to_string(i) + " leads to sheet " + std::to_string(around[i]) + ", expected to itself");
    }
  }
}

// Random covers. What the sides of the polygon mean for the sheets is a homomorphism of the group: one permutation for
// each generator that is left with one relation.

/// The relation as x B y C x⁻¹ D y⁻¹ Z. It says [x₁, y₁] = (B Z D C)⁻¹ up to conjugation: with y = B⁻¹ y₁ C⁻¹ and
/// x = D C x₁ it is [x₁, y₁] = C⁻¹ D⁻¹ Z⁻¹ B⁻¹.
struct Commutator {
  std::uint32_t x;
  std::uint32_t y;
  SidesOfPolygon b, c, d, z;
};

Commutator commutator(const PolygonSides& polygon, const SidesOfPolygon& relation) {
  const std::size_t n = relation.size();
  std::vector<std::size_t> place(polygon.side.size());
  for (std::size_t i = 0; i < n; ++i) place[relation[i]] = i;
  const auto between = [&](std::size_t from, std::size_t to) {
    SidesOfPolygon result;
    for (std::size_t i = (from + 1) % n; i != to; i = (i + 1) % n) result.push_back(relation[i]);
    return result;
  };
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t back = place[polygon.partner[relation[i]]];
    for (std::size_t j = i + 1; j < back; ++j) {
      const std::size_t end = place[polygon.partner[relation[j]]];
      if (end > back)
        return {relation[i], relation[j], between(i, j), between(j, back), between(back, end), between(end, i)};
    }
  }
  throw CoverError("the relation of the group is not that of an oriented surface");
}

std::uint32_t below(Engine& engine, std::uint32_t bound) {
  return boost::random::uniform_int_distribution<std::uint32_t>(0, bound - 1)(engine);
}

template <class T>
void shuffle(std::vector<T>& items, Engine& engine) {
  for (std::size_t i = items.size(); i > 1; --i) {
    std::swap(items[i - 1], items[below(engine, static_cast<std::uint32_t>(i))]);
  }
}

std::vector<Permutation> cycles_of(const Permutation& p) {
  std::vector<Permutation> cycles;
  std::vector<bool> seen(p.size());
  for (std::uint32_t start = 0; start < p.size(); ++start) {
    if (seen[start]) continue;
    Permutation& cycle = cycles.emplace_back();
    for (std::uint32_t i = start; !seen[i]; i = p[i]) {
      seen[i] = true;
      cycle.push_back(i);
    }
  }
  return cycles;
}

void sort_by_length(std::vector<Permutation>& cycles) {
  std::stable_sort(cycles.begin(), cycles.end(),
                   [](const Permutation& a, const Permutation& b) { return a.size() > b.size(); });
}

/// Partitions of a number, each as likely as the other.
class Partitions {
 public:
  explicit Partitions(std::uint32_t number) : number_(number) {
    count_.assign(number + 1, std::vector<std::uint64_t>(number + 1));
    for (std::uint32_t most = 0; most <= number; ++most) count_[0][most] = 1;
    for (std::uint32_t n = 1; n <= number; ++n) {
      for (std::uint32_t most = 1; most <= number; ++most) {
        count_[n][most] = count_[n][most - 1] + (most <= n ? count_[n - most][most] : 0);
      }
    }
  }

  std::vector<std::uint32_t> draw(Engine& engine) const {
    std::vector<std::uint32_t> parts;
    for (std::uint32_t left = number_, most = number_; left > 0;) {
      auto rank = boost::random::uniform_int_distribution<std::uint64_t>(0, count_[left][most] - 1)(engine);
      std::uint32_t part = 1;
      while (rank >= count_[left][part]) ++part;
      parts.push_back(part);
      left -= part;
      most = part;
    }
    return parts;
  }

 private:
  std::uint32_t number_;
  std::vector<std::vector<std::uint64_t>> count_;  ///< Of n into parts of at most the second.
};

/// A pair with [x, y] = w; nullopt if the draw was none. Every such pair is as likely as the other, and as likely for
/// one w as for the other: each class of x is as likely, so x is as likely as it has few conjugates; and there are as
/// many y as elements that commute with x.
std::optional<std::array<Permutation, 2>> draw_pair(const Permutation& w, const Partitions& partitions,
                                                    Engine& engine) {
  const std::vector<std::uint32_t> parts = partitions.draw(engine);
  Permutation points = identity(w.size());
  shuffle(points, engine);
  Permutation x(w.size());
  std::size_t start = 0;
  for (const std::uint32_t part : parts) {
    for (std::size_t i = 0; i < part; ++i) x[points[start + i]] = points[start + (i + 1) % part];
    start += part;
  }
  // y x⁻¹ y⁻¹ = x⁻¹ w takes the cycles of x⁻¹ w to those of x⁻¹, all of which are as long.
  const Permutation back = inverse_of(x);
  std::vector<Permutation> from = cycles_of(composed(back, w));
  std::vector<Permutation> to = cycles_of(back);
  if (from.size() != to.size()) return std::nullopt;
  shuffle(to, engine);
  sort_by_length(from);
  sort_by_length(to);
  if (!std::equal(from.begin(), from.end(), to.begin(),
                  [](const Permutation& a, const Permutation& b) { return a.size() == b.size(); })) {
    return std::nullopt;
  }
  Permutation y(w.size());
  for (std::size_t i = 0; i < to.size(); ++i) {
    const auto length = static_cast<std::uint32_t>(to[i].size());
    const std::uint32_t turn = below(engine, length);
    for (std::uint32_t k = 0; k < length; ++k) y[from[i][k]] = to[i][(k + turn) % length];
  }
  return std::array{std::move(x), std::move(y)};
}

/// The rows, so many times.
template <class Row>
std::vector<Row> repeated(const std::vector<Row>& rows, std::size_t times) {
  std::vector<Row> result;
  for (std::size_t i = 0; i < times; ++i) result.insert(result.end(), rows.begin(), rows.end());
  return result;
}

}  // namespace

std::vector<Permutation> parse_permutations(const std::string& text) {
  certify::ByteStream bytes(text);
  certify::Json json(bytes);
  std::vector<Permutation> result;
  const auto take = [&](const char* expected) {
    if (!json.take('[')) throw CoverError(json.found() + " found, expected " + expected);
  };
  try {
    take("an array of permutations, as in [[1, 0, 2], [0, 2, 1]]");
    json.elements([&](std::size_t k) {
      take("the array of the images of the sheets 0, 1, ...");
      Permutation& permutation = result.emplace_back();
      json.elements([&](std::size_t i) {
        const std::string token(json.token());
        const bool digits =
            !token.empty() && token.size() <= 7 && token.find_first_not_of("0123456789") == std::string::npos;
        if (!digits) {
          throw CoverError("permutation " + std::to_string(k) + ", entry " + std::to_string(i) + ": " +
                           (token.empty() ? json.found() : "\"" + token.substr(0, 40) + "\"") +
                           " found, expected the number of a sheet");
        }
        permutation.push_back(static_cast<std::uint32_t>(std::stoul(token)));
      });
    });
    if (!json.at_end()) throw CoverError("something follows the array");
  } catch (const certify::JsonError& error) {
    throw CoverError(std::string("not JSON: ") + error.what());
  }
  return result;
}

Surface cover(const Surface& base, const std::vector<Permutation>& permutations) {
  const PolygonSides polygon = polygon_sides(base);
  require_permutations(permutations, polygon.side.size() / 2);
  const std::size_t degree = permutations.front().size();
  if (degree * base.side_count() > kMostSides) {
    throw CoverError(std::to_string(degree) + " sheets of " + std::to_string(base.side_count()) +
                     " sides found, expected at most 2^20 sides");
  }
  const std::vector<Permutation> across = both_ways(polygon, permutations);
  require_relations(polygon, across);
  if (const std::size_t sheets = reached(permutations, degree); sheets < degree) {
    throw CoverError("the cover is not connected: from sheet 0 one gets to " + std::to_string(sheets) + " of " +
                     std::to_string(degree) + " sheets");
  }
  const auto tiles = static_cast<std::uint32_t>(base.tiles().size());
  ById<SideId, std::uint32_t> side_of_polygon(base.side_count(), base.side_count());
  for (std::uint32_t k = 0; k < polygon.side.size(); ++k) side_of_polygon[polygon.side[k]] = k;
  std::vector<Tile> copies;
  std::vector<Gluing> gluing;
  certify::SurfaceDocument::Field over_field;
  if (base.field_tiles()) over_field = base.field_tiles()->document;
  for (std::uint32_t sheet = 0; sheet < degree; ++sheet) {
    if (base.is_rational()) copies.insert(copies.end(), base.tiles().begin(), base.tiles().end());
    for (const Gluing& g : base.gluing()) {
      const std::uint32_t k = side_of_polygon[base.side_number(TileId(g.tile), g.side)];
      const std::uint32_t other = k < across.size() ? across[k][sheet] : sheet;
      gluing.push_back({sheet * tiles + g.tile, g.side, other * tiles + g.other_tile, g.other_side});
    }
  }
  over_field.polygons = repeated(over_field.polygons, degree);
  over_field.crossings = repeated(over_field.crossings, degree);
  Surface result = base.is_regular()    ? Surface::map(*base.regular_tile(), std::move(gluing))
                   : base.is_rational() ? Surface(std::move(copies), std::move(gluing))
                                        : surface_over_field(std::move(over_field), std::move(gluing));
  const std::string of = base.about().empty() ? "a surface of genus " + std::to_string(base.genus()) : base.about();
  result.set_about("cover of degree " + std::to_string(degree) + " of " + of);
  return result;
}

std::vector<Permutation> random_sheets(const Surface& base, std::uint32_t degree, std::uint64_t seed) {
  if (degree < 1 || degree > kMostRandomSheets) {
    throw CoverError("degree " + std::to_string(degree) + " found, expected 1 to " + std::to_string(kMostRandomSheets) +
                     " for a random cover");
  }
  const PolygonSides polygon = polygon_sides(base);
  const OneRelator group(polygon);
  const Commutator form = commutator(polygon, group.relation);
  const Partitions partitions(degree);
  Engine engine(seed);
  std::vector<Permutation> across(polygon.side.size());
  const auto set = [&](std::uint32_t k, const Permutation& p) {
    across[k] = p;
    across[polygon.partner[k]] = inverse_of(p);
  };
  const auto value = [&](const SidesOfPolygon& word) {
    Permutation result = identity(degree);
    for (const std::uint32_t k : word) result = composed(result, across[k]);
    return result;
  };
  for (;;) {
    for (const std::uint32_t k : group.relation) {
      if (k > polygon.partner[k] || k == form.x || k == form.y || polygon.partner[k] == form.x ||
          polygon.partner[k] == form.y) {
        continue;
      }
      Permutation p = identity(degree);
      shuffle(p, engine);
      set(k, p);
    }
    const Permutation b = value(form.b);
    const Permutation c = value(form.c);
    const Permutation d = value(form.d);
    const Permutation w = inverse_of(composed(composed(b, value(form.z)), composed(d, c)));
    const auto pair = draw_pair(w, partitions, engine);
    if (!pair) continue;
    set(form.x, composed(composed(d, c), (*pair)[0]));
    set(form.y, composed(composed(inverse_of(b), (*pair)[1]), inverse_of(c)));
    for (auto e = group.expressed.rbegin(); e != group.expressed.rend(); ++e) set(e->side, value(e->word));
    std::vector<Permutation> result;
    for (std::uint32_t k = 0; k < across.size(); ++k) {
      if (k < polygon.partner[k]) result.push_back(across[k]);
    }
    if (reached(result, degree) == degree) return result;
  }
}

}  // namespace epsnet
