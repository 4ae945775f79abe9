#include "instruments/contact_layers.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "instruments/bed.hpp"
#include "physics/neighbours.hpp"

namespace pmr::instruments {
namespace {

// Of a species' row of `partners`.
double mean_of(const ContactLayer& layer, std::size_t species, std::size_t partners) {
  const std::size_t count = layer.particles[species];
  if (count == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(partners) / static_cast<double>(count);
}

std::vector<std::size_t> sums(const std::vector<std::size_t>& a,
                              const std::vector<std::size_t>& b) {
  std::vector<std::size_t> sum(a.size());
  std::transform(a.begin(), a.end(), b.begin(), sum.begin(), std::plus<>());
  return sum;
}

}  // namespace

double ContactLayer::touched(std::size_t species, std::size_t other) const {
  return mean_of(*this, species, partners[species * particles.size() + other]);
}

double ContactLayer::touched(std::size_t species) const {
  const auto row = partners.begin() + static_cast<std::ptrdiff_t>(species * particles.size());
  const auto end = row + static_cast<std::ptrdiff_t>(particles.size());
  return mean_of(*this, species, std::accumulate(row, end, std::size_t{0}));
}

double ContactLayer::touched_of_others(std::size_t species) const {
  return touched(species) - touched(species, species);
}

std::vector<ContactLayer> contact_layers(const Particles& bed, std::size_t species, const Vec3& up,
                                         std::size_t count) {
  if (bed.size() == 0 || count == 0) return {};
  const Particles stands = upright(bed, up);
  const double floor = lowest_point(stands);
  const double height = bed_height(stands, Vec3(0.0, 0.0, floor));
  const double thickness = height / static_cast<double>(count);
  std::vector<ContactLayer> layers;
  for (std::size_t k = 0; k < count; ++k) {
    const double top = height - static_cast<double>(k) * thickness;
    layers.push_back({top, top - thickness, std::vector<std::size_t>(species, 0),
                      std::vector<std::size_t>(species * species, 0)});
  }
  const auto layer_of = [&](std::size_t i) -> ContactLayer& {
    const double depth = floor + height - stands.position[i].z();
    const double k = std::clamp(std::floor(depth / thickness), 0.0, static_cast<double>(count - 1));
    return layers[static_cast<std::size_t>(k)];
  };
  const auto count_partner = [&](std::size_t i, std::size_t other) {
    ++layer_of(i).partners[bed.species[i] * species + bed.species[other]];
  };
  for (std::size_t i = 0; i < bed.size(); ++i) ++layer_of(i).particles[bed.species[i]];
  for (const physics::NeighbourPair& pair : physics::pairs_within(bed, 0.0)) {
    count_partner(pair.i, pair.j);
    count_partner(pair.j, pair.i);
  }
  return layers;
}

ContactLayer whole_bed(const std::vector<ContactLayer>& layers) {
  if (layers.empty()) return {};
  ContactLayer all = layers.front();
  all.bottom = layers.back().bottom;
  for (auto layer = layers.begin() + 1; layer != layers.end(); ++layer) {
    all.particles = sums(all.particles, layer->particles);
    all.partners = sums(all.partners, layer->partners);
  }
  return all;
}

io::Series contact_table(const std::vector<ContactLayer>& layers,
                         const std::vector<std::string>& species) {
  io::Series table;
  const auto add = [&](const std::string& name, const char* unit, const auto& value) {
    io::Column column{name, unit, {}};
    for (std::size_t k = 0; k < layers.size(); ++k) column.values.push_back(value(k));
    table.columns.push_back(std::move(column));
  };
  add("layer", "1", [](std::size_t k) { return static_cast<double>(k + 1); });
  add("top", "m", [&](std::size_t k) { return layers[k].top; });
  add("bottom", "m", [&](std::size_t k) { return layers[k].bottom; });
  for (std::size_t s = 0; s < species.size(); ++s) {
    add("particles." + species[s], "1",
        [&](std::size_t k) { return static_cast<double>(layers[k].particles[s]); });
    add("touched_by." + species[s], "1", [&](std::size_t k) { return layers[k].touched(s); });
    for (std::size_t other = 0; other < species.size(); ++other)
      add("touched_by." + species[s] + "." + species[other], "1",
          [&](std::size_t k) { return layers[k].touched(s, other); });
  }
  return table;
}

}  // namespace pmr::instruments
