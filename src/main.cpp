// pmr: the Particle Mix Reactor. The command line in, an exit status out:
// 0 done, 2 the user's input is wrong, 3 the simulation failed, 130 interrupted.
#include <malloc.h>

#include "cli/console.hpp"

namespace {

// Each evaluation of the heat network makes vectors of a number a particle and drops them. Without
// this, the C library gives such memory back to the kernel each time and has it handed out again,
// page by page, which takes half of the network's time with 193,130 particles (docs/benchmarks.md).
void keep_memory() {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // [bytes] the largest that is allowed
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
}

}  // namespace

int main(int argc, char** argv) {
  keep_memory();
  return pmr::cli::console(argc, argv);
}
