#include "oracle/judging/judge.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "geometry/cutting/common_lines.h"

namespace sightline::lattice {
namespace {

void append(Complaints& all, const char* stage, const std::vector<std::string>& more) {
  for (const std::string& line : more) all.push_back(stage + line);
}

std::string text(const Rational& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

void compare(Complaints& complaints, const std::string& what, const Rational& ours, const Rational& oracle) {
  if (ours != oracle) complaints.push_back(what + " is " + text(ours) + ", the oracle says " + text(oracle));
}

// The length is in window units.
double length(const ProjectedScene& scene, EdgeId e) {
  const ImagePoint& top = scene.point(scene.edge(e).top);
  const ImagePoint& bottom = scene.point(scene.edge(e).bottom);
  return std::ldexp(std::hypot(static_cast<double>(bottom.x - top.x), static_cast<double>(bottom.y - top.y)),
                    -scene.grid_bits);
}

void compare_with_oracle(Verdict& verdict, const RandomScene& scene, const View& view) {
  const CutMesh& mesh = view.scene.mesh();
  const std::vector<OracleFace> faces = oracle_faces(mesh, scene.camera, scene.sides);
  const lattice::Visibility truth = visibility(faces, mesh.face_count());
  const std::vector<Rational> ours = visible_areas(view);
  const int bits = view.scene.grid_bits;
  Rational uncovered = window_area(bits);
  for (std::size_t f = 0; f < ours.size(); ++f) {
    compare(verdict.complaints, "visible area of face " + std::to_string(f), ours[f],
            in_grid_units(truth.area[f], bits));
    uncovered -= ours[f];
  }
  compare(verdict.complaints, "uncovered area", uncovered, in_grid_units(truth.uncovered, bits));
  verdict.degeneracy = degeneracy(faces);
}

std::vector<Point3> used_vertices(RandomScene& scene) {
  std::vector<Point3> kept;
  std::vector<std::uint32_t> index(scene.vertices.size(), UINT32_MAX);
  for (auto& corners : scene.faces) {
    for (std::uint32_t& c : corners) {
      if (index[c] == UINT32_MAX) {
        index[c] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(scene.vertices[c]);
      }
      c = index[c];
    }
  }
  return kept;
}

}  // namespace

CutMesh cut(const Mesh& mesh) { return cut_along_common_lines(mesh, find_contacts(mesh)); }

Complaints complaints_of_stages(const View& view) {
  const CutMesh& mesh = view.scene.mesh();
  Complaints complaints;
  append(complaints, "mesh: ", validate(mesh));
  append(complaints, "scene: ", validate(view.scene));
  append(complaints, "segments: ", validate(view.segments, view.scene));
  append(complaints, "polygons: ", validate(view.polygons, view.scene, view.segments));
  append(complaints, "labelled: ", validate(view.labelled, view.scene));
  return complaints;
}

std::vector<Rational> visible_areas(const View& view) {
  const CutMesh& mesh = view.scene.mesh();
  std::vector<Rational> result(mesh.face_count());
  for (std::size_t p = 0; p < view.polygons.polygons.size(); ++p) {
    result[view.polygons.polygons[p].face.index()] += exact_area(view.scene, view.segments, view.polygons, p);
  }
  return result;
}

Rational window_area(int grid_bits) {
  return Rational(boost::multiprecision::cpp_int(4) << static_cast<unsigned>(2 * grid_bits));
}

Verdict judge(const RandomScene& scene) {
  Verdict verdict;
  try {
    const Analyzer analyzer(uncrossed(mesh_of(scene)),
                            {.sides = policy_of(scene.sides), .precision = {}, .engine = Engine::full});
    const View view = analyzer.view(scene.camera);
    verdict.statistics = view.segments.statistics;
    compare_with_oracle(verdict, scene, view);
    append(verdict.complaints, "", complaints_of_stages(view));
  } catch (const std::exception& error) {
    verdict.complaints.push_back(std::string("exception: ") + error.what());
  }
  return verdict;
}

RandomScene reduced(RandomScene scene, const std::function<bool(const RandomScene&)>& fails) {
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (std::size_t f = scene.faces.size(); f-- > 0;) {
      RandomScene without = scene;
      without.faces.erase(without.faces.begin() + static_cast<std::ptrdiff_t>(f));
      if (!fails(without)) continue;
      scene = without;
      smaller = true;
    }
  }
  RandomScene compact = scene;
  compact.vertices = used_vertices(compact);
  return fails(compact) ? compact : scene;
}

double rounding_bound(const ProjectedScene& scene) {
  // What is not rounded is off by its radius, and areas by their own rounding.
  if (scene.is_unrounded()) return 0x1p-40;
  double total = 0;
  for (std::size_t e = 0; e < scene.edge_count(); ++e) total += length(scene, EdgeId(e));
  return std::ldexp(total, -scene.grid_bits);
}

std::uint64_t scene_count(std::uint64_t full) {
  const char* wanted = std::getenv("SIGHTLINE_RANDOM_SCENES");
  if (wanted == nullptr) return full;
  return std::min(full, static_cast<std::uint64_t>(std::strtoull(wanted, nullptr, 10)));
}

std::string joined(const Complaints& complaints) {
  std::string text;
  for (const std::string& line : complaints) text += line + "\n";
  return text;
}

}  // namespace sightline::lattice
