// A bench of tests whose results are closed forms: cases are read and folders written as of real
// runs, but a function stands for the simulation. x is the friction of a granule on the wall and y
// its rolling friction.
#pragma once
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "calibrate/calibration.hpp"
#include "case/case.hpp"
#include "io/atomic_file.hpp"

namespace pmr::test {

// What one run comes to: figures under names, or a reason why it failed.
struct Said {
  std::vector<std::pair<std::string, double>> figures;
  std::string failure;
};
using Simulation = std::function<Said(const Case&)>;

inline PairContact on_wall(const Case& c, const std::string& material) {
  std::size_t grain = 0, wall = 0;
  for (std::size_t k = 0; k < c.materials.list.size(); ++k) {
    if (c.materials.list[k].name == material) grain = k;
    if (c.materials.list[k].name == "coated-wall") wall = k;
  }
  return c.materials.pair(grain, wall);
}

class Bench {
 public:
  Bench(const std::string& lab_text, Simulation simulation)
      : root(std::filesystem::temp_directory_path() /
             ("pmr-calibrate-" + std::to_string(::getpid()))),
        simulation_(std::move(simulation)) {
    std::filesystem::remove_all(root);
    std::filesystem::create_directories(root);
    rewrite(lab_text);
  }
  ~Bench() { std::filesystem::remove_all(root); }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  void rewrite(const std::string& lab_text) {
    rewrite_whole("title = \"T\"\nteaches = \"tests\"\n" + lab_text);
  }
  void rewrite_whole(const std::string& text, const std::string& name = "lab.toml") {
    std::ofstream(root / name) << text;
    lab = calibrate::read_lab(root / name, {});
  }

  // Carries out `jobs` at most before it is killed.
  calibrate::Calibration solved(const calibrate::Wishes& wishes = {},
                                std::size_t jobs = static_cast<std::size_t>(-1)) {
    const study::Folder folder(root / "out", "lab.toml");
    const auto lock = folder.prepare(lab.text);
    calibrate::Runs runs(lab, folder, "pmr", 1, [&](const std::vector<study::Job>& all) {
      for (const study::Job& job : all) {
        if (jobs-- == 0) return false;
        carry_out(job);
      }
      return true;
    });
    return calibrate::calibrate(lab, wishes, runs);
  }

  bool carry_out_all(const std::vector<study::Job>& jobs) {
    for (const study::Job& job : jobs) carry_out(job);
    return true;
  }

  std::filesystem::path root;
  calibrate::Lab lab;
  std::size_t carried_out = 0;

 private:
  void carry_out(const study::Job& job) {
    ++carried_out;
    std::filesystem::create_directories(job.folder);
    const Said said = simulation_(casefile::load_case(job.command.at(2)));
    std::ofstream(job.log) << said.failure << "\n";
    if (!said.failure.empty()) return;
    std::string text = "{\"status\": \"completed\"";
    for (const auto& [name, value] : said.figures)
      text += ", \"" + name + "\": " + std::to_string(value);
    std::ofstream(job.folder / "summary.json") << text << "}\n";
    std::ofstream(job.folder / "report.html") << "<html>";
  }

  Simulation simulation_;
};

inline std::string test_table(const std::string& name, const std::string& more = "") {
  return "[tests." + name + "]\ncase = \"" PMR_SOURCE_DIR "/cases/two-body-bounce.toml\"\n" + more;
}

inline std::string response(const std::string& test, const std::string& name, double value,
                            double error, const std::string& more = "") {
  return "[tests." + test + ".responses." + name + "]\nkey = \"" + name + "\"\nfloor = 0\n" + more +
         "result = {value = " + std::to_string(value) +
         ", standard_error = " + std::to_string(error) + ", source = \"closed form\"}\n";
}

inline std::string unknown(const std::string& stage, const std::string& name,
                           const std::string& key, const std::string& more = "") {
  return "[stages." + stage + ".unknowns." + name + "]\nkey = 'contacts.\"" + key + "'\n" +
         "from = 0\nto = 0.8\n" + more;
}

}  // namespace pmr::test
