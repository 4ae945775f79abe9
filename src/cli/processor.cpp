// Tells a processor without AVX2 what is missing, before anything compiled for AVX2 runs: first of
// all constructors, compiled for every x86-64 and calling nothing but the kernel.
#include <unistd.h>

namespace {

constexpr char missing[] =
    "pmr: this processor lacks AVX2 or FMA, which pmr is built for; it runs on x86-64 with both "
    "(Intel from Haswell, AMD from Excavator on)\n";

[[gnu::constructor(101)]] void check_processor() {
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
      __builtin_cpu_supports("bmi2"))
    return;
  [[maybe_unused]] const auto told = write(STDERR_FILENO, missing, sizeof missing - 1);
  _exit(3);
}

}  // namespace
