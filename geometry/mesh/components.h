// The components of a closed, oriented mesh, and what is inside them.
//
// In:  a mesh.
// Out: its facets grouped by the edges they share; the sign of the volume that a closed component encloses; whether a
//      point is outside, on, or inside a closed component.
// All exact on the input's coordinates. Facets that share only a vertex are not connected by it.
// Complexity: components() O(n alpha(n)) for n facets; volume_sign O(n); location_of O(n) per ray, mostly one.
#pragma once

#include <span>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/numbers/predicates.h"

namespace sightline::inline geometry {

using Component = std::vector<FacetId>;  // ascending

// The components are ordered by their first facets.
[[nodiscard]] std::vector<Component> components(const PolygonMesh& mesh);

// Returns the sign of the volume enclosed, positive where the facets are counter-clockwise seen from outside. The
// component is closed: each of its edges has two facets that run through it in opposite directions.
[[nodiscard]] Sign volume_sign(const PolygonMesh& mesh, std::span<const FacetId> component);

enum class Location { outside, on_surface, inside };

// p is inside where a ray from it crosses the component an odd number of times. The component is closed, as above.
[[nodiscard]] Location location_of(const Point3& p, const PolygonMesh& mesh, std::span<const FacetId> component);

}  // namespace sightline::inline geometry
