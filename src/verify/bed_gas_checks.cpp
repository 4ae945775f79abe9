// Gas that rises through the pores of a bed, against the porous medium's closed form.
#include <Eigen/LU>
#include <cmath>

#include "chemistry/chamber.hpp"
#include "chemistry/gas.hpp"
#include "coupling/system.hpp"
#include "physics/porous_bed.hpp"
#include "pmr/base/constants.hpp"
#include "verify/check.hpp"
#include "verify/coupling_scenes.hpp"

namespace pmr::verify {
namespace {

using Vector = Eigen::VectorXd;

constexpr int layers = 12;
constexpr double T = 1000.0, top = 1000.0;           // [K], [Pa]
constexpr double area = 7.85e-3, height = 0.12;      // [m2], [m] the demonstrator's chamber
constexpr double permeability = 4.4e-9;              // [m2] d 2 mm, porosity 0.41
constexpr double release = 0.38 / 60.0;              // [mol/s] O2, the same all over the bed
constexpr double porosity = 0.41, tortuosity = 1.5;  // [1]

// Pure oxygen at T over a column of layers.
struct Column {
  explicit Column(double capillary) : setup(inert_case(constant_solid(1e3, 1e3, 1.0), 1e-3)) {
    setup.chamber = ChamberCase{0.0, 1.0, top, 1.0, T, 0.0, std::nullopt, std::nullopt, 0.0};
    const double each = height / layers;
    system.setup = &setup;
    system.closed = false;
    system.pores.layers.assign(layers, {area, each, porosity * area * each, permeability, capillary,
                                        porosity / tortuosity, 0.0});
  }
  // [mol/s] of each layer, what is released in it included, by its moles.
  Vector surplus(const Vector& moles) const {
    std::vector<double> y;
    for (const double n : moles)
      y.insert(y.end(), {n, 0.0, chemistry::internal_energy({n, 0.0}, T)});
    const auto rate = coupling::gas_rates(system, 0.0, y).rate;
    Vector of_layers(layers);
    for (Eigen::Index k = 0; k < layers; ++k)
      of_layers[k] = rate[static_cast<std::size_t>(3 * k)] + release / layers;
    return of_layers;
  }
  double pressure(double moles) const {  // [Pa]
    return chemistry::gas_pressure(moles, T, system.pores.layers[0].volume);
  }
  // Pressure at the bed's bottom [Pa] when nothing changes any more: Newton's method, and half a
  // layer down from the lowest centre by the parabola of p^2.
  double bottom() const {
    const double air = top * system.pores.layers[0].volume / (gas_constant * T);
    Vector moles = Vector::Constant(layers, 3.0 * air);
    for (int round = 0; round < 30; ++round) {
      const Vector now = surplus(moles);
      Eigen::MatrixXd slope(layers, layers);
      for (Eigen::Index k = 0; k < layers; ++k) {
        Vector shifted = moles;
        shifted[k] += 1e-6 * air;
        slope.col(k) = (surplus(shifted) - now) / (1e-6 * air);
      }
      moles -= slope.partialPivLu().solve(now);
    }
    const double p0 = pressure(moles[0]), p1 = pressure(moles[1]);
    return std::sqrt(p0 * p0 + (p0 * p0 - p1 * p1) / 8.0);
  }
  Case setup;
  coupling::System system{};
};

// p^2/2 + slip p rises by mu R T J L/(2 K) from the top, J the flux that leaves there; `slip` [Pa]
// is 4 lambda p/r.
double expected_pressure(double slip) {
  const double drive = chemistry::viscosity(1.0, T) * gas_constant * T * (release / area) * height /
                       (2.0 * permeability);
  const double whole = 0.5 * top * top + slip * top + drive;
  return std::sqrt(slip * slip + 2.0 * whole) - slip;
}

}  // namespace

std::vector<Check> bed_gas_checks() {
  const double r = physics::capillary_radius(permeability, porosity, tortuosity);
  const double slip = 4.0 * chemistry::mean_free_path(1.0, T, top) * top / r;
  constexpr double wide = 1e6;  // [m] capillaries without slip
  return {{"coupling.bed_pressure.viscous",
           "0.38 mol O2 in 60 s through 12 cm of bed under 1 kPa, pressure at the bottom, no slip",
           Column(wide).bottom(), 3126.0, 0.005 * 3126.0, "Pa",
           "p_b^2 = p_t^2 + mu R T J L/K by hand; tolerance: the viscosity's last digit"},
          {"coupling.bed_pressure.slip", "The same with slip at the pores' walls",
           Column(r).bottom(), expected_pressure(slip), 0.002 * expected_pressure(slip), "Pa",
           "closed form of d(p^2/2 + 4 lambda p/r); tolerance: slip is taken layer by layer"}};
}

}  // namespace pmr::verify
