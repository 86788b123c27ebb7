// These laws hold on every scene, whatever is in it, on the grid and without rounding: order and handedness change nothing,
// and the refined surface is the surface.
#include <doctest/doctest.h>

#include "oracle/judging/labelled_laws.h"
#include "oracle/judging/scene_changes.h"
#include "tests/tools/analyzed.h"

namespace sightline::tests::laws_test {
using namespace lattice;

namespace {

constexpr std::uint64_t first_seed = 500001;  // not the scenes of the oracle test
constexpr std::uint64_t scenes = 1500;

// Calls law(scene, mesh, precision) on random scenes; it returns its complaints.
template <class Law>
void check_on_random_scenes(Law law, const Precision& precision) {
  CAPTURE(to_string(precision.arithmetic));
  int failures = 0;
  for (std::uint64_t seed = first_seed; seed < first_seed + scene_count(scenes) && failures < 3; ++seed) {
    const auto complaints_of = [&](const RandomScene& scene) {
      try {
        return law(scene, mesh_of(scene), precision);
      } catch (const std::exception& error) {
        return Complaints{error.what()};
      }
    };
    const RandomScene scene = random_scene(seed);
    if (complaints_of(scene).empty()) continue;
    ++failures;
    const RandomScene small = reduced(scene, [&](const RandomScene& s) { return !complaints_of(s).empty(); });
    FAIL_CHECK(joined(complaints_of(small)), to_text(small));
  }
}

template <class Law>
void check_on_random_scenes(Law law) {
  for (const Arithmetic arithmetic : {Arithmetic::exact, Arithmetic::unrounded})
    check_on_random_scenes(law, Precision{arithmetic, default_grid_bits});
}

// The view has everything up to the polygons.
View view_of(const AnyMesh& mesh, const Camera& camera, Sides sides, const Precision& precision) {
  View view;
  view.scene = project(mesh, camera, sides, precision);
  view.segments = find_visible_segments(view.scene, Engine::full);
  view.polygons = reconstruct_polygons(view.scene, view.segments);
  return view;
}

Outcome seen_from(const AnyMesh& mesh, const Camera& camera, Sides sides, const Precision& precision) {
  return outcome(view_of(mesh, camera, sides, precision));
}

}  // namespace

TEST_CASE("law: the order of the faces does not matter where no two overlap in one plane") {
  std::uint64_t tried = 0;
  check_on_random_scenes([&](const RandomScene& scene, const AnyMesh& mesh, const Precision& precision) {
    if (scene.notes.coplanar_overlap) return Complaints{};
    ++tried;
    Dice dice(scene.seed);
    const Shuffled shuffled = with_faces_shuffled(mesh, dice);
    const Outcome after = seen_from(shuffled.mesh, scene.camera, scene.sides, precision);
    Outcome put_back = after;
    for (std::size_t i = 0; i < shuffled.order.size(); ++i) put_back.areas[shuffled.order[i]] = after.areas[i];
    return differences(seen_from(mesh, scene.camera, scene.sides, precision), put_back);
  });
  CHECK(tried * 5 >= 2 * scene_count(scenes));
}

TEST_CASE("law: the corner a face begins with does not matter") {
  check_on_random_scenes([](const RandomScene& scene, const AnyMesh& mesh, const Precision& precision) {
    Dice dice(scene.seed);
    return differences(seen_from(mesh, scene.camera, scene.sides, precision),
                       seen_from(with_corners_rotated(mesh, dice), scene.camera, scene.sides, precision));
  });
}

TEST_CASE("law: the mirrored scene seen by the mirrored camera shows the same") {
  check_on_random_scenes([](const RandomScene& scene, const AnyMesh& mesh, const Precision& precision) {
    return differences(seen_from(mesh, scene.camera, scene.sides, precision),
                       seen_from(mirrored(mesh), mirrored(scene.camera), scene.sides, precision));
  });
}

TEST_CASE("law: a camera turned about its view direction sees the same") {
  check_on_random_scenes([](const RandomScene& scene, const AnyMesh& mesh, const Precision& precision) {
    return differences(seen_from(mesh, scene.camera, scene.sides, precision),
                       seen_from(mesh, rolled(scene.camera), scene.sides, precision));
  });
}

TEST_CASE("law: two runs give the same, bit for bit") {
  check_on_random_scenes([](const RandomScene& scene, const AnyMesh& mesh, const Precision& precision) {
    const bool same = identical(analyzed(mesh, scene.camera, scene.sides, precision),
                                analyzed(mesh, scene.camera, scene.sides, precision));
    return same ? Complaints{} : Complaints{"two runs differ"};
  });
}

TEST_CASE("law: the labelled surface keeps vertices and areas") {
  check_on_random_scenes([](const RandomScene& scene, const AnyMesh& mesh, const Precision& precision) {
    const LabelledMesh labelled = analyzed(mesh, scene.camera, scene.sides, precision).labelled;
    Complaints complaints = input_vertices_kept(mesh, labelled);
    for (const std::string& line : areas_kept(mesh, labelled)) complaints.push_back(line);
    return complaints;
  });
}

TEST_CASE("law: what is labelled as seen covers what the visible polygons cover") {
  // Corners are doubles. They are off by 2^-48 for coordinates below 2^5, a few times that in the image where nothing
  // is nearer than 1/8 to the eye's plane; the outlines of a dozen pieces are shorter than 2^8.
  constexpr double tolerance = 0x1p-32;
  check_on_random_scenes([&](const RandomScene& scene, const AnyMesh& mesh, const Precision& precision) {
    return seen_areas_agree(analyzed(mesh, scene.camera, scene.sides, precision), tolerance);
  });
}

TEST_CASE("law: closed surfaces stay closed, three cubes before each other") {
  const std::vector<Point3> cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                 {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const std::vector<std::vector<std::uint32_t>> squares{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                        {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    INFO("seed ", seed);
    Dice dice(seed);
    RandomScene scene;
    for (int copy = 0; copy < 3; ++copy) {
      const Vector3 step{dice.between(-3, 3) * 0.75, dice.between(-3, 3) * 0.75, copy * 1.5};
      for (const auto& square : squares) {
        scene.faces.push_back(square);
        for (std::uint32_t& c : scene.faces.back()) c += static_cast<std::uint32_t>(scene.vertices.size());
      }
      for (const Point3& p : cube) scene.vertices.push_back(p + step);
    }
    const Mesh mesh = mesh_of(scene);
    REQUIRE(is_closed(mesh));
    ViewPoint from;
    from.eye = {dice.between(-5, 5) + 0.3, dice.between(-5, 5) + 0.1, 9};
    from.target = {0.5, 0.5, 2};
    const Sides sides = seed % 2 == 0 ? Sides::both : Sides::front;
    for (const Arithmetic arithmetic : {Arithmetic::exact, Arithmetic::unrounded}) {
      CAPTURE(to_string(arithmetic));
      const View view =
          analyzed(mesh, perspective_camera("random", from, 30), sides, Precision{arithmetic, default_grid_bits});
      CHECK(joined(complaints_of_stages(view)) == "");
      CHECK(is_closed(view.labelled));
      CHECK(joined(areas_kept(mesh, view.labelled)) == "");
      CHECK(joined(input_vertices_kept(mesh, view.labelled)) == "");
      CHECK(joined(seen_areas_agree(view, 0x1p-36)) == "");
    }
  }
}

}  // namespace sightline::tests::laws_test
