#include "netgen/eigenvalues/eigenvalues.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "certify/claims/eigenvalues/forms.h"
#include "certify/net/labels.h"
#include "certify/net/rules.h"
#include "certify/numbers/ball.h"
#include "netgen/eigenvalues/elements.h"
#include "netgen/nets/certified_net.h"
#include "netgen/pictures/pictures.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/surfaces.h"

/// The generator's side of eigenvalues. `certify` shares no code with it but the factorization, so agreement with it is
/// a test of both.
namespace epsnet::eigenvalues_test {
namespace {

using certify::Ball;
using certify::EigenvaluesDocument;
using certify::Interval;
using certify::NetDocument;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// A surface with its first eigenvalues as they are known, each with its multiplicity.
struct Known {
  const char* name;
  Surface surface;
  std::vector<std::pair<double, std::uint32_t>> eigenvalues;

  [[nodiscard]] std::vector<double> all() const {
    std::vector<double> result;
    for (const auto& [value, count] : eigenvalues) result.insert(result.end(), count, value);
    return result;
  }
};

/// Octagon and Klein's quartic: proved from complete lists of closed geodesics, by the trace formula (until commit
/// e4d5b04). Bolza: A. Strohmaier and V. Uski.
const Known& octagon() {
  static const Known result{"octagon 5",
                            random_octagon(5),
                            {{2.7750679832, 1},
                             {3.7064891848, 1},
                             {4.0900253014, 1},
                             {4.7133217905, 1},
                             {5.0646140186, 1},
                             {6.2471533662, 1},
                             {8.2883129522, 1},
                             {8.3120299460, 1}}};
  return result;
}
const Known& bolza() {
  static const Known result{
      "Bolza", Surface::regular(2), {{3.8388872588, 3}, {5.3536013412, 4}, {8.2495548152, 2}, {14.7262167878, 4}}};
  return result;
}
const Known& klein() {
  static const Known result{"Klein", named_surface("klein"), {{2.6779329066, 8}, {6.6225129946, 7}}};
  return result;
}
/// So many digits of these are known.
constexpr double kUnknown = 2e-10;

NetDocument net_of(const Surface& surface, const char* epsilon) {
  return compute_net(surface, Length(epsilon)).document;
}

double area(const Surface& surface) { return 4 * std::numbers::pi * (surface.genus() - 1.0); }

Surface with_cuff(const char* length) {
  FenchelNielsenRequest request;
  request.graph = "0-0 0-1 1-1";
  request.lengths = {"2", length, "2"};
  request.twists = {"0.3", "0", "0.7"};
  return fenchel_nielsen_surface(resolve(request));
}
Surface of_genus(std::uint32_t genus) {
  FenchelNielsenRequest request;
  request.genus = genus;
  request.seed = 1;
  return fenchel_nielsen_surface(resolve(request));
}
Surface cover_of(const Surface& base, std::uint32_t degree) { return cover(base, random_sheets(base, degree, 1)); }

// Elements.

using Entries = std::map<std::pair<std::uint32_t, std::uint32_t>, double>;

Entries entries_of(const Eigen::SparseMatrix<double>& lower_half) {
  Entries result;
  for (Eigen::Index column = 0; column < lower_half.cols(); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(lower_half, column); entry; ++entry) {
      EXPECT_GE(entry.row(), column);
      result[{static_cast<std::uint32_t>(entry.row()), static_cast<std::uint32_t>(column)}] = entry.value();
    }
  }
  return result;
}

/// Of all entries of the symmetric matrix, by row.
std::vector<double> sums_of_rows(const Eigen::SparseMatrix<double>& lower_half) {
  std::vector<double> result(static_cast<std::size_t>(lower_half.rows()));
  for (const auto& [place, value] : entries_of(lower_half)) {
    result[place.first] += value;
    if (place.first != place.second) result[place.second] += value;
  }
  return result;
}

double middle(const Ball& x) {
  const certify::Interval in = certify::outer_interval(x);
  return in.lower / 2 + in.upper / 2;
}

void add(Entries& entries, const std::array<std::uint32_t, 3>& numbers, const certify::SymmetricForm& form) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [j, k] = std::minmax(numbers[(i + 1) % 3], numbers[(i + 2) % 3]);
    entries[{numbers[i], numbers[i]}] += middle(form.square[i]);
    entries[{k, j}] += (j == k ? 2 : 1) * middle(form.product[i]);
  }
}

