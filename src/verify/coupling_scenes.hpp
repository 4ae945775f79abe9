// Small thermal scenes: a few particles at rest, plates or a box of given temperature.
#pragma once
#include "coupling/network.hpp"
#include "coupling/nodes.hpp"
#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"
#include "verify/reference_materials.hpp"

namespace pmr::verify {

// One species, one material, no models but the network's tolerances.
Case inert_case(Material material, double radius);
// One species of SrFeO3-d that reacts.
Case redox_case(double radius);

struct ThermalScene {
  explicit ThermalScene(Case c) : setup(std::move(c)) {}
  ThermalScene(const ThermalScene&) = delete;
  ThermalScene& operator=(const ThermalScene&) = delete;

  void add(const Vec3& position, double temperature);  // [m], [K]; before begin()
  void add_plate(double temperature);                  // [K] a wall far away, for links by hand
  void add_box(const Vec3& low, const Vec3& high, double temperature);  // facing inwards
  void begin();  // numbers the nodes, fills the state
  void advance(double dt, std::vector<coupling::HeatLink> links);  // [s]

  Case setup;
  coupling::Nodes nodes;
  State state;
};

}  // namespace pmr::verify
