// Koucky's structure of vertices V and structure of triangles T (tables 3.1 and 3.2), as far as visibility needs them.
//
// In:  a flat scene, in which culling (3.5) and the field of view (3.6) are done.
// Out: V and T. Each polygon's corners are vertices of V, and its fan from the first of them is in T; every triangle is
//      still called visible. Corners in a straight edge are left out (convex_ring.h).
// Departures: a vertex has its depth in place of its position in space, which says as much; neighbours do not share
//      vertices, because each has its own rounded depth there.
#pragma once

#include <array>
#include <vector>

#include "peers/scene/convex_ring.h"
#include "peers/scene/flat_scene.h"

namespace sightline::peers::thesis {

struct Vertex {
  Point2 position2D;
  double depth = 0;
  bool visible = true;
};

struct Triangle {
  const FlatPolygon* polygon = nullptr;  // whose plane it is in
  std::array<std::size_t, 3> vertices{};
  MinMax extent;
  bool visible = true;
  bool partly_visible = false;
  bool thrown_away = false;
};

struct Structures {
  std::vector<Vertex> V;
  std::vector<Triangle> T;

  [[nodiscard]] const Point2& position2D(const Triangle& t, std::size_t corner) const {
    return V[t.vertices[corner]].position2D;
  }
  [[nodiscard]] ConvexRing projection(const Triangle& t) const {
    return {position2D(t, 0), position2D(t, 1), position2D(t, 2)};
  }
};

[[nodiscard]] Structures structures_of(const FlatScene& scene);

// Adds a triangle of the polygon's plane, with vertices of its own.
void add_triangle(Structures& structures, const FlatPolygon& polygon, const std::array<Point2, 3>& corners,
                  bool visible);

// The signs of p's barycentric coordinates tell, exactly, whether it is inside or on an edge. "If b_i = 1 then p
// coincides with p_i", and is not inside: so no triangle hides its own corners.
[[nodiscard]] bool is_inside(const Point2& p, const ConvexRing& triangle);

// This is the point that the segments ab and cd have in common; there is none where they are parallel. An end that lies
// on the other segment is the point itself; otherwise it is rounded, to the same point whichever way round the segments
// are given.
struct Intersection {
  bool found = false;
  Point2 point;
};
[[nodiscard]] Intersection intersection(const Point2& a, const Point2& b, const Point2& c, const Point2& d);

}  // namespace sightline::peers::thesis
