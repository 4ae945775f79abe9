// The only file that knows UDUNITS-2.
#include "case/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "case/unit_text.hpp"
#include "pmr/base/constants.hpp"
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
    DimensionName{Dimension::rotation_rate, "a rate of rotation", "radian/s", "20 rpm"},
    DimensionName{Dimension::frequency, "a frequency", "Hz", "50 Hz"},
    DimensionName{Dimension::event_rate, "a number per time", "1/s", "2000 1/s"},
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

// What a unit is made of. UDUNITS itself counts radians as numbers, and takes a unit for its
// reciprocal: by that 5 s/m would be a speed of 0.2 m/s, and 5 Hz a time.
struct Anatomy {
  std::map<std::string, int> powers;  // of the base units; of the radian in `angle`
  int angle = 0;
  bool is_linear = true;  // neither logarithmic nor a date

  static ut_status basic(const ut_unit* unit, void* anatomy) {
    const int one = 1;
    return product(unit, 1, &unit, &one, anatomy);
  }
  static ut_status product(const ut_unit*, int count, const ut_unit* const* units,
                           const int* powers, void* anatomy) {
    auto& out = *static_cast<Anatomy*>(anatomy);
    for (int k = 0; k < count; ++k) {
      const char* symbol = ut_get_symbol(units[k], UT_ASCII);
      const std::string name = symbol == nullptr ? "" : symbol;
      (name == "rad" ? out.angle : out.powers[name]) += powers[k];
    }
    return UT_SUCCESS;
  }
  static ut_status galilean(const ut_unit*, double, const ut_unit* underlying, double,
                            void* anatomy) {
    return ut_accept_visitor(underlying, &visitor, anatomy);
  }
  static ut_status other(void* anatomy) {
    static_cast<Anatomy*>(anatomy)->is_linear = false;
    return UT_SUCCESS;
  }
  static ut_status timestamp(const ut_unit*, const ut_unit*, double, void* anatomy) {
    return other(anatomy);
  }
  static ut_status logarithmic(const ut_unit*, double, const ut_unit*, void* anatomy) {
    return other(anatomy);
  }
  static const ut_visitor visitor;
};

const ut_visitor Anatomy::visitor{basic, product, galilean, timestamp, logarithmic};

Anatomy anatomy_of(const ut_unit* unit) {
  Anatomy anatomy;
  ut_accept_visitor(unit, &Anatomy::visitor, &anatomy);
  return anatomy;
}

// Factor from a unit to the SI unit of a dimension that angles bring in [1], beside UDUNITS' own: a
// turn is 2 pi rad. None where the two do not fit.
std::optional<double> turns(const Anatomy& from, const Anatomy& to, Dimension dimension) {
  if (!from.is_linear || from.powers != to.powers) return std::nullopt;
  if (from.angle == to.angle) return 1.0;
  if (dimension == Dimension::rotation_rate && from.angle == 0) return 2.0 * pi;      // "20 1/min"
  if (dimension == Dimension::frequency && from.angle == 1) return 1.0 / (2.0 * pi);  // "3000 rpm"
  return std::nullopt;
}

}  // namespace

struct Units::System {
  ut_system* system;

  Unit unit(const std::string& text) const { return Unit(ut_parse(system, text.c_str(), UT_UTF8)); }
  std::optional<double> turns_to(const ut_unit* from, const DimensionName& to) const {
    return turns(anatomy_of(from), anatomy_of(unit(to.si).get()), to.dimension);
  }
  std::string found(const ut_unit* from) const {
    for (const DimensionName& name : names)
      if (turns_to(from, name) == 1.0) return name.name;
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
  NumbersAndUnit parts = split(text);
  if (parts.numbers.empty()) return refuse("is no number with a unit");
  if (parts.unit.empty()) return refuse("has no unit");
  if (!has_whole_exponents(parts.unit))
    return refuse(
        fmt::format("has the unit '{}', in which a number is no whole exponent", parts.unit));
  const Unit from = system_->unit(parts.unit);
  if (!from) return refuse(fmt::format("has the unknown unit '{}'", parts.unit));
  const DimensionName& name = name_of(dimension);
  const std::optional<double> turns = system_->turns_to(from.get(), name);
  if (!turns) return refuse("is " + system_->found(from.get()));
  const Converter converter(ut_get_converter(from.get(), system_->unit(name.si).get()));
  const bool has_offset = cv_convert_double(converter.get(), 0.0) != 0.0;
  if (has_offset && dimension != Dimension::temperature)
    return refuse("is a temperature on a scale with an offset");
  for (double& number : parts.numbers) {
    if (!std::isfinite(number)) return refuse("is not finite");
    number = *turns * cv_convert_double(converter.get(), number);
    if (!std::isfinite(number)) return refuse("is not finite in SI");
  }
  return {std::move(parts.numbers), ""};
}

Scale Units::scale(const std::string& unit, Dimension dimension) const {
  if (const NumbersAndUnit parts = split(unit); !parts.numbers.empty())
    return {0.0, 1.0, fmt::format("'{}' is no unit: it holds a number", unit)};
  const Quantities ends = parse("0 1 " + unit, dimension);
  if (!ends.problem.empty()) return {0.0, 1.0, ends.problem};
  return {ends.values[0], ends.values[1] - ends.values[0], ""};
}

}  // namespace pmr::casefile
