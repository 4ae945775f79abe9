// One material: its figures and its laws.
#include <fmt/format.h>

#include <algorithm>

#include "case/materials.hpp"
#include "chemistry/heat_curve.hpp"
#include "chemistry/redox.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::casefile {
namespace {

constexpr Want poisson{Dimension::none, {-1.0, 0.5, true, false}};

// Reads a table whose mark and source hold for all of it, recorded as one figure.
template <class Read>
void read_law(Table& parent, const std::string& key, const Read& read) {
  const Node* node = parent.look_table(key);
  if (node == nullptr) return;
  Reading& reading = parent.reading();
  Table law(reading, *node, parent.path(key));
  const std::string mark =
      law.has("mark") ? law.choice("mark", {"P", "L", "D", "A"}) : std::string("A");
  const std::string source = law.word_or("source", "given in the case");
  const std::string range = law.word_or("range", "");
  Node figures = *node;
  for (const char* side : {"mark", "source", "range"}) figures.members.erase(side);
  if (!mark.empty() && reading.provenance != nullptr)
    reading.provenance->push_back({parent.path(key), write_value(figures), mark[0], source, range});
  const bool plain = reading.records_plain_values;
  reading.records_plain_values = false;
  read(law);
  reading.records_plain_values = plain;
}

// Rows "temperature" and "value" of equal length, temperatures ascending.
pmr::Table read_rows(Table& law, Want want) {
  pmr::Table rows{law.values("temperature", a_temperature), law.values("value", want)};
  if (rows.x.size() != rows.y.size()) law.fault("value", "wanted as many values as temperatures");
  if (std::adjacent_find(rows.x.begin(), rows.x.end(), std::greater_equal<>()) != rows.x.end())
    law.fault("temperature", "wanted rising temperatures");
  if (rows.x.empty() || rows.x.size() != rows.y.size()) return constant(nan);
  return rows;
}

// sum of c_k T^k between two temperatures, as rows so close that lines between them are within
// 1e-5 of any smooth law of solids.
pmr::Table read_polynomial(Table& law, Want want) {
  constexpr int parts = 400;
  Want any_sign = want;
  any_sign.range = any;
  const std::vector<double> c = law.values("coefficients", any_sign);
  const double low = law.value("minimum_temperature", a_temperature);
  const double high = law.value("maximum_temperature", a_temperature);
  if (high <= low) law.fault("maximum_temperature", "wanted above minimum_temperature");
  if (c.empty() || !(high > low)) return constant(nan);
  pmr::Table rows;
  for (int k = 0; k <= parts; ++k) {
    const double T = low + (high - low) * k / parts;
    double value = 0.0;
    for (std::size_t n = c.size(); n-- > 0;) value = value * T + c[n];
    rows.x.push_back(T);
    rows.y.push_back(value);
    if (!want.range.holds(value)) {
      law.fault("coefficients",
                fmt::format("at {:.0f} K they give {:.4g} (SI), which is out of range", T, value));
      return constant(nan);
    }
  }
  return rows;
}

// By rows or by a polynomial, as `law` says.
pmr::Table read_over_temperature(Table& law, const std::string& kind, Want want) {
  return kind == "polynomial" ? read_polynomial(law, want) : read_rows(law, want);
}

ConstantHeat read(Table& law, ConstantHeat) {
  return {law.value("heat_capacity", {Dimension::heat_capacity, positive})};
}

Shomate read(Table& law, Shomate) {
  const Want coefficient{Dimension::molar_heat_capacity, any};
  const auto energy = [&](const char* key) {  // [kJ/mol], as NIST writes them
    return law.value(key, {Dimension::molar_energy, any}) * 1e-3;
  };
  return {law.value("a", coefficient),
          law.value("b", coefficient),
          law.value("c", coefficient),
          law.value("d", coefficient),
          law.value("e", coefficient),
          energy("f"),
          energy("h"),
          law.value("molar_mass", {Dimension::molar_mass, positive}),
          law.value("minimum_temperature", a_temperature),
          law.value("maximum_temperature", a_temperature)};
}

OxideHeat read(Table& law, OxideHeat) {
  const Want coefficient{Dimension::molar_heat_capacity, any};
  return {law.value("a", coefficient),
          law.value("b", coefficient),
          law.value("c", coefficient),
          law.value("d", coefficient),
          law.value("minimum_temperature", a_temperature),
          law.value("maximum_temperature", a_temperature)};
}

HeatLaw read_heat(Table& law) {
  const std::string kind = law.choice("law", {ConstantHeat::name, Shomate::name, OxideHeat::name,
                                              TabulatedHeat::name, "polynomial"});
  if (kind == ConstantHeat::name) return read(law, ConstantHeat{});
  if (kind == Shomate::name) return read(law, Shomate{});
  if (kind == OxideHeat::name) return read(law, OxideHeat{});
  if (!kind.empty())
    return TabulatedHeat{
        IntegratedTable(read_over_temperature(law, kind, {Dimension::heat_capacity, positive}))};
  law.ignore_rest();
  return ConstantHeat{nan};
}

Conductivity read_conductivity(Table& law) {
  const std::string kind = law.choice("law", {"constant", "table", "polynomial", "alumina"});
  const Want conductivity{Dimension::conductivity, positive};
  if (kind == "alumina")
    return AluminaConductivity{law.value("factor", a_positive_number),
                               law.value("c0", {Dimension::conductivity, not_negative}),
                               law.value("c1", {Dimension::line_conductivity, not_negative}),
                               law.value("c2", {Dimension::per_temperature, not_negative}),
                               law.value("c3", {Dimension::temperature_difference, any})};
  if (kind == "table" || kind == "polynomial")
    return TabulatedConductivity{read_over_temperature(law, kind, conductivity),
                                 law.value("gas_share", a_fraction, 0.0),
                                 law.value("half_pressure", {Dimension::pressure, positive}, 1.0)};
  if (kind.empty()) law.ignore_rest();
  if (kind != "constant") return TabulatedConductivity{constant(nan)};
  return TabulatedConductivity{constant(law.value("value", conductivity))};
}

pmr::Table read_emissivity(Table& table) {
  const Want emissivity{Dimension::none, {lowest_emissivity, 1.0}};
  const Node* node = table.look("emissivity");
  if (node == nullptr) return constant(nan);
  const bool is_polynomial = node->find("coefficients") != nullptr;
  if (node->find("temperature") == nullptr && !is_polynomial)
    return constant(table.value("emissivity", emissivity));
  pmr::Table rows = constant(nan);
  read_law(table, "emissivity", [&](Table& law) {
    rows = read_over_temperature(law, is_polynomial ? "polynomial" : "table", emissivity);
  });
  return rows;
}

constexpr Want an_entropy{Dimension::molar_heat_capacity, any};

void read(Table& law, ArctanEnthalpy, RedoxEquilibrium& e) {
  const Want energy{Dimension::molar_energy, positive};
  ArctanEnthalpy enthalpy{};
  enthalpy.minimum = law.value("enthalpy_minimum", energy);
  enthalpy.maximum = law.value("enthalpy_maximum", energy);
  enthalpy.shift = law.value("shift", a_number);
  enthalpy.steepness = law.value("steepness", a_positive_number);
  enthalpy.offset = law.value("offset", a_number);
  e.enthalpy = enthalpy;
  e.vibration_entropy = law.value("vibration_entropy", an_entropy);
  const Node* oxygen = law.look("oxygen_entropy");
  if (oxygen == nullptr || oxygen->text != "gas")
    e.oxygen_entropy = law.value("oxygen_entropy", an_entropy);
}

void read(Table& law, PolynomialEnthalpy, RedoxEquilibrium& e) {
  const Want energy{Dimension::molar_energy, any};
  PolynomialEnthalpy enthalpy{};
  enthalpy.c[0] = law.value("enthalpy_0", energy);
  for (std::size_t k = 1; k < enthalpy.c.size(); ++k)
    enthalpy.c[k] = law.value(fmt::format("enthalpy_{}", k), energy, 0.0);
  e.enthalpy = enthalpy;
  e.vibration_entropy = 0.0;
  e.oxygen_entropy = law.value("entropy", an_entropy);
}

void read_fit(Table& law, RedoxEquilibrium& e) {
  const Want delta{Dimension::none, {0.0, 3.0, false, false}};
  e.configuration = law.value("configuration", a_positive_number);
  e.fit_delta_minimum = law.value("fit_delta_minimum", delta);
  e.fit_delta_maximum = law.value("fit_delta_maximum", delta);
  e.fit_temperature_minimum = law.value("fit_temperature_minimum", a_temperature);
  e.fit_temperature_maximum = law.value("fit_temperature_maximum", a_temperature);
  e.fit_pressure_minimum = law.value("fit_pressure_minimum", a_pressure);
  e.fit_pressure_maximum = law.value("fit_pressure_maximum", a_pressure);
}

// Both laws may stand in a material, each in a table of its name; "enthalpy" says which counts.
// (A table with a "law" would be replaced as a whole where a case sets that alone.)
RedoxEquilibrium read_equilibrium(Table& redox) {
  RedoxEquilibrium e{};
  const Node* node = redox.look_table("equilibrium");
  if (node == nullptr) return e;
  Table table(redox.reading(), *node, redox.path("equilibrium"));
  for (const char* key : {ArctanEnthalpy::name, PolynomialEnthalpy::name}) table.look(key);
  e.delta_limit = table.value("delta_limit", {Dimension::none, {0.0, 3.0, false, false}}, 0.5);
  const std::size_t before = redox.reading().faults();
  const bool is_named = choose_law(table, "enthalpy", e.enthalpy, [&](auto named) {
    table.need_table(named.name);
    read_law(table, named.name, [&](Table& law) {
      read(law, named, e);
      read_fit(law, e);
    });
  });
  if (!is_named)
    table.ignore_rest();
  else if (redox.reading().faults() == before &&
           !chemistry::is_stable(e, e.fit_temperature_minimum))
    table.fault("enthalpy",
                "its pressure does not fall all the way as delta rises at the lowest temperature "
                "of its fit");
  return e;
}

constexpr Want an_energy{Dimension::molar_energy, not_negative};

// The pre-exponential is per Pa^m; UDUNITS has no broken powers, so m = 1 alone is written in Pa.
PowerRate read(Table& law, PowerRate) {
  PowerRate rate{};
  rate.factor = law.value("factor", {Dimension::none, not_negative});
  rate.exponent = law.value("exponent", a_positive_number);
  const Want constant{rate.exponent == 1.0 ? Dimension::rate_constant : Dimension::volumetric_rate,
                      not_negative};
  rate.reduction = {law.value("pre_exponential", constant),
                    law.value("activation_energy", an_energy)};
  const bool has_own = law.has("oxidation_pre_exponential") || law.has("oxidation_energy");
  if (has_own)
    rate.oxidation = Arrhenius{law.value("oxidation_pre_exponential", constant),
                               law.value("oxidation_energy", an_energy)};
  return rate;
}

RelaxationRate read(Table& law, RelaxationRate) {
  return {law.value("time", a_duration), law.value("reference_temperature", a_temperature),
          law.value("reduction_energy", an_energy), law.value("oxidation_energy", an_energy),
          law.value("shortest", a_duration)};
}

VacancyRate read(Table& law, VacancyRate) {
  return {law.value("pre_exponential", {Dimension::event_rate, positive}),
          law.value("activation_energy", an_energy), law.value("exponent", a_positive_number),
          law.value("reference_pressure", {Dimension::pressure, positive})};
}

// The law that "law" names, with its figures; else it stays what it is.
template <class Law>
void read_named(Table& table, Law& law) {
  if (!choose_law(table, "law", law, [&](auto named) { law = read(table, named); }))
    table.ignore_rest();
}

std::optional<PoreDiffusion> read_pores(Table& redox, const RateLaw& rate) {
  const Node* node = redox.look_table("pores");
  if (node == nullptr) return std::nullopt;
  const auto* power = std::get_if<PowerRate>(&rate);
  if (power == nullptr || power->exponent != 1.0)
    redox.fault("pores", "wanted only with the power law of exponent 1");
  Table table(redox.reading(), *node, redox.path("pores"));
  return PoreDiffusion{table.value("diffusivity", {Dimension::diffusivity, positive}),
                       table.value("reference_temperature", a_temperature)};
}

Redox read_redox(Table& table) {
  Redox redox{};
  table.need_table("equilibrium");
  table.need_table("rate");
  redox.equilibrium = read_equilibrium(table);
  read_law(table, "rate", [&](Table& law) {
    read_named(law, redox.rate);
    redox.rate_temperature_minimum = law.value("fit_temperature_minimum", a_temperature, 0.0);
    redox.rate_temperature_maximum = law.value("fit_temperature_maximum", a_temperature, infinity);
  });
  redox.pores = read_pores(table, redox.rate);
  redox.oxygen_atoms = table.value("oxygen_atoms", a_positive_number);
  redox.molar_mass = table.value("molar_mass", {Dimension::molar_mass, positive});
  redox.atomic_oxygen = table.value("atomic_oxygen", {Dimension::molar_mass, positive});
  redox.density_delta = table.value("density_delta", {Dimension::none, {0.0, 3.0}});
  return redox;
}

void read_elasticity(Table& table, Material& material) {
  const Want modulus{Dimension::pressure, positive};
  material.young_soft = table.value("young_soft", modulus, nan);
  material.poisson_soft = table.value("poisson_soft", poisson, nan);
  material.young_real = table.value("young_real", modulus, nan);
  material.poisson_real = table.value("poisson_real", poisson, nan);
}

}  // namespace

