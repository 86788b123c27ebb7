// This must hold for every extreme scene. There is a complaint per violation; the list is empty where it holds.
#pragma once

#include "tests/extremes/extreme_scene.h"

namespace sightline::extremes {

// Every stage's validator is asked; the labelled surface keeps vertices and areas, and is closed where the mesh is.
[[nodiscard]] Complaints complaints_of_stages_and_laws(const View& view);

// Fixed rays all over the window, and rays three grid units beside corners of the image, are held against the visible
// polygons.
//
// A ray decides nothing where a facet's border passes within a grid unit: there facets may overlap in the rounded image
// that do not in truth, and have no depth order.
struct RayTally {
  std::size_t decided = 0;
  std::size_t seen = 0;  // of these, how many see a face
  Complaints complaints;
};
[[nodiscard]] RayTally compare_rays(const View& view);

// Returns the visible areas with the faces in another order, put back into the old one.
[[nodiscard]] std::vector<Rational> areas_when_shuffled(const Mesh& mesh, const Sight& sight, std::uint64_t seed);

// Returns by how much the visible area of a face may differ from the truth, in window units squared.
//
// Rounding moves each end of an edge of the image by at most half a grid spacing s per axis. So both the true edge and
// the rounded one lie in the hull of two squares of side s around the true ends, whose area is s (|dx| + |dy|) + s^2
// for an edge (dx, dy). A place outside all hulls is in the same facets' images before and after, and depth is not
// rounded: it shows the same face. So the bound is the sum over the facets' edges in the view volume. In terms of the
// rounded edge, |dx| + |dy| is larger by at most 2 s, which makes it s (|dx'| + |dy'|) + 3 s^2.
[[nodiscard]] Rational rounding_bound(const ProjectedScene& scene);

// Visible areas are held against those of the rational oracle: they are equal where the image is exact, else within the
// bound; those of the sweep without rounding are equal everywhere. This is for small scenes.
[[nodiscard]] Complaints differences_from_truth(const Mesh& mesh, const Sight& sight);

}  // namespace sightline::extremes
