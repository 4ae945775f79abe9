// Studies of the tiny reactor, written to a folder that goes with the value.
#pragma once
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "pmr/base/errors.hpp"
#include "study/plan.hpp"

namespace pmr::test {

class StudyFile {
 public:
  explicit StudyFile(const std::string& text)
      : folder_(std::filesystem::temp_directory_path() /
                ("pmr-study-" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
    std::ofstream(path()) << "title = \"T\"\nteaches = \"tests\"\ncase = \"" PMR_SOURCE_DIR
                             "/tests/sim/tiny.toml\"\n"
                          << text;
  }
  ~StudyFile() { std::filesystem::remove_all(folder_); }
  StudyFile(const StudyFile&) = delete;
  StudyFile& operator=(const StudyFile&) = delete;
  std::filesystem::path path() const { return folder_ / "study.toml"; }

 private:
  std::filesystem::path folder_;
};

inline study::Study read(const std::string& text, const std::vector<std::string>& sets = {}) {
  return study::read_study(StudyFile(text).path(), sets);
}

inline std::vector<Fault> faults_of(const std::string& text) {
  try {
    read(text);
  } catch (const CaseError& error) {
    return error.faults();
  }
  return {};
}

inline const std::string response = "[responses.delta]\nkey = \"chemistry/delta_final\"\n";

}  // namespace pmr::test
