// The rivals are what sightline is measured against. Each is in a file of its own, and each is optional.
//
// In:  what sightline works on.
// Out: the rival's processor time in seconds, on one thread; empty where it was not installed when this was built.
// Complexity: the rival's. Errors: std::runtime_error where the rival reports one.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "bench/scenes/projected_triangles.h"
#include "geometry/mesh/mesh.h"
#include "geometry/numbers/image_point.h"
#include "geometry/projection/camera.h"

namespace sightline::bench {

// tinyobjloader takes a file to positions (as float, its default) and triangles.
[[nodiscard]] std::optional<double> seconds_to_parse(const std::filesystem::path& obj);

// std::sort sorts by sweeps_before, after shuffling that does not count.
[[nodiscard]] double seconds_to_sort(std::vector<ImagePoint> points);

// Embree builds the hierarchy of boxes over the facets, and finds the nearest facet for the centre of each of 2048 x
// 2048 pixels. The camera is a pinhole.
struct EmbreeSeconds {
  double hierarchy = 0;
  double rays = 0;
};
[[nodiscard]] std::optional<EmbreeSeconds> seconds_of_embree(const CutMesh& mesh, const Camera& camera);

// CGAL runs lower_envelope_3, with exact predicates and constructions.
[[nodiscard]] std::optional<double> seconds_of_cgal(const std::vector<ProjectedTriangle>& triangles);

// gl2ps makes a binary space partition and removes what is hidden, in an image of 2048 x 2048, in single precision. Its
// format leaves out all drawing: nothing is written.
[[nodiscard]] std::optional<double> seconds_of_gl2ps(const std::vector<ProjectedTriangle>& triangles);

}  // namespace sightline::bench
