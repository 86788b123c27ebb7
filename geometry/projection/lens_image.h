// The image that a lens bends, and the part of the ideal image that it shows.
//
// What a camera sees depends on its eye alone; a lens only moves it about in the image. So a camera with a lens is an ideal
// pinhole, and its frame: the part of the ideal image that the lens brings within the borders of the bent one.
//
// In:  K, the lens, and the bent image's size.
// Out: the frame, a polygon in the window of the ideal pinhole, which is a rectangle around it; and where places of the window
//      come to in the bent image.
// Holds: the polygon's corners are places that the lens brings to the bent image's border, to 1e-9 pixels; between them its sides,
//      bent, are off that border by at most `frame_tolerance` pixels. That is an estimate: twice the largest distance of
//      three places of each side. From there on the polygon is what counts, exactly: its corners are multiples of 2^-48.
//      On a region that has the whole frame in it no two places are bent to one (proven_disc in lens.h).
// Errors: CameraError: the model folds, or the frame reaches 89 degrees or more off the axis.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "geometry/numbers/export.h"
#include "geometry/projection/lens.h"

namespace sightline::inline geometry {

constexpr double default_frame_tolerance = 0.01;  // pixels

// Pixels have x to the right and y down, and begin where K says so.
struct LensImage {
  Lens lens;
  Eigen::Matrix3d k = Eigen::Matrix3d::Identity();  // (x', y', 1) to bent pixels, and (x, y, 1) to ideal ones
  double first = 0;                                 // the bent image's left and upper border
  double width = 0;                                 // of the bent image
  double height = 0;
  double left = 0;  // the window in ideal pixels: its left and upper border, and its size
  double top = 0;
  double window_width = 0;
  double window_height = 0;
  std::vector<Point2> frame;  // in the window, counter-clockwise
  double frame_tolerance = default_frame_tolerance;
};

// camera: its name, for messages. first: -0.5 where pixel (0, 0) is the first pixel's centre, else 0.
[[nodiscard]] LensImage make_lens_image(const std::string& camera, const Eigen::Matrix3d& k, const Lens& lens,
                                        double first, double width, double height, double frame_tolerance);

// Returns the bent pixel at which a place of the window is seen, in floating point.
[[nodiscard]] SIGHTLINE_EXPORT Point2 bent_pixel(const LensImage& image, const Point2& window);

// Returns the places of the window from the first to the second, both included, between which segments, bent, are straight
// to the tolerance in pixels: an estimate, from their middles. In the other direction they are the same places.
[[nodiscard]] SIGHTLINE_EXPORT std::vector<Point2> bent_line(const LensImage& image, const Point2& from,
                                                             const Point2& to, double tolerance);

// Returns the frame's area in the window, whose own is 4.
[[nodiscard]] SIGHTLINE_EXPORT double frame_area(const LensImage& image);

}  // namespace sightline::inline geometry
