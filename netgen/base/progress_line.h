#pragma once

#include <chrono>
#include <string>

namespace epsnet {

/// Shows how far we are on a terminal, after the first second; wipes its line at the end.
class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  void show(const std::string& text, double share);

 private:
  bool terminal_;
  bool shown_once_ = false;
  std::chrono::steady_clock::time_point shown_ = std::chrono::steady_clock::now();
};

}  // namespace epsnet
