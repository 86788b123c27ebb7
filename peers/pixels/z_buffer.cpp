#include "peers/pixels/z_buffer.h"

#include <limits>

#include "peers/errors/pixel_cover.h"

namespace sightline::peers {
namespace {

Outcome paint_nearest(const FlatScene& scene, int resolution) {
  ItemBuffer framebuffer(resolution);
  std::vector<double> z_buffer(pixel_count(resolution), std::numeric_limits<double>::infinity());
  std::uint64_t touched = 0;
  std::uint64_t painted = 0;
  for (const FlatPolygon& polygon : scene.polygons) {
    for_each_covered_pixel(framebuffer, polygon.corners, [&](int column, int row) {
      const double pz = polygon.plane.at(framebuffer.x_of(column), framebuffer.y_of(row));
      double& z = z_buffer[pixel_index(column, row, resolution)];
      ++touched;
      if (!(pz < z)) return;
      z = pz;
      framebuffer.paint(column, row, polygon.face);
      ++painted;
    });
  }
  return {std::move(framebuffer), {{"pixels touched", touched}, {"pixels painted", painted}}};
}

}  // namespace

Peer z_buffer() {
  return {
      "z-buffer",
      "Z-buffer (depth buffer)",
      "slides 001, \"Z-buffer algorithm\"; slides 004, \"Depth-Buffer Method\"",
      ComputedAt::image_precision,
      "Keeps, beside the face of each pixel, the depth that was painted there. The polygons come in any order; each is "
      "converted to pixels, scan line by scan line, and takes over a pixel where its own depth at the centre is less "
      "than the one stored. Nothing is sorted, and no polygon is compared with another.",
      "It decides at the centres of pixels only, as ray casting does, with the same steps along every edge and the "
      "same "
      "losses of what falls between centres. Pixels of hidden polygons are computed, too, and painted over later: the "
      "two counts show how many. On graphics hardware a depth has 24 or 32 bits, and faces that lie close behind each "
      "other mix; here it is a double, which leaves such errors only to faces that touch.",
      paint_nearest};
}

}  // namespace sightline::peers
