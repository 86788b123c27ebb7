// This tests which sides count: every way in which a mesh may fail to be a closed solid, and every place of the eye.
#include "geometry/projection/culling.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>

#include <doctest/doctest.h>

#include "formats/reading/obj_reader.h"
#include "geometry/mesh/components.h"

namespace sightline::tests::culling_test {
namespace {

struct Solid {
  std::vector<Point3> vertices;
  std::vector<std::vector<std::size_t>> faces;
};

// Returns the box [low, high], its faces counter-clockwise seen from outside.
Solid box(const Point3& low, const Point3& high) {
  Solid solid;
  for (int i = 0; i < 8; ++i) {
    solid.vertices.push_back(
        {(i & 1) ? high.x() : low.x(), (i & 2) ? high.y() : low.y(), (i & 4) ? high.z() : low.z()});
  }
  solid.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return solid;
}

Solid unit_cube() { return box({0, 0, 0}, {1, 1, 1}); }

Solid inverted(Solid solid) {
  for (auto& face : solid.faces) std::reverse(face.begin(), face.end());
  return solid;
}

Solid together(Solid a, const Solid& b) {
  const std::size_t offset = a.vertices.size();
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (auto face : b.faces) {
    for (std::size_t& corner : face) corner += offset;
    a.faces.push_back(face);
  }
  return a;
}

// Returns an L in the x-y plane, of height 1: [0, 2]^2 without (1, 2]^2.
Solid l_shape() {
  const std::vector<Point2> outline{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  Solid solid;
  for (const double z : {0.0, 1.0}) {
    for (const Point2& p : outline) solid.vertices.push_back({p.x, p.y, z});
  }
  solid.faces = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
  for (std::size_t i = 0; i < 6; ++i) solid.faces.push_back({i, (i + 1) % 6, 6 + (i + 1) % 6, 6 + i});
  return solid;
}

Mesh mesh_of(const Solid& solid) {
  PolygonList faces;
  for (const auto& face : solid.faces) {
    std::vector<VertexId> corners;
    for (const std::size_t corner : face) corners.emplace_back(corner);
    faces.push_back(corners);
  }
  return build_mesh(solid.vertices, std::move(faces));
}

Camera camera_at(const HomogeneousPoint& eye) {
  Camera camera;
  camera.eye = eye;
  return camera;
}

SidesDecision decide(const Mesh& mesh, const HomogeneousPoint& eye, SidesPolicy policy = SidesPolicy::automatic) {
  return decide_sides(uncrossed(mesh), find_contacts(mesh), camera_at(eye), policy);
}

std::string reason_for(const Solid& solid, const Point3& eye) {
  const SidesDecision decision = decide(mesh_of(solid), {eye, 1});
  CHECK((decision.sides == Sides::both) == decision.reason.starts_with("both sides: "));
  return decision.reason;
}

bool culls(const Solid& solid, const HomogeneousPoint& eye) {
  return decide(mesh_of(solid), eye).sides == Sides::front;
}

std::vector<FacetId> all_facets(const Mesh& mesh) {
  std::vector<FacetId> facets;
  for (std::size_t f = 0; f < mesh.facet_count(); ++f) facets.emplace_back(f);
  return facets;
}

Location location_in(const Solid& solid, const Point3& p) {
  const Mesh mesh = mesh_of(solid);
  return location_of(p, mesh, all_facets(mesh));
}

std::filesystem::path shared_model(const std::string& name) {
  const char* variable = std::getenv("SIGHTLINE_SHARED");
#ifdef SIGHTLINE_SHARED_DIR
  const std::filesystem::path folder = variable != nullptr ? variable : SIGHTLINE_SHARED_DIR;
#else
  const std::filesystem::path folder = variable != nullptr ? variable : "";
#endif
  return folder / "models" / (name + ".obj");
}

const Point3 far_eye{5, 7, 9};

}  // namespace

TEST_CASE("what is asked for is done") {
  const Mesh mesh = mesh_of(inverted(unit_cube()));
  CHECK(decide(mesh, {far_eye, 1}, SidesPolicy::front).sides == Sides::front);
  CHECK(decide(mesh_of(unit_cube()), {far_eye, 1}, SidesPolicy::both).sides == Sides::both);
}

TEST_CASE("a closed solid is culled where the eye is outside") {
  CHECK(culls(unit_cube(), {far_eye, 1}));
  CHECK(reason_for(unit_cube(), {0.5, 0.25, 0.75}) == "both sides: the eye is inside the surface of face 0");
  CHECK(reason_for(unit_cube(), {1, 0.5, 0.5}) == "both sides: the eye is on the surface of face 0");
  CHECK(reason_for(unit_cube(), {1, 1, 0.5}) == "both sides: the eye is on the surface of face 0");
  CHECK(reason_for(unit_cube(), {1, 1, 1}) == "both sides: the eye is on the surface of face 0");
  CHECK(culls(unit_cube(), {{1 + 0x1p-52, 0.5, 0.5}, 1}));
}

TEST_CASE("the eye of an orthographic camera is outside") {
  CHECK(culls(unit_cube(), {{0, 0, 1}, 0}));
  CHECK(culls(unit_cube(), {{0.5, 0.5, 0.5}, 0}));
  CHECK_FALSE(culls(inverted(unit_cube()), {{0, 0, 1}, 0}));
}

TEST_CASE("a surface that is not closed and oriented is not culled") {
  Solid open = unit_cube();
  open.faces.pop_back();
  CHECK(reason_for(open, far_eye).ends_with(" has one facet"));

  Solid flipped = unit_cube();
  std::reverse(flipped.faces[0].begin(), flipped.faces[0].end());
  CHECK(reason_for(flipped, far_eye).ends_with(" has two facets that run along it in one direction"));

  Solid fin = unit_cube();
  fin.vertices.push_back({-1, -1, 0.5});
  fin.faces.push_back({0, 4, 8});
  CHECK(reason_for(fin, far_eye).starts_with("both sides: edge "));
  CHECK_FALSE(culls(fin, {{0, 0, 1}, 0}));

  CHECK(reason_for(inverted(unit_cube()), far_eye) == "both sides: the surface of face 0 is inside out");
}

TEST_CASE("several surfaces") {
  const Solid inner = box({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
  CHECK(culls(together(unit_cube(), inner), {far_eye, 1}));
  CHECK(reason_for(together(unit_cube(), inverted(inner)), far_eye) ==
        "both sides: the surface of face 6 is inside out");
  CHECK(reason_for(together(inner, unit_cube()), {0.125, 0.5, 0.5}) ==
        "both sides: the eye is inside the surface of face 6");
  CHECK(reason_for(together(unit_cube(), box({0.5, 0.5, 1}, {2, 2, 2})), far_eye) == "both sides: faces 1 and 6 touch");
  CHECK(reason_for(together(unit_cube(), box({0.5, 0.5, 0.5}, {2, 2, 2})), far_eye) ==
        "both sides: faces 1 and 8 cross");
  CHECK(culls(together(unit_cube(), box({1, 1, 1}, {2, 2, 2})), {far_eye, 1}));
  CHECK(reason_for(together(unit_cube(), box({1, 1, 0}, {2, 2, 1})), far_eye) == "both sides: edge 3-7 has 4 facets");
}

TEST_CASE("an edge's facets count, the shared corner of two surfaces does not connect them") {
  CHECK(components(mesh_of(unit_cube())).size() == 1);
  const auto parts = components(mesh_of(together(unit_cube(), box({1, 1, 1}, {2, 2, 2}))));
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].size() == 6);
  CHECK(parts[1].front() == FacetId(6));
}

TEST_CASE("the eye in the bounding box, but not in the solid") {
  CHECK(culls(l_shape(), {{1.5, 1.5, 0.5}, 1}));
  CHECK(culls(l_shape(), {{1.5, 1.5, 0}, 1}));
  CHECK(culls(l_shape(), {{1 + 0x1p-52, 1 + 0x1p-52, 1}, 1}));
  CHECK(reason_for(l_shape(), {1.5, 0.5, 0.5}).starts_with("both sides: the eye is inside"));
  CHECK(reason_for(l_shape(), {1.5, 1, 0.5}).starts_with("both sides: the eye is on"));
}

TEST_CASE("inside, outside, on: every point of a grid over the L, most of whose first rays meet edges") {
  const auto within = [](double x, double low, double high) { return low <= x && x <= high; };
  const auto strictly = [](double x, double low, double high) { return low < x && x < high; };
  int on_surface = 0;
  int inside = 0;
  for (double x = -0.5; x <= 2.5; x += 0.25) {
    for (double y = -0.5; y <= 2.5; y += 0.25) {
      for (double z = -0.5; z <= 1.5; z += 0.25) {
        INFO(x, " ", y, " ", z);
        const bool closed = within(z, 0, 1) && within(x, 0, 2) && within(y, 0, 2) && (x <= 1 || y <= 1);
        const bool open = strictly(z, 0, 1) && strictly(x, 0, 2) && strictly(y, 0, 2) && (x < 1 || y < 1);
        const Location expected = open ? Location::inside : (closed ? Location::on_surface : Location::outside);
        CHECK(location_in(l_shape(), {x, y, z}) == expected);
        on_surface += expected == Location::on_surface ? 1 : 0;
        inside += open ? 1 : 0;
      }
    }
  }
  CHECK(on_surface > 100);
  CHECK(inside > 50);
}

TEST_CASE("a near plane may cut a closed surface open") {
  const Mesh mesh = mesh_of(unit_cube());
  Camera camera = camera_at({{5, 5, 5}, 1});
  CHECK(decide_sides(uncrossed(mesh), find_contacts(mesh), camera, SidesPolicy::automatic).sides == Sides::front);
  camera.near_distance = 1;
  CHECK(decide_sides(uncrossed(mesh), find_contacts(mesh), camera, SidesPolicy::automatic).sides == Sides::both);
}

TEST_CASE("the sign of a volume is exact, far from the origin, tiny or huge") {
  for (const double size : {1.0, 0x1p-40, 0x1p-1074, 0x1p900}) {
    const Mesh mesh = mesh_of(box({0, 0, 0}, {size, size, size}));
    CHECK(volume_sign(mesh, all_facets(mesh)) == 1);
    const Mesh inside_out = mesh_of(inverted(box({0, 0, 0}, {size, size, size})));
    CHECK(volume_sign(inside_out, all_facets(inside_out)) == -1);
  }
  const Mesh far = mesh_of(box({0x1p50, 0x1p50, 0x1p50}, {0x1p50 + 1, 0x1p50 + 1, 0x1p50 + 1}));
  CHECK(volume_sign(far, all_facets(far)) == 1);
}

// A tent and the same tent with its top moved by one last bit, inside out, stand on one base that neither has: together
// they are a closed sheet whose volume is a sixth of that bit.
TEST_CASE("a volume of one last bit has the right sign") {
  for (const double height : {1 - 0x1p-53, 1 + 0x1p-52}) {
    const Solid sheet{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.7, 1}, {0.3, 0.7, height}},
                      {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}}};
    const Mesh mesh = mesh_of(sheet);
    CHECK(volume_sign(mesh, all_facets(mesh)) == (height < 1 ? 1 : -1));
  }
}

