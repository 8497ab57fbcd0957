#include "netgen/eigenvalues/local_functions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "netgen/eigenvalues/elements.h"
#include "netgen/nets/certified_net.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/surfaces.h"

/// Approximate eigenfunctions as functions around the vertices of a net.
namespace epsnet::local_functions_test {
namespace {

using certify::EigenvaluesDocument;
using Rows = std::vector<EigenvaluesDocument::Eigenfunctions>;

/// A net, and what matrices say of its first eigenvalues, from λ₁ on.
class Start {
 public:
  Start(const Surface& surface, const char* epsilon, std::uint32_t count)
      : net_(compute_net(surface, Length(epsilon)).document), geometry_(net_) {
    const ElementMatrices matrices = Elements(geometry_, 2).upper();
    const DiscreteSpectrum spectrum = first_eigenvalues(matrices, elimination_order(matrices.energy), count + 1);
    values_.assign(spectrum.values.begin() + 1, spectrum.values.end());
    vectors_ = spectrum.vectors;
  }

  /// Functions of λ_k, first ≤ k < last from 0 on, beginning with what the matrices say, and with the functions of some
  /// eigenvalues behind them.
  [[nodiscard]] std::optional<Rows> found(std::size_t first, std::size_t last, int digits, unsigned threads = 2) const {
    return found(
        {values_.begin() + static_cast<std::ptrdiff_t>(first), values_.begin() + static_cast<std::ptrdiff_t>(last)},
        first, digits, threads);
  }
  /// Of these numbers, whatever the matrices say.
  [[nodiscard]] std::optional<Rows> found(const std::vector<double>& lambdas, std::size_t first, int digits,
                                          unsigned threads = 2) const {
    const LocalFunctions local(geometry_, lambdas.back(), digits, threads);
    const std::size_t all = std::min(first + lambdas.size() + 2, values_.size());
    const auto vertices = static_cast<Eigen::Index>(net_.vertices.size());
    Eigen::MatrixXd starts(vertices, static_cast<Eigen::Index>(all - first));
    for (Eigen::Index j = 0; j < starts.cols(); ++j) {
      for (Eigen::Index i = 0; i < vertices; ++i) starts(i, j) = vectors_(i, static_cast<Eigen::Index>(first) + 1 + j);
    }
    return local.near(lambdas, starts);
  }

  /// Whether the functions prove what the rows say.
  [[nodiscard]] bool proves(const Rows& rows) const {
    EigenvaluesDocument document;
    document.net = net_;
    document.eigenfunctions = rows;
    const certify::Certificate certificate = certify::check(document, {.threads = 2, .max_work = 1'000'000'000'000});
    EXPECT_EQ(certificate.verdict, certify::Verdict::verified) << certify::verdict_line(certificate);
    return certificate.verdict == certify::Verdict::verified;
  }

  [[nodiscard]] const certify::NetDocument& net() const { return net_; }

 private:
  certify::NetDocument net_;
  NetGeometry geometry_;
  std::vector<double> values_;
  Eigen::MatrixXd vectors_;
};

void expect_row(const EigenvaluesDocument::Eigenfunctions& row, double known, std::size_t count, double width) {
  EXPECT_EQ(row.functions.size(), count) << known;
  EXPECT_LE(row.in.lower, known + 2e-10);
  EXPECT_GE(row.in.upper, known - 2e-10);
  EXPECT_LE(row.in.lower, row.lambda);
  EXPECT_GE(row.in.upper, row.lambda);
  EXPECT_LT(row.in.upper - row.in.lower, width) << known;
}

TEST(LocalFunctions, OfASimpleEigenvalueAreFound) {
  const Start octagon(random_octagon(5), "0.5", 4);
  for (const auto& [k, known] : {std::pair{0U, 2.7750679832}, {1U, 3.7064891848}}) {
    const auto rows = octagon.found(k, k + 1, 6);
    ASSERT_TRUE(rows) << known;
    ASSERT_EQ(rows->size(), 1U);
    expect_row(rows->front(), known, 1, 1e-5);
    EXPECT_TRUE(octagon.proves(*rows));
  }
}

TEST(SlowLocalFunctions, OfMultipleEigenvaluesAreFound) {
  const Start bolza(Surface::regular(2), "0.5", 9);
  for (const auto& [first, count, known] : {std::tuple{0U, 3U, 3.8388872588}, {3U, 4U, 5.3536013412}}) {
    const auto rows = bolza.found(first, first + count, 9);
    ASSERT_TRUE(rows) << known;
    ASSERT_EQ(rows->size(), 1U) << known;
    expect_row(rows->front(), known, count, 3e-7);
    EXPECT_TRUE(bolza.proves(*rows)) << known;
  }
}

TEST(SlowLocalFunctions, OfAnEigenvalueOfMultiplicityEightAreFound) {
  const Start klein(named_surface("klein"), "0.6", 15);
  const auto rows = klein.found(0, 8, 9);
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows->size(), 1U);
  expect_row(rows->front(), 2.6779329066, 8, 3e-7);
  EXPECT_TRUE(klein.proves(*rows));
}

/// Two that are near each other, sought together, are told apart.
TEST(SlowLocalFunctions, OfClosePairsAreToldApart) {
  const Start octagon(random_octagon(5), "0.4", 10);
  const auto rows = octagon.found(6, 8, 9);
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows->size(), 2U);
  expect_row(rows->front(), 8.2883129522, 1, 1e-7);
  expect_row(rows->back(), 8.3120299460, 1, 1e-7);
  EXPECT_TRUE(octagon.proves(*rows));
}

