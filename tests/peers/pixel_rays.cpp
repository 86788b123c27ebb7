#include "tests/peers/pixel_rays.h"

#include <algorithm>
#include <cmath>

#include "oracle/judging/ray_caster.h"

namespace sightline::tests {
namespace {

using peers::ItemBuffer;

double distance(const Point2& place, const Point2& from, const Point2& to) {
  const Point2 along{to.x - from.x, to.y - from.y};
  const double projected = (place.x - from.x) * along.x + (place.y - from.y) * along.y;
  const double share = std::clamp(projected / (along.x * along.x + along.y * along.y), 0.0, 1.0);
  return std::hypot(place.x - from.x - share * along.x, place.y - from.y - share * along.y);
}

bool has_edge_near(const ProjectedScene& scene, const Point2& place) {
  const auto in_window = [&](PointId id) {
    const ImagePoint& p = scene.point(id);
    return Point2{std::ldexp(static_cast<double>(p.x), -scene.grid_bits),
                  std::ldexp(static_cast<double>(p.y), -scene.grid_bits)};
  };
  for (std::size_t e = 0; e < scene.edge_count(); ++e) {
    const SceneEdge& edge = scene.edge(EdgeId(e));
    if (distance(place, in_window(edge.top), in_window(edge.bottom)) <= 1e-9) return true;
  }
  return false;
}

}  // namespace

std::vector<ImagePoint> rays_through_centres(const ItemBuffer& buffer, int grid_bits) {
  const auto on_grid = [grid_bits](double x) { return static_cast<std::int64_t>(std::ldexp(x, grid_bits)); };
  std::vector<ImagePoint> rays;
  for (int row = buffer.resolution() - 1; row >= 0; --row) {
    for (int column = 0; column < buffer.resolution(); ++column) {
      rays.push_back({on_grid(buffer.x_of(column)), on_grid(buffer.y_of(row))});
    }
  }
  return rays;
}

ItemBuffer seen_by_rays(const ProjectedScene& scene, int resolution) {
  const CutMesh& mesh = scene.mesh();
  ItemBuffer buffer(resolution);
  const std::vector<ImagePoint> rays = rays_through_centres(buffer, scene.grid_bits);
  std::vector<lattice::RayHits> hits = lattice::cast(scene, rays);
  std::size_t ray = 0;
  for (int row = resolution - 1; row >= 0; --row) {
    for (int column = 0; column < resolution; ++column, ++ray) {
      std::vector<FacetId>& facets = hits[ray].facets;
      if (facets.empty()) continue;
      lattice::sort_by_depth(facets, scene.mesh(), scene, rays[ray]);
      buffer.paint(column, row, mesh.facet_face[facets.front().index()]);
    }
  }
  return buffer;
}

std::size_t centres_on_edges(const ProjectedScene& scene, int resolution) {
  std::size_t on_edges = 0;
  const std::vector<ImagePoint> rays = rays_through_centres(ItemBuffer(resolution), scene.grid_bits);
  for (const lattice::RayHits& hits : lattice::cast(scene, rays)) on_edges += hits.on_edge ? 1 : 0;
  return on_edges;
}

int differing_pixels(const ItemBuffer& a, const ItemBuffer& b) {
  int differing = 0;
  for (int row = 0; row < a.resolution(); ++row) {
    for (int column = 0; column < a.resolution(); ++column) {
      differing += a.at(column, row) != b.at(column, row) ? 1 : 0;
    }
  }
  return differing;
}

int wrong_pixels(const ProjectedScene& scene, const ItemBuffer& buffer, const ItemBuffer& truth) {
  int wrong = 0;
  for (int row = 0; row < truth.resolution(); ++row) {
    for (int column = 0; column < truth.resolution(); ++column) {
      if (buffer.at(column, row) == truth.at(column, row)) continue;
      if (!has_edge_near(scene, {truth.x_of(column), truth.y_of(row)})) ++wrong;
    }
  }
  return wrong;
}

}  // namespace sightline::tests
