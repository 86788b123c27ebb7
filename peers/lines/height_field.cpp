#include "peers/lines/height_field.h"

#include <algorithm>
#include <optional>
#include <string>

#include "geometry/projection/camera_forms.h"
#include "peers/lines/height_grid.h"
#include "peers/scene/peer.h"

namespace sightline::peers {
namespace {

constexpr auto no_height_field =
    "the mesh is no height field: y = f(x, z), or another axis as the height, over a complete rectangular grid";
constexpr auto not_upright =
    "columns of the image are no upright planes: the camera is rolled, or a pinhole that looks up or down";
constexpr auto behind_eye = "a part of the height field lies behind the eye";
constexpr auto no_order =
    "the eye is above the height field, or looks along its polylines: these have no order from front to back";

bool is_upright(const Camera& camera, int height_axis) {
  if (camera.right[height_axis] != 0) return false;
  return camera.projection == Projection::orthographic || camera.forward[height_axis] == 0;
}

bool is_before_eye(const CutMesh& mesh, const HeightGrid& grid, const Camera& camera) {
  if (camera.projection == Projection::orthographic) return true;
  const CameraForms<double> forms(camera);
  return std::all_of(grid.vertices.begin(), grid.vertices.end(),
                     [&](VertexId v) { return forms.depth_at(mesh.position(v)) > 0; });
}

// `constant` says which of the ground axes is constant on a polyline.
struct Order {
  std::size_t constant = 0;
  bool is_ascending = true;
};

// Returns the order in which the rays pass the polylines; nothing where not all do it in one order.
std::optional<Order> order_of(const Camera& camera, const HeightGrid& grid) {
  const bool is_far_away = camera.projection == Projection::orthographic;
  for (const std::size_t constant : {std::size_t{0}, std::size_t{1}}) {
    const double eye = camera.eye.xyz[grid.ground_axes[constant]];
    if (eye < (is_far_away ? 0 : grid.values[constant].front())) return Order{constant, true};
    if (eye > (is_far_away ? 0 : grid.values[constant].back())) return Order{constant, false};
  }
  return std::nullopt;
}

// Returns nullptr where there is none.
const char* reason_against(const CutMesh& mesh, const HeightGrid& grid, const Camera& camera) {
  if (!is_upright(camera, grid.height_axis)) return not_upright;
  if (!is_before_eye(mesh, grid, camera)) return behind_eye;
  return order_of(camera, grid) ? nullptr : no_order;
}

std::vector<std::vector<VertexId>> polylines_of(const HeightGrid& grid, const Order& order) {
  std::vector<std::vector<VertexId>> polylines(grid.values[order.constant].size());
  for (std::size_t i = 0; i < grid.values[0].size(); ++i) {
    for (std::size_t j = 0; j < grid.values[1].size(); ++j) {
      polylines[order.constant == 0 ? i : j].push_back(grid.at(i, j));
    }
  }
  if (!order.is_ascending) std::reverse(polylines.begin(), polylines.end());
  return polylines;
}

// Returns the edges that join polylines, by the nearer one.
std::vector<std::vector<std::array<VertexId, 2>>> joins_of(const CutMesh& mesh,
                                                           const std::vector<std::vector<VertexId>>& polylines) {
  std::vector<std::size_t> polyline_of(mesh.vertices.size());
  for (std::size_t i = 0; i < polylines.size(); ++i) {
    for (const VertexId v : polylines[i]) polyline_of[v.index()] = i;
  }
  std::vector<std::vector<std::array<VertexId, 2>>> joins(polylines.size());
  for (const auto& ends : mesh.edges) {
    const auto [nearer, farther] = std::minmax(polyline_of[ends[0].index()], polyline_of[ends[1].index()]);
    if (nearer != farther) joins[nearer].push_back(ends);
  }
  return joins;
}

void refuse_what_is_left_out(const ProjectedScene& scene) {
  if (scene.camera.near_distance || scene.camera.far_distance) {
    throw RefusedScene("the camera has a near or far bound, which may cut the height field open; leave it out");
  }
  if (scene.sides_shown != Sides::both) {
    throw RefusedScene("only front sides count here, and a height field hides with both; set sides to both");
  }
}

}  // namespace

HeightField height_field(const FlatScene& scene) {
  const CutMesh& mesh = *scene.mesh;
  refuse_what_is_left_out(*scene.projected);
  const char* reason = no_height_field;
  for (const int height_axis : {1, 2, 0}) {
    const auto grid = height_grid(mesh, height_axis);
    if (!grid) continue;
    reason = reason_against(mesh, *grid, scene.projected->camera);
    if (reason != nullptr) continue;
    HeightField field{polylines_of(*grid, *order_of(scene.projected->camera, *grid)), {}};
    field.joins = joins_of(mesh, field.polylines);
    return field;
  }
  throw RefusedScene(std::string(reason) + "; take another peer");
}

}  // namespace sightline::peers
