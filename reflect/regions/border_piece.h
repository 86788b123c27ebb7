// The border of a region of the image consists of directed pieces, which have the region to their left.
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
