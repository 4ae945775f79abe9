// A small valid case, changed by each test, and its faults as text.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::test {

// Line numbers count from 1 at `title`.
inline const std::string small_case = R"(title = "test"
gravity = "0 0 -9.80665 m/s2"
[domain]
low = "-1 -1 -1 m"
high = "1 1 1 m"
[species.bead]
material = "Al2O3"
diameter = "2.99 mm"
mass = "10 g"
temperature = "20 degC"
region = {base = "0 0 0 m", radius = "20 mm", height = "80 mm"}
[walls.floor]
kind = "plane"
material = "coated-wall"
point = "0 0 0 m"
normal = [0, 0, 1]
[fill]
duration = "1 s"
rest_speed = "2 mm/s"
rest_hold = "20 ms"
)";

inline std::string temporary(const std::string& name) {
  return (std::filesystem::temp_directory_path() / name).string();
}

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  ensure(at != std::string::npos, "the text to replace is there");
  return text.replace(at, what.size(), by);
}

inline Case load(const std::string& text, const std::vector<std::string>& sets = {}) {
  return casefile::load_case_text(text, "x.toml", PMR_SOURCE_DIR, sets);
}

inline std::vector<std::string> faults_of(const std::string& text,
                                          const std::vector<std::string>& sets = {}) {
  std::vector<std::string> lines;
  try {
    load(text, sets);
  } catch (const CaseError& error) {
    for (const Fault& fault : error.faults()) lines.push_back(to_string(fault));
  }
  return lines;
}

// The only fault of the small case with one text replaced.
inline std::string only_fault(const std::string& what, const std::string& by) {
  const std::vector<std::string> lines = faults_of(replaced(small_case, what, by));
  std::string all;
  for (const std::string& line : lines) all += (all.empty() ? "" : "\n") + line;
  return all;
}

}  // namespace pmr::test
