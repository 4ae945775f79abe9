#include "physics/motion.hpp"

#include <algorithm>
#include <cmath>

#include "pmr/base/constants.hpp"

namespace pmr::physics {
namespace {

Pose shifted(const Vec3& translation, const Vec3& velocity) {
  Pose p;
  p.translation = translation;
  p.velocity = velocity;
  return p;
}

Pose at(const Rest&, double) { return {}; }

Pose at(const Fall& m, double t) {
  const double fallen = std::max(0.0, t - m.release);
  const double way = 0.5 * m.acceleration * fallen * fallen;
  if (way >= m.stroke) return shifted(m.stroke * m.direction, Vec3::Zero());
  return shifted(way * m.direction, m.acceleration * fallen * m.direction);
}

Pose at(const Translate& m, double t) {
  const double moved = std::clamp(t, m.begin, m.finish) - m.begin;
  const bool is_moving = m.begin <= t && t < m.finish;
  return shifted(moved * m.velocity, is_moving ? m.velocity : Vec3(Vec3::Zero()));
}

Pose at(const Oscillate& m, double t) {
  if (t < m.begin) return {};
  const double omega = 2.0 * pi * m.frequency;
  const double phase = omega * (t - m.begin);
  return shifted(std::sin(phase) * m.amplitude, omega * std::cos(phase) * m.amplitude);
}

Pose at(const Rotate& m, double t) {
  const double angle = m.rate * (std::clamp(t, m.begin, m.finish) - m.begin);
  Pose p;
  p.is_turned = angle != 0.0;
  p.rotation = Eigen::AngleAxisd(angle, m.axis).toRotationMatrix();
  p.translation = m.pivot - p.rotation * m.pivot;
  p.pivot = m.pivot;
  if (m.begin <= t && t < m.finish) p.spin = m.rate * m.axis;
  return p;
}

// Farthest corner of the box from the axis of rotation [m].
double farthest(const Rotate& m, const Box& box) {
  double reach = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 x;
    for (int k = 0; k < 3; ++k) x[k] = (corner >> k) & 1 ? box.high[k] : box.low[k];
    reach = std::max(reach, (x - m.pivot).cross(m.axis).norm());
  }
  return reach;
}

}  // namespace

Pose pose(const Motion& motion, double t) {
  return std::visit([&](const auto& m) { return at(m, t); }, motion);
}

double displacement_bound(const Motion& motion, double t0, double t1, const Box& domain) {
  if (std::holds_alternative<Rest>(motion)) return 0.0;
  if (const auto* m = std::get_if<Oscillate>(&motion))
    return m->amplitude.norm() * std::min(2.0, 2.0 * pi * m->frequency * (t1 - t0));
  if (const auto* m = std::get_if<Rotate>(&motion)) {
    const double turned = std::clamp(t1, m->begin, m->finish) - std::clamp(t0, m->begin, m->finish);
    return std::abs(m->rate * turned) * farthest(*m, domain);
  }
  return (pose(motion, t1).translation - pose(motion, t0).translation).norm();  // one way
}

}  // namespace pmr::physics
