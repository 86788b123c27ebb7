#include "peers/errors/parts_in_pixels.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "peers/errors/pixel_areas.h"

namespace sightline::peers {
namespace {

using PartsOfFaces = std::map<FaceId, VisibleParts>;

PartsOfFaces by_face(const VisibleParts& parts) {
  PartsOfFaces faces;
  for (const VisiblePart& part : parts) faces[part.face].push_back(part);
  return faces;
}

}  // namespace

ItemBuffer in_pixels(const VisibleParts& parts, int resolution) {
  ItemBuffer buffer(resolution);
  std::vector<double> most(pixel_count(resolution), 0);
  std::vector<double> nothing(pixel_count(resolution), 1);
  for (const auto& [face, of_face] : by_face(parts)) {
    const FaceId shown = face;
    PixelAreas(resolution, of_face).for_each([&](int column, int row, double area) {
      const std::size_t pixel = pixel_index(column, row, resolution);
      nothing[pixel] -= area;
      if (area > most[pixel]) {
        most[pixel] = area;
        buffer.paint(column, row, shown);
      }
    });
  }
  for (int row = 0; row < resolution; ++row) {
    for (int column = 0; column < resolution; ++column) {
      const std::size_t pixel = pixel_index(column, row, resolution);
      if (nothing[pixel] > 0.5) buffer.paint(column, row, FaceId{});
    }
  }
  return buffer;
}

// With nothing as a label, too, the two cover each pixel once, so what one label has too much another has too little:
// half the sum of all differences has it.
std::vector<float> difference_in_pixels(const VisibleParts& seen, const VisibleParts& exact, int resolution) {
  std::vector<double> differences(pixel_count(resolution), 0);
  std::vector<double> of_nothing(pixel_count(resolution), 0);
  PartsOfFaces faces = by_face(seen);
  for (VisiblePart part : exact) {
    std::reverse(part.ring.begin(), part.ring.end());
    faces[part.face].push_back(std::move(part));
  }
  for (const auto& [face, of_face] : faces) {
    PixelAreas(resolution, of_face).for_each([&](int column, int row, double area) {
      const std::size_t pixel = pixel_index(column, row, resolution);
      differences[pixel] += std::abs(area);
      of_nothing[pixel] += area;
    });
  }
  std::vector<float> wrong(differences.size());
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    wrong[i] = static_cast<float>(std::min(1.0, (differences[i] + std::abs(of_nothing[i])) / 2));
  }
  return wrong;
}

}  // namespace sightline::peers
