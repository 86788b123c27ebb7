#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "formats/reading/mtl_reader.h"
#include "formats/reading/obj_reader.h"
#include "fuzz/checks.h"
#include "fuzz/no_files.h"
#include "fuzz/refusal.h"
#include "oracle/judging/judge.h"
#include "sightline/analyzer.h"

namespace sightline::fuzz {
namespace {

// Views of larger meshes would leave the fuzzer few inputs per second.
constexpr std::size_t most_facets = 40;

// Whatever material library the text asks for, it gets itself.
std::optional<MeshFile> read_or_refused(std::string_view text) {
  const std::string name = "input.obj";
  const auto itself = [&](const std::string&) { return std::optional(std::string(text)); };
  try {
    const NoFiles no_files;
    MeshFile file = read_obj(text, name, {}, Normals::passed_over, itself);
    if (NoFiles::was_tried()) throw Finding("a file was opened");
    return file;
  } catch (const InputError& refusal) {
    check_refusal(refusal, text, name);
    return std::nullopt;
  }
}

// Returns whether the scene reaches so far that doubles out there are coarse against what the camera is near to. Points
// that the labelled surface adds on its edges are rounded by as much, and its checker, which follows borders in
// doubles, loses its way.
bool has_coarse_doubles(const Mesh& mesh) {
  constexpr double far = 0x1p20;
  return std::ranges::any_of(mesh.vertices, [](const Point3& p) {
    return std::max({std::fabs(p.x()), std::fabs(p.y()), std::fabs(p.z())}) > far;
  });
}

void check_region(const Region& region) {
  if (region.name.size() > longest_region_name) throw Finding("a region's name is too long");
  if (region_name(region.name) != region.name) throw Finding("a region's name is not text: " + region.name);
}

// A face is in one region of each kind, and in one group or more, in each once.
void check_face(const FaceRegions& regions, FaceId face) {
  std::array<std::size_t, region_kinds.size()> count{};
  std::set<RegionId> seen;
  regions.for_each(face, [&](RegionId id) {
    if (id.index() >= regions.regions.size()) throw Finding("a face is in no region that there is");
    if (!seen.insert(id).second) throw Finding("a face is twice in a region");
    ++count[static_cast<std::size_t>(regions.regions[id.index()].kind)];
  });
  for (const RegionKind kind : region_kinds) {
    const std::size_t found = count[static_cast<std::size_t>(kind)];
    if (found == 0 || (kind != RegionKind::group && found > 1))
      throw Finding("a face is in " + std::to_string(found) + " regions of kind " + to_string(kind));
  }
}

void check_regions(const MeshFile& file) {
  const FaceRegions& regions = file.regions;
  if (regions.face_state.size() != file.mesh.face_count()) throw Finding("regions are not parallel to faces");
  for (const Region& region : regions.regions) check_region(region);
  for (std::size_t f = 0; f < file.mesh.face_count(); ++f) check_face(regions, FaceId(f));
}

// The text as a material library, whether it is named in itself or not.
void check_materials(std::string_view text) {
  try {
    for (const auto& [name, material] : read_mtl(text)) {
      if (region_name(name) != name) throw Finding("a material's name is not text: " + name);
    }
  } catch (const std::length_error&) {
    return;
  }
}

void require_none(const lattice::Complaints& complaints) {
  if (!complaints.empty()) throw Finding(lattice::joined(complaints));
}

}  // namespace

void check_obj(std::string_view bytes) {
  check_materials(bytes);
  const auto file = read_or_refused(bytes);
  if (!file) return;
  check_regions(*file);
  require_none(validate(file->mesh));
  if (file->mesh.facet_count() > most_facets) return;
  const ViewPoint view{{3, 2, 4}, {0, 0, 0}, {0, 1, 0}, 1, {}, {}};
  const Camera camera = perspective_camera("fixed", view, 50);
  lattice::Complaints complaints = lattice::complaints_of_stages(Analyzer(file->mesh).view(camera));
  if (has_coarse_doubles(file->mesh))
    std::erase_if(complaints, [](const std::string& line) { return line.starts_with("labelled: "); });
  require_none(complaints);
}

}  // namespace sightline::fuzz
