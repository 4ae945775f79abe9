// The mixture on the page: what is measured, what is stated and what the run itself shows.
#include <catch2/catch.hpp>
#include <fstream>

#include "pmr/base/errors.hpp"
#include "report/mixing_frames.hpp"
#include "report/mixture.hpp"
#include "report/mixture_data.hpp"
#include "report/report.hpp"
#include "synthetic_run.hpp"

using namespace pmr;
using namespace pmr::report;
using Catch::Contains;

namespace {

const std::vector<double> measured{3.5, 3.0, 2.0, 1.0, 0.5, 0.4, 0.5};

// Seven layers of eight sections, as the tool finds them in the small demonstrator.
constexpr const char* homogeneity =
    R"({"homogeneity": {"sectors": 8, "lacey_index": 0.712, "layers": [
   {"mass": 0.0052, "thickness": 0.0053, "mass_ratio": 4.28},
   {"mass": 0.0053, "thickness": 0.0043, "mass_ratio": 3.21},
   {"mass": 0.0054, "thickness": 0.0044, "mass_ratio": 1.63},
   {"mass": 0.0058, "thickness": 0.0048, "mass_ratio": 0.71},
   {"mass": 0.0053, "thickness": 0.0044, "mass_ratio": 0.32},
   {"mass": 0.0052, "thickness": 0.0042, "mass_ratio": 0.23},
   {"mass": 0.0037, "thickness": 0.0031, "mass_ratio": 0.63}],
  "sections": [[5.1,4.6,4.1,3.9,4.4,3.6,4.0,4.8],[4.2,3.6,2.9,2.5,2.8,2.7,3.1,3.9],
   [2.6,2.0,1.3,1.1,1.6,1.2,1.4,2.1],[1.0,0.8,0.6,0.5,0.8,0.6,0.7,0.9],
   [0.4,0.35,0.3,0.25,0.33,0.28,0.31,0.36],[0.3,0.25,0.2,0.18,0.24,0.19,0.22,0.26],
   [0.8,0.7,0.6,0.5,0.6,0.55,0.6,0.7]]}})";

const RunData& plain() {
  static const RunData run = [] {
    RunData made = synthetic_run(200, "plain");
    made.summary = parse_json(homogeneity);
    return made;
  }();
  return run;
}

RunData compared() {
  RunData run = plain();
  run.name = "compared";
  run.setup->decomposition =
      Decomposition{Vec3::Zero(), 0.0, {}, 8, "", MixtureReference{"measured.csv", measured, {}}};
  return run;
}

// Layers 1 to 7 with the largest w in these sectors, w falling with depth.
RunData with_peaks(const std::vector<std::size_t>& sectors) {
  RunData run = plain();
  Value::Array layers, rows;
  for (std::size_t k = 0; k < sectors.size(); ++k) {
    std::vector<double> row(8, 3.0 / static_cast<double>(k + 1));
    row[sectors[k]] *= 2.0;
    rows.push_back(Value(row));
    Value layer;
    layer.set("thickness", 0.01);
    layers.push_back(std::move(layer));
  }
  Value bed, summary;
  bed.set("layers", std::move(layers));
  bed.set("sections", std::move(rows));
  summary.set("homogeneity", std::move(bed));
  run.summary = summary;
  return run;
}

std::string section_of(const std::vector<const RunData*>& runs) {
  Charts charts;
  return mixture_section(runs, charts).html;
}

Value charts_of(const std::vector<const RunData*>& runs) {
  Charts charts;
  mixture_section(runs, charts);
  return parse_json(charts.to_json());
}

}  // namespace

TEST_CASE("The deviation on the page is that of the sections' means from the reference") {
  const RunData run = compared();
  const MixtureData mixture = mixture_of(run);
  REQUIRE(mixture.deviation);
  // Layer 1: the mean of 5.1 4.6 4.1 3.9 4.4 3.6 4.0 4.8 is 4.3125, against 3.5.
  CHECK(mixture.deviation->layers[0] == Approx(4.3125 / 3.5 - 1.0).epsilon(1e-12));
  CHECK_THAT(section_of({&run}), Contains("deviation from measured.csv") && Contains("23"));
  CHECK_FALSE(mixture_of(plain()).deviation);
}

TEST_CASE("A reference for another tool is not compared") {
  RunData run = compared();
  run.setup->decomposition->reference->layers.pop_back();
  CHECK_FALSE(mixture_of(run).deviation);
}

TEST_CASE("Several runs and the reference share the charts of the mixture") {
  const RunData run = compared();
  const Value data = charts_of({&plain(), &run});
  for (const char* chart : {"charts/layers/lines", "charts/azimuth/lines"}) {
    const auto& lines = data.items(chart);
    REQUIRE(lines.size() >= 2);
    CHECK(lines[0].text("label") == "plain");
    CHECK(lines[1].text("label") == "compared");
  }
  CHECK(data.items("charts/layers/lines").size() == 3);
  CHECK(data.items("charts/azimuth/lines").size() == 2);  // measured by layers alone
  CHECK_THAT(section_of({&plain(), &run}), Contains("compared − plain"));
}

TEST_CASE("Whether the azimuthal peak is reproduced is told from the run's own sections") {
  const RunData far = with_peaks({0, 4, 4, 4, 1, 2, 3});
  const RunData some = with_peaks({0, 4, 3, 4, 1, 2, 3});
  const RunData none = with_peaks({4, 0, 3, 5, 4, 4, 4});
  CHECK_THAT(section_of({&far}), Contains("the azimuthal peak is reproduced."));
  CHECK_THAT(section_of({&some}), Contains("reproduced in part.") && Contains("layer 3: φ = 135°"));
  CHECK_THAT(section_of({&none}), Contains("the azimuthal peak is not reproduced."));
  CHECK_THAT(section_of({&none}), Contains("falls from layer to layer"));
}

TEST_CASE("Published statements are drawn for the demonstrator alone") {
  CHECK(charts_of({&plain()}).has("charts/layers/published"));
  RunData other = plain();
  other.setup->title = "A hopper";
  CHECK_FALSE(charts_of({&other}).has("charts/layers/published"));
}

TEST_CASE("Frames of the mixing stand at the chosen times, each once") {
  RunData run = plain();  // snapshots every 50 ms to 0.6 s, then 0.62 s, 2 s ...
  CHECK(frame_times({&run}) == std::vector<double>{0.0, 0.124, 0.248, 0.372, 0.496, 0.62});
  run.frame_times = {0.21, 0.19, 0.4, 1e6};
  const auto frames = mixing_frames(run, frame_times({&run}));
  REQUIRE(frames.size() == 3);
  CHECK(run.snapshot_times[frames[0]] == Approx(0.2));
  CHECK(run.snapshot_times[frames[1]] == Approx(0.4));
  CHECK(run.snapshot_times[frames[2]] == 1800.0);
}

TEST_CASE("A wished reference that is wrong is refused, and no page is written") {
  const auto folder = std::filesystem::temp_directory_path() / "pmr_test_wished";
  write_folder(plain(), folder);
  CHECK_THROWS_AS(write_report({folder}, folder / "x.html", {folder / "no-such.csv", {}}),
                  CaseError);
  CHECK_FALSE(std::filesystem::exists(folder / "x.html"));
  std::filesystem::remove_all(folder);
}
