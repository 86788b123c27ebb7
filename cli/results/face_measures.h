// Face measures say in numbers what the camera sees of each input face.
//
// In:  a mesh and the view of it. Out: one FaceMeasures per input face, in file order.
// Units: 3D areas in input units squared; image areas in the window [-1, 1]^2, so at most 4.
// Holds: a skipped face has only zeros; a face that is wholly in the view volume has in_view_area == area.
// Complexity: O(n).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "formats/writing/text_buffer.h"
#include "geometry/mesh/mesh.h"
#include "sightline/view.h"

namespace sightline::cli {

enum class FaceFacing : std::uint8_t {
  front,
  back,
  edge_on,
  mixed,
  skipped
};  // mixed: not planar, and its facets differ
[[nodiscard]] const char* to_string(FaceFacing facing);

struct FaceMeasures {
  FaceFacing facing = FaceFacing::skipped;
  Label label =
      Label::back_facing;   // the highest of its triangles: visible, else hidden, else out of view, else back-facing
  double area = 0;          // of its facets
  double in_view_area = 0;  // of its facets' polygons in the view volume; culled and edge-on facets have none
  double visible_area = 0;  // of its triangles that are seen
  double image_area = 0;    // of its facets' polygons in the image
  double visible_image_area = 0;        // of its visible polygons above resolution
  double any_reflecting_area = 0;       // of its triangles that mirror one panel or more into the camera
  std::vector<double> reflecting_area;  // per panel, of its triangles that mirror it into the camera
};

[[nodiscard]] std::vector<FaceMeasures> measure_faces(const View& view);

// faces.csv: a row per input face, in file order, index from 0. panels: their names; per panel there is a column
// reflecting_area:NAME.
void write_faces_table(const std::vector<FaceMeasures>& faces, const std::vector<std::string>& panels, TextBuffer& out);

}  // namespace sightline::cli
