#include "cli/machine.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <fstream>
#include <thread>

#include "pmr/base/hash.hpp"
#include "pmr/base/parallel.hpp"
#include "version.hpp"

namespace pmr::cli {
namespace {

std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

std::string compiler() {
#if defined(__clang__)
  return fmt::format("clang {}", __clang_version__);
#else
  return fmt::format("gcc {}", __VERSION__);
#endif
}

}  // namespace

std::string hexadecimal(std::uint64_t value) { return fmt::format("{:016x}", value); }

std::map<std::string, std::string> provenance(const std::string& command,
                                              const std::string& case_text) {
  Hash hash;
  hash.add(std::string_view(case_text));
  return {{"version", pmr_version},
          {"git", pmr_git},
          {"compiler", compiler()},
          {"machine", processor()},
          {"cores", std::to_string(std::thread::hardware_concurrency())},
          {"threads", std::to_string(ThreadLimit::current())},
          {"started", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
          {"command", command},
          {"case_hash", hexadecimal(hash.value())}};
}

}  // namespace pmr::cli
