#include <string_view>

#include "case/case.hpp"
#include "case/node.hpp"

namespace pmr::casefile {
namespace {

using Keys = std::initializer_list<const char*>;

void drop(Node* table, Keys keys) {
  if (table == nullptr) return;
  for (const char* key : keys) table->members.erase(key);
}

Node* member(Node* table, const char* key) {
  if (table == nullptr) return nullptr;
  const auto found = table->members.find(key);
  return found == table->members.end() ? nullptr : &found->second;
}

void drop_in_each(Node* table, Keys keys) {
  if (table == nullptr) return;
  for (auto& [name, one] : table->members) drop(&one, keys);
}

// Temperatures and linings of walls: "thermal", "chamber_thermal", ...
void drop_thermal(Node& node) {
  std::erase_if(node.members, [](const auto& entry) {
    return std::string_view(entry.first).ends_with("thermal");
  });
  for (auto& [key, inner] : node.members) drop_thermal(inner);
  for (Node& item : node.items) drop_thermal(item);
}

void drop_particle_temperatures(Node* particles) {
  if (particles == nullptr) return;
  for (Node& one : particles->items) drop(&one, {"temperature"});
}

}  // namespace

// What is not named here counts as mechanical: a key too many costs a mixing, never a wrong bed.
// The chamber's closing stays, as its door is a moving wall.
std::string mechanical_text(const std::string& case_text) {
  Node root = parse_toml(case_text, "case");
  drop(&root, {"title", "description", "react", "thermocouples", "decomposition", "conductivity"});
  drop(member(&root, "models"),
       {"conduction", "radiation", "reaction", "bed_gas", "network", "mechanics_only"});
  drop(member(&root, "output"),
       {"snapshot_times", "checkpoint_wall_time", "cut_point", "cut_normal"});
  drop(member(&root, "chamber"), {"volume", "pressure", "oxygen_fraction", "gas_temperature",
                                  "film_coefficient", "leak", "pump", "vent"});
  drop_in_each(member(&root, "species"), {"temperature", "delta"});
  drop_in_each(member(&root, "materials"),
               {"heat", "conductivity", "emissivity", "accommodation", "redox"});
  drop_thermal(root);
  drop_particle_temperatures(member(&root, "particles"));
  return write_toml(root);
}

}  // namespace pmr::casefile
