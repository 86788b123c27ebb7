// Faces that are coplanar by design, and by the last digits of their corners are not: where they are snapped, what is seen, and
// what reflects, is what the design says, in every pose.
#include <doctest/doctest.h>

#include <random>

#include "formats/reading/obj_reader.h"
#include "geometry/cutting/coincidence.h"
#include "geometry/cutting/snapped_planes.h"
#include "oracle/truth/truth.h"
#include "sightline/analyzer.h"
#include "tests/tools/model_shots.h"
#include "tests/tools/polygon_mesh.h"
#include "tests/tools/unrounded_areas.h"

namespace sightline::tests::snapped_faces_test {
namespace {

constexpr unsigned seed = 20261201;

struct Pose {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Vector3 by = Vector3::Zero();

  [[nodiscard]] Point3 operator()(const Point3& p) const { return turn * p + by; }
  [[nodiscard]] Corners operator()(Corners corners) const {
    for (Point3& p : corners) p = (*this)(p);
    return corners;
  }
};

Pose random_pose(std::mt19937& random) {
  std::uniform_real_distribution<double> any(-1, 1);
  const Eigen::Quaterniond q(any(random), any(random), any(random), any(random));
  return {q.normalized().toRotationMatrix(), {any(random), 3 * any(random), any(random)}};
}

struct Scene {
  std::vector<Corners> faces;
  Point3 eye;
  bool is_orthographic = false;
  std::vector<Corners> panels;
  bool has_lens = false;
};

Camera lens_camera(const Point3& eye, const Pose& pose) {
  const Vector3 along = unit(Vector3(-eye));
  const Vector3 right = unit(along.cross(Vector3(0, 1, 0)));
  Matrix3 k;
  k << 300, 0, 330, 0, 310, 230, 0, 0, 1;
  CameraPose from;
  from.rotation << right.transpose(), along.cross(right).transpose(), along.transpose();
  from.rotation = Matrix3(from.rotation * pose.turn.transpose());
  from.eye = pose(eye);
  return posed_camera("camera", k, from, {640, 480}, {LensModel::brown, {-0.2, 0.02, 0, 0, 0, 0}, {0.001, -0.002}}, 1);
}

Camera camera_of(const Scene& scene, const Pose& pose) {
  if (scene.has_lens) return lens_camera(scene.eye, pose);
  ViewPoint from;
  from.eye = pose(scene.eye);
  from.target = pose(Point3::Zero());
  from.up = pose.turn * Vector3(0.1, 1, 0.2);
  return scene.is_orthographic ? orthographic_camera("camera", from, 6) : perspective_camera("camera", from, 60);
}

struct Seen {
  std::vector<double> visible;     // per face, in the image
  std::vector<double> reflecting;  // the same, of all panels
};

Seen seen(const Scene& scene, const Pose& pose, const AnalysisOptions& options) {
  std::vector<Corners> faces;
  for (const Corners& face : scene.faces) faces.push_back(pose(face));
  std::vector<Panel> panels;
  for (const Corners& corners : scene.panels)
    panels.push_back({"panel " + std::to_string(panels.size()), pose(corners)});
  const View view = Analyzer(mesh_of(faces), options).view(camera_of(scene, pose), panels);
  Seen result{std::vector<double>(faces.size()), std::vector<double>(faces.size())};
  for (const VisiblePolygon& polygon : view.polygons.polygons) result.visible[polygon.face.index()] += polygon.area;
  for (const PanelReflection& panel : view.reflections.panels) {
    for (const VisiblePolygon& polygon : panel.polygons.polygons)
      result.reflecting[polygon.face.index()] += polygon.area;
  }
  return result;
}

AnalysisOptions options_of(SidesPolicy sides, bool snaps, Engine engine = Engine::fast) {
  AnalysisOptions options;
  options.sides = sides;
  options.engine = engine;
  options.reflection.snaps = snaps;
  return options;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::fabs(a[i] - b[i]));
  return largest;
}

Corners turned(Corners corners) {
  std::ranges::reverse(corners);
  return corners;
}

const Corners wall{{-3, -2, 0}, {3, -2, 0}, {3, 2, 0}, {-3, 2, 0}};
const Corners window{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
const Corners window_over_the_edge{{2, -1, 0}, {4, -1, 0}, {4, 1, 0}, {2, 1, 0}};
const Corners room{{-6, -6, -2}, {6, -6, -2}, {6, 6, -2}, {-6, 6, -2}};
// It goes through the wall and the window.
const Corners blade{{0, -3, -1}, {0.5, 3, -1}, {0.25, 0, 1}};
const Corners lamp{{-9, 3, 4}, {9, 3, 4}, {9, 8, 6}, {-9, 8, 6}};

// Corners on whole numbers: rectangles in two planes, either way round, one on the other; and triangles through them.
Scene random_scene(std::mt19937& random) {
  const auto between = [&random](int low, int high) {
    return static_cast<double>(low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1)));
  };
  Scene scene;
  for (int i = 0; i < 7; ++i) {
    const double x = between(-3, 2);
    const double y = between(-3, 2);
    const double right = between(static_cast<int>(x) + 1, 3);
    const double top = between(static_cast<int>(y) + 1, 3);
    const double z = i < 5 ? 0 : 1;
    Corners face{{x, y, z}, {right, y, z}, {right, top, z}, {x, top, z}};
    scene.faces.push_back(random() % 2 == 0 ? face : turned(face));
  }
  while (scene.faces.size() < 10) {
    Corners face;
    for (int i = 0; i < 3; ++i) face.emplace_back(between(-3, 3), between(-3, 3), between(-2, 3));
    const Vector3 across = (face[1] - face[0]).cross(face[2] - face[0]);
    if (across.head<2>().norm() > 0) scene.faces.push_back(face);
  }
  std::shuffle(scene.faces.begin(), scene.faces.end(), random);
  scene.eye = {between(-4, 4) + 0.3, between(-4, 4) + 0.1, random() % 2 == 0 ? 7.7 : -7.7};
  scene.is_orthographic = random() % 3 == 0;
  scene.panels = {lamp, turned(lamp)};
  return scene;
}

