// What reflections cost beside the view that they are of, and what tolerance buys on a body whose reflection is known. Prints the
// tables of docs/smooth.md, and where a file is named a plot of the second one.
//
//     build/release/bench/sightline_smooth [PLOT.svg [MODEL.obj...]]
//
// Processor time of one thread, the least of several runs; ratios within one run of the program.

#include <tbb/global_control.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>

#include "bench/measuring/least_seconds.h"
#include "bench/measuring/markdown_table.h"
#include "formats/reading/obj_reader.h"
#include "sightline/analyzer.h"

namespace sightline::bench {
namespace {

struct Body {
  std::string name;
  Mesh mesh;
  std::vector<Vector3> normals;  // empty: means
};

// The unit sphere in n rows of 2 n halved squares, with its own normals.
Body sphere(int n) {
  Body body{"sphere, n = " + std::to_string(n), {}, {}};
  std::vector<Point3> vertices;
  PolygonList faces;
  const int columns = 2 * n;
  for (int r = 0; r <= n; ++r) {
    const double latitude = std::numbers::pi * r / n;
    const double radius = r == 0 || r == n ? 0 : std::sin(latitude);
    for (int c = 0; c < columns; ++c) {
      const double angle = std::numbers::pi * c / n;
      vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), -std::cos(latitude)});
    }
  }
  const auto add = [&](int a, int b, int c) {
    std::vector<VertexId> face;
    for (const int corner : {a, b, c}) {
      face.emplace_back(static_cast<std::size_t>(corner));
      body.normals.push_back(vertices[static_cast<std::size_t>(corner)]);
    }
    faces.push_back(face);
  };
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < columns; ++c) {
      const int low = r * columns;
      const int next = (c + 1) % columns;
      add(low + c, low + next, low + columns + c);
      add(low + next, low + columns + next, low + columns + c);
    }
  }
  body.mesh = build_mesh(std::move(vertices), std::move(faces));
  return body;
}

Body model(const std::string& path) {
  return {path.substr(path.rfind('/') + 1), read_obj(std::filesystem::path(path)).mesh, {}};
}

struct Look {
  Camera camera;
  Panel panel;
};

// From the front and above; the panel to the left, three quarters as wide as the body's diagonal.
Look look_at(const Mesh& mesh) {
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 high = -low;
  for (const Point3& p : mesh.vertices) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Point3 middle = (low + high) / 2;
  const double size = (high - low).norm() / 2;
  ViewPoint view;
  view.target = middle;
  view.eye = middle + size * Vector3(1, 1.5, 2.5);
  const double left = middle.x() - 2 * size;
  const auto corner = [&](double y, double z) { return Point3(left, middle.y() + y * size, middle.z() + z * size); };
  return {perspective_camera("front", view, 40),
          {"window", {corner(0, 0.5), corner(0, 2), corner(1.5, 2), corner(1.5, 0.5)}, Emits::both}};
}

// The window is 4 wide, and the rays are parallel to z: so of triangles of the surface, where they are marked.
double marked_area_of(const LabelledMesh& labelled) {
  double area = 0;
  for (const LabelledTriangle& t : labelled.triangles) {
    if (t.reflecting == 0) continue;
    const auto at = [&](std::size_t i) { return labelled.vertices[t.corners[i].index()]; };
    area += std::fabs((at(1) - at(0)).cross(at(2) - at(0)).z()) / 2 / 4;
  }
  return area;
}

double area_of(const View& view) {
  if (view.reflections.mode == ReflectionMode::triangles) return marked_area_of(view.labelled);
  double area = 0;
  for (const VisiblePolygon& p : view.reflections.panels[0].polygons.polygons) area += p.area;
  return area;
}

struct Reflected {
  double seconds = 0;  // beyond those of the view alone
  double area = 0;     // in the image
  double uncertain_area = 0;
  std::size_t triangles = 0;
};

Reflected reflected(const Body& body, const Look& look, const ReflectionOptions& options, double view_seconds) {
  AnalysisOptions analysis;
  analysis.reflection = options;
  analysis.corner_normals = body.normals;
  const Analyzer analyzer(body.mesh, analysis);
  const MirrorWorld world = analyzer.world({look.panel});
  View view;
  Reflected result;
  result.seconds = least_seconds([&] { view = analyzer.view(look.camera, world); }) - view_seconds;
  result.area = area_of(view);
  result.uncertain_area = view.reflections.panels[0].uncertain_area;
  result.triangles = view.labelled.triangles.size();
  return result;
}

