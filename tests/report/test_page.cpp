#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "pmr/base/errors.hpp"
#include "report/report.hpp"
#include "synthetic_run.hpp"

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
  static const RunData run = synthetic_run(300, "hot");
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

TEST_CASE("The answer comes first and in figures") {
  const std::string& html = hot_page();
  CHECK(contains(html, "871.9"));  // 1145.05 K in degC
  CHECK(contains(html, "with no particle lost"));
  CHECK(contains(html, "pO2 below the fit"));         // the warning
  CHECK(contains(html, "chamber.film_coefficient"));  // the assumed input
  CHECK(contains(html, "not reproduced."));           // the title says demonstrator
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
  double into = 0.0, out = 0.0;  // [J] of the granules
  for (const Value& link : data.items("charts/energy/links")) {
    CHECK(link.number("value") > 0.0);
    if (link.text("to") == "granules") into += link.number("value");
    if (link.text("from") == "granules") out += link.number("value");
  }
  CHECK(into == Approx(420 + 2300 + 1500));  // the summary's three paths
  CHECK(out == Approx(into).epsilon(1e-6));  // eight digits are written
}

TEST_CASE("What a run has not is left out with one line that says why") {
  const std::string html = report_page(mechanics_only(hot()));
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
  RunData cold = mechanics_only(hot());
  cold.name = "cold";
  RunData other = hot();
  other.name = "other";
  other.header.case_text += "extra = 1\n";
  other.summary = parse_json(R"({"thermal": {"temperature_mean": {"SrFeO3": 1135.05}}})");
  const std::string html = comparison_page({hot(), other, cold});
  check_self_contained(html);
  CHECK(contains(html, "other − hot"));
  CHECK(contains(html, "\u221210.0\u202fK"));
  CHECK(contains(html, "extra = 1"));
  CHECK(data_of(html).has("charts/temperatures"));
}

TEST_CASE("A report is written from run folders") {
  const auto folder = std::filesystem::temp_directory_path() / "pmr_test_report";
  write_folder(hot(), folder);
  write_report({folder}, folder / "report.html");
  write_report({folder, folder}, folder / "compare.html");
  std::ifstream in(folder / "report.html");
  std::ostringstream html;
  html << in.rdbuf();
  CHECK(contains(html.str(), "</html>"));
  CHECK(contains(html.str(), "871.9"));
  CHECK_THROWS_AS(write_report({folder / "nothing"}, folder / "x.html"), CaseError);
  std::filesystem::remove_all(folder);
}
