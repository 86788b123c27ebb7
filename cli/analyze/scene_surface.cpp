#include "cli/analyze/scene_surface.h"

#include <fmt/format.h>

#include "cli/system/resources.h"
#include "formats/importing/mesh_import.h"
#include "formats/reading/assembly.h"
#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

std::vector<MeshPart> read_parts(const SceneDescription& scene, Normals normals, const ReadLimits& limits,
                                 Progress& progress) {
  std::vector<MeshPart> parts;
  for (const SceneMesh& mesh : scene.meshes) {
    progress.stage("read " + mesh.file);
    parts.push_back(
        {mesh.file, mesh.name, mesh.placement, import_mesh(std::filesystem::path(mesh.file), limits, normals)});
  }
  return parts;
}

std::vector<ScenePart> places_of(const std::vector<MeshPart>& parts) {
  std::vector<ScenePart> places;
  std::size_t first = 0;
  for (const MeshPart& part : parts) {
    places.push_back({part.file_name, part.name, first, part.file.mesh.face_count()});
    first += part.file.mesh.face_count();
  }
  return places;
}

// Faces mirror that are called so, or made so; where nothing is said, all do.
FaceMask mirrors_of(const FaceRegions& regions, const SceneDescription& scene) {
  FaceMask mask;
  if (scene.regions.mirrors) mask = faces_of(regions, *scene.regions.mirrors, scene.file);
  if (!scene.regions.mirrors_material) return mask;
  const FaceMask made = faces_of(regions, *scene.regions.mirrors_material, scene.file);
  mask.resize(made.size(), 0);
  for (std::size_t f = 0; f < made.size(); ++f) mask[f] |= made[f];
  return mask;
}

void require_any_left(const RegionChoice& chosen, const FaceMask& faces, const FaceMask& ignored,
                      const std::string& scene_file) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (faces[f] != 0 && ignored[f] == 0) return;
  }
  throw InputError(
      scene_file, chosen.line,
      fmt::format("'{}': all of its faces are ignored, too; take them out of one of both, or leave '{}' out",
                  chosen.key, chosen.key));
}

}  // namespace

MeshInput read_surface(const SceneDescription& scene, Normals normals, std::uint64_t max_memory, Progress& progress) {
  const Stopwatch watch;
  std::vector<MeshPart> parts = read_parts(scene, normals, {max_memory}, progress);
  MeshInput input;
  input.parts = places_of(parts);
  MeshFile all = assembled(std::move(parts), {max_memory});
  if (scene.regions.of_interest) input.of_interest = faces_of(all.regions, *scene.regions.of_interest, scene.file);
  input.mirror_faces = mirrors_of(all.regions, scene);
  if (scene.regions.ignore) {
    const FaceMask ignored = faces_of(all.regions, *scene.regions.ignore, scene.file);
    if (scene.regions.of_interest) require_any_left(*scene.regions.of_interest, input.of_interest, ignored, scene.file);
    if (scene.regions.mirrors) require_any_left(*scene.regions.mirrors, input.mirror_faces, ignored, scene.file);
    all = without_faces(std::move(all), ignored);
  }
  static_cast<MeshFile&>(input) = std::move(all);
  input.read_seconds = watch.seconds();
  return input;
}

}  // namespace sightline::cli
