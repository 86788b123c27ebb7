// The page of the report knows one camera by these arrays (ArrayBlock).
//
// positions (f32, x y z in units of the ball's radius, from its centre), corners (u32, three per triangle), triangle_face (u32),
// triangle_state (u8: bits 0 and 1 the label, bit 2 seen, bits 3 to 5 whether the edge from corner 0, 1, 2 to the next
// is a piece of an edge of its face), triangle_panels (u64, where there are panels: the panels that it mirrors).
// image_points (f32, x y in the window), ring_points (u32, into them), ring_sizes (u32), polygon_rings (u32: how many),
// polygon_face (u32), polygon_colour (u8, r g b): the visible polygons above resolution, as view.svg has them.
// Per face, as faces.csv has them: face_facing (u8, see FaceFacing), face_area (f64), face_image_area (f64),
// face_reflecting_area (f64: all faces for the first panel, then for the next), and, as u64, what the bits of a number
// differ from those of another one that it mostly equals, for the sake of compression: face_in_view_area from face_area,
// face_visible_area from face_in_view_area, face_visible_image_area from face_image_area.
// Complexity: O(n log k) for faces of k triangles.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/results/face_measures.h"
#include "cli/results/json.h"
#include "geometry/mesh/mesh.h"
#include "sightline/view.h"

namespace sightline::cli {

// What the page shows is turned and measured in units of its size: so the numbers of a graphics card do for every input.
struct Ball {
  Point3 centre = Point3::Zero();
  double radius = 1;  // the largest half extent
};

// Which triangles are in the block.
enum class HeldTriangles : std::uint8_t { all, seen };

// places: window_points(view). faces: measure_faces(view).
[[nodiscard]] std::string view_block(const View& view, const std::vector<Point2>& places,
                                     const std::vector<FaceMeasures>& faces, const Ball& ball, HeldTriangles held);

// Named arrays of numbers as bytes: what JavaScript opens as typed arrays without a copy.
//
// Out: the length of the head (u32), the head (JSON: [{"name", "type", "count"}, ...], filled up with spaces), then the
//      arrays one after the other, each filled up with zeros; every array begins at a multiple of 8. Little endian. The
//      types are u8, u32, u64, f32 and f64.
class ArrayBlock {
 public:
  void add(const char* name, const std::vector<std::uint8_t>& values) { append(name, "u8", values); }
  void add(const char* name, const std::vector<std::uint32_t>& values) { append(name, "u32", values); }
  void add(const char* name, const std::vector<std::uint64_t>& values) { append(name, "u64", values); }
  void add(const char* name, const std::vector<float>& values) { append(name, "f32", values); }
  void add(const char* name, const std::vector<double>& values) { append(name, "f64", values); }

  [[nodiscard]] std::string bytes() const;

 private:
  template <class Number>
  void append(const char* name, const char* type, const std::vector<Number>& values);

  Json head_ = Json::array();
  std::string body_;
};

// Which edges of the refined triangles are pieces of the edges of their faces: per triangle three bits, of which bit i is
// the edge from corner i to the next one. What lies between two triangles of one face is not on its border.
[[nodiscard]] std::vector<std::uint8_t> face_borders(const LabelledMesh& labelled);

}  // namespace sightline::cli
