// A run folder of a test's own, whatever else runs at the same time; it goes with the value.
#pragma once
#include <unistd.h>

#include <filesystem>
#include <string>

#include "io/run_file.hpp"

namespace pmr::test {

struct Folder {
  std::filesystem::path path;
  explicit Folder(const std::string& name)
      : path(std::filesystem::temp_directory_path() /
             ("pmr-test-" + name + "-" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
    io::create_run(path, {});
  }
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
};

}  // namespace pmr::test
