// A peer: another algorithm that answers the question that sightline answers, to be compared with it.
//
// Each has a file of its own with a function that returns its Peer. A peer gets a flat scene and says what is seen,
// and how much work that was in its own terms. Image-precision peers look at resolution x resolution pixels.
// Errors: RefusedScene where a peer cannot work on a scene at all; what() says why in a sentence.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/numbers/errors.h"
#include "peers/scene/flat_scene.h"
#include "peers/scene/seen.h"

namespace sightline::peers {

class RefusedScene : public Error {
  using Error::Error;
};

// Visibility is decided at a precision: each pixel's, or that of the numbers that objects are given in.
enum class ComputedAt : std::uint8_t { image_precision, object_precision };

// A count says how much there was of something that the algorithm works on: "pixels touched", "pairs tested", "nodes",
// "splits".
struct Count {
  std::string what;
  std::uint64_t number = 0;
};

struct Outcome {
  Seen seen;
  std::vector<Count> counts;
};

struct Peer {
  std::string name;    // one word of small letters and hyphens, for --peers
  std::string title;   // as the sources call it
  std::string source;  // which of them, and where
  ComputedAt computed_at = ComputedAt::image_precision;
  std::string does;  // for a student: what it does, in a few sentences
  std::string errs;  // and where it goes wrong, and why
  Outcome (*run)(const FlatScene& scene, int resolution) = nullptr;
};

}  // namespace sightline::peers
