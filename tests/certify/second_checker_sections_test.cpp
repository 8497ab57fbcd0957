#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "certify/claims/eigenvalues/enclosures.h"
#include "certify/claims/eigenvalues/fields.h"
#include "certify/exact/checker.h"
#include "certify/file/file.h"
#include "certify/net/numbering.h"
#include "tests/certify/reference.h"

/// Eigenvalues files with phases, in both checkers: sections of flat line bundles (docs/proof.md, section 17.3).
namespace epsnet::exact::second_checker_sections_test {
namespace {

using Document = certify::EigenvaluesDocument;
using Phases = std::vector<std::string>;

Document file(const std::string& name) {
  return certify::read_file<Document>(std::string(EPSNET_TEST_DATA) + "/eigenvalues/" + name + ".json");
}

/// The octagon of octagon-5.json, a third or half of a turn across side 0. Its eigenvalues and those of the complex
/// conjugate are those of the cyclic cover of three (two) sheets across this side that are not the octagon's: of the
/// third 0.2873, 1.6175, three from 4.05 to 5.12, and nothing else up to 5.48; of the half 0.4610, 1.2867, three from
/// 4.07 to 5.11, and 5.96.
Document third() { return file("octagon-sections-of-a-third"); }
Document half() { return file("octagon-sections-of-a-half"); }

std::string text(const Document& document) {
  std::ostringstream out;
  certify::write_file(document, out);
  return out.str();
}

constexpr std::array<const char*, 4> kVerdicts{"VERIFIED", "REFUTED", "UNDECIDED", "MALFORMED"};

std::string named(const char* verdict, const std::string& rule) {
  return verdict + (rule.empty() || rule == "structure" ? "" : ": " + rule);
}

/// "VERDICT", or "VERDICT: rule", on which both checkers agree.
std::string outcome(const Document& document) {
  const certify::Certificate first = certify::check(document, {.threads = 1});
  const Result second = check(text(document));
  const std::string result = named(kVerdicts.at(static_cast<std::size_t>(first.verdict)), first.rule);
  EXPECT_EQ(named(kVerdicts.at(static_cast<std::size_t>(second.verdict)), second.rule), result) << second.message;
  return result;
}

std::string changed(const std::function<void(Document&)>& change) {
  Document document = third();
  change(document);
  return outcome(document);
}

std::string message(const Document& document) { return certify::check(document, {.threads = 1}).message; }

void remove_counts(Document& document) {
  document.eigenvalues.clear();
  document.next = 0;
  document.at_most.clear();
  document.at_least.clear();
  document.side_order.clear();
  document.vertex_order.clear();
}

TEST(Sections, OfTrueFilesAreVerified) {
  EXPECT_EQ(outcome(third()), "VERIFIED");
  EXPECT_EQ(outcome(half()), "VERIFIED");
}

TEST(Sections, HaveTheEigenvaluesThatACoverHasBesideThoseOfFunctions) {
  const auto expect_in = [](const Document& document, double first, double second) {
    ASSERT_EQ(document.eigenvalues.size(), 3U);
    for (const auto& [row, value] : {std::pair(document.eigenvalues[0], first), {document.eigenvalues[1], second}}) {
      EXPECT_EQ(row.count, 1U);
      EXPECT_LT(row.in.lower, value);
      EXPECT_GT(row.in.upper, value);
    }
    EXPECT_EQ(document.eigenvalues[2].count, 3U);
  };
  expect_in(third(), 0.2873, 1.6175);
  expect_in(half(), 0.4610, 1.2867);
}

TEST(Sections, TheClaimIsNotOneOfFunctions) {
  EXPECT_EQ(certify::check(third(), {.threads = 1}).claim,
            "the first 5 eigenvalues of the Laplacian on sections of the flat line bundle of these phases, with "
            "multiplicity, lie in 3 intervals, all others are at least 5.0706557779780139");
  Document document = third();
  remove_counts(document);
  EXPECT_EQ(certify::check(document, {.threads = 1}).claim,
            "all eigenvalues of the Laplacian on sections of the flat line bundle of these phases are at least 0");
}

TEST(Sections, EachCountIsAsGoodAsTheMatrices) {
  for (const auto& make : {third, half}) {
    for (const std::size_t i : {1U, 2U, 3U}) {
      Document document = make();
      --document.at_most[i].count;
      EXPECT_EQ(outcome(document), "UNDECIDED: most") << i;
      document = make();
      ++document.at_least[i - 1].count;
      EXPECT_EQ(outcome(document), "UNDECIDED: least") << i;
      document = make();
      document.at_most[i].sigma *= 1.3;
      document.at_least[i - 1].below *= 0.9;
      EXPECT_EQ(outcome(document), "UNDECIDED: most") << i;
      document.at_most[i].sigma /= 1.3;
      EXPECT_EQ(outcome(document), "UNDECIDED: least") << i;
    }
  }
  Document document = third();
  --document.at_most[3].count;
  EXPECT_EQ(message(document), "at_most[3]: at most 5 follows");
  document = third();
  ++document.at_least[2].count;
  EXPECT_EQ(message(document), "at_least[2]: at least 5 follows");
  document = third();
  document.at_least[0].below = 0.25;
  EXPECT_EQ(message(document), "at_least[0]: nothing follows");
}

TEST(Sections, RowsOfEigenvaluesBeginWithTheFirstOne) {
  Document document = third();
  document.eigenvalues.erase(document.eigenvalues.begin());
  EXPECT_EQ(outcome(document), "REFUTED: enclosures");
  EXPECT_EQ(message(document), "eigenvalues[0]: that lambda_0 is at least 1.5656416984925787 does not follow");
}

TEST(Sections, OfConjugatePhasesHaveTheSameEigenvalues) {
  EXPECT_EQ(changed([](Document& d) { d.phases = {"-1/3", "0", "0", "0", "1/3", "0", "0", "0"}; }), "VERIFIED");
  EXPECT_EQ(changed([](Document& d) { d.phases = {"2/3", "0", "0", "0", "1/3", "0", "0", "0"}; }), "VERIFIED");
}

TEST(Sections, OfOtherPhasesHaveOtherEigenvalues) {
  EXPECT_EQ(changed([](Document& d) { d.phases = {"0", "1/3", "0", "0", "0", "-1/3", "0", "0"}; }), "UNDECIDED: most");
  EXPECT_EQ(changed([](Document& d) { d.phases = half().phases; }), "UNDECIDED: most");
  EXPECT_EQ(changed([](Document& d) { d.phases = Phases(8, "0"); }), "UNDECIDED: most");
  // Functions: λ_0 is not counted.
  EXPECT_EQ(changed([](Document& d) { d.phases.clear(); }), "UNDECIDED: least");
}

/// Functions are sections without phases, but for the 0 of the constants.
TEST(Sections, WithoutPhasesAreFunctions) {
  Document document = file("octagon-5");
  document.phases = Phases(8, "0");
  EXPECT_EQ(outcome(document), "UNDECIDED: most");
  for (auto& row : document.at_most) ++row.count;
  for (auto& row : document.at_least) ++row.count;
  EXPECT_EQ(outcome(document), "REFUTED: enclosures");
  document.eigenvalues.insert(document.eigenvalues.begin(), Document::Enclosure{{0, 0.01}, 1});
  EXPECT_EQ(outcome(document), "REFUTED: enclosures");
  document.at_least.push_back({0.01, 1});
  EXPECT_EQ(outcome(document), "VERIFIED");
}

/// Both products of two values of one number are in the diagonal: all three corners of a triangle are one vertex.
TEST(Sections, OfOneVertexAreNoConstants) {
  Document document = file("octagon-5-of-one-vertex");
  remove_counts(document);
  document.halvings = 0;
  document.vertex_order = {0};
  document.at_least = {{0.01, 1}};
  document.phases = Phases(8, "0");
  EXPECT_EQ(outcome(document), "VERIFIED");
  // Energy by mass of a constant in the frame of the vertex, in the metric of flat triangles.
  const std::array<std::pair<const char*, double>, 2> quotients{{{"0.3", 3.384}, {"1/2", 8.008}}};
  for (const auto& [phase, quotient] : quotients) {
    document.phases = {phase, "0", "0", "0", std::string("-") + phase, "0", "0", "0"};
    document.at_least = {{quotient * 0.99, 1}};
    EXPECT_EQ(outcome(document), "UNDECIDED: least") << phase;
    document.at_least = {{quotient * 1.01, 1}};
    EXPECT_EQ(outcome(document), "VERIFIED") << phase;
  }
}

// The rule `phases`.

TEST(Phases, OfGluedSidesAddUpToAnInteger) {
  const auto broken = [](const Phases& phases) {
    Document document = third();
    document.phases = phases;
    EXPECT_EQ(outcome(document), "REFUTED: phases");
    return message(document);
  };
  EXPECT_EQ(broken({"1/3", "0", "0", "0", "1/3", "0", "0", "0"}),
            "those of side 0 of tile 0 and side 4 of tile 0 add up to 2/3 modulo 1, not to an integer");
  EXPECT_EQ(broken({"1/3", "0", "0", "0", "0", "0", "0", "0"}),
            "those of side 0 of tile 0 and side 4 of tile 0 add up to 1/3 modulo 1, not to an integer");
  EXPECT_EQ(broken({"1/3", "0", "0", "0", "-1/3", "0", "0", "0.000000000000001"}),
            "those of side 3 of tile 0 and side 7 of tile 0 add up to 1/1000000000000000 modulo 1, not to an integer");
}

/// Klein's quartic, made of 24 heptagons, with phases and the net's matrices.
Document klein(const Phases& phases) {
  Document document;
  document.net =
      certify::read_file<certify::NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/map-klein.json");
  document.phases = phases;
  return document;
}

/// Phases that make no difference: f_t times a unit for each tile.
Phases gauge(const certify::SurfaceSides& sides, int denominator) {
  std::mt19937 random(5);  // NOLINT: the same in every run.
  std::vector<int> turns(sides.first.size());
  for (int& turn : turns) turn = static_cast<int>(random() % static_cast<unsigned>(denominator));
  Phases phases;
  for (std::size_t s = 0; s < sides.partner.size(); ++s) {
    const int phase = turns[sides.tile[sides.partner[s]]] - turns[sides.tile[s]];
    phases.push_back(std::to_string(phase) + "/" + std::to_string(denominator));
  }
  return phases;
}

TEST(Phases, AroundVerticesAddUpToAnInteger) {
  const certify::SurfaceSides sides(klein({}).net.surface);
  for (const std::uint32_t first : sides.vertices()) {
    // Of the sides of one vertex one changes, with its partner; the vertex at its other end is wrong then, too.
    Phases phases = gauge(sides, 5);
    EXPECT_EQ(outcome(klein(phases)), "VERIFIED");
    phases[first] = phases[sides.partner[first]] = "0.5";
    const Document document = klein(phases);
    EXPECT_EQ(outcome(document), "REFUTED: phases");
    EXPECT_NE(message(document).find("around vertex"), std::string::npos) << message(document);
    if (first > 10) break;
  }
}

/// Multiplied by a unit in each tile, sections are functions: the least eigenvalue is 0, and one is less than 0.1; the
/// next one is 2.678.
TEST(Sections, DoNotDependOnTheUnitsOfTiles) {
  const certify::SurfaceSides sides(klein({}).net.surface);
  for (const int denominator : {2, 4, 7}) {
    Document document = klein(gauge(sides, denominator));
    for (const std::uint32_t halvings : {0U, 1U}) {
      document.halvings = halvings;
      const std::size_t vertices = halvings == 0 ? 24 : 24 + 84;
      const std::size_t edges = halvings == 0 ? 84 : 336;
      document.side_order.resize(edges);
      document.vertex_order.resize(vertices);
      for (std::uint32_t i = 0; i < edges; ++i) document.side_order[i] = i;
      for (std::uint32_t i = 0; i < vertices; ++i) document.vertex_order[i] = i;
      document.at_most = {{1, 1, 2}};
      document.at_least = {{0.1, 1}};
      EXPECT_EQ(outcome(document), "VERIFIED") << denominator << ' ' << halvings;
      document.at_most[0].count = 0;
      EXPECT_EQ(outcome(document), "UNDECIDED: most") << denominator << ' ' << halvings;
      document.at_most[0].count = 1;
      document.at_least[0].count = 2;
      EXPECT_EQ(outcome(document), "UNDECIDED: least") << denominator << ' ' << halvings;
    }
  }
}

// Structure.

TEST(Phases, AreWrittenInFewCharactersAndHaveACommonDenominator) {
  const auto with = [](const char* phase) {
    return changed([&](Document& d) {
      remove_counts(d);
      d.phases = {phase, "0", "0", "0", std::string("-") + phase, "0", "0", "0"};
    });
  };
  EXPECT_EQ(with("0.123456789012345678"), "VERIFIED");
  EXPECT_EQ(with("123456789012345677/1000000000000000000"), "VERIFIED");
  EXPECT_EQ(with("0.50000000000000000000000000000000000000"), "MALFORMED");  // With the minus: 41 characters.
  EXPECT_EQ(with("0.1234567890123456789"), "MALFORMED");
  for (const char* phase : {"1", "1.0", "3/2", "1e-1", "1E0", "x", "1/0", "0x1", ".5"})
    EXPECT_EQ(with(phase), "MALFORMED") << phase;
  EXPECT_EQ(changed([](Document& d) {
              remove_counts(d);
              d.phases = {"1/1000000007", "1/1000000009", "0", "0", "-1/1000000007", "-1/1000000009", "0", "0"};
            }),
            "MALFORMED");
}

TEST(Phases, AreThoseOfAllSides) {
  EXPECT_EQ(changed([](Document& d) { d.phases.pop_back(); }), "MALFORMED");
  EXPECT_EQ(changed([](Document& d) { d.phases.emplace_back("0"); }), "MALFORMED");
  EXPECT_EQ(changed([](Document& d) { d.phases = {"0"}; }), "MALFORMED");
}

TEST(Phases, AndEigenfunctionsAreNotInOneFile) {
  Document document = file("octagon-5-with-a-function");
  document.phases = Phases(8, "0");
  EXPECT_EQ(outcome(document), "MALFORMED");
}

// Boxes of phases. Those of octagon-sections-in-a-box.json are a hundredth of a turn in the four directions of the
// octagon of octagon-5.json.

Document box() { return file("octagon-sections-in-a-box"); }

std::string changed_box(const std::function<void(Document::Box&)>& change) {
  Document document = box();
  change(*document.box);
  return outcome(document);
}

/// Of a true file that says less: eigenvalues are not so near to those of the centre.
Document wider_box() {
  Document document = box();
  for (auto& row : document.eigenvalues) row.in = {row.in.lower / 2, row.in.upper * 2};
  document.next /= 2;
  return document;
}

TEST(Boxes, OfTrueFilesAreVerified) {
  EXPECT_EQ(outcome(box()), "VERIFIED");
  EXPECT_EQ(outcome(wider_box()), "VERIFIED");
}

TEST(Boxes, AreSaidInTheClaim) {
  const std::string claim = certify::check(box(), {.threads = 1}).claim;
  EXPECT_NE(claim.find("of these phases, or of any within \"1/100\" turns of them in 4 directions, with"),
            std::string::npos)
      << claim;
}

/// Intervals are as narrow as follows, to some digits: 1 + 10⁻⁹ is the room that the file leaves.
TEST(Boxes, EachEndOfAnIntervalFollowsFromItsSize) {
  for (const double factor : {1 + 1e-6, 1 - 1e-6}) {
    for (std::size_t row = 0; row < box().eigenvalues.size(); ++row) {
      Document document = box();
      document.eigenvalues[row].in.lower *= factor;
      EXPECT_EQ(outcome(document), factor > 1 ? "REFUTED: enclosures" : "VERIFIED") << row;
      document = box();
      document.eigenvalues[row].in.upper *= factor;
      EXPECT_EQ(outcome(document), factor > 1 ? "VERIFIED" : "REFUTED: enclosures") << row;
    }
    Document document = box();
    document.next *= factor;
    EXPECT_EQ(outcome(document), factor > 1 ? "REFUTED: enclosures" : "VERIFIED");
  }
}

TEST(Boxes, OfAGreaterRadiusSayLess) {
  EXPECT_EQ(changed_box([](auto& b) { b.radius = "0.00999"; }), "VERIFIED");
  EXPECT_EQ(changed_box([](auto& b) { b.radius = "0.01"; }), "VERIFIED");
  EXPECT_EQ(changed_box([](auto& b) { b.radius = "10001/1000000"; }), "REFUTED: enclosures");
  EXPECT_EQ(changed_box([](auto& b) { b.radius = "1e1000"; }), "UNDECIDED: box");
  EXPECT_EQ(changed_box([](auto& b) { b.radius = "1e-1000"; }), "VERIFIED");
}

/// Without it the rows say what they say of the centre.
TEST(Boxes, WithoutSlopesAreTheirCentre) {
  Document document = box();
  document.box->directions.clear();
  EXPECT_EQ(outcome(document), "VERIFIED");
  document.eigenvalues[0].in.upper = document.at_least[0].below;
  document.next = document.at_most.back().below;
  EXPECT_EQ(outcome(document), "VERIFIED");
  // Of h that is constant, too.
  document.box->directions = {
      {std::vector<std::int64_t>(8, 0), std::vector<double>(document.net.vertices.size(), 0.5)}};
  EXPECT_EQ(outcome(document), "VERIFIED");
  document.box->directions[0].heights.back() += 1e-3;
  EXPECT_EQ(outcome(document), "REFUTED: enclosures");
}

TEST(Boxes, HaveTheSlopesOfAllDirections) {
  // A direction less leaves room for another radius.
  EXPECT_EQ(changed_box([](auto& b) { b.directions.pop_back(); }), "VERIFIED");
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(changed_box([&](auto& b) {
                for (auto& step : b.directions[k].steps) step *= 2;
              }),
              "REFUTED: enclosures")
        << k;
    EXPECT_EQ(changed_box([&](auto& b) {
                for (double& height : b.directions[k].heights) height = 0;
              }),
              "REFUTED: enclosures")
        << k;
    // A constant changes nothing, and neither does the sign.
    EXPECT_EQ(changed_box([&](auto& b) {
                for (double& height : b.directions[k].heights) height += 0x1p-10;
              }),
              "VERIFIED")
        << k;
    EXPECT_EQ(changed_box([&](auto& b) {
                for (double& height : b.directions[k].heights) height = -height;
                for (auto& step : b.directions[k].steps) step = -step;
              }),
              "VERIFIED")
        << k;
    EXPECT_EQ(changed_box([&](auto& b) {
                for (double& height : b.directions[k].heights) height = -height;
              }),
              "REFUTED: enclosures")
        << k;
  }
}

/// One height that is far from what is around it is seen, wherever it is.
TEST(Boxes, HaveTheGreatestSlopeOfAllTriangles) {
  const std::size_t vertices = box().net.vertices.size();
  for (std::size_t v = 0; v < vertices; ++v)
    EXPECT_EQ(changed_box([&](auto& b) { b.directions[v % 4].heights[v] += 2; }), "REFUTED: enclosures") << v;
}

/// Of one count from either side.
Document box_of_one_row() {
  Document document = box();
  document.eigenvalues.resize(1);
  document.next = 0;
  document.at_most.resize(1);
  document.at_least.resize(1);
  return document;
}

/// ρ by Lemma 37.10, in long double, and the triangle where slopes are greatest.
struct RootDistance {
  certify::Real value = 0;
  std::uint32_t triangle = 0;
};

class RootDistances {
 public:
  explicit RootDistances(const certify::NetDocument& net) : reference_(net) {}

