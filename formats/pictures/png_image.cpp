#include "formats/pictures/png_image.h"

#include <png.h>

#include <stdexcept>

namespace sightline::inline formats {

std::string png_image(int width, int height, std::span<const Colour> colours) {
  ::png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, colours.data(), 0, nullptr) == 0) {
    throw std::runtime_error(std::string("a picture cannot be made: ") + image.message);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace sightline::inline formats
