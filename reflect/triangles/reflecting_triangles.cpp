#include "reflect/triangles/reflecting_triangles.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "reflect/smooth/shading_normals.h"
#include "reflect/triangles/vertex_pyramid.h"
#include "reflect/world/uncut_facets.h"

namespace sightline::inline reflect {
namespace {

struct Ray {
  Point3 from = Point3::Zero();
  Vector3 direction = Vector3::Zero();
};

// This is a panel as rays meet it.
class PanelTarget {
 public:
  PanelTarget(const MirrorWorld& world, std::size_t panel) : emits_(world.panels[panel].emits) {
    for (const Point3& p : world.panels[panel].corners) corners_.push_back(world.scale * p);
    const auto [a, b, c] = panel_plane(world.panel_meshes[panel]);
    plane_ = plane_form(world.scale * a, world.scale * b, world.scale * c);
    const Vector3& n = plane_.normal;
    const std::array sizes{std::fabs(n.x()), std::fabs(n.y()), std::fabs(n.z())};
    axis_ = static_cast<int>(std::ranges::max_element(sizes) - sizes.begin());
  }

  [[nodiscard]] const PlaneForm& plane() const { return plane_; }

  // Returns whether the ray, beyond its start, meets the panel on a side that emits.
  [[nodiscard]] bool is_met_by(const Ray& ray) const {
    const double height = plane_.at(ray.from);
    const double distance = -height / plane_.normal.dot(ray.direction);
    if (!(distance > 0) || !std::isfinite(distance)) return false;
    return (emits_ == Emits::both || height > 0) && contains(ray.from + distance * ray.direction);
  }

 private:
  // The crossings of a line that runs to one side tell whether the place is inside.
  [[nodiscard]] bool contains(const Point3& place) const {
    const Point2 p = without_axis(place);
    bool inside = false;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Point2 a = without_axis(corners_[i]);
      const Point2 b = without_axis(corners_[i + 1 == corners_.size() ? 0 : i + 1]);
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
  }

  [[nodiscard]] Point2 without_axis(const Point3& p) const { return drop_axis(p, axis_); }

  Emits emits_;
  std::vector<Point3> corners_;
  PlaneForm plane_;
  int axis_ = 0;
};

// This has the vertices that triangles have, scaled.
class VertexSearch {
 public:
  VertexSearch(const LabelledMesh& labelled, double scale) {
    std::vector<std::uint8_t> used(labelled.vertices.size(), 0);
    for (const LabelledTriangle& t : labelled.triangles) {
      for (const VertexId v : t.corners) used[v.index()] = 1;
    }
    std::vector<Box> boxes;
    for (std::size_t v = 0; v < used.size(); ++v) {
      if (used[v] == 0) continue;
      const Point3 p = scale * labelled.vertices[v];
      boxes.push_back({p, p});
      vertices_.emplace_back(v);
    }
    hierarchy_ = build_hierarchy(boxes);
  }

  // Calls visit(vertex) for those in the pyramid.
  template <class Visit>
  void for_each_in(const VertexPyramid& pyramid, Visit visit) const {
    for_each_touched_item(
        hierarchy_, [&](const Box& box) { return pyramid.may_touch(box); },
        [&](const BoxHierarchy::Item& item) {
          if (pyramid.contains(item.box.low)) visit(vertices_[item.index]);
        });
  }

 private:
  BoxHierarchy hierarchy_;
  std::vector<VertexId> vertices_;
};

// Corners of what counts as in one plane with other surfaces (CutMesh::snapped_to): they are in it, though rounding has them off.
class SnappedCorners {
 public:
  SnappedCorners(const CutMesh& mesh, const LabelledMesh& labelled) : mesh_(mesh) {
    if (mesh.snapped_to.empty()) return;
    for (const LabelledTriangle& t : labelled.triangles) {
      for (const VertexId v : t.corners) planes_.emplace_back(v, plane_of(t.surface));
    }
    std::ranges::sort(planes_);
  }

  [[nodiscard]] bool is_in_plane(VertexId corner, FacetId surface) const {
    return !planes_.empty() && std::ranges::binary_search(planes_, std::pair(corner, plane_of(surface)));
  }

 private:
  [[nodiscard]] UncutFacetId plane_of(FacetId surface) const { return mesh_.plane_of(mesh_.uncut_facet(surface)); }

