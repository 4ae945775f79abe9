#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "pmr/base/errors.hpp"
#include "real_run.hpp"
#include "report/page.hpp"
#include "report/report.hpp"
#include "report/text.hpp"

using namespace pmr;
using namespace pmr::report;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// The page without D3 and our scripts, which name the SVG namespace.
std::string without_scripts(std::string html) {
  for (std::size_t a; (a = html.find("<script>")) != std::string::npos;)
    html.erase(a, html.find("</script>", a) + 9 - a);
  return html;
}

Value data_of(const std::string& html) {
  const auto mark = html.find("id=\"pmr-data\">");
  REQUIRE(mark != std::string::npos);
  const auto begin = mark + 14;
  return parse_json(html.substr(begin, html.find("</script>", begin) - begin));
}

void check_self_contained(const std::string& html) {
  const std::string page = without_scripts(html);
  for (const char* load : {"http://", "https://", "src=", "@import", "url(http", "<link"})
    CHECK_FALSE(contains(page, load));
}

const RunData& hot() {
  static const RunData run = real_run("hot");
  return run;
}

const std::string& hot_page() {
  static const std::string html = report_page(hot());
  return html;
}

}  // namespace

TEST_CASE("The report is one file with all of its sections") {
  const std::string& html = hot_page();
  check_self_contained(html);
  for (const char* id : {"answer", "pictures", "mixture", "course", "books", "reproduction"})
    CHECK(contains(html, "<section id=\"" + std::string(id) + "\">"));
  CHECK(contains(html, "data:image/png;base64,"));
  CHECK(html.size() < 6u << 20);
}

TEST_CASE(
    "The answer comes first: the granules' highest mean, when, how alike, the oxygen's peak") {
  const std::string& html = hot_page();
  const auto row_of_peak = [](const std::string& column) {
    const auto& values = hot().series.values(column);
    return std::max_element(values.begin(), values.end()) - values.begin();
  };
  const auto value = [](const std::string& column, std::ptrdiff_t row) {
    return hot().series.values(column)[static_cast<std::size_t>(row)];
  };
  const auto hottest = row_of_peak("temperature_mean.SrFeO3");
  const auto most = row_of_peak("oxygen_released");
  double granules = 0.0;  // [kg] at the start
  const Particles first = hot().snapshot(0).particles;
  for (std::size_t i = 0; i < first.size(); ++i)
    granules += first.species[i] == 1 ? first.mass[i] : 0.0;
  const std::vector<std::string> in_order{
      "<p class=\"answer\">The SrFeO₃ granules were hottest after " +
          with_unit(Quantity::time, value("time", hottest)),
      with_unit(Quantity::temperature, value("temperature_mean.SrFeO3", hottest)),
      "±" + with_unit(Quantity::temperature_difference, value("temperature_std.SrFeO3", hottest)),
      "after " + with_unit(Quantity::time, value("time", most)),
      with_unit(Quantity::specific_amount, value("oxygen_released", most) / granules),
      "At the end, after 20\u202fs",
      with_unit(Quantity::temperature, hot().summary.number("thermal/temperature_mean/SrFeO3")),
      "were mixed"};
  std::size_t at = 0;
  for (const std::string& part : in_order) {
    INFO(part);
    const std::size_t found = html.find(part, at);
    REQUIRE(found != std::string::npos);
    at = found;
  }
}

TEST_CASE("The answer of a bulk test is its angle, its time, its masses") {
  RunData run = moved_alone();
  run.summary.set("heap", parse_json(R"({"angle": 26.53, "angle_scatter": 0.57})"));
  CHECK(
      contains(answer_section(run).html, "The angle of repose is <strong>26.5 ± 0.6 deg</strong>"));
  run.summary.set("heap", parse_json(R"({"angle": null})"));
  run.summary.set("catch", parse_json(R"({"bin": {"mass": 0.0125}, "missed": {"mass": 0},
      "out": {"mass": 0.0301, "threshold": 0.03, "time_to_threshold": 3.25}})"));
  const std::string html = answer_section(run).html;
  CHECK(contains(html, with_unit(Quantity::mass, 0.03) + " were caught by out after <strong>" +
                           with_unit(Quantity::time, 3.25) + "</strong>"));
  CHECK(contains(
      html, "caught were <strong>" + with_unit(Quantity::mass, 0.0125) + "</strong>\n by bin."));
}

