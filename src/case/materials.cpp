#include "case/materials.hpp"

#include <fmt/format.h>

#include <cmath>

#include "case/nearest.hpp"
#include "case/shipped.hpp"
#include "chemistry/solids.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::casefile {
namespace {

constexpr std::string_view contacts_file = "contacts";

std::string pair_key(std::string a, std::string b) {
  if (b < a) std::swap(a, b);
  return a + "|" + b;
}

// "A|B" with A <= B.
std::string normalised(const std::string& key) {
  const std::size_t bar = key.find('|');
  return bar == std::string::npos ? key : pair_key(key.substr(0, bar), key.substr(bar + 1));
}

bool lacks(const ConstantHeat& law) { return std::isnan(law.heat_capacity); }
bool lacks(const Shomate&) { return false; }
bool lacks(const OxideHeat&) { return false; }
bool lacks(const TabulatedHeat&) { return false; }

bool lacks_conductivity(const Material& material) {
  const auto* table = std::get_if<TabulatedConductivity>(&material.conductivity);
  return table != nullptr && std::isnan(table->table.y.front());
}

// Name of the first key that a role wants and the material does not have, or "".
std::string lacking(const Material& m, unsigned roles, const Models& models) {
  const auto in_role = [&](MaterialBook::Role role) {
    return (roles & static_cast<unsigned>(role)) != 0;
  };
  const bool particle = in_role(MaterialBook::Role::particle);
  const bool touches = particle || in_role(MaterialBook::Role::surface);
  const bool lining = in_role(MaterialBook::Role::lining);
  const bool no_heat = std::visit([](const auto& law) { return lacks(law); }, m.heat);
  if ((particle || lining) && std::isnan(m.density)) return "density";
  if ((particle || lining) && no_heat && models.heat()) return "heat";
  if (touches && std::isnan(m.young_soft)) return "young_soft";
  if (touches && std::isnan(m.poisson_soft)) return "poisson_soft";
  if (touches && models.radiation && std::isnan(m.emissivity.table.y.front())) return "emissivity";
  if (!models.conduction) return lining && lacks_conductivity(m) ? "conductivity" : "";
  if (lacks_conductivity(m)) return "conductivity";
  if (touches && std::isnan(m.young_real)) return "young_real";
  if (touches && std::isnan(m.poisson_real)) return "poisson_real";
  if (touches && std::isnan(m.accommodation)) return "accommodation";
  return "";
}

}  // namespace

MaterialBook::MaterialBook(Reading& reading, Table& root, std::vector<Provenance>& provenance)
    : reading_(reading), provenance_(provenance) {
  for (const ShippedFile& file : shipped_files()) {
    Node node = parse_toml(file.text, fmt::format("materials/{}.toml", file.name));
    if (file.name == contacts_file)
      for (auto& [key, pair] : node.members) contacts_[normalised(key)] = std::move(pair);
    else
      nodes_[file.name] = std::move(node);
  }
  if (const Node* given = root.look_table("materials"); given != nullptr) {
    for (const auto& [name, node] : given->members) {
      const auto [place, is_new] = nodes_.try_emplace(name, node);
      if (!is_new) merge(place->second, node);
    }
    for (const auto& [name, node] : given->members) load(name);
  }
  if (const Node* given = root.look_table("contacts"); given != nullptr)
    for (const auto& [key, node] : given->members) add_contact(key, node);
}

void MaterialBook::add_contact(const std::string& key, const Node& node) {
  const std::string path = "contacts.\"" + key + "\"";
  const std::size_t bar = key.find('|');
  if (bar == std::string::npos) {
    reading_.fault(node.place, path, "wanted a pair of materials such as \"Al2O3|SrFeO3\"");
    return;
  }
  for (const std::string& name : {key.substr(0, bar), key.substr(bar + 1)})
    if (!nodes_.contains(name))
      reading_.fault(node.place, path, unknown_word("material", name, names()));
  const auto [place, is_new] = contacts_.try_emplace(normalised(key), node);
  if (!is_new) merge(place->second, node);
  unread_pairs_.insert(normalised(key));
}

std::vector<std::string> MaterialBook::names() const {
  std::vector<std::string> all;
  for (const auto& [name, node] : nodes_) all.push_back(name);
  return all;
}

