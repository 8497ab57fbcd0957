#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <gtest/gtest.h>
#include <iterator>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "certify/exact/checker.h"
#include "certify/exact/interval.h"
#include "certify/file/file.h"

/// Local maxima of the systole, asked of both checkers.
namespace epsnet::exact::second_checkers_local_maximum_test {
namespace {

using certify::GeodesicsDocument;
using certify::Verdict;

GeodesicsDocument load(const std::string& name) {
  return certify::read_file<GeodesicsDocument>(std::string(EPSNET_TEST_DATA) + "/geodesics/" + name + ".json");
}

/// "VERDICT", or "VERDICT: rule", of both checkers, which agree.
std::string outcome(const GeodesicsDocument& document) {
  const certify::Certificate first = certify::check(document, {.threads = 2, .max_precision = 256});
  const std::string rule = first.rule.empty() ? "" : ": " + first.rule;
  std::ostringstream out;
  certify::write_file(document, out);
  const Result second = check(out.str());
  EXPECT_EQ(second.rule, first.rule) << first.message << "; " << second.message;
  constexpr std::array kNames{"VERIFIED", "REFUTED", "UNDECIDED", "MALFORMED"};
  EXPECT_EQ(kNames.at(static_cast<std::size_t>(second.verdict)), std::string(name(first.verdict)));
  return std::string(name(first.verdict)) + rule;
}

// Gradients of traces by difference quotients, in a space of matrices: no twists, no angles.

using Complex = std::complex<double>;

/// (a, b; b̄, ā).
struct Matrix {
  Complex a;
  Complex b;
};
Matrix operator*(const Matrix& f, const Matrix& g) {
  return {f.a * g.a + f.b * std::conj(g.b), f.a * g.b + f.b * std::conj(g.a)};
}

constexpr std::size_t kParameters = 12;
using Vector = std::array<double, kParameters>;

/// The crossings of the regular octagon with opposite sides glued, each of the first four changed a little: by three
/// numbers, so that the determinant is still 1.
std::array<Matrix, 8> crossings(const Vector& change) {
  std::array<Matrix, 8> result;
  for (std::size_t side = 0; side < 4; ++side) {
    const double cosh = 1 + std::sqrt(2.0);
    const Matrix crossing{cosh, -std::sqrt(cosh * cosh - 1) * std::polar(1.0, static_cast<double>(side) * M_PI / 4)};
    const Complex b(change[3 * side + 1], change[3 * side + 2]);
    const Matrix f = crossing * Matrix{std::polar(std::sqrt(1 + std::norm(b)), change[3 * side]), b};
    result[side] = f;
    result[side + 4] = {std::conj(f.a), -f.b};
  }
  return result;
}

Matrix value(const std::vector<std::uint32_t>& word, const Vector& change) {
  const std::array<Matrix, 8> crossing = crossings(change);
  Matrix result{1, 0};
  for (const std::uint32_t side : word) result = crossing[side] * result;
  return result;
}

/// The gradient of a function of the changes, at 0.
template <class Function>
Vector gradient(const Function& function) {
  constexpr double kStep = 1e-5;
  Vector result{};
  for (std::size_t i = 0; i < kParameters; ++i) {
    Vector change{};
    change[i] = kStep;
    result[i] = function(change);
    change[i] = -kStep;
    result[i] = (result[i] - function(change)) / (2 * kStep);
  }
  return result;
}

Vector gradient_of_trace(const std::vector<std::uint32_t>& word) {
  return gradient([&](const Vector& change) { return std::abs(value(word, change).a.real()); });
}

/// Of what must be 0: the product of the crossings around the one vertex is ±1.
std::vector<Vector> gradients_of_relation() {
  const std::vector<std::uint32_t> around{0, 5, 2, 7, 4, 1, 6, 3};
  EXPECT_NEAR(std::abs(value(around, {}).a.real()), 1, 1e-9);
  return {gradient([&](const Vector& change) { return value(around, change).a.imag(); }),
          gradient([&](const Vector& change) { return value(around, change).b.real(); }),
          gradient([&](const Vector& change) { return value(around, change).b.imag(); })};
}

double product(const Vector& x, const Vector& y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
  return sum;
}

/// The combination of vectors that is nearest to `goal`, and its distance from it; no coefficients if they are
/// dependent.
std::pair<std::vector<double>, double> nearest_combination(const std::vector<Vector>& vectors, const Vector& goal) {
  const std::size_t n = vectors.size();
  std::vector<std::vector<double>> rows(n, std::vector<double>(n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) rows[i][j] = product(vectors[i], vectors[j]);
    rows[i][n] = product(vectors[i], goal);
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (rows[k][k] < 1e-5) return {{}, 0};  // Of a positive semidefinite matrix.
    for (std::size_t i = 0; i < n; ++i) {
      const double factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; i != k && j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  std::pair<std::vector<double>, double> result;
  Vector rest = goal;
  for (std::size_t k = 0; k < n; ++k) {
    result.first.push_back(rows[k][n] / rows[k][k]);
    for (std::size_t i = 0; i < kParameters; ++i) rest[i] -= result.first[k] * vectors[k][i];
  }
  result.second = std::sqrt(product(rest, rest));
  return result;
}

TEST(LocalMaximum, WeightsAndBasesAreThoseOfGradientsByDifferenceQuotients) {
  // Of any basis and any weights: whether others are positive with which a sum of gradients is one of the relation's.
  const GeodesicsDocument good = load("bolza-maximum");
  const std::vector<Vector> relation = gradients_of_relation();
  std::vector<Vector> gradients;
  for (const auto& row : good.geodesics) gradients.push_back(gradient_of_trace(row.word));
  std::mt19937 random(1);  // NOLINT(cert-msc51-cpp): the same each time.
  std::array<int, 3> count{};
  for (int i = 0; i < 60; ++i) {
    GeodesicsDocument document = good;
    document.basis.clear();
    document.weights.clear();
    std::vector<Vector> vectors = relation;
    Vector goal{};
    for (std::uint32_t j = 0; j < 12; ++j) {
      // As many as are still needed, of those that are left.
      if (random() % (12 - j) < 6 - document.basis.size()) {
        document.basis.push_back(j);
        vectors.push_back(gradients[j]);
      } else {
        document.weights.push_back(i % 3 == 0 ? 1 : static_cast<std::uint32_t>(1 + random() % 9));
        for (std::size_t k = 0; k < kParameters; ++k) goal[k] -= document.weights.back() * gradients[j][k];
      }
    }
    const auto [weights, distance] = nearest_combination(vectors, goal);
    if (weights.empty()) {
      ++count[0];
      EXPECT_EQ(outcome(document), "UNDECIDED: maximal");
      continue;
    }
    EXPECT_NEAR(distance, 0, 1e-6);  // So 12 - 3 dimensions are all that there are.
    double least = weights[3];
    for (std::size_t k = 3; k < weights.size(); ++k) least = std::min(least, weights[k]);
    if (std::abs(least) < 1e-6) continue;  // A weight of 0: no checker decides that.
    ++count[least > 0 ? 1 : 2];
    EXPECT_EQ(outcome(document), least > 0 ? "VERIFIED" : "REFUTED: maximal") << least;
  }
  for (const int n : count) EXPECT_GT(n, 5);
}

TEST(LocalMaximum, AWeightOf0IsNotPositive) {
  // With a weight of 0 by symmetry or by chance: never verified.
  const GeodesicsDocument good = load("bolza-maximum");
  ASSERT_EQ(outcome(good), "VERIFIED");
  std::vector<Vector> vectors = gradients_of_relation();
  for (const std::uint32_t j : good.basis) vectors.push_back(gradient_of_trace(good.geodesics[j].word));
  int found = 0;
  for (std::uint32_t code = 0; code < 729 && found < 3; ++code) {
    GeodesicsDocument document = good;
    std::uint32_t rest = code;
    Vector goal{};
    std::size_t other = 0;
    for (std::uint32_t j = 0; j < 12; ++j) {
      if (std::find(good.basis.begin(), good.basis.end(), j) != good.basis.end()) continue;
      document.weights[other] = 1 + rest % 3;
      rest /= 3;
      const Vector gradient = gradient_of_trace(good.geodesics[j].word);
      for (std::size_t k = 0; k < kParameters; ++k) goal[k] -= document.weights[other] * gradient[k];
      ++other;
    }
    const std::vector<double> weights = nearest_combination(vectors, goal).first;
    double least = weights[3];
    for (std::size_t k = 3; k < weights.size(); ++k) least = std::min(least, weights[k]);
    if (std::abs(least) > 1e-6) continue;
    ++found;
    EXPECT_EQ(outcome(document), "UNDECIDED: maximal") << code;
  }
  EXPECT_EQ(found, 3);
}

TEST(LocalMaximum, KleinsQuarticIsOneInTwelveDimensions) {
  GeodesicsDocument document = load("klein-maximum");
  ASSERT_EQ(document.basis.size(), 12);
  EXPECT_EQ(outcome(document), "VERIFIED");
  document.weights[4] = 1000;
  EXPECT_EQ(outcome(document), "REFUTED: maximal");
}

/// Geodesics of a list that is longer are not asked about.
TEST(LocalMaximum, LongerGeodesicsMayFollow) {
  GeodesicsDocument document = load("bolza-maximum");
  const GeodesicsDocument longer = load("bolza-to-6.2");
  ASSERT_EQ(longer.clusters[0].count, 12);
  document.net = longer.net;
  document.geodesics.assign(longer.geodesics.begin(), longer.geodesics.begin() + longer.clusters[2].first);
  document.clusters.assign(longer.clusters.begin(), longer.clusters.begin() + 2);
  document.up_to = "4.9";
  // Which are a basis depends on their order.
  int verified = 0;
  for (std::uint32_t i = 0; i < 6; ++i) {
    for (std::uint32_t k = 0; k < 6; ++k) document.basis[k] = i == 0 ? k : k < i ? k : 6 + k;
    const std::string answer = outcome(document);
    verified += answer == "VERIFIED" ? 1 : 0;
    EXPECT_TRUE(answer == "VERIFIED" || answer == "UNDECIDED: maximal") << answer;
  }
  EXPECT_GT(verified, 0);
}

/// Whatever the weights, nothing is said of what a list of other geodesics would prove.
TEST(LocalMaximum, IsAskedAboutWhenTheShortestGeodesicsAreKnown) {
  const GeodesicsDocument good = load("bolza-maximum");
  for (std::uint32_t gone = 0; gone < 12; ++gone) {
    if (std::find(good.basis.begin(), good.basis.end(), gone) != good.basis.end()) continue;
    GeodesicsDocument document = good;
    document.geodesics.erase(document.geodesics.begin() + gone);
    document.clusters[0].count = 11;
    for (std::uint32_t& element : document.basis) element -= element > gone ? 1 : 0;
    document.weights.pop_back();
    const certify::Certificate certificate = certify::check(document, {.threads = 2, .max_precision = 128});
    EXPECT_EQ(certificate.rule, "complete");
    EXPECT_EQ(certificate.rules.back().rule, "maximal");
    EXPECT_EQ(certificate.rules.back().verdict, Verdict::undecided);
  }
}

TEST(LocalMaximum, ShortestGeodesicsAreOfExactlyEqualLengthAndAllThere) {
  const GeodesicsDocument good = load("bolza-maximum");
  GeodesicsDocument document = good;
  document.geodesics.pop_back();
  document.clusters[0].count = 11;
  document.basis = {0, 1, 2, 3, 4, 5};
  document.weights.pop_back();
  EXPECT_EQ(outcome(document), "REFUTED: complete");

  // Those of the next length as well, in enclosures that do not tell.
  const GeodesicsDocument longer = load("bolza-to-6.2");
  document = good;
  document.net = longer.net;
  document.geodesics.assign(longer.geodesics.begin(), longer.geodesics.begin() + 12 + longer.clusters[1].count);
  for (auto& row : document.geodesics) row.length = {3, 4.95};
  document.up_to = "4.9";
  document.clusters = {{0, static_cast<std::uint32_t>(document.geodesics.size()), true}};
  document.weights.assign(document.geodesics.size() - 6, 1);
  EXPECT_EQ(outcome(document), "REFUTED: equal");

  document = good;
  document.geodesics[11] = document.geodesics[10];
  EXPECT_EQ(outcome(document), "REFUTED: distinct");
  document = good;
  document.geodesics[3].simple = false;
  EXPECT_EQ(outcome(document), "REFUTED: simple");
  document = good;
  document.up_to = "3.05";
  EXPECT_EQ(outcome(document), "REFUTED: geodesics");
}

TEST(LocalMaximum, BasisAndWeightsAreThoseOfTheFormatForBothCheckers) {
  const GeodesicsDocument good = load("bolza-maximum");
  const auto expect_malformed = [&](const auto& change) {
    GeodesicsDocument document = good;
    change(document);
    EXPECT_EQ(certify::check(document, {.threads = 1}).verdict, Verdict::malformed);
    std::ostringstream out;
    certify::write_file(document, out);
    EXPECT_EQ(check(out.str()).verdict, exact::Verdict::malformed);
  };
  expect_malformed([](auto& document) { document.clusters[0].equal = false; });
  expect_malformed([](auto& document) { document.basis = {0, 1, 2, 3, 4}, document.weights.push_back(1); });
  expect_malformed([](auto& document) { document.basis = {0, 1, 2, 3, 4, 5, 6}, document.weights.pop_back(); });
  expect_malformed([](auto& document) { document.basis = {0, 1, 2, 3, 3, 5}; });
  expect_malformed([](auto& document) { document.basis = {0, 1, 2, 4, 3, 5}; });
  expect_malformed([](auto& document) { document.basis = {0, 1, 2, 3, 4, 12}; });
  expect_malformed([](auto& document) { document.weights.push_back(1); });
  expect_malformed([](auto& document) { document.weights.pop_back(); });
  expect_malformed([](auto& document) { document.weights[2] = 0; });
  expect_malformed([](auto& document) { document.up_to = "0"; });
  expect_malformed([](auto& document) { document.up_to = "-1"; });
}

TEST(LocalMaximum, TheBasisIsOfTheFirstCluster) {
  // Twelve systoles, and twelve longer geodesics, of which one is in the basis.
  GeodesicsDocument document = load("bolza-maximum");
  const GeodesicsDocument longer = load("bolza-to-6.2");
  document.net = longer.net;
  document.geodesics.assign(longer.geodesics.begin(), longer.geodesics.begin() + longer.clusters[2].first);
  document.clusters.assign(longer.clusters.begin(), longer.clusters.begin() + 2);
  document.up_to = "4.9";
  document.basis = {0, 1, 2, 3, 4, 12};
  EXPECT_EQ(certify::check(document, {.threads = 1}).verdict, Verdict::malformed);
  std::ostringstream out;
  certify::write_file(document, out);
  EXPECT_EQ(check(out.str()).verdict, exact::Verdict::malformed);
}

TEST(LinearEquations, HaveTheSolutionThatTheyAreMadeOf) {
  std::mt19937 random(2);  // NOLINT(cert-msc51-cpp): the same each time.
  const auto digit = [&] { return static_cast<long>(random() % 7) - 3; };
  int solved = 0;
  for (int i = 0; i < 200; ++i) {
    const std::size_t size = 1 + random() % 6;
    std::vector<std::vector<Interval>> matrix(size);
    std::vector<std::vector<mpq_class>> numbers(size);
    std::vector<long> x;
    for (std::size_t k = 0; k < size; ++k) x.push_back(digit());
    std::vector<Interval> right;
    for (std::size_t k = 0; k < size; ++k) {
      long sum = 0;
      for (std::size_t j = 0; j < size; ++j) {
        const long entry = digit();
        numbers[k].emplace_back(entry);
        matrix[k].emplace_back(entry);
        sum += entry * x[j];
      }
      right.emplace_back(sum);
    }
    // Whether it has an inverse, by elimination in rational numbers.
    bool is_regular = true;
    for (std::size_t k = 0; k < size && is_regular; ++k) {
      std::size_t pivot = k;
      while (pivot < size && numbers[pivot][k] == 0) ++pivot;
      is_regular = pivot < size;
      if (!is_regular) break;
      std::swap(numbers[k], numbers[pivot]);
      for (std::size_t j = k + 1; j < size; ++j) {
        const mpq_class factor = numbers[j][k] / numbers[k][k];
        for (std::size_t m = k; m < size; ++m) numbers[j][m] -= factor * numbers[k][m];
      }
    }
    const auto found = solution(matrix, right);
    ASSERT_EQ(found.has_value(), is_regular);
    if (!found) continue;
    ++solved;
    ASSERT_EQ(found->size(), size);
    for (std::size_t k = 0; k < size; ++k) {
      const Interval error = (*found)[k] - Interval(x[k]);
      EXPECT_LE(error.lower(), 0);
      EXPECT_GE(error.upper(), 0);
      EXPECT_LT(error.upper() - error.lower(), 1e-60);
    }
  }
  EXPECT_GT(solved, 100);
}

/// (a ± r)x + by = c ± s and dx + (e ± r)y = f: by Cramer's rule for all ends of the intervals.
TEST(LinearEquations, ContainTheSolutionsForAllNumbersInTheIntervals) {
  const mpq_class r(1, 10), s(1, 5);
  const auto around = [](const mpq_class& x, const mpq_class& radius) {
    return hull(Interval(mpq_class(x - radius)), Interval(mpq_class(x + radius)));
  };
  const mpq_class a = 3, b = 1, c = 7, d = -2, e = 2, f = 5;
  const auto found = solution({{around(a, r), Interval(b)}, {Interval(d), around(e, r)}}, {around(c, s), Interval(f)});
  ASSERT_TRUE(found);
  for (const int i : {-1, 1}) {
    for (const int j : {-1, 1}) {
      for (const int k : {-1, 1}) {
        const mpq_class p = a + i * r, q = e + j * r, right = c + k * s;
        const mpq_class determinant = p * q - b * d;
        const std::array<mpq_class, 2> x{(right * q - b * f) / determinant, (p * f - d * right) / determinant};
        for (std::size_t n = 0; n < 2; ++n) {
          EXPECT_LE((*found)[n].lower(), x[n].get_d() + 1e-12);
          EXPECT_GE((*found)[n].upper(), x[n].get_d() - 1e-12);
        }
      }
    }
  }
}

TEST(LinearEquations, OfWideIntervalsHaveNoSolution) {
  const Interval wide = hull(Interval(-1), Interval(1));
  EXPECT_FALSE(solution({{wide}}, {Interval(1)}));
  EXPECT_FALSE(solution({{Interval(2), Interval(1)}, {Interval(2), Interval(1) + wide}}, {Interval(1), Interval(1)}));
  const auto unbounded = solution({{Interval(1) / Interval(0)}}, {Interval(1)});
  EXPECT_FALSE(unbounded);
}

TEST(LinearEquations, WithTooManyUnknownsAreLeftOut) {
  const auto identity = [](std::size_t size) {
    std::vector<std::vector<Interval>> result(size, std::vector<Interval>(size, Interval(0)));
    for (std::size_t k = 0; k < size; ++k) result[k][k] = Interval(1);
    return result;
  };
  EXPECT_THROW((void)solution(identity(501), std::vector<Interval>(501)), LeftOut);
}

}  // namespace
}  // namespace epsnet::exact::second_checkers_local_maximum_test
