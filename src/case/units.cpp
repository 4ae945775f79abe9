// The only file that knows UDUNITS-2.
#include "case/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>

#include "pmr/base/errors.hpp"

namespace pmr::casefile {
namespace {

struct UnitDeleter {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct ConverterDeleter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Unit = std::unique_ptr<ut_unit, UnitDeleter>;
using Converter = std::unique_ptr<cv_converter, ConverterDeleter>;

struct DimensionName {
  Dimension dimension;
  const char* name;     // with its article
  const char* si;       // unit that values are converted to
  const char* example;  // of a value
};

// Order matters where dimensions share a unit: the first match names what was found.
constexpr std::array names{
    DimensionName{Dimension::none, "a dimensionless number", "1", "0.5"},
    DimensionName{Dimension::length, "a length", "m", "2.99 mm"},
    DimensionName{Dimension::mass, "a mass", "kg", "1 kg"},
    DimensionName{Dimension::time, "a time", "s", "125 ms"},
    DimensionName{Dimension::speed, "a speed", "m/s", "2 mm/s"},
    DimensionName{Dimension::acceleration, "an acceleration", "m/s2", "9.80665 m/s2"},
    DimensionName{Dimension::angle, "an angle", "radian", "43 deg"},
    DimensionName{Dimension::spin, "an angular velocity", "radian/s", "10 rad/s"},
    DimensionName{Dimension::frequency, "a frequency", "Hz", "50 Hz"},
    DimensionName{Dimension::temperature, "a temperature", "K", "1100 degC"},
    DimensionName{Dimension::temperature_difference, "a temperature difference", "K", "0.1 K"},
    DimensionName{Dimension::pressure, "a pressure", "Pa", "1000 Pa"},
    DimensionName{Dimension::density, "a density", "kg/m3", "3690 kg/m3"},
    DimensionName{Dimension::volume, "a volume", "m3", "1.5 l"},
    DimensionName{Dimension::flow, "a pumping speed", "m3/s", "0.1 m3/s"},
    DimensionName{Dimension::mass_rate, "a mass rate", "kg/s", "50 g/s"},
    DimensionName{Dimension::heat_capacity, "a heat capacity", "J/kg/K", "900 J/kg/K"},
    DimensionName{Dimension::molar_heat_capacity, "a molar heat capacity or entropy", "J/mol/K",
                  "102.4 J/mol/K"},
    DimensionName{Dimension::molar_energy, "a molar energy", "J/mol", "75.7 kJ/mol"},
    DimensionName{Dimension::molar_mass, "a molar mass", "kg/mol", "101.96 g/mol"},
    DimensionName{Dimension::conductivity, "a thermal conductivity", "W/m/K", "1.1 W/m/K"},
    DimensionName{Dimension::line_conductivity, "a conductivity times temperature", "W/m",
                  "15360 W/m"},
    DimensionName{Dimension::per_temperature, "a reciprocal temperature", "1/K", "0.002 1/K"},
    DimensionName{Dimension::film_coefficient, "a film coefficient", "W/m2/K", "8 W/m2/K"},
    DimensionName{Dimension::leak, "a leak", "mol/s/Pa", "1e-9 mol/s/Pa"},
    DimensionName{Dimension::rate_constant, "a rate constant", "mol/s/m3/Pa", "623 mol/s/m3/Pa"},
    DimensionName{Dimension::volumetric_rate, "a volumetric rate", "mol/s/m3", "623 mol/s/m3"},
    DimensionName{Dimension::diffusivity, "a diffusivity", "m2/s", "3e-5 m2/s"},
};

const DimensionName& name_of(Dimension dimension) {
  for (const DimensionName& name : names)
    if (name.dimension == dimension) return name;
  ensure(false, "every dimension has a name");
  return names[0];
}

struct Split {
  std::vector<double> numbers;
  std::string unit;
};

// Leading numbers, then the unit: "0 0 10 mm", "2.99mm". "1/K" is a unit, not a number.
Split split(std::string_view text) {
  Split out;
  while (true) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())) != 0)
      text.remove_prefix(1);
    const bool plus = text.size() > 1 && text.front() == '+';
    const char* first = text.data() + (plus ? 1 : 0);
    const char* last = text.data() + text.size();
    double number = 0.0;
    const auto [end, error] = std::from_chars(first, last, number);
    const bool glued = end != last && std::string_view("/*^.").find(*end) != std::string_view::npos;
    if (error != std::errc{} || glued) break;
    out.numbers.push_back(number);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  out.unit = text;
  while (!out.unit.empty() && out.unit.back() == ' ') out.unit.pop_back();
  return out;
}

}  // namespace

struct Units::System {
  ut_system* system;

  Unit unit(const std::string& text) const { return Unit(ut_parse(system, text.c_str(), UT_UTF8)); }
  bool converts(const ut_unit* from, const char* to) const {
    const Unit target = unit(to);
    return ut_are_convertible(const_cast<ut_unit*>(from), target.get()) != 0;
  }
  std::string found(const ut_unit* from) const {
    for (const DimensionName& name : names)
      if (converts(from, name.si)) return name.name;
    return "of another dimension";
  }
};

Units::Units() : system_(std::make_unique<System>()) {
  ut_set_error_message_handler(ut_ignore);
  system_->system = ut_read_xml(nullptr);
  if (system_->system == nullptr)
    throw CaseError(
        {{"UDUNITS-2", "", "its table of units cannot be read; set UDUNITS2_XML_PATH"}});
  const Unit degree = system_->unit("arc_degree");
  ut_map_symbol_to_unit("deg", UT_UTF8, degree.get());
}

Units::~Units() { ut_free_system(system_->system); }

std::string wanted(Dimension dimension) {
  const DimensionName& name = name_of(dimension);
  if (dimension == Dimension::none) return fmt::format("a bare number such as {}", name.example);
  return fmt::format("{} such as \"{}\"", name.name, name.example);
}

Quantities Units::parse(const std::string& text, Dimension dimension) const {
  const auto refuse = [&](const std::string& problem) {
    return Quantities{{}, fmt::format("'{}' {}; wanted {}", text, problem, wanted(dimension))};
  };
  Split parts = split(text);
  if (parts.numbers.empty()) return refuse("is no number with a unit");
  if (parts.unit.empty()) return refuse("has no unit");
  const Unit from = system_->unit(parts.unit);
  if (!from) return refuse(fmt::format("has the unknown unit '{}'", parts.unit));
  const DimensionName& name = name_of(dimension);
  if (!system_->converts(from.get(), name.si)) return refuse("is " + system_->found(from.get()));
  const Unit target = system_->unit(name.si);
  const Converter converter(ut_get_converter(from.get(), target.get()));
  const bool has_offset = cv_convert_double(converter.get(), 0.0) != 0.0;
  if (has_offset && dimension != Dimension::temperature)
    return refuse("is a temperature on a scale with an offset");
  for (double& number : parts.numbers) {
    if (!std::isfinite(number)) return refuse("is not finite");
    number = cv_convert_double(converter.get(), number);
  }
  return {std::move(parts.numbers), ""};
}

}  // namespace pmr::casefile
