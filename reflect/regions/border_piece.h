// A directed piece of the border of a region of the image, with the region to its left.
#pragma once

#include <vector>

#include "reflect/regions/image_place.h"

namespace sightline::inline reflect {

struct BorderPiece {
  ImagePlace start;
  ImagePlace end;
  ImageLine line;  // that it lies on
};
using RegionBorder = std::vector<BorderPiece>;

}  // namespace sightline::inline reflect