TEST_CASE("What limits trust is listed: all warnings of the summary, and the assumed inputs") {
  const std::string& html = hot_page();
  CHECK(contains(html, "with no particle lost"));
  REQUIRE_FALSE(hot().summary.items("warnings").empty());
  for (const Value& warning : hot().summary.items("warnings"))
    CHECK(contains(html, "<li>" + escape(warning.as_text())));
  REQUIRE_FALSE(hot().summary.items("assumed").empty());
  for (const Value& input : hot().summary.items("assumed"))
    CHECK(contains(html, "<code>" + escape(input.text("key"))));
}

TEST_CASE("Nothing in a case's text can end the page's scripts or become markup") {
  const std::string& html = hot_page();
  CHECK_FALSE(contains(html, "<b>not bold</b>"));
  CHECK(contains(html, "&lt;b&gt;not bold"));
}

TEST_CASE("Every chart finds its columns, and columns of one run are equally long") {
  const std::string& html = hot_page();
  const Value data = data_of(html);
  std::size_t rows = 0;
  for (const Member& column : data.members("columns")) {
    const auto& values = std::get<Value::Array>(column.value.data);
    if (rows == 0) rows = values.size();
    CHECK(values.size() == rows);
  }
  CHECK(rows > 50);
  for (const Member& chart : data.members("charts")) {
    CHECK(contains(html, "data-chart=\"" + chart.key + "\""));
    for (const Value& line : chart.value.items("lines"))
      for (const char* axis : {"x", "y", "low", "high"})
        if (!line.text(axis).empty()) CHECK(data.has("columns/" + line.text(axis)));
  }
}

TEST_CASE("Every node of the energy's flow balances") {
  const Value data = data_of(hot_page());
  double from_beads = 0.0, into = 0.0, out = 0.0;  // [J] of the granules
  for (const Value& link : data.items("charts/energy/links")) {
    CHECK(link.number("value") > 0.0);
    if (link.text("to") == "granules") into += link.number("value");
    if (link.text("to") == "granules" && link.text("from") == "beads")
      from_beads += link.number("value");
    if (link.text("from") == "granules") out += link.number("value");
  }
  const auto path = [](const char* name) {
    return hot().summary.number(std::string("heat_paths/") + name);
  };
  CHECK(from_beads == Approx(path("contact") + path("gap") + path("radiation")).epsilon(1e-6));
  CHECK(out == Approx(into).epsilon(1e-6));  // eight digits are written
}

TEST_CASE("What a run has not is left out with one line that says why") {
  const std::string html = report_page(moved_alone());
  check_self_contained(html);
  CHECK(contains(html, "no reaction in this case"));
  CHECK(contains(html, "No mixture"));
  CHECK(contains(html, "No flow of energy"));
  CHECK(contains(html, "every particle has the same"));
  CHECK_FALSE(contains(html, ">nan"));
  CHECK_FALSE(contains(html, ">inf"));
}

TEST_CASE("A run with nothing but a header still gives a page") {
  RunData empty;
  empty.name = "empty";
  const std::string html = report_page(empty);
  CHECK(contains(html, "No pictures"));
  CHECK(contains(html, "No course"));
}

TEST_CASE("Several runs stand side by side with their differences") {
  RunData cold = moved_alone();
  cold.name = "cold";
  RunData other = hot();
  other.name = "other";
  other.header.case_text += "extra = 1\n";
  const double mean = hot().summary.number("thermal/temperature_mean/SrFeO3");
  other.summary = parse_json(R"({"thermal": {"temperature_mean": {"SrFeO3": )" +
                             std::to_string(mean - 10.0) + "}}}");
  const std::string html = comparison_page({hot(), other, cold});
  check_self_contained(html);
  CHECK(contains(html, "other − hot"));
  CHECK(contains(html, "\u221210.0\u202fK"));
  CHECK(contains(html, "extra = 1"));
  CHECK(data_of(html).has("charts/temperatures"));
}

TEST_CASE("A report is written from run folders") {
  const auto folder = std::filesystem::temp_directory_path() / "pmr_test_report";
  std::filesystem::create_directories(folder);
  write_report({real_folder()}, folder / "report.html");
  write_report({real_folder(), real_folder()}, folder / "compare.html");
  std::ifstream in(folder / "report.html");
  std::ostringstream html;
  html << in.rdbuf();
  CHECK(contains(html.str(), "</html>"));
  CHECK(contains(html.str(), "were hottest after"));
  CHECK_THROWS_AS(write_report({folder / "nothing"}, folder / "x.html"), CaseError);
  std::filesystem::remove_all(folder);
}
