// Users compile the sources of a folder together (PMR_UNITY), so that a name of an unnamed
// namespace is seen by the folder's other sources. Two functions of one name and unlike arguments
// would compile, and a call might silently take the other one.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace fs = std::filesystem;

namespace {

const fs::path source_root = PMR_SOURCE_DIR;

// The name that a line at the left margin declares: of a function, a constant or a type.
std::string declared_name(const std::string& line) {
  static const std::regex function(
      R"((?:template\b.*> ?)?(?:\[\[.*?\]\] )?[A-Za-z_][\w:<>,*& ]*[ *&](\w+)\(.*)");
  static const std::regex constant(R"((?:constexpr|const|inline)\b.* (\w+)(?:\[\])? ?[={].*)");
  static const std::regex type(R"((?:struct|class|enum class|using) (\w+)\b.*[{=].*)");
  if (line.rfind("return", 0) == 0 || line.rfind("TEST_CASE", 0) == 0) return {};
  std::smatch found;
  for (const std::regex& kind : {type, constant, function})
    if (std::regex_match(line, found, kind)) return found[1];
  return {};
}

// Names at the left margin of the unnamed namespaces of a source as this project writes them.
std::set<std::string> names_of(const fs::path& source) {
  std::set<std::string> names;
  std::ifstream in(source);
  bool is_unnamed = false;
  for (std::string line; std::getline(in, line);) {
    if (line == "namespace {") is_unnamed = true;
    if (line == "}  // namespace") is_unnamed = false;
    if (is_unnamed) names.insert(declared_name(line));
  }
  names.erase("");
  return names;
}

}  // namespace

TEST_CASE("A name in an unnamed namespace stands once in its folder") {
  std::map<std::pair<fs::path, std::string>, std::set<std::string>> files_of;  // by folder and name
  for (const char* top : {"physics", "radiation", "chemistry", "src", "tests"})
    for (const auto& entry : fs::recursive_directory_iterator(source_root / top))
      if (entry.path().extension() == ".cpp")
        for (const std::string& name : names_of(entry.path()))
          files_of[{entry.path().parent_path(), name}].insert(entry.path().filename().string());
  CHECK(files_of.size() > 1500);
  for (const auto& [where, files] : files_of) {
    INFO(where.first.string() << ": " << where.second << " in " << *files.begin() << " and "
                              << *files.rbegin());
    CHECK(files.size() == 1);
  }
}
