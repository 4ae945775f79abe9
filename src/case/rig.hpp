// The demonstrator's rig, parametric: chamber, spout, mixer with ramp, furnace tubes with valves.
// Frame: chamber floor z = 0, axis x = y = 0; the ramp comes down from +x.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "case/materials.hpp"
#include "case/polytope.hpp"
#include "case/walls.hpp"
#include "pmr/state/case.hpp"

namespace pmr::casefile {

// All lengths already multiplied by the rig's scale.
struct RigDimensions {
  double chamber_radius;     // [m]
  double lid_height;         // [m] of the flat lid round the spout
  double spout_width;        // [m] side of the square channel
  double spout_height;       // [m] from the lid up to the ramp's foot
  double ramp_angle;         // [rad] against the horizontal
  double back_wall;          // [m] x of the wall behind the ramp
  double far_wall_angle;     // [rad] of the wall opposite the ramp, at its foot
  double far_wall;           // [m] distance from the axis where it becomes vertical
  double side_wall_angle;    // [rad]
  double side_wall;          // [m] distance from y = 0 where the side walls become vertical
  double roof_height;        // [m] lower ends of the tubes
  double tube_radius;        // [m] inner
  double tube_length;        // [m]
  double rod_radius;         // [m]
  double plug_clearance;     // [m] tube radius less the plug's rim radius
  double plug_cone_height;   // [m]
  double plug_skirt;         // [m] height of the rim
  double plug_stroke;        // [m] fall of the valve until it is stopped
  double plug_acceleration;  // [m/s2]

  double foot() const { return lid_height + spout_height; }           // [m] z of the ramp's foot
  double tube_top() const { return roof_height + tube_length; }       // [m]
  double rim_radius() const { return tube_radius - plug_clearance; }  // [m]
  double chamber_volume() const;                                      // [m3]
};

struct Valve {
  std::string name;
  double x;                 // [m] of its tube's axis, y = 0
  double release;           // [s]
  ThermalBoundary thermal;  // of tube, rod and plug
};

struct Rig {
  RigDimensions size;
  std::vector<Valve> valves;
  std::uint32_t material;                // of every surface
  ThermalBoundary chamber, door, mixer;  // side and floor; door; lid, spout and mixer
  std::array<std::uint32_t, 2> side_patches, floor_patches, door_patches;
  double closing;  // [s] everything above the chamber leaves, the door comes; may be infinite
};

// Reads [rig]; none if the case has no rig or it is faulty.
std::optional<Rig> read_rig(Table& root, const WallSetting& setting, double closing);

// Appends its bodies and surfaces.
void build_rig(const Rig& rig, Walls& walls);

// Inward faces of the mixer with its roof; the spout's top is left open.
std::vector<Polygon> mixer_faces(const RigDimensions& size);

// What a charge may fill above the closed plug of a valve.
CylinderRegion tube_region(const RigDimensions& size, const Valve& valve);

// Corners of the domain: the rig's bounding box, a tenth of its size wider on each side [m].
std::pair<Vec3, Vec3> rig_domain(const RigDimensions& size);

// Half side of the square that a tube's hole takes from the roof [m].
double roof_cell(const RigDimensions& size);

}  // namespace pmr::casefile
