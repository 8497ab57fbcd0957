#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "netgen/base/options.h"

namespace epsnet {

/// Shows progress on a terminal, and, after the first second, the remaining time at the present pace. The destructor
/// clears the line.
class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  void show(std::string_view text, double share);

  /// Returns a function that shows progress on this line, which must outlive it. `prefix` comes before its text.
  [[nodiscard]] Progress shower(std::string prefix = "");

 private:
  [[nodiscard]] std::string time_left(std::chrono::steady_clock::time_point now) const;

  bool terminal_;
  bool shown_once_ = false;
  std::chrono::steady_clock::time_point shown_ = std::chrono::steady_clock::now();
  // When, and with which share, the current step began: a share that is smaller than the last one, or 0, begins a new
  // step.
  std::chrono::steady_clock::time_point began_ = shown_;
  double began_share_ = 0;
  double share_ = 0;
};

}  // namespace epsnet
