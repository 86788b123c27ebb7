#include "bench/rivals/rivals.h"

#ifdef SIGHTLINE_BENCH_TINYOBJLOADER

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <stdexcept>

#include "cli/system/resources.h"

namespace sightline::bench {

std::optional<double> seconds_to_parse(const std::filesystem::path& obj) {
  const cli::ProcessorTime watch;
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning;
  std::string error;
  if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, obj.c_str())) {
    throw std::runtime_error("tinyobjloader: " + error);
  }
  return watch.seconds();
}

}  // namespace sightline::bench

#else

namespace sightline::bench {

std::optional<double> seconds_to_parse(const std::filesystem::path& /*obj*/) { return std::nullopt; }

}  // namespace sightline::bench

#endif
