#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <random>
#include <sstream>

#include "certify/check.h"
#include "certify/exact/checker.h"
#include "certify/file/reader.h"
#include "certify/file/writer.h"
#include "netgen/exchange/domain_format.h"
#include "netgen/exchange/exchange.h"
#include "netgen/nets/certified_net.h"
#include "netgen/surfaces/octagon.h"
#include "tests/netgen/oracle.h"
#include "tests/support/scale.h"

/// Single random defects in verified nets: `certify` must say what the oracle says, and `certify-exact` what `certify`
/// says.
namespace epsnet {
namespace {

using certify::NetDocument;
using certify::Verdict;

/// The same numbers with every standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  [[nodiscard]] std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(engine_() % n); }
  [[nodiscard]] double share() { return std::ldexp(static_cast<double>(engine_() >> 11), -53); }
  [[nodiscard]] double sign() { return below(2) == 0 ? 1 : -1; }
  template <class T>
  [[nodiscard]] T& of(std::vector<T>& rows) {
    return rows[below(rows.size())];
  }

 private:
  std::mt19937_64 engine_;
};

/// Another index below n; sometimes one that is just too large, or as large as can be.
void change_index(std::uint32_t& index, std::size_t n, Random& random) {
  switch (random.below(12)) {
    case 0:
      index = static_cast<std::uint32_t>(n);
      break;
    case 1:
      index = ~0U;
      break;
    default:
      index = random.below(n);
  }
}

/// A little or a lot, relative to numbers below 1.
mpq_class some_step(Random& random) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, 1 + random.below(40));
  return mpq_class(random.below(2) == 0 ? 1 : -1, power);
}

double& coordinate(NetDocument& net, Random& random) {
  certify::NetDocument::Vertex& v = random.of(net.vertices);
  return random.below(2) == 0 ? v.x : v.y;
}
mpq_class& coordinate(certify::RationalPoint& z, Random& random) { return random.below(2) == 0 ? z.x : z.y; }

std::uint32_t& letter(NetDocument& net, Random& random) {
  std::vector<std::uint32_t*> letters;
  for (certify::NetDocument::Label& l : net.labels) {
    for (std::uint32_t& s : l.word) letters.push_back(&s);
  }
  return *random.of(letters);
}

std::size_t side_count(const NetDocument& net) {
  std::size_t n = 0;
  for (const certify::SurfaceDocument::Tile& tile : net.surface.tiles) n += tile.size();
  return n;
}

struct Mutation {
  const char* name;
  std::function<void(NetDocument&, Random&)> apply;
};

