#include "peers/lines/scene_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "geometry/mesh/facet_plane.h"
#include "geometry/projection/camera_forms.h"
#include "geometry/projection/vertex_projection.h"
#include "peers/lines/cohen_sutherland.h"

namespace sightline::peers {
namespace {

using CameraPoint = CameraPlace<double>;

double mixed(double a, double b, double t) { return a + t * (b - a); }

CameraPoint mixed(const CameraPoint& p, const CameraPoint& q, double t) {
  return {mixed(p.x, q.x, t), mixed(p.y, q.y, t), mixed(p.w, q.w, t), mixed(p.depth, q.depth, t)};
}

Corner image_of(const Camera& camera, const CameraPoint& p) {
  const double depth = camera.projection == Projection::perspective ? -1 / p.w : p.depth;
  return {p.x / p.w, p.y / p.w, depth};
}

// Returns what is left of the line from p, before the eye's plane, to q, which is not: up to where it leaves a window
// of twice the size on the side on which it meets the eye's plane. There is nothing where it is beyond that side all
// along.
std::optional<CameraPoint> cut_before_eye(const CameraPoint& p, const CameraPoint& q) {
  const CameraPoint at_eye = mixed(p, q, p.w / (p.w - q.w));
  const bool is_across = std::abs(at_eye.x) >= std::abs(at_eye.y);
  const double side = std::copysign(1.0, is_across ? at_eye.x : at_eye.y);
  const auto inside = [=](const CameraPoint& c) { return 2 * c.w - side * (is_across ? c.x : c.y); };
  if (inside(p) <= 0) return std::nullopt;
  return mixed(p, q, inside(p) / (inside(p) - inside(q)));
}

// Returns the image of a vertex before the eye: its grid point where it is in the window.
Corner vertex_image(const FlatScene& scene, VertexId vertex, const CameraPoint& place) {
  const ProjectedScene& projected = *scene.projected;
  Corner image = image_of(projected.camera, place);
  const ProjectedVertex rounded = project_vertex(*scene.mesh, vertex, projected.camera, projected.grid_bits);
  if (rounded.strictly_outside != 0) return image;
  image.x = std::ldexp(static_cast<double>(rounded.image.x), -projected.grid_bits);
  image.y = std::ldexp(static_cast<double>(rounded.image.y), -projected.grid_bits);
  return image;
}

struct ImageLine {
  LineEnd from;
  LineEnd to;
};

std::optional<ImageLine> image_of(const FlatScene& scene, const std::array<VertexId, 2>& ends) {
  const Camera& camera = scene.projected->camera;
  const CameraForms<double> forms(camera);
  const CameraPoint p = forms.at(scene.mesh->position(ends[0]));
  const CameraPoint q = forms.at(scene.mesh->position(ends[1]));
  if (p.w > 0 && q.w > 0)
    return ImageLine{{vertex_image(scene, ends[0], p), ends[0]}, {vertex_image(scene, ends[1], q), ends[1]}};
  if (p.w > 0) {
    const auto cut = cut_before_eye(p, q);
    if (cut) return ImageLine{{vertex_image(scene, ends[0], p), ends[0]}, {image_of(camera, *cut), {}}};
  }
  if (q.w > 0) {
    const auto cut = cut_before_eye(q, p);
    if (cut) return ImageLine{{image_of(camera, *cut), {}}, {vertex_image(scene, ends[1], q), ends[1]}};
  }
  return std::nullopt;
}

bool is_inside(const Point2& p, const Window& window) {
  return p.x > window.x_min && p.x < window.x_max && p.y > window.y_min && p.y < window.y_max;
}

double on_grid(double coordinate, int grid_bits) {
  return std::ldexp(std::round(std::ldexp(coordinate, grid_bits)), -grid_bits);
}

// Returns the end of the line's part at p: the line's own end where that is inside the window.
LineEnd end_at(const Point2& p, const LineEnd& end, const ImageLine& line, int grid_bits) {
  if (is_inside(p, Window{})) return end;
  const Corner& a = line.from.place;
  const Corner& b = line.to.place;
  const bool is_flat = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
  const double t = is_flat ? (p.x - a.x) / (b.x - a.x) : (p.y - a.y) / (b.y - a.y);
  return {{on_grid(p.x, grid_bits), on_grid(p.y, grid_bits), mixed(a.depth, b.depth, t)}, {}};
}

bool is_along_border(const Line& line, const Window& window) {
  const bool upright = line.from.x == line.to.x && (line.from.x == window.x_min || line.from.x == window.x_max);
  const bool level = line.from.y == line.to.y && (line.from.y == window.y_min || line.from.y == window.y_max);
  return upright || level;
}

std::optional<ImageLine> clipped(const ImageLine& line, int grid_bits) {
  const Window window;
  const auto part =
      cohen_sutherland({{line.from.place.x, line.from.place.y}, {line.to.place.x, line.to.place.y}}, window);
  if (!part || part->from == part->to || is_along_border(*part, window)) return std::nullopt;
  return ImageLine{end_at(part->from, line.from, line, grid_bits), end_at(part->to, line.to, line, grid_bits)};
}

// This is a polygon on a mesh edge.
struct EdgeUse {
  MeshEdgeId edge;
  const FlatPolygon* polygon = nullptr;
  bool is_left = true;
};

// The uses are sorted by mesh edge, then by facet.
std::vector<EdgeUse> edge_uses(const FlatScene& scene) {
  const CutMesh& mesh = *scene.mesh;
  std::vector<EdgeUse> uses;
  for (const FlatPolygon& polygon : scene.polygons) {
    const auto corners = mesh.corners(polygon.facet);
    const auto edges = mesh.edges_of(polygon.facet);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const bool is_along = mesh.weld[corners[i].index()] == mesh.edges[edges[i].index()][0];
      uses.push_back({edges[i], &polygon, is_along == polygon.is_front});
    }
  }
  std::stable_sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) { return a.edge < b.edge; });
  return uses;
}