// Checks that what is snapped is seen, and reflects, in a pose as it does upright, with both engines. Returns whether what is not
// snapped is seen otherwise.
bool is_wrong_without(const Scene& scene, const Pose& pose, SidesPolicy sides, const Seen& upright) {
  const Seen snapped = seen(scene, pose, options_of(sides, true));
  CHECK(largest_difference(snapped.visible, upright.visible) < 1e-9);
  CHECK(largest_difference(snapped.reflecting, upright.reflecting) < 1e-9);
  const Seen full = seen(scene, pose, options_of(sides, true, Engine::full));
  CHECK(full.visible == snapped.visible);
  CHECK(full.reflecting == snapped.reflecting);
  const Seen as_written = seen(scene, pose, options_of(sides, false));
  return largest_difference(as_written.visible, upright.visible) > 1e-3;
}

}  // namespace

TEST_CASE("a window in its wall is seen, and reflects, as designed in every pose") {
  std::mt19937 random(seed);
  INFO("seed ", seed);
  std::size_t wrong_without = 0;
  for (const Corners& part : {window, window_over_the_edge}) {
    for (const std::vector<Corners>& faces : {std::vector{part, wall}, std::vector{wall, part},
                                              std::vector{turned(part), wall}, std::vector{wall, turned(part)}}) {
      Scene scene{faces, {2, 3, 8}, false, {lamp}};
      scene.faces.push_back(room);
      scene.faces.push_back(blade);
      for (const SidesPolicy sides : {SidesPolicy::front, SidesPolicy::both}) {
        for (const double height : {8.0, -1.5}) {
          scene.eye.z() = height;
          const Seen upright = seen(scene, {}, options_of(sides, false));
          for (int i = 0; i < 6; ++i) {
            wrong_without += is_wrong_without(scene, random_pose(random), sides, upright) ? 1 : 0;
          }
        }
      }
    }
  }
  MESSAGE(wrong_without << " views of 192 are wrong as written");
  CHECK(wrong_without > 20);
}

