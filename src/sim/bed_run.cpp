#include "sim/bed_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "case/nearest.hpp"
#include "io/run_file.hpp"
#include "physics/adhered.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::sim {
namespace {

constexpr std::uint32_t gone = std::numeric_limits<std::uint32_t>::max();

// Index in the case of each species of the run, by name.
std::vector<SpeciesIndex> match_species(const Case& c, const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const Species& species : c.species) known.push_back(species.name);
  std::vector<SpeciesIndex> match;
  std::vector<Fault> faults;
  for (const std::string& name : names) {
    const auto found = std::find(known.begin(), known.end(), name);
    match.push_back(static_cast<SpeciesIndex>(found - known.begin()));
    if (found == known.end())
      faults.push_back({c.bed, "species." + name, casefile::unknown_word("species", name, known)});
  }
  if (!faults.empty()) throw CaseError(std::move(faults));
  return match;
}

// The surfaces of a run by the names of their patches: "lid", or "side[0,0]", "side[0,1]", ...
std::vector<std::string> surfaces_of(const std::vector<std::string>& patches) {
  std::vector<std::string> names;
  for (const std::string& patch : patches) {
    const std::size_t bracket = patch.find_last_of('[');
    if (bracket == std::string::npos)
      names.push_back(patch);
    else if (patch.substr(bracket) == "[0,0]")
      names.push_back(patch.substr(0, bracket));
  }
  return names;
}

// Index in the case of each surface of the run, or `gone`.
std::vector<std::uint32_t> match_surfaces(const Case& c, const std::vector<std::string>& names) {
  std::vector<std::uint32_t> match;
  for (const std::string& name : names) {
    const auto found = std::find_if(c.walls.surfaces.begin(), c.walls.surfaces.end(),
                                    [&](const Surface& s) { return s.name == name; });
    match.push_back(found == c.walls.surfaces.end()
                        ? gone
                        : static_cast<std::uint32_t>(found - c.walls.surfaces.begin()));
  }
  return match;
}

// The history with its partners renamed; entries whose partner is gone are left out, and those of
// adhered grains, which are the case's.
ContactHistory renamed(const ContactHistory& h, const std::vector<std::uint32_t>& name) {
  ContactHistory r;
  for (std::size_t i = 0; i + 1 < h.start.size(); ++i) {
    std::vector<std::uint32_t> row;
    for (std::uint32_t k = h.start[i]; k < h.start[i + 1]; ++k)
      if (h.partner[k] < physics::first_adhered_id && name.at(h.partner[k]) != gone)
        row.push_back(k);
    std::sort(row.begin(), row.end(), [&](std::uint32_t a, std::uint32_t b) {
      return name[h.partner[a]] < name[h.partner[b]];
    });
    for (const std::uint32_t k : row) {
      r.partner.push_back(name[h.partner[k]]);
      r.tangential.push_back(h.tangential[k]);
      r.rolling.push_back(h.rolling[k]);
    }
    r.start.push_back(static_cast<std::uint32_t>(r.partner.size()));
  }
  return r;
}

// New ids 0.. in the order of the old, closing the gaps that lost particles left.
std::vector<std::uint32_t> new_ids(const State& state) {
  std::vector<ParticleId> old = state.particles.id;
  std::sort(old.begin(), old.end());
  std::vector<std::uint32_t> name(state.opening.particles, gone);
  for (std::size_t k = 0; k < old.size(); ++k) name.at(old[k]) = static_cast<std::uint32_t>(k);
  return name;
}

Particles bare_particles(const Particles& from, const std::vector<std::uint32_t>& name,
                         const std::vector<SpeciesIndex>& match) {
  Particles p;
  resize(p, from.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.id[i] = name[from.id[i]];
    p.species[i] = match.at(from.species[i]);
  }
  p.radius = from.radius;
  p.position = from.position;
  p.velocity = from.velocity;
  p.spin = from.spin;
  return p;
}

}  // namespace

Bed read_run_bed(const Case& c) {
  const io::RunHeader header = io::read_header(c.bed);
  if (!io::has_checkpoint(c.bed))
    throw CaseError({{c.bed, "", "holds no checkpoint.h5, and so no bed to start from"}});
  const State state = io::load_checkpoint(c.bed);
  if (state.phase == Phase::fill || state.phase == Phase::mix)
    throw CaseError(
        {{c.bed, "", "its bed still moves; end that run first with: pmr resume " + c.bed}});
  const auto species = match_species(c, header.species);
  const auto surfaces = match_surfaces(c, surfaces_of(header.patches));
  const auto name = new_ids(state);
  Bed bed{};
  bed.particles = bare_particles(state.particles, name, species);
  bed.pair_contacts = renamed(state.pair_contacts, name);
  bed.wall_contacts = renamed(state.wall_contacts, surfaces);
  bed.time = std::isfinite(state.settled_at) ? state.settled_at : state.time;
  bed.rest_since = -std::numeric_limits<double>::infinity();
  const std::size_t dropped = state.wall_contacts.partner.size() - bed.wall_contacts.partner.size();
  bed.description = fmt::format("{} particles of the run {} at t = {:.6g} s", bed.particles.size(),
                                c.bed, bed.time);
  if (dropped > 0)
    bed.description += fmt::format(", without {} springs of walls that are not here", dropped);
  return bed;
}

}  // namespace pmr::sim
