#include "radiation/scene.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "pmr/base/errors.hpp"
#include "pmr/base/parallel.hpp"
#include "radiation/geometry.hpp"

namespace pmr::radiation {
namespace {

using Bounds = Eigen::AlignedBox3d;

Bounds bounds_of(const std::vector<Sphere>& spheres, const std::vector<Triangle>& triangles) {
  Bounds box;
  for (const Sphere& s : spheres) {
    box.extend(Vec3(s.centre.array() - s.radius));
    box.extend(Vec3(s.centre.array() + s.radius));
  }
  for (const Triangle& t : triangles)
    for (const Vec3& corner : t.corner) box.extend(corner);
  return box;
}

double unit_of(const std::vector<Sphere>& spheres, const Bounds& box) {
  double sum = 0.0;  // [m]
  for (const Sphere& s : spheres) sum += 2.0 * s.radius;
  if (!spheres.empty()) return sum / static_cast<double>(spheres.size());
  const double extent = box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
  return extent > 0.0 ? extent : 1.0;
}

}  // namespace

struct Scene::Tree {
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = rtcNewScene(device);
  Eigen::Index triangle_geometry = -1;  // Embree's number of the geometry that holds triangles

  Tree() = default;
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;
  ~Tree() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  float* add(RTCGeometry geometry, RTCFormat format, std::size_t stride, std::size_t vertices) {
    return static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, format,
                                                       stride * sizeof(float), vertices));
  }
  unsigned attach(RTCGeometry geometry) {
    rtcCommitGeometry(geometry);
    const unsigned id = rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);  // the scene keeps it
    return id;
  }
  void check(const char* stage) const {
    const RTCError error = rtcGetDeviceError(device);
    if (error != RTC_ERROR_NONE)
      throw NumericsError(std::string("ray tracing: Embree failed to ") + stage + ", error " +
                          std::to_string(static_cast<int>(error)));
  }
};

Scene::Scene(std::span<const Sphere> spheres, std::span<const Triangle> triangles)
    : spheres_(spheres.begin(), spheres.end()),
      triangles_(triangles.begin(), triangles.end()),
      tree_(std::make_unique<Tree>()) {
  ensure(primitives() < none, "fewer than 2^32 - 1 spheres and triangles");
  const Bounds box = bounds_of(spheres_, triangles_);
  if (!box.isEmpty()) middle_ = box.center();
  unit_ = unit_of(spheres_, box);
  const auto scaled = [&](const Vec3& point) -> Eigen::Vector3f {
    return ((point - middle_) / unit_).cast<float>();
  };
  tree_->check("start");
  rtcSetSceneFlags(tree_->scene, RTC_SCENE_FLAG_ROBUST);  // no leaks along shared edges
  if (!spheres_.empty()) {
    const RTCGeometry geometry = rtcNewGeometry(tree_->device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    float* at = tree_->add(geometry, RTC_FORMAT_FLOAT4, 4, spheres_.size());
    for (const Sphere& s : spheres_) {
      const Eigen::Vector3f centre = scaled(s.centre);
      at = std::copy_n(centre.data(), 3, at);
      *at++ = static_cast<float>(s.radius / unit_);
    }
    tree_->attach(geometry);
  }
  if (!triangles_.empty()) {
    const RTCGeometry geometry = rtcNewGeometry(tree_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    float* at = tree_->add(geometry, RTC_FORMAT_FLOAT3, 3, 3 * triangles_.size());
    for (const Triangle& t : triangles_)
      for (const Vec3& corner : t.corner) {
        const Eigen::Vector3f vertex = scaled(corner);
        at = std::copy_n(vertex.data(), 3, at);
      }
    auto* index = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), triangles_.size()));
    for (unsigned k = 0; k < 3 * triangles_.size(); ++k) index[k] = k;
    tree_->triangle_geometry = tree_->attach(geometry);
  }
  const ThreadLimit one_thread(1);
  rtcCommitScene(tree_->scene);
  tree_->check("build the search tree");
}

Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

Hit Scene::nearest(const Ray& ray, std::uint32_t excluded) const {
  const Vec3 origin = (ray.origin - middle_) / unit_;
  RTCRayHit query;
  query.ray.org_x = static_cast<float>(origin.x());
  query.ray.org_y = static_cast<float>(origin.y());
  query.ray.org_z = static_cast<float>(origin.z());
  query.ray.dir_x = static_cast<float>(ray.direction.x());
  query.ray.dir_y = static_cast<float>(ray.direction.y());
  query.ray.dir_z = static_cast<float>(ray.direction.z());
  query.ray.tnear = static_cast<float>(ray.from / unit_);
  query.ray.time = 0.0F;
  query.ray.mask = ~0U;
  query.ray.flags = 0;
  const auto triangle_geometry = static_cast<unsigned>(tree_->triangle_geometry);
  std::uint32_t met = none;
  do {  // the excluded one can only be met by rounding: go on behind it
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    query.ray.tfar = std::numeric_limits<float>::infinity();
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(tree_->scene, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    met = query.hit.primID;
    if (query.hit.geomID == triangle_geometry) met += static_cast<std::uint32_t>(spheres_.size());
    query.ray.tnear = std::nextafter(query.ray.tfar, std::numeric_limits<float>::infinity());
  } while (met == excluded);
  return hit_at(met, static_cast<double>(query.ray.tfar) * unit_, ray);
}

Hit Scene::hit_at(std::uint32_t primitive, double distance, const Ray& ray) const {
  Hit hit;
  hit.primitive = primitive;
  hit.distance = distance;
  hit.point = ray.origin + distance * ray.direction;
  if (is_sphere(primitive)) {
    const Sphere& sphere = spheres_[primitive];
    hit.node = sphere.node;
    hit.normal = (hit.point - sphere.centre).normalized();
    return hit;
  }
  const Triangle& wall = triangle(primitive);
  hit.node = wall.node;
  hit.normal = normal_of(wall);
  if (hit.normal.dot(ray.direction) > 0.0) hit.normal = -hit.normal;
  return hit;
}

}  // namespace pmr::radiation