Material read_material(Reading& reading, const Node& node, const std::string& name) {
  Material material{};
  material.name = name;
  std::vector<Provenance>* const outer = reading.provenance;
  reading.provenance = &material.provenance;
  reading.records_plain_values = true;
  const std::string path = joined("materials", name);
  {
    Table table(reading, node, path);
    for (const char* key :
         {"heat", "conductivity", "emissivity", "emissivity_per_delta", "accommodation", "redox"})
      table.moves_nothing(key);
    material.density = table.value("density", {Dimension::density, positive}, nan);
    read_elasticity(table, material);
    material.heat = ConstantHeat{nan};
    read_law(table, "heat", [&](Table& law) { material.heat = read_heat(law); });
    material.conductivity = TabulatedConductivity{constant(nan)};
    read_law(table, "conductivity",
             [&](Table& law) { material.conductivity = read_conductivity(law); });
    material.emissivity = {read_emissivity(table),
                           table.value("emissivity_per_delta", a_number, 0.0)};
    material.accommodation = table.value("accommodation", {Dimension::none, {0, 1, true}}, nan);
    if (const Node* redox = table.look_table("redox"); redox != nullptr) {
      Table inner(reading, *redox, table.path("redox"));
      material.redox = read_redox(inner);
    }
  }
  reading.provenance = outer;
  reading.records_plain_values = false;
  for (Provenance& figure : material.provenance) figure.key.erase(0, path.size() + 1);
  return material;
}

}  // namespace pmr::casefile
