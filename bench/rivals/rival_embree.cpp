#include "bench/rivals/rivals.h"

#ifdef SIGHTLINE_BENCH_EMBREE

#include <embree3/rtcore.h>

#include <array>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "cli/system/resources.h"

namespace sightline::bench {
using namespace cli;
namespace {

constexpr std::size_t pixels = 2048;
constexpr std::size_t tile = 4;  // tile * tile rays go together
constexpr std::size_t packet = tile * tile;

template <class Number>
std::array<Number, 3>* buffer_of(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t count) {
  return static_cast<std::array<Number, 3>*>(
      rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(std::array<Number, 3>), count));
}

void set_vertices(RTCGeometry geometry, const CutMesh& mesh) {
  auto* vertices = buffer_of<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.vertices.size());
  for (const Point3& p : mesh.vertices) {
    *vertices++ = {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
  }
}

void set_triangles(RTCGeometry geometry, const CutMesh& mesh) {
  const std::size_t count = mesh.facets.corners.size() - 2 * mesh.facet_count();
  auto* triangles = buffer_of<std::uint32_t>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, count);
  for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
    const auto corners = mesh.corners(FacetId(f));
    for (std::size_t i = 2; i < corners.size(); ++i) {
      *triangles++ = {corners[0].value, corners[i - 1].value, corners[i].value};
    }
  }
}

RTCScene build_hierarchy(RTCDevice device, const CutMesh& mesh) {
  RTCScene scene = rtcNewScene(device);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  set_vertices(geometry, mesh);
  set_triangles(geometry, mesh);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  return scene;
}

// The directions of a camera's rays are along + x * across + y * upwards for the place (x, y) of the window. They are
// the columns of the inverse of the camera's rows.
struct RayFan {
  explicit RayFan(const Camera& camera) {
    const double scale = 1 / camera.right.dot(camera.up.cross(camera.forward));
    across = scale * camera.up.cross(camera.forward);
    upwards = scale * camera.forward.cross(camera.right);
    along = scale * camera.right.cross(camera.up);
  }
  Vector3 across = Vector3::Zero();
  Vector3 upwards = Vector3::Zero();
  Vector3 along = Vector3::Zero();
};

double window_place(std::size_t pixel) { return (2 * static_cast<double>(pixel) + 1) / pixels - 1; }

void aim(RTCRayHit16& rays, std::size_t ray, const Point3& from, const Vector3& direction) {
  rays.ray.org_x[ray] = static_cast<float>(from.x());
  rays.ray.org_y[ray] = static_cast<float>(from.y());
  rays.ray.org_z[ray] = static_cast<float>(from.z());
  rays.ray.dir_x[ray] = static_cast<float>(direction.x());
  rays.ray.dir_y[ray] = static_cast<float>(direction.y());
  rays.ray.dir_z[ray] = static_cast<float>(direction.z());
  rays.ray.tnear[ray] = 0;
  rays.ray.tfar[ray] = std::numeric_limits<float>::infinity();
  rays.ray.mask[ray] = ~0U;
  rays.ray.flags[ray] = 0;
  rays.ray.time[ray] = 0;
  rays.hit.geomID[ray] = RTC_INVALID_GEOMETRY_ID;
}

void shoot_tile(RTCScene scene, const Point3& from, const RayFan& fan, std::size_t column, std::size_t row) {
  alignas(64) static constexpr std::array<int, packet> all{-1, -1, -1, -1, -1, -1, -1, -1,
                                                           -1, -1, -1, -1, -1, -1, -1, -1};
  alignas(64) RTCRayHit16 rays;
  for (std::size_t ray = 0; ray < packet; ++ray) {
    const double x = window_place(column + ray % tile);
    const double y = window_place(row + ray / tile);
    aim(rays, ray, from, fan.along + x * fan.across + y * fan.upwards);
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(all.data(), scene, &context, &rays);
}

}  // namespace

std::optional<EmbreeSeconds> seconds_of_embree(const CutMesh& mesh, const Camera& camera) {
  RTCDevice device = rtcNewDevice("threads=1");
  EmbreeSeconds seconds;
  const ProcessorTime building;
  RTCScene scene = build_hierarchy(device, mesh);
  seconds.hierarchy = building.seconds();
  const RayFan fan(camera);
  const ProcessorTime shooting;
  for (std::size_t row = 0; row < pixels; row += tile) {
    for (std::size_t column = 0; column < pixels; column += tile) shoot_tile(scene, camera.origin, fan, column, row);
  }
  seconds.rays = shooting.seconds();
  const RTCError error = rtcGetDeviceError(device);
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
  if (error != RTC_ERROR_NONE) throw std::runtime_error("Embree reports error " + std::to_string(error));
  return seconds;
}

}  // namespace sightline::bench

#else

namespace sightline::bench {

std::optional<EmbreeSeconds> seconds_of_embree(const CutMesh& /*mesh*/, const Camera& /*camera*/) {
  return std::nullopt;
}

}  // namespace sightline::bench

#endif
