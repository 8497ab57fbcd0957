#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "netgen/base/progress.h"

namespace epsnet {

/// Shows how far we are on a terminal, and how long it will take from there at this pace, after the first second; wipes
/// its line at the end.
class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  void show(std::string_view text, double share);

  /// What shows the progress of a computation on this line, which must outlive it. `prefix` comes before its text.
  [[nodiscard]] Progress shower(std::string prefix = "");

 private:
  [[nodiscard]] std::string time_left(std::chrono::steady_clock::time_point now) const;

  bool terminal_;
  bool shown_once_ = false;
  std::chrono::steady_clock::time_point shown_ = std::chrono::steady_clock::now();
  // Where the part of the work began that the share is of: a share that falls, or 0, begins another one.
  std::chrono::steady_clock::time_point began_ = shown_;
  double began_share_ = 0;
  double share_ = 0;
};

}  // namespace epsnet
