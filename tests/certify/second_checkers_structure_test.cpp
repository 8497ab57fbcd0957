#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "certify/exact/checker.h"
#include "certify/file/file.h"

/// What the second checker calls malformed, of files of every claim of which one value is changed: what the first one
/// does.
namespace epsnet::exact::structure_test {
namespace {

using Json = nlohmann::json;
using Pointer = Json::json_pointer;

Json file(const std::string& name) {
  std::ifstream in(std::string(EPSNET_TEST_DATA) + "/" + name + ".json");
  return Json::parse(in);
}

/// Other values in the place of one.
std::vector<Json> others(const Json& value) {
  std::vector<Json> result;
  if (value.is_number_unsigned()) {
    const auto n = value.get<std::uint64_t>();
    for (const std::uint64_t other : {n + 1, n - 1, std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{2}, 2 * n,
                                      std::uint64_t{std::numeric_limits<std::uint32_t>::max()}}) {
      if (other != n && other <= std::numeric_limits<std::uint32_t>::max()) result.emplace_back(other);
    }
  } else if (value.is_number_integer()) {
    result = {value.get<std::int64_t>() + 1, value.get<std::int64_t>() - 1};
  } else if (value.is_number_float()) {
    const auto x = value.get<double>();
    result = {0, -x, x / 2, 2 * x, std::nextafter(x, 0.0), std::nextafter(x, 1e9)};
  } else if (value.is_array()) {
    result = {Json::array()};
    if (!value.empty()) {
      Json other = value;
      other.erase(other.size() - 1);
      result.push_back(other);
      other = value;
      other.push_back(value.back());
      result.push_back(other);
      other = value;
      std::swap(other[0], other[other.size() - 1]);
      result.push_back(other);
    }
  } else if (value.is_string()) {
    result = {"0", "-1", "1/2"};
  }
  return result;
}

/// Of all values but those in nets.
void find_values(const Json& value, const Pointer& place, std::vector<Pointer>& places) {
  places.push_back(place);
  if (value.is_object()) {
    for (const auto& [key, member] : value.items()) {
      if (key != "net" && key != "format" && key != "version" && key != "claim" && member != value.value("net", Json()))
        find_values(member, place / key, places);
    }
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) find_values(value[i], place / i, places);
  }
}

bool first_finds_malformed(const std::string& text) {
  try {
    const auto document = certify::parse_file<certify::ClaimDocument>(text, "it");
    return certify::check(document, {.threads = 1}).verdict == certify::Verdict::malformed;
  } catch (const certify::MalformedError&) {
    return true;
  }
}

class FilesOfEveryClaim : public testing::TestWithParam<std::string> {};

TEST_P(FilesOfEveryClaim, AreMalformedForBothCheckersOrForNone) {
  // Sides that do not fit, or disks that do not cover, are no matter of structure, and end the check of what is
  // well-formed.
  Json good = file(GetParam());
  Json& net = good["net"].contains("net") ? good["net"]["net"] : good["net"];
  if (net["surface"].contains("tiles")) {
    net["surface"]["tiles"][0][0] = {"1/97", "1/89"};
  } else {
    net["epsilon"] = "1/1000";
  }
  ASSERT_FALSE(first_finds_malformed(good.dump()));
  ASSERT_EQ(check(good.dump()).verdict, Verdict::refuted);
  std::vector<Pointer> places;
  find_values(good, Pointer(), places);
  std::map<bool, int> met;
  const std::size_t step = 1 + places.size() / 300;
  for (std::size_t i = 1; i < places.size(); i += step) {
    for (const Json& other : others(good[places[i]])) {
      Json changed = good;
      changed[places[i]] = other;
      const std::string text = changed.dump();
      const bool malformed = first_finds_malformed(text);
      EXPECT_EQ(check(text).verdict == Verdict::malformed, malformed) << places[i] << ": " << other;
      ++met[malformed];
    }
  }
  EXPECT_GT(met[true], 20);
  EXPECT_GT(met[false], 2);
}

std::string name_of(const testing::TestParamInfo<std::string>& info) {
  std::string result;
  for (const char c : info.param) result += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return result;
}

INSTANTIATE_TEST_SUITE_P(
    All, FilesOfEveryClaim,
    testing::Values("geodesics/systole-long-conjugate", "forgeries/spectrum", "forgeries/spectrum-of-equal-lengths",
                    "geodesics/one-curve-of-2-arsinh-1", "geodesics/three-cuffs", "distances/four-equal",
                    "bounds/octagon-diameter-base", "bounds/octagon-radius", "bounds/octagon-embedded-disk",
                    "bounds/bolza-radius-domain", "isometries/octagon-5", "eigenvalues/octagon-5-of-one-vertex",
                    "pants/octagon-5", "curves/one-fills", "comparisons/octagons", "comparisons/mirror-image"),
    name_of);

}  // namespace
}  // namespace epsnet::exact::structure_test
