#include "peers/painters/painting.h"

#include "peers/errors/pixel_cover.h"

namespace sightline::peers {

Painting paint(const BackToFront& polygons, int resolution) {
  Painting painting{ItemBuffer(resolution)};
  for (const FlatPolygon& polygon : polygons) {
    for_each_covered_pixel(painting.buffer, polygon.corners, [&](int column, int row) {
      painting.buffer.paint(column, row, polygon.face);
      ++painting.pixels_painted;
    });
  }
  return painting;
}

}  // namespace sightline::peers