/// What `certify` computes for a net.
struct Checked {
  Checked(const NetDocument& net, std::uint32_t halvings) {
    const certify::Precision scope(128);
    const auto parts = certify::label_parts(certify::check_surface(net.surface).crossings, net.charts, {});
    std::vector<std::uint32_t> numbers(net.labels.size());
    std::iota(numbers.begin(), numbers.end(), 1U);
    const auto labels = certify::LabelEvaluator(net, parts).evaluate(numbers, 128, 512, 1);
    const certify::HalvedNet halved = certify::halved_net(net, halvings);
    std::size_t small = 0;
    for (std::uint32_t t = 0; t < net.triangles.size(); ++t) {
      for (const auto& squares : certify::flat_sides(net, labels, t, halvings)) {
        const auto flat = certify::FlatTriangle::of(squares);
        if (!flat) throw std::logic_error("no triangle");
        const auto& side = halved.sides[small];
        const auto& vertex = halved.vertices[small];
        add(lower_energy, {side[1], side[2], side[0]}, flat->least_energy());
        add(lower_mass, {side[1], side[2], side[0]}, flat->greatest_mass());
        add(upper_energy, vertex, flat->greatest_energy());
        add(upper_mass, vertex, flat->least_mass());
        interpolation = std::max(interpolation, middle(flat->interpolation_constant()));
        ++small;
      }
    }
  }
  Entries lower_energy;
  Entries lower_mass;
  Entries upper_energy;
  Entries upper_mass;
  double interpolation = 0;
};

/// Λ is a square root, of 0 for equilateral triangles, as those of Klein's quartic are before they are halved.
constexpr double kRoundingOfRoot = 1e-8;

void expect_near(const Eigen::SparseMatrix<double>& found, const Entries& expected, double rounding,
                 const std::string& what) {
  const Entries entries = entries_of(found);
  double greatest = 0;
  for (const auto& [place, value] : expected) greatest = std::max(greatest, std::abs(value));
  for (const auto& [place, value] : expected) {
    const auto at = entries.find(place);
    const double there = at == entries.end() ? 0 : at->second;
    EXPECT_NEAR(there, value, rounding * greatest) << what << ' ' << place.first << ' ' << place.second;
  }
  for (const auto& [place, value] : entries) {
    EXPECT_TRUE(expected.contains(place) || value == 0) << what << ' ' << place.first << ' ' << place.second;
  }
}

/// So the numbers of sides and vertices are those of docs/format.md as well.
TEST(Elements, HaveTheMatricesOfTheChecker) {
  for (const Known& known : {octagon(), klein()}) {
    for (const std::uint32_t halvings : {0U, 1U, 2U}) {
      const NetDocument net = net_of(known.surface, "1");
      const Elements elements(NetGeometry(net), halvings);
      const Checked checked(net, halvings);
      const std::string what = known.name + std::string(", halvings: ") + std::to_string(halvings);
      const double rounding = known.name == klein().name ? kRoundingOfRoot : 1e-12;
      const ElementMatrices lower = elements.lower();
      expect_near(lower.energy, checked.lower_energy, rounding, what + ", energy by sides");
      expect_near(lower.mass, checked.lower_mass, 1e-12, what + ", mass by sides");
      const ElementMatrices upper = elements.upper();
      expect_near(upper.energy, checked.upper_energy, rounding, what + ", energy by vertices");
      expect_near(upper.mass, checked.upper_mass, 1e-12, what + ", mass by vertices");
      EXPECT_NEAR(elements.interpolation() / checked.interpolation, 1, 1e-12) << what;
    }
  }
}

/// One vertex, and sides with both ends there: triangles in which vertices, and sides, occur twice.
TEST(Elements, OfANetOfOneVertexAreThoseOfTheChecker) {
  const NetDocument net = net_of(octagon().surface, "3");
  ASSERT_EQ(net.vertices.size(), 1U);
  for (const std::uint32_t halvings : {0U, 1U}) {
    const Elements elements(NetGeometry(net), halvings);
    const Checked checked(net, halvings);
    expect_near(elements.lower().energy, checked.lower_energy, 1e-12, "sides");
    expect_near(elements.upper().mass, checked.upper_mass, 1e-12, "vertices");
  }
}

