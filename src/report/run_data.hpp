// All that a report knows of one run, apart from where it was read.
#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/run_file.hpp"
#include "pmr/state/case.hpp"
#include "report/value.hpp"

namespace pmr::report {

// Totals of a species, from the first and the last snapshot.
struct SpeciesTotals {
  std::string name;
  std::size_t count = 0;                             // [1] at the start
  double mass = 0.0;                                 // [kg] at the start
  double first_temperature = 0.0;                    // [K] mean at the start
  double first_enthalpy = 0.0, last_enthalpy = 0.0;  // [J]
  bool is_reactive = false;
};

struct RunData {
  std::string name;  // of the run's folder
  io::RunHeader header;
  io::Series series;
  std::vector<double> snapshot_times;                 // [s]
  std::function<io::Snapshot(std::size_t)> snapshot;  // reads the one of that index
  Value summary;                                      // summary.json
  std::optional<Case> setup;                          // the case, where it can be read again
  std::vector<SpeciesTotals> species;                 // by species index
  std::vector<double> frame_times;  // [s] wanted for the frames of the mixing; empty: our choice

  std::vector<std::size_t> reactive() const;   // indices of the species that give off oxygen
  double reactive_mass() const;                // [kg] of them at the start
  std::optional<std::size_t> hottest() const;  // index of the hottest at the start, if one is
  // The reactive one, of several the one of most mass; else the coldest, else the last.
  std::size_t granules() const;
  double end_time() const;      // [s] of the last row; 0 without rows
  double settled_time() const;  // [s] first row of the react phase; NaN without
};

RunData read_run(const std::filesystem::path& folder);  // CaseError if it is no run folder
void gather_species(RunData& run);  // fills `species` from the first and last snapshot

}  // namespace pmr::report
