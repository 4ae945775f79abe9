#include "validate/experiment.hpp"

#include <fmt/format.h>

#include <set>
#include <stdexcept>

#include "case/nearest.hpp"
#include "statistics/expression.hpp"
#include "study/file_parts.hpp"
#include "study/plan.hpp"

namespace pmr::validate {
namespace {

namespace fs = std::filesystem;
using casefile::Node;
using casefile::Table;

const char* const an_expression = "an expression such as \"temperature + 273.15\"";

Figure read_figure(Table& table, const std::string& name) {
  Figure figure;
  figure.name = name;
  study::check_name(table, name);
  figure.key = table.word_or("key", "");
  figure.column = table.word_or("series", "");
  figure.at = table.word_or("at", "");
  figure.factor = table.value("factor", casefile::a_number, 1.0);
  figure.offset = table.value("offset", casefile::a_number, 0.0);
  if (figure.key.empty() == figure.column.empty())
    table.fault("", "wanted one of: key, of summary.json; series, a column of the run's series");
  if (!figure.at.empty() && figure.column.empty()) table.fault("at", "goes with 'series' alone");
  return figure;
}

Bar read_bar(Table& parent) {
  Bar bar;
  const Node* node = parent.look_table("bar");
  if (node == nullptr) return bar;
  Table table(parent.reading(), *node, parent.path("bar"));
  const std::pair<const char*, Bar::Kind> kinds[] = {
      {"largest", Bar::Kind::largest}, {"rms", Bar::Kind::rms}, {"relative", Bar::Kind::relative}};
  int given = 0;
  for (const auto& [key, kind] : kinds)
    if (const auto most = table.maybe(key, casefile::a_positive_number)) {
      bar.kind = kind;
      bar.most = *most;
      ++given;
    }
  if (given != 1) table.fault("", "wanted one of: largest, rms, relative");
  bar.from = table.value("from", casefile::a_number, bar.from);
  bar.to = table.value("to", casefile::a_number, bar.to);
  return bar;
}

Quantity read_quantity(Table& table, const std::string& name) {
  Quantity q;
  q.name = name;
  q.label = table.word_or("label", name);
  q.unit = table.word_or("unit", "");
  q.computed = table.word("computed", an_expression);
  q.measured = table.word("measured", an_expression);
  q.deviation = table.word("deviation", an_expression);
  q.has_free_zero = table.flag("free_zero", false);
  q.bar = read_bar(table);
  q.on_miss = table.word_or("on_miss", "");
  return q;
}

Slope read_slope(Table& table, const std::string& name) {
  Slope slope;
  slope.name = name;
  slope.label = table.word_or("label", name);
  slope.x = table.word("x", an_expression);
  slope.y = table.word("y", an_expression);
  slope.measured = table.value("measured", casefile::a_number);
  slope.deviation = table.value("deviation", casefile::a_positive_number);
  slope.bar = table.value("bar", casefile::a_positive_number);
  slope.on_miss = table.word_or("on_miss", "");
  return slope;
}

Axis read_axis(Table& root) {
  Axis axis;
  const Node* node = root.need_table("axis");
  if (node == nullptr) return axis;
  Table table(root.reading(), *node, "axis");
  axis.value = table.word("value", an_expression);
  axis.label = table.word_or("label", axis.value);
  axis.unit = table.word_or("unit", "");
  axis.is_logarithmic = table.has("spacing") && table.choice("spacing", {"linear", "log"}) == "log";
  table.look("spacing");
  return axis;
}

Points read_points_of(Table& root) {
  const std::string name = root.word("points", "the name of a CSV file of measured points");
  if (name.empty()) return {};
  const fs::path folder = fs::absolute(root.look("points")->place.file).parent_path();
  try {
    return read_points(folder / name);
  } catch (const CaseError& error) {
    for (const Fault& fault : error.faults())
      root.fault("points",
                 fault.where + ": " + (fault.key.empty() ? "" : fault.key + ": ") + fault.problem);
    return {};
  }
}

std::optional<std::size_t> read_group(Table& root, const Points& points) {
  const std::string wanted = root.word_or("group", "");
  if (wanted.empty()) return std::nullopt;
  std::vector<std::string> names;
  for (std::size_t c = 0; c < points.columns.size(); ++c) {
    names.push_back(points.columns[c].name);
    if (names.back() == wanted) return c;
  }
  root.fault("group", casefile::unknown_word("column of the points", wanted, names));
  return std::nullopt;
}

// That each expression can be read, and knows its names.
class Expressions {
 public:
  Expressions(Table& root, const Experiment& e) : root_(root) {
    for (const auto& [name, value] : e.constants) known_.push_back(name);
    for (const Column& column : e.points.columns) known_.push_back(column.name);
    with_figures_ = known_;
    for (const Figure& f : e.figures) with_figures_.push_back(f.name);
  }
  void of_point(const std::string& key, const std::string& text) { check(key, text, known_); }
  void of_run(const std::string& key, const std::string& text) { check(key, text, with_figures_); }

