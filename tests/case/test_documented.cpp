// docs/case-reference.md held against the keys that the reader asks for. What is read comes from
// the reader itself, as it goes through the cases below; that these cases come by every key is held
// against the keys that the reader's sources spell.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "case/case.hpp"

namespace fs = std::filesystem;
using pmr::casefile::keys_asked_for;
using Names = std::set<std::string>;

namespace {

// All that stands by itself, and one of each choice; NAME is any name.
const std::string one_of_each = R"(
[domain]
[species.NAME]
material = "NAME"
pour = {}
region = {}
[species.NAME2]
material = "NAME"
pour = {low = "0 0 0 m", particle_rate = "1 Hz"}
region = {low = "0 0 0 m"}
diameter = {value = "1 mm", mark = "A"}
[species.NAME3]
material = "NAME"
size = {law = "classes"}
delta = {equilibrium_at = "1000 K"}
[species.NAME4]
material = "NAME"
size = {law = "normal", mean = "1 mm", deviation = "0.1 mm"}
region = {rig = "NAME"}
[species.NAME5]
material = "NAME"
size = {law = "log-normal"}
[species.NAME6]
material = "NAME"
size = {law = "rosin-rammler"}
[species.NAME7]
material = "NAME"
size = {law = "csv"}
[[particles]]
[materials.NAME]
heat = {law = "constant"}
conductivity = {law = "constant"}
emissivity = {temperature = "300 K"}
[materials.NAME.redox]
equilibrium = {enthalpy = "arctan", arctan = {}}
rate = {law = "power", oxidation_energy = "1 J/mol"}
pores = {}
[materials.NAME2]
heat = {law = "shomate"}
conductivity = {law = "table"}
[materials.NAME2.redox]
equilibrium = {enthalpy = "polynomial", polynomial = {}}
rate = {law = "relaxation"}
[materials.NAME3]
heat = {law = "oxide"}
conductivity = {law = "alumina"}
[materials.NAME4]
heat = {law = "polynomial"}
conductivity = {law = "polynomial"}
emissivity = {coefficients = 1}
[materials.NAME3.redox]
equilibrium = {}
rate = {law = "vacancies"}
[contacts."NAME|NAME"]
[walls.NAME]
kind = "plane"
motion = {kind = "fall"}
thermal = {kind = "fixed"}
[walls.NAME2]
kind = "disc"
motion = {kind = "translate"}
thermal = {kind = "lining", layers = [{}]}
[walls.NAME3]
kind = "cylinder"
motion = {kind = "oscillate"}
[walls.NAME4]
kind = "cone"
motion = {kind = "rotate"}
[walls.NAME5]
kind = "box"
[walls.NAME6]
kind = "stl"
grains = {csv = ""}
[walls.NAME7]
kind = "rectangle"
grains = {}
moves_with = "NAME"
[rig]
[rig.valves.NAME]
[fill]
[mix]
[react]
[chamber]
closing = "1 s"
pump = {speed = {pressure = "1 Pa"}}
vent = {}
[models]
conduction = {contact_law = "liggghts", contact_area = "soft"}
radiation = {law = "traced"}
bed_gas = true
[decomposition]
[thermocouples.NAME]
[conductivity]
[catch.NAME]
[heap]
along = [1, 0, 0]
[wall_force.NAME]
[output]
)";
const std::string particles_of_a_sheet = "particles = {csv = \"\"}\n";

Names all_asked_for() {
  Names all = keys_asked_for(one_of_each);
  all.merge(keys_asked_for(particles_of_a_sheet));
  return all;
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> matches(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> all;
  for (auto it = std::sregex_iterator(text.begin(), text.end(), regex);
       it != std::sregex_iterator(); ++it)
    all.push_back((*it)[1]);
  return all;
}

bool is_name(const std::string& part) {  // of the user's own, or an index into a list
  return part.rfind("NAME", 0) == 0 || std::isdigit(static_cast<unsigned char>(part[0])) != 0 ||
         part.front() == '"';
}

// "walls.NAME.radius" -> walls, NAME, radius. No name of these cases holds a dot.
std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> parts;
  std::istringstream in(path);
  for (std::string part; std::getline(in, part, '.');) parts.push_back(part);
  return parts;
}

