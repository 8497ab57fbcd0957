#include "netgen/base/progress_line.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <unistd.h>
#include <utility>

namespace epsnet {

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (shown_once_) std::fprintf(stderr, "\r%64s\r", "");
}

void ProgressLine::show(std::string_view text, double share) {
  const auto now = std::chrono::steady_clock::now();
  if (share < share_ || share <= 0) {
    began_ = now;
    began_share_ = share;
  }
  share_ = share;
  if (!terminal_ || now - shown_ < std::chrono::milliseconds(shown_once_ ? 200 : 1000)) return;
  shown_ = now;
  shown_once_ = true;
  std::fprintf(stderr, "\r%-40s %3.0f %%%-18s", std::string(text).c_str(), 100 * share, time_left(now).c_str());
}

std::string ProgressLine::time_left(std::chrono::steady_clock::time_point now) const {
  const std::chrono::duration<double> elapsed = now - began_;
  const double done = share_ - began_share_;
  if (done < 0.02 || elapsed.count() < 1) return "";
  const double seconds = std::ceil(elapsed.count() * (1 - share_) / done);
  if (seconds > 1e6) return "";
  const auto whole = static_cast<std::uint64_t>(seconds);
  return whole < 100 ? ", " + std::to_string(whole) + " s left"
                     : ", " + std::to_string((whole + 59) / 60) + " min left";
}

Progress ProgressLine::shower(std::string prefix) {
  return [this, prefix = std::move(prefix)](std::string_view what, double share) {
    show(prefix + std::string(what), share);
  };
}

}  // namespace epsnet
