#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <system_error>
#include <thread>

namespace coherency {

/// Calls work(i) for every i below `count`, in no order, on as many threads as there are cores (at most 8)
/// and as the count is worth. What work(i) writes must be its own; then the outcome does not depend on the
/// threads. It must not throw.
template <class Work>
void parallelFor(std::size_t count, const Work& work) {
  constexpr std::size_t kChunk = 64;
  std::atomic<std::size_t> next{0};
  const auto run = [&] {
    for (std::size_t begin = next.fetch_add(kChunk); begin < count; begin = next.fetch_add(kChunk))
      for (std::size_t i = begin, end = std::min(begin + kChunk, count); i < end; ++i) work(i);
  };
  const std::size_t cores = std::clamp(std::thread::hardware_concurrency(), 1U, 8U);
  std::array<std::thread, 7> helpers;  // no list: what is done by this thread alone allocates nothing
  try {
    const std::size_t worth = std::min(cores, count / (2 * kChunk) + 1) - 1;
    for (std::size_t n = 0; n < worth; ++n) helpers.at(n) = std::thread(run);
  } catch (const std::system_error&) {
    // The system gives no more threads: those there are, this one if no other, do all of it.
  }
  run();
  for (std::thread& helper : helpers)
    if (helper.joinable()) helper.join();
}

}  // namespace coherency
