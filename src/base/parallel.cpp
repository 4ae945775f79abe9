#include "pmr/base/parallel.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <thread>

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace pmr {
namespace {

// ThreadSanitizer does not see that TBB (a library built without it) starts tasks after what came
// before the loop and ends the loop after its tasks; told here.
#ifdef __SANITIZE_THREAD__
void happens_before(void* what) { __tsan_release(what); }
void happens_after(void* what) { __tsan_acquire(what); }
#else
void happens_before(void*) {}
void happens_after(void*) {}
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
  char begin = 0, end = 0;  // of the loop
  happens_before(&begin);
  tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t b) {
    happens_after(&begin);
    run(b);
    happens_before(&end);
  });
  happens_after(&end);
}

}  // namespace pmr
