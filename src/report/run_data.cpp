#include "report/run_data.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

#include "case/case.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::report {
namespace {

namespace fs = std::filesystem;

std::string read_text(const fs::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// The case explains the run (geometry, clocks); a report can do without it.
std::optional<Case> reread_case(const io::RunHeader& header, const fs::path& folder) {
  try {
    return casefile::load_case_text(header.case_text, "case of " + folder.string(), folder);
  } catch (const CaseError&) {
    return std::nullopt;
  }
}

void add_particles(const io::Snapshot& snapshot, RunData& run) {
  const Particles& p = snapshot.particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.species[i] >= run.species.size()) continue;
    SpeciesTotals& totals = run.species[p.species[i]];
    ++totals.count;
    totals.mass += p.mass[i];
    totals.first_temperature += p.temperature[i];
    totals.first_enthalpy += p.enthalpy[i];
    totals.is_reactive = totals.is_reactive || p.formula_units[i] > 0.0;
  }
  for (SpeciesTotals& totals : run.species)
    if (totals.count > 0) totals.first_temperature /= static_cast<double>(totals.count);
}

}  // namespace

void gather_species(RunData& run) {
  run.species.clear();
  for (const std::string& name : run.header.species) run.species.push_back({.name = name});
  if (run.snapshot_times.empty()) return;
  add_particles(run.snapshot(0), run);
  const Particles last = run.snapshot(run.snapshot_times.size() - 1).particles;
  for (std::size_t i = 0; i < last.size(); ++i)
    if (last.species[i] < run.species.size())
      run.species[last.species[i]].last_enthalpy += last.enthalpy[i];
}

RunData read_run(const fs::path& folder) {
  if (!fs::exists(folder / "run.h5"))
    throw CaseError({{folder.string(), "", "is no run folder: it has no run.h5"}});
  RunData run;
  run.name = fs::weakly_canonical(folder).filename().string();
  run.header = io::read_header(folder);
  run.series = io::read_series(folder);
  run.snapshot_times = io::snapshot_times(folder);
  run.snapshot = [folder](std::size_t index) { return io::read_snapshot(folder, index); };
  const fs::path summary = folder / "summary.json";
  if (fs::exists(summary)) run.summary = parse_json(read_text(summary));
  run.setup = reread_case(run.header, folder);
  gather_species(run);
  return run;
}

std::vector<std::size_t> RunData::reactive() const {
  const bool is_on = setup ? setup->models.reaction : summary.has("chemistry");
  std::vector<std::size_t> found;
  for (std::size_t s = 0; is_on && s < species.size(); ++s)
    if (species[s].is_reactive) found.push_back(s);
  return found;
}

double RunData::reactive_mass() const {
  double mass = 0.0;
  for (const std::size_t s : reactive()) mass += species[s].mass;
  return mass;
}

std::optional<std::size_t> RunData::hottest() const {
  std::size_t hot = 0;
  for (std::size_t s = 1; s < species.size(); ++s)
    if (species[s].first_temperature > species[hot].first_temperature) hot = s;
  for (std::size_t s = 0; s < species.size(); ++s)
    if (species[hot].first_temperature > species[s].first_temperature + 0.01) return hot;
  return std::nullopt;
}

std::size_t RunData::granules() const {
  if (const auto found = reactive(); !found.empty())
    return *std::max_element(found.begin(), found.end(), [&](std::size_t a, std::size_t b) {
      return species[a].mass < species[b].mass;
    });
  std::size_t cold = species.empty() ? 0 : species.size() - 1;
  for (std::size_t s = 0; s < species.size(); ++s)
    if (species[s].first_temperature < species[cold].first_temperature - 0.01) cold = s;
  return cold;
}

double RunData::end_time() const {
  return series.rows() == 0 ? 0.0 : series.columns.front().values.back();
}

double RunData::settled_time() const {
  const double none = std::numeric_limits<double>::quiet_NaN();
  if (!series.has("phase") || !series.has("time")) return none;
  const auto& phase = series.values("phase");
  const auto& time = series.values("time");
  for (std::size_t row = 0; row < phase.size(); ++row)
    if (phase[row] >= static_cast<double>(Phase::react)) return time[row];
  return none;
}

}  // namespace pmr::report