struct Alone {
  double seconds = 0;
  std::size_t triangles = 0;
};

Alone view_alone(const Body& body, const Look& look) {
  const Analyzer analyzer(body.mesh);
  View view;
  Alone alone;
  alone.seconds = least_seconds([&] { view = analyzer.view(look.camera); });
  alone.triangles = view.labelled.triangles.size();
  return alone;
}

TableRow cost_row(const Body& body) {
  const Look look = look_at(body.mesh);
  const Alone alone = view_alone(body, look);
  TableRow row{body.name, number("%.3f s", alone.seconds)};
  const Reflected exact = reflected(body, look, {}, alone.seconds);
  row.push_back(number("%.2f", exact.seconds / alone.seconds));
  std::size_t triangles = 0;
  for (const double tolerance : {1e-2, 1e-3}) {
    const Reflected smooth =
        reflected(body, look, {ReflectionMode::smooth, MirrorNormals::vertex, tolerance}, alone.seconds);
    row.push_back(number("%.2f", smooth.seconds / alone.seconds));
    triangles = smooth.triangles;
  }
  row.push_back(std::to_string(alone.triangles));
  row.push_back(std::to_string(triangles));
  return row;
}

void print_costs(const std::vector<std::string>& models) {
  std::vector<TableRow> rows;
  for (const std::string& path : models) rows.push_back(cost_row(model(path)));
  for (const int n : {32, 143}) rows.push_back(cost_row(sphere(n)));
  std::printf("%s\n", markdown_table({"body", "the view alone", "exact, beside it", "smooth at 1e-2", "smooth at 1e-3",
                                      "triangles of the view", "with smooth at 1e-3"},
                                     rows)
                          .c_str());
}

// A square of side 2 at height 3 over the sphere, seen along its axis by parallel rays; the window is 4 wide. A ray at the distance
// sin(t) from the axis leaves at the angle 2 t.
Look look_along_axis() {
  ViewPoint view;
  view.eye = {0, 0, 10};
  return {orthographic_camera("axis", view, 4),
          {"square", {{-1, -1, 3}, {1, -1, 3}, {1, 1, 3}, {-1, 1, 3}}, Emits::both}};
}

double true_area() {
  constexpr int steps = 4096;
  double area = 0;
  for (int i = 0; i < steps; ++i) {
    const double met = 1 / std::cos((i + 0.5) / steps * std::numbers::pi / 4);
    double low = 0;
    double high = 0.7;
    for (int k = 0; k < 60; ++k) {
      const double t = (low + high) / 2;
      (std::sin(t) + (3 - std::cos(t)) * std::tan(2 * t) < met ? low : high) = t;
    }
    area += std::sin(low) * std::sin(low) / 2 * (std::numbers::pi / 4 / steps);
  }
  return 8 * area / 4;
}

struct Trade {
  std::string kind;
  int refinement = 0;
  double error = 0;  // relative, against the sphere itself
  double uncertain = 0;
  double ratio = 0;  // seconds beside those of the view alone
};

std::vector<Trade> trades() {
  std::vector<Trade> result;
  const double truth = true_area();
  const Look look = look_along_axis();
  for (const int n : {16, 32, 64}) {
    const Body body = sphere(n);
    const double seconds = view_alone(body, look).seconds;
    const auto add = [&](const std::string& kind, const ReflectionOptions& options) {
      const Reflected found = reflected(body, look, options, seconds);
      result.push_back({kind, n, std::fabs(found.area - truth) / truth,
                        found.area > 0 ? found.uncertain_area / found.area : 0, found.seconds / seconds});
    };
    add("exact", {});
    add("triangles", {ReflectionMode::triangles});
    for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4})
      add("smooth " + number("%.0e", tolerance), {ReflectionMode::smooth, MirrorNormals::vertex, tolerance});
  }
  return result;
}