TEST_CASE("a window in its wall hides nothing that the wall mirrors, in any mode") {
  std::mt19937 random(seed + 4);
  INFO("seed ", seed + 4);
  double reflecting = 0;
  for (const ReflectionMode mode : {ReflectionMode::exact, ReflectionMode::smooth, ReflectionMode::triangles}) {
    for (const std::vector<Corners>& faces : {std::vector{window, wall}, std::vector{wall, window}}) {
      const Scene scene{faces, {0, -6, 3}, false, {lamp}};
      AnalysisOptions options = options_of(SidesPolicy::both, true);
      options.reflection.mode = mode;
      const Seen upright = seen(scene, {}, options);
      const double area = upright.reflecting[0] + upright.reflecting[1];
      const double bound = mode == ReflectionMode::smooth ? options.reflection.tolerance * area : 1e-9;
      reflecting += area;
      for (int i = 0; i < 10; ++i) {
        CAPTURE(i);
        const Seen snapped = seen(scene, random_pose(random), options);
        CHECK(largest_difference(snapped.reflecting, upright.reflecting) < bound);
      }
    }
  }
  MESSAGE("reflecting " << reflecting);
  CHECK(reflecting > 0.1);
}

TEST_CASE("a window in its wall is seen as designed behind a lens") {
  std::mt19937 random(seed + 5);
  INFO("seed ", seed + 5);
  const Scene scene{{wall, window, room, blade}, {0, -6, 3}, false, {lamp}, true};
  const Seen upright = seen(scene, {}, options_of(SidesPolicy::both, false));
  CHECK(upright.visible[1] < upright.visible[0]);
  CHECK(upright.reflecting[0] > 0.001);
  std::size_t wrong_without = 0;
  for (int i = 0; i < 10; ++i) {
    CAPTURE(i);
    const Pose pose = random_pose(random);
    const Seen snapped = seen(scene, pose, options_of(SidesPolicy::both, true));
    // The frame's corners are found in the camera's own numbers.
    CHECK(largest_difference(snapped.visible, upright.visible) < 1e-6);
    CHECK(largest_difference(snapped.reflecting, upright.reflecting) < 1e-6);
    const Seen as_written = seen(scene, pose, options_of(SidesPolicy::both, false));
    wrong_without += largest_difference(as_written.visible, upright.visible) > 1e-3 ? 1 : 0;
  }
  CHECK(wrong_without > 2);
}

// Between the planes of both, or nearer to them than the distance, an eye sees nothing that a design would say; but whatever it sees,
// it sees with both engines.
TEST_CASE("an eye in or next to the plane of what is snapped sees the same with both engines") {
  std::mt19937 random(seed + 6);
  INFO("seed ", seed + 6);
  std::uniform_real_distribution<double> any(-1, 1);
  std::size_t edge_on = 0;
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    Scene scene{{wall, window, room, blade}, {}, i % 3 == 0, {lamp}};
    for (Point3& p : scene.faces[1]) p += 1e-9 * Vector3(any(random), any(random), any(random));
    scene.eye = {5 * any(random), -4 + any(random), std::pow(10.0, -11 + 3 * any(random)) * any(random)};
    const Pose pose = i % 2 == 0 ? Pose{} : random_pose(random);
    const SidesPolicy sides = i % 4 < 2 ? SidesPolicy::front : SidesPolicy::both;
    const Seen fast = seen(scene, pose, options_of(sides, true));
    const Seen full = seen(scene, pose, options_of(sides, true, Engine::full));
    CHECK(fast.visible == full.visible);
    CHECK(fast.reflecting == full.reflecting);
    edge_on += fast.visible[1] == 0 ? 1 : 0;
  }
  CHECK(edge_on > 50);
  CHECK(edge_on < 200);
}

TEST_CASE("rectangles on each other, and triangles through them, are seen as designed in every pose") {
  std::mt19937 random(seed + 1);
  INFO("seed ", seed + 1);
  std::size_t wrong_without = 0;
  for (int i = 0; i < 40; ++i) {
    CAPTURE(i);
    const Scene scene = random_scene(random);
    const SidesPolicy sides = i % 2 == 0 ? SidesPolicy::front : SidesPolicy::both;
    const Seen upright = seen(scene, {}, options_of(sides, false));
    for (int turn = 0; turn < 4; ++turn) {
      wrong_without += is_wrong_without(scene, random_pose(random), sides, upright) ? 1 : 0;
    }
  }
  MESSAGE(wrong_without << " views of 160 are wrong as written");
  CHECK(wrong_without > 40);
}

