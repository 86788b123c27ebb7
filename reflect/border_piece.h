// A directed piece of the border of a region of the image, with the region to its left.
#pragma once

#include <vector>

#include "reflect/image_place.h"

namespace sightline {

struct BorderPiece {
  ImagePlace start;
  ImagePlace end;
  ImageLine line;  // that it lies on
};
using RegionBorder = std::vector<BorderPiece>;

}  // namespace sightline
