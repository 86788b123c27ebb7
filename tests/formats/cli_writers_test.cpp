// What the writers write is read back and compared with the values in memory.
#include <doctest/doctest.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "cli/analyze/scene_surface.h"
#include "cli/results/face_measures.h"
#include "cli/results/report.h"
#include "cli/scene/scene_file.h"
#include "cli/system/memory_limit.h"
#include "formats/writing/labelled_obj.h"
#include "formats/writing/labelled_ply.h"
#include "formats/writing/segments_table.h"
#include "formats/writing/view_svg.h"
#include "formats/writing/window_points.h"
#include "tests/cli/xml_reader.h"
#include "tests/tools/analyzed.h"
#include "tests/tools/command_runner.h"

namespace sightline::tests::cli_writers_test {
using namespace cli;

namespace {

double number(const std::string& text) {
  double value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  REQUIRE(result.ptr == text.data() + text.size());
  return value;
}

struct Analysed {
  SceneDescription scene;
  MeshInput input;
  ViewAnalysis analysis;
  std::vector<FaceMeasures> faces;
};

Analysed analysed(const std::string& scene_file, std::size_t camera) {
  Progress silent(false);
  Analysed result;
  result.scene = read_scene_file(std::string(SIGHTLINE_FIXTURES_DIR) + "/" + scene_file);
  result.input = read_surface(result.scene, Normals::passed_over, default_memory_limit(), silent);
  const Analyzer analyzer(std::move(result.input.mesh), {.sides = result.scene.sides});
  result.analysis.view = analyzer.view(result.scene.cameras[camera], result.scene.panels);
  result.faces = measure_faces(result.analysis.view);
  return result;
}

Analysed fang() { return analysed("fang/scene.toml", 0); }

// The doubles are awkward, to be read back bit for bit.
LabelledMesh two_triangles() {
  LabelledMesh labelled;
  labelled.vertices = {{0.1, -0.0, 1e-310}, {1e300, 1.0 / 3, -5e-324}, {0.1 + 0.2, 4, 5}, {6, 7, 8}};
  labelled.triangles = {
      {{VertexId(0), VertexId(1), VertexId(2)}, FaceId(3), FacetId(3), Label::visible, true},
      {{VertexId(2), VertexId(1), VertexId(3)}, FaceId(70000), FacetId(70000), Label::back_facing, false}};
  return labelled;
}

template <class Value>
Value take(const std::string& bytes, std::size_t& at) {
  Value value;
  REQUIRE(at + sizeof value <= bytes.size());
  std::memcpy(&value, bytes.data() + at, sizeof value);
  at += sizeof value;
  return value;
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

using Pair = std::array<double, 2>;

// The area is in Fang's units, by the shoelace formula.
double shoelace(const std::vector<Pair>& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Pair& a = ring[i];
    const Pair& b = ring[(i + 1) % ring.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2;
}

const Pair O{6, 12}, P{2, 4}, Q{14, 0}, A{2, 9}, B{4, 2}, C{8, 5}, D{7, 8}, E{4, 11};
const Pair F{5, 10}, G{32.0 / 11, 64.0 / 11}, H{68.0 / 19, 66.0 / 19}, I{68.0 / 13, 38.0 / 13};
const double pentagon = shoelace({A, B, C, D, E});
const double triangle = shoelace({O, P, Q});
const double triangle_visible = shoelace({O, F, D, C, I, Q}) + shoelace({P, H, G});
constexpr double square_units = 4.0 / 256;  // the window's area over Fang's square

std::string svg_of(const View& view) {
  return text_of([&](TextBuffer& out) { write_view_svg(view, window_points(view), {}, out); });
}

}  // namespace

TEST_CASE("labelled.ply gives back every vertex and triangle bit for bit") {
  const LabelledMesh labelled = two_triangles();
  const std::string ply = text_of([&](TextBuffer& out) { write_labelled_ply(labelled, {}, out); });
  const std::string end = "end_header\n";
  std::size_t at = ply.find(end) + end.size();
  const std::string header = ply.substr(0, at);
  CHECK(header.rfind("ply\nformat binary_little_endian 1.0\n", 0) == 0);
  CHECK(header.find("element vertex 4\nproperty double x\nproperty double y\nproperty double z\n") !=
        std::string::npos);
  CHECK(header.find("element face 2\nproperty list uchar int vertex_indices\nproperty int face\nproperty uchar label\n"
                    "property uchar seen\n") != std::string::npos);
  for (const Label label : {Label::back_facing, Label::out_of_view, Label::hidden, Label::visible}) {
    CHECK(header.find("comment label " + std::to_string(static_cast<int>(label)) + " = " + to_string(label)) !=
          std::string::npos);
  }
  for (const Point3& p : labelled.vertices) {
    for (const double coordinate : {p.x(), p.y(), p.z()}) CHECK(same_bits(take<double>(ply, at), coordinate));
  }
  for (const LabelledTriangle& t : labelled.triangles) {
    CHECK(take<std::uint8_t>(ply, at) == 3);
    for (const VertexId corner : t.corners)
      CHECK(take<std::int32_t>(ply, at) == static_cast<std::int32_t>(corner.value));
    CHECK(take<std::int32_t>(ply, at) == static_cast<std::int32_t>(t.face.value));
    CHECK(take<std::uint8_t>(ply, at) == static_cast<std::uint8_t>(t.label));
    CHECK(take<std::uint8_t>(ply, at) == (t.seen ? 1 : 0));
  }
  CHECK(at == ply.size());
}

TEST_CASE("labelled.obj gives back every vertex, and the triangles by label") {
  const LabelledMesh labelled = two_triangles();
  std::vector<double> coordinates;
  std::map<std::string, std::vector<std::string>> groups;
  std::string group;
  for (const std::string& line : lines_of(text_of([&](TextBuffer& out) { write_labelled_obj(labelled, {}, out); }))) {
    const auto words = split(line, ' ');
    if (words[0] == "v") {
      for (std::size_t i = 1; i < 4; ++i) coordinates.push_back(number(words[i]));
    } else if (words[0] == "g") {
      group = words[1];
    } else if (words[0] == "f") {
      groups[group].push_back(line);
    }
  }
  REQUIRE(coordinates.size() == 12);
  for (std::size_t i = 0; i < 4; ++i) {
    const Point3& p = labelled.vertices[i];
    CHECK(same_bits(coordinates[3 * i], p.x()));
    CHECK(same_bits(coordinates[3 * i + 1], p.y()));
    CHECK(same_bits(coordinates[3 * i + 2], p.z()));
  }
  CHECK(groups.size() == 2);
  CHECK(groups[to_string(Label::visible)] == std::vector<std::string>{"f 1 2 3"});
  CHECK(groups[to_string(Label::back_facing)] == std::vector<std::string>{"f 3 2 4"});
}

TEST_CASE("faces.csv reads back as the measures, and Fang's areas are those of his polygons") {
  const Analysed fang_view = fang();
  const auto lines = lines_of(text_of([&](TextBuffer& out) { write_faces_table(fang_view.faces, {}, out); }));
  CHECK(lines[0] == "face,facing,area,in_view_area,visible_area,image_area,visible_image_area");
  REQUIRE(lines.size() == 3);
  for (std::size_t f = 0; f < 2; ++f) {
    const FaceMeasures& face = fang_view.faces[f];
    const auto cells = split(lines[f + 1], ',');
    REQUIRE(cells.size() == 7);
    CHECK(cells[0] == std::to_string(f));
    CHECK(cells[1] == "front");
    const std::array<double, 5> values{face.area, face.in_view_area, face.visible_area, face.image_area,
                                       face.visible_image_area};
    for (std::size_t i = 0; i < 5; ++i) CHECK(same_bits(number(cells[i + 2]), values[i]));
  }
  const FaceMeasures& front = fang_view.faces[0];
  const FaceMeasures& behind = fang_view.faces[1];
  CHECK(front.area == pentagon);
  CHECK(front.in_view_area == front.area);
  CHECK(std::abs(front.visible_area - front.area) <= 1e-12 * front.area);
  CHECK(front.image_area == pentagon * square_units);
  CHECK(front.visible_image_area == pentagon * square_units);
  CHECK(front.label == Label::visible);
  CHECK(behind.area == triangle);
  CHECK(behind.in_view_area == behind.area);
  CHECK(behind.image_area == triangle * square_units);
  CHECK(std::abs(behind.visible_area - triangle_visible) <= 1e-12 * triangle);
  CHECK(std::abs(behind.visible_image_area - triangle_visible * square_units) <= 1e-12);
}

TEST_CASE("a face that is partly in view or skipped has the measures of its part") {
  // The window [-1, 1]^2 shows the half x < 1 of a square of side 2 in the plane z = 0; and there is a degenerate face.
  PolygonList faces;
  faces.push_back(std::vector{VertexId(0), VertexId(1), VertexId(2), VertexId(3)});
  faces.push_back(std::vector{VertexId(0), VertexId(1), VertexId(0)});
  const Mesh mesh = build_mesh({{0, -1, 0}, {2, -1, 0}, {2, 1, 0}, {0, 1, 0}}, faces);
  ViewPoint above;
  above.eye = {0, 0, 1};
  for (const bool from_behind : {false, true}) {
    above.eye.z() = from_behind ? -1 : 1;
    const View view = analyzed(mesh, orthographic_camera("c", above, 2));
    const auto measures = measure_faces(view);
    CHECK(measures[0].facing == (from_behind ? FaceFacing::back : FaceFacing::front));
    CHECK(measures[0].label == (from_behind ? Label::back_facing : Label::visible));
    CHECK(measures[0].area == 4);
    CHECK(measures[0].in_view_area == 2);
    CHECK(measures[0].visible_area == 2);
    CHECK(measures[0].image_area == 2);
    CHECK(measures[0].visible_image_area == 2);
    CHECK(measures[1].facing == FaceFacing::skipped);
    CHECK(lines_of(text_of([&](TextBuffer& out) { write_faces_table(measures, {}, out); }))[2] ==
          "1,skipped,0,0,0,0,0");
  }
}

TEST_CASE("segments.csv has Fang's fourteen segments, and each runs along its mesh edge") {
  const Analysed fang_view = fang();
  const View& view = fang_view.analysis.view;
  const auto lines = lines_of(
      text_of([&](TextBuffer& out) { write_segments_table(fang_view.analysis.view, window_points(view), out); }));
  CHECK(lines[0] == "face,start_x,start_y,end_x,end_y,edge,other_face,edge_start,edge_end");
  REQUIRE(lines.size() == 15);
  std::map<std::string, int> faces;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    INFO(doctest::String(lines[i].c_str()));
    const auto cells = split(lines[i], ',');
    REQUIRE(cells.size() == 9);
    CHECK(cells[5] == "mesh");
    ++faces[cells[0]];
    const Point3& u = fang_view.analysis.view.mesh().vertices[std::stoul(cells[7])];
    const Point3& v = fang_view.analysis.view.mesh().vertices[std::stoul(cells[8])];
    for (const std::size_t at : {std::size_t{1}, std::size_t{3}}) {
      const double x = 8 + 8 * number(cells[at]);
      const double y = 8 + 8 * number(cells[at + 1]);
      CHECK(std::abs((v.x() - u.x()) * (y - u.y()) - (v.y() - u.y()) * (x - u.x())) <= 1e-12);
    }
    CHECK((cells[6].empty() || cells[6] != cells[0]));
  }
  CHECK(faces["0"] == 5);
  CHECK(faces["1"] == 9);
}

TEST_CASE("view.svg is well-formed and has one path per visible polygon, with distinct ids") {
  for (const auto& [file, camera] :
       {std::pair<const char*, std::size_t>{"fang/scene.toml", 0}, {"demo/scene.toml", 2}}) {
    const Analysed analysed_view = analysed(file, camera);
    const View& view = analysed_view.analysis.view;
    const std::string svg = svg_of(analysed_view.analysis.view);
    const auto elements = sightline::tests::read_xml(svg);
    std::set<std::string> ids;
    std::size_t paths = 0;
    for (const auto& element : elements) {
      if (element.name != "path") continue;
      ++paths;
      ids.insert(element.attributes.at("id"));
      CHECK(element.attributes.at("id").rfind("face-" + element.attributes.at("data-face"), 0) == 0);
    }
    std::size_t above = 0;
    for (const VisiblePolygon& polygon : view.polygons.polygons) above += polygon.below_resolution ? 0 : 1;
    CHECK(above > 0);
    CHECK(paths == above);
    CHECK(ids.size() == paths);
  }
}

TEST_CASE("a camera's name cannot break the SVG") {
  const Analysed fang_view = fang();
  View view = fang_view.analysis.view;
  view.scene.camera.name = "a&b</title><script>";
  const std::string svg = svg_of(fang_view.analysis.view);
  for (const auto& element : sightline::tests::read_xml(svg)) CHECK(element.name != "script");
}

TEST_CASE("the report's sums are those of the faces, and what is seen and what is uncovered fill the window") {
  const Analysed fang_view = fang();
  const Report report = make_report(fang_view.scene, fang_view.input, fang_view.analysis, fang_view.faces, 0.5);
  CHECK(report.counts.faces.visible == 2);
  CHECK(report.counts.visible_polygons == 3);
  CHECK(report.counts.visible_segments == 14);
  CHECK(report.counts.crossings == 4);
  CHECK(report.counts.holes == 0);
  CHECK(report.areas.surface == pentagon + triangle);
  CHECK(std::abs(report.areas.image_visible + report.areas.image_uncovered - 4) <= 1e-12);
  CHECK(report.seconds.write == 0.5);
  CHECK(report.warnings.empty());
}

}  // namespace sightline::tests::cli_writers_test
