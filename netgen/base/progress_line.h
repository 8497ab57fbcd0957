#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "netgen/base/options.h"

namespace epsnet {

/// Where progress is shown.
struct ProgressOutput {
  bool lines = false;  ///< Whether there are lines on standard error without a terminal (--progress),
  std::chrono::milliseconds every = std::chrono::seconds(10);  ///< and the time from one to the next.
};

/// The output of this process, which the command line sets.
[[nodiscard]] ProgressOutput& progress_output();

/// What a line of progress says: what is being done, how much of it, and since when. How much is a share that never
/// falls: once a computation has begun a second part, the share of a part is not that of the whole, and is left out.
class ProgressText {
 public:
  void set(std::string_view text, double share);
  [[nodiscard]] std::string after(std::chrono::seconds elapsed) const;

 private:
  std::string text_;
  double share_ = 0;
  bool fell_ = false;
};

/// Shows progress: on a terminal in one line, from the first second on; without one as ProgressOutput says. It is
/// written anew as time passes, also while a computation says nothing. The destructor ends that and clears the line.
class ProgressLine {
 public:
  /// `what` is shown until the computation says what it does.
  explicit ProgressLine(std::string_view what = "working");
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  /// Says what is being done, and which share of it is.
  void show(std::string_view text, double share);

  /// Returns a function that shows progress on this line, which must outlive it. `prefix` comes before its text.
  [[nodiscard]] Progress shower(std::string prefix = "");

 private:
  void run();

  const bool terminal_;
  const std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::condition_variable ended_;
  bool is_ended_ = false;
  ProgressText text_;
  std::thread thread_;
};

}  // namespace epsnet
