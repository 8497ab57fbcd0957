#pragma once

#include <condition_variable>
#include <exception>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <variant>

#include "netgen/base/options.h"
#include "netgen/pictures/pictures.h"
#include "python/binding/binding.h"

/// Computations that Python waits for, and that it can stop waiting for.
namespace epsnet::python {

/// What a computation and the thread that waits for it share.
class JobState {
 public:
  /// For the computation: tells its progress, and throws once nobody waits for it.
  [[nodiscard]] static Progress progress(const std::shared_ptr<JobState>& state);
  /// Runs the computation, and tells that it has ended.
  void run(const std::function<void()>& computation);
  /// Waits until the computation has ended, without the GIL, and throws what it threw. Some twenty times a second it
  /// looks for a signal (Ctrl-C is KeyboardInterrupt), calls epsnet._progress.poll, and `callback(what, share)` unless
  /// that is None. If one of these raises, tells the computation to end, and throws that within half a second.
  void wait(const py::object& callback);

 private:
  void look(const py::object& callback);
  void abandon();

  std::mutex mutex_;
  std::condition_variable ended_signal_;
  bool ended_ = false;
  bool abandoned_ = false;
  bool told_ = false;  ///< Whether there is progress that `callback` was not called with.
  std::string what_;
  double share_ = 0;
  std::exception_ptr error_;
};

/// Returns `function(progress)`, or `function()`, computed in a thread of its own while other Python threads run.
///
/// Ctrl-C ends the wait within a second, wherever the computation is: one that does not look at its progress goes on
/// alone, and its result is thrown away. So `function` owns what it needs (it is copied), and touches no Python object.
template <class Function>
auto interruptible(Function function, const py::object& callback = py::none()) {
  static constexpr bool kTells = std::is_invocable_v<Function&, const Progress&>;
  using Result = typename std::conditional_t<kTells, std::invoke_result<Function&, const Progress&>,
                                             std::invoke_result<Function&>>::type;
  static constexpr bool kReturns = !std::is_void_v<Result>;
  struct Job : JobState {
    Function function;
    std::conditional_t<kReturns, std::optional<Result>, std::monostate> result;
    explicit Job(Function f) : function(std::move(f)) {}
  };
  const auto job = std::make_shared<Job>(std::move(function));
  std::thread([job] {
    job->run([&] {
      const auto compute = [&] {
        if constexpr (kTells) {
          return job->function(JobState::progress(job));
        } else {
          return job->function();
        }
      };
      if constexpr (kReturns) {
        job->result.emplace(compute());
      } else {
        compute();
      }
    });
  }).detach();
  job->wait(callback);
  if constexpr (kReturns) return std::move(*job->result);
}

/// Warns in Python of what a picture leaves out.
void warn_of(const std::vector<std::string>& left_out);

/// Returns the picture that `make()` returns as SVG, computed as in `interruptible`. Warns of what is left out.
std::string svg_of(const std::function<PolygonPicture()>& make, std::uint32_t size);

/// Writes a file, completely or not at all; nothing if the wait is ended. `write` owns what it needs.
void save(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

}  // namespace epsnet::python
