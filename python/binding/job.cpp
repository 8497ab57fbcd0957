#include "python/binding/job.h"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <unistd.h>

#include "netgen/base/atomic_file.h"

namespace epsnet::python {
namespace {

constexpr std::chrono::milliseconds kInterval(50);
constexpr std::chrono::milliseconds kPatience(500);

/// Thrown in a computation that nobody waits for.
struct Abandoned {};

/// Computations that nobody waits for, and that have not ended.
std::atomic<int> abandoned_jobs = 0;

/// Such a computation would go on in a process whose static objects are being destroyed.
void leave_at_once(int status, void*) {
  if (abandoned_jobs.load() == 0) return;
  remove_temporary_files();
  std::fflush(nullptr);
  _exit(status);
}

}  // namespace

Progress JobState::progress(const std::shared_ptr<JobState>& state) {
  return [state](std::string_view what, double share) {
    const std::lock_guard lock(state->mutex_);
    if (state->abandoned_) throw Abandoned();
    state->what_ = what;
    state->share_ = share;
    state->told_ = true;
  };
}

void JobState::run(const std::function<void()>& computation) {
  std::exception_ptr error;
  try {
    computation();
  } catch (...) {
    error = std::current_exception();
  }
  const std::lock_guard lock(mutex_);
  error_ = error;
  ended_ = true;
  if (abandoned_) --abandoned_jobs;
  ended_signal_.notify_all();
}

void JobState::wait(const py::object& callback) {
  const auto ended = [this] { return ended_; };
  for (bool first = true;; first = false) {
    {
      const py::gil_scoped_release released;
      std::unique_lock lock(mutex_);
      // The first look is early, so that a callback hears of short computations, too.
      if (ended_signal_.wait_for(lock, first ? kInterval / 10 : kInterval, ended)) break;
    }
    try {
      look(callback);
    } catch (...) {
      abandon();
      throw;
    }
  }
  if (told_ && !callback.is_none() && !error_) callback(what_, share_);
  if (error_) std::rethrow_exception(error_);
}

void JobState::look(const py::object& callback) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  py::module_::import("epsnet._progress").attr("poll")();
  if (callback.is_none()) return;
  std::string what;
  double share = 0;
  {
    const std::lock_guard lock(mutex_);
    if (!told_) return;
    told_ = false;
    what = what_;
    share = share_;
  }
  callback(what, share);
}

void JobState::abandon() {
  static std::once_flag once;
  std::call_once(once, [] { on_exit(leave_at_once, nullptr); });
  const py::gil_scoped_release released;
  std::unique_lock lock(mutex_);
  if (ended_) return;
  abandoned_ = true;
  ++abandoned_jobs;
  ended_signal_.wait_for(lock, kPatience, [this] { return ended_; });
}

std::string svg_of(const std::function<PolygonPicture()>& make, std::uint32_t size) {
  const auto [svg, left_out] = interruptible([make, size] {
    PolygonPicture picture = make();
    return std::pair(draw_svg(picture, size), std::move(picture.left_out));
  });
  warn_of(left_out);
  return svg;
}

void warn_of(const std::vector<std::string>& left_out) {
  for (const std::string& what : left_out) {
    if (PyErr_WarnEx(PyExc_UserWarning, ("left out: " + what).c_str(), 1) != 0) throw py::error_already_set();
  }
}

void save(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
  interruptible([path, write](const Progress& progress) {
    write_files_atomically({{path, write}}, [&] { progress("writing", 1); });
  });
}

}  // namespace epsnet::python
