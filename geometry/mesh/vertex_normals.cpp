#include "geometry/mesh/vertex_normals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sightline::inline geometry {
namespace {

// Returns twice the area of a face, which need not be planar, as a vector.
Vector3 area_vector(const PolygonMesh& mesh, FaceId face, double scale) {
  const auto corners = mesh.faces[face.index()];
  const auto position = [&](std::size_t i) -> Vector3 { return scale * mesh.position(corners[i]); };
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum = sum + (position(i) - position(0)).cross(position(i + 1) - position(0));
  return sum;
}

bool is_skipped(const PolygonMesh& mesh, FaceId face) { return mesh.first_facet(face) == mesh.end_facet(face); }

double angle_degrees(const Vector3& a, const Vector3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

// What a face adds to means, and the faces around each vertex that stands for its position (Mesh::weld).
class NormalSums {
 public:
  NormalSums(const PolygonMesh& mesh, const NormalOptions& options)
      : mesh_(mesh), crease_(options.crease_angle_degrees) {
    const double scale = unit_scale(mesh.vertices);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      const Vector3 area = is_skipped(mesh, FaceId(f)) ? Vector3(Vector3::Zero()) : area_vector(mesh, FaceId(f), scale);
      of_face_.push_back(options.means == NormalMeans::area ? area : unit(area));
    }
    if (crease_) {
      collect_faces();
    } else {
      add_up();
    }
  }

  [[nodiscard]] Vector3 at(FaceId face, VertexId corner) const {
    const std::size_t place = mesh_.weld[corner.index()].index();
    if (!crease_) return sums_[place];
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = first_[place]; i < first_[place + 1]; ++i) {
      if (is_beside(face, faces_[i])) sum += of_face_[faces_[i].index()];
    }
    return sum;
  }

  // Whether the second face counts where the first one has a corner with it.
  [[nodiscard]] bool is_beside(FaceId face, FaceId other) const {
    const Vector3& own = of_face_[face.index()];
    return !crease_ || own == Vector3::Zero() || angle_degrees(own, of_face_[other.index()]) <= *crease_;
  }

 private:
  template <class Visit>
  void for_each_corner(Visit visit) const {
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
      for (const VertexId corner : mesh_.faces[f]) visit(FaceId(f), mesh_.weld[corner.index()].index());
    }
  }

  void add_up() {
    sums_.assign(mesh_.vertices.size(), Vector3::Zero());
    for_each_corner([&](FaceId face, std::size_t place) { sums_[place] += of_face_[face.index()]; });
  }

  void collect_faces() {
    first_.assign(mesh_.vertices.size() + 1, 0);
    for_each_corner([&](FaceId /*face*/, std::size_t place) { ++first_[place + 1]; });
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    faces_.resize(mesh_.faces.corners.size());
    for_each_corner([&](FaceId face, std::size_t place) { faces_[next[place]++] = face; });
  }

  const PolygonMesh& mesh_;
  std::optional<double> crease_;
  std::vector<Vector3> of_face_;
  std::vector<Vector3> sums_;       // without a crease: per vertex
  std::vector<std::size_t> first_;  // with one: where a vertex's faces begin
  std::vector<FaceId> faces_;
};

bool is_given(const std::vector<Vector3>& given, std::size_t corner) {
  return corner < given.size() && given[corner] != Vector3::Zero();
}

// Calls visit(face, corner's number) of faces that are not skipped.
template <class Visit>
void for_each_corner_in_use(const PolygonMesh& mesh, Visit visit) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (is_skipped(mesh, FaceId(f))) continue;
    for (std::size_t i = mesh.faces.begin[f]; i < mesh.faces.begin[f + 1]; ++i) visit(FaceId(f), i);
  }
}

// Calls visit(face, other face) of faces that share an edge, each pair once.
template <class Visit>
void for_each_neighbours(const PolygonMesh& mesh, Visit visit) {
  std::vector<std::pair<MeshEdgeId, FaceId>> sides;
  for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
    for (std::size_t i = mesh.facets.begin[f]; i < mesh.facets.begin[f + 1]; ++i)
      sides.emplace_back(mesh.facet_edges[i], mesh.facet_face[f]);
  }
  std::ranges::sort(sides);
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (sides[i].first == sides[i - 1].first && sides[i].second != sides[i - 1].second)
      visit(sides[i - 1].second, sides[i].second);
  }
}

constexpr double same_direction = 0.1;  // in degrees: more than five decimals lose

}  // namespace

const char* to_string(NormalMeans means) { return means == NormalMeans::area ? "area" : "plain"; }

std::vector<Vector3> vertex_normals(const PolygonMesh& mesh, const std::vector<Vector3>& given,
                                    const NormalOptions& options) {
  const NormalSums sums(mesh, options);
  std::vector<Vector3> normals;
  normals.reserve(mesh.faces.corners.size());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    for (std::size_t i = mesh.faces.begin[f]; i < mesh.faces.begin[f + 1]; ++i)
      normals.push_back(unit(is_given(given, i) ? given[i] : sums.at(FaceId(f), mesh.faces.corners[i])));
  }
  return normals;
}

NormalDoubts doubts_about_normals(const PolygonMesh& mesh, const std::vector<Vector3>& given,
                                  const NormalOptions& options) {
  const double scale = unit_scale(mesh.vertices);
  std::vector<Vector3> of_face;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) of_face.push_back(unit(area_vector(mesh, FaceId(f), scale)));
  NormalDoubts doubts;
  std::size_t in_use = 0;
  std::size_t of_faces = 0;
  std::vector<std::uint8_t> has_means(mesh.face_count(), 0);
  for_each_corner_in_use(mesh, [&](FaceId face, std::size_t corner) {
    ++in_use;
    if (!is_given(given, corner)) {
      has_means[face.index()] = 1;
      return;
    }
    of_faces += angle_degrees(given[corner], of_face[face.index()]) <= same_direction ? 1 : 0;
    if (given[corner].dot(of_face[face.index()]) >= 0) return;
    if (doubts.turned_corners++ == 0) doubts.first_turned = face;
  });
  const NormalSums sums(mesh, options);
  bool is_bent = false;
  for_each_neighbours(mesh, [&](FaceId face, FaceId other) {
    const double angle = angle_degrees(of_face[face.index()], of_face[other.index()]);
    is_bent = is_bent || angle > same_direction;
    if (has_means[face.index()] == 0 || !sums.is_beside(face, other) || angle <= doubts.sharpest_mean) return;
    doubts.sharpest_mean = angle;
    doubts.sharpest = {face, other};
  });
  doubts.are_of_faces = is_bent && in_use > 0 && of_faces == in_use;
  return doubts;
}

}  // namespace sightline::inline geometry
