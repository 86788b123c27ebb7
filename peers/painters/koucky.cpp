#include "peers/painters/koucky.h"

#include <algorithm>

#include "peers/painters/delaunay.h"
#include "peers/painters/koucky_structures.h"
#include "peers/scene/in_front.h"

namespace sightline::peers {
namespace thesis {
namespace {

using Points = std::vector<Point2>;
using Projections = std::vector<ConvexRing>;

struct Work {
  std::uint64_t tested = 0;  // pairs of a vertex and a triangle
  std::uint64_t partly_visible = 0;
  std::uint64_t points_added = 0;
};

bool is_closer(const Triangle& t, const Vertex& v) {
  return t.polygon->plane.at(v.position2D.x, v.position2D.y) < v.depth;
}

bool hides(const Structures& s, const Triangle& t, const Vertex& v) {
  return contains(t.extent, v.position2D) && is_closer(t, v) && is_inside(v.position2D, s.projection(t));
}

std::size_t hidden_corners(const Structures& s, const Triangle& t) {
  return static_cast<std::size_t>(
      std::count_if(t.vertices.begin(), t.vertices.end(), [&](std::size_t v) { return !s.V[v].visible; }));
}

// This is algorithm 3.4.
void find_hidden_triangles(Structures& s, Work& work) {
  for (Vertex& v : s.V) {
    for (const Triangle& t : s.T) {
      ++work.tested;
      if (!hides(s, t, v)) continue;
      v.visible = false;
      break;
    }
  }
  for (Triangle& t : s.T) {
    const std::size_t hidden = hidden_corners(s, t);
    t.visible = hidden == 0;
    t.partly_visible = hidden == 1 || hidden == 2;
  }
}

// Returns T_closer, each by its projection.
Projections closer_triangles(const Structures& s, const Triangle& t, const CutMesh& mesh) {
  const ConvexRing projection = s.projection(t);
  Projections closer;
  for (const Triangle& other : s.T) {
    if (other.thrown_away || other.polygon == t.polygon || !extents_overlap(t.extent, other.extent)) continue;
    ConvexRing other_projection = s.projection(other);
    const ConvexRing common = overlap(projection, other_projection);
    if (common.empty() || !is_in_front(*other.polygon, *t.polygon, common, mesh)) continue;
    closer.push_back(std::move(other_projection));
  }
  return closer;
}

Points intersections(const ConvexRing& a, const ConvexRing& b) {
  Points points;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const auto [found, point] = intersection(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]);
      if (found) points.push_back(point);
    }
  }
  return points;
}

// These are lines 3 to 10 of algorithm 3.5.
Points retriangulation_points(const ConvexRing& triangle, const Projections& closer) {
  Points points = triangle;
  for (const ConvexRing& other : closer) {
    const Points common = intersections(triangle, other);
    if (common.empty()) continue;
    points.insert(points.end(), common.begin(), common.end());
    std::copy_if(other.begin(), other.end(), std::back_inserter(points),
                 [&](const Point2& p) { return is_inside(p, triangle); });
  }
  return points;
}

bool is_visible(const TriangleOfPoints& t, const Projections& closer) {
  const Point2 centroid{(t[0].x + t[1].x + t[2].x) / 3, (t[0].y + t[1].y + t[2].y) / 3};
  return std::none_of(closer.begin(), closer.end(),
                      [&](const ConvexRing& other) { return is_inside(centroid, other); });
}

// The first triangulation only serves to find them.
Points points_of_visible_triangles(const Points& points, const Projections& closer) {
  Points kept;
  for (const TriangleOfPoints& t : delaunay(points)) {
    if (is_visible(t, closer)) kept.insert(kept.end(), t.begin(), t.end());
  }
  return kept;
}

// This is algorithm 3.5 for one partly visible triangle. Depths on its plane take the place of 3D positions (line 11).
void retriangulate(Structures& s, std::size_t index, const CutMesh& mesh, Work& work) {
  const FlatPolygon& polygon = *s.T[index].polygon;
  const ConvexRing triangle = s.projection(s.T[index]);
  const Projections closer = closer_triangles(s, s.T[index], mesh);
  const Points points = retriangulation_points(triangle, closer);
  Points kept = points_of_visible_triangles(points, closer);
  kept.insert(kept.end(), triangle.begin(), triangle.end());
  for (const TriangleOfPoints& t : delaunay(kept)) add_triangle(s, polygon, t, is_visible(t, closer));
  s.T[index].thrown_away = true;
  work.points_added += points.size() - 3;
}

// The new triangles are in T, too, for those that are retriangulated after them.
void retriangulate_partly_visible(Structures& s, const CutMesh& mesh, Work& work) {
  const std::size_t count = s.T.size();
  for (std::size_t t = 0; t < count; ++t) {
    if (!s.T[t].partly_visible) continue;
    ++work.partly_visible;
    retriangulate(s, t, mesh, work);
  }
}

VisibleParts visible_triangles(const Structures& s) {
  VisibleParts seen;
  for (const Triangle& t : s.T) {
    if (t.visible && !t.thrown_away) seen.push_back({t.polygon->face, s.projection(t)});
  }
  return seen;
}

Outcome refine_and_label(const FlatScene& scene, int /*resolution*/) {
  Structures structures = structures_of(scene);
  Work work;
  find_hidden_triangles(structures, work);
  retriangulate_partly_visible(structures, *scene.mesh, work);
  return {visible_triangles(structures),
          {{"vertices tested against triangles", work.tested},
           {"triangles partly visible", work.partly_visible},
           {"points added", work.points_added},
           {"triangles", structures.T.size() - work.partly_visible}}};
}

}  // namespace
}  // namespace thesis

Peer koucky() {
  return {
      "koucky",
      "Hidden triangles and retriangulation",
      "Koucky 3.7 and 3.8, algorithms 3.4 and 3.5",
      ComputedAt::object_precision,
      "It tests each vertex against the triangles closer to the camera. A triangle with no hidden corner is visible, "
      "one with three is hidden, and one with one or two is cut up: where its edges meet those of closer triangles, "
      "and "
      "where these have vertices inside it, points are put, and a Delaunay triangulation of them gives new triangles. "
      "The points of those that are visible are triangulated once more, so that little is spent on what is hidden.",
      "It looks at corners, so it misses whatever hides no corner of a triangle, such as a thin bar across its middle, "
      "and it "
      "calls a triangle hidden if its corners are, even where its middle can be seen through a gap. The Delaunay "
      "triangulation does not know the edges of what hides, so a new triangle can lie across one and then counts "
      "whole, "
      "as its centroid is seen or not. Where two occluders cross inside a triangle no point is put. Its error shrinks "
      "as the triangles of the scene get small beside what hides them.",
      thesis::refine_and_label};
}

}  // namespace sightline::peers
