// Every mesh of the optional folder of models is seen from three cameras, and goes through the stages' checkers, the
// laws, and ray casting.
#include <doctest/doctest.h>

#include "formats/reading/obj_reader.h"
#include "geometry/cutting/interpenetration.h"
#include "oracle/judging/labelled_laws.h"
#include "oracle/judging/ray_caster.h"
#include "oracle/judging/scene_changes.h"
#include "tests/tools/analyzed.h"
#include "tests/tools/model_shots.h"

namespace sightline::tests::models_test {
using namespace lattice;

namespace {

struct RayTally {
  std::size_t on_edge = 0;
  std::size_t seen = 0;
  Complaints complaints;
};

FacetId before_cut(const CutMesh& mesh, FacetId f) { return FacetId(mesh.uncut_facet(f).index()); }

// Returns what the polygons show at a ray, as a face; nothing where they show nothing.
std::vector<FaceId> shown(const View& view, const std::vector<std::size_t>& polygons) {
  std::vector<FaceId> faces;
  for (const std::size_t p : polygons) faces.push_back(view.polygons.polygons[p].face);
  return faces;
}

// `whole` is the mesh before it was cut to what was viewed.
RayTally compare_rays(const Mesh& whole, const View& view) {
  const CutMesh& mesh = view.scene.mesh();
  const auto rays = fixed_rays(view.scene.grid_bits, 1000);
  auto hits = cast(view.scene, rays);
  const auto polygons = polygons_around(view, rays);
  RayTally tally;
  for (std::size_t r = 0; r < rays.size(); ++r) {
    auto& facets = hits[r].facets;
    tally.on_edge += hits[r].on_edge ? 1U : 0U;
    if (hits[r].on_edge) continue;
    for (FacetId& f : facets) f = before_cut(mesh, f);
    if (facets.size() > 1) sort_by_depth(facets, whole, view.scene, rays[r]);
    std::vector<FaceId> expected;
    if (!facets.empty()) expected.push_back(whole.facet_face[facets.front().index()]);
    tally.seen += expected.size();
    if (shown(view, polygons[r]) == expected) continue;
    tally.complaints.push_back("ray " + std::to_string(r) + " at (" + std::to_string(rays[r].x) + ", " +
                               std::to_string(rays[r].y) + ") sees face " +
                               (expected.empty() ? "none" : std::to_string(expected[0].value)) + ", polygons show " +
                               (polygons[r].empty() ? "none" : std::to_string(shown(view, polygons[r])[0].value)) +
                               " of " + std::to_string(polygons[r].size()));
  }
  return tally;
}

// Returns the first few, in one text.
std::string some(Complaints complaints) {
  if (complaints.size() > 10) complaints.resize(10);
  return joined(complaints);
}

void check_stages_and_laws(const Mesh& whole, const View& view, bool closed) {
  CHECK(some(complaints_of_stages(view)) == "");
  CHECK(some(input_vertices_kept(whole, view.labelled)) == "");
  CHECK(some(areas_kept(whole, view.labelled)) == "");
  if (closed) CHECK(is_closed(view.labelled));
}

}  // namespace

TEST_CASE("models: stages, laws and ray casting from three cameras") {
  if (models().empty()) MESSAGE("no models in " << models_folder().string());
  for (const std::filesystem::path& file : models()) {
    const Mesh whole = read_obj(file).mesh;
    const CutMesh mesh = cut(whole);
    const bool closed = is_closed(whole);
    for (const Shot& shot : shots(whole)) {
      INFO(file.filename().string(), " ", shot.camera.name);
      View view;
      REQUIRE_NOTHROW(view = analyzed(mesh, shot.camera, shot.sides));
      check_stages_and_laws(whole, view, closed);
      const RayTally tally = compare_rays(whole, view);
      CHECK(some(tally.complaints) == "");
      CHECK(tally.on_edge <= 10);
      CHECK(tally.seen >= 50);
      MESSAGE(file.filename().string() << " " << shot.camera.name << ": " << tally.seen << " rays see a face, "
                                       << tally.on_edge << " on an edge");
    }
  }
}

// Returns the outcome with the faces in another order, put back into the old one.
Outcome shuffled_outcome(const PolygonMesh& mesh, const Shot& shot, Dice& dice, const Precision& precision = {}) {
  const Shuffled shuffled = with_faces_shuffled(mesh, dice);
  const Outcome after = outcome(analyzed(shuffled.mesh, shot.camera, shot.sides, precision));
  Outcome put_back = after;
  for (std::size_t i = 0; i < shuffled.order.size(); ++i) put_back.areas[shuffled.order[i]] = after.areas[i];
  return put_back;
}

TEST_CASE("models: two runs, order and handedness change nothing") {
  constexpr std::uint64_t seed = 7;
  Dice dice(seed);
  for (const std::filesystem::path& file : models()) {
    const Mesh whole = read_obj(file).mesh;
    const CutMesh mesh = cut(whole);
    const Shot shot = shots(whole).front();
    INFO(file.filename().string(), " seed ", seed);
    const View view = analyzed(mesh, shot.camera, shot.sides);
    CHECK(identical(view, analyzed(mesh, shot.camera, shot.sides)));
    // Where faces overlap in one plane the lower index is in front. Where a facet is cut beyond a common line depends
    // on the coordinates, so mirroring changes roundings.
    const MeshContacts contacts = find_contacts(whole);
    if (!contacts.crossing.empty()) continue;
    const Outcome before = outcome(view);
    if (contacts.touching.empty()) CHECK(some(differences(before, shuffled_outcome(mesh, shot, dice))) == "");
    const Mesh turned = with_corners_rotated(mesh, dice);
    CHECK(some(differences(before, outcome(analyzed(turned, shot.camera, shot.sides)))) == "");
    const Mesh mirror = mirrored(mesh);
    CHECK(some(differences(before, outcome(analyzed(mirror, mirrored(shot.camera), shot.sides)))) == "");
  }
}

// Of faces that repeat each other the first is kept.
bool has_skipped_face(const Mesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.first_facet(FaceId(f)) == mesh.end_facet(FaceId(f))) return true;
  }
  return false;
}

