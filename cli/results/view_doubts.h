// Doubts about a camera: a view that shows nothing is hardly what its owner meant.
//
// In:  a view, and what of the surface is in view. Out: a line per doubt, which says where the mesh is in the camera's
//      frame (x right, y up, z along the view; input units) and what the mistake may be:
//        nothing is in view: the mesh is behind, nearer than near, beyond far, or beside
//        all faces turn their backs
//        the camera is one of a matrix P, and faces lie on both sides of its image plane, or -P was taken for P
// Complexity: O(n).
#pragma once

#include <string>
#include <vector>

#include "sightline/view.h"

namespace sightline::cli {

struct ViewDoubt {
  std::string brief;  // for a terminal: at most 60 characters
  std::string full;   // with the numbers, and what to do
};

// What of the surface is in view.
struct InView {
  bool front = false;     // a face is visible or hidden
  bool area = false;      // a face that counts (culling.h) has a part in the view volume
  bool any_back = false;  // a face turns its back, be it out of view
};

[[nodiscard]] std::vector<ViewDoubt> doubts_about_view(const Visibility& view, const InView& in_view);

}  // namespace sightline::cli
