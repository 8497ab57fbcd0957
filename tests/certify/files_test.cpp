#include <filesystem>
#include <gtest/gtest.h>
#include <set>
#include <string>

#include "certify/check.h"
#include "certify/file/file.h"

/// Every file under tests/data/certify/VERDICT has that verdict; refuted and undecided ones are named RULE-defect.
namespace epsnet::certify::files_test {
namespace {

std::vector<std::filesystem::path> files(const std::string& verdict) {
  std::vector<std::filesystem::path> result;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(EPSNET_TEST_DATA) + "/certify/" + verdict)) {
    result.push_back(entry.path());
  }
  return result;
}

Certificate check_file(const std::filesystem::path& path) {
  return check(read_file<ClaimDocument>(path), {.threads = 2});
}

void expect_verdict(const std::string& folder, Verdict verdict, std::size_t at_least, bool named_by_rule) {
  const auto paths = files(folder);
  EXPECT_GE(paths.size(), at_least);
  for (const auto& path : paths) {
    SCOPED_TRACE(path.string());
    const Certificate certificate = check_file(path);
    EXPECT_EQ(certificate.verdict, verdict) << certificate.rule << ": " << certificate.message;
    if (named_by_rule) {
      EXPECT_TRUE(path.filename().string().starts_with(certificate.rule + "-")) << certificate.rule;
    }
  }
}

TEST(Files, VerifiedOnesAreVerified) { expect_verdict("verified", Verdict::verified, 13, false); }
TEST(Files, RefutedOnesAreRefutedByTheRuleInTheirName) { expect_verdict("refuted", Verdict::refuted, 30, true); }
TEST(Files, UndecidedOnesAreUndecided) { expect_verdict("undecided", Verdict::undecided, 2, true); }

TEST(Files, MalformedOnesAreNotRead) {
  const auto paths = files("malformed");
  EXPECT_GE(paths.size(), 60U);
  for (const auto& path : paths) {
    SCOPED_TRACE(path.string());
    EXPECT_THROW(static_cast<void>(read_file<NetDocument>(path)), MalformedError);
  }
}

TEST(Files, EveryRuleHasARefutedFile) {
  std::set<std::string> rules;
  for (const auto& path : files("refuted")) {
    const std::string file = path.filename().string();
    rules.insert(file.substr(0, file.find('-')));
  }
  EXPECT_EQ(rules, (std::set<std::string>{"surface", "map", "gluing", "orientation", "delaunay", "covering", "packing",
                                          "geodesics", "cells"}));
}

}  // namespace
}  // namespace epsnet::certify::files_test