TEST(Elements, AreAsManyAsTheCheckerHas) {
  for (const Known& known : {octagon(), bolza(), klein()}) {
    const NetDocument net = net_of(known.surface, "0.8");
    const NetGeometry geometry(net);
    for (const std::uint32_t halvings : {0U, 1U, 3U}) {
      const Elements elements(geometry, halvings);
      const certify::HalvedSizes sizes = certify::halved_sizes(net, halvings);
      EXPECT_EQ(elements.sides(), sizes.sides);
      EXPECT_EQ(elements.vertices(), sizes.vertices);
      // V − E + F, with 3F = 2E.
      const int characteristic = static_cast<int>(elements.vertices()) - static_cast<int>(elements.sides() / 3);
      EXPECT_EQ(characteristic, 2 - 2 * static_cast<int>(known.surface.genus())) << known.name << ' ' << halvings;
      EXPECT_EQ(elements.lower().energy.rows(), elements.sides());
      EXPECT_EQ(elements.upper().energy.rows(), elements.vertices());
    }
  }
}

TEST(Elements, ConstantsHaveNoEnergyAndAboutTheAreaForMass) {
  for (const Known& known : {octagon(), bolza(), klein()}) {
    const NetDocument net = net_of(known.surface, "0.4");
    const NetGeometry geometry(net);
    double error = 0;
    for (const std::uint32_t halvings : {0U, 1U, 2U}) {
      const Elements elements(geometry, halvings);
      for (const ElementMatrices& matrices : {elements.lower(), elements.upper()}) {
        for (const double sum : sums_of_rows(matrices.energy)) EXPECT_NEAR(sum, 0, 1e-11);
      }
      const auto mass = [](const ElementMatrices& matrices) {
        const std::vector<double> sums = sums_of_rows(matrices.mass);
        return std::accumulate(sums.begin(), sums.end(), 0.0);
      };
      const double greatest = mass(elements.lower()) / area(known.surface);
      const double least = mass(elements.upper()) / area(known.surface);
      EXPECT_GT(greatest, 1) << known.name;
      EXPECT_LT(least, 1) << known.name;
      // Both differ by the convexity of the density in s², of order r⁴: divided by 16 with each halving.
      EXPECT_LT(greatest - least, 0.3 * std::pow(0.4, 4)) << known.name;
      if (halvings > 0) {
        EXPECT_NEAR(error / (greatest - least), 16, 2) << known.name;
      }
      error = greatest - least;
    }
  }
}

DiscreteSpectrum spectrum_of(const ElementMatrices& matrices, std::uint32_t count) {
  return first_eigenvalues(matrices, elimination_order(matrices.energy), count);
}

std::uint32_t count_below(const ElementMatrices& matrices, double sigma, unsigned threads) {
  return inertia(matrices, elimination_order(matrices.energy), sigma, certify::Bound::upper, threads).negative;
}

struct Bounds {
  std::vector<double> least;
  std::vector<double> greatest;
};
/// By index from λ₁ on.
Bounds bounds_of(const Elements& elements, std::uint32_t count) {
  Bounds result;
  const double constant = elements.interpolation();
  for (const double mu : spectrum_of(elements.lower(), count + 1).values)
    result.least.push_back(mu / (1 + constant * mu));
  result.greatest = spectrum_of(elements.upper(), count + 1).values;
  for (std::vector<double>* values : {&result.least, &result.greatest}) {
    EXPECT_NEAR(values->front(), 0, 1e-6);
    values->erase(values->begin());
  }
  return result;
}

TEST(Elements, EncloseKnownEigenvaluesAndConverge) {
  for (const Known& known : {octagon(), bolza(), klein()}) {
    const std::vector<double> expected = known.all();
    const auto count = static_cast<std::uint32_t>(expected.size());
    const NetDocument net = net_of(known.surface, "0.4");
    const NetGeometry geometry(net);
    Bounds before;
    for (const std::uint32_t halvings : {0U, 1U, 2U}) {
      const Bounds bounds = bounds_of(Elements(geometry, halvings), count);
      ASSERT_EQ(bounds.least.size(), expected.size());
      ASSERT_EQ(bounds.greatest.size(), expected.size());
      for (std::size_t k = 0; k < expected.size(); ++k) {
        EXPECT_LE(bounds.least[k], expected[k] + kUnknown) << known.name << ' ' << k;
        EXPECT_GE(bounds.greatest[k], expected[k] - kUnknown) << known.name << ' ' << k;
        if (halvings > 0) {
          // The errors are of the order of the square of the triangles' size.
          const double below = (expected[k] - before.least[k]) / (expected[k] - bounds.least[k]);
          const double above = (before.greatest[k] - expected[k]) / (bounds.greatest[k] - expected[k]);
          EXPECT_GT(below, 2.8) << known.name << ' ' << k;
          EXPECT_LT(below, 4.5) << known.name << ' ' << k;
          EXPECT_GT(above, 3.5) << known.name << ' ' << k;
          EXPECT_LT(above, 5) << known.name << ' ' << k;
        }
      }
      before = bounds;
    }
  }
}

