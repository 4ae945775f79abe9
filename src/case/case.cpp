#include "case/case.hpp"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>

#include "case/backs.hpp"
#include "case/bulk_tests.hpp"
#include "case/extents.hpp"
#include "case/facing.hpp"
#include "case/parts.hpp"
#include "case/walls.hpp"
#include "physics/time_step.hpp"
#include "physics/upright.hpp"

namespace pmr::casefile {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  const auto refuse = [&](const std::string& problem) {
    throw CaseError({{file.string(), "", problem}});
  };
  if (fs::is_directory(file)) refuse("is a folder; wanted a case file");
  std::ifstream in(file, std::ios::binary);
  if (!in) refuse(std::string("cannot be read: ") + std::strerror(errno));
  return {std::istreambuf_iterator<char>(in), {}};
}

constexpr int deepest = 8;  // cases that lie on one another

using Folders = std::map<std::string, fs::path>;  // by the name of the file

// The names that "extends" gives: one, or a list.
std::vector<std::string> bases_named(const Node& extends) {
  std::vector<std::string> names;
  const auto add = [&](const Node& node) {
    if (node.kind != Node::Kind::string)
      throw CaseError({{to_string(node.place), "extends",
                        "wanted a case file's name in quotes, or a list of them"}});
    names.push_back(node.text);
  };
  if (extends.kind == Node::Kind::array)
    for (const Node& item : extends.items) add(item);
  else
    add(extends);
  return names;
}

// A case may lie on others: what it says replaces or adds to what "extends" names, and of those
// each to the one before. Whether there was such a base.
bool lay_on_base(Node& document, const fs::path& base_dir, Folders& folders, int depth = 0) {
  const Node* extends = document.find("extends");
  if (extends == nullptr) return false;
  const std::string place = to_string(extends->place);
  if (depth == deepest)
    throw CaseError({{place, "extends", "the cases extend each other in a circle"}});
  Node below;
  for (const std::string& name : bases_named(*extends)) {
    const fs::path file = base_dir / name;
    if (!fs::is_regular_file(file))
      throw CaseError({{place, "extends", "there is no case file " + file.string()}});
    Node base = parse_toml(text_of(file), file.string());
    folders[file.string()] = file.parent_path();
    lay_on_base(base, file.parent_path(), folders, depth + 1);
    merge(below, base);
  }
  document.members.erase("extends");
  merge(below, document);
  document = std::move(below);
  return true;
}

Vec3 read_gravity(Table& root) {
  const std::string wanted = "a vector such as \"0 0 -9.80665 m/s2\", or \"none\"";
  const Node* node = root.need("gravity", wanted);
  if (node == nullptr || (node->kind == Node::Kind::string && node->text == "none"))
    return Vec3::Zero();
  return root.vector("gravity", Dimension::acceleration);
}

void read_domain(Table& root, const std::optional<Rig>& rig, bool rig_is_faulty, Case& made) {
  if (rig) std::tie(made.domain_low, made.domain_high) = rig_domain(rig->size);
  const bool is_given = root.has("domain");
  const Node* node = rig || rig_is_faulty ? root.look_table("domain") : root.need_table("domain");
  if (!is_given || node == nullptr) return;
  Table table(root.reading(), *node, "domain");
  made.domain_low = table.vector("low", Dimension::length);
  made.domain_high = table.vector("high", Dimension::length);
  if ((made.domain_high - made.domain_low).minCoeff() <= 0.0)
    table.fault("high", "wanted each component above low");
}

void check_whole(Table& root, const Case& made) {
  if (!made.fill && !made.mix && !made.react)
    root.need("fill", "a phase: [fill], [mix] or [react]");
  const auto& models = made.models;
  if (made.react && !models.conduction && !models.radiation && !models.reaction)
    root.fault("react", "wanted [models.conduction], [models.radiation] or models.reaction = true");
  if (models.conduction && models.conduction->gap && !made.chamber)
    root.fault("models", "the gas gaps want [chamber] for the gas; or set conduction.gap = false");
  if (models.reaction && !made.chamber)
    root.fault("models", "the reaction wants [chamber] for the oxygen pressure");
  if (made.conductivity && (!made.chamber || !models.conduction || !models.radiation))
    root.fault("conductivity",
               "wanted [chamber], models.conduction and [models.radiation] with it");
  for (std::size_t k = 0; k < made.particles.size(); ++k) {
    const Vec3& at = made.particles[k].position;
    const bool outside = (at.array() < made.domain_low.array()).any() ||
                         (at.array() > made.domain_high.array()).any();
    if (outside)
      root.fault("particles", "particle " + std::to_string(k) + " lies outside the domain");
  }
}

bool is_along_z(const Vec3& axis) { return std::abs(axis.z()) > 1.0 - 1e-9; }
bool is_level(const Plane& plane) { return is_along_z(plane.normal); }
bool is_level(const Facet& facet) { return is_along_z(facet.normal); }
bool is_level(const Revolved& turned) { return turned.z0 == turned.z1 && is_along_z(turned.axis); }

// True where the surface lies across the z axis.
bool is_level(const Surface& surface) {
  return std::visit([](const auto& s) { return is_level(s); }, surface.shape);
}

