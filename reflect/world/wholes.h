// Facets as mirrors and obstacles are made of them: as they were before they were cut, and their planes.
#pragma once

#include <array>
#include <span>

#include "geometry/cutting/facet_cutter.h"
#include "geometry/mesh/box_hierarchy.h"
#include "geometry/mesh/cut_mesh.h"

namespace sightline::inline reflect {

// Returns the corners of a whole: of a facet, where the mesh was not cut.
[[nodiscard]] std::span<const VertexId> whole_corners(const CutMesh& mesh, WholeId whole);

[[nodiscard]] Box box_of(const CutMesh& mesh, std::span<const VertexId> corners);

[[nodiscard]] CutPolygon whole_polygon(const CutMesh& mesh, WholeId whole);

// Three corners that are not on one line.
[[nodiscard]] std::array<Point3, 3> plane_points(const CutMesh& mesh, FacetId facet);
[[nodiscard]] ExactPlane plane_through(const std::array<Point3, 3>& points);

}  // namespace sightline::inline reflect
