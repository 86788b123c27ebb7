#include "cli/trace/trace_examples.h"

#include <algorithm>
#include <cmath>

#include "cli/scene/extreme_families.h"
#include "geometry/cutting/common_lines.h"
#include "geometry/cutting/interpenetration.h"

namespace sightline::cli {

namespace {

using Polygon = std::vector<Point3>;

// A polygon at one height above the page.
Polygon at_height(double z, const std::vector<Point2>& outline) {
  Polygon polygon;
  for (const Point2& p : outline) polygon.push_back({p.x, p.y, z});
  return polygon;
}

Polygon rectangle(double z, const Point2& low, const Point2& high) {
  return at_height(z, {low, {high.x, low.y}, high, {low.x, high.y}});
}

std::string letter(std::size_t number) { return {static_cast<char>('A' + number)}; }

// Letters for vertices, and faces by their corners.
trace::SceneNames letters_for(const Mesh& mesh) {
  trace::SceneNames names;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) names.vertices.push_back(letter(v));
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    names.faces.emplace_back();
    for (const VertexId corner : mesh.faces[f]) names.faces.back() += letter(corner.index());
  }
  return names;
}

// Vertices are numbered in the order in which the faces bring them; equal positions are one vertex.
class Draft {
 public:
  void add(const Polygon& polygon) {
    std::vector<VertexId> corners;
    for (const Point3& p : polygon) corners.push_back(vertex_at(p));
    faces_.push_back(corners);
  }
  // Seen from above: the page is the square from (0, 0) to (16, 16).
  [[nodiscard]] TraceScene on_page() const {
    const Mesh mesh = build_mesh(vertices_, faces_);
    const ViewPoint from_above{{8, 8, 10}, {8, 8, 0}, {0, 1, 0}, 1, {}, {}};
    return {cut_along_common_lines(mesh, find_contacts(mesh)),
            orthographic_camera("page", from_above, 16),
            letters_for(mesh),
            {}};
  }

 private:
  VertexId vertex_at(const Point3& p) {
    const auto found = std::find(vertices_.begin(), vertices_.end(), p);
    if (found != vertices_.end()) return VertexId(static_cast<std::size_t>(found - vertices_.begin()));
    vertices_.push_back(p);
    return VertexId(vertices_.size() - 1);
  }

  std::vector<Point3> vertices_;
  PolygonList faces_;
};

TraceScene page_of(const std::vector<Polygon>& faces) {
  Draft draft;
  for (const Polygon& face : faces) draft.add(face);
  return draft.on_page();
}

TraceScene fang() {
  TraceScene scene =
      page_of({at_height(1, {{2, 9}, {4, 2}, {8, 5}, {7, 8}, {4, 11}}), at_height(0, {{6, 12}, {2, 4}, {14, 0}})});
  scene.names = {{"A", "B", "C", "D", "E", "O", "P", "Q"}, {"ABCDE", "OPQ"}, {"F", "G", "H", "I"}};
  return scene;
}

TraceScene hole() {
  return page_of({rectangle(0, {2, 2}, {14, 14}), at_height(1, {{8, 4}, {12, 7}, {8, 12}, {4, 9}}),
                  at_height(2, {{7, 7}, {9, 7}, {8, 9}})});
}

TraceScene vertex_on_edge() {
  return page_of({at_height(0, {{3, 13}, {3, 3}, {13, 8}}), at_height(1, {{7, 11}, {11, 5}, {14, 12}}),
                  at_height(2, {{3, 8}, {6, 4}, {7, 7}})});
}

TraceScene vertex_on_vertex() {
  return page_of({at_height(0, {{3, 13}, {2, 4}, {9, 8}}), at_height(1, {{9, 8}, {13, 3}, {14, 12}}),
                  at_height(2, {{9, 8}, {6, 14}, {5, 5}})});
}

TraceScene edge_on_edge() {
  return page_of(
      {rectangle(0, {2, 4}, {9, 12}), rectangle(1, {9, 6}, {14, 14}), at_height(2, {{9, 11}, {5, 9}, {9, 7}})});
}

TraceScene horizontal_edges() {
  return page_of({rectangle(0, {2, 3}, {9, 10}), rectangle(1, {6, 6}, {14, 10}), rectangle(2, {4, 6}, {11, 8})});
}

TraceScene coplanar_faces() {
  return page_of({at_height(0, {{3, 4}, {12, 4}, {7, 13}}), at_height(0, {{2, 10}, {8, 2}, {14, 10}}),
                  rectangle(0, {6, 5}, {9, 8})});
}

