#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "netgen/eigenvalues/elements.h"
#include "netgen/nets/certified_net.h"
#include "netgen/surfaces/characters.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"

/// Eigenvalues with phases: matrices, enclosures, bands.
namespace epsnet::phases_test {
namespace {

using TorusPoint = std::vector<Rational>;

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
// Matrices.

const std::vector<std::pair<std::string, Surface>>& surfaces() {
  static const std::vector<std::pair<std::string, Surface>> result{
      {"octagon", octagon()},
      {"Bolza", bolza()},
      {"Klein", klein()},
      {"genus 4", of_genus(4)},
      {"cover", cover(octagon(), random_sheets(octagon(), 3, 1))}};
  return result;
}

bool is_whole(const Rational& x) { return denominator(x) == 1; }

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
      const Elements elements(NetGeometry(net), 1, turns_of(net, phases_of_sides(surface, character)));
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

}  // namespace
}  // namespace epsnet::phases_test