  const CutMesh& mesh_;
  std::vector<std::pair<VertexId, UncutFacetId>> planes_;
};

class Marker {
 public:
  Marker(const MirrorWorld& world, const Camera& camera, const LabelledMesh& labelled, ReflectionStatistics& statistics)
      : world_(world),
        labelled_(labelled),
        statistics_(statistics),
        vertices_(labelled, world.scale),
        snapped_corners_(*world.surface, labelled),
        forward_(camera.forward),
        eye_(camera.eye) {
    if (eye_.w != 0) eye_.xyz = world.scale * eye_.xyz;
    for (std::size_t panel = 0; panel < world.panels.size(); ++panel) targets_.emplace_back(world, panel);
  }

  std::uint64_t reflecting(const LabelledTriangle& triangle) {
    if (!triangle.seen || !world_.mirrors(triangle.face)) return 0;
    const std::array<Ray, 3> rays = mirrored_rays(triangle);
    std::uint64_t panels = 0;
    for (std::size_t panel = 0; panel < targets_.size(); ++panel) {
      const auto meets_panel = [&](const Ray& ray) { return targets_[panel].is_met_by(ray); };
      if (world_.is_snapped_surface(panel, triangle.surface)) continue;
      if (std::ranges::all_of(rays, meets_panel) && !is_blocked(triangle, panel)) panels |= std::uint64_t{1} << panel;
    }
    return panels;
  }

 private:
  [[nodiscard]] Point3 corner(const LabelledTriangle& triangle, std::size_t i) const {
    return world_.scale * labelled_.vertices[triangle.corners[i].index()];
  }

  std::array<Ray, 3> mirrored_rays(const LabelledTriangle& triangle) {
    if (!normals_ || surface_ != triangle.surface) {
      normals_.emplace(*world_.surface, world_.normals, triangle.surface);
      surface_ = triangle.surface;
    }
    std::array<Ray, 3> rays;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Point3 from = corner(triangle, i);
      const Vector3 incoming = eye_.w == 0 ? forward_ : from - eye_.xyz;
      const Vector3 normal = world_.normals.empty()
                                 ? normals_->of_plane()
                                 : normals_->normal_at(labelled_.vertices[triangle.corners[i].index()]);
      rays[i] = {from, incoming - (2 * incoming.dot(normal)) * normal};
    }
    return rays;
  }

  // The triangle's own corners are on the pyramid's sides, whatever rounding says.
  bool is_blocked(const LabelledTriangle& triangle, std::size_t panel) {
    ++statistics_.pyramids;
    std::array corners{corner(triangle, 0), corner(triangle, 1), corner(triangle, 2)};
    const PlaneForm plane = plane_form(corners[0], corners[1], corners[2]);
    const double towards = eye_.w == 0 ? plane.normal.dot(eye_.xyz) : plane.at(eye_.xyz);
    if (towards < 0) std::swap(corners[1], corners[2]);
    bool blocked = false;
    vertices_.for_each_in(VertexPyramid(corners, eye_, targets_[panel].plane()), [&](VertexId v) {
      ++statistics_.obstacles;
      blocked = blocked || (std::ranges::find(triangle.corners, v) == triangle.corners.end() &&
                            !snapped_corners_.is_in_plane(v, triangle.surface));
    });
    statistics_.blocked += blocked ? 1 : 0;
    return blocked;
  }

  const MirrorWorld& world_;
  const LabelledMesh& labelled_;
  ReflectionStatistics& statistics_;
  VertexSearch vertices_;
  SnappedCorners snapped_corners_;
  Vector3 forward_ = Vector3::Zero();
  HomogeneousPoint eye_;
  std::vector<PanelTarget> targets_;
  std::optional<ShadingNormals> normals_;  // of surface_
  FacetId surface_;
};

}  // namespace

Reflections reflecting_triangles(const MirrorWorld& world, const Camera& camera, LabelledMesh& labelled) {
  Reflections reflections{ReflectionMode::triangles, std::vector<PanelReflection>(world.panels.size()), {}};
  Marker marker(world, camera, labelled, reflections.statistics);
  for (LabelledTriangle& triangle : labelled.triangles) triangle.reflecting = marker.reflecting(triangle);
  return reflections;
}

}  // namespace sightline::inline reflect
