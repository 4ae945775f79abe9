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

// "settling", "lab/repose-AA", "long/demonstrator-bed": those of the folder and of folders in it.
std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::path& within : {fs::path(), fs::path("lab"), fs::path("long")}) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder / within, error))
      if (entry.path().extension() == ".toml")
        names.push_back((within / entry.path().stem()).string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

fs::path find(const fs::path& named, const fs::path& folder, const char* kind) {
  std::error_code error;
  const std::string name =
      named.extension() == ".toml" ? (named.parent_path() / named.stem()).string() : named.string();
  const auto names = names_in(folder);
  const bool is_shipped = std::binary_search(names.begin(), names.end(), name);
  if (fs::exists(named, error) || (named.has_parent_path() && !is_shipped)) return named;
  if (is_shipped) return folder / (name + ".toml");
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

fs::path find_lab(const fs::path& named) {
  return find(named, shipped_folder() / "calibration", "lab");
}

std::vector<fs::path> find_experiments(const std::vector<fs::path>& named) {
  const fs::path folder = shipped_folder() / "validation";
  std::vector<fs::path> found;
  for (const fs::path& one : named) found.push_back(find(one, folder, "experiment"));
  if (named.empty())
    for (const std::string& name : names_in(folder))
      if (name.find('/') == std::string::npos) found.push_back(folder / (name + ".toml"));
  return found;
}

}  // namespace pmr::cli
