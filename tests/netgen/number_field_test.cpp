#include "netgen/surfaces/number_field.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "certify/check.h"
#include "certify/numbers/field_number.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/isometries/isometries.h"
#include "netgen/nets/certified_net.h"
#include "netgen/surfaces/exact_isometries.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/netgen/matrix_texts.h"

/// Numbers that texts name, and surfaces over the fields of such numbers.
namespace epsnet::number_field_test {
namespace {

using test::made_of;
using test::problem;
using ::testing::HasSubstr;

/// The field of some numbers, and their values.
struct Read {
  explicit Read(const std::vector<std::string>& texts) {
    NumberFieldReader reader;
    for (const std::string& text : texts) reader.add(text);
    field = reader.field();
    const certify::NumberField numbers(field.polynomial, field.root);
    const certify::Precision scope(128);
    for (const RationalPolynomial& x : reader.numbers()) {
      certify::FieldNumber numerator{&numbers, {}};
      fmpq_poly_get_numerator(numerator.re.get(), x.get());
      values.push_back(certify::lower_end(certify::real_ball(numerator)) / denominator_of(x).get_d());
      zero.push_back(certify::sign(numerator) == 0);
    }
  }
  [[nodiscard]] std::size_t degree() const { return field.polynomial.size() - 1; }