  [[nodiscard]] RootDistance operator()(const Document::Box& box) const {
    RootDistance result;
    for (std::uint32_t t = 0; t < reference_.net().triangles.size(); ++t) {
      const certify::Real slopes = slopes_on(t, box);
      if (slopes > result.value) result = {slopes, t};
    }
    result.value *= 2 * std::numbers::pi_v<certify::Real> * certify::parse_decimal(box.radius).value().get_d();
    return result;
  }

 private:
  using Heights = std::array<certify::Real, 3>;

  [[nodiscard]] certify::Real height(const Document::Direction& direction, std::uint32_t dart) const {
    certify::Real result = direction.heights[certify::start(reference_.net(), dart)];
    if (const std::uint32_t label = certify::corner_label(reference_.net(), dart); label > 0) {
      for (const std::uint32_t side : reference_.net().labels[label - 1].word)
        result += static_cast<certify::Real>(direction.steps[side]);
    }
    return result;
  }

  /// C times the length of the vector g in the plane of the flat triangle with ⟨g, v_i − v_0⟩ = h_i − h_0.
  [[nodiscard]] certify::Real slope(std::uint32_t t, const Heights& h) const {
    std::array<certify::Vector, 2> sides;
    const certify::Vector v = certify::vector_of(reference_.corner(3 * t));
    for (std::uint32_t i = 0; i < 2; ++i) {
      const certify::Vector w = certify::vector_of(reference_.corner(3 * t + i + 1));
      sides[i] = {w[0] - v[0], w[1] - v[1], w[2] - v[2]};
    }
    const certify::Real a = certify::lorentz(sides[0], sides[0]);
    const certify::Real b = certify::lorentz(sides[0], sides[1]);
    const certify::Real c = certify::lorentz(sides[1], sides[1]);
    const certify::Real x = h[1] - h[0];
    const certify::Real y = h[2] - h[0];
    return std::cosh(reference_.circumradius(t)) * std::sqrt((c * x * x - 2 * b * x * y + a * y * y) / (a * c - b * b));
  }