namespace {

// Boxes on whole numbers that stand on, in and beside each other, closed; each corner of a box moved with it by so much at most.
Scene random_boxes(std::mt19937& random, double play) {
  std::uniform_real_distribution<double> any(-1, 1);
  const auto between = [&random](int low, int high) {
    return static_cast<double>(low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1)));
  };
  Scene scene;
  for (int box = 0; box < 5; ++box) {
    const Vector3 by = play * Vector3(any(random), any(random), any(random));
    const Point3 low = Point3(between(-2, 1), between(-2, 1), between(-2, 1)) + by;
    const Vector3 size(between(1, 3), between(1, 3), between(1, 3));
    const auto corner = [&](int x, int y, int z) {
      return Point3(low + Vector3(x * size.x(), y * size.y(), z * size.z()));
    };
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        Corners face;
        for (const auto& [u, v] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
          std::array<int, 3> at{};
          at[static_cast<std::size_t>(axis)] = side;
          at[static_cast<std::size_t>((axis + 1) % 3)] = u;
          at[static_cast<std::size_t>((axis + 2) % 3)] = v;
          face.push_back(corner(at[0], at[1], at[2]));
        }
        scene.faces.push_back(side == 1 ? face : turned(face));
      }
    }
  }
  scene.eye = {7 * any(random), 7 * any(random), random() % 2 == 0 ? 7.7 : -7.7};
  scene.is_orthographic = random() % 3 == 0;
  scene.panels = {lamp, turned(lamp)};
  return scene;
}

}  // namespace

TEST_CASE("boxes on, in and beside each other are seen as designed in every pose, their edges with them") {
  std::mt19937 random(seed + 2);
  INFO("seed ", seed + 2);
  std::size_t wrong_without = 0;
  for (int i = 0; i < 24; ++i) {
    CAPTURE(i);
    const Scene scene = random_boxes(random, 0);
    const SidesPolicy sides = i % 2 == 0 ? SidesPolicy::front : SidesPolicy::both;
    const Seen upright = seen(scene, {}, options_of(sides, false));
    for (int turn = 0; turn < 4; ++turn) {
      wrong_without += is_wrong_without(scene, random_pose(random), sides, upright) ? 1 : 0;
    }
  }
  MESSAGE(wrong_without << " views of 96 are wrong as written");
  CHECK(wrong_without > 24);
}

// The tolerance is a user's: what is farther apart than rounding takes it may be meant to be coplanar, too.
TEST_CASE("boxes with play are seen as designed where the distance says that play is none") {
  constexpr double play = 1e-5;
  std::mt19937 random(seed + 3);
  INFO("seed ", seed + 3);
  std::size_t wrong_without = 0;
  for (int i = 0; i < 60; ++i) {
    CAPTURE(i);
    std::mt19937 twin = random;
    const Scene designed = random_boxes(twin, 0);
    const Scene scene = random_boxes(random, play);
    AnalysisOptions options = options_of(i % 2 == 0 ? SidesPolicy::front : SidesPolicy::both, true);
    options.reflection.coincidence = play;  // of a size of 2 at least
    const Seen upright = seen(designed, {}, options_of(options.sides, false));
    const Pose pose = random_pose(random);
    const Seen snapped = seen(scene, pose, options);
    CHECK(largest_difference(snapped.visible, upright.visible) < 40 * play);
    options.engine = Engine::full;
    CHECK(seen(scene, pose, options).visible == snapped.visible);
    const Seen as_written = seen(scene, pose, options_of(options.sides, false));
    wrong_without += largest_difference(as_written.visible, upright.visible) > 0.01 ? 1 : 0;
  }
  MESSAGE(wrong_without << " views of 60 are wrong as written");
  CHECK(wrong_without > 10);
}

