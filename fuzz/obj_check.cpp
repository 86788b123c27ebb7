#include <algorithm>
#include <cmath>
#include <optional>

#include "formats/reading/obj_reader.h"
#include "fuzz/checks.h"
#include "fuzz/refusal.h"
#include "oracle/judging/judge.h"
#include "sightline/analyzer.h"

namespace sightline::fuzz {
namespace {

// Views of larger meshes would leave the fuzzer few inputs per second.
constexpr std::size_t most_facets = 40;

std::optional<MeshFile> read_or_refused(std::string_view text) {
  const std::string name = "input.obj";
  try {
    return read_obj(text, name);
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

void require_none(const lattice::Complaints& complaints) {
  if (!complaints.empty()) throw Finding(lattice::joined(complaints));
}

}  // namespace

void check_obj(std::string_view bytes) {
  const auto file = read_or_refused(bytes);
  if (!file) return;
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
