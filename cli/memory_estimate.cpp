#include "cli/memory_estimate.h"

#include "cli/memory_limit.h"

namespace sightline {

std::uint64_t memory_for_view(const Mesh& mesh, const ProjectedScene& scene) {
  return (std::uint64_t{20} << 20) + 500 * mesh.facet_count() + 500 * scene.edge_count();
}

void require_memory_for_view(const Mesh& mesh, const ProjectedScene& scene, std::uint64_t limit) {
  const std::uint64_t needed = memory_for_view(mesh, scene);
  if (needed > limit) throw MemoryError("camera \"" + scene.camera.name + "\"", needed, limit);
}

}  // namespace sightline
