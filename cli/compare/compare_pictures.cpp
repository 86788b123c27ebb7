#include "cli/compare/compare_pictures.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "formats/pictures/png_image.h"
#include "geometry/numbers/mix.h"
#include "peers/errors/parts_in_pixels.h"

namespace sightline::cli {

namespace {

constexpr int picture_size = 512;  // of what has no pixels of its own
constexpr int most_pixels = 4096;  // along each side
constexpr Colour paper{255, 255, 255};
constexpr Colour ink{20, 20, 20};

// Light enough for red to stand out on its grey, and neighbours in number far apart.
Colour colour_of(FaceId face) {
  if (!face.valid()) return paper;
  const std::uint64_t bits = mix(face.index() + 1);
  const auto channel = [bits](unsigned shift) { return static_cast<std::uint8_t>(70 + (bits >> shift) % 160); };
  return {channel(0), channel(16), channel(32)};
}

std::uint8_t grey_of(const Colour& colour) {
  const double grey = 0.3 * colour[0] + 0.59 * colour[1] + 0.11 * colour[2];
  return static_cast<std::uint8_t>(150 + 0.4 * grey);
}

Colour reddened(const Colour& colour, float wrong) {
  constexpr std::array<double, 3> red{200, 0, 20};
  const double grey = std::min<double>(grey_of(colour), 255);
  Colour result;
  for (std::size_t i = 0; i < 3; ++i) result.at(i) = static_cast<std::uint8_t>(grey + wrong * (red.at(i) - grey));
  return result;
}

std::string picture(int size, const std::vector<Colour>& colours) { return png_image(size, size, colours); }

// A pixel for each step of the longer axis.
void draw(const peers::VisibleLine& line, std::vector<Colour>& colours) {
  const auto pixel = [](double w) { return (w + 1) / 2 * picture_size; };
  const double x = pixel(line.from.x);
  const double y = pixel(-line.from.y);
  const double dx = pixel(line.to.x) - x;
  const double dy = pixel(-line.to.y) - y;
  const int steps = 1 + static_cast<int>(std::max(std::abs(dx), std::abs(dy)));
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const int column = std::clamp(static_cast<int>(x + t * dx), 0, picture_size - 1);
    const int row = std::clamp(static_cast<int>(y + t * dy), 0, picture_size - 1);
    colours[peers::pixel_index(column, row, picture_size)] = ink;
  }
}

}  // namespace

ComparePictures pictures_of(const peers::ItemBuffer& seen, const std::vector<float>& wrong) {
  if (seen.resolution() > most_pixels) return {};
  std::vector<Colour> faces;
  std::vector<Colour> errors;
  for (int row = 0; row < seen.resolution(); ++row) {
    for (int column = 0; column < seen.resolution(); ++column) {
      faces.push_back(colour_of(seen.at(column, row)));
      errors.push_back(reddened(faces.back(), wrong[errors.size()]));
    }
  }
  return {picture(seen.resolution(), faces), picture(seen.resolution(), errors)};
}

ComparePictures pictures_of(const peers::VisibleParts& seen, const peers::ExactParts& exact) {
  return pictures_of(peers::in_pixels(seen, picture_size),
                     peers::difference_in_pixels(seen, exact.parts, picture_size));
}

ComparePictures pictures_of(const peers::VisibleLines& seen) {
  std::vector<Colour> colours(peers::pixel_count(picture_size), paper);
  for (const peers::VisibleLine& line : seen) draw(line, colours);
  return {picture(picture_size, colours), ""};
}

}  // namespace sightline::cli
