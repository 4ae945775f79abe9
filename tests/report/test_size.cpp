// Slow: the report of a bed of full size, read from its folder.
#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <chrono>

#include "real_run.hpp"
#include "report/report.hpp"
#include "synthetic_run.hpp"

using namespace pmr;
using namespace pmr::report;

TEST_CASE("A run of 193,132 particles gets a page below 15 MB within a minute") {
  const auto folder = std::filesystem::temp_directory_path() / "pmr_test_full_size";
  RunData full = synthetic_run(193132, "full");
  full.series = real_run("course").series;
  full.summary = real_run("course").summary;
  write_folder(full, folder);
  const auto begin = std::chrono::steady_clock::now();
  write_report({folder}, folder / "report.html");
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  const auto size = std::filesystem::file_size(folder / "report.html");
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  WARN("report: " << taken.count() << " s, " << 1e-6 * static_cast<double>(size)
                  << " MB; the whole test " << used.ru_maxrss / 1024 << " MiB");
  CHECK(taken.count() < 60.0);
  CHECK(size < 15'000'000);
  std::filesystem::remove_all(folder);
}
