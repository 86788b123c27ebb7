// Contacts of facets are held against all pairs in rational arithmetic by another method: clipping one facet to the
// other.
#include "geometry/cutting/interpenetration.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <random>
#include <string>

#include <doctest/doctest.h>

#include "formats/reading/obj_reader.h"
#include "geometry/cutting/facet_contact.h"
#include "geometry/mesh/box_hierarchy.h"
#include "tests/geometry/facet_clipping_oracle.h"

namespace sightline::tests::interpenetration_test {
using namespace clipping_oracle;

namespace {

RationalPolygon rational_facet(const Mesh& mesh, FacetId f) {
  RationalPolygon polygon;
  for (const VertexId v : mesh.corners(f)) {
    const Point3& p = mesh.position(v);
    polygon.push_back({Rational(p.x()), Rational(p.y()), Rational(p.z())});
  }
  return polygon;
}

class Generator {
 public:
  explicit Generator(unsigned seed) : random_(seed) {}
  int between(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  Point3 grid_point(int low, int high) {
    const int x = between(low, high);
    const int y = between(low, high);
    return {double(x), double(y), double(between(low, high))};
  }

 private:
  std::mt19937 random_;
};

void add_face(std::vector<Point3>& vertices, PolygonList& faces, const std::vector<Point3>& corners) {
  std::vector<VertexId> ids;
  for (const Point3& p : corners) {
    ids.emplace_back(vertices.size());
    vertices.push_back(p);
  }
  faces.push_back(ids);
}

Mesh mesh_of(const std::vector<std::vector<Point3>>& polygons) {
  std::vector<Point3> vertices;
  PolygonList faces;
  for (const auto& polygon : polygons) add_face(vertices, faces, polygon);
  return build_mesh(std::move(vertices), std::move(faces));
}

// Triangles and parallelograms are on a small grid, some of them in a common plane and some on two corners of another,
// so that they meet in every way.
std::vector<std::vector<Point3>> random_polygons(Generator& random) {
  std::vector<std::vector<Point3>> polygons;
  for (int i = 0; i < 9; ++i) {
    Point3 a = random.grid_point(0, 3);
    Vector3 u = random.grid_point(-2, 2);
    Vector3 v = random.grid_point(-2, 2);
    if (i % 3 == 0) a.z() = u.z() = v.z() = 0;
    if (i % 4 == 3) {
      const auto& other = polygons[static_cast<std::size_t>(random.between(0, i - 1))];
      polygons.push_back({other[0], other[static_cast<std::size_t>(random.between(1, 2))], a});
    } else if (i % 2 == 0) {
      polygons.push_back({a, a + u, a + v});
    } else {
      polygons.push_back({a, a + u, a + u + v, a + v});
    }
  }
  return polygons;
}

ConvexFacet facet_of(const Mesh& mesh, const std::vector<VertexId>& welded, FacetId f) {
  return {mesh, f, std::span(welded).subspan(mesh.facets.begin[f.index()], mesh.corners(f).size())};
}

std::vector<VertexId> welded_corners(const Mesh& mesh) {
  std::vector<VertexId> corners = mesh.facets.corners;
  for (VertexId& v : corners) v = mesh.weld[v.index()];
  return corners;
}

using Pair = std::array<FacetId, 2>;

Contact contact_between(const MeshContacts& contacts, const Pair& pair) {
  const bool crossing = std::binary_search(contacts.crossing.begin(), contacts.crossing.end(), pair);
  const bool touching = std::binary_search(contacts.touching.begin(), contacts.touching.end(), pair);
  REQUIRE_FALSE((crossing && touching));
  return crossing ? Contact::crossing : (touching ? Contact::touching : Contact::none);
}

// Returns the contact of the first two facets.
Contact contact_of_two(const std::vector<Point3>& a, const std::vector<Point3>& b) {
  const Mesh mesh = mesh_of({a, b});
  REQUIRE(mesh.facet_count() == 2);
  return contact_between(find_contacts(mesh), {FacetId(0), FacetId(1)});
}

std::filesystem::path shared_models() {
  const char* variable = std::getenv("SIGHTLINE_SHARED");
#ifdef SIGHTLINE_SHARED_DIR
  return std::filesystem::path(variable != nullptr ? variable : SIGHTLINE_SHARED_DIR) / "models";
#else
  return std::filesystem::path(variable != nullptr ? variable : "") / "models";
#endif
}

// Returns every face as a fan of triangles from its first corner, as the figures of the models suppose.
Mesh fanned(const Mesh& mesh) {
  PolygonList triangles;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.faces[f];
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      triangles.push_back(std::array{corners[0], corners[i], corners[i + 1]});
    }
  }
  return build_mesh(mesh.vertices, std::move(triangles));
}

int shared_corner_count(const Mesh& mesh, const Pair& pair) {
  int count = 0;
  for (const VertexId a : mesh.corners(pair[0])) {
    for (const VertexId b : mesh.corners(pair[1])) count += mesh.weld[a.index()] == mesh.weld[b.index()] ? 1 : 0;
  }
  return count;
}

}  // namespace

