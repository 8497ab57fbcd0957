#include "netgen/surfaces/field_matrices.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "netgen/surfaces/field_numbers.h"
#include "netgen/surfaces/triangle_group.h"

/// The surface that matrices over the ring of a triangle group generate: they are known as walks over its tiling by
/// rounded numbers, which exact ones confirm, and walks say which tiles are the same.
namespace epsnet {
namespace {

using Kind = MatricesError::Kind;
using Number = TriangleGroup::Number;
using ExactElement = TriangleGroup::ExactElement;

/// Some 20 seconds.
constexpr std::uint64_t kMostWork = 20'000'000'000;

/// A generator, exactly up to scale, and rounded.
struct Generator {
  ExactElement exact;
  Isometry<Number> rounded;
};

std::string named(std::size_t k) { return "generator " + std::to_string(k + 1); }

Generator generator_of(const std::array<std::string, 4>& texts, MatrixModel model, const TriangleGroup& group,
                       const std::string& name) {
  std::vector<RingNumber> numbers;
  mpz_class denominator = 1;
  for (const std::string& text : texts) {
    try {
      numbers.push_back(parse_ring_number(text, group));
    } catch (const SurfaceError& error) {
      throw MatricesError(Kind::text, name + ": " + error.what());
    }
    denominator = lcm(denominator, numbers.back().denominator);
  }
  std::vector<certify::RegularNumber> e;
  e.reserve(numbers.size());
  for (const RingNumber& number : numbers) e.push_back(mpz_class(denominator / number.denominator) * number.numerator);
  const std::array<Number, 4> r{numbers[0].rounded, numbers[1].rounded, numbers[2].rounded, numbers[3].rounded};
  const certify::Gaussian i{0, 1};
  ExactElement exact = model == MatrixModel::su11
                           ? ExactElement{e[0] + i * e[1], e[2] + i * e[3]}
                           : ExactElement{e[0] + e[3] + i * (e[1] - e[2]), e[0] - e[3] - i * (e[1] + e[2])};
  if (certify::sign(certify::norm(exact.a) - certify::norm(exact.b)) <= 0) {
    throw MatricesError(
        Kind::text,
        name + ": the determinant is not positive, so it is no isometry of the plane that preserves the orientation");
  }
  return {std::move(exact), normalized(isometry_of_entries(r, model))};
}

void check_relation(const std::vector<std::int32_t>& relation, const std::vector<Generator>& generators) {
  if (relation.empty()) return;
  const ExactElement product = certify::compose_range(0, relation.size(), [&](std::size_t i) {
    const std::int32_t k = relation[relation.size() - 1 - i];
    const ExactElement& f = generators[static_cast<std::size_t>(std::abs(k)) - 1].exact;
    return k > 0 ? f : certify::inverse(f);
  });
  const certify::RegularRing& ring = *product.a.ring;
  const ExactElement one{certify::regular_number(ring, certify::Gaussian{1, 0}),
                         certify::regular_number(ring, certify::Gaussian{0, 0})};
  if (!TriangleGroup::same(product, one)) {
    throw MatricesError(Kind::relation, "the relation does not hold: the product is not a multiple of 1");
  }
}

MatrixSurface made(const MatrixGenerators& matrices) {
  const RegularTile tile = *matrices.tile;
  const TriangleGroup group = [&] {
    try {
      return TriangleGroup(tile, certify::Budget(kMostWork));
    } catch (const SurfaceError& error) {
      throw MatricesError(Kind::text, error.what());
    }
  }();
  const std::string tiling = "the tiles " + std::to_string(tile.p) + " " + std::to_string(tile.q);
  std::vector<Generator> generators;
  for (std::size_t k = 0; k < matrices.numbers.size(); ++k)
    generators.push_back(generator_of(matrices.numbers[k], matrices.model, group, named(k)));
  check_relation(matrices.relation, generators);
  std::vector<TileWalk> walks;
  for (std::size_t k = 0; k < generators.size(); ++k) {
    const auto walk = group.walk(generators[k].rounded);
    if (!walk || !TriangleGroup::same(group.element(*walk), generators[k].exact)) {
      throw MatricesError(Kind::undecided,
                          "could not decide: " + named(k) + " does not take " + tiling +
                              " to themselves, of which one has its centre at " +
                              (matrices.model == MatrixModel::su11 ? "0" : "i") +
                              " and the midpoint of a side to the right of it, or moves them too far; without tiles, "
                              "decimals mean a surface that is near");
    }
    walks.push_back(*walk);
  }
  const auto tiles = subgroup_tiles(tile, walks);
  if (!tiles) {
    throw MatricesError(Kind::undecided, "could not decide: the surface has more than 2^20 sides of " + tiling +
                                             ", or the group is not cocompact");
  }
  MatrixSurface result{Surface::map(tile, tiles->gluing), {}};
  for (const std::vector<std::uint32_t>& path : tiles->paths) result.words.push_back(word_of_letters(path));
  result.surface.set_about("map of type {" + std::to_string(tile.p) + ", " + std::to_string(tile.q) + "} of " +
                           std::to_string(matrices.numbers.size()) + " matrices");
  return result;
}

}  // namespace

MatrixSurface surface_of_field_matrices(const MatrixGenerators& matrices) {
  try {
    return made(matrices);
  } catch (const MatricesError&) {
    throw;
  } catch (const certify::BudgetSpent&) {
    throw MatricesError(Kind::undecided, "could not decide: the numbers are too long");
  } catch (const SurfaceError& error) {
    throw MatricesError(Kind::torsion, error.what());
  }
}

}  // namespace epsnet
