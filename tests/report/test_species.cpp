// The report of a bed with more than one reacting species.
#include <catch2/catch.hpp>

#include "real_run.hpp"
#include "report/figures.hpp"
#include "report/report.hpp"

using namespace pmr;
using namespace pmr::report;

namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Every third granule is ceria, whose deltas are a twentieth of the others'.
RunData with_ceria() {
  RunData run = real_run("two oxides");
  run.header.species.push_back("CeO2");
  run.snapshot = [one_oxide = run.snapshot](std::size_t index) {
    io::Snapshot snapshot = one_oxide(index);
    Particles& p = snapshot.particles;
    for (std::size_t i = 0; i < p.size(); i += 3)
      if (p.species[i] == 1) {
        p.species[i] = 2;
        p.delta[i] *= 0.05;
      }
    return snapshot;
  };
  const auto copy = [&](const std::string& name, const std::string& as, double factor) {
    io::Column column{as, "1", run.series.values(name)};
    for (double& value : column.values) value *= factor;
    run.series.columns.push_back(std::move(column));
  };
  for (const std::string part : {"delta_mean", "delta_p10", "delta_p90"}) {
    copy(part, part + ".SrFeO3", 1.0);
    copy(part, part + ".CeO2", 0.05);
  }
  copy("oxygen_released", "oxygen_released.SrFeO3", 0.9);
  copy("oxygen_released", "oxygen_released.CeO2", 0.1);
  for (Member& member : std::get<Value::Object>(run.summary.data))
    if (member.key == "chemistry")
      member.value.set("species", parse_json(R"({
    "SrFeO3": {"delta_initial": 0.327, "delta_final": 0.452, "oxygen_released": 0.0063,
               "oxygen_per_kilogram": 0.31},
    "CeO2": {"delta_initial": 0.016, "delta_final": 0.0226, "oxygen_released": 0.0007,
             "oxygen_per_kilogram": 0.037}})"));
  gather_species(run);
  return run;
}

}  // namespace

TEST_CASE("Each reacting species has its own delta, oxygen, course and picture") {
  const RunData run = with_ceria();
  REQUIRE(run.reactive() == std::vector<std::size_t>{1, 2});
  const std::string html = report_page(run);
  CHECK(has(html, "The bed at the end, by δ of SrFeO₃"));
  CHECK(has(html, "The bed at the end, by δ of CeO₂"));
  CHECK(has(html, "δ of CeO₂"));
  CHECK(has(html, "released by CeO₂"));
  CHECK(has(html, "Oxygen released by CeO₂"));
  // Per kg of what reacts in all.
  const double mass = run.species[1].mass + run.species[2].mass;
  const double released = run.summary.number("chemistry/oxygen_released");
  for (const KeyFigure& figure : key_figures(run)) {
    if (figure.id == "oxygen") CHECK(figure.value == Approx(released / mass));
    if (figure.id == "oxygen.CeO2") CHECK(figure.value == 0.037);
    if (figure.id == "delta.CeO2") CHECK(figure.value == 0.0226);
  }
}

TEST_CASE("With one reacting species its course and picture need no name") {
  const RunData run = real_run("one oxide");
  const std::string html = report_page(run);
  CHECK(has(html, "The bed at the end, by δ</h3>"));
  CHECK_FALSE(has(html, "by δ of"));
}

TEST_CASE("Where heat went names all that gave and all that received") {
  const std::string html = report_page(with_ceria());
  CHECK(has(html, "through the SrFeO₃ and CeO₂"));
  CHECK(has(html, "Al₂O₃ gave off"));
}