TEST_CASE("every pair of random facets meets as clipping in rationals says, in either order") {
  const unsigned seed = 20240611;
  INFO("seed ", seed);
  Generator random(seed);
  std::map<std::string, int> kinds;
  int quadrilaterals = 0;
  for (int scene = 0; scene < 160; ++scene) {
    const Mesh mesh = mesh_of(random_polygons(random));
    const MeshContacts contacts = find_contacts(mesh);
    const auto welded = welded_corners(mesh);
    for (std::size_t i = 0; i < mesh.facet_count(); ++i) {
      const RationalPolygon a = rational_facet(mesh, FacetId(i));
      quadrilaterals += a.size() == 4 ? 1 : 0;
      for (std::size_t j = i + 1; j < mesh.facet_count(); ++j) {
        INFO("scene ", scene, ", facets ", i, " and ", j);
        const RationalPolygon b = rational_facet(mesh, FacetId(j));
        const Contact expected = contact_by_clipping(a, b);
        CHECK(contact_between(contacts, {FacetId(i), FacetId(j)}) == expected);
        CHECK(contact_of(facet_of(mesh, welded, FacetId(j)), facet_of(mesh, welded, FacetId(i))) == expected);
        ++kinds[kind(a, b, expected)];
      }
    }
  }
  CHECK(quadrilaterals > 300);
  for (const char* name :
       {"apart, shared corners: 0", "apart, shared corners: 1", "apart, shared corners: 2",
        "crossing, shared corners: 0", "crossing, shared corners: 1", "touching in one plane, shared corners: 0",
        "touching in one plane, shared corners: 1", "touching in one plane, shared corners: 2",
        "touching, edge on edge", "touching, corner in a facet", "touching, corner on an edge",
        "crossing, along a chord of both"}) {
    INFO(name);
    CHECK(kinds[name] >= 5);
  }
}

TEST_CASE("translation and scaling change no contact, however far from the origin") {
  const unsigned seed = 7;
  INFO("seed ", seed);
  Generator random(seed);
  for (int scene = 0; scene < 40; ++scene) {
    const auto polygons = random_polygons(random);
    const MeshContacts expected = find_contacts(mesh_of(polygons));
    auto far = polygons;
    for (auto& polygon : far) {
      for (Point3& p : polygon) p = 0x1p-30 * (p + Point3{0x1p50, -0x1p49, 0x1p50});
    }
    const MeshContacts moved = find_contacts(mesh_of(far));
    auto tiny = polygons;
    for (auto& polygon : tiny) {
      for (Point3& p : polygon) p = 0x1p-1070 * p;
    }
    const MeshContacts scaled = find_contacts(mesh_of(tiny));
    CHECK(moved.crossing == expected.crossing);
    CHECK(moved.touching == expected.touching);
    CHECK(scaled.crossing == expected.crossing);
    CHECK(scaled.touching == expected.touching);
  }
}

TEST_CASE("facets that share corners") {
  const std::vector<Point3> square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  SUBCASE("a fold of two triangles onto each other overlaps; opened by the smallest angle it does not") {
    CHECK(contact_of_two({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{2, 0, 0}, {0, 0, 0}, {2, 2, 0}}) == Contact::touching);
    CHECK(contact_of_two({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{2, 0, 0}, {0, 0, 0}, {2, 2, 0x1p-1074}}) ==
          Contact::none);
    CHECK(contact_of_two({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{2, 0, 0}, {0, 0, 0}, {2, -2, 0}}) == Contact::none);
  }
  SUBCASE("a triangle on a square's diagonal shares two corners but no edge") {
    CHECK(contact_of_two(square, {{0, 0, 0}, {2, 2, 0}, {1, 1, 1}}) == Contact::touching);
    CHECK(contact_of_two(square, {{0, 0, 0}, {2, 0, 0}, {1, 0, 1}}) == Contact::none);
  }
  SUBCASE("three shared corners in one plane overlap") {
    CHECK(contact_of_two(square, {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}}) == Contact::touching);
  }
  SUBCASE("one shared corner, and a crossing elsewhere") {
    CHECK(contact_of_two(square, {{0, 0, 0}, {1, 1, 1}, {1, 1, -1}}) == Contact::crossing);
    CHECK(contact_of_two(square, {{0, 0, 0}, {-2, 1, 1}, {-2, 1, -1}}) == Contact::none);
  }
}