const std::vector<Mutation>& mutations() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static const std::vector<Mutation> all{
      {"vertex moved by an ulp",
       [](NetDocument& net, Random& r) {
         double& x = coordinate(net, r);
         x = std::nextafter(x, r.sign());
       }},
      {"vertex moved by 1e-6", [](NetDocument& net, Random& r) { coordinate(net, r) += 1e-6 * r.sign(); }},
      {"vertex moved by up to 0.3",
       [](NetDocument& net, Random& r) { coordinate(net, r) += 0.3 * r.share() * r.sign(); }},
      {"vertex anywhere",
       [](NetDocument& net, Random& r) {
         const std::vector<double> numbers{
             0.0,       -0.0, 1.0,    -1.0, 0.999999, 2.0,          -1e300,
             kInfinity, 1e-9, 5e-324, 0.5,  -0.5,     std::nan(""), std::nextafter(1.0, 0.0)};
         coordinate(net, r) = numbers[r.below(numbers.size())];
       }},
      {"vertex mirrored",
       [](NetDocument& net, Random& r) {
         double& x = coordinate(net, r);
         x = -x;
       }},
      {"vertices exchanged", [](NetDocument& net, Random& r) { std::swap(r.of(net.vertices), r.of(net.vertices)); }},
      {"vertex in another chart",
       [](NetDocument& net, Random& r) { change_index(r.of(net.vertices).chart, net.charts.size() + 1, r); }},
      {"vertex dropped", [](NetDocument& net, Random&) { net.vertices.pop_back(); }},
      {"vertex added", [](NetDocument& net, Random& r) { net.vertices.push_back(r.of(net.vertices)); }},
      {"chart moved", [](NetDocument& net, Random& r) { coordinate(r.of(net.charts).centre, r) += some_step(r); }},
      {"chart mirrored",
       [](NetDocument& net, Random& r) {
         mpq_class& x = coordinate(r.of(net.charts).centre, r);
         x = -x;
       }},
      {"chart of another tile",
       [](NetDocument& net, Random& r) { change_index(r.of(net.charts).tile, net.surface.tiles.size() + 1, r); }},
      {"chart dropped", [](NetDocument& net, Random&) { net.charts.pop_back(); }},
      {"epsilon a little different",
       [](NetDocument& net, Random& r) {
         mpq_class value(Length(net.epsilon).value().backend().data());
         value *= 1 + some_step(r);
         net.epsilon = value.get_str();
       }},
      {"epsilon up to twice or half",
       [](NetDocument& net, Random& r) {
         const double factor = std::exp2(r.share() * r.sign());
         std::ostringstream text;
         text << factor * static_cast<double>(Length(net.epsilon).value());
         net.epsilon = text.str();
       }},
      {"epsilon something else",
       [](NetDocument& net, Random& r) {
         const std::vector<const char*> texts{"0",   "-1",   "",        "nan", "inf", "1/0",    "0x1", "1e9999",
                                              "100", "1e-9", "1e-9999", "0.0", "1 ",  "-0.5e1", "1/",  "1e99999"};
         net.epsilon = texts[r.below(texts.size())];
       }},
      {"letter changed", [](NetDocument& net, Random& r) { change_index(letter(net, r), side_count(net) + 1, r); }},
      {"letter dropped",
       [](NetDocument& net, Random& r) {
         auto& word = r.of(net.labels).word;
         if (!word.empty()) word.erase(word.begin() + r.below(word.size()));
       }},
      {"letter added",
       [](NetDocument& net, Random& r) {
         auto& word = r.of(net.labels).word;
         word.insert(word.begin() + r.below(word.size() + 1), r.below(side_count(net)));
       }},
      {"word reversed",
       [](NetDocument& net, Random& r) {
         auto& word = r.of(net.labels).word;
         std::reverse(word.begin(), word.end());
       }},
      {"words exchanged", [](NetDocument& net, Random& r) { std::swap(r.of(net.labels).word, r.of(net.labels).word); }},
      {"a side crossed there and back",
       [](NetDocument& net, Random& r) {
         // The same element of the group, so the same net.
         auto& word = r.of(net.labels).word;
         const certify::SurfaceDocument::Gluing& g = r.of(net.surface.gluing);
         if (net.surface.tiles.size() == 1)
           word.insert(word.begin() + r.below(word.size() + 1), {g.side, g.other_side});
       }},
      {"label to another chart",
       [](NetDocument& net, Random& r) {
         certify::NetDocument::Label& l = r.of(net.labels);
         change_index(r.below(2) == 0 ? l.from : l.to, net.charts.size() + 1, r);
       }},
      {"labels exchanged", [](NetDocument& net, Random& r) { std::swap(r.of(net.labels), r.of(net.labels)); }},
      {"label dropped",
       [](NetDocument& net, Random& r) { net.labels.erase(net.labels.begin() + r.below(net.labels.size())); }},
      {"corner of another vertex",
       [](NetDocument& net, Random& r) {
         change_index(r.of(net.triangles).vertex[r.below(3)], net.vertices.size(), r);
       }},
      {"another opposite",
       [](NetDocument& net, Random& r) {
         change_index(r.of(net.triangles).opposite[r.below(3)], 3 * net.triangles.size(), r);
       }},
      {"two edges glued otherwise",
       [](NetDocument& net, Random& r) {
         // a–b and c–d become a–d and c–b: still an involution.
         const auto across = [&](std::uint32_t d) -> std::uint32_t& { return net.triangles[d / 3].opposite[d % 3]; };
         const std::uint32_t a = r.below(3 * net.triangles.size());
         const std::uint32_t c = r.below(3 * net.triangles.size());
         const std::uint32_t b = across(a);
         const std::uint32_t d = across(c);
         if (a == d) return;
         across(a) = d;
         across(d) = a;
         across(c) = b;
         across(b) = c;
       }},
      {"corner with another label",
       [](NetDocument& net, Random& r) {
         change_index(r.of(net.triangles).label[r.below(2)], net.labels.size() + 1, r);
       }},
      {"corner with another label that fits",
       [](NetDocument& net, Random& r) {
         certify::NetDocument::Triangle& t = r.of(net.triangles);
         std::uint32_t& l = t.label[r.below(2)];
         const certify::NetDocument::Label wanted =
             l == 0 ? certify::NetDocument::Label{net.vertices[t.vertex[0]].chart, net.vertices[t.vertex[0]].chart, {}}
                    : net.labels[l - 1];
         for (int i = 0; i < 50; ++i) {
           const std::uint32_t other = r.below(net.labels.size());
           if (other + 1 != l && net.labels[other].from == wanted.from && net.labels[other].to == wanted.to) {
             l = other + 1;
             return;
           }
         }
       }},
      {"corners' labels exchanged",
       [](NetDocument& net, Random& r) {
         certify::NetDocument::Triangle& t = r.of(net.triangles);
         std::swap(t.label[0], t.label[1]);
       }},
      {"triangle turned over",
       [](NetDocument& net, Random& r) {
         certify::NetDocument::Triangle& t = r.of(net.triangles);
         std::swap(t.vertex[1], t.vertex[2]);
         std::swap(t.label[0], t.label[1]);
       }},
      {"triangles exchanged", [](NetDocument& net, Random& r) { std::swap(r.of(net.triangles), r.of(net.triangles)); }},
      {"triangle dropped",
       [](NetDocument& net, Random& r) { net.triangles.erase(net.triangles.begin() + r.below(net.triangles.size())); }},
      {"triangle doubled", [](NetDocument& net, Random& r) { net.triangles.push_back(r.of(net.triangles)); }},
      {"polygon's vertex moved",
       [](NetDocument& net, Random& r) { coordinate(r.of(r.of(net.surface.tiles)), r) += some_step(r); }},
      {"polygon's vertices exchanged",
       [](NetDocument& net, Random& r) {
         certify::SurfaceDocument::Tile& tile = r.of(net.surface.tiles);
         std::swap(r.of(tile), r.of(tile));
       }},
      {"polygon reversed",
       [](NetDocument& net, Random& r) {
         certify::SurfaceDocument::Tile& tile = r.of(net.surface.tiles);
         std::reverse(tile.begin(), tile.end());
       }},
      {"polygon's vertex dropped", [](NetDocument& net, Random& r) { r.of(net.surface.tiles).pop_back(); }},
      {"gluing changed",
       [](NetDocument& net, Random& r) {
         certify::SurfaceDocument::Gluing& g = r.of(net.surface.gluing);
         change_index(r.below(2) == 0 ? g.side : g.other_side, side_count(net), r);
       }},
      {"gluings crossed",
       [](NetDocument& net, Random& r) {
         std::swap(r.of(net.surface.gluing).other_side, r.of(net.surface.gluing).other_side);
       }},
      {"gluing turned round",
       [](NetDocument& net, Random& r) {
         // The same pairs: still the same net.
         certify::SurfaceDocument::Gluing& g = r.of(net.surface.gluing);
         g = {g.other_tile, g.other_side, g.tile, g.side};
       }},
      {"gluing dropped", [](NetDocument& net, Random&) { net.surface.gluing.pop_back(); }},
      {"tile added", [](NetDocument& net, Random&) { net.surface.tiles.push_back(net.surface.tiles[0]); }},
  };
  return all;
}

