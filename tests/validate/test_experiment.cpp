// Experiments as files: what is read, what is refused, and that the shipped ones are sound.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "case/case.hpp"
#include "pmr/base/errors.hpp"
#include "validate/runs.hpp"

using namespace pmr;
using namespace pmr::validate;

namespace {

namespace fs = std::filesystem;
using Catch::Contains;

const std::string good = "title = \"T\"\nteaches = \"t\"\nsource = \"s\"\ncase = \"" PMR_SOURCE_DIR
                         "/cases/heat-pair.toml\"\npoints = \"points.csv\"\n";
const std::string rest = R"(
[axis]
value = "time"
[figures]
reading = {series = "temperature_mean.grain", at = "time"}
[quantities.temperature]
computed = "reading"
measured = "temperature"
deviation = "0.5"
)";
const std::string table = "time [s],temperature [K]\n0.1,425\n0.2,423\n";

class Files {
 public:
  Files(const std::string& text, const std::string& points)
      : folder_(fs::temp_directory_path() / ("pmr-validate-" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
    std::ofstream(folder_ / "pair.toml") << text;
    std::ofstream(folder_ / "points.csv") << points;
  }
  ~Files() { fs::remove_all(folder_); }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;
  Experiment read(const std::vector<std::string>& sets = {}) const {
    return read_experiment(folder_ / "pair.toml", sets);
  }
  std::string faults() const {
    std::string all;
    try {
      read();
    } catch (const CaseError& error) {
      for (const Fault& fault : error.faults()) all += to_string(fault) + "\n";
    }
    return all;
  }

 private:
  fs::path folder_;
};

}  // namespace

TEST_CASE("An experiment is read whole") {
  const Experiment e =
      Files(
          good +
              "replicates = 2\n[constants]\nshift = 2\n[variants.soft]\nlabel = \"L\"\nsettings = "
              "{seed = 7}\n" +
              rest +
              "bar = {rms = 3, from = 0.1}\nfree_zero = true\non_miss = \"why\"\n[slopes.n]\nx = "
              "\"time\"\ny = \"reading\"\nmeasured = 1\ndeviation = 0.1\nbar = 0.2\n",
          table)
          .read({"shift=3"});
  CHECK(e.name == "pair");
  CHECK(e.points.rows == 2);
  CHECK(e.points.columns[1].unit == "K");
  CHECK(known_at(e, 1) == study::Values{{"shift", 3.0}, {"time", 0.2}, {"temperature", 423.0}});
  CHECK(e.variants.size() == 1);
  CHECK(e.quantities[0].bar.kind == Bar::Kind::rms);
  CHECK(e.quantities[0].bar.from == 0.1);
  CHECK(e.quantities[0].has_free_zero);
  CHECK(e.slopes.size() == 1);
}

TEST_CASE("Points that want the same case share its runs, one a seed") {
  const Experiment e = Files(good + "replicates = 2\n" + rest, table).read();
  const ValidationPlan plan = make_plan(std::vector{e});
  CHECK(plan.plan.runs.size() == 2);
  CHECK(plan.plan.runs[0].name == "pair_seed=1");
  CHECK(plan.places[0][0] == std::vector<std::vector<std::size_t>>{{0, 1}, {0, 1}});
  const Experiment apart =
      Files(good + "[settings]\n\"react.end\" = \"${time} s\"\n" + rest, table).read();
  CHECK(make_plan(std::vector{apart}).plan.runs.size() == 2);
  CHECK_THROWS_AS(make_plan(std::vector{e, apart}), CaseError);  // of one name
}

TEST_CASE("What is wrong with an experiment is told, all of it") {
  CHECK(Files(good + rest, table).faults().empty());
  CHECK_THAT(Files(good + rest, "time,temperature [K]\n1,2\n").faults(), Contains("with its unit"));
  CHECK_THAT(Files(good + rest, "time [s],temperature [K]\n1\n2,x\n").faults(),
             Contains("points.csv:2: has 1 cells; wanted 2") && Contains("'x' is no number"));
  CHECK_THAT(Files(good + rest, "time [s],temperature [K]\n").faults(),
             Contains("at least one point"));
  CHECK_THAT(Files(good + rest, "a b [s],temperature [K]\n1,2\n").faults(),
             Contains("cannot stand in an expression"));
  CHECK_THAT(Files(good + rest + "bar = {rms = 1, largest = 2}\n", table).faults(),
             Contains("wanted one of: largest, rms, relative"));
  CHECK_THAT(Files(good + rest + "bar = {rms = 1, from = 3}\n", table).faults(),
             Contains("no point lies between"));
  CHECK_THAT(Files(good + rest +
                       "[slopes.n]\nx = \"time\"\ny = \"reading\"\nmeasured = 1\n"
                       "deviation = 0.1\nbar = 0.2\n",
                   "time [s],temperature [K]\n1,2\n")
                 .faults(),
             Contains("at least two points"));
  CHECK_THAT(Files(good + rest + "bra = {rms = 1}\n", table).faults(),
             Contains("did you mean 'bar'"));
  CHECK_THAT(Files(good + "group = \"tme\"\n" + rest, table).faults(),
             Contains("did you mean 'time'"));
  CHECK_THAT(Files(good + rest + "free_zero = 3\n", table).faults(), Contains("free_zero"));
  std::string text = rest;
  text.replace(text.find("\"0.5\""), 5, "\"time - 0.2\"");
  CHECK_THAT(Files(good + text, table).faults(),
             Contains("point 1: wanted a deviation above 0") && Contains("point 2: wanted a"));
  text = rest;
  text.replace(text.find("\"reading\""), 9, "\"raeding\"");
  CHECK_THAT(Files(good + text, table).faults(), Contains("raeding"));
  text = rest;
  text.replace(text.find("{series"), 1, "{key = \"a\", ");
  CHECK_THAT(Files(good + text, table).faults(), Contains("wanted one of: key"));
  CHECK_THAT(Files("title = \"T\"\n" + rest, table).faults(),
             Contains("teaches") && Contains("source") && Contains("case") && Contains("points"));
}

TEST_CASE("A case that is wrong at a point is told before anything is run") {
  const Experiment e =
      Files(good + "[settings]\n\"react.endd\" = \"${time} s\"\n" + rest, table).read();
  CHECK_THROWS_WITH(make_plan(std::vector{e}), Contains("react.endd"));
}

TEST_CASE("Every shipped experiment has sound cases at each of its points") {
  std::vector<Experiment> experiments;
  for (const auto& entry : fs::directory_iterator(PMR_SOURCE_DIR "/cases/validation"))
    if (entry.path().extension() == ".toml") {
      INFO(entry.path());
      experiments.push_back(read_experiment(entry.path(), {}));
      CHECK(experiments.back().teaches.size() > 80);
    }
  CHECK(experiments.size() >= 6);
  CHECK(make_plan(experiments).plan.runs.size() > experiments.size());
}
