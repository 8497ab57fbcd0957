#include <cstdlib>
#include <gtest/gtest.h>
#include <iostream>
#include <string>

#include "tests/support/scale.h"

/// Runs the tests with a fixed RapidCheck seed and 100 cases per property, scaled by EPSNET_TEST_MULTIPLIER.
/// RC_PARAMS in the environment replaces both, for example RC_PARAMS="seed=7 max_success=10000".
int main(int argc, char** argv) {
  const std::string parameters = "seed=20250915 max_success=" + std::to_string(epsnet::test::scaled(100));
  setenv("RC_PARAMS", parameters.c_str(), 0);
  testing::InitGoogleTest(&argc, argv);
  const int failed = RUN_ALL_TESTS();
  if (testing::UnitTest::GetInstance()->test_to_run_count() == 0) {
    std::cerr << "no test was run\n";
    return 1;
  }
  return failed;
}
