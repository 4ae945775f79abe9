// Openings that catch, forces on walls and adhered grains in whole runs.
#include <catch2/catch.hpp>
#include <cmath>

#include "instruments/catching.hpp"
#include "io/run_file.hpp"
#include "sim/ledger.hpp"
#include "small_runs.hpp"

using namespace pmr;
using namespace pmr::test;

namespace {

constexpr double speed = 2.41;  // [m/s]

// A bead that falls onto the middle of a plate at 45 degrees, and an opening 120 mm below.
std::string plate_case(double restitution) {
  const double touch = 0.5 * 2.99 / std::sqrt(2.0);  // [mm] of the centre from the axes
  const std::string at = std::to_string(touch);
  return R"(title = "plate"
gravity = "0 0 -9.80665 m/s2"
[domain]
low = "-1 -1 -0.2 m"
high = "1 1 1 m"
[species.bead]
material = "Al2O3"
diameter = "2.99 mm"
[[particles]]
species = "bead"
position = ")" +
         at + " 0 " + std::to_string(touch + 0.05) + R"( mm"
velocity = "0 0 -2.41 m/s"
[walls.plate]
kind = "rectangle"
material = "coated-wall"
corner = "-28.2843 -40 28.2843 mm"
along = "56.5685 0 -56.5685 mm"
across = "0 80 0 mm"
[contacts."Al2O3|coated-wall"]
restitution = )" +
         std::to_string(restitution) + R"(
[catch.below]
corner = "-500 -500 -120 mm"
along = "1000 0 0 mm"
across = "0 1000 0 mm"
threshold = "40 mg"
ends_motion = true
[mix]
duration = "1 s"
heat_interval = "4 ms"
[models.mechanics]
time_step = "20 us"
)";
}

// Beads and granules that fall through a funnel's mouth onto a rough plate that shakes.
const std::string shaken = R"(title = "shaken"
gravity = "0 0 -9.80665 m/s2"
[domain]
low = "-50 -50 -30 mm"
high = "50 50 100 mm"
[species.bead]
material = "Al2O3"
diameter = "2.99 mm"
count = 40
region = {base = "0 0 6 mm", radius = "12 mm", height = "30 mm"}
[walls.plate]
kind = "disc"
material = "coated-wall"
centre = "0 0 0 mm"
axis = [0, 0, 1]
radius = "12 mm"
motion = {kind = "oscillate", amplitude = "2 0 0 mm", frequency = "20 Hz", begin = "0 s"}
grains = {material = "SrFeO3", diameter = "1.47 mm", area_fraction = 0.75, height_deviation = 0.05}
[catch.out]
corner = "-50 -50 -10 mm"
along = "100 0 0 mm"
across = "0 100 0 mm"
[wall_force.plate]
[mix]
duration = "0.4 s"
heat_interval = "5 ms"
[models.mechanics]
time_step = "20 us"
[output]
snapshot_interval = "100 ms"
)";

}  // namespace

// Ballistics of a sphere that leaves without slip (v_t 5/7 of what it was): v_x = v (5/7 + e)/2,
// v_z = v (e - 5/7)/2, then a fall of 120 mm, from where the centre is as it touches: 195, 266 mm.
TEST_CASE("A bead lands off the impact plate where its restitution says") {
  for (const auto& [e, expected] : {std::pair{0.5, 0.195}, {0.7, 0.266}}) {
    const double across = speed * (5.0 / 7.0 + e) / 2.0, up = speed * (e - 5.0 / 7.0) / 2.0;
    const double touch = 0.5 * 2.99e-3 / std::sqrt(2.0);  // [m]
    const double fall = (up + std::sqrt(up * up + 2.0 * 9.80665 * (0.12 + touch))) / 9.80665;
    REQUIRE(touch + across * fall == Approx(expected).epsilon(0.005));
    const Ended ended = run_to_end(load(plate_case(e)), "plate");
    REQUIRE(ended.state.caught.size() == 1);
    CHECK(ended.state.caught[0].position.x() == Approx(expected).epsilon(0.04));
    CHECK(ended.state.caught[0].position.z() == Approx(-0.12).epsilon(1e-9));
    CHECK(ended.state.lost.empty());
    CHECK(ended.state.particles.size() == 0);
    CHECK(ended.state.time < 0.3);  // the opening ended the motion
    const auto& caught = ended.summary["catch"]["below"];
    CHECK(caught["mass"].get<double>() == Approx(51.65e-6).epsilon(1e-3));
    CHECK(caught["masses"]["bead"] == caught["mass"]);
    CHECK(caught["time_to_threshold"].get<double>() <= ended.state.time);
    CHECK(ended.summary["books"]["particles"]["caught"] == 1);
  }
}

TEST_CASE("A shaken rough plate: the same bits after a stop, all booked, its force on record") {
  const Case c = load(shaken);
  const Ended whole = run_to_end(c, "shaken");
  REQUIRE(whole.state.caught.size() > 3);
  REQUIRE(whole.state.particles.size() > 3);
  const sim::Balance balance = sim::close_books(c, whole.state);
  CHECK(balance.inserted == balance.alive + balance.caught);
  CHECK(balance.closes());
  for (const std::uint64_t stop_after : {20U, 50U}) {
    const Folder folder("stopped");
    {
      std::atomic<bool> stop{false};
      sim::Simulation first(c, folder.path);
      first.run(stop,
                [&](const sim::Simulation& now) { stop = now.state().interval >= stop_after; });
    }
    State state = io::load_checkpoint(folder.path);
    CHECK(state.caught.size() < whole.state.caught.size());
    const std::atomic<bool> never{false};
    sim::Simulation second(c, folder.path, std::move(state));
    REQUIRE(second.run(never, [](const auto&) {}) == sim::Ending::completed);
    CHECK(io::state_hash(second.state()) == io::state_hash(whole.state));
    const io::Snapshot last =
        io::read_snapshot(folder.path, io::snapshot_times(folder.path).size() - 1);
    CHECK(last.adhered.size() == c.walls.grains.size());
  }
  const auto& mass = whole.series.values("catch.out");
  CHECK(std::is_sorted(mass.begin(), mass.end()));
  CHECK(mass.back() == Approx(whole.summary["catch"]["out"]["mass"].get<double>()));
  // from 0.1 s on the plate bears what lies on it, less than all
  const auto& force = whole.series.values("wall_force.plate.z");
  CHECK(std::isnan(force.front()));
  const double weight = 40 * 51.65e-6 * 9.80665;
  double mean = 0.0;
  for (std::size_t k = force.size() - 20; k < force.size(); ++k) mean += force[k] / 20.0;
  CHECK(mean < 0.0);
  CHECK(mean > -weight);
  CHECK(whole.summary["wall_force"]["plate"]["largest_force"].get<double>() > -mean);
}
