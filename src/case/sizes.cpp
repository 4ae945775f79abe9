#include "case/sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "case/csv.hpp"

namespace pmr::casefile {
namespace {

using physics::SizeLaw;

constexpr double rounding = 2e-3;  // [1] by which fractions of a table may miss 1

// Classes whose fractions add up to 1, but for the rounding of a table.
std::optional<SizeLaw> classes_of(Table& table, const std::string& key,
                                  std::vector<double> diameter, std::vector<double> fraction) {
  const double sum = std::accumulate(fraction.begin(), fraction.end(), 0.0);
  const auto is_bad = [](double f) { return !(f > 0.0 && f <= 1.0); };
  if (diameter.empty() || fraction.empty()) return std::nullopt;  // told already
  if (diameter.size() != fraction.size())
    table.fault(key, fmt::format("has {} mass fractions for {} diameters", fraction.size(),
                                 diameter.size()));
  else if (std::any_of(fraction.begin(), fraction.end(), is_bad))
    table.fault(key, "wanted mass fractions above 0 and at most 1");
  else if (std::abs(sum - 1.0) > rounding)
    table.fault(key, fmt::format("the mass fractions add up to {:.6g}; wanted 1", sum));
  else {
    for (double& f : fraction) f /= sum;
    return physics::SizeClasses{std::move(diameter), std::move(fraction)};
  }
  return std::nullopt;
}

std::optional<SizeLaw> curve_of(Table& table, std::vector<double> diameter,
                                std::vector<double> passing) {
  if (diameter.size() < 2)
    table.fault("csv", "wanted at least two points of the curve");
  else if (!std::is_sorted(diameter.begin(), diameter.end(), std::less_equal<>()))
    table.fault("csv", "wanted diameters that ascend");
  else if (!std::is_sorted(passing.begin(), passing.end()) || passing.front() != 0.0 ||
           std::abs(passing.back() - 1.0) > rounding)
    table.fault("csv", "wanted mass fractions passing that ascend from 0 to 1");
  else {
    for (double& q : passing) q /= passing.back();
    return physics::SizeCurve{std::move(diameter), std::move(passing)};
  }
  return std::nullopt;
}

// "diameter [mm], passing" (a curve) or "diameter [mm], mass_fraction" (classes).
std::optional<SizeLaw> read_csv(Table& table) {
  const std::string name = table.file("csv", "the name of a CSV file");
  if (name.empty()) return std::nullopt;
  const auto sheet = read_number_csv(table.reading(), name,
                                     {{"diameter", Dimension::length},
                                      {"passing", Dimension::none},
                                      {"mass_fraction", Dimension::none}});
  if (!sheet) return std::nullopt;
  const auto& [diameter, passing, fraction] = std::tie((*sheet)[0], (*sheet)[1], (*sheet)[2]);
  const bool is_positive =
      std::all_of(diameter.begin(), diameter.end(), [](double d) { return d > 0.0; });
  if (diameter.empty() || passing.empty() == fraction.empty() || !is_positive) {
    table.fault("csv",
                "wanted the columns 'diameter [mm]', above zero, and either 'passing' or "
                "'mass_fraction'");
    return std::nullopt;
  }
  if (!fraction.empty()) return classes_of(table, "csv", diameter, fraction);
  return curve_of(table, diameter, passing);
}

std::optional<SizeLaw> read_size_law(Table& table) {
  const std::string law =
      table.choice("law", {"classes", "normal", "log-normal", "rosin-rammler", "csv"});
  if (law == "classes")
    return classes_of(table, "mass_fraction", table.values("diameter", a_length),
                      table.values("mass_fraction", a_number));
  if (law == "normal")
    return physics::NormalSizes{table.value("mean", a_length), table.value("deviation", a_length)};
  if (law == "log-normal")
    return physics::LogNormalSizes{table.value("median", a_length),
                                   table.value("log_deviation", {Dimension::none, {0, 2, true}})};
  if (law == "rosin-rammler")
    return physics::RosinRammlerSizes{table.value("scale", a_length),
                                      table.value("exponent", {Dimension::none, {0.5, 100}})};
  if (law == "csv") return read_csv(table);
  table.ignore_rest();
  return std::nullopt;
}

}  // namespace

std::optional<physics::SizeDistribution> read_sizes(Table& species) {
  const Node* node = species.need_table("size");
  if (node == nullptr) return std::nullopt;
  Table table(species.reading(), *node, species.path("size"));
  const std::size_t before = table.reading().faults();
  const auto law = read_size_law(table);
  if (!law || table.reading().faults() != before) {
    table.ignore_rest();
    return std::nullopt;
  }
  physics::SizeDistribution sizes = physics::cut_at_tails(*law);
  if (!std::holds_alternative<physics::SizeClasses>(*law)) {
    sizes.smallest = table.value("smallest", a_length, sizes.smallest);
    sizes.largest = table.value("largest", a_length, sizes.largest);
  }
  if (std::isnan(sizes.smallest + sizes.largest)) return std::nullopt;  // a missing key, told later
  if (sizes.smallest <= 0.0)
    table.fault("deviation", "reaches sizes below zero; wanted `smallest`, or less of it");
  else if (sizes.smallest > sizes.largest)
    table.fault("largest", "wanted above smallest");
  return table.reading().faults() == before ? std::optional(sizes) : std::nullopt;
}

}  // namespace pmr::casefile
