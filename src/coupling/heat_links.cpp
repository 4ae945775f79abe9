#include "coupling/heat_links.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "chemistry/gas.hpp"
#include "coupling/thermal_state.hpp"
#include "physics/conduction.hpp"
#include "physics/gap.hpp"
#include "physics/upright.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::coupling {
namespace {

// One side of a link.
struct Side {
  const Material* material;
  double radius;       // [m], physics::plane_wall for a wall
  double temperature;  // [K]
};

// Conductivity of the gas and its jump length at a surface of full accommodation, over temperature:
// the powers in them cost more than the gap itself. Linear between whole kelvins, within 3e-7.
class GasTable {
 public:
  explicit GasTable(const Atmosphere& gas) {
    const double x = gas.oxygen_fraction;
    for (double T = lowest; T <= highest; T += 1.0)
      at_.push_back(
          {chemistry::gas_conductivity(x, T), chemistry::jump_length(x, T, gas.pressure, 1.0)});
  }
  struct Point {
    double conductivity;  // [W/m/K]
    double jump;          // [m]
  };
  Point operator()(double T) const {
    const double place = std::clamp(T, lowest, highest) - lowest;
    const auto k = std::min(static_cast<std::size_t>(place), at_.size() - 2);
    const double part = place - static_cast<double>(k);
    const Point &a = at_[k], &b = at_[k + 1];
    return {a.conductivity + part * (b.conductivity - a.conductivity),
            a.jump + part * (b.jump - a.jump)};
  }

 private:
  static constexpr double lowest = 150.0, highest = 3000.0;  // [K]
  std::vector<Point> at_;
};

// The gas round a link.
struct Surroundings {
  Atmosphere gas;
  GasTable table;
};

// What all links of one moment share.
struct Context {
  const Case& setup;
  const ConductionModel& model;
  const Outlook& outlook;
  const PoreSpace& pores;
  std::vector<Surroundings> gas;  // by layer of pores; the chamber's alone where there are none