TEST_CASE("a corner within a straight side is a corner like the others") {
  const std::vector<Point3> split_side{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  CHECK(contact_of_two(split_side, {{1, 0, 0}, {0, 0, 0}, {0, -1, 0}}) == Contact::none);
  CHECK(contact_of_two(split_side, {{2, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, -1, 0}}) == Contact::none);
  CHECK(contact_of_two(split_side, {{2, 0, 0}, {0, 0, 0}, {1, -1, 0}}) == Contact::touching);
  CHECK(contact_of_two(split_side, {{2, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 1}}) == Contact::none);
  CHECK(contact_of_two(split_side, {{2, 0, 0}, {0, 0, 0}, {1, 0, 1}}) == Contact::touching);
}

TEST_CASE("overlapping boxes are found once each, as among all pairs") {
  const unsigned seed = 99;
  INFO("seed ", seed);
  Generator random(seed);
  for (const int count : {0, 1, 2, 5, 300}) {
    std::vector<Box> boxes;
    for (int i = 0; i < count; ++i) {
      const Point3 low = random.grid_point(0, 12);
      boxes.push_back({low, low + random.grid_point(0, 3)});
    }
    std::vector<std::array<std::size_t, 2>> expected;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t j = i + 1; j < boxes.size(); ++j) {
        if (overlap(boxes[i], boxes[j])) expected.push_back({i, j});
      }
    }
    std::vector<std::array<std::size_t, 2>> found;
    for_each_overlapping_pair(build_hierarchy(boxes), [&](std::size_t i, std::size_t j) { found.push_back({i, j}); });
    std::sort(found.begin(), found.end());
    CHECK(found == expected);
    if (count == 300) CHECK(expected.size() > 500);
  }
}

// The figures are X and touch of the models' README, which calls a pair crossing only where an edge of one passes
// through the other's interior, and leaves out pairs that share an edge. Two models are not here,
// openscad-nonmanifold-crash and CornellBox-Mirror: their figures count repeated triangles again, which a mesh has
// once.
TEST_CASE("the models meet themselves as often as their README says") {
  struct Figures {
    const char* name;
    std::size_t crossing;
    std::size_t touching;
  };
  if (!std::filesystem::exists(shared_models())) {
    MESSAGE("no shared models");
    return;
  }
  for (const Figures& figures : {Figures{"teapot", 151, 10},
                                 {"beetle", 49, 7},
                                 {"self_intersectA", 338, 0},
                                 {"featuretype", 0, 1216},
                                 {"spot", 0, 0},
                                 {"suzanne", 90, 0},
                                 {"holodeck", 799, 222},
                                 {"mountain", 0, 0},
                                 {"stanford-bunny", 0, 0},
                                 {"lost_empire", 1668, 5916}}) {
    INFO(figures.name);
    const Mesh mesh = fanned(read_obj(shared_models() / (std::string(figures.name) + ".obj")).mesh);
    const MeshContacts contacts = find_contacts(mesh);
    const auto by_edge = static_cast<std::size_t>(
        std::count_if(contacts.crossing.begin(), contacts.crossing.end(), [&](const Pair& pair) {
          const RationalPolygon a = rational_facet(mesh, pair[0]);
          const RationalPolygon b = rational_facet(mesh, pair[1]);
          return an_edge_crosses(a, b) || an_edge_crosses(b, a);
        }));
    CHECK(by_edge == figures.crossing);
    const auto apart =
        static_cast<std::size_t>(std::count_if(contacts.touching.begin(), contacts.touching.end(),
                                               [&](const Pair& pair) { return shared_corner_count(mesh, pair) < 2; }));
    CHECK(apart + contacts.crossing.size() - by_edge == figures.touching);
  }
}

}  // namespace sightline::tests::interpenetration_test
