// The scenes of fixtures/extremes are read here; each must hold the same from each of its cameras.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/projection/culling.h"
#include "oracle/judging/judge.h"
#include "tests/tools/analyzed.h"

namespace sightline::extremes {

using lattice::Complaints;

struct ExtremeScene {
  Mesh mesh;
  SidesPolicy sides = SidesPolicy::both;
  std::vector<Camera> cameras;
};

// A sight is what one camera sees.
struct Sight {
  Camera camera;
  Sides sides = Sides::both;
  View view;
  std::vector<Rational> areas;  // visible, per face; in window units squared (the window has 4)
};

[[nodiscard]] ExtremeScene read_extreme(const std::string& name);

// Camera and sides are as the command takes them.
[[nodiscard]] Sight sight(const tests::AnyMesh& mesh, const Camera& camera, SidesPolicy policy);

[[nodiscard]] const Camera& camera_called(const std::vector<Camera>& cameras, std::string_view name);
[[nodiscard]] const Sight& sight_from(const std::vector<Sight>& sights, std::string_view name);

// Returns the faces for which wanted(face) is true, in their order, with all vertices.
[[nodiscard]] Mesh with_faces(const Mesh& mesh, const std::function<bool(FaceId)>& wanted);

[[nodiscard]] Rational total(const std::vector<Rational>& areas);

// Returns whether the image needs no rounding: every corner, clipped ones included, is a grid point, exactly.
[[nodiscard]] bool is_exact(const tests::AnyMesh& mesh, const Sight& sight);

}  // namespace sightline::extremes