TraceScene many_through_one_point() {
  return page_of({at_height(0, {{2, 2}, {14, 14}, {5, 14}}), at_height(1, {{2, 14}, {14, 2}, {14, 9}}),
                  at_height(2, {{8, 15}, {8, 1}, {12, 4}}), at_height(3, {{1, 8}, {15, 8}, {10, 11}})});
}

TraceScene t_junction() {
  return page_of({rectangle(1, {2, 2}, {8, 14}), rectangle(1, {8, 2}, {14, 7}), rectangle(1, {8, 7}, {14, 14}),
                  at_height(0, {{4, 4}, {15, 8}, {5, 12}})});
}

TraceScene interpenetrating_faces() {
  return page_of({rectangle(0, {3, 3}, {13, 12}), {{1, 6, -3}, {15, 5, 3}, {7, 14, 0}}});
}

TraceScene edge_on() {
  return page_of({at_height(0, {{2, 3}, {14, 4}, {8, 13}}),
                  {{4, 6, 1}, {12, 6, 1}, {12, 6, 3}, {4, 6, 3}},
                  {{5, 8, 1}, {11, 8, 1}, {11, 8.5, 4}, {5, 8.5, 4}}});
}

// In float, and whatever else is as the family has it.
TraceScene float_in(const char* family_name, double value) {
  const auto& all = extreme_families();
  const auto family = std::find_if(all.begin(), all.end(), [&](const auto& f) { return f.name == family_name; });
  FamilyScene scene = family->make(value);
  trace::SceneNames names = letters_for(scene.mesh);
  return {uncrossed(std::move(scene.mesh)),
          scene.camera,
          std::move(names),
          {Arithmetic::single_precision, scene.grid_bits}};
}

TraceScene float_is_wrong() { return float_in("depth_gap", std::ldexp(1.0, -30)); }

// A field of view of 10^-5 degrees.
TraceScene float_stops() { return float_in("field_of_view", std::tan(0.5e-5 * std::acos(-1.0) / 180)); }

}  // namespace

const std::vector<TraceExample>& trace_examples() {
  static const std::vector<TraceExample> all{
      {"fang", "Fang's worked example",
       "Pentagon ABCDE before triangle OPQ: Fang 1993, section 5.3, tables 5.2 to 5.4.", fang},
      {"hole", "Holes and threads",
       "A face inside another's outline cuts a hole into it, and has one itself. A thread tells where a hole belongs.",
       hole},
      {"vertex-on-edge", "Vertices on edges", "In the image, corners of two triangles lie on the edges of a third.",
       vertex_on_edge},
      {"vertex-on-vertex", "Vertices on vertices",
       "Corners of three triangles fall on one point, at three depths: one sweep point.", vertex_on_vertex},
      {"edge-on-edge", "Edges on edges",
       "Three faces have an edge on one line. Edges that lie on each other are one bundle, one entry of the list.",
       edge_on_edge},
      {"horizontal", "Horizontal edges",
       "Points of one height are swept left to right, as if the sweep line were tilted a little: a horizontal edge is "
       "like any other.",
       horizontal_edges},
      {"coplanar", "Coplanar faces", "Three faces overlap in one plane. The rule: the lower face index is in front.",
       coplanar_faces},
      {"many-through-one", "Many edges through one point",
       "Four edges at four depths cross in one point: one sweep point, at which they turn round.",
       many_through_one_point},
      {"t-junction", "T-junctions", "A corner of two faces lies on an edge of a third; what is behind stays hidden.",
       t_junction},
      {"interpenetrating", "Faces that pass through each other",
       "A rectangle and a tilted triangle are cut along their common line first, so that each part has one order.",
       interpenetrating_faces},
      {"edge-on", "Faces seen edge-on",
       "One plate is seen exactly edge-on and shows nothing; another leans a little, and is swept.", edge_on},
      {"float-wrong", "Where float is wrong",
       "Four triangles in planes 2^-30 apart, nearer ones later. Float cannot tell their depths, and the picture is "
       "wrong without a sign of it. Exact arithmetic beside it.",
       float_is_wrong},
      {"float-stops", "Where float stops",
       "Four triangles through a field of view of 10^-5 degrees. In float the sweep meets a contradiction and ends. "
       "Exact arithmetic beside it.",
       float_stops},
  };
  return all;
}

const TraceExample* trace_example_named(const std::string& name) {
  const auto& all = trace_examples();
  const auto found = std::find_if(all.begin(), all.end(), [&](const TraceExample& e) { return e.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace sightline::cli
