#include "formats/reading/mesh_reader.h"

#include "formats/reading/obj_reader.h"

namespace sightline::inline formats {

MeshFile read_mesh(const std::filesystem::path& file, const ReadLimits& limits, Normals normals) {
  return read_obj(file, limits, normals);
}

}  // namespace sightline::inline formats
