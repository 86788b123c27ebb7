#include "formats/writing/window_points.h"

#include "geometry/projection/camera_forms.h"
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

std::vector<Point2> bent_pixels(const Camera& camera, const std::vector<Point2>& places) {
  std::vector<Point2> pixels;
  pixels.reserve(places.size());
  for (const Point2& place : places) pixels.push_back(bent_pixel(*camera.lens_image, place));
  return pixels;
}

Point2 window_place(const Camera& camera, const Point3& p) {
  const CameraPlace<double> place = CameraForms<double>(camera).at(p);
  return {place.x / place.w, place.y / place.w};
}

}  // namespace sightline::inline formats
