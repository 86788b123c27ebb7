#include "tests/extremes/extreme_scene.h"

#include <algorithm>
#include <stdexcept>

#include "cli/scene/scene_file.h"
#include "formats/reading/obj_reader.h"
#include "geometry/cutting/interpenetration.h"
#include "geometry/projection/clipping.h"
#include "tests/tools/analyzed.h"

namespace sightline::extremes {

ExtremeScene read_extreme(const std::string& name) {
  const cli::SceneDescription scene = cli::read_scene_file(SIGHTLINE_FIXTURES_DIR "/extremes/" + name + ".toml");
  return {read_obj(std::filesystem::path(scene.mesh_file)).mesh, scene.sides, scene.cameras};
}

Sight sight(const tests::AnyMesh& mesh, const Camera& camera, SidesPolicy policy) {
  const MeshContacts contacts = policy == SidesPolicy::automatic ? find_contacts(*mesh) : MeshContacts{};
  const Sides sides = decide_sides(mesh, contacts, camera, policy).sides;
  Sight result{camera, sides, analyzed(mesh, camera, sides), {}};
  const Rational unit(1, boost::multiprecision::cpp_int(1) << static_cast<unsigned>(2 * result.view.scene.grid_bits));
  result.areas = lattice::visible_areas(result.view);
  for (Rational& area : result.areas) area *= unit;
  return result;
}

const Camera& camera_called(const std::vector<Camera>& cameras, std::string_view name) {
  const auto found = std::find_if(cameras.begin(), cameras.end(), [&](const Camera& c) { return c.name == name; });
  if (found == cameras.end()) throw std::invalid_argument("no camera " + std::string(name));
  return *found;
}

const Sight& sight_from(const std::vector<Sight>& sights, std::string_view name) {
  const auto found = std::find_if(sights.begin(), sights.end(), [&](const Sight& s) { return s.camera.name == name; });
  if (found == sights.end()) throw std::invalid_argument("no camera " + std::string(name));
  return *found;
}

Mesh with_faces(const Mesh& mesh, const std::function<bool(FaceId)>& wanted) {
  PolygonList faces;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (wanted(FaceId(f))) faces.push_back(mesh.faces[f]);
  }
  return build_mesh(mesh.vertices, std::move(faces));
}

Rational total(const std::vector<Rational>& areas) {
  Rational sum = 0;
  for (const Rational& area : areas) sum += area;
  return sum;
}

bool is_exact(const tests::AnyMesh& mesh, const Sight& sight) {
  const auto bits = static_cast<unsigned>(sight.view.scene.grid_bits);
  const auto on_grid = [&](const ExactCorner& c) {
    return BigInteger(c.x << bits) % c.w == 0 && BigInteger(c.y << bits) % c.w == 0;
  };
  for (std::size_t f = 0; f < mesh->facet_count(); ++f) {
    if (sight.view.scene.status[f] != FacetStatus::in_view) continue;
    const auto corners = clip(mesh, sight.camera, FacetId(f));
    if (!std::all_of(corners.begin(), corners.end(), on_grid)) return false;
  }
  return true;
}

}  // namespace sightline::extremes