Names last_parts(const Names& paths) {
  Names names;
  for (const std::string& path : paths) names.insert(parts_of(path).back());
  return names;
}

// Sides of a figure, which any number may have.
const Names of_figures{"value", "mark", "source", "range"};

// Words in backticks by the table of the case ("walls") under whose heading they stand.
std::map<std::string, Names> documented() {
  const std::map<std::string, std::vector<std::string>> tables{
      {"Top level", {"", "domain"}},
      {"`[species.NAME]`", {"species", "particles"}},
      {"Beds", {}},
      {"`[materials.NAME]`", {"materials", "contacts"}},
      {"`[walls.NAME]`", {"walls"}},
      {"`[rig]`: the demonstrator", {"rig"}},
      {"Phases", {"fill", "mix", "react"}},
      {"`[chamber]`", {"chamber"}},
      {"`[models]`: numerics", {"models"}},
      {"Instruments and output",
       {"decomposition", "thermocouples", "conductivity", "catch", "heap", "wall_force",
        "output"}}};
  std::map<std::string, Names> words;
  std::istringstream in(text_of(fs::path(PMR_SOURCE_DIR) / "docs/case-reference.md"));
  std::vector<std::string> under;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("## ", 0) == 0) {
      INFO("heading " << line);
      REQUIRE(tables.contains(line.substr(3)));
      under = tables.at(line.substr(3));
    }
    for (const std::string& code : matches(line, "`([^`]*)`"))
      for (const std::string& word : matches(code, "([a-z][a-z_0-9]*)"))
        for (const std::string& table : under) words[table].insert(word);
  }
  return words;
}

}  // namespace

TEST_CASE("every key that is read is documented under the heading of its table") {
  const auto words = documented();
  for (const std::string& path : all_asked_for()) {
    const std::vector<std::string> parts = parts_of(path);
    const std::string table = parts.size() == 1 ? "" : parts.front();
    if (is_name(parts.back()) || of_figures.contains(parts.back())) continue;
    if (table.empty() && words.contains(parts.back())) continue;  // a table with its own heading
    INFO(path << " is read; docs/case-reference.md does not name it under [" << table << "]");
    CHECK(words.at(table).contains(parts.back()));
  }
}

TEST_CASE("every key that has a row in the reference is read") {
  const Names read = last_parts(all_asked_for());
  std::istringstream in(text_of(fs::path(PMR_SOURCE_DIR) / "docs/case-reference.md"));
  std::size_t rows = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("| ", 0) != 0) continue;
    const std::string first = line.substr(0, line.find('|', 1));
    for (const std::string& code : matches(first, "`([^`]*)`")) {
      if (code.front() == '"') continue;  // a choice, not a key
      ++rows;
      for (const std::string& part : parts_of(code)) {
        if (part.empty() || part == "NAME" || part.front() == '_') continue;
        INFO(part << " of " << code << " is documented, and nothing reads it");
        CHECK(read.contains(part));
      }
    }
  }
  CHECK(rows > 100);
}

TEST_CASE("the cases of this test come by every key that the reader's sources spell") {
  const Names read = last_parts(all_asked_for());
  std::size_t spelt = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(PMR_SOURCE_DIR) / "src/case")) {
    if (entry.path().extension() != ".cpp") continue;
    for (const std::string& key :
         matches(text_of(entry.path()),
                 "[^a-z_](?:value|values|maybe|vector|direction|count|flag|word|word_or|choice|"
                 "need|look|"
                 "need_table|look_table|file|file_if_any|moves_nothing|length|energy)"
                 "\\(\"([a-z_0-9]+)\"")) {
      ++spelt;
      INFO(key << " in " << entry.path() << ": let a case of this test come by it");
      CHECK(read.contains(key));
    }
  }
  CHECK(spelt > 150);
}
