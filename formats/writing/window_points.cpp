#include "formats/writing/window_points.h"

#include "sweep/segments/image_points.h"

namespace sightline::inline formats {

std::vector<Point2> window_points(const View& view) {
  const ImagePoints points(view.scene, view.segments);
  const std::size_t count = view.scene.points.size() + view.segments.crossings.size();
  std::vector<Point2> places;
  places.reserve(count);
  for (std::size_t p = 0; p < count; ++p) places.push_back(points.in_window(PointId(p)));
  return places;
}

Point2 window_place(const Camera& camera, const Point3& p) {
  const Vector3 from_origin = p - camera.origin;
  const double depth = camera.projection == Projection::perspective ? camera.forward.dot(from_origin) : 1;
  return {camera.right.dot(from_origin) / depth, camera.up.dot(from_origin) / depth};
}

}  // namespace sightline::inline formats
