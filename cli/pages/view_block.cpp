#include "cli/pages/view_block.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <span>

#include "formats/writing/face_shade.h"

namespace sightline::cli {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

// Gives those that are asked for new numbers, in the order in which they are.
class Renumbering {
 public:
  explicit Renumbering(std::size_t count) : number_(count, none) {}
  std::uint32_t number(std::size_t old_one) {
    if (number_[old_one] == none) {
      number_[old_one] = static_cast<std::uint32_t>(kept_.size());
      kept_.push_back(old_one);
    }
    return number_[old_one];
  }
  [[nodiscard]] const std::vector<std::size_t>& kept() const { return kept_; }

 private:
  std::vector<std::uint32_t> number_;
  std::vector<std::size_t> kept_;
};

std::uint8_t state_of(const LabelledTriangle& triangle, std::uint8_t border) {
  return static_cast<std::uint8_t>(static_cast<unsigned>(triangle.label) | (triangle.seen ? 4U : 0U) |
                                   unsigned{border} << 3U);
}

std::vector<float> positions(const LabelledMesh& labelled, const std::vector<std::size_t>& kept, const Ball& ball) {
  std::vector<float> result;
  result.reserve(3 * kept.size());
  for (const std::size_t v : kept) {
    const Vector3 offset = labelled.vertices[v] - ball.centre;
    for (const double coordinate : {offset.x(), offset.y(), offset.z()})
      result.push_back(static_cast<float>(coordinate / ball.radius));
  }
  return result;
}

void add_triangles(ArrayBlock& block, const View& view, const Ball& ball, HeldTriangles held) {
  const LabelledMesh& labelled = view.labelled;
  const std::vector<std::uint8_t> borders = face_borders(labelled);
  Renumbering vertices(labelled.vertices.size());
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> faces;
  std::vector<std::uint8_t> states;
  std::vector<std::uint64_t> panels;
  for (std::size_t t = 0; t < labelled.triangles.size(); ++t) {
    const LabelledTriangle& triangle = labelled.triangles[t];
    if (held == HeldTriangles::seen && !triangle.seen) continue;
    for (const VertexId corner : triangle.corners) corners.push_back(vertices.number(corner.index()));
    faces.push_back(triangle.face.value);
    states.push_back(state_of(triangle, borders[t]));
    panels.push_back(triangle.reflecting);
  }
  block.add("positions", positions(labelled, vertices.kept(), ball));
  block.add("corners", corners);
  block.add("triangle_face", faces);
  block.add("triangle_state", states);
  if (!view.reflections.panels.empty()) block.add("triangle_panels", panels);
}

void add_image_points(ArrayBlock& block, const std::vector<Point2>& places, const std::vector<std::size_t>& kept) {
  std::vector<float> result;
  result.reserve(2 * kept.size());
  for (const std::size_t p : kept) {
    result.push_back(static_cast<float>(places[p].x));
    result.push_back(static_cast<float>(places[p].y));
  }
  block.add("image_points", result);
}

class PolygonArrays {
 public:
  PolygonArrays(const View& view, std::size_t points) : view_(view), points_(points) {}

  void add(const CutMesh& mesh, const VisiblePolygon& polygon) {
    for (std::size_t r = 0; r < polygon.ring_count; ++r) add_ring(view_.polygons.ring(polygon.first_ring + r));
    rings_.push_back(polygon.ring_count);
    faces_.push_back(polygon.face.value);
    const FacetFacing facing = view_.scene.facing[polygon.facet.index()];
    for (const std::uint8_t channel : face_shade(mesh, view_.scene.camera, polygon.facet, facing).fill)
      colours_.push_back(channel);
  }
  void add_to(ArrayBlock& block, const std::vector<Point2>& places) const {
    add_image_points(block, places, points_.kept());
    block.add("ring_points", ring_points_);
    block.add("ring_sizes", ring_sizes_);
    block.add("polygon_rings", rings_);
    block.add("polygon_face", faces_);
    block.add("polygon_colour", colours_);
  }

 private:
  void add_ring(std::span<const SegmentId> ring) {
    for (const SegmentId segment : ring)
      ring_points_.push_back(points_.number(view_.segments.segments[segment.index()].start.index()));
    ring_sizes_.push_back(static_cast<std::uint32_t>(ring.size()));
  }