// They are not cut. Areas are compared as rationals, which takes long for large ones.
TEST_CASE("models without rounding: stages, laws; two runs, order and handedness change nothing") {
  constexpr std::uint64_t seed = 7;
  constexpr Precision unrounded{Arithmetic::unrounded, default_grid_bits};
  constexpr std::size_t most_facets_compared = 10000;
  Dice dice(seed);
  for (const std::filesystem::path& file : models()) {
    const Mesh mesh = read_obj(file).mesh;
    const Shot shot = shots(mesh).front();
    INFO(file.filename().string(), " seed ", seed);
    const View view = analyzed(mesh, shot.camera, shot.sides, unrounded);
    check_stages_and_laws(mesh, view, is_closed(mesh));
    CHECK(identical(view, analyzed(mesh, shot.camera, shot.sides, unrounded)));
    if (mesh.facet_count() > most_facets_compared) continue;
    const Outcome before = outcome(view);
    const MeshContacts contacts = find_contacts(mesh);
    if (contacts.touching.empty() && !has_skipped_face(mesh))
      CHECK(some(differences(before, shuffled_outcome(mesh, shot, dice, unrounded))) == "");
    const Mesh turned = with_corners_rotated(mesh, dice);
    CHECK(some(differences(before, outcome(analyzed(turned, shot.camera, shot.sides, unrounded)))) == "");
    const Mesh mirror = mirrored(mesh);
    CHECK(some(differences(before, outcome(analyzed(mirror, mirrored(shot.camera), shot.sides, unrounded)))) == "");
  }
}

TEST_CASE("models: where back-facing faces may be culled, culling changes nothing") {
  int culled = 0;
  for (const std::filesystem::path& file : models()) {
    const Mesh mesh = read_obj(file).mesh;
    const MeshContacts contacts = find_contacts(mesh);
    for (const Shot& shot : shots(mesh)) {
      if (decide_sides(uncrossed(mesh), contacts, shot.camera, SidesPolicy::automatic).sides == Sides::both) continue;
      ++culled;
      INFO(file.filename().string(), " ", shot.camera.name);
      const View front = analyzed(mesh, shot.camera, Sides::front);
      const View both = analyzed(mesh, shot.camera, Sides::both);
      CHECK(visible_areas(front) == visible_areas(both));
    }
  }
  CHECK((culled > 0 || models().empty()));
}

}  // namespace sightline::tests::models_test
