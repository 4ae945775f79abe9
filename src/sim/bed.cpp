#include "sim/bed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>

#include "io/dump.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/hash.hpp"
#include "sim/bed_checks.hpp"
#include "sim/bed_run.hpp"

namespace pmr::sim {
namespace {

namespace fs = std::filesystem;

std::uint64_t hash_of_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  Hash hash;
  hash.add(std::string_view(bytes));
  return hash.value();
}

// Species of each atom type: as the case says, or else 1 for the first species and so on.
std::map<std::uint64_t, SpeciesIndex> types_of(const Case& c) {
  std::map<std::uint64_t, SpeciesIndex> types;
  const bool is_given = std::any_of(c.species.begin(), c.species.end(),
                                    [](const Species& s) { return s.dump_type != 0; });
  for (std::size_t s = 0; s < c.species.size(); ++s) {
    const std::uint64_t type = is_given ? c.species[s].dump_type : s + 1;
    if (type != 0) types[type] = static_cast<SpeciesIndex>(s);
  }
  return types;
}

// "1 = Al2O3, 2 = SrFeO3"
std::string list_of(const Case& c, const std::map<std::uint64_t, SpeciesIndex>& types) {
  std::string list;
  for (const auto& [type, species] : types)
    list += fmt::format("{}{} = {}", list.empty() ? "" : ", ", type, c.species[species].name);
  return list;
}

Bed read_dump_bed(const Case& c) {
  const io::Dump dump = io::read_dump(c.bed);
  const auto types = types_of(c);
  std::map<std::uint64_t, std::size_t> strangers;
  Bed bed{};
  Particles& p = bed.particles;
  resize(p, dump.atoms.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const io::DumpAtom& atom = dump.atoms[i];
    const auto type = types.find(atom.type);
    if (type == types.end())
      ++strangers[atom.type];
    else
      p.species[i] = type->second;
    p.id[i] = static_cast<ParticleId>(i);
    p.radius[i] = atom.radius;
    p.position[i] = atom.position;
    p.velocity[i] = atom.velocity;
    p.spin[i] = atom.spin;
  }
  std::vector<Fault> faults;
  for (const auto& [type, count] : strangers)
    faults.push_back({c.bed, "type",
                      fmt::format("{} atoms are of type {}, which is no species; the case has {} "
                                  "(see dump_type)",
                                  count, type, list_of(c, types))});
  if (!faults.empty()) throw CaseError(std::move(faults));
  bed.rest_since = std::numeric_limits<double>::infinity();
  bed.description = fmt::format("{} particles of the dump {}, time step {}, {}", p.size(), c.bed,
                                dump.time_step, list_of(c, types));
  return bed;
}

void find_nothing_to_do(const Case& c, const Bed& bed, std::vector<Fault>& faults) {
  if (bed.particles.size() == 0) faults.push_back({c.bed, "", "holds no particle"});
  if (!c.mix && !c.react)
    faults.push_back({c.bed, "", "the case has nothing to do with a bed: wanted [mix] or [react]"});
  if (c.react && c.react->end <= bed.time)
    faults.push_back({c.bed, "",
                      fmt::format("its clock stands at {:.6g} s already; wanted react.end "
                                  "after that, not {:.6g} s",
                                  bed.time, c.react->end)});
}

void set_masses(const Case& c, Particles& p) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Species& species = c.species[p.species[i]];
    p.mass[i] = c.materials.list[species.material].density * 4.0 / 3.0 * pi * p.radius[i] *
                p.radius[i] * p.radius[i];
    p.temperature[i] = species.initial_temperature;
  }
}

}  // namespace

Bed read_bed(const Case& c) {
  const bool is_run = fs::exists(fs::path(c.bed) / "run.h5");
  if (!is_run && !io::is_dump(c.bed))
    throw CaseError({{c.bed, "bed",
                      fs::exists(c.bed) ? "is neither a run folder (with run.h5) nor a text dump "
                                          "('ITEM: TIMESTEP' first)"
                                        : "does not exist; wanted a run folder or a text dump"}});
  Bed bed = is_run ? read_run_bed(c) : read_dump_bed(c);
  bed.hash = hash_of_file(is_run ? fs::path(c.bed) / "checkpoint.h5" : fs::path(c.bed));
  set_masses(c, bed.particles);
  std::vector<Fault> faults = bed_faults(c, bed);
  find_nothing_to_do(c, bed, faults);
  if (!faults.empty()) throw CaseError(std::move(faults));
  bed.description +=
      fmt::format("; largest overlap {:.2f} % of the radius", 100.0 * bed.overlap_ratio);
  return bed;
}

void count_bed(const Particles& p, Case& c) {
  for (std::size_t s = 0; s < c.species.size(); ++s) {
    Species& species = c.species[s];
    species.diameters.clear();
    species.requested_mass = 0.0;
    double squares = 0.0, cubes = 0.0;  // [m2], [m3]
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p.species[i] != s) continue;
      const double d = 2.0 * p.radius[i];
      species.diameters.push_back(d);
      squares += d * d;
      cubes += d * d * d;
    }
    species.count = species.diameters.size();
    species.diameter = species.count == 0 ? 0.0 : cubes / squares;
    species.requested_mass = c.materials.list[species.material].density * pi / 6.0 * cubes;
  }
}

}  // namespace pmr::sim
