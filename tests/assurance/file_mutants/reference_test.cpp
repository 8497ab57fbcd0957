#include "tests/assurance/file_mutants/reference.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <vector>

/// The reference agrees with the folders and names of the committed files.
namespace epsnet::attack {
namespace {

std::string contents(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::filesystem::path> files(const std::string& folder) {
  const std::filesystem::directory_iterator all(EPSNET_TEST_DATA "/certify/" + folder);
  return {begin(all), end(all)};
}

bool is_geodesics(const std::string& text) { return text.find("epsnet-geodesics") != std::string::npos; }

/// Whether the reference leaves the file to the other checkers.
bool is_of_regular_tiles(const Answer& answer) {
  return answer.verdict == Answer::Verdict::unknown && answer.rule == "regular tiles";
}

TEST(Reference, AcceptsTrueNets) {
  for (const auto& path : files("verified")) {
    if (path.stem().string().starts_with("map-")) continue;  // The reference knows no maps.
    const Answer answer = ask(contents(path));
    if (is_of_regular_tiles(answer)) continue;
    EXPECT_EQ(answer.verdict, Answer::Verdict::valid) << path << ": " << answer.rule;
  }
}

TEST(Reference, NamesTheRuleThatIsBroken) {
  for (const auto& path : files("refuted")) {
    const std::string name = path.stem().string();
    if (name.starts_with("geodesics-")) continue;           // Below.
    if (name.starts_with("cells-")) continue;               // A bound file: the reference knows none.
    if (name.find("-map-") != std::string::npos) continue;  // A net on a map: likewise.
    const Answer answer = ask(contents(path));
    if (is_of_regular_tiles(answer)) continue;
    EXPECT_EQ(answer.verdict, Answer::Verdict::invalid) << path << ": " << answer.rule;
    EXPECT_EQ(answer.rule, name.substr(0, name.find('-'))) << path;
  }
}

TEST(Reference, RefusesWhatIsNoFile) {
  for (const auto& path : files("malformed")) {
    EXPECT_EQ(ask(contents(path)).verdict, Answer::Verdict::malformed) << path;
  }
}

TEST(Reference, FindsTheGeodesicsOfTrueFilesAgain) {
  for (const std::string name :
       {"forgeries/systole", "forgeries/spectrum", "forgeries/small-curves", "forgeries/spectrum-with-a-figure-eight",
        "geodesics/three-cuffs", "geodesics/one-cuff-of-1e-8", "geodesics/systole-long-conjugate"}) {
    const std::string text = contents(EPSNET_TEST_DATA "/" + name + ".json");
    ASSERT_TRUE(is_geodesics(text)) << name;
    const KnownGeodesics known = learn(text);
    const Answer answer = ask(text, &known);
    EXPECT_EQ(answer.verdict, Answer::Verdict::valid) << name << ": " << answer.rule;
  }
}

TEST(Reference, SeesWhatIsWrongWithAListOfGeodesics) {
  const std::string true_file = contents(EPSNET_TEST_DATA "/forgeries/spectrum.json");
  const KnownGeodesics known = learn(true_file);
  const auto with = [&](const std::string& old, const std::string& other) {
    std::string text = true_file;
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return ask(text.replace(at, old.size(), other), &known);
  };
  EXPECT_EQ(with("true", "false").rule, "simple");
  EXPECT_EQ(with("\"word\":[2,7]", "\"word\":[2,7,2,7]").rule, "geodesics");  // Twice as long as it is said to be.
  EXPECT_EQ(with("\"word\":[1,4]", "\"word\":[2,7]").rule, "geodesics");
  EXPECT_EQ(with("2.2647398959355343", "2.2647398959355334").rule, "geodesics");
  EXPECT_EQ(with("\"claim\":\"spectrum\"", "\"claim\":\"spectra\"").verdict, Answer::Verdict::malformed);
  EXPECT_EQ(ask(contents(EPSNET_TEST_DATA "/forgeries/systole.json"), nullptr).verdict, Answer::Verdict::unknown);
}

}  // namespace
}  // namespace epsnet::attack
