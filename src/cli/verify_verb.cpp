// pmr verify: the verification table.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/console.hpp"
#include "cli/verbs.hpp"
#include "verify/check.hpp"

namespace pmr::cli {
namespace {

void print_table(const std::vector<verify::Check>& checks) {
  for (const auto& check : checks)
    fmt::print("{:4}  {:48} {:>14.7g} {:>14.7g} +- {:<9.2g} {:10} {}\n      {}\n",
               check.passes() ? "ok" : "MISS", check.id, check.measured, check.expected,
               check.tolerance, check.unit, check.what, check.source);
}

void print_json(const std::vector<verify::Check>& checks) {
  auto list = nlohmann::ordered_json::array();
  for (const auto& check : checks)
    list.push_back({{"id", check.id},
                    {"what", check.what},
                    {"measured", check.measured},
                    {"expected", check.expected},
                    {"tolerance", check.tolerance},
                    {"unit", check.unit},
                    {"source", check.source},
                    {"passes", check.passes()}});
  fmt::print("{}\n", list.dump(2));
}

}  // namespace

int verify(bool json) {
  const auto checks = verify::all_checks();
  json ? print_json(checks) : print_table(checks);
  std::size_t missed = 0;
  for (const auto& check : checks) missed += check.passes() ? 0 : 1;
  if (!json) fmt::print("{} checks, {} missed\n", checks.size(), missed);
  return missed == 0 ? done : failed;
}

}  // namespace pmr::cli
