#include "formats/writing/view_svg.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "formats/writing/escaped_text.h"
#include "formats/writing/face_shade.h"
#include "formats/writing/text_buffer.h"
#include "formats/writing/window_points.h"

namespace sightline::inline formats {

namespace {

constexpr double image_height = 800;  // pixels, for viewers that ask for a size

// The width is in window units. It is thinner where there are many polygons, so that strokes do not hide what they
// surround. It is not a vector-effect: librsvg ignores non-scaling-stroke.
double stroke_width(std::size_t polygons) {
  const double pixels = std::min(0.7, 30 / std::sqrt(static_cast<double>(polygons) + 1));
  return pixels * 2 / image_height;
}

void write_header(const Camera& camera, std::size_t polygons, TextBuffer& out) {
  const double aspect = camera.aspect;
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << aspect * image_height << "\" height=\"" << image_height
      << "\" viewBox=\"" << -aspect << " -1 " << 2 * aspect << " 2\">\n<title>" << html_text(camera.name)
      << "</title>\n<rect x=\"" << -aspect << "\" y=\"-1\" width=\"" << 2 * aspect
      << "\" height=\"2\" fill=\"#faf8f4\"/>\n<g transform=\"scale(" << aspect
      << " -1)\" fill-rule=\"evenodd\" stroke-width=\"" << stroke_width(polygons) << "\" stroke-linejoin=\"round\">\n";
}

void write_colour(const Colour& colour, TextBuffer& out) {
  constexpr std::string_view digits = "0123456789abcdef";
  out << '#';
  for (const std::uint8_t channel : colour) out << digits[channel / 16U] << digits[channel % 16U];
}

void write_rings(const VisibleSegments& segments, const VisiblePolygons& polygons, const VisiblePolygon& polygon,
                 const PlaceTexts& places, TextBuffer& out) {
  for (std::size_t r = 0; r < polygon.ring_count; ++r) {
    char command = 'M';
    for (const SegmentId segment : polygons.ring(polygon.first_ring + r)) {
      const PointId start = segments.segments[segment.index()].start;
      out << command << places.x(start) << ' ' << places.y(start);
      command = 'L';
    }
    out << 'Z';
  }
}

void write_names(FaceId face, std::size_t occurrence, FacetFacing facing, TextBuffer& out) {
  out << "<path id=\"face-" << face.value;
  if (occurrence > 1) out << '-' << std::uint64_t{occurrence};
  out << "\" class=\"" << (facing == FacetFacing::back ? "back" : "front") << "\" data-face=\"" << face.value << '"';
}

void write_polygon(const View& view, const VisiblePolygon& polygon, std::size_t occurrence, const PlaceTexts& places,
                   TextBuffer& out) {
  const CutMesh& mesh = view.scene.mesh();
  const FacetFacing facing = view.scene.facing[polygon.facet.index()];
  const FaceShade shade = face_shade(mesh, view.scene.camera, polygon.facet, facing);
  write_names(polygon.face, occurrence, facing, out);
  out << " fill=\"";
  write_colour(shade.fill, out);
  out << "\" stroke=\"";
  write_colour(shade.stroke, out);
  out << "\" d=\"";
  write_rings(view.segments, view.polygons, polygon, places, out);
  out << "\"/>\n";
}

// Calls visit(polygon, occurrence) for those above resolution. The polygons come by face, so those of one face follow
// each other.
template <class Visit>
void for_each_polygon(const VisiblePolygons& polygons, Visit visit) {
  FaceId last;
  std::size_t occurrence = 0;
  for (const VisiblePolygon& polygon : polygons.polygons) {
    if (polygon.below_resolution) continue;
    occurrence = polygon.face == last ? occurrence + 1 : 1;
    last = polygon.face;
    visit(polygon, occurrence);
  }
}

// The colours are light on a blue surface: brightness, too, tells them apart from it and from each other.
constexpr std::array<std::string_view, 4> panel_colours{"#ffd54a", "#ff8f3f", "#fff6c8", "#f25f5c"};

// The names of a face's parts count from 1, and the first has no number.
void write_reflecting_name(const std::string& panel, FaceId face, std::size_t occurrence, TextBuffer& out) {
  out << "<path id=\"reflecting-" << panel << '-' << face.value;
  if (occurrence > 1) out << '-' << std::uint64_t{occurrence};
  out << "\" data-face=\"" << face.value << "\" d=\"";
}

void write_reflecting_polygons(const PanelReflection& reflection, const std::string& panel, const PlaceTexts& places,
                               TextBuffer& out) {
  for_each_polygon(reflection.polygons, [&](const VisiblePolygon& polygon, std::size_t occurrence) {
    write_reflecting_name(panel, polygon.face, occurrence, out);
    write_rings(reflection.segments, reflection.polygons, polygon, places, out);
    out << "\"/>\n";
  });
}

void write_reflecting_triangles(const View& view, std::size_t number, const std::string& panel, TextBuffer& out) {
  FaceId last;
  std::size_t occurrence = 0;
  for (const LabelledTriangle& triangle : view.labelled.triangles) {
    if ((triangle.reflecting >> number & 1U) == 0) continue;
    occurrence = triangle.face == last ? occurrence + 1 : 1;
    last = triangle.face;
    write_reflecting_name(panel, triangle.face, occurrence, out);
    char command = 'M';
    for (const VertexId v : triangle.corners) {
      const Point2 place = window_place(view.scene.camera, view.labelled.vertices[v.index()]);
      out << command << place.x << ' ' << place.y;
      command = 'L';
    }
    out << "Z\"/>\n";
  }
}

void write_panel(const View& view, const std::string& name, std::size_t number, const PlaceTexts& places,
                 TextBuffer& out) {
  const std::string_view colour = panel_colours[number % panel_colours.size()];
  const std::string panel = html_text(name);
  out << "<g class=\"reflecting\" data-panel=\"" << panel << "\" fill=\"" << colour << "\" stroke=\"#7a5b00\">\n";
  if (view.reflections.mode == ReflectionMode::triangles) {
    write_reflecting_triangles(view, number, panel, out);
  } else {
    write_reflecting_polygons(view.reflections.panels[number], panel, places, out);
  }
  out << "</g>\n";
}

}  // namespace

void write_view_svg(const View& view, const std::vector<Point2>& places, const std::vector<std::string>& panels,
                    TextBuffer& out) {
  const PlaceTexts texts(places);
  write_header(view.scene.camera, view.polygons.polygons.size(), out);
  for_each_polygon(view.polygons, [&](const VisiblePolygon& polygon, std::size_t occurrence) {
    write_polygon(view, polygon, occurrence, texts, out);
  });
  for (std::size_t p = 0; p < panels.size(); ++p) write_panel(view, panels[p], p, texts, out);
  out << "</g>\n</svg>\n";
}

}  // namespace sightline::inline formats
