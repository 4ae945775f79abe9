#include "instruments/thermocouple.hpp"

#include <limits>

namespace pmr::instruments {

ThermocoupleReading read_thermocouple(const Thermocouple& probe, const Particles& particles) {
  double nearest = std::numeric_limits<double>::infinity();  // [m]
  double nearest_temperature = std::numeric_limits<double>::quiet_NaN();
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double distance = (particles.position[i] - probe.position).norm();
    if (distance < nearest) {
      nearest = distance;
      nearest_temperature = particles.temperature[i];
    }
    if (distance > probe.radius) continue;
    sum += particles.temperature[i];
    ++count;
  }
  const double temperature = count > 0 ? sum / static_cast<double>(count) : nearest_temperature;
  return {temperature, count, nearest};
}

}  // namespace pmr::instruments