/// Even those that are not so near, if they are said to be.
TEST(SlowLocalFunctions, OfOtherEigenvaluesAreToldApart) {
  const Start octagon(random_octagon(5), "0.4", 8);
  const auto rows = octagon.found(2, 4, 9);
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows->size(), 2U);
  expect_row(rows->front(), 4.0900253014, 1, 1e-7);
  expect_row(rows->back(), 4.7133217905, 1, 1e-7);
}

TEST(SlowLocalFunctions, AreMorePreciseWithMoreDigits) {
  const Start octagon(random_octagon(5), "0.5", 3);
  double last = 1;
  std::size_t coefficients = 0;
  for (const int digits : {3, 5, 7, 9}) {
    const auto rows = octagon.found(0, 1, digits);
    ASSERT_TRUE(rows) << digits;
    const double width = rows->front().in.upper - rows->front().in.lower;
    EXPECT_LT(width, last) << digits;
    EXPECT_LT(width, 2.8 * std::pow(10.0, 1 - digits)) << digits;
    EXPECT_GT(rows->front().functions.front().size(), coefficients) << digits;
    last = width;
    coefficients = rows->front().functions.front().size();
  }
}

/// A number of coefficients for each vertex, a radius of more than ε, and the same for any number of threads.
TEST(LocalFunctions, AreAsTheFormatSays) {
  const Start octagon(random_octagon(5), "0.5", 3);
  const auto rows = octagon.found(0, 1, 4, 1);
  ASSERT_TRUE(rows);
  EXPECT_EQ(rows, octagon.found(0, 1, 4, 3));
  const auto& row = rows->front();
  EXPECT_GT(row.radius, 0.5);
  EXPECT_LT(row.radius, 2);
  const std::size_t vertices = octagon.net().vertices.size();
  ASSERT_EQ(row.functions.front().size() % vertices, 0U);
  EXPECT_EQ(row.functions.front().size() / vertices % 2, 1U);
}

/// λ_1 is small if a separating curve is short: nearly constant functions, beside those that are.
TEST(SlowLocalFunctions, OfSmallEigenvaluesAreFound) {
  FenchelNielsenRequest request;
  request.graph = "0-0 0-1 1-1";
  request.lengths = {"2", "1/8", "2"};
  request.twists = {"0.3", "0", "0.7"};
  const Start pinched(fenchel_nielsen_surface(resolve(request)), "0.5", 4);
  const auto rows = pinched.found(0, 1, 9);
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows->size(), 1U);
  expect_row(rows->front(), 0.0138673615, 1, 1e-6);
  EXPECT_TRUE(pinched.proves(*rows));
}

/// Two are asked for where there is one.
TEST(SlowLocalFunctions, ThatAreNotThereAreNotFound) {
  const Start octagon(random_octagon(5), "0.5", 2);
  const auto rows = octagon.found({2.7751, 2.7752}, 0, 4);
  EXPECT_TRUE(!rows || octagon.proves(*rows));
}

}  // namespace
}  // namespace epsnet::local_functions_test