// Sparse eigenproblems.

TEST(Discrete, OrdersOfEliminationArePermutations) {
  const NetDocument net = net_of(octagon().surface, "0.5");
  const NetGeometry geometry(net);
  for (const std::uint32_t halvings : {0U, 1U, 2U}) {
    const Elements elements(geometry, halvings);
    for (const auto& matrix : {elements.lower().energy, elements.upper().energy}) {
      std::vector<std::uint32_t> order = elimination_order(matrix);
      EXPECT_EQ(order, elimination_order(matrix));
      std::sort(order.begin(), order.end());
      std::vector<std::uint32_t> all(static_cast<std::size_t>(matrix.rows()));
      std::iota(all.begin(), all.end(), 0U);
      EXPECT_EQ(order, all);
    }
  }
}

TEST(Discrete, AreCountedAsTheyAreFound) {
  for (const Known& known : {octagon(), bolza(), klein()}) {
    const NetDocument net = net_of(known.surface, "0.4");
    const Elements elements(NetGeometry(net), 1);
    for (const ElementMatrices& matrices : {elements.lower(), elements.upper()}) {
      const DiscreteSpectrum spectrum = spectrum_of(matrices, 30);
      ASSERT_EQ(spectrum.values.size(), 30U);
      EXPECT_TRUE(std::is_sorted(spectrum.values.begin(), spectrum.values.end()));
      EXPECT_EQ(spectrum.vectors.rows(), matrices.energy.rows());
      EXPECT_EQ(spectrum.vectors.cols(), 30);
      for (std::uint32_t k = 1; k < 30; ++k) {
        const double middle = (spectrum.values[k - 1] + spectrum.values[k]) / 2;
        // Equal ones are not told apart.
        if (spectrum.values[k] - spectrum.values[k - 1] < 1e-5) continue;
        EXPECT_EQ(count_below(matrices, middle, 1), k) << known.name << ' ' << middle;
      }
      EXPECT_EQ(count_below(matrices, -0.1, 1), 0U);
    }
  }
}

/// The last one that is asked for is one of several that are equal, or nearly.
TEST(Discrete, AnyNumberOfThemIsFound) {
  for (const Known& known : {bolza(), klein()}) {
    const NetDocument net = net_of(known.surface, "0.6");
    const Elements elements(NetGeometry(net), 1);
    for (const ElementMatrices& matrices : {elements.lower(), elements.upper()}) {
      const DiscreteSpectrum all = spectrum_of(matrices, 24);
      for (std::uint32_t count = 1; count < 24; ++count) {
        const DiscreteSpectrum some = spectrum_of(matrices, count);
        ASSERT_EQ(some.values.size(), count) << known.name;
        for (std::uint32_t k = 0; k < count; ++k) EXPECT_NEAR(some.values[k], all.values[k], 1e-6) << known.name;
      }
    }
  }
}

TEST(Discrete, TheNumberOfThreadsDoesNotMatter) {
  const NetDocument net = net_of(octagon().surface, "0.3");
  const ElementMatrices matrices = Elements(NetGeometry(net), 1).lower();
  for (const double sigma : {0.5, 3.0, 10.0, 100.0})
    EXPECT_EQ(count_below(matrices, sigma, 1), count_below(matrices, sigma, 3)) << sigma;
}

// The first eigenvalues.

