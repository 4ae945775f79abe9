#include "verify/mechanics_collisions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "physics/time_step.hpp"
#include "pmr/base/constants.hpp"
#include "verify/mechanics_scenes.hpp"

namespace pmr::verify {
namespace {

// --- Head on, each sphere at half the relative speed.
struct HeadOn {
  const char* id;
  SpeciesIndex species;
  double speed, time_step;      // [m/s], [s]
  double restitution, overlap;  // [1], [m] by LIGGGHTS
};
constexpr std::array head_on{
    HeadOn{"beads.0.1", bead, 0.1, 1e-6, 0.749993999, 2.27084513e-05},
    HeadOn{"granules.0.1", granule, 0.1, 1e-6, 0.239568304, 7.99134716e-06},
    HeadOn{"beads.1.0", bead, 1.0, 1e-6, 0.750002831, 0.000143272904},
    HeadOn{"granules.1.0", granule, 1.0, 1e-6, 0.239465789, 5.03931621e-05},
    HeadOn{"beads.1.0.long_step", bead, 1.0, 2e-5, 0.751324897, 0.000143173697},
    HeadOn{"granules.1.0.long_step", granule, 1.0, 2e-5, 0.233177906, 4.96484919e-05}};

void check_head_on(const HeadOn& t, std::vector<Check>& checks) {
  Case c = study_case(t.time_step);
  const double x = radius_of(t.species) + 0.5 * start_gap;
  add_particle(c, t.species, Vec3(-x, 0, 0), Vec3(0.5 * t.speed, 0, 0));
  add_particle(c, t.species, Vec3(x, 0, 0), Vec3(-0.5 * t.speed, 0, 0));
  Scene scene(c);
  watch_collision(scene, t.time_step, 5000);
  const Particles& p = scene.state.particles;
  const double apart = (p.velocity[scene.place_of(1)] - p.velocity[scene.place_of(0)])[0];
  const std::string id = std::string("mechanics.head_on.") + t.id;
  checks.push_back({id + ".restitution", "Restitution of two equal spheres, head on",
                    apart / t.speed, t.restitution, 1e-3 * t.restitution, "1",
                    std::string(liggghts) + "; 0.1 %"});
  checks.push_back({id + ".overlap", "Largest overlap of two equal spheres, head on",
                    scene.state.extremes.overlap_ratio * radius_of(t.species), t.overlap,
                    1e-3 * t.overlap, "m", std::string(liggghts) + "; 0.1 %"});
}

// --- Oblique on the coated wall at 1 m/s, angle from the normal.
struct Oblique {
  const char* id;
  SpeciesIndex species;
  double angle;           // [deg]
  double vx, vz, spin_y;  // [m/s], [m/s], [rad/s] by LIGGGHTS
};
constexpr std::array oblique{
    Oblique{"bead.10", bead, 10.0, 0.0127055969796, 0.49241593455, 13.7233801461},
    Oblique{"bead.45", bead, 45.0, 0.389110164052, 0.353494854401, 280.806641176},
    Oblique{"bead.80", bead, 80.0, 0.875788311019, 0.0868156718288, 122.092241533},
    Oblique{"granule.10", granule, 10.0, 0.0151900052195, 0.472488099883, 27.0329097535},
    Oblique{"granule.45", granule, 45.0, 0.392931257688, 0.339435019858, 562.944170223},
    Oblique{"granule.80", granule, 80.0, 0.867392481518, 0.0833469641973, 276.939661272}};

void check_oblique(const Oblique& t, std::vector<Check>& checks) {
  constexpr double dt = 1e-6;
  Case c = study_case(dt);
  add_floor(c);
  const double angle = t.angle * pi / 180.0;
  add_particle(c, t.species, Vec3(0, 0, radius_of(t.species) + start_gap),
               Vec3(std::sin(angle), 0, -std::cos(angle)));
  Scene scene(c);
  watch_collision(scene, dt, 5000);
  const Particles& p = scene.state.particles;
  const std::string id = std::string("mechanics.oblique.") + t.id;
  const std::string source = std::string(liggghts) + "; 0.5 %";
  const auto add = [&](const char* part, const char* unit, double measured, double expected) {
    checks.push_back({id + part, "Rebound of a sphere from the coated wall at 1 m/s", measured,
                      expected, 5e-3 * std::abs(expected), unit, source});
  };
  add(".vx", "m/s", p.velocity[0][0], t.vx);
  add(".vz", "m/s", p.velocity[0][2], t.vz);
  add(".spin", "rad/s", p.spin[0][1], t.spin_y);
}

// --- Chung & Ooi, Granular Matter 13 (2011) 643.
void check_peak(const char* id, const char* what, const physics::HertzPair& pair, double speed,
                Scene& scene, double dt, std::vector<Check>& checks) {
  const Collision seen = watch_collision(scene, dt, 100000);
  const double force = physics::hertz_peak_force(pair, speed);
  const double time = physics::hertz_contact_time(pair, speed);
  const std::string source = "Chung & Ooi (2011), closed form of Hertz; ";
  checks.push_back({std::string(id) + ".force", what, seen.peak_force, force, 1e-4 * force, "N",
                    source + "sampling of the peak"});
  checks.push_back({std::string(id) + ".time", what, seen.duration, time, 3.0 * dt, "s",
                    source + "three steps"});
}

void check_spheres_and_plane(std::vector<Check>& checks) {
  constexpr double rigid = 1e25;  // [Pa]
  const double glass_mass = 2800.0 * 4.0 / 3.0 * pi * 1e-6;
  const double glass_young = 0.5 * 48e9 / (1.0 - 0.2 * 0.2);
  Case two = one_material_case({0.01, 48e9, 0.2, 2800.0, rigid, {0.35, 0.0, 1.0}}, 2e-8);
  add_particle(two, 0, Vec3(-0.01 - 0.5 * start_gap, 0, 0), Vec3(10, 0, 0));
  add_particle(two, 0, Vec3(0.01 + 0.5 * start_gap, 0, 0), Vec3(-10, 0, 0));
  Scene glass(two);
  check_peak("mechanics.chung_ooi.1", "Two glass spheres head on at 10 m/s each",
             {0.5 * glass_mass, 0.005, glass_young}, 20.0, glass, 2e-8, checks);

  const double metal_mass = 2699.0 * 4.0 / 3.0 * pi * 1e-3;
  Case plane = one_material_case({0.1, 70e9, 0.3, 2699.0, rigid, {0.0, 0.0, 1.0}}, 2e-7);
  add_floor(plane);
  add_particle(plane, 0, Vec3(0, 0, 0.1 + start_gap), Vec3(0, 0, -0.2));
  Scene metal(plane);
  check_peak("mechanics.chung_ooi.2", "An aluminium sphere on a rigid plane at 0.2 m/s",
             {metal_mass, 0.1, 70e9 / (1.0 - 0.09)}, 0.2, metal, 2e-7, checks);
}

// Sphere on a rigid wall at 3.9 m/s; returns velocity and spin after the contact.
struct Rebound {
  Vec3 velocity, spin;  // [m/s], [rad/s]
};
Rebound rebound(const PairContact& contact, double angle_degrees) {
  constexpr double dt = 1e-8, speed = 3.9, r = 2.5e-3;
  Case c = one_material_case({r, 380e9, 0.23, 4000.0, 1e25, contact}, dt);
  add_floor(c);
  const double angle = angle_degrees * pi / 180.0;
  add_particle(c, 0, Vec3(0, 0, r + 1e-10), speed * Vec3(std::sin(angle), 0, -std::cos(angle)));
  Scene scene(c);
  watch_collision(scene, dt, 10000);
  return {scene.state.particles.velocity[0], scene.state.particles.spin[0]};
}

void check_restitution(std::vector<Check>& checks) {
  for (const double e : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
    char id[64];
    std::snprintf(id, sizeof id, "mechanics.chung_ooi.3.e%.1f", e);
    checks.push_back({id, "Restitution out equals restitution in, sphere on a rigid wall",
                      rebound({0.0, 0.0, e}, 0.0).velocity[2] / 3.9, e, 1e-3, "1",
                      "Chung & Ooi (2011) test 3; the law's attractive tail costs up to 1e-3"});
  }
}

// Test 4: spins and rebound angles of the contact point, over the angle of incidence [deg].
void check_incidence(std::vector<Check>& checks) {
  struct Row {
    double incidence, spin, angle;  // [deg], [rad/s], [deg]
  };
  constexpr std::array rows{
      Row{5, -19.27, 3.761},    Row{10, -213.00, -1.556}, Row{15, -377.83, -5.544},
      Row{20, -510.55, -7.538}, Row{25, -599.39, -7.538}, Row{30, -616.51, -3.550},
      Row{40, -544.80, 11.571}, Row{50, -457.03, 29.350}, Row{60, -357.49, 47.795},
      Row{70, -246.18, 64.577}, Row{80, -126.30, 78.701}};
  double spin_off = 0.0, angle_off = 0.0;
  for (const Row& row : rows) {
    const Rebound out = rebound({0.092, 0.0, 0.98}, row.incidence);
    const double surface = out.velocity[0] - 2.5e-3 * out.spin[1];
    const double angle = std::atan2(surface, out.velocity[2]) * 180.0 / pi;
    spin_off = std::max(spin_off, std::abs(out.spin[1] + row.spin));
    angle_off = std::max(angle_off, std::abs(angle - row.angle));
  }
  const std::string source = "Chung & Ooi (2011) test 4, curves as read off by the Kratos project;";
  checks.push_back({"mechanics.chung_ooi.4.spin", "Largest deviation of the spin, 5 to 80 degrees",
                    spin_off, 0.0, 0.05 * 616.51, "rad/s", source + " 5 % of the largest"});
  checks.push_back({"mechanics.chung_ooi.4.angle", "Largest deviation of the rebound angle",
                    angle_off, 0.0, 2.5, "deg", source + " 2.5 degrees"});
}

}  // namespace

void add_liggghts_checks(std::vector<Check>& checks) {
  for (const HeadOn& t : head_on) check_head_on(t, checks);
  for (const Oblique& t : oblique) check_oblique(t, checks);
}

void add_chung_ooi_checks(std::vector<Check>& checks) {
  check_spheres_and_plane(checks);
  check_restitution(checks);
  check_incidence(checks);
}

}  // namespace pmr::verify
