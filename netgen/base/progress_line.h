#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "netgen/base/progress.h"

namespace epsnet {

/// Shows how far we are on a terminal, after the first second; wipes its line at the end.
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
  bool terminal_;
  bool shown_once_ = false;
  std::chrono::steady_clock::time_point shown_ = std::chrono::steady_clock::now();
};

}  // namespace epsnet
