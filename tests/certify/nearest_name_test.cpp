#include "certify/base/nearest_name.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace epsnet::certify::nearest_name_test {
namespace {

TEST(NearestName, IsTheOneWithTheFewestTypingErrors) {
  const std::vector<std::string> names{"--threads", "--json", "--max-precision", "--max-work"};
  EXPECT_EQ(nearest_name("--thraeds", names), "--threads");
  EXPECT_EQ(nearest_name("--jsn", names), "--json");
  EXPECT_EQ(nearest_name("-json", names), "--json");
  EXPECT_EQ(nearest_name("--max-precison", names), "--max-precision");
  EXPECT_EQ(nearest_name("--max-wrk", names), "--max-work");
}

TEST(NearestName, IsAlsoOneThatBeginsAlike) {
  EXPECT_EQ(nearest_name("--thr", {"--json", "--threads"}), "--threads");
  EXPECT_EQ(nearest_name("eigen", {"epsilon", "eigenvalues"}), "eigenvalues");
}

TEST(NearestName, IsEmptyIfNoneIsNear) {
  EXPECT_EQ(nearest_name("--frobnicate", {"--threads", "--json"}), "");
  EXPECT_EQ(nearest_name("", {"--json"}), "");
  EXPECT_EQ(nearest_name("--json", {}), "");
  EXPECT_EQ(nearest_name(std::string(41, 'a'), {std::string(41, 'a')}), "");
}

}  // namespace
}  // namespace epsnet::certify::nearest_name_test
