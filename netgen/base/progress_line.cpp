#include "netgen/base/progress_line.h"

#include <cstdio>
#include <unistd.h>
#include <utility>

namespace epsnet {

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (shown_once_) std::fprintf(stderr, "\r%44s\r", "");
}

void ProgressLine::show(std::string_view text, double share) {
  const auto now = std::chrono::steady_clock::now();
  if (!terminal_ || now - shown_ < std::chrono::milliseconds(shown_once_ ? 200 : 1000)) return;
  shown_ = now;
  shown_once_ = true;
  std::fprintf(stderr, "\r%-36s %3.0f %%", std::string(text).c_str(), 100 * share);
}

Progress ProgressLine::shower(std::string prefix) {
  return [this, prefix = std::move(prefix)](std::string_view what, double share) {
    show(prefix + std::string(what), share);
  };
}

}  // namespace epsnet
