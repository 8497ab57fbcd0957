#include "netgen/base/progress_line.h"

#include <cstdio>
#include <unistd.h>

namespace epsnet {

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (shown_once_) std::fprintf(stderr, "\r%44s\r", "");
}

void ProgressLine::show(const std::string& text, double share) {
  const auto now = std::chrono::steady_clock::now();
  if (!terminal_ || now - shown_ < std::chrono::milliseconds(shown_once_ ? 200 : 1000)) return;
  shown_ = now;
  shown_once_ = true;
  std::fprintf(stderr, "\r%-36s %3.0f %%", text.c_str(), 100 * share);
}

}  // namespace epsnet