  const Surroundings& around(Node particle) const {
    return gas[pores.is_resolved() ? pores.layer_of[particle] : 0];
  }
};

Context context_of(const Case& c, const Outlook& outlook, const PoreSpace& pores) {
  Context context{c, *c.models.conduction, outlook, pores, {}};
  for (const Atmosphere& gas : outlook.pores) context.gas.push_back({gas, GasTable(gas)});
  if (!pores.is_resolved()) context.gas.assign(1, {outlook.gas, GasTable(outlook.gas)});
  return context;
}

// (2 - alpha)/alpha [1]: a jump length over that of full accommodation.
double accommodation_factor(const Side& side) {
  const double alpha = side.material->accommodation;
  return (2.0 - alpha) / alpha;
}

// A contact as though there were no gas beside it: none at all where contacts are off, or, to
// compare with, as other codes have it. No value: it is to be taken together with the gas.
std::optional<double> contact_alone(const ConductionModel& model, double k1, double k2,
                                    double reduced_radius, double overlap, double radius) {
  if (!model.contact) return 0.0;
  const bool is_liggghts = model.contact_law == ContactConduction::liggghts;
  const bool is_soft = model.contact_area == ContactArea::of_soft_contact;
  if (!is_liggghts && !is_soft) return std::nullopt;
  return (is_liggghts ? physics::liggghts_contact_factor : 1.0) *
         physics::contact_conductance(
             k1, k2, is_soft ? physics::contact_radius(reduced_radius, overlap, 1.0) : radius);
}

// Of the conductance across a gap [1].
double fade_of(const ConductionModel& model, double gap, double radius, bool to_wall) {
  if (gap <= 0.0) return 1.0;
  if (to_wall)
    return physics::gap_fade(gap / radius, physics::wall_fade_begin, physics::wall_fade_end);
  return physics::gap_fade(gap / radius, physics::pair_fade_begin * model.gap_reach,
                           physics::pair_fade_end * model.gap_reach);
}

// Conductances of a pair whose surfaces are `gap` [m] apart (negative: the soft overlap).
HeatLink link(const Context& context, const Surroundings& around, const Side& one, const Side& two,
              double gap) {
  const double pressure = around.gas.pressure;
  const double k1 = physics::conductivity(one.material->conductivity, one.temperature, pressure);
  const double k2 = physics::conductivity(two.material->conductivity, two.temperature, pressure);
  const bool to_wall = two.radius == physics::plane_wall;
  const double reduced = physics::reduced_radius(one.radius, two.radius);
  const double radius = physics::contact_radius(
      reduced, -gap, physics::contact_softening(*one.material, *two.material));
  const double soft = gap + one.radius + (to_wall ? 0.0 : two.radius);
  const physics::GapPair pair{one.radius, two.radius,
                              physics::true_distance(one.radius, two.radius, soft), radius,
                              context.model.bed_solid_fraction};
  physics::GapMedium medium{k1, k2, 0.0, 0.0};
  const bool has_gas = context.model.gap && pressure > 0.0;
  if (has_gas) {
    const auto between = around.table(0.5 * (one.temperature + two.temperature));
    medium.conductivity_gas = between.conductivity;
    medium.jump = between.jump * (accommodation_factor(one) + accommodation_factor(two));
  }
  const double fade = fade_of(context.model, gap, std::min(one.radius, two.radius), to_wall);
  const auto contact = contact_alone(context.model, k1, k2, reduced, -gap, radius);
  if (contact) return {0, 0, *contact, has_gas ? fade * physics::gap_conductance(pair, medium) : 0};
  if (!has_gas) return {0, 0, physics::spot_conductance(pair, medium), 0.0};
  const auto both = physics::pair_conductance(pair, medium);
  return {0, 0, both.contact, fade * both.gas};
}

Side side_of(const Context& context, const Particles& p, std::size_t i) {
  const Case& c = context.setup;
  return {&c.materials.list[c.species[p.species[i]].material], p.radius[i],
          context.outlook.temperature[i]};
}

// Links across the gaps of the bed, in their order.
std::vector<HeatLink> link_gaps(const Context& context, const Nodes& nodes, const State& state,
                                const Gaps& gaps) {
  const Case& c = context.setup;
  const Particles& p = state.particles;
  const auto faces = patch_temperatures(c, nodes, context.outlook.walls);
  const auto other_side = [&](const Gap& gap) {
    if (gap.b < nodes.solids()) return side_of(context, p, gap.other);
    const Surface& surface = c.walls.surfaces[nodes.patches[gap.other].surface];
    return Side{&c.materials.list[surface.material], physics::plane_wall, faces[gap.other]};
  };
  std::vector<HeatLink> links(gaps.all.size());
  parallel_for(links.size(), [&](std::size_t k) {
    const Gap& gap = gaps.all[k];
    links[k] = link(context, context.around(nodes.particle(p.id[gap.particle])),
                    side_of(context, p, gap.particle), other_side(gap), gap.width);
    links[k].contact *= gap.share;
    links[k].gap *= gap.share;
    links[k].a = gap.a;
    links[k].b = gap.b;
  });
  return links;
}

// From shell to shell: the outermost one's node lies on the surface, the others' in the middle of
// their volumes; between two radii a sphere conducts 4 pi k r1 r2/(r1 - r2).
void link_shells(const Context& context, const Nodes& nodes, const State& state,
                 std::vector<HeatLink>& links) {
  const Particles& p = state.particles;
  const auto parts = static_cast<double>(nodes.shells);
  const auto radius = [&](std::size_t k) {  // [1] of the particle's
    return k == 0 ? 1.0 : std::cbrt((parts - static_cast<double>(k) - 0.5) / parts);
  };
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double k_solid = physics::conductivity(
        side_of(context, p, i).material->conductivity, context.outlook.temperature[i],
        context.around(nodes.particle(p.id[i])).gas.pressure);
    for (std::size_t k = 0; k + 1 < nodes.shells; ++k) {
      const double outer = radius(k), inner = radius(k + 1);
      links.push_back({nodes.shell(p.id[i], k), nodes.shell(p.id[i], k + 1),
                       4.0 * pi * k_solid * p.radius[i] * outer * inner / (outer - inner), 0.0});
    }
  }
}

