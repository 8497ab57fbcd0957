#include "netgen/nets/net_record.h"

#include <gtest/gtest.h>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "certify/base/text.h"
#include "certify/check.h"
#include "netgen/surfaces/octagon.h"

namespace epsnet::net_record_test {
namespace {

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> result;
  std::istringstream in(line + ',');
  for (std::string field; std::getline(in, field, ',');) {
    result.push_back(field);
  }
  return result;
}

std::map<std::string, std::string> record(const UncertifiedNet& net, const certify::Certificate& certificate,
                                          const NetOptions& options) {
  const auto names = fields(net_record_columns());
  const auto values = fields(net_record("octagon-9", net, certificate, options, {0.25, 1.5}));
  EXPECT_EQ(names.size(), values.size());
  std::map<std::string, std::string> result;
  for (std::size_t i = 0; i < names.size(); ++i) {
    result[names[i]] = values[i];
  }
  return result;
}

std::map<std::string, std::string> record(const char* epsilon, const NetOptions& options) {
  const UncertifiedNet net = compute_net(random_octagon(9), Length(epsilon), options);
  return record(net, certify::check(net.net), options);
}

TEST(NetRecord, SaysHowTheNetWasMade) {
  auto flips = record("1/5", {.insertion = Insertion::flips, .walk = Walk::straight, .list = TriangleList::all_front});
  EXPECT_EQ(flips["surface"], "octagon-9");
  EXPECT_EQ(flips["epsilon"], "1/5");
  EXPECT_EQ(flips["insertion"], "flips");
  EXPECT_EQ(flips["walk"], "straight");
  EXPECT_EQ(flips["list"], "B");
  EXPECT_EQ(flips["verdict"], "VERIFIED");
  EXPECT_EQ(flips["genus"], "2");
  EXPECT_EQ(std::stoi(flips["vertices"]), std::stoi(flips["insertions"]) + 1);
  EXPECT_EQ(flips["located"], flips["insertions"]);
  EXPECT_EQ(flips["net_seconds"], "0.250000");
  EXPECT_EQ(flips["certificate_seconds"], "1.500000");
  auto cavity = record("0.2", {});
  EXPECT_EQ(cavity["insertion"], "cavity");
  EXPECT_EQ(cavity["walk"], "");
  EXPECT_EQ(cavity["list"], "C");
  EXPECT_EQ(cavity["located"], "0");
}

TEST(OptionNames, LeadFromValuesToNamesAndBack) {
  EXPECT_EQ(name(Insertion::cavity), "cavity");
  EXPECT_EQ(name(Insertion::flips), "flips");
  EXPECT_EQ(name(Walk::visibility), "visibility");
  EXPECT_EQ(name(Walk::straight), "straight");
  // The letters of the thesis' Table IV.2.
  EXPECT_EQ(name(TriangleList::all_back), "A");
  EXPECT_EQ(name(TriangleList::all_front), "B");
  EXPECT_EQ(name(TriangleList::large_back), "C");
  EXPECT_EQ(name(TriangleList::largest_first), "D");
  const auto expect_back = [](const auto& names) {
    for (const auto& [text, value] : names) {
      EXPECT_EQ(name(value), text);
      EXPECT_EQ(value_in(names, text), value);
    }
    EXPECT_FALSE(value_in(names, "E").has_value());
    EXPECT_FALSE(value_in(names, "").has_value());
  };
  expect_back(kInsertionNames);
  expect_back(kWalkNames);
  expect_back(kTriangleListNames);
}

TEST(NetRecord, HasWhatIsProved) {
  auto net = record("0.2", {});
  EXPECT_LT(std::stod(net["largest_circumradius_upper"]), 0.2);
  EXPECT_GT(std::stod(net["shortest_edge_lower"]), 0.2);
  EXPECT_EQ(net["shortest_loop_lower"], "");
  EXPECT_GT(std::stod(net["systole_lower"]), 0.2);
  auto one_vertex = record("20", {});
  EXPECT_EQ(one_vertex["vertices"], "1");
  EXPECT_EQ(one_vertex["shortest_edge_lower"], "");
  EXPECT_LE(std::stod(one_vertex["systole_lower"]), std::stod(one_vertex["shortest_loop_upper"]));
}

/// The bounds hold for the decimals, not only for the binary64 numbers that they read as.
TEST(NetRecord, BoundsAreRoundedOutward) {
  for (std::int32_t seed = 1; seed <= 30; ++seed) {
    const UncertifiedNet net = compute_net(random_octagon(seed), Length("1"));
    const certify::Certificate certificate = certify::check(net.net);
    ASSERT_TRUE(certificate.enclosures && certificate.enclosures->shortest_edge) << seed;
    auto row = record(net, certificate, {});
    const auto value = [&](const char* name) { return certify::parse_decimal(row[name]).value(); };
    const certify::Enclosures& enclosures = *certificate.enclosures;
    EXPECT_GE(value("largest_circumradius_upper"), mpq_class(enclosures.largest_circumradius.upper)) << seed;
    EXPECT_LE(value("shortest_edge_lower"), mpq_class(enclosures.shortest_edge->lower)) << seed;
    if (!enclosures.shortest_loop) continue;
    EXPECT_LE(value("shortest_loop_lower"), mpq_class(enclosures.shortest_loop->lower)) << seed;
    EXPECT_GE(value("shortest_loop_upper"), mpq_class(enclosures.shortest_loop->upper)) << seed;
  }
}

TEST(NetRecord, QuotesNamesThatNeedIt) {
  const UncertifiedNet net = compute_net(random_octagon(9), Length("20"));
  EXPECT_TRUE(net_record("a,\"b\"", net, certify::check(net.net), {}, {}).starts_with("\"a,\"\"b\"\"\",20,"));
}

}  // namespace
}  // namespace epsnet::net_record_test
