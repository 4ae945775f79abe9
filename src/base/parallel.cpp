#include "pmr/base/parallel.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <thread>

#ifdef __SANITIZE_THREAD__
#include <atomic>
#include <future>
#include <vector>
#endif

namespace pmr {
namespace {

#ifdef __SANITIZE_THREAD__
// ThreadSanitizer does not see how TBB (a library built without it) orders its tasks: threads of
// the standard library take its place. The counter orders nothing, so that no race is hidden.
void for_all(std::size_t count, const std::function<void(std::size_t)>& run) {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t b; (b = next.fetch_add(1, std::memory_order_relaxed)) < count;) run(b);
  };
  std::vector<std::future<void>> threads;
  for (int k = 0; k < ThreadLimit::current(); ++k)
    threads.push_back(std::async(std::launch::async, work));
  for (auto& thread : threads) thread.get();
}
#else
void for_all(std::size_t count, const std::function<void(std::size_t)>& run) {
  tbb::parallel_for(std::size_t{0}, count, run);
}
#endif

}  // namespace

ThreadLimit::ThreadLimit(int n)
    : control_(new tbb::global_control(
          tbb::global_control::max_allowed_parallelism,
          n > 0 ? static_cast<std::size_t>(n)
                : static_cast<std::size_t>(std::max(1U, std::thread::hardware_concurrency())))) {}

ThreadLimit::~ThreadLimit() { delete static_cast<tbb::global_control*>(control_); }

int ThreadLimit::current() {
  return static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

void parallel_blocks(std::size_t count, const std::function<void(std::size_t, std::size_t)>& body,
                     std::size_t block) {
  const std::size_t blocks = (count + block - 1) / block;
  const auto run = [&](std::size_t b) { body(b * block, std::min(count, (b + 1) * block)); };
  if (blocks <= 1 || ThreadLimit::current() == 1) {
    for (std::size_t b = 0; b < blocks; ++b) run(b);
    return;
  }
  for_all(blocks, run);
}

}  // namespace pmr
