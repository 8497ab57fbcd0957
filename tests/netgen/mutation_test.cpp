#include <gtest/gtest.h>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>

#include "certify/check.h"
#include "certify/exact/checker.h"
#include "certify/file/file.h"
#include "netgen/exchange/exchange.h"
#include "netgen/exchange/text_formats.h"
#include "netgen/nets/certified_net.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/assurance/file_mutants/mutations.h"
#include "tests/netgen/oracle.h"
#include "tests/support/scale.h"

/// Single random defects in verified nets: `certify` must agree with the oracle, and `certify-exact` with `certify`.
namespace epsnet::mutation_test {
namespace {

using attack::Mutation;
using attack::mutations;
using attack::Random;
using certify::NetDocument;
using certify::Verdict;

std::string written(const NetDocument& net) {
  std::ostringstream out;
  certify::write_file(net, out);
  return out.str();
}

/// The number of mutants by mutation and by outcome.
using Table = std::map<std::string, std::map<std::string, int>>;

void print(const Table& table) {
  const std::vector<const char*> columns{"structure", "surface",  "map",     "gluing",   "orientation",
                                         "delaunay",  "covering", "packing", "verified", "undecided"};
  std::cout << std::left << std::setw(38) << "" << std::right;
  for (const char* c : columns) std::cout << std::setw(12) << c;
  std::cout << '\n';
  for (const auto& [row, counts] : table) {
    std::cout << std::left << std::setw(38) << row << std::right;
    for (const char* c : columns) {
      const auto found = counts.find(c);
      std::cout << std::setw(12) << (found == counts.end() ? std::string(".") : std::to_string(found->second));
    }
    std::cout << '\n';
  }
}

/// Checks one mutant and returns the outcome.
std::string outcome(const NetDocument& mutant, test::Oracle& oracle) {
  const std::string broken = oracle.broken_rule(mutant);
  const certify::Certificate certificate = certify::check(mutant, {.threads = 1, .max_precision = 2048});
  switch (certificate.verdict) {
    case Verdict::verified:
      EXPECT_EQ(broken, "") << "verified, but the oracle says that a rule is broken";
      break;
    case Verdict::refuted:
    case Verdict::malformed:
      EXPECT_EQ(certificate.rule, broken) << certify::name(certificate.verdict) << ": " << certificate.message;
      break;
    case Verdict::undecided:
      break;
  }
  // The second checker agrees, wherever both decide, and names the same rule.
  const exact::Result second = exact::check(written(mutant));
  if (certificate.verdict != Verdict::undecided && second.verdict != exact::Verdict::undecided) {
    EXPECT_EQ(static_cast<int>(second.verdict), static_cast<int>(certificate.verdict)) << second.message;
    EXPECT_EQ(second.rule, certificate.verdict == Verdict::refuted ? certificate.rule : "") << second.message;
  }
  EXPECT_FALSE(second.verdict == exact::Verdict::undecided && certificate.verdict == Verdict::verified)
      << second.rule << ": " << second.message;
  // The reader refuses exactly the broken structures; NaN and infinity cannot even be written.
  try {
    EXPECT_EQ(certify::parse_file<certify::NetDocument>(written(mutant), "mutant"), mutant);
    EXPECT_NE(certificate.verdict, Verdict::malformed) << certificate.message;
  } catch (const certify::MalformedError& error) {
    EXPECT_EQ(certificate.verdict, Verdict::malformed) << error.what();
  }
  return certificate.verdict == Verdict::verified    ? "verified"
         : certificate.verdict == Verdict::undecided ? "undecided"
                                                     : certificate.rule;
}

struct Base {
  std::string name;
  NetDocument net;
};

std::vector<Base> bases() {
  std::vector<Base> result;
  for (const auto& [seed, epsilon] :
       std::vector<std::pair<std::int32_t, const char*>>{{123, "1.5"}, {321, "0.8"}, {2, "0.5"}, {7, "3"}}) {
    result.push_back({"octagon " + std::to_string(seed) + ", epsilon " + epsilon,
                      certified_net(random_octagon(seed), Length(epsilon)).document});
  }
  // A short curve: charts and words that lead far into its collar.
  const Surface thin = import_surface(certify::load(EPSNET_TEST_DATA "/polygons/polygon-g2-thin-1e-4.txt"), "thin");
  result.push_back({"thin, epsilon 1.5", certified_net(thin, Length("1.5")).document});
  // The octagon 123 as two triangles and a hexagon.
  const Surface octagon = random_octagon(123);
  const Tile& v = octagon.tiles()[0];
  const Surface tiles({{v[0], v[1], v[2]}, {v[4], v[5], v[6]}, {v[0], v[2], v[3], v[4], v[6], v[7]}},
                      {{0, 0, 1, 0}, {0, 1, 1, 1}, {2, 1, 2, 4}, {2, 2, 2, 5}, {0, 2, 2, 0}, {1, 2, 2, 3}});
  result.push_back({"three tiles, epsilon 0.9", certified_net(tiles, Length("0.9")).document});
  return result;
}

TEST(Mutation, TheOracleAgreesWithEveryUnchangedNet) {
  test::Oracle oracle;
  for (const auto& [name, net] : bases()) {
    EXPECT_EQ(oracle.broken_rule(net), "") << name;
    EXPECT_EQ(outcome(net, oracle), "verified") << name;
  }
}

TEST(Mutation, NoMutantIsVerifiedUnlessTheOracleAgrees) {
  Random random(20250915);
  Table table;
  const int rounds = test::scaled(25);
  for (const auto& [name, net] : bases()) {
    test::Oracle oracle;
    for (int round = 0; round < rounds; ++round) {
      for (const Mutation& mutation : mutations()) {
        NetDocument mutant = net;
        if (mutant.labels.empty()) continue;
        mutation.apply(mutant, random);
        if (mutant == net) continue;
        SCOPED_TRACE(name + ", " + mutation.name + ", round " + std::to_string(round));
        const std::string result = outcome(mutant, oracle);
        ++table[mutation.name][result];
        ++table["~ all"][result];
      }
    }
  }
  print(table);
  const auto& killed = table["~ all"];
  for (const char* rule : {"structure", "surface", "map", "gluing", "orientation", "delaunay", "covering", "packing"}) {
    EXPECT_TRUE(killed.contains(rule)) << "no mutant was killed by rule " << rule;
  }
  // Moves by an ulp and detours in words leave a net verified, so the test is not vacuous.
  EXPECT_GT(table["vertex moved by an ulp"]["verified"], 0);
  EXPECT_GT(table["a side crossed there and back"]["verified"], 0);
  EXPECT_EQ(table["a side crossed there and back"].size(), 1U);
  EXPECT_EQ(table["gluing turned round"].size(), 1U);
}

}  // namespace
}  // namespace epsnet::mutation_test
