#include "instruments/decomposition.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "instruments/bed.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::instruments {
namespace {

// Places from the highest centre to the lowest, equal heights by id.
std::vector<std::size_t> from_the_top(const Particles& bed) {
  std::vector<std::size_t> order(bed.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const double za = bed.position[a].z(), zb = bed.position[b].z();
    return za != zb ? za > zb : bed.id[a] < bed.id[b];
  });
  return order;
}

std::size_t sector_of(const Vec3& position, const Decomposition& tool) {
  const double x = position.x() - tool.axis_point.x();
  const double y = position.y() - tool.axis_point.y();
  const double width = 2.0 * pi / tool.sectors;
  const double turns = (std::atan2(y, x) - tool.ramp_azimuth) / width + 0.5;
  const auto sectors = static_cast<long>(tool.sectors);
  const long sector = static_cast<long>(std::floor(turns)) % sectors;
  return static_cast<std::size_t>(sector < 0 ? sector + sectors : sector);
}

void add(Portion& portion, const Particles& bed, std::size_t i, const Sides& sides) {
  if (sides[bed.species[i]] == Side::beads) {
    portion.bead_mass += bed.mass[i];
    ++portion.beads;
  } else {
    portion.granule_mass += bed.mass[i];
    ++portion.granules;
  }
}

// First place of each layer in the order from the top, the residuum's, and the end. A layer ends
// before the particle that would bring its sum further past the target than it is short of it.
std::vector<std::size_t> layer_starts(const Particles& bed, const std::vector<std::size_t>& order,
                                      const std::vector<double>& fractions) {
  double total = 0.0;
  for (const std::size_t i : order) total += bed.mass[i];
  std::vector<std::size_t> starts{0};
  double target = 0.0, removed = 0.0;
  std::size_t next = 0;
  for (const double fraction : fractions) {
    target += fraction * total;
    while (next < order.size() && removed + 0.5 * bed.mass[order[next]] < target)
      removed += bed.mass[order[next++]];
    starts.push_back(next);
  }
  starts.push_back(order.size());
  return starts;
}

// Height of the cut above order[place]: midway between the centres on both sides, the bed's height
// for the first [m].
double cut_height(const Particles& bed, const std::vector<std::size_t>& order, std::size_t place,
                  const Vec3& floor) {
  if (place >= order.size()) return 0.0;
  if (place == 0) return bed_height(bed, floor);
  const double below = bed.position[order[place]].z() - floor.z();
  return 0.5 * (below + bed.position[order[place - 1]].z() - floor.z());
}

}  // namespace

std::optional<Sides> beads_and_granules(const Case& setup) {
  if (setup.species.size() < 2) return std::nullopt;
  Sides sides;
  for (const Species& species : setup.species)
    sides.push_back(setup.materials.list.at(species.material).redox ? Side::granules : Side::beads);
  if (std::adjacent_find(sides.begin(), sides.end(), std::not_equal_to<>()) != sides.end())
    return sides;
  std::fill(sides.begin(), sides.end(), Side::granules);
  sides.front() = Side::beads;
  return sides;
}

double Portion::mass_ratio() const {
  if (granule_mass > 0.0) return bead_mass / granule_mass;
  return bead_mass > 0.0 ? std::numeric_limits<double>::infinity() : nan;
}

BedSections decompose(const Particles& bed, const Decomposition& tool, const Sides& sides) {
  ensure(tool.sectors > 0, "the decomposition tool has sectors");
  const std::vector<std::size_t> order = from_the_top(bed);
  const std::vector<std::size_t> starts = layer_starts(bed, order, tool.layer_fraction);
  std::vector<Layer> layers(starts.size() - 1);
  for (std::size_t k = 0; k < layers.size(); ++k) {
    Layer& layer = layers[k];
    layer.sectors.resize(tool.sectors);
    layer.top = cut_height(bed, order, starts[k], tool.axis_point);
    const bool is_residuum = k + 1 == layers.size();
    layer.bottom = is_residuum ? 0.0 : cut_height(bed, order, starts[k + 1], tool.axis_point);
    layer.top = std::max(layer.top, layer.bottom);  // a first layer of less than 1 % of the mass
    for (std::size_t place = starts[k]; place < starts[k + 1]; ++place) {
      const std::size_t i = order[place];
      layer.mass += bed.mass[i];
      add(layer.content, bed, i, sides);
      add(layer.sectors[sector_of(bed.position[i], tool)], bed, i, sides);
    }
  }
  const Layer residuum = layers.back();
  layers.pop_back();
  return {std::move(layers), residuum};
}

double sector_azimuth(const Decomposition& tool, std::size_t sector) {
  return 2.0 * pi * static_cast<double>(sector) / tool.sectors;
}

}  // namespace pmr::instruments