constexpr double bed_part = 0.99;  // [1] of the particles lie below the bed's top

// Height that `bed_part` of the centres do not rise above [m]: a grain stuck higher is no bed.
double top_of_bed(std::vector<double> heights) {
  const auto rank = static_cast<std::ptrdiff_t>(bed_part * static_cast<double>(heights.size() - 1));
  std::nth_element(heights.begin(), heights.begin() + rank, heights.end());
  return heights[static_cast<std::size_t>(rank)];
}

// Particles that meet the gas over the bed: those whose centres lie within one largest diameter of
// its top or above; all, where nothing pulls them into a bed.
std::vector<std::size_t> at_the_top(const Case& c, const Particles& p) {
  std::vector<std::size_t> found(p.size());
  std::iota(found.begin(), found.end(), std::size_t{0});
  const auto up = physics::up_against(c.gravity);
  if (!up) return found;
  std::vector<double> heights;
  for (const Vec3& x : p.position) heights.push_back(physics::is_z(*up) ? x.z() : x.dot(*up));
  const double largest = 2.0 * *std::max_element(p.radius.begin(), p.radius.end());
  const double top = top_of_bed(heights);
  std::erase_if(found, [&](std::size_t i) { return !(heights[i] > top - largest); });
  return found;
}

// A film of gas over the bed's top, each particle with its cross-section; and over the walls of the
// closed chamber.
void link_gas(const Case& c, const Nodes& nodes, const State& state, std::vector<HeatLink>& links) {
  const Particles& p = state.particles;
  if (!c.chamber || state.phase != Phase::react || p.size() == 0) return;
  const double film = c.chamber->film_coefficient;
  if (film <= 0.0) return;
  for (const std::size_t i : at_the_top(c, p))
    links.push_back(
        {nodes.particle(p.id[i]), nodes.gas(), 0.0, film * pi * p.radius[i] * p.radius[i]});
  if (!state.gas.closed) return;
  for (std::size_t k = 0; k < nodes.patches.size(); ++k) {
    const Surface& surface = c.walls.surfaces[nodes.patches[k].surface];
    if (is_present(surface, state.time) && !std::holds_alternative<Adiabatic>(surface.thermal))
      links.push_back({nodes.patch(k), nodes.gas(), 0.0, film * nodes.patches[k].area});
  }
}

}  // namespace

std::vector<HeatLink> conduct(const Case& c, const Nodes& nodes, const State& state,
                              const Gaps& gaps, const Outlook& outlook, const PoreSpace& pores) {
  std::vector<HeatLink> links, others;
  if (c.models.conduction) {
    const Context context = context_of(c, outlook, pores);
    links = link_gaps(context, nodes, state, gaps);
    link_shells(context, nodes, state, others);
  }
  link_gas(c, nodes, state, others);
  std::sort(others.begin(), others.end(), comes_before);
  const auto middle = static_cast<std::ptrdiff_t>(links.size());
  links.insert(links.end(), others.begin(), others.end());
  std::inplace_merge(links.begin(), links.begin() + middle, links.end(), comes_before);
  return links;
}

// Both halves of the matrix of links that stand in order of (a, b), a < b: each row's lower part
// comes in order of a, its upper part in order of b.
Csr symmetric_rows(const std::vector<HeatLink>& links, std::size_t nodes) {
  Csr csr;
  csr.start.assign(nodes + 1, 0);
  for (const HeatLink& link : links) {
    ++csr.start[link.a + 1];
    ++csr.start[link.b + 1];
  }
  for (std::size_t row = 0; row < nodes; ++row) csr.start[row + 1] += csr.start[row];
  csr.column.resize(2 * links.size());
  csr.value.resize(2 * links.size());
  std::vector<std::uint64_t> next(csr.start.begin(), csr.start.end() - 1);
  const auto put = [&](Node row, Node column, const HeatLink& link) {
    csr.column[next[row]] = column;
    csr.value[next[row]++] = link.contact + link.gap;
  };
  for (const HeatLink& link : links) put(link.b, link.a, link);
  for (const HeatLink& link : links) put(link.a, link.b, link);
  return csr;
}

}  // namespace pmr::coupling