  [[nodiscard]] certify::Real slopes_on(std::uint32_t t, const Document::Box& box) const {
    certify::Real sum = 0;
    for (std::size_t first = 0; first < box.directions.size(); first += 4) {
      const std::size_t count = std::min<std::size_t>(4, box.directions.size() - first);
      certify::Real greatest = 0;
      for (unsigned signs = 0; signs < 1U << count; ++signs) {
        Heights heights{};
        for (std::size_t k = 0; k < count; ++k) {
          for (std::uint32_t i = 0; i < 3; ++i)
            heights[i] += (signs >> k & 1U ? -1 : 1) * height(box.directions[first + k], 3 * t + i);
        }
        greatest = std::max(greatest, slope(t, heights));
      }
      sum += greatest;
    }
    return sum;
  }

  certify::Reference reference_;
};

/// In both checkers: the ends that follow, and not those that are narrower by little.
void expect_distance(Document document, const certify::Real& distance) {
  constexpr double kLittle = 1e-9;
  const auto root = [](double x) { return std::sqrt(certify::Real{x}); };
  auto& in = document.eigenvalues[0].in;
  const auto lower = static_cast<double>(std::pow(root(document.at_most[0].below) - distance, 2));
  const auto upper = static_cast<double>(std::pow(root(document.at_least[0].below) + distance, 2));
  double& least = document.at_most[0].count == 0 ? in.lower : document.next;
  least = lower * (1 - kLittle);
  in.upper = upper * (1 + kLittle);
  EXPECT_EQ(outcome(document), "VERIFIED");
  least = lower * (1 + kLittle);
  EXPECT_EQ(outcome(document), "REFUTED: enclosures");
  least = lower * (1 - kLittle);
  in.upper = upper * (1 - kLittle);
  EXPECT_EQ(outcome(document), "REFUTED: enclosures");
}

/// Both checkers round the same number outward, so they agree on ends that differ in the last digit.
TEST(Boxes, EndInTheSameNumbersForBothCheckers) {
  Document document = box_of_one_row();
  const certify::Real distance = RootDistances(document.net)(*document.box).value;
  const auto root = [](double x) { return std::sqrt(certify::Real{x}); };
  auto& in = document.eigenvalues[0].in;
  double& least = document.at_most[0].count == 0 ? in.lower : document.next;
  // Verified up to some end, and refuted from the next one on.
  const auto expect_change = [&](double& end, const certify::Real& value, double towards) {
    end = static_cast<double>(value);
    for (int digit = 0; digit < 3; ++digit) end = std::nextafter(end, -towards);
    EXPECT_EQ(outcome(document), "VERIFIED");
    std::string last = "VERIFIED";
    for (int digit = 0; digit < 6; ++digit) {
      end = std::nextafter(end, towards);
      const std::string next = outcome(document);
      EXPECT_TRUE(last == "VERIFIED" || next == "REFUTED: enclosures") << next;
      last = next;
    }
    EXPECT_EQ(last, "REFUTED: enclosures");
  };
  in.upper = 100;
  expect_change(least, std::pow(root(document.at_most[0].below) - distance, 2), HUGE_VAL);
  least = 0;
  expect_change(in.upper, std::pow(root(document.at_least[0].below) + distance, 2), -HUGE_VAL);
}

/// Heights are such that each triangle is once the steepest one.
TEST(Boxes, HaveTheDistanceOfTheLemma) {
  Document document = box_of_one_row();
  const Document::Box made = *document.box;
  const RootDistances distance_of(document.net);
  std::set<std::uint32_t> steepest;
  std::minstd_rand random(1);
  const std::size_t triangles = document.net.triangles.size();
  for (int trial = 0; trial < 5000 && steepest.size() < triangles; ++trial) {
    document.box = made;
    document.box->directions.resize(1 + random() % 4);
    for (Document::Direction& direction : document.box->directions) {
      for (const std::uint32_t v : document.net.triangles[random() % triangles].vertex)
        direction.heights[v] += static_cast<double>(random() % 1000) / 1000 - 0.5;
    }
    const RootDistance distance = distance_of(*document.box);
    if (distance.value < 0.4 && steepest.insert(distance.triangle).second) expect_distance(document, distance.value);
  }
  EXPECT_EQ(steepest.size(), triangles);
}

/// If it is more than a root, nothing is known of lower ends: (√y − ρ)² is no bound then.
TEST(Boxes, AsLargeAsARootHaveNoLowerEnd) {
  Document document = box_of_one_row();
  const RootDistances distance_of(document.net);
  const certify::Real root = std::sqrt(certify::Real{document.at_most[0].below});
  const certify::Real to_root = root / distance_of(*document.box).value / 100;
  double& least = document.at_most[0].count == 0 ? document.eigenvalues[0].in.lower : document.next;
  document.eigenvalues[0].in.upper = 100;
  for (const double times : {1.001, 1.5, 3.0}) {
    document.box->radius = std::to_string(static_cast<double>(times * to_root));
    least = 0;
    EXPECT_EQ(outcome(document), "VERIFIED") << times;
    least = static_cast<double>(std::pow((times - 1) * root, 2)) / 2;
    EXPECT_EQ(outcome(document), "REFUTED: enclosures") << times;
  }
  document.box->radius = std::to_string(static_cast<double>(0.9 * to_root));
  least = document.at_most[0].below / 101;
  EXPECT_EQ(outcome(document), "VERIFIED");
}

TEST(Boxes, MoveNumbersOutward) {
  EXPECT_EQ(certify::least_beside(4, 1), 1);
  EXPECT_EQ(certify::greatest_beside(4, 1), 9);
  EXPECT_EQ(certify::least_beside(4, 2), 0);
  EXPECT_EQ(certify::least_beside(4, 3), 0);
  std::minstd_rand random(1);
  const auto next = [&] { return static_cast<double>(random()) / std::minstd_rand::max(); };
  for (int trial = 0; trial < 1000; ++trial) {
    const double x = next();
    const double distance = next();
    EXPECT_EQ(certify::least_beside(x, 0), x);
    EXPECT_EQ(certify::greatest_beside(x, 0), x);
    // In 256 bits.
    const certify::Precision scope(256);
    const certify::Ball root = sqrt(certify::Ball::exactly(x));
    const certify::Ball moved = certify::Ball::exactly(distance);
    const certify::Ball least = root - moved;
    const bool is_left = certainly_less(certify::Ball(), least) == certify::Tri::yes;
    EXPECT_EQ(certify::least_beside(x, distance), is_left ? lower_end(sqr(least)) : 0) << x << ' ' << distance;
    EXPECT_EQ(certify::greatest_beside(x, distance), upper_end(sqr(root + moved))) << x << ' ' << distance;
  }
}

/// Six directions are two groups.
TEST(Boxes, OfGenus3HaveTheDistanceOfTheLemma) {
  Document document = klein(Phases(168, "0"));
  const certify::SurfaceSides sides(document.net.surface);
  document.side_order.resize(84);
  document.vertex_order.resize(24);
  std::iota(document.side_order.begin(), document.side_order.end(), 0U);
  std::iota(document.vertex_order.begin(), document.vertex_order.end(), 0U);
  document.at_most = {{1, 1, 2}};
  document.at_least = {{0.1, 1}};
  document.eigenvalues = {{{0, 1}, 1}};
  const RootDistances distance_of(document.net);
  std::minstd_rand random(1);
  for (int trial = 0; trial < 4; ++trial) {
    document.box = {.radius = "1/1000", .directions = {}};
    for (std::uint32_t k = 0; k < 6; ++k) {
      // What leads from a tile to another one.
      Document::Direction& direction = document.box->directions.emplace_back();
      for (std::uint32_t s = 0; s < 168; ++s)
        direction.steps.push_back((sides.tile[s] == k) - (sides.tile[sides.partner[s]] == k));
      for (std::size_t v = 0; v < document.net.vertices.size(); ++v)
        direction.heights.push_back(static_cast<double>(random() % 1000) / 1000);
    }
    expect_distance(document, distance_of(*document.box).value);
  }
}

TEST(Boxes, OfHugeHeightsAreUndecided) {
  EXPECT_EQ(changed_box([](auto& b) { b.directions[1].heights[0] = 1e307; }), "REFUTED: enclosures");
  EXPECT_EQ(changed_box([](auto& b) {
              b.directions[1].heights[0] = 1e307;
              b.radius = "100";
            }),
            "UNDECIDED: box");
}

TEST(Boxes, HaveStepsOfHomomorphisms) {
  const certify::SurfaceSides sides(box().net.surface);
  for (std::uint32_t s = 0; s < 8; ++s) {
    EXPECT_EQ(changed_box([&](auto& b) { ++b.directions[s % 4].steps[s]; }), "REFUTED: box") << s;
    EXPECT_EQ(changed_box([&](auto& b) { --b.directions[s % 4].steps[s]; }), "REFUTED: box") << s;
    EXPECT_EQ(changed_box([&](auto& b) {
                ++b.directions[s % 4].steps[s];
                ++b.directions[s % 4].steps[sides.partner[s]];
              }),
              "REFUTED: box")
        << s;
  }
  Document document = box();
  ++document.box->directions[2].steps[3];
  EXPECT_EQ(message(document), "box.directions[2]: the steps of side 3 of tile 0 and its partner do not add up to 0");
}

TEST(Boxes, HaveStepsOfHomomorphismsAroundVertices) {
  Document document = klein(Phases(168, "0"));
  const certify::SurfaceSides sides(document.net.surface);
  const auto with = [&](const std::vector<std::int64_t>& steps) {
    document.box = {.radius = "1e-9", .directions = {{steps, std::vector<double>(document.net.vertices.size(), 0)}}};
    return outcome(document);
  };
  // What leads from tile 3 to another one.
  std::vector<std::int64_t> steps(168, 0);
  for (std::uint32_t s = 0; s < 168; ++s) {
    if (sides.tile[s] == 3) ++steps[s];
    if (sides.tile[sides.partner[s]] == 3) --steps[s];
  }
  EXPECT_EQ(with(steps), "VERIFIED");
  for (const std::uint32_t first : sides.vertices()) {
    std::vector<std::int64_t> wrong = steps;
    ++wrong[first];
    --wrong[sides.partner[first]];
    EXPECT_EQ(with(wrong), "REFUTED: box");
    EXPECT_NE(message(document).find("across the sides around vertex"), std::string::npos) << message(document);
  }
}

TEST(Boxes, AreOfPhases) {
  Document document = box();
  document.phases.clear();
  EXPECT_EQ(outcome(document), "MALFORMED");
}

TEST(Boxes, HaveAStepForEachSideAndAHeightForEachVertex) {
  for (const char* radius : {"0", "-1", "0.0", "x", "", "1/0"})
    EXPECT_EQ(changed_box([&](auto& b) { b.radius = radius; }), "MALFORMED") << radius;
  EXPECT_EQ(changed_box([](auto& b) { b.directions[3].steps.pop_back(); }), "MALFORMED");
  EXPECT_EQ(changed_box([](auto& b) { b.directions[3].steps.push_back(0); }), "MALFORMED");
  EXPECT_EQ(changed_box([](auto& b) { b.directions[0].heights.pop_back(); }), "MALFORMED");
  EXPECT_EQ(changed_box([](auto& b) { b.directions[0].heights.push_back(0); }), "MALFORMED");
  EXPECT_EQ(changed_box([](auto& b) { b.directions.push_back(b.directions[0]); }), "MALFORMED");
  const auto with_step = [](std::int64_t step) {
    return changed_box([&](auto& b) {
      for (auto& direction : b.directions) {
        direction.steps = {step, 0, 0, 0, -step, 0, 0, 0};
        std::fill(direction.heights.begin(), direction.heights.end(), 0);
      }
    });
  };
  EXPECT_EQ(with_step(1'000'000), "REFUTED: enclosures");
  EXPECT_EQ(with_step(1'000'001), "MALFORMED");
  EXPECT_EQ(with_step(-1'000'001), "MALFORMED");
  for (std::uint32_t s = 0; s < 8; ++s) {
    for (const std::int64_t step : {1'000'001, -1'000'001})
      EXPECT_EQ(changed_box([&](auto& b) { b.directions[2].steps[s] = step; }), "MALFORMED") << s;
  }
  for (const double height : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    Document document = box();
    document.box->directions[1].heights.back() = height;
    EXPECT_EQ(message(document), "box.directions[1]: a height is not finite");
  }
}

}  // namespace
}  // namespace epsnet::exact::second_checker_sections_test
