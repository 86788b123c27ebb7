#include "formats/reading/assembly.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "geometry/numbers/errors.h"

namespace sightline::inline formats {

namespace {

bool names_objects(const FaceRegions& regions) {
  return std::ranges::any_of(regions.regions,
                             [](const Region& r) { return r.kind == RegionKind::object && !r.name.empty(); });
}

// Says of all regions of a file which mesh they are in.
void name_mesh(FaceRegions& regions, const std::string& mesh) {
  const bool has_objects = names_objects(regions);
  for (Region& region : regions.regions) {
    region.mesh = mesh;
    if (region.kind == RegionKind::mesh || (region.kind == RegionKind::object && !has_objects)) region.name = mesh;
  }
}

void append(FaceRegions& all, FaceRegions part) {
  const auto first_region = static_cast<std::uint32_t>(all.regions.size());
  const auto first_group = static_cast<std::uint32_t>(all.groups.size());
  const auto first_state = static_cast<std::uint32_t>(all.states.size());
  const auto moved = [&](RegionId region) { return RegionId(region.index() + first_region); };
  std::ranges::move(part.regions, std::back_inserter(all.regions));
  std::ranges::transform(part.groups, std::back_inserter(all.groups), moved);
  for (FaceRegions::State state : part.states) {
    std::ranges::transform(state.single, state.single.begin(), moved);
    state.first_group += first_group;
    all.states.push_back(state);
  }
  for (const std::uint32_t state : part.face_state) all.face_state.push_back(state + first_state);
}

// What is gathered before there is a mesh of it.
struct Gathered {
  std::vector<Point3> vertices;
  PolygonList faces;
  MeshFile rest;  // without a mesh
  std::set<std::pair<std::uint32_t, Defect>> known_defects;
  std::vector<std::size_t> first_face;  // per part
};

void require_room(const Gathered& all, const MeshPart& part, const ReadLimits& limits) {
  const Mesh& mesh = part.file.mesh;
  const std::uint64_t vertices = all.vertices.size() + mesh.vertices.size();
  const std::uint64_t corners = all.faces.corners.size() + mesh.faces.corners.size();
  if (std::max(vertices, corners) > std::numeric_limits<std::uint32_t>::max())
    throw InputError(part.file_name, 0,
                     "all meshes together have more than 4294967295 vertices or corners; leave some out");
  const std::uint64_t needed = memory_for_mesh(vertices, corners, all.faces.size() + mesh.faces.size());
  if (needed > limits.memory)
    throw InputError(part.file_name, 0,
                     "all meshes up to this one need about " + std::to_string(needed) +
                         " bytes of memory, and the limit is " + std::to_string(limits.memory) +
                         "; raise it with --max-memory");
}

// Corners without normals have zeros where other meshes have some.
void add_normals(Gathered& all, std::vector<Vector3> normals) {
  if (normals.empty() && all.rest.corner_normals.empty()) return;
  all.rest.corner_normals.resize(all.faces.corners.size(), Vector3::Zero());
  std::ranges::copy(normals, all.rest.corner_normals.end() - static_cast<std::ptrdiff_t>(normals.size()));
}

void add(Gathered& all, MeshPart part) {
  Mesh& mesh = part.file.mesh;
  try {
    place(part.placement, mesh.vertices, mesh.faces, part.file.corner_normals);
  } catch (const PlacementError& error) {
    throw PlacementError(part.file_name + ": " + error.what());
  }
  const std::size_t first_vertex = all.vertices.size();
  const std::size_t first_face = all.faces.size();
  all.first_face.push_back(first_face);
  all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
  std::vector<VertexId> corners;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    corners.clear();
    for (const VertexId v : mesh.faces[f]) corners.emplace_back(v.index() + first_vertex);
    all.faces.push_back(corners);
  }
  add_normals(all, std::move(part.file.corner_normals));
  for (const FaceDefect& d : mesh.defects)
    all.known_defects.emplace(static_cast<std::uint32_t>(d.face.index() + first_face), d.defect);
  if (part.file.regions.empty()) part.file.regions = unnamed_regions(mesh.faces.size());
  name_mesh(part.file.regions, part.name);
  append(all.rest.regions, std::move(part.file.regions));
  std::ranges::move(part.file.warnings, std::back_inserter(all.rest.warnings));
}

std::string numbers_of(const std::vector<std::size_t>& faces) {
  std::string text;
  for (std::size_t i = 0; i < faces.size() && i < 10; ++i) text += (i == 0 ? "" : ", ") + std::to_string(faces[i]);
  return text + (faces.size() > 10 ? ", ..." : "");
}

// Warns of what is no face, or was mended, once all meshes are in their places.
void warn_about_new_defects(const Gathered& all, const std::vector<std::string>& names, MeshFile& result) {
  std::map<std::pair<std::size_t, Defect>, std::vector<std::size_t>> found;
  for (const FaceDefect& d : result.mesh.defects) {
    if (all.known_defects.contains({d.face.value, d.defect})) continue;
    const auto after = std::ranges::upper_bound(all.first_face, d.face.index());
    found[{static_cast<std::size_t>(after - all.first_face.begin()) - 1, d.defect}].push_back(d.face.index());
  }
  for (const auto& [key, faces] : found) {
    const char* const done = is_skipped(key.second) ? " skipped in the scene (" : " mended in the scene (";
    result.warnings.push_back(names[key.first] + ": " + std::to_string(faces.size()) +
                              (faces.size() == 1 ? " face" : " faces") + done + to_string(key.second) +
                              "), by the scene's numbers: " + numbers_of(faces));
  }
}

bool stays_as_it_is(const std::vector<MeshPart>& parts) {
  return parts.size() == 1 && parts[0].name.empty() && parts[0].placement.changes_nothing();
}

// Keeps of what is parallel to the corners what belongs to faces that stay.
std::vector<Vector3> kept_normals(const PolygonList& faces, const std::vector<Vector3>& normals,
                                  const std::vector<std::uint8_t>& left_out) {
  std::vector<Vector3> kept;
  if (normals.empty()) return kept;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (left_out[f] != 0) continue;
    kept.insert(kept.end(), normals.begin() + faces.begin[f], normals.begin() + faces.begin[f + 1]);
  }
  return kept;
}

}  // namespace

MeshFile assembled(std::vector<MeshPart> parts, const ReadLimits& limits) {
  if (stays_as_it_is(parts)) return std::move(parts[0].file);
  Gathered all;
  std::vector<std::string> names;
  for (MeshPart& part : parts) {
    require_room(all, part, limits);
    names.push_back(part.file_name);
    add(all, std::move(part));
  }
  MeshFile result = std::move(all.rest);
  result.mesh = build_mesh(std::move(all.vertices), std::move(all.faces));
  warn_about_new_defects(all, names, result);
  return result;
}

MeshFile without_faces(MeshFile mesh, const std::vector<std::uint8_t>& left_out) {
  if (std::ranges::count(left_out, 0) == std::ranges::ssize(left_out)) return mesh;
  PolygonList faces;
  for (std::size_t f = 0; f < mesh.mesh.faces.size(); ++f)
    faces.push_back(left_out[f] != 0 ? std::span<const VertexId>() : mesh.mesh.faces[f]);
  mesh.corner_normals = kept_normals(mesh.mesh.faces, mesh.corner_normals, left_out);
  mesh.mesh = build_mesh(std::move(mesh.mesh.vertices), std::move(faces));
  if (mesh.mesh.facet_count() == 0) mesh.warnings.emplace_back("the scene is empty: every face is left out");
  return mesh;
}

}  // namespace sightline::inline formats