  const View& view_;
  Renumbering points_;
  std::vector<std::uint32_t> ring_points_, ring_sizes_, rings_, faces_;
  std::vector<std::uint8_t> colours_;
};

void add_polygons(ArrayBlock& block, const View& view, const std::vector<Point2>& places) {
  const CutMesh& mesh = view.scene.mesh();
  PolygonArrays arrays(view, places.size());
  for (const VisiblePolygon& polygon : view.polygons.polygons) {
    if (!polygon.below_resolution) arrays.add(mesh, polygon);
  }
  arrays.add_to(block, places);
}

std::uint64_t difference(double value, double usual) {
  return std::bit_cast<std::uint64_t>(value) ^ std::bit_cast<std::uint64_t>(usual);
}

template <class Value>
void add_column(ArrayBlock& block, const char* name, const std::vector<FaceMeasures>& faces, Value value) {
  std::vector<decltype(value(faces.front()))> column;
  column.reserve(faces.size());
  for (const FaceMeasures& face : faces) column.push_back(value(face));
  block.add(name, column);
}

void add_faces(ArrayBlock& block, const std::vector<FaceMeasures>& faces, std::size_t panels) {
  using Face = const FaceMeasures&;
  add_column(block, "face_facing", faces, [](Face face) { return static_cast<std::uint8_t>(face.facing); });
  add_column(block, "face_area", faces, [](Face face) { return face.area; });
  add_column(block, "face_in_view_area", faces, [](Face face) { return difference(face.in_view_area, face.area); });
  add_column(block, "face_visible_area", faces,
             [](Face face) { return difference(face.visible_area, face.in_view_area); });
  add_column(block, "face_image_area", faces, [](Face face) { return face.image_area; });
  add_column(block, "face_visible_image_area", faces,
             [](Face face) { return difference(face.visible_image_area, face.image_area); });
  std::vector<double> reflecting;
  for (std::size_t p = 0; p < panels; ++p) {
    for (const FaceMeasures& face : faces) reflecting.push_back(face.reflecting_area[p]);
  }
  block.add("face_reflecting_area", reflecting);
}

constexpr std::size_t alignment = 8;

std::size_t aligned(std::size_t size) { return (size + alignment - 1) / alignment * alignment; }

// Little endian, whatever the machine is.
template <class Number>
void append_bytes(std::string& out, const std::vector<Number>& values) {
  const std::size_t begin = out.size();
  out.resize(begin + values.size() * sizeof(Number));
  if (!values.empty()) std::memcpy(out.data() + begin, values.data(), values.size() * sizeof(Number));
  if constexpr (std::endian::native == std::endian::big) {
    for (char* at = out.data() + begin; at != out.data() + out.size(); at += sizeof(Number))
      std::reverse(at, at + sizeof(Number));
  }
}

using Ends = std::array<VertexId, 2>;  // the smaller one first

Ends edge_of(const LabelledTriangle& triangle, std::size_t i) {
  const VertexId a = triangle.corners[i];
  const VertexId b = triangle.corners[(i + 1) % 3];
  return {std::min(a, b), std::max(a, b)};
}

std::vector<Ends> sorted_edges(std::span<const LabelledTriangle> face) {
  std::vector<Ends> edges;
  for (const LabelledTriangle& triangle : face) {
    for (std::size_t i = 0; i < 3; ++i) edges.push_back(edge_of(triangle, i));
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

void append_borders(std::span<const LabelledTriangle> face, std::vector<std::uint8_t>& borders) {
  const std::vector<Ends> edges = sorted_edges(face);
  for (const LabelledTriangle& triangle : face) {
    unsigned border = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [first, last] = std::equal_range(edges.begin(), edges.end(), edge_of(triangle, i));
      if (last - first == 1) border |= 1U << i;
    }
    borders.push_back(static_cast<std::uint8_t>(border));
  }
}

}  // namespace

std::string view_block(const View& view, const std::vector<Point2>& places, const std::vector<FaceMeasures>& faces,
                       const Ball& ball, HeldTriangles held) {
  ArrayBlock block;
  add_triangles(block, view, ball, held);
  add_polygons(block, view, places);
  add_faces(block, faces, view.reflections.panels.size());
  return block.bytes();
}

template <class Number>
void ArrayBlock::append(const char* name, const char* type, const std::vector<Number>& values) {
  head_.push_back({{"name", name}, {"type", type}, {"count", values.size()}});
  append_bytes(body_, values);
  body_.resize(aligned(body_.size()), '\0');
}

template void ArrayBlock::append(const char*, const char*, const std::vector<std::uint8_t>&);
template void ArrayBlock::append(const char*, const char*, const std::vector<std::uint32_t>&);
template void ArrayBlock::append(const char*, const char*, const std::vector<std::uint64_t>&);
template void ArrayBlock::append(const char*, const char*, const std::vector<float>&);
template void ArrayBlock::append(const char*, const char*, const std::vector<double>&);

std::string ArrayBlock::bytes() const {
  std::string head = head_.dump();
  const std::size_t begin = sizeof(std::uint32_t);
  head.resize(aligned(begin + head.size()) - begin, ' ');
  std::string out;
  append_bytes(out, std::vector{static_cast<std::uint32_t>(head.size())});
  return out + head + body_;
}

std::vector<std::uint8_t> face_borders(const LabelledMesh& labelled) {
  const std::span<const LabelledTriangle> triangles(labelled.triangles);
  std::vector<std::uint8_t> borders;
  borders.reserve(triangles.size());
  for (std::size_t begin = 0; begin < triangles.size();) {
    std::size_t end = begin + 1;
    while (end < triangles.size() && triangles[end].face == triangles[begin].face) ++end;
    append_borders(triangles.subspan(begin, end - begin), borders);
    begin = end;
  }
  return borders;
}

}  // namespace sightline::cli
