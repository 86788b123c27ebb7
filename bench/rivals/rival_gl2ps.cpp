#include "bench/rivals/rivals.h"

#ifdef SIGHTLINE_BENCH_GL2PS

#include <gl2ps.h>

#include <array>
#include <cstdio>
#include <stdexcept>

#include "cli/system/resources.h"

namespace sightline::bench {
using namespace cli;
namespace {

constexpr GLint pixels = 2048;

GL2PSvertex vertex_at(const Point3& place) {
  const auto pixel = [](double x) { return static_cast<GLfloat>((x + 1) / 2 * pixels); };
  GL2PSvertex vertex{};
  vertex.xyz[0] = pixel(place.x());
  vertex.xyz[1] = pixel(place.y());
  vertex.xyz[2] = static_cast<GLfloat>(place.z());
  vertex.rgba[3] = 1;
  return vertex;
}

void add(const ProjectedTriangle& triangle) {
  std::array<GL2PSvertex, 3> vertices{vertex_at(triangle[0]), vertex_at(triangle[1]), vertex_at(triangle[2])};
  gl2psAddPolyPrimitive(GL2PS_TRIANGLE, 3, vertices.data(), 0, 0, 0, 0, 0, 1, 0, 0, 0);
}

void begin_page(std::FILE* nowhere) {
  std::array<GLint, 4> viewport{0, 0, pixels, pixels};
  const GLint options = GL2PS_OCCLUSION_CULL | GL2PS_NO_OPENGL_CONTEXT | GL2PS_NO_BLENDING | GL2PS_SILENT;
  const GLint begun = gl2psBeginPage("scene", "sightline", viewport.data(), GL2PS_TEX, GL2PS_BSP_SORT, options, GL_RGBA,
                                     0, nullptr, 0, 0, 0, 0, nowhere, "nowhere");
  if (begun != GL2PS_SUCCESS) throw std::runtime_error("gl2ps: the page cannot be begun");
}

}  // namespace

std::optional<double> seconds_of_gl2ps(const std::vector<ProjectedTriangle>& triangles) {
  std::FILE* const nowhere = std::fopen("/dev/null", "w");
  if (nowhere == nullptr) throw std::runtime_error("/dev/null cannot be opened");
  const ProcessorTime watch;
  begin_page(nowhere);
  for (const ProjectedTriangle& triangle : triangles) add(triangle);
  const GLint ended = gl2psEndPage();
  const double seconds = watch.seconds();
  std::fclose(nowhere);
  if (ended != GL2PS_SUCCESS) throw std::runtime_error("gl2ps: the page cannot be ended");
  return seconds;
}

}  // namespace sightline::bench

#else

namespace sightline::bench {

std::optional<double> seconds_of_gl2ps(const std::vector<ProjectedTriangle>& /*triangles*/) { return std::nullopt; }

}  // namespace sightline::bench

#endif
