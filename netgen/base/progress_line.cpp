#include "netgen/base/progress_line.h"

#include <cstdio>
#include <string>
#include <unistd.h>
#include <utility>

namespace epsnet {
namespace {

constexpr std::chrono::milliseconds kOnTerminal{200};

std::string time_text(std::chrono::seconds time) {
  const auto seconds = time.count();
  if (seconds < 120) return std::to_string(seconds) + " s";
  return std::to_string(seconds / 60) + " min " + std::to_string(seconds % 60) + " s";
}

}  // namespace

ProgressOutput& progress_output() {
  static ProgressOutput output;
  return output;
}

void ProgressText::set(std::string_view text, double share) {
  text_ = text;
  fell_ = fell_ || share < share_;
  share_ = share;
}

std::string ProgressText::after(std::chrono::seconds elapsed) const {
  std::string result = text_;
  if (!fell_ && share_ > 0) result += ", " + std::to_string(static_cast<int>(100 * share_)) + " %";
  return result + ", " + time_text(elapsed);
}

ProgressLine::ProgressLine(std::string_view what) : terminal_(isatty(STDERR_FILENO) != 0) {
  text_.set(what, 0);
  if (terminal_ || progress_output().lines) thread_ = std::thread([this] { run(); });
}

ProgressLine::~ProgressLine() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    is_ended_ = true;
  }
  ended_.notify_one();
  thread_.join();
}

void ProgressLine::run() {
  std::unique_lock lock(mutex_);
  std::size_t width = 0;
  const auto is_ended = [this] { return is_ended_; };
  auto next = began_ + (terminal_ ? std::chrono::seconds(1) : progress_output().every);
  while (!ended_.wait_until(lock, next, is_ended)) {
    const auto elapsed = std::chrono::steady_clock::now() - began_;
    const std::string line = text_.after(std::chrono::duration_cast<std::chrono::seconds>(elapsed));
    if (terminal_) {
      std::fprintf(stderr, "\r%-*s", static_cast<int>(width), line.c_str());
      width = line.size();
      next += kOnTerminal;
    } else {
      std::fprintf(stderr, "%s\n", line.c_str());
      next += progress_output().every;
    }
  }
  if (width > 0) std::fprintf(stderr, "\r%*s\r", static_cast<int>(width), "");
}

void ProgressLine::show(std::string_view text, double share) {
  const std::lock_guard lock(mutex_);
  text_.set(text, share);
}

Progress ProgressLine::shower(std::string prefix) {
  return [this, prefix = std::move(prefix)](std::string_view what, double share) {
    show(prefix + std::string(what), share);
  };
}

}  // namespace epsnet
