// Rolling: spheres on a wall under both rolling laws, against LIGGGHTS and closed forms.
#include <cmath>
#include <string>

#include "pmr/base/constants.hpp"
#include "verify/mechanics_collisions.hpp"
#include "verify/mechanics_scenes.hpp"

namespace pmr::verify {
namespace {

constexpr const char* liggghts_cdt = "LIGGGHTS 3.8.0 (Debian), hertz + tangential history + cdt";

// --- Rolling and sliding on the coated wall from 0.2 m/s, dt 2e-5 s, starting at the overlap that
// carries the weight. LIGGGHTS winds the rolling spring in its set-up already, which saves it half
// a step of a rolling sphere's way (2e-6 m).
struct Ride {
  SpeciesIndex species;
  bool rolls_at_start;
  double rolling_friction;  // [1]
  double duration;          // [s]
  RollingLaw law = Epsd2{};
};
struct Ridden {
  double way, speed, spin;  // [m], [m/s], [rad/s]
};

Ridden ride(const Ride& t) {
  constexpr double dt = 2e-5, speed = 0.2;
  Case c = study_case(dt);
  add_floor(c);
  c.gravity = Vec3(0, 0, -9.81);
  c.models.mechanics.contact.rolling = t.law;
  for (PairContact& pair : c.materials.pairs) pair.rolling_friction = t.rolling_friction;
  const double r = radius_of(t.species);
  const double overlap = t.species == bead ? 2.33901536e-06 : 6.86240703e-07;
  const double spin = t.rolls_at_start ? speed / (r - 0.5 * overlap) : 0.0;
  add_particle(c, t.species, Vec3(0, 0, r - overlap), Vec3(speed, 0, 0), Vec3(0, spin, 0));
  Scene scene(c);
  scene.advance(static_cast<std::uint64_t>(std::lround(t.duration / dt)));
  const Particles& p = scene.state.particles;
  return {p.position[0][0], p.velocity[0][0], p.spin[0][1]};
}

void check_rides(std::vector<Check>& checks) {
  const std::string source = std::string(liggghts) + ", dt 2e-5; 0.1 %";
  const auto add = [&](const char* id, const char* what, double measured, double expected,
                       const char* unit) {
    checks.push_back({id, what, measured, expected, 1e-3 * expected, unit, source});
  };
  const Ridden bead_rolls = ride({bead, true, 0.14, 0.5});
  const Ridden granule_rolls = ride({granule, true, 0.14, 0.5});
  const Ridden bead_slides = ride({bead, false, 0.0, 0.4});
  const Ridden granule_slides = ride({granule, false, 0.0, 0.4});
  const Ridden bead_brakes = ride({bead, false, 0.14, 0.4});
  constexpr const char* stop = "Way of a rolling sphere until it stops";
  constexpr const char* slide = "A sphere that starts sliding: after 0.4 s";
  add("mechanics.roll.bead.way", stop, bead_rolls.way, 0.0203801284, "m");
  add("mechanics.roll.granule.way", stop, granule_rolls.way, 0.0203831648, "m");
  add("mechanics.slide.bead.way", slide, bead_slides.way, 0.0575524341508, "m");
  add("mechanics.slide.bead.speed", slide, bead_slides.speed, 0.142793236904, "m/s");
  add("mechanics.slide.bead.spin", slide, bead_slides.spin, 95.5886478674, "rad/s");
  add("mechanics.slide.granule.way", slide, granule_slides.way, 0.0575048071798, "m");
  add("mechanics.slide.granule.speed", slide, granule_slides.speed, 0.142819017728, "m/s");
  add("mechanics.slide.granule.spin", slide, granule_slides.spin, 194.40234167, "rad/s");
  add("mechanics.slide_and_brake.bead.way", slide, bead_brakes.way, 0.0109947650095, "m");

  // v^2 / (2 5/7 mu_r g); lever arms R - d/2 and the spring's wind-up cost less than 0.2 %.
  const double way = 0.2 * 0.2 / (2.0 * 5.0 / 7.0 * 0.14 * 9.81);
  checks.push_back({"mechanics.roll.closed_form", stop, bead_rolls.way, way, 2e-3 * way, "m",
                    "closed form: deceleration 5/7 mu_r g; overlap over radius 0.16 %"});
  checks.push_back({"mechanics.slide.closed_form", "A sliding sphere ends rolling at 5/7 of v0",
                    bead_slides.speed, 5.0 / 7.0 * 0.2, 2e-3 * 5.0 / 7.0 * 0.2, "m/s",
                    "closed form, conservation of angular momentum; overlap over radius 0.16 %"});
}

// --- Directional torque instead of the rolling spring. Rolling as above, 0.1 s after the start;
// and a bead and a granule that meet with spins about all axes, which the torque turns.
void check_directional_rides(std::vector<Check>& checks) {
  struct Row {
    const char* id;
    SpeciesIndex species;
    double way, speed, spin;  // [m], [m/s], [rad/s] by LIGGGHTS
  };
  for (const Row& row :
       {Row{"bead", bead, 0.01509341002269, 0.1018671168869, 68.19188482943},
        Row{"granule", granule, 0.01509403465108, 0.1018803753017, 138.6774943841}}) {
    const Ridden ridden = ride({row.species, true, 0.14, 0.1, Cdt{}});
    const std::string id = std::string("mechanics.cdt.roll.") + row.id;
    const auto add = [&](const char* part, const char* unit, double measured, double expected) {
      checks.push_back({id + part, "A rolling sphere under the directional torque, after 0.1 s",
                        measured, expected, 1e-6 * expected, unit,
                        std::string(liggghts_cdt) + ", dt 2e-5; 1e-6"});
    };
    add(".way", "m", ridden.way, row.way);
    add(".speed", "m/s", ridden.speed, row.speed);
    add(".spin", "rad/s", ridden.spin, row.spin);
  }
}

void check_directional_collision(std::vector<Check>& checks) {
  constexpr double dt = 1e-6;
  Case c = study_case(dt);
  c.models.mechanics.contact.rolling = Cdt{};
  add_particle(c, bead, Vec3(-radius_of(bead) - 0.5 * start_gap, 0, 0), Vec3(0.3, 0, 0),
               Vec3(150, 60, -40));
  add_particle(c, granule, Vec3(radius_of(granule) + 0.5 * start_gap, 0, 0), Vec3(-0.3, 0.2, 0),
               Vec3(-80, 120, 300));
  Scene scene(c);
  watch_collision(scene, dt, 6000);
  // velocities and spins by LIGGGHTS
  const Vec3 velocity[] = {{0.2083391178186, 0.004341795623528, 0.006245455331386},
                           {0.522613553725, 0.1610344146552, -0.05605004100456}};
  const Vec3 spin[] = {{150.0700066167, 48.44769294763, -26.18213192819},
                       {-80.72003917559, -4.455885317541, 261.5200963743}};
  const Particles& p = scene.state.particles;
  double velocity_off = 0.0, spin_off = 0.0;
  for (const ParticleId k : {0U, 1U}) {
    const std::size_t i = scene.place_of(k);
    velocity_off = std::max(velocity_off, (p.velocity[i] - velocity[k]).norm());
    spin_off = std::max(spin_off, (p.spin[i] - spin[k]).norm());
  }
  const std::string source = std::string(liggghts_cdt) + ", dt 1e-6; ";
  checks.push_back({"mechanics.cdt.collision.velocity",
                    "Bead and granule with spins about all axes: deviation of the velocities",
                    velocity_off, 0.0, 1e-6, "m/s", source + "2e-6 of the largest"});
  checks.push_back({"mechanics.cdt.collision.spin", "Deviation of the spins", spin_off, 0.0, 3e-4,
                    "rad/s", source + "1e-6 of the largest"});
}

}  // namespace

void add_rolling_checks(std::vector<Check>& checks) {
  check_rides(checks);
  check_directional_rides(checks);
  check_directional_collision(checks);
}

}  // namespace pmr::verify
