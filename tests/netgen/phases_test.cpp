#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>
#include <rapidcheck/gtest.h>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "certify/net/numbering.h"
#include "netgen/eigenvalues/eigenvalues.h"
#include "netgen/eigenvalues/elements.h"
#include "netgen/isometries/isometries.h"
#include "netgen/nets/certified_net.h"
#include "netgen/pictures/pictures.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"

/// Phases of the sides of a surface that are a character of its group; eigenvalues with them: matrices, enclosures,
/// bands.
namespace epsnet::phases_test {
namespace {

using certify::EigenvaluesDocument;
using certify::Interval;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

Surface octagon() { return random_octagon(5); }
Surface bolza() { return Surface::regular(2); }
/// Genus 3, of 24 heptagons, three of which meet at each vertex.
Surface klein() { return named_surface("klein"); }
Surface of_genus(std::uint32_t genus) {
  FenchelNielsenRequest request;
  request.genus = genus;
  request.seed = 1;
  return fenchel_nielsen_surface(resolve(request));
}

TorusPoint point(const std::vector<std::string>& turns) {
  TorusPoint result;
  for (const std::string& text : turns) result.push_back(parse_turns(text));
  return result;
}
/// With one phase that is not 0, by default the first one.
TorusPoint one_phase(const Surface& surface, const Rational& turns, std::size_t which = 0) {
  TorusPoint result(2 * surface.genus(), Rational(0));
  result[which] = turns;
  return result;
}
TorusPoint times(const TorusPoint& of, int factor) {
  TorusPoint result;
  for (const Rational& turns : of) result.push_back(factor * turns);
  return result;
}

// Characters.

const std::vector<std::pair<std::string, Surface>>& surfaces() {
  static const std::vector<std::pair<std::string, Surface>> result{
      {"octagon", octagon()},
      {"Bolza", bolza()},
      {"Klein", klein()},
      {"genus 4", of_genus(4)},
      {"cover", cover(octagon(), random_sheets(octagon(), 3, 1))}};
  return result;
}

std::vector<Rational> any_point(const Surface& surface) {
  std::vector<Rational> result;
  for (std::uint32_t i = 0; i < 2 * surface.genus(); ++i)
    result.push_back(Rational(*rc::gen::inRange(-40, 40)) / *rc::gen::inRange(1, 12));
  return result;
}

bool is_whole(const Rational& x) { return denominator(x) == 1; }

/// What makes phases of sides a homomorphism of the group: its relations are those of glued sides and of vertices.
RC_GTEST_PROP(Characters, ArePhasesWithWholeSumsOnGluedSidesAndAroundVertices, ()) {
  const auto& [name, surface] = surfaces()[*rc::gen::inRange<std::size_t>(0, surfaces().size())];
  const ById<SideId, Rational> phases = phases_of_sides(surface, any_point(surface));
  for (const SideId side : phases.ids()) {
    RC_ASSERT(is_whole(phases[side] + phases[surface.partner(side)]));
    RC_ASSERT(phases[side] > Rational(-1, 2) && phases[side] <= Rational(1, 2));
    Rational around = 0;
    for (const SideId crossed : surface.corner_cycle(side)) around += phases[crossed];
    RC_ASSERT(is_whole(around));
  }
}

/// And there are no others: 2g phases can be any, and determine all.
RC_GTEST_PROP(Characters, HaveTheGivenPhasesOnTheirSides, ()) {
  const auto& [name, surface] = surfaces()[*rc::gen::inRange<std::size_t>(0, surfaces().size())];
  const std::vector<Rational> turns = any_point(surface);
  const ById<SideId, Rational> phases = phases_of_sides(surface, turns);
  const std::vector<SideId> sides = character_sides(surface);
  RC_ASSERT(sides.size() == turns.size());
  for (std::size_t i = 0; i < sides.size(); ++i) RC_ASSERT(is_whole(phases[sides[i]] - turns[i]));
}

TEST(Characters, HaveTheFirstSidesOfThePairsOfAPolygonOfOneVertex) {
  EXPECT_THAT(character_sides(bolza()), ElementsAre(SideId(0), SideId(1), SideId(2), SideId(3)));
  const Surface surface = octagon();
  const PolygonSides polygon = polygon_sides(surface);
  ASSERT_EQ(polygon.relations.size(), 1U);
  std::vector<SideId> first;
  for (std::uint32_t k = 0; k < polygon.side.size(); ++k)
    if (k < polygon.partner[k]) first.push_back(polygon.side[k]);
  EXPECT_EQ(character_sides(surface), first);
}

TEST(Characters, HaveNoPhasesInsideOfThePolygon) {
  const Surface surface = klein();
  const PolygonSides polygon = polygon_sides(surface);
  ASSERT_GT(polygon.relations.size(), 1U);
  const std::set<SideId> outside(polygon.side.begin(), polygon.side.end());
  const ById<SideId, Rational> phases = phases_of_sides(surface, point({"1/3", "1/5", "1/7", "1/9", "1/11", "1/13"}));
  for (const SideId side : phases.ids()) {
    if (!outside.contains(side)) {
      EXPECT_EQ(phases[side], 0) << to_string(side);
    }
  }
}

TEST(Characters, AreReducedToHalfATurn) {
  const ById<SideId, Rational> phases = phases_of_sides(bolza(), point({"4/3", "-1/2", "-0.75", "7"}));
  const std::vector<Rational> expected{Rational(1, 3),  Rational(1, 2), Rational(1, 4),  Rational(0),
                                       Rational(-1, 3), Rational(1, 2), Rational(-1, 4), Rational(0)};
  EXPECT_EQ(std::vector<Rational>(phases.begin(), phases.end()), expected);
  EXPECT_EQ(phase_of_word(phases, {0, 0}), static_cast<double>(Rational(-1, 3)));
  EXPECT_EQ(phase_of_word(phases, {0, 2, 4}), 0.25);
  EXPECT_EQ(phase_of_word(phases, {}), 0);
}

TEST(Characters, OfAnotherNumberOfPhasesAreRefused) {
  EXPECT_THAT([] { (void)phases_of_sides(bolza(), point({"1/2"})); },
              ThrowsMessage<CharacterError>("1 phase found, expected 4, those of the sides 0, 1, 2, 3"));
  EXPECT_THAT(
      [] {
        (void)phases_of_sides(klein(), point({"0", "0", "0", "0"}));
      },
      ThrowsMessage<CharacterError>(HasSubstr("4 phases found, expected 6, those of the sides ")));
  EXPECT_EQ(phases_of_sides(bolza(), point({"1e-18", "0", "0.5", "0"}))[SideId(0)].str(), "1/1000000000000000000");
  for (const auto& turns : {point({"0", "1e-19", "0", "0"}), point({"1e-18", "1/3", "0", "0"})}) {
    EXPECT_THAT([&] { (void)phases_of_sides(bolza(), turns); },
                ThrowsMessage<CharacterError>("the phases are not multiples of 1/n for any n of at most 10^18"));
  }
  const std::vector<std::string> texts{"", "x", "1/0", "0,5", "inf", "1/3/4", " 1", std::string(41, '1')};
  for (const std::string& text : texts) {
    EXPECT_THAT([&] { (void)parse_turns(text); },
                ThrowsMessage<CharacterError>(HasSubstr("expected a phase in turns, a decimal or a fraction")));
  }
}

// Matrices.

using Hermitian = Eigen::MatrixXcd;

Hermitian whole(const Eigen::SparseMatrix<double>& real, const Eigen::SparseMatrix<double>& imaginary) {
  const std::complex<double> i(0, 1);
  Hermitian half = Eigen::MatrixXd(real).cast<std::complex<double>>();
  if (imaginary.size() > 0) half += i * Eigen::MatrixXd(imaginary).cast<std::complex<double>>();
  return half.selfadjointView<Eigen::Lower>();
}

std::vector<double> turns_of(const certify::NetDocument& net, const ById<SideId, Rational>& phases) {
  std::vector<double> result{0};
  for (const auto& label : net.labels) result.push_back(phase_of_word(phases, label.word));
  return result;
}

/// The matrices of all eigenvalues by Eigen's dense method.
std::vector<double> dense_eigenvalues(const ElementMatrices& matrices) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Hermitian> solver(whole(matrices.energy, matrices.imaginary_energy),
                                                                   whole(matrices.mass, matrices.imaginary_mass));
  return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

TEST(PhasedElements, HaveTheEigenvaluesOfTheDenseMatrices) {
  for (const auto& [name, surface] : surfaces()) {
    for (const Rational& turns : {Rational(0), Rational(1, 2), Rational(1, 3), Rational(1, 4)}) {
      const certify::NetDocument net = compute_net(surface, Length("1")).document;
      TorusPoint character = one_phase(surface, turns);
      character.back() = 2 * turns;
      // Dense matrices of more rows take long.
      const std::uint32_t halvings = net.triangles.size() < 30 ? 1 : 0;
      const Elements elements(NetGeometry(net), halvings, turns_of(net, phases_of_sides(surface, character)));
      for (const ElementMatrices& matrices : {elements.lower(), elements.upper()}) {
        EXPECT_EQ(matrices.is_real(), is_whole(2 * turns)) << name << ' ' << turns;
        const std::vector<double> expected = dense_eigenvalues(matrices);
        const std::vector<std::uint32_t> order = elimination_order(matrices.energy);
        const DiscreteSpectrum found = first_eigenvalues(matrices, order, 8);
        ASSERT_EQ(found.values.size(), 8U);
        for (std::size_t k = 0; k < 8; ++k) EXPECT_NEAR(found.values[k], expected[k], 1e-6) << name << ' ' << turns;
        for (std::size_t k = 1; k < 8; ++k) {
          if (expected[k] - expected[k - 1] < 1e-3) continue;
          const double between = (expected[k] + expected[k - 1]) / 2;
          for (const auto bound : {certify::Bound::lower, certify::Bound::upper})
            EXPECT_EQ(inertia(matrices, order, between, bound, 1).negative, k) << name << ' ' << turns;
        }
      }
    }
  }
}

/// One vertex: both ends of each side are the same.
TEST(PhasedElements, OfANetOfOneVertexHaveTheEigenvaluesOfTheDenseMatrices) {
  const Surface surface = octagon();
  const certify::NetDocument net = compute_net(surface, Length("3")).document;
  ASSERT_EQ(net.vertices.size(), 1U);
  const std::vector<double> turns = turns_of(net, phases_of_sides(surface, point({"1/3", "1/5", "0", "1/7"})));
  // f is the function of one value, so its energy is positive; it is the same of the matrix that is halved.
  const ElementMatrices once = Elements(NetGeometry(net), 0, turns).upper();
  EXPECT_TRUE(once.is_real());
  EXPECT_GT(once.energy.coeff(0, 0), 0);
  double before = once.energy.coeff(0, 0) / once.mass.coeff(0, 0);
  for (const std::uint32_t halvings : {1U, 2U, 3U}) {
    const double least = dense_eigenvalues(Elements(NetGeometry(net), halvings, turns).upper()).front();
    EXPECT_LT(least, before);
    before = least;
  }
  const EigenvaluesDocument document =
      unproved::eigenvalues(surface, {.count = 1, .digits = 2, .phases = point({"1/3", "1/5", "0", "1/7"})});
  EXPECT_NEAR(before / document.eigenvalues.front().in.upper, 1, 0.1);
}

TEST(PhasedElements, WithoutPhasesAreThoseOfFunctions) {
  const certify::NetDocument net = compute_net(klein(), Length("1")).document;
  const NetGeometry geometry(net);
  const std::vector<double> zeros(net.labels.size() + 1, 0.0);
  for (const std::uint32_t halvings : {0U, 2U}) {
    const ElementMatrices with = Elements(geometry, halvings, zeros).lower();
    const ElementMatrices without = Elements(geometry, halvings).lower();
    EXPECT_TRUE(with.is_real());
    EXPECT_EQ((with.energy - without.energy).norm(), 0);
    EXPECT_EQ((with.mass - without.mass).norm(), 0);
  }
}

// Eigenvalues.

void expect_verified(const EigenvaluesDocument& document) {
  const certify::Certificate certificate = certify::check(document, {.threads = 2, .max_work = 100'000'000'000});
  EXPECT_EQ(certificate.verdict, certify::Verdict::verified) << certify::verdict_line(certificate);
}

/// One interval for each eigenvalue.
std::vector<Interval> intervals(const EigenvaluesDocument& document) {
  std::vector<Interval> result;
  for (const auto& [in, count] : document.eigenvalues) result.insert(result.end(), count, in);
  return result;
}

/// The kth eigenvalue of one list may be the kth one of the other, for all that both have.
void expect_equal(std::vector<Interval> one, std::vector<Interval> other, const std::string& what) {
  const auto ends = [](const std::vector<Interval>& list, double Interval::*end) {
    std::vector<double> result;
    for (const Interval& in : list) result.push_back(in.*end);
    std::sort(result.begin(), result.end());
    return result;
  };
  const std::size_t count = std::min(one.size(), other.size());
  for (std::size_t k = 0; k < count; ++k) {
    EXPECT_LE(ends(one, &Interval::lower)[k], ends(other, &Interval::upper)[k]) << what << ' ' << k;
    EXPECT_LE(ends(other, &Interval::lower)[k], ends(one, &Interval::upper)[k]) << what << ' ' << k;
  }
}

/// The cover of degree n on which χ, of order n, is trivial: crossing a side leads from sheet i to sheet i + nθ.
Surface cyclic_cover(const Surface& surface, const TorusPoint& turns, int n) {
  const PolygonSides polygon = polygon_sides(surface);
  const ById<SideId, Rational> phases = phases_of_sides(surface, turns);
  std::vector<Permutation> sheets;
  for (std::uint32_t k = 0; k < polygon.side.size(); ++k) {
    if (k > polygon.partner[k]) continue;
    const auto shift = static_cast<int>(numerator(Rational(n * phases[polygon.side[k]])));
    Permutation& permutation = sheets.emplace_back();
    for (int i = 0; i < n; ++i) permutation.push_back(static_cast<std::uint32_t>(((i + shift) % n + n) % n));
  }
  return cover(surface, sheets);
}

/// Functions on the cover are sums of one with the phases of each power of χ, of order n.
void expect_those_of_a_cover(const std::string& name, const Surface& surface, int n) {
  TorusPoint turns = one_phase(surface, Rational(1, n));
  turns[1] = Rational(-1, n);
  turns.back() = Rational(1, n);
  std::vector<Interval> of_powers;
  double next = HUGE_VAL;
  for (int power = 0; power < n; ++power) {
    const EigenvaluesDocument document =
        unproved::eigenvalues(surface, {.count = 6, .digits = 2, .phases = times(turns, power)});
    expect_verified(document);
    const std::vector<Interval> found = intervals(document);
    of_powers.insert(of_powers.end(), found.begin(), found.end());
    next = std::min(next, document.next);
  }
  const EigenvaluesDocument cover = unproved::eigenvalues(cyclic_cover(surface, turns, n), {.count = 8, .digits = 2});
  expect_verified(cover);
  std::vector<Interval> of_cover{{0, 0}};
  for (const Interval& in : intervals(cover)) of_cover.push_back(in);
  // Not more than all powers are known to have.
  std::erase_if(of_cover, [&](const Interval& in) { return in.upper >= next; });
  EXPECT_GE(of_cover.size(), 3U) << name << ' ' << n;
  expect_equal(of_powers, of_cover, name + " " + std::to_string(n));
}

TEST(PhasedEigenvalues, OfAllPowersAreThoseOfACyclicCover) {
  for (const int n : {2, 3}) {
    expect_those_of_a_cover("octagon", octagon(), n);
    expect_those_of_a_cover("Bolza", bolza(), n);
  }
}

TEST(DeepPhasedEigenvalues, OfAllPowersAreThoseOfACyclicCover) {
  for (const int n : {2, 3}) expect_those_of_a_cover("genus 3", of_genus(3), n);
  for (const int n : {2, 3, 5}) expect_those_of_a_cover("Klein", klein(), n);
  expect_those_of_a_cover("octagon", octagon(), 5);
  expect_those_of_a_cover("Bolza", bolza(), 5);
}

TEST(PhasedEigenvalues, WithoutPhasesAreThoseOfFunctionsAndZero) {
  const EigenvaluesDocument with =
      unproved::eigenvalues(bolza(), {.count = 8, .digits = 2, .phases = one_phase(bolza(), 3)});
  EXPECT_THAT(with.phases, ElementsAre("0", "0", "0", "0", "0", "0", "0", "0"));
  expect_verified(with);
  const EigenvaluesDocument without = unproved::eigenvalues(bolza(), {.count = 7, .digits = 2});
  EXPECT_TRUE(without.phases.empty());
  ASSERT_EQ(with.eigenvalues.size(), 3U);
  EXPECT_EQ(with.eigenvalues.front().count, 1U);
  EXPECT_EQ(with.eigenvalues.front().in.lower, 0);
  EXPECT_LT(with.eigenvalues.front().in.upper, 2e-6);
  for (std::size_t row = 0; row < 2; ++row) EXPECT_EQ(with.eigenvalues[row + 1].count, without.eigenvalues[row].count);
  std::vector<Interval> known = intervals(without);
  known.push_back({0, 0});
  expect_equal(intervals(with), known, "Bolza");
}

TEST(PhasedEigenvalues, OfConjugatePhasesAreTheSame) {
  for (const Surface& surface : {octagon(), klein()}) {
    TorusPoint turns = one_phase(surface, Rational(1, 5));
    turns.back() = Rational(2, 7);
    const EigenvaluesDocument one = unproved::eigenvalues(surface, {.count = 4, .digits = 2, .phases = turns});
    const EigenvaluesDocument other =
        unproved::eigenvalues(surface, {.count = 4, .digits = 2, .phases = times(turns, -1)});
    EXPECT_NE(one.phases, other.phases);
    EXPECT_EQ(intervals(one).size(), intervals(other).size());
    expect_equal(intervals(one), intervals(other), "conjugate");
    EXPECT_EQ(one.side_order, other.side_order);
  }
}

/// The rotation by a corner of the regular 4g-gon takes side k to side k + 1, and side 2g has the phase −θ₀.
TEST(PhasedEigenvalues, OfARegularPolygonAreTheSameForPhasesThatAreRotated) {
  for (const std::uint32_t genus : {2U, 3U}) {
    const Surface surface = Surface::regular(genus);
    TorusPoint turns = one_phase(surface, Rational(1, 3));
    turns[1] = Rational(1, 5);
    turns.back() = Rational(1, 7);
    TorusPoint rotated{Rational(-turns.back())};
    rotated.insert(rotated.end(), turns.begin(), turns.end() - 1);
    const EigenvaluesDocument one = unproved::eigenvalues(surface, {.count = 4, .phases = turns});
    const EigenvaluesDocument other = unproved::eigenvalues(surface, {.count = 4, .phases = rotated});
    expect_equal(intervals(one), intervals(other), "rotated");
    // It matters: other phases have other eigenvalues.
    std::swap(rotated[0], rotated[1]);
    const EigenvaluesDocument different = unproved::eigenvalues(surface, {.count = 4, .phases = rotated});
    EXPECT_TRUE(intervals(different)[0].lower > intervals(one)[0].upper ||
                intervals(different)[0].upper < intervals(one)[0].lower);
  }
}

/// The character of a group that an isometry makes of another one: χ ∘ f on the sides of character_sides.
TorusPoint moved(const Surface& surface, const TorusPoint& point, const SurfaceIsometry& f) {
  const std::vector<Word> generators = generator_words(surface);
  const ById<SideId, Rational> phases = phases_of_sides(surface, point);
  const auto phase = [&](const ById<SideId, Rational>& of_sides, const Word& word) {
    Rational sum = 0;
    for (const SideId side : word) sum += of_sides[side];
    return sum;
  };
  TorusPoint result;
  for (std::size_t k = 0; k < point.size(); ++k) {
    // A generator that crosses the side, or its partner, and no other one that has a phase.
    const ById<SideId, Rational> unit = phases_of_sides(surface, one_phase(surface, Rational(1, 7), k));
    const SideId side = character_sides(surface)[k];
    for (std::size_t i = 0; i < generators.size(); ++i) {
      const Word& word = generators[i];
      const bool crosses =
          std::count(word.begin(), word.end(), side) + std::count(word.begin(), word.end(), surface.partner(side)) == 1;
      if (!crosses) continue;
      const Rational sign = 7 * phase(unit, word);
      result.push_back(sign * phase(phases, f.images[i]));
    }
    EXPECT_EQ(result.size(), k + 1);
  }
  return result;
}

/// An isometry takes functions with phases to functions with others.
TEST(PhasedEigenvalues, AreTheSameForPhasesThatAnIsometryMoves) {
  for (const auto& [name, surface] : {std::pair("Bolza", bolza()), std::pair("octagon", octagon())}) {
    TorusPoint turns = one_phase(surface, Rational(1, 3));
    turns[1] = Rational(1, 5);
    turns[2] = Rational(2, 7);
    const EigenvaluesDocument one = unproved::eigenvalues(surface, {.count = 4, .digits = 2, .phases = turns});
    const IsometryGroup group = isometries(surface);
    ASSERT_FALSE(group.generators().empty());
    for (const std::uint32_t g : group.generators()) {
      const TorusPoint other_turns = moved(surface, turns, group.isometry(g));
      const EigenvaluesDocument other =
          unproved::eigenvalues(surface, {.count = 4, .digits = 2, .phases = other_turns});
      EXPECT_NE(other.phases, one.phases) << name << ' ' << g;
      expect_equal(intervals(one), intervals(other), name + (" " + std::to_string(g)));
    }
  }
}

/// λ₀(χ) is the square of the distance from χ = 1 in the norm of harmonic forms, up to higher terms: 4π²E(h)/area for
/// the function h of least energy that increases by the phases.
TEST(PhasedEigenvalues, GrowAsTheEnergyOfHarmonicFunctionsFromOneOn) {
  const Surface surface = octagon();
  const certify::NetDocument net = compute_net(surface, Length("0.1")).document;
  const NetGeometry geometry(net);
  const std::vector<int> along{1, 2, 0, 1};
  const EigenvaluesDocument::Box box = CharacterDirections(surface, geometry).box(Rational(1, 100));
  // Energy is that of the Euclidean triangles with the corners in the disk, as angles are.
  double energy = 0;
  for (std::uint32_t t = 0; t < net.triangles.size(); ++t) {
    const auto z = geometry.corners(t);
    std::array<double, 3> h{};
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        double height = box.directions[k].heights[certify::start(net, 3 * t + i)];
        const std::uint32_t label = certify::corner_label(net, 3 * t + i);
        if (label > 0) {
          for (const std::uint32_t side : net.labels[label - 1].word)
            height += static_cast<double>(box.directions[k].steps[side]);
        }
        h[i] += along[k] * height;
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::complex<double> a(z[(i + 1) % 3].x - z[i].x, z[(i + 1) % 3].y - z[i].y);
      const std::complex<double> b(z[(i + 2) % 3].x - z[i].x, z[(i + 2) % 3].y - z[i].y);
      const std::complex<double> quotient = b / a;
      energy += quotient.real() / quotient.imag() / 2 * std::pow(h[(i + 1) % 3] - h[(i + 2) % 3], 2);
    }
  }
  const double half_of_second_derivative = 4 * M_PI * M_PI * energy / (4 * M_PI);
  for (const int part : {100, 50}) {
    const Rational t = Rational(1) / part;
    const EigenvaluesDocument document =
        unproved::eigenvalues(surface, {.count = 1, .digits = 2, .phases = {t, Rational(2 * t), Rational(0), t}});
    const Interval in = document.eigenvalues.front().in;
    EXPECT_NEAR((in.lower + in.upper) / 2 * part * part / half_of_second_derivative, 1, 0.02) << part;
  }
}

// Boxes of phases.

/// Of all characters in the box, the corners included.
TEST(Boxes, ContainTheEigenvaluesOfAllCharactersInThem) {
  for (const auto& [name, surface] :
       {std::pair("octagon", octagon()), std::pair("Bolza", bolza()), std::pair("Klein", klein())}) {
    const Rational radius(1, 60);
    TorusPoint centre = one_phase(surface, Rational(1, 3));
    centre.back() = Rational(1, 5);
    const EigenvaluesDocument box =
        unproved::eigenvalues(surface, {.count = 3, .digits = 2, .phases = centre, .box = radius});
    expect_verified(box);
    std::minstd_rand random(1);
    for (int trial = 0; trial < 6; ++trial) {
      TorusPoint point = centre;
      for (Rational& turns : point) {
        const int part = trial < 3 ? 2 * static_cast<int>(random() % 2) - 1 : static_cast<int>(random() % 21) - 10;
        turns += radius * (trial < 3 ? Rational(part) : Rational(part, 10));
      }
      const std::vector<Interval> there =
          intervals(unproved::eigenvalues(surface, {.count = 3, .digits = 2, .phases = point}));
      expect_equal(intervals(box), there, name + (" " + std::to_string(trial)));
      const std::size_t count = intervals(box).size();
      if (there.size() > count) {
        EXPECT_GE(there[count].upper, box.next) << name;
      }
    }
  }
}

/// Intervals are wider by what the slopes say, and no more.
TEST(Boxes, AreAsWideAsTheirRadius) {
  const Surface surface = octagon();
  const TorusPoint centre = one_phase(surface, Rational(1, 3));
  const EigenvaluesDocument alone = unproved::eigenvalues(surface, {.count = 2, .digits = 2, .phases = centre});
  EXPECT_FALSE(alone.box.has_value());
  const NetGeometry geometry(alone.net);
  const CharacterDirections directions(surface, geometry);
  for (const Rational& radius : {Rational(1, 1000), Rational(1, 50), Rational(1, 2)}) {
    const EigenvaluesDocument box =
        unproved::eigenvalues(surface, {.count = 2, .digits = 2, .phases = centre, .box = radius});
    ASSERT_TRUE(box.box.has_value());
    EXPECT_EQ(box.box->radius, radius.str());
    EXPECT_EQ(box.box->directions.size(), 4U);
    const double distance = directions.distance(radius);
    EXPECT_GT(distance, static_cast<double>(radius));  // h increases by 1 along loops shorter than 2π.
    EXPECT_LT(distance, 20 * static_cast<double>(radius));
    for (std::size_t row = 0; row < alone.eigenvalues.size(); ++row) {
      EXPECT_NEAR(std::sqrt(box.eigenvalues[row].in.upper), std::sqrt(alone.eigenvalues[row].in.upper) + distance,
                  1e-8);
      EXPECT_NEAR(std::sqrt(box.eigenvalues[row].in.lower),
                  std::max(0.0, std::sqrt(alone.eigenvalues[row].in.lower) - distance), 1e-8);
    }
    EXPECT_NEAR(std::sqrt(box.next), std::max(0.0, std::sqrt(alone.next) - distance), 1e-8);
    expect_verified(box);
  }
}

TEST(Boxes, CountWhatIsBelowANumber) {
  const EigenvaluesDocument document = unproved::eigenvalues(
      bolza(), {.below = 0.5, .phases = one_phase(bolza(), Rational(1, 2)), .box = Rational(1, 100)});
  expect_verified(document);
  EXPECT_EQ(document.eigenvalues.size(), 0U);
  EXPECT_GT(document.next, 0.3);
  EXPECT_LT(document.next, 0.5);
  // The count is one in the centre.
  EXPECT_EQ(eigenvalues_below(document, 0.5).most, std::nullopt);
  EXPECT_EQ(eigenvalues_below(document, document.next).most, 0U);
  for (const EigenvaluesPicture::Step& step : picture_of(document).most) EXPECT_LE(step.lambda, document.next);
}

TEST(Boxes, AreAroundPhasesAndNotMoreThanHalfATurnWide) {
  const auto with = [](TorusPoint phases, const Rational& radius) {
    return [=] { (void)unproved::eigenvalues(bolza(), {.count = 1, .phases = phases, .box = radius}); };
  };
  EXPECT_THAT(with({}, Rational(1, 10)), ThrowsMessage<std::invalid_argument>("box is given without phases"));
  for (const Rational& radius : {Rational(0), Rational(-1, 10), Rational(51, 100)}) {
    EXPECT_THAT(with(one_phase(bolza(), Rational(1, 2)), radius),
                ThrowsMessage<std::invalid_argument>("box is not more than 0 and at most 1/2"));
  }
}

// The gap: λ₀ away from χ = 1.

TEST(Gap, IsProvedByBoxesThatCoverHalfOfTheTorus) {
  const Surface surface = bolza();
  std::vector<EigenvaluesDocument> boxes;
  std::set<std::size_t> numbers;
  const Rational outside(3, 8);
  const std::size_t count = gap_outside(
      surface, outside, 1e-4, {.epsilon = Length("1"), .each = [&](std::size_t i, const EigenvaluesDocument& document) {
                                 EXPECT_TRUE(numbers.insert(i).second);
                                 boxes.push_back(document);
                               }});
  EXPECT_EQ(count, boxes.size());
  const std::vector<SideId> sides = character_sides(surface);
  const auto contains = [&](const EigenvaluesDocument& box, const std::vector<double>& point) {
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const double away = point[k] - static_cast<double>(Rational(box.phases[sides[k].number()]));
      if (std::abs(away - std::round(away)) > static_cast<double>(Rational(box.box->radius)) + 1e-12) return false;
    }
    return true;
  };
  std::minstd_rand random(1);
  const auto number = [&] { return static_cast<double>(random()) / 2147483646.0 - 0.5; };
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<double> point{number(), number(), number(), number()};
    point[random() % 4] = 0.5 - std::abs(number()) / 4;  // At least 3/8.
    if (point[0] < 0) {
      for (double& turns : point) turns = -turns;
    }
    EXPECT_TRUE(std::any_of(boxes.begin(), boxes.end(), [&](const auto& box) { return contains(box, point); }));
  }
  for (const EigenvaluesDocument& box : boxes) {
    EXPECT_TRUE(box.eigenvalues.empty());
    EXPECT_EQ(box.next, 1e-4);
  }
  expect_verified(boxes.front());
}

TEST(Gap, TakesMoreBoxesForAGreaterBoundAndIsTheSameForAnyNumberOfThreads) {
  const auto boxes = [](double bound, unsigned threads) {
    return gap_outside(bolza(), Rational(7, 16), bound, {.epsilon = Length("1"), .threads = threads});
  };
  EXPECT_EQ(boxes(1e-6, 1), boxes(1e-6, 3));
  EXPECT_LT(boxes(1e-6, 0), boxes(2e-2, 0));
}

TEST(Gap, IsNotProvedWhereThereIsNone) {
  // λ₀ is 0.77 where one phase is a half and all others are 0.
  EXPECT_THAT([] { (void)gap_outside(bolza(), Rational(3, 8), 2, {.epsilon = Length("0.8")}); },
              ThrowsMessage<NetError>(HasSubstr("not proved at the phases ")));
  EXPECT_THAT([] { (void)gap_outside(bolza(), Rational(1, 1000), 1e-6, {.most = 10}); },
              ThrowsMessage<NetError>(HasSubstr("more than 10 boxes")));
}

TEST(Gap, IsOfARadiusAndABoundThatMakeSense) {
  for (const Rational& radius : {Rational(0), Rational(1, 2), Rational(-1, 4)}) {
    EXPECT_THAT([&] { (void)gap_outside(bolza(), radius, 0.1); },
                ThrowsMessage<std::invalid_argument>("radius is not between 0 and 1/2"));
  }
  for (const double bound : {0.0, -1.0, std::nan(""), 1e5}) {
    EXPECT_THAT([&] { (void)gap_outside(bolza(), Rational(1, 4), bound); },
                ThrowsMessage<std::invalid_argument>("bound is not a positive number of at most 10000"));
  }
  EXPECT_THAT([] { (void)gap_outside(of_genus(5), Rational(1, 4), 0.1); }, testing::Throws<LimitError>());
}

/// λ₀(χ) is about a multiple of the square of the distance from χ = 1.
TEST(PhasedEigenvalues, GrowAsTheSquareFromZeroOn) {
  const Surface surface = octagon();
  std::vector<double> quotients;
  for (const int part : {100, 50, 25}) {
    const Rational t = Rational(1) / part;
    const EigenvaluesDocument document =
        unproved::eigenvalues(surface, {.count = 1, .digits = 2, .phases = {t, Rational(2 * t), Rational(0), t}});
    expect_verified(document);
    const Interval in = document.eigenvalues.front().in;
    EXPECT_GT(in.lower, 0);
    quotients.push_back((in.lower + in.upper) / 2 * part * part);
  }
  EXPECT_NEAR(quotients[1] / quotients[0], 1, 0.02);
  EXPECT_NEAR(quotients[2] / quotients[0], 1, 0.03);
}

TEST(PhasedEigenvalues, BelowANumberAreCounted) {
  const TorusPoint turns = one_phase(bolza(), Rational(1, 3));
  const std::vector<Interval> first =
      intervals(unproved::eigenvalues(bolza(), {.count = 4, .digits = 2, .phases = turns}));
  for (const std::size_t count : {0U, 1U, 3U}) {
    const double below = count == 0 ? 0.25 : (first[count - 1].upper + first[count].lower) / 2;
    const EigenvaluesDocument document = unproved::eigenvalues(bolza(), {.below = below, .phases = turns});
    expect_verified(document);
    EXPECT_EQ(eigenvalues_below(document, below).least, count) << below;
    EXPECT_EQ(eigenvalues_below(document, below).most, count) << below;
  }
}

TEST(PhasedEigenvalues, HaveTwoDigitsByDefault) {
  const TorusPoint turns = one_phase(bolza(), Rational(1, 3));
  EXPECT_EQ(unproved::eigenvalues(bolza(), {.count = 2, .phases = turns}),
            unproved::eigenvalues(bolza(), {.count = 2, .digits = 2, .phases = turns}));
}

TEST(PhasedEigenvalues, OfAnotherNumberOfPhasesAreRefused) {
  EXPECT_THAT(
      [] {
        (void)unproved::eigenvalues(klein(), {.phases = point({"0", "0", "0", "0"})});
      },
      ThrowsMessage<CharacterError>(HasSubstr("4 phases found, expected 6, those of the sides ")));
}

TEST(PhasedEigenvalues, OfMoreThanThreeDigitsAreRefused) {
  EXPECT_THAT([] { (void)unproved::eigenvalues(bolza(), {.digits = 4, .phases = one_phase(bolza(), 1)}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("digits is not from 1 to 3")));
  EXPECT_THAT([] { (void)bands(bolza(), {one_phase(bolza(), 1)}, {.digits = 4}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("digits is not from 1 to 3")));
}

TEST(DeepPhasedEigenvalues, OfThreeDigitsAreNarrow) {
  const EigenvaluesDocument document =
      unproved::eigenvalues(bolza(), {.count = 2, .digits = 3, .phases = one_phase(bolza(), Rational(1, 3))});
  expect_verified(document);
  for (const Interval& in : intervals(document)) EXPECT_LT(in.upper - in.lower, 1.1e-3 * in.lower);
}

// Bands.

TEST(Bands, AreTheEigenvaluesAtEachPoint) {
  const std::vector<TorusPoint> points = torus_path({point({"0", "0", "0", "0"}), point({"1/2", "0", "1/4", "0"})}, 3);
  std::vector<EigenvaluesDocument> documents(points.size());
  const auto found =
      bands(bolza(), points,
            {.count = 3, .each = [&](std::size_t i, const EigenvaluesDocument& document) { documents[i] = document; }});
  ASSERT_EQ(found.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_EQ(found[i].size(), 3U);
    const EigenvaluesDocument alone = unproved::eigenvalues(bolza(), {.count = 3, .digits = 2, .phases = points[i]});
    EXPECT_EQ(documents[i].phases, alone.phases);
    EXPECT_EQ(documents[i].net, documents[0].net);
    expect_verified(documents[i]);
    expect_equal(found[i], intervals(alone), std::to_string(i));
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(found[i][k].upper, intervals(documents[i])[k].upper);
      EXPECT_LT(found[i][k].upper - found[i][k].lower, std::max(1e-5, 0.011 * found[i][k].upper));
    }
  }
}

TEST(Bands, AreTheSameForAnyNumberOfThreads) {
  const std::vector<TorusPoint> points = torus_path({point({"0", "0", "0", "0"}), point({"1/2", "0", "1/3", "0"})}, 2);
  EXPECT_EQ(bands(octagon(), points, {.count = 2, .digits = 1, .threads = 1}),
            bands(octagon(), points, {.count = 2, .digits = 1, .threads = 3}));
}

TEST(Bands, OfNoPointsAreNone) { EXPECT_TRUE(bands(bolza(), {}).empty()); }

TEST(Bands, OfPointsThatAreNoneAreRefused) {
  EXPECT_THAT(
      [] {
        (void)bands(bolza(), {point({"0", "0", "0", "0"}), point({"0"})});
      },
      ThrowsMessage<CharacterError>(HasSubstr("1 phase found, expected 4")));
  EXPECT_THROW((void)bands(bolza(), {point({"0", "0", "0", "0"})}, {.count = 0}), std::invalid_argument);
}

TEST(Bands, AreOnPathsWithExactPoints) {
  const std::vector<TorusPoint> path = torus_path({point({"0", "1"}), point({"1/2", "0"}), point({"1/2", "1/7"})}, 3);
  EXPECT_THAT(path, ElementsAre(point({"0", "1"}), point({"1/6", "2/3"}), point({"1/3", "1/3"}), point({"1/2", "0"}),
                                point({"1/2", "1/21"}), point({"1/2", "2/21"}), point({"1/2", "1/7"})));
  EXPECT_THAT(torus_path({point({"1/5"})}, 4), ElementsAre(point({"1/5"})));
  EXPECT_THROW((void)torus_path({}, 1), std::invalid_argument);
  EXPECT_THROW((void)torus_path({point({"0"})}, 0), std::invalid_argument);
  EXPECT_THROW((void)torus_path({point({"0"}), point({"0", "1"})}, 1), std::invalid_argument);
}

TEST(Bands, ArePicturesOfAllIntervals) {
  BandsPicture picture{{{{0, 0.1}, {1, 1.1}}, {{0.2, 0.3}, {1, 1.2}}, {{0, 0.1}, {1, 1.1}}}, {{0, "G"}, {2, "<X>"}}};
  const std::string svg = draw_svg(picture, 500);
  const auto count = [&](const std::string& what) {
    std::size_t result = 0;
    for (std::size_t at = svg.find(what); at != std::string::npos; at = svg.find(what, at + 1)) ++result;
    return result;
  };
  EXPECT_EQ(count("class=\"band\""), 2U);
  EXPECT_EQ(count("class=\"intervals\""), 2U);
  EXPECT_EQ(count(">&lt;X"), 1U);
  EXPECT_EQ(count("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"500\" height=\"310\""), 1U);
  EXPECT_FALSE(draw_svg(BandsPicture{}).empty());
}

// Lattices.

/// Functions at the nodes of a cover are sums of one with the phases of each power of χ.
TEST(Lattice, EigenvaluesOfAllPowersAreThoseOfACyclicCover) {
  for (const auto& [name, surface] : {std::pair("octagon", octagon()), std::pair("Bolza", bolza()),
                                      std::pair("Klein", klein()), std::pair("genus 3", of_genus(3))}) {
    for (const int n : {2, 3, 5}) {
      TorusPoint turns = one_phase(surface, Rational(1, n));
      turns[1] = Rational(-1, n);
      turns.back() = Rational(2, n);
      for (const GraphNodes nodes : {GraphNodes::vertices, GraphNodes::faces}) {
        std::vector<Interval> of_powers;
        for (int power = 0; power < n; ++power) {
          const auto found = eigenvalues(lattice_matrix(surface, nodes, times(turns, power)));
          of_powers.insert(of_powers.end(), found.begin(), found.end());
        }
        const std::vector<Interval> of_cover = eigenvalues(lattice_matrix(cyclic_cover(surface, turns, n), nodes));
        ASSERT_EQ(of_powers.size(), of_cover.size());
        expect_equal(of_powers, of_cover, name + (" " + std::to_string(n)));
      }
    }
  }
}

/// The Möbius–Kantor graph, of the 16 triangles of the map R2.1, and the Klein graphs.
TEST(Lattice, EigenvaluesOfKnownGraphs) {
  const auto expect = [](const std::string& name, GraphNodes nodes, const std::vector<std::pair<double, int>>& known) {
    const auto found = eigenvalues(lattice_matrix(named_surface(name), nodes));
    std::size_t k = 0;
    for (const auto& [value, count] : known) {
      for (int i = 0; i < count; ++i, ++k) {
        ASSERT_LT(k, found.size());
        EXPECT_LE(found[k].lower, value) << name;
        EXPECT_GE(found[k].upper, value) << name;
        EXPECT_LT(found[k].upper - found[k].lower, 1e-8) << name;
      }
    }
    EXPECT_EQ(k, found.size()) << name;
  };
  const double root = std::sqrt(3.0);
  expect("R2.1", GraphNodes::faces, {{-3, 1}, {-root, 4}, {-1, 3}, {1, 3}, {root, 4}, {3, 1}});
  expect("klein", GraphNodes::faces, {{-std::sqrt(7.0), 8}, {-1, 7}, {std::sqrt(7.0), 8}, {7, 1}});
}

/// Another lift of χ to phases, by integers, changes nothing; conjugate phases give the conjugate matrix.
TEST(Lattice, DependsOnTheCharacterAlone) {
  for (const GraphNodes nodes : {GraphNodes::vertices, GraphNodes::faces}) {
    const HermitianMatrix one = lattice_matrix(klein(), nodes, point({"1/3", "0.3", "0", "-1/7", "1/2", "1/4"}));
    const HermitianMatrix same = lattice_matrix(klein(), nodes, point({"4/3", "-0.7", "1", "6/7", "-1/2", "5/4"}));
    const HermitianMatrix conjugate =
        lattice_matrix(klein(), nodes, point({"-1/3", "-0.3", "0", "1/7", "1/2", "-1/4"}));
    ASSERT_EQ(one.entries.size(), same.entries.size());
    ASSERT_EQ(one.entries.size(), conjugate.entries.size());
    for (std::size_t k = 0; k < one.entries.size(); ++k) {
      EXPECT_EQ(one.entries[k].value, same.entries[k].value);
      EXPECT_EQ(std::conj(one.entries[k].value), conjugate.entries[k].value);
      EXPECT_NEAR(std::abs(one.entries[k].value), 1, 1e-15);
    }
    EXPECT_EQ(eigenvalues(one), eigenvalues(conjugate));
  }
}

/// Of one octagon: the sum over its four pairs of sides of 2 cos 2πθ.
TEST(Lattice, OfOneTileIsANumber) {
  const HermitianMatrix matrix = lattice_matrix(bolza(), GraphNodes::faces, point({"1/3", "0", "1/2", "1/8"}));
  ASSERT_EQ(matrix.entries.size(), 1U);
  EXPECT_NEAR(matrix.entries[0].value.real(), -1 + 2 - 2 + std::sqrt(2.0), 1e-14);
  EXPECT_EQ(matrix.entries[0].value.imag(), 0);
  std::ostringstream integers, complex;
  write_matrix_market(lattice_matrix(bolza(), GraphNodes::faces), integers);
  EXPECT_EQ(integers.str(), "%%MatrixMarket matrix coordinate integer symmetric\n1 1 1\n1 1 8\n");
  write_matrix_market({.size = 2, .entries = {{1, 0, {0.5, -2}}}}, complex);
  EXPECT_EQ(complex.str(), "%%MatrixMarket matrix coordinate complex hermitian\n2 2 1\n2 1 0.5 -2\n");
}

/// What is proved allows for the error of the matrix, and for its size.
TEST(Lattice, IntervalsContainTheErrorOfTheMatrix) {
  const HermitianMatrix matrix{.size = 2, .entries = {{0, 0, 1}, {1, 0, {0, 1}}, {1, 1, 1}}, .error = 1e-9};
  const std::vector<Interval> found = eigenvalues(matrix);  // 0 and 2.
  ASSERT_EQ(found.size(), 2U);
  for (const double k : {0, 1}) {
    EXPECT_LE(found[static_cast<std::size_t>(k)].lower, 2 * k - 1e-9);
    EXPECT_GE(found[static_cast<std::size_t>(k)].upper, 2 * k + 1e-9);
    EXPECT_LT(found[static_cast<std::size_t>(k)].upper, 2 * k + 1e-7);
  }
  EXPECT_THROW((void)eigenvalues(HermitianMatrix{.size = 1, .entries = {{0, 0, 1}}, .error = 1e-3}), LimitError);
  EXPECT_THROW((void)eigenvalues(HermitianMatrix{.size = 1501}), LimitError);
  EXPECT_THROW((void)lattice_matrix(bolza(), GraphNodes::faces, point({"1/2"})), CharacterError);
}

}  // namespace
}  // namespace epsnet::phases_test
