// Facets as mirrors and obstacles are made of them: as they were before they were cut, and their planes.
#pragma once

#include <array>

#include "geometry/cutting/facet_cutter.h"
#include "geometry/mesh/mesh.h"

namespace sightline::inline reflect {

[[nodiscard]] CutPolygon whole_polygon(const Mesh& mesh, WholeId whole);

// Three corners that are not on one line.
[[nodiscard]] std::array<Point3, 3> plane_points(const Mesh& mesh, FacetId facet);
[[nodiscard]] ExactPlane plane_through(const std::array<Point3, 3>& points);

}  // namespace sightline::inline reflect
