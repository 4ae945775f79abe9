#include "cli/shipped_cases.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "case/nearest.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::cli {
namespace {

namespace fs = std::filesystem;

// Beside the program, be it installed (PREFIX/bin) or in its build folder, which holds a link.
fs::path shipped_folder() {
  std::error_code none;  // no /proc: nothing shipped is found, files still are
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  return (program.parent_path() / "../share/pmr/cases").lexically_normal();
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

fs::path find(const fs::path& named, const fs::path& folder, const char* kind) {
  std::error_code error;
  if (fs::exists(named, error) || named.has_parent_path()) return named;
  const std::string name = named.extension() == ".toml" ? named.stem() : named;
  const auto names = names_in(folder);
  if (std::binary_search(names.begin(), names.end(), name)) return folder / (name + ".toml");
  const std::string meant = casefile::nearest(name, names);
  throw CaseError({{named.string(), "",
                    fmt::format("is neither a file here nor a shipped {}{}; shipped: {}", kind,
                                meant.empty() ? "" : "; did you mean '" + meant + "'?",
                                fmt::join(names, ", "))}});
}

}  // namespace

fs::path find_case(const fs::path& named) { return find(named, shipped_folder(), "case"); }
fs::path find_study(const fs::path& named) {
  return find(named, shipped_folder() / "studies", "study");
}

}  // namespace pmr::cli
