// This measures the errors of an item buffer, and says where they are.
#pragma once

#include <vector>

#include "peers/scene/errors_of_areas.h"
#include "peers/scene/exact_parts.h"

namespace sightline::peers {

struct PixelErrors {
  AreaErrors errors;
  std::vector<float> wrong;  // per pixel, row by row: the part of it that has the wrong face, 0 to 1
};

[[nodiscard]] PixelErrors errors_of(const ItemBuffer& seen, const ExactParts& exact);

}  // namespace sightline::peers