bool is_verified(const EigenvaluesDocument& document) {
  const certify::Certificate certificate = certify::check(document, {.threads = 2, .max_work = 100'000'000'000});
  EXPECT_EQ(certificate.verdict, certify::Verdict::verified) << certify::verdict_line(certificate);
  return certificate.verdict == certify::Verdict::verified;
}

std::uint32_t count_of(const EigenvaluesDocument& document) {
  std::uint32_t result = 0;
  for (const auto& row : document.eigenvalues) result += row.count;
  return result;
}

/// Verified, and with what is known inside, to so many digits.
void expect_true(const EigenvaluesDocument& document, const Known& known, double width) {
  EXPECT_TRUE(is_verified(document)) << known.name;
  const std::vector<double> expected = known.all();
  std::size_t first = 0;
  for (const auto& [in, count] : document.eigenvalues) {
    for (std::size_t k = first; k < std::min(first + count, expected.size()); ++k) {
      EXPECT_LE(in.lower, expected[k] + kUnknown) << known.name << ' ' << k;
      EXPECT_GE(in.upper, expected[k] - kUnknown) << known.name << ' ' << k;
      EXPECT_LT(in.upper - in.lower, width * expected[k]) << known.name << ' ' << k;
    }
    first += count;
  }
  for (std::size_t k = 0; k < expected.size(); ++k) {
    if (k >= first) {
      EXPECT_LE(document.next, expected[k] + kUnknown) << known.name << ' ' << k;
    }
  }
}

TEST(Eigenvalues, OfSeveralDigitsAreVerified) {
  for (const int digits : {1, 2, 3}) {
    const EigenvaluesDocument document = unproved::eigenvalues(octagon().surface, {.count = 2, .digits = digits});
    EXPECT_EQ(count_of(document), 2U);
    EXPECT_EQ(document.eigenfunctions.empty(), digits < 3);
    expect_true(document, octagon(), std::pow(10.0, -digits));
  }
}

TEST(SlowEigenvalues, OfNineDigitsAreVerified) {
  const EigenvaluesDocument octagons = unproved::eigenvalues(octagon().surface, {.count = 8});
  EXPECT_EQ(octagons.eigenfunctions.size(), 8U);
  expect_true(octagons, octagon(), 1e-8);
  const EigenvaluesDocument bolzas = unproved::eigenvalues(bolza().surface, {.count = 9});
  ASSERT_EQ(bolzas.eigenvalues.size(), 3U);
  EXPECT_EQ(bolzas.eigenfunctions.size(), 3U);
  expect_true(bolzas, bolza(), 1e-7);
}

TEST(SlowEigenvalues, OfAllNumbersOfDigitsAreVerified) {
  for (const int digits : {4, 5, 6, 7, 8, 10}) {
    // Rounding leaves eight.
    expect_true(unproved::eigenvalues(octagon().surface, {.count = 1, .digits = digits}), octagon(),
                std::pow(10.0, 1 - std::min(digits, 8)));
  }
}

/// Those that are equal are in one row, and all of these when the first one is asked for.
TEST(SlowEigenvalues, OfAMultiplicityAreInARow) {
  for (const Known& known : {bolza(), klein()}) {
    for (const std::uint32_t count : {1U, known.eigenvalues[0].second, known.eigenvalues[0].second + 1}) {
      const EigenvaluesDocument document = unproved::eigenvalues(known.surface, {.count = count, .digits = 2});
      expect_true(document, known, 0.011);
      const std::size_t rows = count <= known.eigenvalues[0].second ? 1 : 2;
      ASSERT_EQ(document.eigenvalues.size(), rows) << known.name << ' ' << count;
      for (std::size_t row = 0; row < rows; ++row)
        EXPECT_EQ(document.eigenvalues[row].count, known.eigenvalues[row].second) << known.name;
    }
  }
}

TEST(Eigenvalues, BelowANumberAreCounted) {
  const std::vector<double> expected = octagon().all();
  const double between = (expected[0] + expected[1]) / 2;
  for (const double below : {0.25, between, 5.0}) {
    const EigenvaluesDocument document = unproved::eigenvalues(octagon().surface, {.below = below});
    EXPECT_TRUE(is_verified(document)) << below;
    const auto count =
        static_cast<std::uint32_t>(std::lower_bound(expected.begin(), expected.end(), below) - expected.begin());
    EXPECT_EQ(count_of(document), count) << below;
    EXPECT_GE(document.next, below);
    EXPECT_TRUE(document.eigenfunctions.empty());
    const EigenvalueCount read = eigenvalues_below(document, below);
    EXPECT_EQ(read.least, count) << below;
    EXPECT_EQ(read.most, count) << below;
  }
}

TEST(SlowEigenvalues, BelowANumberAreEnclosedIfDigitsAreAskedFor) {
  for (const int digits : {1, 2, 3}) {
    for (const double below : {0.25, 3.9}) {
      const EigenvaluesDocument document = unproved::eigenvalues(octagon().surface, {.below = below, .digits = digits});
      const std::uint32_t count = below < 1 ? 0 : 2;
      EXPECT_EQ(eigenvalues_below(document, below).least, count);
      EXPECT_EQ(eigenvalues_below(document, below).most, count);
      EXPECT_GE(count_of(document), count);
      expect_true(document, octagon(), std::pow(10.0, -digits));
    }
  }
}

/// Those of the base are among those of a cover.
TEST(Eigenvalues, OfCoversAreVerified) {
  const Surface three = cover_of(octagon().surface, 3);
  EXPECT_TRUE(is_verified(unproved::eigenvalues(three, {.count = 3, .digits = 1})));
  const Surface many = cover_of(octagon().surface, 9);
  const EigenvaluesDocument document = unproved::eigenvalues(many, {.below = 0.25});
  EXPECT_EQ(many.genus(), 10U);
  EXPECT_TRUE(is_verified(document));
  EXPECT_EQ(count_of(document), 1U) << "λ_1 is in [0.2406096930, 0.2406096946]";
}

TEST(SlowEigenvalues, OfACoverAreAmongThemToNineDigits) {
  const EigenvaluesDocument document = unproved::eigenvalues(cover_of(octagon().surface, 2), {.count = 3});
  EXPECT_TRUE(is_verified(document));
  // From closed geodesics.
  const std::vector<double> expected{0.9214217442, 2.0345041551, 2.7750679832};
  ASSERT_EQ(document.eigenvalues.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LE(document.eigenvalues[i].in.lower, expected[i] + 1e-9);
    EXPECT_GE(document.eigenvalues[i].in.upper, expected[i] - 1e-9);
    EXPECT_LT(document.eigenvalues[i].in.upper - document.eigenvalues[i].in.lower, 3e-8);
  }
}

TEST(Eigenvalues, OfFenchelNielsenSurfacesAreVerified) {
  // From closed geodesics.
  const Known three{"genus 3", of_genus(3), {{0.2343192302, 1}, {0.9907381674, 1}, {1.2072329512, 1}}};
  expect_true(unproved::eigenvalues(three.surface, {.count = 3, .digits = 1}), three, 0.1);
  const Known four{"genus 4", of_genus(4), {{0.0845512837, 1}, {0.6721740812, 1}}};
  expect_true(unproved::eigenvalues(four.surface, {.below = 0.25}), four, 10);
  expect_true(unproved::eigenvalues(four.surface, {.count = 1, .digits = 1}), four, 0.1);
}

/// λ_1 is about ℓ/π².
TEST(Eigenvalues, NearZeroAreCounted) {
  const EigenvaluesDocument document = unproved::eigenvalues(with_cuff("0.001"), {.below = 0.25});
  EXPECT_TRUE(is_verified(document));
  EXPECT_EQ(count_of(document), 1U);
}

TEST(Eigenvalues, NearZeroAreEnclosed) {
  const EigenvaluesDocument document = unproved::eigenvalues(with_cuff("0.1"), {.count = 1, .digits = 2});
  EXPECT_TRUE(is_verified(document));
  ASSERT_EQ(document.eigenvalues.size(), 1U);
  EXPECT_GT(document.eigenvalues[0].in.lower, 0.1 / (std::numbers::pi * std::numbers::pi));
  EXPECT_LT(document.eigenvalues[0].in.upper, 0.115 / (std::numbers::pi * std::numbers::pi));
}

TEST(Eigenvalues, AreTheSameForAnyNumberOfThreadsAndEachTime) {
  for (const EigenvaluesOptions& options :
       {EigenvaluesOptions{.count = 2, .digits = 2}, EigenvaluesOptions{.count = 1, .digits = 3},
        EigenvaluesOptions{.below = 5}}) {
    EigenvaluesOptions one = options;
    one.threads = 1;
    EigenvaluesOptions two = options;
    two.threads = 2;
    const EigenvaluesDocument document = unproved::eigenvalues(octagon().surface, one);
    EXPECT_EQ(document, unproved::eigenvalues(octagon().surface, two));
    EXPECT_EQ(document, unproved::eigenvalues(octagon().surface, one));
  }
}

TEST(Eigenvalues, AreCountedOnTheNetThatIsAskedFor) {
  const EigenvaluesDocument document =
      unproved::eigenvalues(octagon().surface, {.count = 1, .digits = 2, .epsilon = Length("0.45")});
  EXPECT_EQ(document.net.epsilon, "0.45");
  expect_true(document, octagon(), 0.01);
}

/// Nets are made as fine as the digits need: halving alone would make up to four times as many triangles.
TEST(Eigenvalues, AreNotMuchNarrowerThanIsAskedFor) {
  for (const int digits : {1, 2}) {
    for (const Surface& surface : {octagon().surface, of_genus(3), cover_of(octagon().surface, 9)}) {
      const EigenvaluesDocument document = unproved::eigenvalues(surface, {.count = 1, .digits = digits});
      ASSERT_EQ(document.eigenvalues.size(), 1U);
      const certify::Interval in = document.eigenvalues[0].in;
      const double width = (in.upper - in.lower) / in.lower;
      EXPECT_LT(width, 1.1 * std::pow(10.0, -digits)) << surface.genus();
      if (digits == 2) {
        EXPECT_GT(width, 0.5 * std::pow(10.0, -digits)) << surface.genus();
      }
    }
  }
}

/// Where the intervals of functions of different eigenvalues are not disjoint, matrices enclose these together.
TEST(Eigenvalues, FunctionsThatAreNotToldApartAreLeftOut) {
  const EigenvaluesDocument document =
      unproved::eigenvalues(random_octagon(3), {.count = 4, .digits = 6, .epsilon = Length("1")});
  EXPECT_EQ(certify::check(document).verdict, certify::Verdict::verified);
  EXPECT_EQ(count_of(document), 4U);
  EXPECT_EQ(document.eigenfunctions.size(), 2U);
}

/// One vertex; triangles that are halved until they are small enough.
TEST(SlowEigenvalues, OfLargeTrianglesAreVerified) {
  for (const char* epsilon : {"1.5", "3"}) {
    const EigenvaluesDocument document =
        unproved::eigenvalues(octagon().surface, {.count = 1, .digits = 2, .epsilon = Length(epsilon)});
    EXPECT_GE(document.halvings, 3U);
    expect_true(document, octagon(), 0.01);
  }
}

/// Functions around the vertices count within less than 2, by the format.
TEST(Eigenvalues, NetsTooCoarseForFunctionsAreErrors) {
  EXPECT_THAT([] { (void)unproved::eigenvalues(octagon().surface, {.count = 1, .epsilon = Length("1.2")}); },
              ThrowsMessage<NetError>(HasSubstr("epsilon is more than 1, which is too much for more than 2 digits")));
}

/// The midpoints of the sides of a large triangle may have no circumscribed circle.
TEST(Eigenvalues, NetsWithTrianglesWithoutFlatQuartersAreErrors) {
  const Surface surface = Surface::regular(5);
  EigenvaluesOptions options{.count = 1, .digits = 2, .epsilon = Length("30")};
  const auto message = ThrowsMessage<NetError>(
      HasSubstr("epsilon is too large: triangles of its net have quarters without a circumscribed circle"));
  EXPECT_THAT([&] { (void)eigenvalues(surface, options); }, message);
  options.phases = std::vector<Rational>(10, Rational(1, 3));
  EXPECT_THAT([&] { (void)eigenvalues(surface, options); }, message);
}

TEST(Eigenvalues, NearZeroAreNotSoughtInVain) {
  for (const char* length : {"0.00001", "0.00000001"}) {
    EXPECT_THAT([&] { (void)unproved::eigenvalues(with_cuff(length), {.below = 0.25}); },
                ThrowsMessage<NetError>(HasSubstr("around a closed geodesic that is")));
    EXPECT_THAT([&] { (void)unproved::eigenvalues(with_cuff(length), {.count = 1, .digits = 1}); },
                ThrowsMessage<NetError>(HasSubstr("around a closed geodesic that is")));
  }
}

/// Of numbers that are far below what is set aside for rounding in most matrices.
TEST(Eigenvalues, VeryNearZeroAreEnclosed) {
  for (const auto& [text, length, width] : {std::tuple{"0.001", 0.001, 0.01}, std::tuple{"0.0001", 0.0001, 0.05}}) {
    const EigenvaluesDocument document = unproved::eigenvalues(with_cuff(text), {.count = 1, .digits = 2});
    EXPECT_TRUE(is_verified(document));
    ASSERT_EQ(document.eigenvalues.size(), 1U);
    const Interval in = document.eigenvalues[0].in;
    EXPECT_LT(in.upper - in.lower, width * in.upper) << text;
    // λ_1 is about ℓ/π², and in fact a little more.
    EXPECT_GT(in.upper, length / (std::numbers::pi * std::numbers::pi)) << text;
    EXPECT_LT(in.lower, 1.01 * length / (std::numbers::pi * std::numbers::pi)) << text;
  }
}

/// Around so short a geodesic they are: then those of two digits are found.
TEST(DeepEigenvalues, FunctionsThatAreTooMuchWorkForTheCheckerAreLeftOut) {
  const Surface surface = with_cuff("0.001");
  EXPECT_FALSE(unproved::eigenvalues(surface, {.count = 1}).eigenfunctions.empty());
  const EigenvaluesDocument found = eigenvalues(surface, {.count = 1}).document;
  EXPECT_TRUE(found.eigenfunctions.empty());
  EXPECT_EQ(found, unproved::eigenvalues(surface, {.count = 1, .digits = 2}));
}

/// The regular map of type {3, 8} and genus 10 of which the rotations are AGL(2, 3), as permutations of the nine points
/// of a plane: its first eigenvalue has the greatest multiplicity that is known here.
TEST(Eigenvalues, OneOfSixteenIsFoundWithAllOthers) {
  const DartMap map = map_of_group({1, 3, 8, 0, 5, 7, 2, 4, 6}, {0, 1, 2, 6, 7, 8, 3, 4, 5});
  EXPECT_EQ(map.rotation.size(), 432U);
  const Surface surface = surface_of_map(map);
  EXPECT_EQ(surface.genus(), 10U);
  const EigenvaluesDocument document = unproved::eigenvalues(surface, {.count = 1, .digits = 1});
  EXPECT_TRUE(is_verified(document));
  ASSERT_EQ(document.eigenvalues.size(), 1U);
  EXPECT_EQ(document.eigenvalues[0].count, 16U);
}

/// Which one is the last of so many that are equal does not matter.
TEST(Eigenvalues, OneOfEightIsFoundWithAllOthers) {
  const EigenvaluesDocument document = unproved::eigenvalues(klein().surface, {.count = 1, .digits = 1});
  ASSERT_EQ(document.eigenvalues.size(), 1U);
  EXPECT_EQ(document.eigenvalues[0].count, 8U);
  expect_true(document, klein(), 0.11);
}

TEST(Eigenvalues, OptionsOutOfRangeAreRefused) {
  const auto refused = [](EigenvaluesOptions options, const char* text) {
    EXPECT_THAT([&] { (void)unproved::eigenvalues(octagon().surface, options); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(text)));
  };
  refused({.count = 0}, "count is not from 1 to 1000");
  refused({.count = 1001}, "count is not from 1 to 1000");
  for (const double below : {0.0, -1.0, 10000.5, HUGE_VAL, std::nan("")})
    refused({.below = below}, "below is not a positive number of at most 10000");
  refused({.digits = 0}, "digits is not from 1 to 10");
  refused({.digits = 11}, "digits is not from 1 to 10");
  refused({.digits = -3}, "digits is not from 1 to 10");
}

TEST(Eigenvalues, ImpossibleNetsAreErrors) {
  EXPECT_THROW((void)unproved::eigenvalues(octagon().surface, {.epsilon = Length("1e-9")}), Error);
}

struct Cancelled {};

/// What the progress says, up to the step of this name, where it ends the computation.
std::vector<std::pair<std::string, double>> reports_of(EigenvaluesOptions options, const std::string& until) {
  std::vector<std::pair<std::string, double>> result;
  options.progress = [&](std::string_view what, double share) {
    result.emplace_back(what, share);
    if (what == until) throw Cancelled();
  };
  if (until.empty()) {
    (void)unproved::eigenvalues(octagon().surface, options);
  } else {
    EXPECT_THROW((void)unproved::eigenvalues(octagon().surface, options), Cancelled) << until;
  }
  return result;
}

TEST(Eigenvalues, ProgressIsReportedAndNeverGoesBack) {
  for (const int digits : {2, 3}) {
    std::map<std::string, double> last;
    for (const auto& [what, share] : reports_of({.count = 2, .digits = digits}, "")) {
      EXPECT_GE(share, 0) << what;
      EXPECT_LE(share, 1) << what;
      const auto [at, is_new] = last.emplace(what, share);
      if (!is_new) {
        EXPECT_GE(share, at->second) << what;
      }
      at->second = share;
    }
    EXPECT_TRUE(last.contains("eigenvalues of matrices"));
    EXPECT_EQ(last.contains("eigenfunctions"), digits == 3);
  }
}

TEST(Eigenvalues, AreCancelledByAnException) {
  EXPECT_FALSE(reports_of({.count = 1, .digits = 2}, "eigenvalues of matrices").empty());
  EXPECT_FALSE(reports_of({.below = 1}, "eigenvalues of matrices").empty());
  EXPECT_FALSE(reports_of({.count = 2, .digits = 3}, "eigenfunctions").empty());
}

}  // namespace
}  // namespace epsnet::eigenvalues_test