std::uint32_t MaterialBook::load(const std::string& name) {
  const auto next = static_cast<std::uint32_t>(materials_.list.size());
  const auto [place, is_new] = loaded_.try_emplace(name, next);
  if (!is_new) return place->second;
  materials_.list.push_back(read_material(reading_, nodes_.at(name), name));
  uses_.emplace_back();
  return next;
}

std::uint32_t MaterialBook::use(Table& table, const std::string& key, Role role) {
  const std::string name = table.word(key, "the name of a material such as \"Al2O3\"");
  if (name.empty()) return 0;
  if (!nodes_.contains(name)) {
    table.fault(key, unknown_word("material", name, names()));
    return 0;
  }
  const std::uint32_t index = load(name);
  if (uses_[index].roles == 0) uses_[index].place = table.node().find(key)->place;
  uses_[index].roles |= static_cast<unsigned>(role);
  return index;
}

void MaterialBook::check(std::uint32_t index, const Models& models) {
  const Material& material = materials_.list[index];
  const std::string missing = lacking(material, uses_[index].roles, models);
  if (!missing.empty())
    reading_.fault(uses_[index].place, "materials." + material.name + "." + missing,
                   "is missing; this use of the material wants it");
  if ((uses_[index].roles & static_cast<unsigned>(Role::lining)) != 0 &&
      !std::holds_alternative<ConstantHeat>(material.heat))
    reading_.fault(uses_[index].place, "materials." + material.name + ".heat",
                   "wanted the law 'constant' of a material of linings");
  if ((uses_[index].roles & static_cast<unsigned>(Role::particle)) == 0) return;
  if (std::holds_alternative<OxideHeat>(material.heat) && !material.redox)
    reading_.fault(uses_[index].place, "materials." + material.name + ".redox",
                   "is missing; the heat law 'oxide' counts oxygen");
  if (material.redox && models.heat() && !chemistry::heat_law_fits(material) && missing.empty())
    reading_.fault(uses_[index].place, "materials." + material.name + ".heat",
                   "wanted the law 'oxide', which counts oxygen, in a material with redox");
}

PairContact MaterialBook::read_contact(const std::string& key) {
  unread_pairs_.erase(key);
  reading_.provenance = &provenance_;
  Table table(reading_, contacts_.at(key), "contacts.\"" + key + "\"");
  const Want coefficient{Dimension::none, not_negative};
  PairContact pair{};
  pair.friction = table.value("friction", coefficient);
  pair.rolling_friction = table.value("rolling_friction", coefficient);
  // e = 0 has no finite damping in the model (its logarithm), so it is excluded
  pair.restitution = table.value("restitution", {Dimension::none, {0.0, 1.0, true, false}});
  return pair;
}

void MaterialBook::set_pair(std::uint32_t i, std::uint32_t j) {
  const std::string key = pair_key(materials_.list[i].name, materials_.list[j].name);
  if (!contacts_.contains(key)) {
    reading_.fault(uses_[i].place, "contacts.\"" + key + "\"",
                   "is missing; these materials can meet, so the pair wants friction, "
                   "rolling_friction and restitution");
    return;
  }
  const std::size_t n = materials_.list.size();
  materials_.pairs[i * n + j] = materials_.pairs[j * n + i] = read_contact(key);
}

Materials MaterialBook::finish(const Models& models) {
  const auto n = static_cast<std::uint32_t>(materials_.list.size());
  materials_.pairs.assign(std::size_t{n} * n, {nan, nan, nan});
  const auto has = [&](std::uint32_t i, Role role) {
    return (uses_[i].roles & static_cast<unsigned>(role)) != 0;
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    check(i, models);
    auto* heat = std::get_if<ConstantHeat>(&materials_.list[i].heat);
    if (!models.heat() && heat != nullptr && lacks(*heat)) *heat = {0.0};  // it holds none
    for (std::uint32_t j = i; j < n; ++j) {
      const bool both = has(i, Role::particle) && has(j, Role::particle);
      const bool with_wall = (has(i, Role::particle) && has(j, Role::surface)) ||
                             (has(j, Role::particle) && has(i, Role::surface));
      if (both || with_wall) set_pair(i, j);
    }
  }
  while (!unread_pairs_.empty()) {
    const std::string key = *unread_pairs_.begin();
    read_contact(key);  // for its faults alone
  }
  return std::move(materials_);
}

}  // namespace pmr::casefile
