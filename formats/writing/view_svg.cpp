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

constexpr double bent_tolerance = 0.05;  // pixels by which lines that a lens bends may be off

// The drawing is in window units, or in pixels of the image that a lens bends.
struct Sheet {
  const Camera& camera;
  const std::vector<Point2>& places;
  const PlaceTexts& texts;
};

// The width is in window units. It is thinner where there are many polygons, so that strokes do not hide what they
// surround. It is not a vector-effect: librsvg ignores non-scaling-stroke.
double stroke_width(std::size_t polygons) {
  const double pixels = std::min(0.7, 30 / std::sqrt(static_cast<double>(polygons) + 1));
  return pixels * 2 / image_height;
}

void write_bent_header(const Camera& camera, std::size_t polygons, TextBuffer& out) {
  const LensImage& image = *camera.lens_image;
  const double border = image.first;
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << image.width << "\" height=\"" << image.height
      << "\" viewBox=\"" << border << ' ' << border << ' ' << image.width << ' ' << image.height << "\">\n<title>"
      << html_text(camera.name) << "</title>\n<rect x=\"" << border << "\" y=\"" << border << "\" width=\""
      << image.width << "\" height=\"" << image.height
      << "\" fill=\"#faf8f4\"/>\n<g fill-rule=\"evenodd\" stroke-width=\"" << stroke_width(polygons) * image.height / 2
      << "\" stroke-linejoin=\"round\">\n";
}

void write_plain_header(const Camera& camera, std::size_t polygons, TextBuffer& out) {
  const double aspect = camera.aspect;
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << aspect * image_height << "\" height=\"" << image_height
      << "\" viewBox=\"" << -aspect << " -1 " << 2 * aspect << " 2\">\n<title>" << html_text(camera.name)
      << "</title>\n<rect x=\"" << -aspect << "\" y=\"-1\" width=\"" << 2 * aspect
      << "\" height=\"2\" fill=\"#faf8f4\"/>\n<g transform=\"scale(" << aspect
      << " -1)\" fill-rule=\"evenodd\" stroke-width=\"" << stroke_width(polygons) << "\" stroke-linejoin=\"round\">\n";
}

void write_header(const Camera& camera, std::size_t polygons, TextBuffer& out) {
  if (camera.lens_image) return write_bent_header(camera, polygons, out);
  write_plain_header(camera, polygons, out);
}

void write_colour(const Colour& colour, TextBuffer& out) {
  constexpr std::string_view digits = "0123456789abcdef";
  out << '#';
  for (const std::uint8_t channel : colour) out << digits[channel / 16U] << digits[channel % 16U];
}

// Writes a line up to, and without, its end.
void write_bent_line(const LensImage& image, const Point2& from, const Point2& to, char& command, TextBuffer& out) {
  const std::vector<Point2> line = bent_line(image, from, to, bent_tolerance);
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Point2 pixel = bent_pixel(image, line[i]);
    out << command << pixel.x << ' ' << pixel.y;
    command = 'L';
  }
}

void write_line(const Sheet& sheet, const VisibleSegment& segment, char& command, TextBuffer& out) {
  if (sheet.camera.lens_image) {
    write_bent_line(*sheet.camera.lens_image, sheet.places[segment.start.index()], sheet.places[segment.end.index()],
                    command, out);
    return;
  }
  out << command << sheet.texts.x(segment.start) << ' ' << sheet.texts.y(segment.start);
  command = 'L';
}

void write_rings(const VisibleSegments& segments, const VisiblePolygons& polygons, const VisiblePolygon& polygon,
                 const Sheet& sheet, TextBuffer& out) {
  for (std::size_t r = 0; r < polygon.ring_count; ++r) {
    char command = 'M';
    for (const SegmentId segment : polygons.ring(polygon.first_ring + r))
      write_line(sheet, segments.segments[segment.index()], command, out);
    out << 'Z';
  }
}

void write_names(FaceId face, std::size_t occurrence, FacetFacing facing, TextBuffer& out) {
  out << "<path id=\"face-" << face.value;
  if (occurrence > 1) out << '-' << std::uint64_t{occurrence};
  out << "\" class=\"" << (facing == FacetFacing::back ? "back" : "front") << "\" data-face=\"" << face.value << '"';
}

void write_polygon(const View& view, const VisiblePolygon& polygon, std::size_t occurrence, const Sheet& sheet,
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
  write_rings(view.segments, view.polygons, polygon, sheet, out);
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

void write_reflecting_polygons(const PanelReflection& reflection, const std::string& panel, const Sheet& sheet,
                               TextBuffer& out) {
  for_each_polygon(reflection.polygons, [&](const VisiblePolygon& polygon, std::size_t occurrence) {
    write_reflecting_name(panel, polygon.face, occurrence, out);
    write_rings(reflection.segments, reflection.polygons, polygon, sheet, out);
    out << "\"/>\n";
  });
}

void write_triangle(const View& view, const LabelledTriangle& triangle, TextBuffer& out) {
  const Camera& camera = view.scene.camera;
  std::array<Point2, 3> places;
  std::ranges::transform(triangle.corners, places.begin(),
                         [&](VertexId v) { return window_place(camera, view.labelled.vertices[v.index()]); });
  char command = 'M';
  for (std::size_t i = 0; i < 3; ++i) {
    if (camera.lens_image) {
      write_bent_line(*camera.lens_image, places[i], places[(i + 1) % 3], command, out);
      continue;
    }
    out << command << places[i].x << ' ' << places[i].y;
    command = 'L';
  }
}

void write_reflecting_triangles(const View& view, std::size_t number, const std::string& panel, TextBuffer& out) {
  FaceId last;
  std::size_t occurrence = 0;
  for (const LabelledTriangle& triangle : view.labelled.triangles) {
    if ((triangle.reflecting >> number & 1U) == 0) continue;
    occurrence = triangle.face == last ? occurrence + 1 : 1;
    last = triangle.face;
    write_reflecting_name(panel, triangle.face, occurrence, out);
    write_triangle(view, triangle, out);
    out << "Z\"/>\n";
  }
}

void write_panel(const View& view, const std::string& name, std::size_t number, const Sheet& sheet, TextBuffer& out) {
  const std::string_view colour = panel_colours[number % panel_colours.size()];
  const std::string panel = html_text(name);
  out << "<g class=\"reflecting\" data-panel=\"" << panel << "\" fill=\"" << colour << "\" stroke=\"#7a5b00\">\n";
  if (view.reflections.mode == ReflectionMode::triangles) {
    write_reflecting_triangles(view, number, panel, out);
  } else {
    write_reflecting_polygons(view.reflections.panels[number], panel, sheet, out);
  }
  out << "</g>\n";
}

}  // namespace

void write_view_svg(const View& view, const std::vector<Point2>& places, const std::vector<std::string>& panels,
                    TextBuffer& out) {
  const PlaceTexts texts(places);
  const Camera& camera = view.scene.camera;
  const Sheet sheet{camera, places, texts};
  write_header(camera, view.polygons.polygons.size(), out);
  for_each_polygon(view.polygons, [&](const VisiblePolygon& polygon, std::size_t occurrence) {
    write_polygon(view, polygon, occurrence, sheet, out);
  });
  for (std::size_t p = 0; p < panels.size(); ++p) write_panel(view, panels[p], p, sheet, out);
  out << "</g>\n</svg>\n";
}

}  // namespace sightline::inline formats
