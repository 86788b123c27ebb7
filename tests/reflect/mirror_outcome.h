// Tests by hand have a surface, panels and a camera above it, and what comes out.
#pragma once

#include <vector>

#include "oracle/judging/judge.h"
#include "tests/tools/analyzed.h"
#include "tests/tools/polygon_mesh.h"

namespace sightline::tests {

// The camera looks straight down; at depth d it sees what is at most d to the left, right, back and front.
[[nodiscard]] Camera looking_down(const Point3& eye);

[[nodiscard]] Corners rectangle(double left, double right, double front, double back, double z);

// The mirror of most tests is 16 x 16 in the plane z = 0, seen from (-2, 0, 4). A panel's point (x, y, 4) is mirrored
// in ((x - 2) / 2, y / 2, 0).
inline const Corners floor_mirror{{-8, -8, 0}, {8, -8, 0}, {8, 8, 0}, {-8, 8, 0}};
inline const Corners overhead{{1, -1, 4}, {3, -1, 4}, {3, 1, 4}, {1, 1, 4}};  // is mirrored in [-1/2, 1/2]^2
inline const Point3 mirror_eye{-2, 0, 4};

struct MirrorOutcome {
  View view;
  std::vector<double> areas;  // per panel, on the surface
};

// These are the areas of the polygons that reflect a panel, in window units. The exact one is for small numbers of
// them.
[[nodiscard]] Rational exact_image_area(const View& view, std::size_t panel);
[[nodiscard]] double image_area(const View& view, std::size_t panel);

[[nodiscard]] double area(const LabelledMesh& labelled, const LabelledTriangle& triangle);

// This checks what every view must hold.
[[nodiscard]] MirrorOutcome reflected(const AnyMesh& mesh, const std::vector<Panel>& panels, const Camera& camera,
                                      const ReflectionOptions& options = {}, const std::vector<Vector3>& normals = {});

}  // namespace sightline::tests
