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

/// The file, with sides that do not fit or disks that do not cover, which are no matter of structure, and end the check
/// of what is well-formed.
Json refuted(const std::string& name) {
  Json result = file(name);
  Json& first = result.contains("net") ? result["net"] : result;
  Json& net = first.contains("net") ? first["net"] : first;
  if (net["surface"].contains("tiles")) {
    net["surface"]["tiles"][0][0] = {"1/97", "1/89"};
  } else {
    net["epsilon"] = "1/1000";
  }
  return result;
}

class FilesOfEveryClaim : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    good_ = refuted(GetParam());
    ASSERT_FALSE(first_finds_malformed(good_.dump()));
    ASSERT_EQ(check(good_.dump()).verdict, Verdict::refuted);
    find_values(good_, Pointer(), places_);
  }

  /// The file with another value at a place, which may be a new member of an object.
  [[nodiscard]] std::string with(const Pointer& place, const Json& value) const {
    Json changed = good_;
    changed[place] = value;
    return changed.dump();
  }

  void expect_malformed(const Pointer& place, const Json& value) const {
    const std::string text = with(place, value);
    EXPECT_TRUE(first_finds_malformed(text)) << place << ": " << value;
    EXPECT_EQ(check(text).verdict, Verdict::malformed) << place << ": " << value;
  }

  Json good_;
  std::vector<Pointer> places_;
};

TEST_P(FilesOfEveryClaim, AreMalformedForBothCheckersOrForNone) {
  std::map<bool, int> met;
  const std::size_t step = 1 + places_.size() / 300;
  for (std::size_t i = 1; i < places_.size(); i += step) {
    for (const Json& other : others(good_[places_[i]])) {
      const std::string text = with(places_[i], other);
      const bool malformed = first_finds_malformed(text);
      EXPECT_EQ(check(text).verdict == Verdict::malformed, malformed) << places_[i] << ": " << other;
      ++met[malformed];
    }
  }
  EXPECT_GT(met[true], 20);
  EXPECT_GT(met[false], 2);
}

TEST_P(FilesOfEveryClaim, HaveTheMembersOfTheFormatAndNoOthers) {
  for (const Pointer& place : places_) {
    const Json object = good_[place];
    if (!object.is_object()) continue;
    expect_malformed(place / "more", 0);
    for (const auto& [key, value] : object.items()) {
      // Left out, which some members may be, and of a name that is that of no member.
      Json other = object;
      other.erase(key);
      const std::string text = with(place, other);
      EXPECT_EQ(check(text).verdict == Verdict::malformed, first_finds_malformed(text)) << place << ": " << key;
      other["X" + key] = value;
      expect_malformed(place, other);
    }
    if (object.contains("version")) {
      for (const Json& wrong : {Json(0), Json(2), Json("1"), Json(1.0), Json(nullptr)})
        expect_malformed(place / "version", wrong);
    }
    if (object.contains("format")) {
      for (const Json& wrong : {Json("epsnet-other"), Json("epsnet-"), Json(""), Json(1)})
        expect_malformed(place / "format", wrong);
    }
  }
}

TEST_P(FilesOfEveryClaim, SayTrueOrFalseAndNothingElse) {
  for (const Pointer& place : places_) {
    if (!good_[place].is_boolean()) continue;
    for (const Json& wrong : {Json(nullptr), Json("true"), Json("false"), Json(0), Json(1), Json::array()})
      expect_malformed(place, wrong);
  }
}

std::string name_of(const testing::TestParamInfo<std::string>& info) {
  std::string result;
  for (const char c : info.param) result += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return result;
}

INSTANTIATE_TEST_SUITE_P(All, FilesOfEveryClaim,
                         testing::Values("geodesics/systole-long-conjugate", "forgeries/spectrum",
                                         "forgeries/spectrum-of-equal-lengths", "geodesics/one-curve-of-2-arsinh-1",
                                         "geodesics/three-cuffs", "geodesics/bolza-maximum", "forgeries/collars",
                                         "distances/four-equal", "bounds/octagon-diameter-base",
                                         "bounds/octagon-radius", "bounds/octagon-embedded-disk",
                                         "bounds/bolza-radius-domain", "isometries/octagon-5",
                                         "eigenvalues/octagon-5-of-one-vertex", "eigenvalues/octagon-5-with-a-function",
                                         "eigenvalues/octagon-sections-in-a-box", "pants/octagon-5", "curves/one-fills",
                                         "comparisons/octagons", "comparisons/mirror-image"),
                         name_of);

}  // namespace
}  // namespace epsnet::exact::structure_test
