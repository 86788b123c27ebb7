// Facets as mirrors and obstacles are made of them: as they were before they were cut, and their planes.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/cutting/facet_cutter.h"
#include "geometry/mesh/box_hierarchy.h"
#include "geometry/mesh/cut_mesh.h"

namespace sightline::inline reflect {

[[nodiscard]] Box box_of(const CutMesh& mesh, std::span<const VertexId> corners);

[[nodiscard]] CutPolygon uncut_polygon(const CutMesh& mesh, UncutFacetId uncut);

// The triangles between whose corners normals are interpolated: fans of the facets of a surface as they were before they were cut.
[[nodiscard]] std::vector<std::array<VertexId, 3>> fans_of(const CutMesh& mesh, FacetId surface);

// Three corners that are not on one line.
[[nodiscard]] std::array<Point3, 3> plane_points(const CutMesh& mesh, FacetId facet);
[[nodiscard]] ExactPlane plane_through(const std::array<Point3, 3>& points);

}  // namespace sightline::inline reflect
