#include <cmath>
#include <complex>
#include <cstdint>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "netgen/eigenvalues/eigenfunctions.h"
#include "netgen/nets/certified_net.h"
#include "netgen/pictures/pictures.h"
#include "netgen/surfaces/surfaces.h"

/// What is seen of an eigenvalues file: counts, pictures, eigenfunctions. The files are made here, so their claims mean
/// nothing.
namespace epsnet::eigenvalues_picture_test {
namespace {

using certify::EigenvaluesDocument;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;
using Point = std::complex<double>;

const certify::NetDocument& net() {
  static const certify::NetDocument result = compute_net(random_octagon(123), Length("0.5")).document;
  return result;
}

/// λ_1 in [1, 1.1], λ_2 to λ_4 in [2, 2.1], all others at least 3.
EigenvaluesDocument document() {
  EigenvaluesDocument result;
  result.net = net();
  result.eigenvalues = {{{1, 1.1}, 1}, {{2, 2.1}, 3}};
  result.next = 3;
  return result;
}

/// Functions around the vertices that have nothing to do with each other: those of two intervals for λ_2 to λ_4, and
/// none for λ_1. M = 3.
EigenvaluesDocument with_functions() {
  EigenvaluesDocument result = document();
  const auto function = [](double first) {
    EigenvaluesDocument::Coefficients coefficients;
    for (std::size_t k = 0; k < 7 * net().vertices.size(); ++k)
      coefficients.push_back(first + std::sin(static_cast<double>(k)));
    return coefficients;
  };
  result.eigenfunctions = {{{2, 2.03}, 2.01, 0.7, {function(0), function(1)}}, {{2.05, 2.1}, 2.08, 0.7, {function(2)}}};
  return result;
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t result = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++result;
  return result;
}

/// The text of a group of an SVG picture.
std::string group(const std::string& svg, const std::string& name) {
  const std::size_t begin = svg.find("<g class=\"" + name + '"');
  return begin == std::string::npos ? "" : svg.substr(begin, svg.find("</g>", begin) - begin);
}

// Counts.

TEST(EigenvaluesBelow, AreCountedByRows) {
  const EigenvaluesDocument file = document();
  const auto expect = [&](double x, std::uint32_t least, std::optional<std::uint32_t> most) {
    const EigenvalueCount count = eigenvalues_below(file, x);
    EXPECT_EQ(count.least, least) << x;
    EXPECT_EQ(count.most, most) << x;
  };
  expect(0.25, 0, 0);
  expect(1, 0, 0);  // At least 1, so none is less.
  expect(1.05, 0, 1);
  expect(1.1, 0, 1);  // It may be 1.1.
  expect(1.5, 1, 1);
  expect(2.05, 1, 4);
  expect(3, 4, 4);
  expect(3.01, 4, {});
}

TEST(EigenvaluesBelow, AreCountedByMatrices) {
  EigenvaluesDocument file = document();
  file.at_most = {{5, 9, 6}, {1.05, 0, 1.2}};
  file.at_least = {{4, 6}, {1.08, 1}};
  EXPECT_EQ(eigenvalues_below(file, 1.05).most, 0U);
  EXPECT_EQ(eigenvalues_below(file, 1.08).least, 1U);
  EXPECT_EQ(eigenvalues_below(file, 3.5).least, 4U);
  EXPECT_EQ(eigenvalues_below(file, 3.5).most, 9U);
  EXPECT_EQ(eigenvalues_below(file, 4).least, 6U);
  EXPECT_FALSE(eigenvalues_below(file, 5.1).most);
}

// The picture of the numbers.

TEST(EigenvaluesPicture, HasStepsWhereSomethingNewIsKnown) {
  EigenvaluesDocument file = document();
  file.at_most = {{3.5, 6, 4}, {1.5, 2, 1.8}};
  file.at_least = {{4, 6}, {5, 5}};
  const EigenvaluesPicture picture = picture_of(file);
  const auto pairs = [](const std::vector<EigenvaluesPicture::Step>& steps) {
    std::vector<std::pair<double, std::uint32_t>> result;
    for (const auto& [lambda, count] : steps) result.emplace_back(lambda, count);
    return result;
  };
  using Pairs = std::vector<std::pair<double, std::uint32_t>>;
  EXPECT_EQ(pairs(picture.least), (Pairs{{1.1, 1}, {2.1, 4}, {4, 6}}));
  EXPECT_EQ(pairs(picture.most), (Pairs{{1, 0}, {2, 1}, {3, 4}, {3.5, 6}}));
  EXPECT_EQ(picture.weyl, 1);
  EXPECT_EQ(picture.next, 3);
  EXPECT_GT(picture.end, 3);
}

TEST(EigenvaluesPicture, HasABandForEachRowAndANumberForSeveralEigenvalues) {
  const EigenvaluesPicture picture = picture_of(document());
  const std::string svg = draw_svg(picture, 700);
  EXPECT_EQ(svg, draw_svg(picture, 700));
  EXPECT_THAT(svg, HasSubstr("width=\"700\" height=\"434\""));
  EXPECT_EQ(occurrences(group(svg, "enclosures"), "<rect"), 2U);
  EXPECT_EQ(occurrences(group(svg, "places"), "<rect"), 2U);
  EXPECT_EQ(occurrences(group(svg, "numbers"), "<text"), 1U);
  EXPECT_THAT(group(svg, "numbers"), HasSubstr(">3<"));
  for (const char* name : {"quarter", "weyl", "least", "most"})
    EXPECT_THAT(svg, HasSubstr("class=\"" + std::string(name) + '"'));
}

/// Intervals of no width that can be seen, and numbers that would be at the same place.
TEST(EigenvaluesPicture, NarrowIntervalsCanBeSeen) {
  EigenvaluesPicture picture{.title = "a & b", .next = 8, .end = 10, .weyl = 2};
  for (const double x : {5.0, 5.001}) picture.eigenvalues.push_back({{x, x + 1e-9}, 2});
  const std::string svg = draw_svg(picture);
  EXPECT_THAT(svg, HasSubstr("a &amp; b"));
  EXPECT_EQ(occurrences(group(svg, "enclosures"), "width=\"2.00\""), 2U);
  EXPECT_EQ(occurrences(group(svg, "places"), "width=\"3.00\""), 2U);
  const std::string numbers = group(svg, "numbers");
  EXPECT_EQ(occurrences(numbers, "y=\"144.00\""), 1U);
  EXPECT_EQ(occurrences(numbers, "y=\"127.00\""), 1U);
}

TEST(EigenvaluesPicture, AnyNumbersOfAFileAreDrawn) {
  EigenvaluesDocument file = document();
  for (const double next : {0.0, 1e-300, 1e300}) {
    for (const bool rows : {false, true}) {
      file.next = next;
      file.eigenvalues.clear();
      if (rows) file.eigenvalues = {{{0, 1e308}, std::numeric_limits<std::uint32_t>::max()}};
      EXPECT_THAT(draw_svg(picture_of(file)), Not(HasSubstr("nan")));
      EXPECT_THAT(draw_svg(picture_of(file)), Not(HasSubstr("inf")));
    }
  }
}

// Eigenfunctions.

/// Δf = −λf, by differences, and the value in the centre is α_0.
TEST(EigenfunctionValues, AreThoseOfAnEigenfunctionAroundEachVertex) {
  const EigenvaluesDocument file = with_functions();
  constexpr double kStep = 1e-3;
  for (const auto& [row, function] : {std::pair(0, 1), std::pair(1, 0)}) {
    const auto r = static_cast<std::size_t>(row);
    const auto f = static_cast<std::size_t>(function);
    const EigenfunctionValues values(file, r, f);
    const EigenvaluesDocument::Eigenfunctions& functions = file.eigenfunctions[r];
    for (const std::size_t v : {std::size_t{0}, net().vertices.size() - 1}) {
      EXPECT_DOUBLE_EQ(values.at(v, 0), functions.functions[f][7 * v]);
      for (const Point z : {Point(0.1, 0), Point(-0.2, 0.15), Point(0.05, -0.3), Point(0.33, 0.02)}) {
        const double sum = values.at(v, z + kStep) + values.at(v, z - kStep) + values.at(v, z + Point(0, kStep)) +
                           values.at(v, z - Point(0, kStep)) - 4 * values.at(v, z);
        const double scale = (1 - std::norm(z)) / 2;
        EXPECT_NEAR(scale * scale * sum / (kStep * kStep), -functions.lambda * values.at(v, z), 1e-4) << z;
      }
    }
  }
}

/// The constants have λ = 0, and the function of order m is then t^m cos mθ or t^m sin mθ.
TEST(EigenfunctionValues, AreHarmonicForZero) {
  EigenvaluesDocument file = with_functions();
  file.eigenfunctions[0].lambda = 0;
  const EigenfunctionValues values(file, 0, 0);
  const std::vector<double>& c = file.eigenfunctions[0].functions[0];
  const Point z(0.2, -0.25);
  double expected = c[7];
  for (std::size_t m = 1; m <= 3; ++m) {
    const Point power = std::pow(z, static_cast<int>(m));
    expected += c[7 + 2 * m - 1] * power.real() + c[7 + 2 * m] * power.imag();
  }
  EXPECT_NEAR(values.at(1, z), expected, 1e-14);
}

TEST(EigenfunctionValues, ThereAreNoOthers) {
  const EigenvaluesDocument file = with_functions();
  EXPECT_THROW(EigenfunctionValues(file, 2, 0), std::out_of_range);
  EXPECT_THROW(EigenfunctionValues(file, 1, 1), std::out_of_range);
}

TEST(EigenfunctionPlace, IsThatOfTheIntervalOfTheEigenvalue) {
  const EigenvaluesDocument file = with_functions();
  const std::vector<std::pair<std::size_t, std::size_t>> expected{{0, 0}, {0, 1}, {1, 0}};
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const EigenfunctionPlace place = eigenfunction_place(file, k + 2);
    EXPECT_EQ(std::pair(place.row, place.function), expected[k]);
    EXPECT_EQ(std::pair(place.first, place.count), std::pair(2U, 3U));
    const std::vector<double> values = eigenfunction_at_vertices(file, k + 2);
    ASSERT_EQ(values.size(), net().vertices.size());
    EXPECT_EQ(values[5], file.eigenfunctions[place.row].functions[place.function][35]);
  }
}

TEST(EigenfunctionPlace, ErrorsSayWhatThereIs) {
  EigenvaluesDocument file = with_functions();
  const auto expect = [&](std::size_t index, const std::string& text) {
    EXPECT_THAT([&] { (void)eigenfunction_place(file, index); }, ThrowsMessage<std::out_of_range>(HasSubstr(text)));
  };
  for (const std::size_t index : {0U, 1U, 5U})
    expect(index,
           "no eigenfunction of lambda_" + std::to_string(index) + ": the file has 3, those of lambda_2 to lambda_4");
  file.eigenfunctions.erase(file.eigenfunctions.begin());
  expect(4, "no eigenfunction of lambda_4: the file has 1, that of lambda_2");
  file.eigenfunctions.clear();
  expect(1, "no eigenfunction of lambda_1: the file has no eigenfunctions");
}

TEST(EigenfunctionPicture, HasBandsAndNodalLines) {
  const EigenvaluesDocument file = with_functions();
  const std::string svg = eigenfunction_svg(file, 2, {.size = 300});
  EXPECT_EQ(svg, eigenfunction_svg(file, 2, {.size = 300}));
  EXPECT_THAT(svg, HasSubstr("λ_2 in [2, 2.03"));
  EXPECT_THAT(svg, HasSubstr("one of 3 for λ_2 to λ_4"));
  EXPECT_GT(occurrences(group(svg, "values"), "<path"), 12U);
  EXPECT_GT(occurrences(group(svg, "nodal-lines"), "<path"), 0U);
  EXPECT_NE(svg, eigenfunction_svg(file, 2, {.centre = 3, .size = 300}));
  EXPECT_NE(svg, eigenfunction_svg(file, 2, {.order = DrawOrder::breadth_first, .size = 300}));
  EXPECT_THROW((void)eigenfunction_svg(file, 2, {.centre = 100'000}), NetGeometryError);
  EXPECT_THROW((void)eigenfunction_svg(file, 1), std::out_of_range);
}

/// Points of different parts are the same on paper, if it is small. Then edges of the bands are the same, too; all are
/// closed (an assertion says so).
TEST(EigenfunctionPicture, IsDrawnOnSmallPaper) {
  const EigenvaluesDocument file = with_functions();
  for (std::uint32_t size = 50; size < 150; ++size) {
    const std::string svg = eigenfunction_svg(file, 2 + size % 3, {.centre = size % 5, .size = size});
    EXPECT_EQ(occurrences(svg, "NaN") + occurrences(svg, "nan"), 0U);
  }
}

/// A function that is positive everywhere has no nodal lines, and only red bands; one that is 0 has no scale.
TEST(EigenfunctionPicture, OfAFunctionWithoutZeros) {
  EigenvaluesDocument file = with_functions();
  std::vector<double>& c = file.eigenfunctions[1].functions[0];
  for (std::size_t k = 0; k < c.size(); ++k) c[k] = k % 7 == 0 ? 1 : 0;
  const std::string svg = eigenfunction_svg(file, 4, {.size = 300});
  EXPECT_EQ(occurrences(group(svg, "nodal-lines"), "<path"), 0U);
  EXPECT_LE(occurrences(group(svg, "values"), "<path"), 12U);
  std::fill(c.begin(), c.end(), 0);
  EXPECT_THAT(eigenfunction_svg(file, 4, {.size = 300}), Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace epsnet::eigenvalues_picture_test
