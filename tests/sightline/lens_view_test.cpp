// Views behind lenses: what is seen is what the ideal pinhole sees, inside the frame; the rest is out of view.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "coverage/coverage.h"
#include "coverage/seen_part.h"
#include "formats/writing/segments_table.h"
#include "formats/writing/view_svg.h"
#include "formats/writing/window_points.h"
#include "geometry/mesh/area.h"
#include "geometry/numbers/errors.h"
#include "sightline/analyzer.h"
#include "tests/tools/polygon_mesh.h"

namespace sightline::tests::lens_view_test {
namespace {

constexpr double width = 640;
constexpr double height = 480;

struct NamedLens {
  std::string name;
  Lens lens;
};

const std::vector<NamedLens>& lenses() {
  static const std::vector<NamedLens> all{
      {"barrel", {LensModel::brown, {-0.2, 0.02, 0, 0, 0, 0}, {0.001, -0.002}}},
      {"pincushion", {LensModel::brown, {0.3, 0, 0, 0, 0, 0}, {0, 0}}},
      {"moustache", {LensModel::brown, {-0.3, 0.5, 0, 0, 0, 0}, {0, 0}}},
      {"fraction", {LensModel::brown, {0.4, 0.1, 0, 0.5, 0.1, 0.01}, {0.002, 0.001}}},
      {"fisheye", {LensModel::fisheye, {-0.02, 0.01, 0, 0, 0, 0}, {0, 0}}},
  };
  return all;
}

Camera behind(const Lens& lens, double tolerance = 0.5) {
  Matrix3 k;
  k << 500, 0, 330, 0, 510, 230, 0, 0, 1;
  const Vector3 t{0.1, -0.2, 6};
  return calibrated_camera("lens", k, Matrix3::Identity(), t, {width, height}, lens, tolerance);
}

Camera without_lens(Camera camera) {
  camera.lens_image.reset();
  return camera;
}

// Triangles in front of a wall, a floor that reaches behind the eye, and much that the image's border crosses.
Mesh scene(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto number = [&](double size) { return std::uniform_real_distribution<double>(-size, size)(random); };
  std::vector<Corners> polygons{{{-40, -40, 9}, {-40, 40, 9}, {40, 40, 9}, {40, -40, 9}},
                                {{-30, 2.5, -20}, {-30, 2.5, 8}, {30, 2.5, 8}, {30, 2.5, -20}}};
  for (int i = 0; i < 40; ++i) {
    const Point3 middle{number(5), number(4), number(3)};
    Corners corners;
    for (int c = 0; c < 3; ++c) corners.push_back(middle + Vector3(number(2), number(2), number(2)));
    polygons.push_back(corners);
  }
  return mesh_of(polygons);
}

AnalysisOptions both_sides(Engine engine = Engine::fast) {
  AnalysisOptions options;
  options.sides = SidesPolicy::both;
  options.engine = engine;
  return options;
}

// How often the segments' rings wind around the place.
template <class Ring>
bool winds_around(const Ring& places, const Point2& p) {
  bool inside = false;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Point2& a = places[i];
    const Point2& b = places[(i + 1) % places.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

// Returns the face of which a polygon has the place; invalid where there is none.
FaceId face_at(const VisiblePolygons& polygons, const VisibleSegments& segments, const std::vector<Point2>& places,
               const Point2& p) {
  for (const VisiblePolygon& polygon : polygons.polygons) {
    bool inside = false;
    for (std::size_t r = polygon.first_ring; r < polygon.first_ring + polygon.ring_count; ++r) {
      std::vector<Point2> ring;
      for (const SegmentId s : polygons.ring(r)) ring.push_back(places[segments.segments[s.index()].start.index()]);
      if (winds_around(ring, p)) inside = !inside;
    }
    if (inside) return polygon.face;
  }
  return {};
}

// How far a pixel is inside the image; negative outside.
double depth_in_image(const LensImage& image, const Point2& window) {
  const Point2 p = bent_pixel(image, window);
  return std::min({p.x, width - p.x, p.y, height - p.y});
}

void check_valid(const View& view) {
  CHECK(validate(view.mesh()).empty());
  CHECK(validate(view.scene).empty());
  CHECK(validate(view.segments, view.scene).empty());
  CHECK(validate(view.polygons, view.scene, view.segments).empty());
  CHECK(validate(view.labelled, view.scene).empty());
}

std::vector<double> image_areas(const View& view) {
  std::vector<double> areas(view.mesh().face_count());
  for (const VisiblePolygon& polygon : view.polygons.polygons) areas[polygon.face.index()] += polygon.area;
  return areas;
}

std::array<double, 4> label_areas(const LabelledMesh& labelled) {
  std::array<double, 4> areas{};
  for (const LabelledTriangle& t : labelled.triangles) {
    const auto& [a, b, c] = t.corners;
    areas[static_cast<std::size_t>(t.label)] +=
        triangle_area(labelled.vertices[a.index()], labelled.vertices[b.index()], labelled.vertices[c.index()]);
  }
  return areas;
}

std::vector<Panel> lamp() { return {{"lamp", {{-12, -10, -4}, {12, -10, -4}, {12, -2, -4}, {-12, -2, -4}}, {}}}; }

}  // namespace

TEST_CASE("Behind a lens a ray sees what it sees without, if its pixel is in the image, and nothing else") {
  const std::uint64_t seed = 11;
  CAPTURE(seed);
  for (const NamedLens& named : lenses()) {
    CAPTURE(named.name);
    const Camera camera = behind(named.lens);
    const LensImage& image = *camera.lens_image;
    const Analyzer analyzer(scene(seed), both_sides());
    const View bent = analyzer.view(camera, lamp());
    const View ideal = analyzer.view(without_lens(camera), lamp());
    check_valid(bent);
    const std::vector<Point2> bent_places = window_points(bent);
    const std::vector<Point2> ideal_places = window_points(ideal);
    std::mt19937_64 random(seed);
    std::array<int, 3> counts{};
    for (int i = 0; i < 4000; ++i) {
      const auto number = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
      const double x = number();
      const Point2 p{x, number()};
      const double depth = depth_in_image(image, p);
      if (std::fabs(depth) <= image.frame_tolerance) continue;
      const FaceId seen = face_at(bent.polygons, bent.segments, bent_places, p);
      if (depth < 0) {
        CHECK(!seen.valid());
        ++counts[0];
        continue;
      }
      CHECK(seen == face_at(ideal.polygons, ideal.segments, ideal_places, p));
      ++counts[1];
      const PanelReflection& reflected = bent.reflections.panels[0];
      const PanelReflection& expected = ideal.reflections.panels[0];
      const FaceId mirror = face_at(reflected.polygons, reflected.segments, bent_places, p);
      CHECK(mirror == face_at(expected.polygons, expected.segments, ideal_places, p));
      counts[2] += mirror.valid() ? 1 : 0;
    }
    CHECK(counts[0] > 50);
    CHECK(counts[1] > 1500);
    CHECK(counts[2] > 10);
  }
}

TEST_CASE("Areas behind a lens add up: of the frame, and of the surface") {
  for (const NamedLens& named : lenses()) {
    CAPTURE(named.name);
    const Camera camera = behind(named.lens);
    const Mesh mesh = scene(5);
    double surface = 0;
    const Analyzer analyzer(mesh, both_sides());
    for (std::size_t f = 0; f < analyzer.mesh().facet_count(); ++f) surface += facet_area(analyzer.mesh(), FacetId(f));
    const View view = analyzer.view(camera);
    // The wall closes the view: every place of the frame sees something.
    double covered = 0;
    for (const double area : image_areas(view)) covered += area;
    CHECK(covered == doctest::Approx(frame_area(*camera.lens_image)).epsilon(1e-12));
    const auto areas = label_areas(view.labelled);
    CHECK(areas[0] + areas[1] + areas[2] + areas[3] == doctest::Approx(surface).epsilon(1e-11));
    CHECK(areas[1] > 0);
    CHECK(areas[2] > 0);
    CHECK(areas[3] > 0);
  }
}

TEST_CASE("Triangles of the labelled surface are on one side of the frame, hidden ones too") {
  for (const NamedLens& named : lenses()) {
    CAPTURE(named.name);
    const Camera camera = behind(named.lens);
    const LensImage& image = *camera.lens_image;
    const View view = Analyzer(scene(6), both_sides()).view(camera);
    const double slack = image.frame_tolerance + 1e-6;
    std::size_t hidden = 0;
    std::size_t beside = 0;
    for (const LabelledTriangle& t : view.labelled.triangles) {
      if (t.label == Label::back_facing) continue;
      std::array<Point2, 3> places;
      bool before_eye = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const Point3& p = view.labelled.vertices[t.corners[i].index()];
        before_eye = before_eye && camera.forward.dot(p - camera.origin) > 1e-3;
        places[i] = window_place(camera, p);
      }
      if (t.label == Label::out_of_view) {
        const Point2 middle{(places[0].x + places[1].x + places[2].x) / 3,
                            (places[0].y + places[1].y + places[2].y) / 3};
        if (!before_eye || std::max(std::fabs(middle.x), std::fabs(middle.y)) > 1) continue;
        CHECK(depth_in_image(image, middle) <= slack);
        ++beside;
        continue;
      }
      hidden += t.label == Label::hidden ? 1 : 0;
      CHECK(before_eye);
      for (const Point2& p : places) CHECK(depth_in_image(image, p) >= -slack);
    }
    CHECK(hidden > 20);
    CHECK(beside > 3);
  }
}

TEST_CASE("Behind a lens engines, threads and the order of faces change nothing") {
  const Camera camera = behind(lenses()[0].lens);
  const Mesh mesh = scene(7);
  const View fast = Analyzer(mesh, both_sides()).view(camera);
  const View full = Analyzer(mesh, both_sides(Engine::full)).view(camera);
  CHECK(fast.labelled.vertices == full.labelled.vertices);
  CHECK(image_areas(fast) == image_areas(full));
  std::vector<Corners> polygons;
  for (std::size_t f = mesh.face_count(); f > 0; --f) {
    Corners corners;
    for (const VertexId v : mesh.faces[f - 1]) corners.push_back(mesh.position(v));
    polygons.push_back(corners);
  }
  std::vector<double> reversed = image_areas(Analyzer(mesh_of(polygons), both_sides()).view(camera));
  std::ranges::reverse(reversed);
  const std::vector<double> areas = image_areas(fast);
  REQUIRE(areas.size() == reversed.size());
  for (std::size_t f = 0; f < areas.size(); ++f) CHECK(std::fabs(areas[f] - reversed[f]) < 1e-14);
}

TEST_CASE("A scene that is turned with its camera looks the same behind a lens") {
  const Mesh mesh = scene(8);
  std::vector<Corners> polygons;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    Corners corners;
    for (const VertexId v : mesh.faces[f]) {
      const Point3& p = mesh.position(v);
      corners.push_back({p.y(), p.z(), p.x()});
    }
    polygons.push_back(corners);
  }
  Matrix3 k;
  k << 500, 0, 330, 0, 510, 230, 0, 0, 1;
  Matrix3 r;
  r << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  const Lens& lens = lenses()[0].lens;
  const Camera turned = calibrated_camera("lens", k, r, {0.1, -0.2, 6}, {width, height}, lens, 0.5);
  const std::vector<double> before = image_areas(Analyzer(mesh, both_sides()).view(behind(lens)));
  const std::vector<double> after = image_areas(Analyzer(mesh_of(polygons), both_sides()).view(turned));
  for (std::size_t f = 0; f < before.size(); ++f) CHECK(std::fabs(before[f] - after[f]) < 1e-12);
}

TEST_CASE("What cameras with and without lenses cover together is between the most of one and the sum") {
  const Analyzer analyzer(scene(9), both_sides());
  const Camera bent = behind(lenses()[0].lens);
  Matrix3 k;
  k << 500, 0, 330, 0, 510, 230, 0, 0, 1;
  const Camera beside = calibrated_camera("beside", k, Matrix3::Identity(), {2, 0, 6}, {width, height});
  const auto seen = [&](const Camera& camera) {
    const View view = analyzer.view(camera);
    return seen_part(view.labelled, view.mesh());
  };
  const SeenPart ideal = seen(without_lens(bent));
  const std::array of_bent{seen(bent), ideal};
  const Coverage same_eye = cover(analyzer.mesh(), of_bent, 0);
  // From the same eye a lens shows a part of what the pinhole sees.
  CHECK(same_eye.together.visible == doctest::Approx(same_eye.cameras[1].visible).epsilon(1e-9));
  CHECK(same_eye.cameras[0].visible < same_eye.cameras[1].visible);
  const std::array of_both{seen(bent), seen(beside)};
  const Coverage both = cover(analyzer.mesh(), of_both, 0);
  CHECK(both.together.visible > std::max(both.cameras[0].visible, both.cameras[1].visible));
  CHECK(both.together.visible < both.cameras[0].visible + both.cameras[1].visible);
}

TEST_CASE("Behind a lens the segments' table has pixels, and the drawing is the bent image") {
  const Camera camera = behind(lenses()[0].lens);
  const View view = Analyzer(scene(10), both_sides()).view(camera);
  const std::vector<Point2> places = window_points(view);
  TextBuffer table;
  write_segments_table(view, places, table);
  const std::string rows = table.take();
  CHECK(rows.starts_with(
      "face,start_x,start_y,end_x,end_y,edge,other_face,edge_start,edge_end,start_pixel_x,start_pixel_y,end_pixel_x,"
      "end_pixel_y\n"));
  CHECK(rows.find(",border,,") != std::string::npos);
  TextBuffer svg;
  write_view_svg(view, places, {}, svg);
  const std::string drawing = svg.take();
  CHECK(drawing.find("viewBox=\"0 0 640 480\"") != std::string::npos);
}

TEST_CASE("A lens on a grid is refused with what to do") {
  AnalysisOptions options = both_sides();
  options.precision = {Arithmetic::exact, default_grid_bits};
  CHECK_THROWS_WITH_AS(static_cast<void>(Analyzer(scene(1), options).view(behind(lenses()[0].lens))),
                       doctest::Contains("leave --arithmetic and --grid-bits out"), CameraError);
}

}  // namespace sightline::tests::lens_view_test
