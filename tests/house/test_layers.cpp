// The house as a test: one-way layers, no include cycles, foreign libraries in one file each.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

const fs::path root = PMR_SOURCE_DIR;

// Folder -> the folders whose headers it may include (besides its own).
const std::map<std::string, std::set<std::string>> allowed = {
    {"include/pmr/base", {}},
    {"src/base", {"include/pmr/base"}},
    {"include/pmr/state", {"include/pmr/base"}},
    {"physics", {"include/pmr/base", "include/pmr/state"}},
    {"radiation", {"include/pmr/base", "include/pmr/state"}},
    {"chemistry", {"include/pmr/base", "include/pmr/state"}},
    {"src/io", {"include/pmr/base", "include/pmr/state"}},
    {"src/case", {"include/pmr/base", "include/pmr/state", "physics", "radiation", "chemistry"}},
    {"src/coupling",
     {"include/pmr/base", "include/pmr/state", "physics", "radiation", "chemistry"}},
    {"src/instruments",
     {"include/pmr/base", "include/pmr/state", "physics", "radiation", "chemistry", "src/io"}},
    {"src/sim",
     {"include/pmr/base", "include/pmr/state", "physics", "radiation", "chemistry", "src/io",
      "src/case", "src/coupling", "src/instruments"}},
    {"src/verify",
     {"include/pmr/base", "include/pmr/state", "physics", "radiation", "chemistry", "src/io",
      "src/case", "src/coupling", "src/instruments", "src/sim"}},
    {"src/report",
     {"include/pmr/base", "include/pmr/state", "physics", "radiation", "chemistry", "src/io",
      "src/case", "src/coupling", "src/instruments", "src/sim"}},
    {"src/statistics", {"include/pmr/base"}},
    {"src/study",
     {"include/pmr/base", "include/pmr/state", "src/io", "src/case", "src/sim", "src/report",
      "src/statistics"}},
    {"src/calibrate",
     {"include/pmr/base", "include/pmr/state", "src/io", "src/case", "src/report", "src/statistics",
      "src/study"}},
    {"src/validate",
     {"include/pmr/base", "include/pmr/state", "src/io", "src/case", "src/report", "src/statistics",
      "src/study"}},
    {"src/cli",
     {"include/pmr/base", "include/pmr/state", "physics", "radiation", "chemistry", "src/io",
      "src/case", "src/coupling", "src/instruments", "src/sim", "src/verify", "src/report",
      "src/study", "src/calibrate", "src/validate"}},
};

// Foreign headers and the files, rarely more than one, that may include each.
const std::map<std::string, std::set<std::string>> foreign = {
    {"embree3/", {"radiation/scene.cpp"}},
    {"boost/", {"physics/wall_tree.cpp"}},
    {"hdf5.h", {"src/io/hdf5.cpp", "src/io/hdf5_disk.hpp"}},
    {"toml++/", {"src/case/toml_file.cpp"}},
    {"udunits2", {"src/case/units.cpp"}},
    {"cvodes/", {"src/coupling/cvode.cpp"}},
    {"nvector/", {"src/coupling/vectors.cpp"}},
    {"sunlinsol/", {"src/coupling/cvode.cpp"}},
    {"sunnonlinsol/", {"src/coupling/cvode.cpp"}},
    {"sundials/", {"src/coupling/cvode.cpp", "src/coupling/vectors.cpp"}},
    {"tbb/", {"src/base/parallel.cpp"}},
    {"png.h", {"src/report/png.cpp"}},
    {"openturns/",
     {"src/statistics/design.cpp", "src/statistics/expression.cpp", "src/statistics/likelihood.cpp",
      "src/statistics/ranking.cpp"}},
};

struct Include {
  std::string file;    // relative to the root, '/' separated
  std::string target;  // as written
};

bool is_source(const fs::path& path) {
  return path.extension() == ".cpp" || path.extension() == ".hpp";
}

std::vector<Include> includes_of(const fs::path& path) {
  std::vector<Include> found;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("#include", 0) != 0) continue;
    const auto open = line.find_first_of("<\"");
    const auto close = line.find_first_of(">\"", open + 1);
    found.push_back(
        {fs::relative(path, root).generic_string(), line.substr(open + 1, close - open - 1)});
  }
  return found;
}

