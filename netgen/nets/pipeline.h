#pragma once

#include <cstddef>
#include <cstdint>

#ifdef EPSNET_ONE_THREAD
#include <functional>
#include <queue>
#include <utility>
#else
#include <oneapi/tbb/concurrent_queue.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>
#endif

#ifdef EPSNET_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

/// The threads of a refinement in parts: those of oneTBB, or the calling one alone where there are no others
/// (EPSNET_ONE_THREAD). The only place that knows the difference.
namespace epsnet {

// The thread sanitizer does not see inside oneTBB and must be told the order of events: everything that a thread did
// before it passed an object on happens before what the receiving thread does.
#ifdef EPSNET_THREAD_SANITIZER
inline void receive(void* something) { __tsan_acquire(something); }
inline void hand_on(void* something) { __tsan_release(something); }
#else
inline void receive(void* /*something*/) {}
inline void hand_on(void* /*something*/) {}
#endif

#ifdef EPSNET_ONE_THREAD

/// An object for each thread, made when that thread first asks for it.
template <class T>
class ForEachThread {
 public:
  explicit ForEachThread(const std::function<T()>& make) : object_(make()) {}
  [[nodiscard]] T& local() { return object_; }

 private:
  T object_;
};

/// A queue that threads share.
template <class T>
class SharedQueue {
 public:
  void push(T item) { queue_.push(std::move(item)); }
  /// Returns whether there was an item.
  [[nodiscard]] bool try_pop(T& item) {
    if (queue_.empty()) return false;
    item = std::move(queue_.front());
    queue_.pop();
    return true;
  }

 private:
  std::queue<T> queue_;
};

/// Runs the function with this many threads.
template <class Function>
auto with_threads(unsigned /*threads*/, const Function& function) {
  return function();
}

/// The number of threads here.
[[nodiscard]] inline int threads_here() { return 1; }

/// For each k < count calls last(middle(first(k))): the middle calls one at a time, in the order of k, the others
/// concurrently. At most `tokens` numbers are on their way at once.
template <class Item, class First, class Middle, class Last>
void pipeline(std::uint32_t count, std::size_t /*tokens*/, const First& first, const Middle& middle, const Last& last) {
  for (std::uint32_t k = 0; k < count; ++k) last(middle(first(k)));
}

#else

template <class T>
using ForEachThread = oneapi::tbb::enumerable_thread_specific<T>;

template <class T>
using SharedQueue = oneapi::tbb::concurrent_queue<T>;

template <class Function>
auto with_threads(unsigned threads, const Function& function) {
  // As many threads as requested, even on fewer cores.
  const oneapi::tbb::global_control control(oneapi::tbb::global_control::max_allowed_parallelism, threads);
  oneapi::tbb::task_arena arena(static_cast<int>(threads));
  return arena.execute(function);
}

[[nodiscard]] inline int threads_here() { return oneapi::tbb::this_task_arena::max_concurrency(); }

template <class Item, class First, class Middle, class Last>
void pipeline(std::uint32_t count, std::size_t tokens, const First& first, const Middle& middle, const Last& last) {
  namespace tbb = oneapi::tbb;
  std::uint32_t next = 0;
  hand_on(&next);
  const auto choose = [&](tbb::flow_control& flow) {
    receive(&next);
    if (next == count) flow.stop();
    const std::uint32_t k = next++;
    hand_on(&next);
    return k;
  };
  tbb::parallel_pipeline(tokens, tbb::make_filter<void, std::uint32_t>(tbb::filter_mode::serial_in_order, choose) &
                                     tbb::make_filter<std::uint32_t, Item>(tbb::filter_mode::parallel, first) &
                                     tbb::make_filter<Item, Item>(tbb::filter_mode::serial_in_order, middle) &
                                     tbb::make_filter<Item, void>(tbb::filter_mode::parallel, last));
}

#endif

}  // namespace epsnet
