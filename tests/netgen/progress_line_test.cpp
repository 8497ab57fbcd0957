#include "netgen/base/progress_line.h"

#include <chrono>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <thread>

namespace epsnet::progress_line_test {
namespace {

using std::chrono::seconds;

TEST(ProgressText, SaysWhatIsDoneAndSinceWhen) {
  ProgressText text;
  text.set("counting", 0);
  EXPECT_EQ(text.after(seconds(3)), "counting, 3 s");
  text.set("counting", 0.256);
  EXPECT_EQ(text.after(seconds(4)), "counting, 25 %, 4 s");
  text.set("counting", 1);
  EXPECT_EQ(text.after(seconds(200)), "counting, 100 %, 3 min 20 s");
}

/// The share of a second part is not that of the whole.
TEST(ProgressText, AShareThatFellIsNotShownAgain) {
  ProgressText text;
  text.set("first", 0.9);
  text.set("second", 0.1);
  EXPECT_EQ(text.after(seconds(5)), "second, 5 s");
  text.set("second", 0.95);
  EXPECT_EQ(text.after(seconds(6)), "second, 6 s");
}

TEST(ProgressLine, HasLinesWithoutATerminalIfTheyAreAskedFor) {
  const auto lines_of = [](bool asked) {
    progress_output() = {.lines = asked, .every = std::chrono::milliseconds(1)};
    testing::internal::CaptureStderr();
    {
      ProgressLine line("nothing");
      const Progress show = line.shower("something: ");
      show("the whole", 0.5);
      std::this_thread::sleep_for(std::chrono::milliseconds(500));
    }
    progress_output() = {};
    return testing::internal::GetCapturedStderr();
  };
  EXPECT_THAT(lines_of(true), testing::HasSubstr("something: the whole, 50 %, 0 s\n"));
  EXPECT_EQ(lines_of(false), "");
}

TEST(ProgressLine, EndsAtOnce) {
  const auto before = std::chrono::steady_clock::now();
  {
    ProgressLine line("nothing");
    line.shower("a part: ")("x", 0.5);
  }
  EXPECT_LT(std::chrono::steady_clock::now() - before, seconds(5));
}

}  // namespace
}  // namespace epsnet::progress_line_test
