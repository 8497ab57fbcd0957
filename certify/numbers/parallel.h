#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

#include "certify/numbers/ball.h"

namespace epsnet::certify {

/// The number of threads that a request means: 0 stands for as many as the machine has cores.
[[nodiscard]] inline unsigned thread_count(unsigned requested) {
  return requested != 0 ? requested : std::max(std::thread::hardware_concurrency(), 1U);
}

/// Calls body(worker, i) for every i < count, each exactly once, by up to `threads` threads (at least 1; the calling
/// one is worker 0). The others do its work where a thread cannot be started. Returns when all are done. If a call
/// throws, no new ones are started and the first exception to arrive is thrown again. Balls round as in the calling
/// thread. Results must be stored by i, so that they do not depend on the number of threads.
template <class Body>
void for_each_parallel(std::size_t count, unsigned threads, const Body& body) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto work = [&](unsigned worker) {
    try {
      for (std::size_t i = next++; i < count; i = next++) body(worker, i);
    } catch (...) {
      next = count;
      const std::lock_guard lock(failure_mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    // Their destructors wait for threads that run; what is deferred as no thread could be started is never called.
    std::vector<std::future<void>> helpers;
    const std::size_t workers = std::min<std::size_t>(std::max(threads, 1U), count);
    for (unsigned worker = 1; worker < workers; ++worker) {
      helpers.push_back(
          std::async(std::launch::async | std::launch::deferred, [&work, worker, bits = Precision::current()] {
            const Precision scope(bits);
            work(worker);
            // FLINT keeps memory and constants for each thread until it is asked for them.
            flint_cleanup();
          }));
    }
    work(0);
  }
  if (failure) std::rethrow_exception(failure);
}

/// Calls body(block, first, last) for blocks of consecutive numbers less than count, block 0 being the first of them,
/// as for_each_parallel does.
template <class Body>
void for_each_block(std::size_t count, unsigned threads, const Body& body) {
  constexpr std::size_t kBlock = std::size_t{1} << 14;
  for_each_parallel((count + kBlock - 1) / kBlock, threads, [&](unsigned, std::size_t block) {
    body(block, block * kBlock, std::min(count, (block + 1) * kBlock));
  });
}

/// What the blocks make, one after the other: result(first, last) for each.
template <class Result>
[[nodiscard]] auto results_of_blocks(std::size_t count, unsigned threads, const Result& result) {
  std::vector<decltype(result(count, count))> results;
  for_each_block(count, 1, [&](std::size_t, std::size_t, std::size_t) { results.emplace_back(); });
  for_each_block(count, threads,
                 [&](std::size_t block, std::size_t first, std::size_t last) { results[block] = result(first, last); });
  return results;
}

}  // namespace epsnet::certify