// What is built for a bed along z alone, and what needs a bed, that is gravity.
void check_upright(Table& root, const Case& made, bool has_rig) {
  const auto up = physics::up_against(made.gravity);
  const bool is_tilted = up && !physics::is_z(*up);
  if (is_tilted && made.decomposition)
    root.fault("decomposition", "its layers lie across z; wanted gravity along -z");
  if (is_tilted && made.heap) root.fault("heap", "stands round z; wanted gravity along -z");
  if (is_tilted && has_rig) root.fault("rig", "stands along z; wanted gravity along -z");
  if (!up && made.models.bed_gas)
    root.fault("models", "bed_gas has layers across gravity; wanted gravity");
  if (!made.conductivity) return;
  for (const std::uint32_t plate : {made.conductivity->hot, made.conductivity->cold})
    if (plate < made.walls.surfaces.size() && !is_level(made.walls.surfaces[plate]))
      root.fault("conductivity", "is measured along z: wanted a plate across z, not '" +
                                     made.walls.surfaces[plate].name + "'");
}

// The case is checked as a whole before its thermal part goes.
void keep_mechanics(Table& root, Case& made) {
  if (!made.fill && !made.mix) root.fault("models", "mechanics_only wants [fill] or [mix]");
  made.models.conduction.reset();
  made.models.radiation.reset();
  made.models.reaction = false;
  made.models.bed_gas.reset();
  made.react.reset();
  made.chamber.reset();
  made.conductivity.reset();
}

// At the place of the time step, or of what is there of its table.
void check_time_step(Reading& reading, const Node& document, const Case& made) {
  const std::string problem = physics::time_step_fault(made);
  if (problem.empty()) return;
  const Node* at = &document;
  for (const char* key : {"models", "mechanics", "time_step"})
    if (const Node* inner = at->find(key); inner != nullptr) at = inner;
  reading.fault(at->place, "models.mechanics.time_step", problem);
}

Case read_case(Reading& reading, const Node& document) {
  Case made{};
  Table root(reading, document, "");
  made.title = root.word(root.moves_nothing("title"), "a text in quotes");
  made.description = root.word_or(root.moves_nothing("description"), "");
  root.look(root.moves_nothing("calibration"));  // where the parameters are from: a record
  made.seed = root.count("seed", 0, 1);
  made.gravity = read_gravity(root);
  made.bed = root.file_if_any("bed");
  made.models = read_models(root);
  reading.provenance = &made.provenance;
  MaterialBook book(reading, root, made.provenance);
  const bool heat = made.models.conduction || made.models.radiation;  // of walls
  const WallSetting setting{book, heat, made.seed};
  const double closing = read_closing(root);
  const std::optional<Rig> rig = read_rig(root, setting, closing);
  const bool rig_is_faulty = !rig && root.has("rig");
  read_domain(root, rig, rig_is_faulty, made);
  if (rig) build_rig(*rig, made.walls);
  const std::size_t parts_of_rig = made.walls.bodies.size();
  read_walls(root, setting, made.walls);
  made.species = read_species(
      root, book,
      {rig, rig_is_faulty, !made.bed.empty(), made.models.heat(), made.models.reaction, made.seed});
  made.particles = read_particles(root, made.species);
  made.fill = read_fill(root);
  made.mix = read_mix(root);
  made.react = read_react(root);
  made.chamber = read_chamber(root, rig, rig_is_faulty);
  made.decomposition = read_decomposition(root);
  made.thermocouples = read_thermocouples(root);
  made.conductivity = read_conductivity(root, made.walls);
  made.catches = read_catches(root);
  made.heap = read_heap(root);
  made.wall_forces = read_wall_forces(root, made.walls);
  made.output = read_output(root);
  made.materials = book.finish(made.models);
  if (reading.faults() == 0 && root.has("species") && made.bed.empty()) count_explicit(root, made);
  if (reading.faults() == 0 && made.bed.empty()) check_time_step(reading, document, made);
  check_whole(root, made);
  if (reading.faults() == 0) check_extents(root, parts_of_rig, made);
  made.warnings = reading.warnings;
  if (made.models.radiation && made.bed.empty()) face_particles(parts_of_rig, made);
  if (made.models.radiation && made.bed.empty() && reading.faults() == 0)
    warn_of_backs(parts_of_rig, made);
  check_upright(root, made, rig.has_value());
  if (made.models.mechanics_only) keep_mechanics(root, made);
  return made;
}

}  // namespace

Case load_case_text(const std::string& text, const std::string& name, const fs::path& base_dir,
                    std::span<const std::string> sets) {
  Node document = parse_toml(text, name);
  if (document.members.empty())
    throw CaseError({{name, "", "is empty: it holds no key at all; wanted a case"}});
  Reading reading;
  reading.folders = {{"", base_dir}, {name, base_dir}};
  const bool is_laid = lay_on_base(document, base_dir, reading.folders);
  for (const std::string& set : sets) apply_setting(document, set);
  Case made = read_case(reading, document);
  reading.finish();
  const Node whole = with_texts(document, reading.files);
  const bool is_written_anew =
      is_laid || !sets.empty() || write_toml(whole) != write_toml(document);
  made.text = is_laid ? "# " + name + ", with what it extends\n" : "";
  made.text += is_written_anew ? write_toml(whole) : text;
  made.mechanical_text = write_toml(without(whole, reading.motionless));
  return made;
}

std::set<std::string> keys_asked_for(const std::string& text) {
  const Node document = parse_toml(text, "case");
  Reading reading;
  read_case(reading, document);
  return reading.asked_for;
}

Case load_case(const fs::path& file, std::span<const std::string> sets) {
  return load_case_text(text_of(file), file.string(), fs::absolute(file).parent_path(), sets);
}

}  // namespace pmr::casefile
