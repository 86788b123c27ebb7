#include "fuzz/checks.h"
#include "fuzz/chosen_scene.h"
#include "tests/oracle/facet_crossing.h"
#include "tests/oracle/judge.h"

namespace sightline::fuzz {
namespace {

bool any_facets_cross(const Mesh& mesh) {
  for (std::size_t a = 0; a < mesh.facet_count(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (oracle::facets_cross(mesh, FacetId(a), FacetId(b))) return true;
    }
  }
  return false;
}

// Whether every image, clipped, has its corners on the oracle's grid.
bool is_on_the_grid(const Mesh& mesh, const oracle::RandomScene& scene) {
  try {
    return oracle::oracle_faces(mesh, scene.camera, scene.sides).size() <= mesh.facet_count();
  } catch (const std::logic_error&) {
    return false;
  }
}

}  // namespace

void check_sweep(std::string_view bytes) {
  const oracle::RandomScene scene = chosen_scene(bytes);
  const Mesh mesh = oracle::mesh_of(scene);
  const bool comparable = !any_facets_cross(mesh) && is_on_the_grid(mesh, scene);
  const oracle::Complaints complaints =
      comparable ? oracle::judge(scene).complaints
                 : oracle::complaints_of_stages(mesh, analyze(mesh, scene.camera, scene.sides));
  if (!complaints.empty()) throw Finding(oracle::joined(complaints) + oracle::to_text(scene));
}

}  // namespace sightline::fuzz
