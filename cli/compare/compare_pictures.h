// Pictures of what a peer sees and of where it is wrong.
//
// Out: PNG. A colour per face, the same in every picture; where nothing is seen, white. Where a peer is wrong the faces
//      are grey and the wrong part of each pixel is red. Empty: more pixels than a picture should have.
// Complexity: O(pixels), and for visible parts those that their sides run through.
#pragma once

#include <string>

#include "peers/errors/pixel_errors.h"
#include "peers/scene/exact_parts.h"

namespace sightline::cli {

struct ComparePictures {
  std::string seen;
  std::string wrong;
};

[[nodiscard]] ComparePictures pictures_of(const peers::ItemBuffer& seen, const std::vector<float>& wrong);

// Draws visible parts, with pixels of their own.
[[nodiscard]] ComparePictures pictures_of(const peers::VisibleParts& seen, const peers::ExactParts& exact);

// Black on white, in one picture; where they are wrong is not shown.
[[nodiscard]] ComparePictures pictures_of(const peers::VisibleLines& seen);

}  // namespace sightline::cli
