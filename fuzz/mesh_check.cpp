#include <cstdint>
#include <optional>

#include "formats/importing/mesh_import.h"
#include "fuzz/checks.h"
#include "fuzz/no_files.h"
#include "fuzz/refusal.h"

namespace sightline::fuzz {
namespace {

// What a few bytes announce may be large; it is refused at this many bytes.
constexpr std::uint64_t most_memory = std::uint64_t{64} << 20;

std::optional<MeshFile> imported_or_refused(std::string_view bytes, Normals normals) {
  const std::string name = "input.mesh";
  const NoFiles no_files;
  try {
    return import_mesh(bytes, name, {most_memory}, normals);
  } catch (const InputError& refusal) {
    check_refusal(refusal, bytes, name);
    return std::nullopt;
  }
}

}  // namespace

void check_mesh(std::string_view bytes) {
  const auto plain = imported_or_refused(bytes, Normals::passed_over);
  if (plain && !validate(plain->mesh).empty()) throw Finding(validate(plain->mesh).front());
  if (plain && !plain->corner_normals.empty()) throw Finding("normals that nobody asked for");
  const auto with_normals = imported_or_refused(bytes, Normals::read);
  if (!with_normals) return;
  if (!plain) throw Finding("what is refused without normals is read with them");
  if (with_normals->corner_normals.size() != with_normals->mesh.faces.corners.size())
    throw Finding("the normals are not parallel to the corners");
  if (with_normals->mesh.vertices != plain->mesh.vertices) throw Finding("normals move vertices");
}

}  // namespace sightline::fuzz