namespace {

// Faces in three planes, each off it by as much as the distance allows, and others through all of them.
std::vector<Corners> random_layers(std::mt19937& random, double off) {
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<Corners> faces;
  for (int i = 0; i < 9; ++i) {
    Corners face;
    const Vector3 slope(0.3 * (i % 3) - 0.2, 0.1 * (i % 3), 0);
    for (int corner = 0; corner < 3; ++corner) {
      const Vector3 at(3 * any(random), 3 * any(random), 0);
      face.push_back(at + Vector3(0, 0, at.dot(slope) + i % 3 + off * any(random)));
    }
    faces.push_back(face);
  }
  for (int i = 0; i < 3; ++i) {
    Corners face;
    for (int corner = 0; corner < 3; ++corner) face.emplace_back(3 * any(random), 3 * any(random), 3 * any(random));
    faces.push_back(face);
  }
  return faces;
}

}  // namespace

TEST_CASE("what is snapped is seen as rationals have it, with depths in the planes that it has") {
  std::mt19937 random(seed + 7);
  INFO("seed ", seed + 7);
  std::uniform_real_distribution<double> any(-1, 1);
  std::size_t snapped = 0;
  std::size_t along_swaps = 0;
  std::size_t differing = 0;
  for (int i = 0; i < 80; ++i) {
    CAPTURE(i);
    const double off = std::pow(10.0, -3.0 - i % 10);
    const Mesh mesh = mesh_of(random_layers(random, off));
    CutMesh with_planes = uncrossed(mesh);
    with_planes.snapped_to = snapped_planes(with_planes, 4 * off);
    std::vector<FacetId> planes;
    for (const UncutFacetId plane : with_planes.snapped_to) planes.emplace_back(plane.index());
    for (std::size_t f = 0; f < planes.size(); ++f) snapped += planes[f].index() != f ? 1 : 0;
    const Scene scene{
        {}, {4 * any(random), 4 * any(random), random() % 4 == 0 ? 1.0 : 8 * any(random)}, i % 3 == 0, {}};
    const Camera camera = camera_of(scene, {});
    const Sides sides = random() % 2 == 0 ? Sides::front : Sides::both;
    const UnroundedAreas seen = unrounded_areas(with_planes, camera, sides);
    along_swaps += seen.along_swaps;
    CHECK(seen.of_face == oracle::true_visibility(mesh, camera, sides, planes).visible_area);
    differing += seen.of_face != oracle::true_visibility(mesh, camera, sides).visible_area ? 1 : 0;
  }
  MESSAGE(snapped << " facets are snapped, " << along_swaps << " segments along swap edges, " << differing
                  << " views differ from the faces as written");
  CHECK(snapped > 160);
  CHECK(along_swaps > 160);
  CHECK(differing > 25);
}

// Boxes that were put together in a program that keeps six digits, if the models are there.
TEST_CASE("a real assembly is seen alike however it is turned, where its faces are snapped") {
  const std::filesystem::path file = models_folder() / "box_assembly.obj";
  if (!std::filesystem::exists(file)) return;
  std::mt19937 random(seed + 8);
  INFO("seed ", seed + 8);
  const Mesh mesh = read_obj(file).mesh;
  Scene scene;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    scene.faces.emplace_back();
    for (const VertexId v : mesh.faces[f]) scene.faces.back().push_back(mesh.position(v));
  }
  Point3 middle = Point3::Zero();
  for (const Point3& p : mesh.vertices) middle += p / static_cast<double>(mesh.vertices.size());
  for (Corners& face : scene.faces) {
    for (Point3& p : face) p -= middle;
  }
  scene.eye = size_of(mesh) * Vector3(0.6, 0.5, 0.6);
  const auto seen_by = [&](const Pose& pose, bool snaps) {
    return seen(scene, pose, options_of(SidesPolicy::both, snaps)).visible;
  };
  const std::vector<double> upright = seen_by({}, true);
  for (int turn = 0; turn < 3; ++turn) {
    const Pose pose = random_pose(random);
    CHECK(largest_difference(seen_by(pose, true), upright) < 1e-12);
    CHECK(largest_difference(seen_by(pose, false), upright) > 1e-6);
  }
}

}  // namespace sightline::tests::snapped_faces_test
