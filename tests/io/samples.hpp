// States, rows and folders for the tests of src/io.
#pragma once
#include <filesystem>
#include <string>

#include "io/run_file.hpp"
#include "pmr/base/random.hpp"

namespace pmr::test {

// Keeps folders of tests that run at the same time apart.
unsigned long process_id();

// A folder of its own, gone at the end of the test.
class Folder {
 public:
  explicit Folder(const std::string& name)
      : path_(std::filesystem::temp_directory_path() /
              ("pmr_" + name + "_" + std::to_string(process_id()))) {
    std::filesystem::remove_all(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// Every member set, numbers of all magnitudes.
State random_state(std::size_t particles, std::uint64_t seed);
io::Snapshot random_snapshot(double time, std::size_t particles);
io::Series rows(double first, std::size_t count);  // times first, first + 1, ... [s]
io::RunHeader header();

}  // namespace pmr::test