void print_trades(const std::vector<Trade>& all) {
  std::vector<TableRow> rows;
  for (const Trade& t : all)
    rows.push_back({std::to_string(t.refinement), t.kind, number("%.1e", t.error), number("%.1e", t.uncertain),
                    number("%.2f", t.ratio)});
  std::printf("%s\n", markdown_table(
                          {"rows", "mode", "wrong, of the sphere's own", "uncertain, as reported", "time / view"}, rows)
                          .c_str());
}

// Error against time, a curve per refinement, on logarithmic axes.
class Plot {
 public:
  void add(const std::vector<Trade>& all) {
    axes();
    const std::array colours{"#b5651d", "#2f6f4f", "#3b5b92"};
    std::size_t colour = 0;
    for (const int n : {16, 32, 64}) curve(all, n, colours[colour++]);
  }

  [[nodiscard]] std::string text() const {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 720 440\" font-family=\"sans-serif\" "
           "font-size=\"13\">"
           "<rect width=\"720\" height=\"440\" fill=\"#faf8f4\"/>" +
           text_ + "</svg>\n";
  }

 private:
  static double x(double ratio) { return 90 + 480 * (std::log10(std::max(ratio, 0.1)) + 1) / 3; }
  static double y(double error) { return 40 - 330 * std::log10(std::max(error, 1e-5)) / 5; }

  void write(double at_x, double at_y, const std::string& words, const std::string& more = "") {
    text_ +=
        "<text x=\"" + number("%.1f", at_x) + "\" y=\"" + number("%.1f", at_y) + "\" " + more + ">" + words + "</text>";
  }

  void axes() {
    for (int e = -1; e <= 2; ++e) {
      const double at = x(std::pow(10, e));
      text_ += "<path d=\"M" + number("%.1f", at) + " 40V370\" stroke=\"#ddd\"/>";
      write(at, 390, number("%g", std::pow(10, e)), "text-anchor=\"middle\"");
    }
    for (int e = -5; e <= 0; ++e) {
      const double at = y(std::pow(10, e));
      text_ += "<path d=\"M90 " + number("%.1f", at) + "H570\" stroke=\"#ddd\"/>";
      write(82, at + 4, "10" + std::string("<tspan dy=\"-5\" font-size=\"9\">") + std::to_string(e) + "</tspan>",
            "text-anchor=\"end\"");
    }
    write(330, 420, "time of the reflection / time of the view", "text-anchor=\"middle\"");
    write(90, 25, "error of the reflecting area, against the sphere itself");
  }

  void curve(const std::vector<Trade>& all, int n, const std::string& colour) {
    std::string path;
    double last_x = 0;
    double last_y = 0;
    for (const Trade& t : all) {
      if (t.refinement != n) continue;
      last_x = x(t.ratio);
      last_y = y(t.error);
      const std::string at = number("%.1f", last_x) + " " + number("%.1f", last_y);
      if (t.kind == "exact" || t.kind == "triangles") {
        text_ += "<rect x=\"" + number("%.1f", last_x - 4) + "\" y=\"" + number("%.1f", last_y - 4) +
                 "\" width=\"8\" height=\"8\" fill=\"" + colour + "\"/>";
        write(last_x + 8, last_y + 4, t.kind + ", " + std::to_string(n) + " rows", "fill=\"" + colour + "\"");
        continue;
      }
      path += (path.empty() ? "M" : "L") + at;
      text_ += "<circle cx=\"" + number("%.1f", last_x) + "\" cy=\"" + number("%.1f", last_y) + "\" r=\"3.5\" fill=\"" +
               colour + "\"/>";
    }
    text_ += "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"1.5\"/>";
    write(last_x + 8, last_y + 4, "smooth, " + std::to_string(n) + " rows", "fill=\"" + colour + "\"");
  }

  std::string text_;
};

void print_all(const std::string& plot_file, const std::vector<std::string>& models) {
  print_costs(models);
  const std::vector<Trade> all = trades();
  print_trades(all);
  if (plot_file.empty()) return;
  Plot plot;
  plot.add(all);
  std::ofstream(plot_file) << plot.text();
}

}  // namespace
}  // namespace sightline::bench

int main(int argc, char** argv) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 1);
  try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    sightline::bench::print_all(words.empty() ? "" : words[0],
                                {words.begin() + std::min<std::ptrdiff_t>(1, std::ssize(words)), words.end()});
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