  certify::SurfaceDocument::Field field;
  std::vector<double> values;
  std::vector<bool> zero;
};

TEST(NumberField, IsTheLeastOneThatHasTheNumbers) {
  const std::vector<std::pair<std::string, std::size_t>> degrees{
      {"3/4", 1},       {"sqrt(4)", 1},         {"sqrt(2)", 2},         {"sqrt(8)/sqrt(2)", 2},
      {"cos(pi/7)", 3}, {"root(x^3-x-1,1)", 3}, {"sqrt(2)+sqrt(3)", 4}, {"cos(pi/5)*sqrt(5)", 2},
      {"sin(pi/8)", 4}, {"sqrt(1+sqrt(2))", 4}, {"root(x^4-4,1.4)", 2}, {"sqrt(3+2*sqrt(2))", 2},
      {"cos(pi/3)", 1}, {"sqrt(2)^2", 2},       {"root((x-1)^2,1)", 1}, {"cos(2*pi/9)+cos(4*pi/9)", 3}};
  for (const auto& [text, degree] : degrees) EXPECT_EQ(Read({text}).degree(), degree) << text;
}

TEST(NumberField, NumbersAreThoseOfTheirTexts) {
  const double golden = (1 + std::sqrt(5)) / 2;
  const std::vector<std::pair<std::string, double>> numbers{
      {"-3/4", -0.75},
      {"0.125*sqrt(2)", std::sqrt(2) / 8},
      {"1/(1+sqrt(2))", 1 / (1 + std::sqrt(2))},
      {"2*cos(pi/5)", golden},
      {"sin(-pi/7)", -std::sin(M_PI / 7)},
      {"cos(3*pi/4)", -std::sqrt(0.5)},
      {"root(x^2-x-1,-1)", 1 - golden},
      {"root(2*x^2-1,1)", std::sqrt(0.5)},
      {"sqrt(sqrt(2)+sqrt(3))", std::sqrt(std::sqrt(2) + std::sqrt(3))},
      {"-(1-sqrt(7))^3", std::pow(std::sqrt(7) - 1, 3)},
      {"-sqrt(3)^2", -3},
      {"1-sqrt(3)^2*-2^2", 13},
      {"root(-x^2+2,1)", std::sqrt(2)}};
  std::vector<std::string> texts;
  for (const auto& [text, value] : numbers) {
    EXPECT_NEAR(Read({text}).values[0], value, 1e-14) << text;
    texts.push_back(text);
  }
  // Also in a field that has the first ones together.
  const Read together({texts.begin(), texts.begin() + 4});
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(together.values[i], numbers[i].second, 1e-14) << numbers[i].first;
}

TEST(NumberField, KnowsWhatIsZero) {
  const Read read(
      {"sqrt(2)*sqrt(3)-sqrt(6)", "cos(pi/4)-sqrt(1/2)", "sqrt(3+2*sqrt(2))-1-sqrt(2)", "sqrt(6)-2.44948974278"});
  EXPECT_EQ(read.zero, (std::vector<bool>{true, true, true, false}));
}

TEST(NumberField, SaysWhatIsWrongWithAText) {
  const std::vector<std::pair<std::string, std::string>> problems{
      {"sqrt(-1)", "expected a positive number in the square root"},
      {"root(x^2+1,0)", "that has a real root"},
      {"root(3,0)", "a polynomial in x of degree 1 to 64"},
      {"root(x^2-2,0)", "nearer to one root than to the others"},
      {"root(x^64+1" + std::string(2000, '0') + "*x+1,0)", "a polynomial of at most 100000 bits"},
      {"1/(sqrt(4)-2)", "other than 0"},
      {"foo", "expected a number, sqrt(x), root(f,r), cos(a*pi/b) or sin(a*pi/b) at character 1"},
      {"sqrt(2", "expected ')'"},
      {"sqrt(2))", "expected an operator at character 8"},
      {"cos(pi/0)", "other than 0"},
      {"cos(pi/1001)", "at most 500 parts of pi"},
      {"cos(pi/101)*cos(pi/103)", "field of degree"},
      {std::string(200, '('), "fewer parentheses"}};
  for (const auto& [text, expected] : problems) {
    NumberFieldReader reader;
    try {
      reader.add(text);
      ADD_FAILURE() << text;
    } catch (const SurfaceError& error) {
      EXPECT_THAT(error.what(), HasSubstr(expected)) << text;
    }
  }
}

/// Bolza's generators, with the octagon's centre at 0.
constexpr const char* kBolza =
    "model su11\n"
    "1+sqrt(2)  0  sqrt(2+2*sqrt(2))  0\n"
    "1+sqrt(2)  0  sqrt(2+2*sqrt(2))*cos(pi/4)  sqrt(2+2*sqrt(2))*sin(pi/4)\n"
    "1+sqrt(2)  0  0   sqrt(2+2*sqrt(2))\n"
    "1+sqrt(2)  0  -sqrt(2+2*sqrt(2))*cos(pi/4)  sqrt(2+2*sqrt(2))*sin(pi/4)\n";

/// Units of norm 1 of the quaternion algebra of discriminant 26, (2, 13 | Q): x + yi + zj + wij.
constexpr const char* kDiscriminant26 =
    "algebra 13 2\n"
    "5/2 -1/2 -1 0\n5/2 -1/2 1 0\n3/2 -1/2 -3/2 -1/2\n3/2 -1/2 -3/2 1/2\n3/2 -1/2 3/2 -1/2\n3/2 -1/2 3/2 1/2\n"
    "3 0 -2 0\n";

TEST(SurfacesOverAField, AreExactlyThoseOfTheirMatrices) {
  const MatrixSurface made = made_of(kBolza);
  EXPECT_TRUE(made.is_exact);
  EXPECT_EQ(made.surface.genus(), 2U);
  EXPECT_EQ(made.surface.field_tiles()->field.degree(), 4U);
  EXPECT_FALSE(made.surface.is_rational());
  EXPECT_EQ(made.words.size(), 4U);
}

TEST(SurfacesOverAField, HaveAllTheirSymmetries) {
  const Surface surface = made_of(kBolza).surface;
  const IsometryGroup group = isometries(surface);
  EXPECT_EQ(group.size(), 96U);
  EXPECT_EQ(certified_isometries(surface, group).certificate.verdict, certify::Verdict::verified);
}

TEST(SurfacesOverAField, OfAQuaternionAlgebraHaveTheLengthsOfItsUnits) {
  const MatrixSurface made = made_of(kDiscriminant26);
  EXPECT_EQ(made.surface.genus(), 2U);
  // A unit of trace t is a translation by 2 arcosh(t/2).
  EXPECT_NEAR(systole(made.surface).document.geodesics.at(0).length.lower, 2 * std::acosh(1.5), 1e-12);
}

TEST(SurfacesOverAField, AreTheSameAfterTheirMatricesAreWritten) {
  for (const char* text : {kBolza, kDiscriminant26}) {
    const Surface surface = made_of(text).surface;
    for (const MatrixModel model : {MatrixModel::sl2r, MatrixModel::su11}) {
      const MatrixSurface again = made_of(write_matrices(surface, model));
      EXPECT_TRUE(again.is_exact);
      EXPECT_EQ(isometric(surface, again.surface).kind, IsometricAnswer::Kind::yes);
    }
  }
}

TEST(SurfacesOverAField, AreTheSameInAFile) {
  const Surface surface = made_of(kDiscriminant26).surface;
  const certify::SurfaceDocument document = to_document(surface);
  EXPECT_EQ(to_document(from_document(document)), document);
}

TEST(SurfacesOverAField, HaveCovers) {
  const Surface surface = made_of(kBolza).surface;
  const Surface threefold = cover(surface, random_sheets(surface, 3, 1));
  EXPECT_EQ(threefold.genus(), 4U);
  EXPECT_EQ(certified_net(threefold, Length("1")).certificate.verdict, certify::Verdict::verified);
}

/// What is said of the tiles of Bolza's surface after a change.
template <class Change>
std::string problem_of(const Change& change) {
  certify::SurfaceDocument document = to_document(made_of(kBolza).surface);
  change(document.field);
  try {
    (void)from_document(document);
  } catch (const SurfaceError& error) {
    return error.what();
  }
  return "no problem";
}

TEST(SurfacesOverAField, AreExamined) {
  EXPECT_EQ(problem_of([](auto&) {}), "no problem");
  EXPECT_THAT(problem_of([](auto& field) { field.root = {1000, 1001}; }), HasSubstr("does not isolate a root"));
  EXPECT_THAT(problem_of([](auto& field) { field.polygons[0][0][2] = {mpz_class(0)}; }),
              HasSubstr("vertex 0 of tile 0 is not inside the light cone"));
  EXPECT_THAT(problem_of([](auto& field) { field.crossings[0][0][0] += 1; }),
              HasSubstr("does not take it to its partner"));
  EXPECT_THAT(problem_of([](auto& field) { std::swap(field.crossings[0][0], field.crossings[0][2]); }),
              HasSubstr("a crossing is no isometry"));
  EXPECT_THAT(problem_of([](auto& field) { std::swap(field.polygons[0][0], field.polygons[0][1]); }),
              HasSubstr("clockwise"));
}

TEST(SurfacesOverAField, OfWrongMatricesAreNone) {
  using Kind = MatricesError::Kind;
  EXPECT_EQ(problem("sqrt(2) 0 0 -1").first, Kind::text);
  EXPECT_EQ(problem("algebra -1 -3\n1 0 0 0\n").first, Kind::text);
  // A parabolic element, and one of order 8.
  EXPECT_EQ(problem("1 sqrt(2) 0 1\n2 sqrt(3) sqrt(3) 2\n").first, Kind::not_compact);
  EXPECT_EQ(problem("cos(pi/8) sin(pi/8) -sin(pi/8) cos(pi/8)\n2 sqrt(3) sqrt(3) 2\n").first, Kind::torsion);
}

}  // namespace
}  // namespace epsnet::number_field_test
