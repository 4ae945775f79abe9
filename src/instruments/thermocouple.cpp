#include "instruments/thermocouple.hpp"

#include <Eigen/QR>
#include <limits>
#include <vector>

namespace pmr::instruments {
namespace {

constexpr std::size_t fewest = 8;  // [1] particles that a plane of four figures is drawn through

// T at the position, from least squares of T = T0 + g . (x - position).
double plane_at(const Vec3& position, const Particles& particles,
                const std::vector<std::size_t>& within) {
  const auto n = static_cast<Eigen::Index>(within.size());
  Eigen::MatrixXd places(n, 4);
  Eigen::VectorXd temperatures(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const std::size_t i = within[static_cast<std::size_t>(k)];
    places.row(k) << 1.0, (particles.position[i] - position).transpose();
    temperatures[k] = particles.temperature[i];
  }
  return Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(places).solve(temperatures)[0];
}

}  // namespace

ThermocoupleReading read_thermocouple(const Thermocouple& probe, const Particles& particles) {
  double nearest = std::numeric_limits<double>::infinity();  // [m]
  double nearest_temperature = std::numeric_limits<double>::quiet_NaN();
  double sum = 0.0;
  std::vector<std::size_t> within;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double distance = (particles.position[i] - probe.position).norm();
    if (distance < nearest) {
      nearest = distance;
      nearest_temperature = particles.temperature[i];
    }
    if (distance > probe.radius) continue;
    sum += particles.temperature[i];
    within.push_back(i);
  }
  const std::size_t count = within.size();
  if (probe.is_plane && count >= fewest)
    return {plane_at(probe.position, particles, within), count, nearest};
  return {count > 0 ? sum / static_cast<double>(count) : nearest_temperature, count, nearest};
}

}  // namespace pmr::instruments