std::string written(const NetDocument& net) {
  std::ostringstream out;
  certify::write_net(net, out);
  return out.str();
}

/// Mutants by mutation and by what became of them.
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

/// Checks one mutant and returns what became of it.
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
  // The reader sees a broken structure too, and nothing else; NaN and infinity cannot even be written.
  try {
    EXPECT_EQ(certify::parse_net(written(mutant), "mutant"), mutant);
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
                      certified_net(random_octagon(seed), Length(epsilon)).net});
  }
  // A short curve: charts and words that lead far into its collar.
  const Surface thin = import_surface_file(std::string(EPSNET_TEST_DATA) + "/polygons/polygon-g2-thin-1e-4.txt");
  result.push_back({"thin, epsilon 1.5", certified_net(thin, Length("1.5")).net});
  // The octagon 123 as two triangles and a hexagon.
  const Surface octagon = random_octagon(123);
  const Tile& v = octagon.tiles()[0];
  const Surface tiles({{v[0], v[1], v[2]}, {v[4], v[5], v[6]}, {v[0], v[2], v[3], v[4], v[6], v[7]}},
                      {{0, 0, 1, 0}, {0, 1, 1, 1}, {2, 1, 2, 4}, {2, 2, 2, 5}, {0, 2, 2, 0}, {1, 2, 2, 3}});
  result.push_back({"three tiles, epsilon 0.9", certified_net(tiles, Length("0.9")).net});
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
  // Both are not nets of another kind by accident: moves by an ulp and detours in words leave a net what it is.
  EXPECT_GT(table["vertex moved by an ulp"]["verified"], 0);
  EXPECT_GT(table["a side crossed there and back"]["verified"], 0);
  EXPECT_EQ(table["a side crossed there and back"].size(), 1U);
  EXPECT_EQ(table["gluing turned round"].size(), 1U);
}

}  // namespace
}  // namespace epsnet
