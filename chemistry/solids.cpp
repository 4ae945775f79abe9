#include "chemistry/solids.hpp"

#include "chemistry/gas.hpp"
#include "chemistry/redox.hpp"
#include "chemistry/temperature_inverse.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::chemistry {
namespace {

HeatCurve curve_of(const Shomate& law) {
  return {law.a,
          law.b,
          law.c,
          law.d,
          law.e,
          1e3 * (law.f - law.h),
          law.minimum_temperature,
          law.maximum_temperature};
}

// At delta = 0.5, per mol of formula units.
HeatCurve curve_of(const OxideHeat& law) {
  const HeatCurve curve{
      law.a, law.b, law.c, 0.0, law.d, 0.0, law.minimum_temperature, law.maximum_temperature};
  return anchored(curve, enthalpy_zero, 0.0);
}

// Per kg.
HeatPoint inert_heat(const Material& material, double T) {
  if (const auto* law = std::get_if<ConstantHeat>(&material.heat))
    return {law->heat_capacity * (T - enthalpy_zero), law->heat_capacity};
  if (const auto* law = std::get_if<TabulatedHeat>(&material.heat))
    return {law->rows.integral(T) - law->rows.integral(enthalpy_zero), law->rows.table(T)};
  const auto* law = std::get_if<Shomate>(&material.heat);
  ensure(law != nullptr, "an inert material's heat law is a constant, a table or Shomate's");
  const HeatPoint molar = evaluate(curve_of(*law), T);
  return {molar.enthalpy / law->molar_mass, molar.heat_capacity / law->molar_mass};
}

HeatCurve oxide_curve(const Material& material) {
  const auto* law = std::get_if<OxideHeat>(&material.heat);
  ensure(law != nullptr, "a redox material's heat law is OxideHeat");
  return curve_of(*law);
}

// Per mol Fe, without H(delta), which does not depend on T.
HeatPoint sensible_heat(const HeatCurve& oxide, double T, double delta) {
  const HeatPoint base = evaluate(oxide, T);
  const HeatPoint gas = oxygen_heat(T);
  const double oxygen = 0.5 * (0.5 - delta);  // [mol O2/mol] beyond delta = 0.5
  return {base.enthalpy + oxygen * gas.enthalpy, base.heat_capacity + oxygen * gas.heat_capacity};
}

}  // namespace

bool heat_law_fits(const Material& material) {
  return material.redox.has_value() == std::holds_alternative<OxideHeat>(material.heat);
}

double specific_heat(const Material& material, double T) {
  return inert_heat(material, T).heat_capacity;
}

double specific_enthalpy(const Material& material, double T) {
  return inert_heat(material, T).enthalpy;
}

double molar_heat_capacity(const Material& material, double T, double delta) {
  return sensible_heat(oxide_curve(material), T, delta).heat_capacity;
}

double molar_enthalpy(const Material& material, double T, double delta) {
  return sensible_heat(oxide_curve(material), T, delta).enthalpy +
         reduction_heat(material.redox->equilibrium, delta);
}

double enthalpy(const Solid& solid, double T, double delta) {
  const Material& material = *solid.material;
  return solid.amount *
         (material.redox ? molar_enthalpy(material, T, delta) : specific_enthalpy(material, T));
}

double heat_capacity(const Solid& solid, double T, double delta) {
  const Material& material = *solid.material;
  return solid.amount *
         (material.redox ? molar_heat_capacity(material, T, delta) : specific_heat(material, T));
}

double enthalpy_delta_slope(const Solid& solid, double T, double delta) {
  const Material& material = *solid.material;
  if (!material.redox) return 0.0;
  return enthalpy_bond_slope(solid, T, reduction_enthalpy(material.redox->equilibrium, delta));
}

double enthalpy_bond_slope(const Solid& solid, double T, double dh) {
  return solid.amount * (dh - 0.5 * oxygen_heat(T).enthalpy);
}

double temperature(const Solid& solid, double energy, double delta, double guess) {
  const Material& material = *solid.material;
  const double per_amount = energy / solid.amount;
  if (!material.redox)
    return solve_temperature(
        per_amount, guess, [&](double T) { return inert_heat(material, T); },
        material.name.c_str());
  const double heat = reduction_heat(material.redox->equilibrium, delta);
  return redox_temperature(solid, energy, delta, heat, guess);
}

double redox_temperature(const Solid& solid, double energy, double delta, double bond_heat,
                         double guess) {
  const Material& material = *solid.material;
  const HeatCurve oxide = oxide_curve(material);
  return solve_temperature(
      energy / solid.amount - bond_heat, guess,
      [&](double T) { return sensible_heat(oxide, T, delta); }, material.name.c_str());
}

}  // namespace pmr::chemistry