TEST_CASE("a closed sheet in one plane has no volume, whatever rounding says") {
  std::mt19937_64 random(7);
  const auto odd = [&] { return static_cast<double>((random() >> 24U) | 1U); };
  for (int sheet = 0; sheet < 50; ++sheet) {
    CAPTURE(sheet);
    const Vector3 u{odd(), odd(), odd()};
    const Vector3 v{odd(), -odd(), odd()};
    const Point3 o{odd(), odd(), -odd()};
    const auto at = [&](double s, double t) -> Vector3 { return o + s * u + t * v; };
    const Solid solid{{at(0, 0), at(7, 0), at(0, 7), at(1, 2), at(3, 1)},
                      {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}}};
    const Mesh mesh = mesh_of(solid);
    CHECK(volume_sign(mesh, all_facets(mesh)) == 0);
  }
}

TEST_CASE("closed models are culled from outside, and not from inside or when they cross themselves") {
  for (const char* name : {"spot", "armadillo", "lion_vase_poly", "self_intersectA", "mountain"}) {
    INFO(name);
    if (!std::filesystem::exists(shared_model(name))) {
      MESSAGE("no shared models");
      return;
    }
    const Mesh mesh = read_obj(shared_model(name)).mesh;
    const MeshContacts contacts = find_contacts(mesh);
    const SidesDecision decision =
        decide_sides(uncrossed(mesh), contacts, camera_at({{300, 200, 500}, 1}), SidesPolicy::automatic);
    INFO(decision.reason);
    const std::string model = name;
    if (model == "self_intersectA") {
      CHECK(decision.reason.ends_with(" cross"));
    } else if (model == "mountain") {
      CHECK(decision.reason.ends_with(" has one facet"));
    } else {
      CHECK(decision.sides == Sides::front);
    }
  }
}

}  // namespace sightline::tests::culling_test
