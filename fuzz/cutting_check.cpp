#include <algorithm>
#include <set>

#include "fuzz/checks.h"
#include "fuzz/chosen_scene.h"
#include "oracle/judging/judge.h"

namespace sightline::fuzz {
namespace {

using PositionSet = std::set<std::array<lattice::Rational, 3>>;

// Where cutting made points, as rationals.
PositionSet made_points(const CutMesh& mesh) {
  PositionSet points;
  for (std::size_t v = mesh.input_vertex_count(); v < mesh.vertices.size(); ++v) {
    const ExactPosition p = exact_position(mesh, VertexId(v));
    points.insert(
        {lattice::Rational(p.xyz.x(), p.w), lattice::Rational(p.xyz.y(), p.w), lattice::Rational(p.xyz.z(), p.w)});
  }
  return points;
}

// Of faces with the same corners the first one counts, and it may be triangulated from another corner.
bool has_repeated_face(const Mesh& mesh) {
  return std::ranges::any_of(mesh.defects, [](const FaceDefect& d) { return d.defect == Defect::repeated_face; });
}

lattice::RandomScene with_faces_reversed(lattice::RandomScene scene) {
  std::ranges::reverse(scene.faces);
  return scene;
}

}  // namespace

// What is moved off the lattice has long fractions, whose greatest common divisors take a fuzzer minutes.
void check_cutting(std::string_view bytes) {
  const lattice::RandomScene scene = chosen_scene(bytes);
  const Mesh mesh = lattice::mesh_of(scene);
  const CutMesh cut = lattice::cut(mesh);
  lattice::Complaints complaints = validate(cut);
  if (!has_repeated_face(mesh) &&
      made_points(cut) != made_points(lattice::cut(lattice::mesh_of(with_faces_reversed(scene)))))
    complaints.push_back("other points where faces come in another order");
  if (!complaints.empty()) throw Finding(lattice::joined(complaints) + lattice::to_text(scene));
}

}  // namespace sightline::fuzz