// All depths are equal on the line, so the nearest polygon beside it is the one that comes nearest per step.
FacetId nearest_beside(const ImageLine& line, std::span<const EdgeUse> uses, bool on_left) {
  const double step = on_left ? 1 : -1;
  const Point2 aside{step * (line.from.place.y - line.to.place.y), step * (line.to.place.x - line.from.place.x)};
  const auto depth_of_step = [&](const EdgeUse& use) {
    return use.polygon->plane.a * aside.x + use.polygon->plane.b * aside.y;
  };
  const EdgeUse* nearest = nullptr;
  for (const EdgeUse& use : uses) {
    if (use.is_left != on_left) continue;
    if (nearest == nullptr || depth_of_step(use) < depth_of_step(*nearest)) nearest = &use;
  }
  return nearest == nullptr ? FacetId{} : nearest->polygon->facet;
}

int winding_of(std::span<const EdgeUse> uses) {
  int winding = 0;
  for (const EdgeUse& use : uses) winding += use.is_left ? 1 : -1;
  return winding;
}

}  // namespace

Corner SceneLine::at(double t) const {
  return {mixed(from.place.x, to.place.x, t), mixed(from.place.y, to.place.y, t),
          mixed(from.place.depth, to.place.depth, t)};
}

std::vector<SceneLine> scene_lines(const FlatScene& scene) {
  std::vector<SceneLine> lines;
  const std::vector<EdgeUse> uses = edge_uses(scene);
  for (std::size_t first = 0, end = 0; first < uses.size(); first = end) {
    const MeshEdgeId edge = uses[first].edge;
    while (end < uses.size() && uses[end].edge == edge) ++end;
    const auto image = image_of(scene, scene.mesh->edges[edge.index()]);
    const auto line = image ? clipped(*image, scene.projected->grid_bits) : std::nullopt;
    if (!line) continue;
    const std::span on_line = std::span(uses).subspan(first, end - first);
    lines.push_back({edge, line->from, line->to, nearest_beside(*line, on_line, true),
                     nearest_beside(*line, on_line, false), winding_of(on_line)});
  }
  return lines;
}

bool parts_surfaces(const CutMesh& mesh, const SceneLine& line) {
  return surface_of(mesh, line.left) != surface_of(mesh, line.right);
}

}  // namespace sightline::peers
