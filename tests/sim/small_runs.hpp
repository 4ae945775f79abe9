// Small cases that run in no time: particles that float in a closed box.
#pragma once
#include <atomic>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "folder.hpp"
#include "sim/simulation.hpp"
#include "sim/summary.hpp"

namespace pmr::test {

// A box of 0.2 m with walls of `wall`, and what is in it.
inline std::string box_case(const std::string& wall, const std::string& contents) {
  return R"(title = "box"
gravity = "none"
[domain]
low = "-200 -200 -200 mm"
high = "200 200 200 mm"
[walls.box]
kind = "box"
material = "coated-wall"
low = "-100 -100 -100 mm"
high = "100 100 100 mm"
thermal = {kind = "fixed", temperature = ")" +
         wall + "\"}\n" + contents;
}

inline std::string species(const std::string& name, const std::string& material,
                           const std::string& more, const std::string& position) {
  return "[species." + name + "]\nmaterial = \"" + material + "\"\n" + more +
         "\n[[particles]]\nspecies = \"" + name + "\"\nposition = \"" + position + " mm\"\n";
}

inline Case load(const std::string& text, const std::vector<std::string>& sets = {}) {
  return casefile::load_case_text(text, "test.toml", PMR_SOURCE_DIR, sets);
}

struct Ended {
  State state;
  io::Series series;
  nlohmann::json summary;
};

// The whole chain: run, run.h5, summary.json.
inline Ended run_to_end(const Case& c, const std::string& name) {
  const Folder folder(name);
  const std::atomic<bool> never{false};
  sim::Simulation simulation(c, folder.path);
  simulation.run(never, [](const auto&) {});
  Ended ended{simulation.state(), io::read_series(folder.path), {}};
  sim::write_summary(folder.path, {c,
                                   ended.state,
                                   simulation.nodes(),
                                   simulation.timings(),
                                   ended.series,
                                   simulation.time_step(),
                                   "completed",
                                   {}});
  std::ifstream(folder.path / "summary.json") >> ended.summary;
  return ended;
}

}  // namespace pmr::test