 private:
  void check(const std::string& key, const std::string& text,
             const std::vector<std::string>& names) {
    if (text.empty()) return;
    try {
      statistics::Expression(text, names);
    } catch (const std::invalid_argument& error) {
      root_.fault(key, error.what());
    }
  }
  Table& root_;
  std::vector<std::string> known_, with_figures_;
};

void check_expressions(Table& root, const Experiment& e) {
  Expressions check(root, e);
  check.of_point("axis", e.axis.value);
  for (const Figure& f : e.figures) check.of_point("figures", f.at);
  for (const Quantity& q : e.quantities) {
    check.of_run("quantities", q.computed);
    check.of_point("quantities", q.measured);
    check.of_point("quantities", q.deviation);
  }
  for (const Slope& s : e.slopes) {
    check.of_point("slopes", s.x);
    check.of_run("slopes", s.y);
  }
}

void check_names(Table& root, const Experiment& e) {
  std::set<std::string> seen;
  const auto add = [&](const std::string& table, const std::string& name) {
    if (!seen.insert(name).second) root.fault(table, "'" + name + "' is named twice");
  };
  for (const auto& [name, value] : e.constants) add("constants", name);
  for (const Column& column : e.points.columns) add("points", column.name);
  for (const Figure& f : e.figures) add("figures", f.name);
}

// A bar that judges no point would be held whatever comes out; a miss is told in deviations.
void check_points(Table& root, const Experiment& e) {
  for (const Quantity& q : e.quantities) {
    std::size_t judged = 0;
    for (std::size_t row = 0; row < e.points.rows; ++row) {
      const study::Values known = known_at(e, row);
      const auto fault = [&](const std::string& problem) {
        root.fault("quantities", fmt::format("{}, point {}: {}", q.name, row + 1, problem));
      };
      try {
        judged += q.bar.judges(study::evaluated(e.axis.value, known)) ? 1 : 0;
        study::evaluated(q.measured, known);
        if (!(study::evaluated(q.deviation, known) > 0.0)) fault("wanted a deviation above 0");
      } catch (const std::invalid_argument& error) {
        fault(error.what());
      }
    }
    if (judged == 0)
      root.fault("quantities", q.name + ": no point lies between 'from' and 'to' of its bar");
  }
  if (!e.slopes.empty() && e.points.rows < 2)
    root.fault("slopes", "wanted at least two points for a straight line");
}

Experiment read_root(casefile::Reading& reading, const Node& document) {
  Table root(reading, document, "");
  Experiment e;
  e.title = root.word("title", "a text in quotes");
  e.teaches = root.word("teaches", "a paragraph on what the experiment tells");
  e.source = root.word("source", "where the points are from");
  e.case_file = study::read_case_name(root);
  e.constants = study::read_constants(root);
  e.settings = study::read_settings(root);
  e.points = read_points_of(root);
  e.group = read_group(root, e.points);
  e.axis = read_axis(root);
  e.replicates = root.count("replicates", 1, 1);
  if (root.need("figures", "a table for each figure of a run") != nullptr)
    study::for_each_in_order(root, "figures", [&](Table& table, const std::string& name) {
      e.figures.push_back(read_figure(table, name));
    });
  study::for_each_in_order(root, "variants", [&](Table& table, const std::string& name) {
    e.variants.push_back({name, table.word_or("label", name), study::read_settings(table)});
  });
  if (e.variants.empty()) e.variants.push_back({"", "computed", {}});
  if (root.need("quantities", "a table for each quantity compared") != nullptr)
    study::for_each_in_order(root, "quantities", [&](Table& table, const std::string& name) {
      e.quantities.push_back(read_quantity(table, name));
    });
  study::for_each_in_order(root, "slopes", [&](Table& table, const std::string& name) {
    e.slopes.push_back(read_slope(table, name));
  });
  check_names(root, e);
  if (reading.faults() == 0) check_expressions(root, e);
  if (reading.faults() == 0) check_points(root, e);
  return e;
}

}  // namespace

study::Values known_at(const Experiment& experiment, std::size_t row) {
  study::Values known = experiment.constants;
  for (const Column& column : experiment.points.columns) known[column.name] = column.values[row];
  return known;
}

Experiment read_experiment(const fs::path& file, const std::vector<std::string>& sets) {
  const Node document = study::document_of(file, "experiment");
  casefile::Reading reading;
  Experiment e = read_root(reading, document);
  reading.finish();
  e.file = file;
  e.name = study::safe_name(file.stem().string());
  e.sets = study::apply_to_constants(sets, e.constants);
  return e;
}

}  // namespace pmr::validate
