// A view of nothing is said to be one, with where the mesh is; and so is a P whose sign is in doubt.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "cli/results/view_doubts.h"
#include "geometry/mesh/mesh.h"
#include "sightline/analyzer.h"
#include "tests/tools/command_runner.h"

namespace sightline::tests::view_doubts_test {
using namespace cli;

namespace {

// A square around (0, 0, z), seen from +z.
Mesh square_at(const std::vector<double>& heights) {
  std::vector<Point3> vertices;
  PolygonList faces;
  for (const double z : heights) {
    const VertexId first(vertices.size());
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) vertices.push_back({1.0 * x, 1.0 * y, z});
    faces.push_back(std::array{first, VertexId(first.value + 1), VertexId(first.value + 2), VertexId(first.value + 3)});
  }
  return build_mesh(std::move(vertices), std::move(faces));
}

std::vector<ViewDoubt> doubts(const Mesh& mesh, const Camera& camera, SidesPolicy sides = SidesPolicy::both) {
  const View view = Analyzer(mesh, {.sides = sides}).view(camera);
  InView in_view;
  for (const LabelledTriangle& triangle : view.labelled.triangles) {
    in_view.front = in_view.front || triangle.label == Label::visible || triangle.label == Label::hidden;
    in_view.area = in_view.area || in_view.front || triangle.seen;
    in_view.any_back = in_view.any_back || triangle.label == Label::back_facing;
  }
  return doubts_about_view(view, in_view);
}

void check_doubt(const std::vector<ViewDoubt>& found, const std::string& brief, const std::string& full) {
  REQUIRE(found.size() == 1);
  INFO(found[0].full);
  CHECK(found[0].brief.find(brief) != std::string::npos);
  CHECK(found[0].brief.size() <= 60);
  CHECK(found[0].full.find(full) != std::string::npos);
}

Camera from(const Point3& eye, const Point3& target, std::optional<double> near_distance = std::nullopt,
            std::optional<double> far_distance = std::nullopt) {
  ViewPoint view;
  view.eye = eye;
  view.target = target;
  view.near_distance = near_distance;
  view.far_distance = far_distance;
  return perspective_camera("c", view, 40);
}

}  // namespace

TEST_CASE("where the mesh is, is said of every view of nothing, and of no other") {
  const Mesh mesh = square_at({0});
  CHECK(doubts(mesh, from({0, 0, 8}, {0, 0, 0})).empty());
  check_doubt(doubts(mesh, from({0, 0, 8}, {0, 0, 16})), "the mesh is behind the camera",
              "from (-1, -1, -8) to (1, 1, -8), behind the camera; exchange eye and target");
  check_doubt(doubts(mesh, from({0, 0, 8}, {0, 0, 0}, 9)), "nearer than near", "near is 9");
  check_doubt(doubts(mesh, from({0, 0, 8}, {0, 0, 0}, 1, 2)), "beyond far", "far is 2");
  check_doubt(doubts(mesh, from({9, 0, 8}, {9, 0, 0})), "left of the view", "from (-10, -1, 8) to (-8, 1, 8)");
  check_doubt(doubts(mesh, from({-9, 0, 8}, {-9, 0, 0})), "right of the view", "look at the camera's axes");
  check_doubt(doubts(mesh, from({0, -9, 8}, {0, -9, 0})), "above the view", "");
  check_doubt(doubts(mesh, from({0, 9, 8}, {0, 9, 0})), "below the view", "");
  check_doubt(doubts(mesh, from({0, 0, 0.5}, {9, 0, 0.5})), "beside the view", "from (-0.5, -1, -1) to (-0.5, 1, 1)");
}

// One is far left of the view, the other one far right.
TEST_CASE("backs that are beside the view are not in it") {
  const Mesh mesh = build_mesh({{50, -1, 0}, {51, -1, 0}, {51, 1, 0}, {-50, -1, 0}, {-51, -1, 0}, {-51, 1, 0}}, [] {
    PolygonList faces;
    faces.push_back(std::array{VertexId(2), VertexId(1), VertexId(0)});
    faces.push_back(std::array{VertexId(3), VertexId(4), VertexId(5)});
    return faces;
  }());
  check_doubt(doubts(mesh, from({0, 0, 5}, {0, 0, 0})), "the mesh is beside the view", "nothing is in view");
}

TEST_CASE("faces that all turn their backs are said to do so") {
  check_doubt(doubts(square_at({0}), from({0, 0, -8}, {0, 0, 0}), SidesPolicy::front), "turn their backs",
              "set sides = \"both\"");
  check_doubt(doubts(square_at({0}), from({0, 0, -8}, {0, 0, -16}), SidesPolicy::front), "behind the camera", "");
}

TEST_CASE("a P that may have been meant with the other sign is said to") {
  const PixelImage image{640, 480};
  const Matrix34 p{{512, 0, -320, 1280}, {0, -512, -240, 960}, {0, 0, -1, 4}};
  Matrix34 upwards = p;
  upwards.row(1) = 480 * p.row(2) - p.row(1);
  const auto camera = [&](const Matrix34& matrix) { return projection_matrix_camera("p", matrix, image); };
  CHECK(doubts(square_at({0}), camera(p)).empty());
  check_doubt(doubts(square_at({0}), camera(-p)), "opposite sign", "give -P");
  check_doubt(doubts(square_at({0, 9}), camera(p)), "both sides of the image plane of P",
              "from z = -5 to 4: P and -P see different ones, and P was taken as it is");
  const auto beyond = doubts(square_at({0, 9}), camera(upwards));
  REQUIRE(beyond.size() == 2);
  CHECK(beyond[0].brief == "all faces in view turn their backs");
  CHECK(beyond[1].full.find("both sides of the image plane of P") != std::string::npos);
  CHECK(beyond[1].full.find("as -P") != std::string::npos);
  const auto turned = doubts(square_at({0}), camera(upwards));
  REQUIRE(turned.size() == 2);
  CHECK(turned[0].full.find("image_y = \"up\"") != std::string::npos);
  PixelImage up = image;
  up.y = ImageY::up;
  CHECK(doubts(square_at({0}), projection_matrix_camera("p", upwards, up)).empty());
}

TEST_CASE("the command says so in its summary and in the report") {
  const TemporaryFolder folder;
  folder.file("a.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\n");
  const std::string scene = folder.file("scene.toml",
                                        "[mesh]\nfile = \"a.obj\"\n[[camera]]\nname = \"away\"\neye = [0, 0, 5]\n"
                                        "target = [0, 0, 9]\nfov_y_deg = 40\n[[camera]]\nname = \"p\"\n"
                                        "P = [[-512, 0, 320, -1280], [0, 512, 240, -960], [0, 0, 1, -4]]\n"
                                        "image = [640, 480]\n");
  const RunResult run = run_sightline({"analyze", scene, "-o", (folder.path() / "out").string()});
  REQUIRE_MESSAGE(run.exit_code == 0, run.err);
  CHECK(run.out.find("3 warnings: see \"warnings\" in report.json\n"
                     "  away: nothing is in view: the mesh is behind the camera\n"
                     "  p: P was taken with the opposite sign\n") != std::string::npos);
  const auto report = nlohmann::json::parse(read_text(folder.path() / "out" / "p" / "report.json"));
  CHECK(report["camera"]["matrix_sign"] == -1);
  CHECK(report["warnings"].size() == 2);
}

}  // namespace sightline::tests::view_doubts_test
