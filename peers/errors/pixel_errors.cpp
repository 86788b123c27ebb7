#include "peers/errors/pixel_errors.h"

#include <algorithm>

#include "peers/errors/pixel_areas.h"

namespace sightline::peers {
namespace {

// Returns, of each pixel, what is right: the area of the face that it shows, or, where it shows none, what no face has.
std::vector<double> right_parts(const ItemBuffer& seen, const VisibleParts& exact) {
  std::vector<double> of_face(pixel_count(seen.resolution()), 0);
  std::vector<double> covered(pixel_count(seen.resolution()), 0);
  for (auto first = exact.begin(); first != exact.end();) {
    const FaceId face = first->face;
    const auto last = std::find_if(first, exact.end(), [face](const VisiblePart& part) { return part.face != face; });
    PixelAreas(seen.resolution(), std::span(first, last)).for_each([&](int column, int row, double area) {
      const std::size_t pixel = pixel_index(column, row, seen.resolution());
      covered[pixel] += area;
      if (seen.at(column, row) == face) of_face[pixel] += area;
    });
    first = last;
  }
  for (int row = 0; row < seen.resolution(); ++row) {
    for (int column = 0; column < seen.resolution(); ++column) {
      const std::size_t pixel = pixel_index(column, row, seen.resolution());
      if (!seen.at(column, row).valid()) of_face[pixel] = 1 - covered[pixel];
    }
  }
  return of_face;
}

FaceAreas areas_of(const ItemBuffer& seen) {
  const double pixel = 4.0 / seen.resolution() / seen.resolution();
  FaceAreas areas;
  for (int row = 0; row < seen.resolution(); ++row) {
    for (int column = 0; column < seen.resolution(); ++column) {
      if (seen.at(column, row).valid()) areas[seen.at(column, row)] += pixel;
    }
  }
  return areas;
}

}  // namespace

PixelErrors errors_of(const ItemBuffer& seen, const ExactParts& exact) {
  PixelErrors result{compare_faces(areas_of(seen), exact.areas), {}};
  const std::vector<double> right = right_parts(seen, exact.parts);
  double sum = 0;
  for (const double part : right) {
    const double wrong = std::clamp(1 - part, 0.0, 1.0);
    result.wrong.push_back(static_cast<float>(wrong));
    sum += wrong;
  }
  result.errors.wrong_share = sum / static_cast<double>(right.size());
  return result;
}

}  // namespace sightline::peers
