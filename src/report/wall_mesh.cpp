#include "report/wall_mesh.hpp"

#include "coupling/tessellate.hpp"
#include "physics/motion.hpp"

namespace pmr::report {

std::vector<radiation::Triangle> wall_mesh(const std::optional<Case>& setup, double t) {
  std::vector<radiation::Triangle> mesh;
  if (!setup) return mesh;
  const Case& c = *setup;
  for (std::size_t s = 0; s < c.walls.surfaces.size(); ++s) {
    const Surface& surface = c.walls.surfaces[s];
    if (!is_present(surface, t) || !surface.holds_particles) continue;
    const physics::Pose pose = physics::pose(c.walls.bodies[surface.body].motion, t);
    for (const auto& flat : coupling::tessellate(surface, c.domain_low, c.domain_high, 120)) {
      radiation::Triangle triangle{flat.corner, static_cast<std::uint32_t>(s)};
      for (Vec3& corner : triangle.corner) corner = pose.to_world(corner);
      mesh.push_back(triangle);
    }
  }
  return mesh;
}

}  // namespace pmr::report