std::vector<Include> all_includes() {
  std::vector<Include> all;
  for (const char* top : {"include", "physics", "radiation", "chemistry", "src"})
    for (const auto& entry : fs::recursive_directory_iterator(root / top))
      if (is_source(entry.path()))
        for (auto& include : includes_of(entry.path())) all.push_back(include);
  return all;
}

std::string folder_of(const std::string& file) { return file.substr(0, file.rfind('/')); }

// The project file that an include names, or "" for a foreign one.
std::string resolve(const std::string& target) {
  for (const char* base : {"", "include/", "src/"})
    if (target.find('/') != std::string::npos && fs::exists(root / (base + target)))
      return base + target;
  return {};
}

// Letters of a UTF-8 line: all bytes but those that continue a letter.
std::ptrdiff_t columns(const std::string& line) {
  return std::count_if(line.begin(), line.end(),
                       [](unsigned char byte) { return (byte & 0xC0) != 0x80; });
}

bool reaches(const std::map<std::string, std::set<std::string>>& graph, const std::string& from,
             const std::string& to, std::set<std::string>& seen) {
  const auto edges = graph.find(from);
  if (edges == graph.end() || !seen.insert(from).second) return false;
  return std::any_of(edges->second.begin(), edges->second.end(), [&](const std::string& next) {
    return next == to || reaches(graph, next, to, seen);
  });
}

}  // namespace

TEST_CASE("Every include points down the layers") {
  std::size_t seen = 0;
  for (const auto& [file, target] : all_includes()) {
    const std::string resolved = resolve(target);
    if (resolved.empty()) continue;
    ++seen;
    const std::string from = folder_of(file), to = folder_of(resolved);
    if (from == to || file == "src/main.cpp") continue;
    INFO(file << " includes " << target);
    REQUIRE(allowed.count(from) == 1);
    CHECK(allowed.at(from).count(to) == 1);
  }
  CHECK(seen > 20);
}

TEST_CASE("No header includes itself in a circle") {
  std::map<std::string, std::set<std::string>> graph;
  for (const auto& [file, target] : all_includes()) {
    const std::string resolved = resolve(target);
    if (!resolved.empty()) graph[file].insert(resolved);
  }
  for (const auto& [file, edges] : graph) {
    std::set<std::string> visited;
    INFO(file);
    CHECK_FALSE(reaches(graph, file, file, visited));
  }
}

TEST_CASE("A foreign library stands in a file of its own") {
  for (const auto& [file, target] : all_includes())
    for (const auto& [prefix, home] : foreign)
      if (target.rfind(prefix, 0) == 0) {
        INFO(file << " includes " << target);
        CHECK(home.count(file) == 1);
      }
}

TEST_CASE("Every source file is listed in a CMakeLists.txt") {
  std::set<fs::path> sources, listed;
  for (const char* top : {"physics", "radiation", "chemistry", "src", "tests"})
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      if (entry.path().extension() == ".cpp") sources.insert(entry.path());
      if (entry.path().filename() != "CMakeLists.txt") continue;
      std::ifstream in(entry.path());
      for (std::string word; in >> word;) {
        std::erase_if(word, [](char c) { return c == '(' || c == ')'; });
        listed.insert((entry.path().parent_path() / word).lexically_normal());
      }
    }
  CHECK(sources.size() > 100);
  for (const fs::path& source : sources) {
    INFO(source);
    CHECK(listed.count(source) == 1);
  }
}

TEST_CASE("No line of ours is wider than 100 columns") {
  const std::set<std::string> kinds{".cpp", ".hpp", ".js", ".css", ".py", ".cmake", ".txt", ""};
  std::size_t files = 0;
  for (const char* top :
       {"include", "physics", "radiation", "chemistry", "src", "tests", "bench", "scripts", ".ci"})
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      if (!entry.is_regular_file() || kinds.count(entry.path().extension()) == 0) continue;
      ++files;
      std::ifstream in(entry.path());
      std::size_t number = 0;
      for (std::string line; std::getline(in, line);) {
        ++number;
        INFO(entry.path() << ":" << number);
        if (columns(line) > 100) CHECK(columns(line) <= 100);
      }
    }
  CHECK(files > 400);
}

TEST_CASE("No file of ours is longer than 500 lines") {
  for (const char* top : {"include", "physics", "radiation", "chemistry", "src", "tests"})
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      if (!is_source(entry.path())) continue;
      std::ifstream in(entry.path());
      const auto lines = std::count(std::istreambuf_iterator<char>(in), {}, '\n');
      INFO(entry.path());
      CHECK(lines <= 500);
    }
}
