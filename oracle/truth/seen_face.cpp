#include "oracle/truth/seen_face.h"

#include <algorithm>
#include <array>
#include <span>

#include "oracle/truth/camera_point.h"

namespace sightline::oracle::image {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Triple = std::array<Integer, 3>;

// Returns twice the area of a triangle's projection along one of the four axes, with a sign.
Integer determinant(const Triple& p, const Triple& q, const Triple& r) {
  return p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
}

Plane plane_through(const CameraPoint& p, const CameraPoint& q, const CameraPoint& r) {
  const auto& [px, py, pw] = p.place;
  const auto& [qx, qy, qw] = q.place;
  const auto& [rx, ry, rw] = r.place;
  return {determinant({py, p.nearness, pw}, {qy, q.nearness, qw}, {ry, r.nearness, rw}),
          -determinant({px, p.nearness, pw}, {qx, q.nearness, qw}, {rx, r.nearness, rw}),
          determinant({px, py, pw}, {qx, qy, qw}, {rx, ry, rw}),
          -determinant({px, py, p.nearness}, {qx, qy, q.nearness}, {rx, ry, r.nearness})};
}

// The corners are coplanar: the triangles of a fan have multiples of one plane, and the sum is that of the whole area.
Plane plane_of(const std::vector<CameraPoint>& corners) {
  Plane sum;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Plane plane = plane_through(corners[0], corners[i], corners[i + 1]);
    sum = {sum.a + plane.a, sum.b + plane.b, sum.n + plane.n, sum.d + plane.d};
  }
  return sum;
}

Plane reduced(const Plane& plane) {
  const Integer divisor = gcd(gcd(plane.a, plane.b), gcd(plane.n, plane.d));
  return {plane.a / divisor, plane.b / divisor, plane.n / divisor, plane.d / divisor};
}

// Returns where the plane is farther than a distance. For a pinhole that is W >= distance * N, for an orthographic
// camera -N >= distance * W; N is -(a X + b Y + d W) / n.
Line where_beyond(const Plane& plane, double distance, bool perspective) {
  const Rational exact(distance);
  const Integer top = numerator(exact);
  const Integer bottom = denominator(exact);
  if (perspective) return {top * plane.a, top * plane.b, bottom * plane.n + top * plane.d};
  return {bottom * plane.a, bottom * plane.b, bottom * plane.d - top * plane.n};
}

// What lies in the near or the far plane is out of view.
Outline cut_to_bound(const Outline& outline, const Line& form) {
  return form == Line{} ? Outline{} : cut(outline, form);
}

Outline cut_to_view(const Outline& outline, const Plane& plane, const Camera& camera) {
  const bool perspective = camera.projection == Projection::perspective;
  Outline result = cut_to_window(outline);
  if (camera.near_distance) result = cut_to_bound(result, where_beyond(plane, *camera.near_distance, perspective));
  if (camera.far_distance) {
    result = cut_to_bound(result, opposite(where_beyond(plane, *camera.far_distance, perspective)));
  }
  return result;
}

class Collector {
 public:
  Collector(const PolygonMesh& mesh, const Camera& camera, Sides sides)
      : mesh_(mesh), camera_(camera), sides_(sides), exact_(exact_camera(mesh, camera)) {}

  // in_plane_of: a polygon in whose plane this one has its depths.
  void add(FaceId face, std::span<const VertexId> polygon, std::span<const VertexId> in_plane_of) {
    std::vector<CameraPoint> corners = points_of(polygon);
    Plane plane = plane_of(corners);
    const int facing = plane.n.sign() * exact_.handedness;
    if (facing == 0 || (facing < 0 && sides_ == Sides::front)) return;
    if (plane.n < 0) std::reverse(corners.begin(), corners.end());
    plane = upright(plane);
    const std::size_t seen_before = faces.size();
    add(face, reduced(plane), corners, facing > 0);
    if (faces.size() == seen_before || in_plane_of.data() == polygon.data()) return;
    const Plane of_depths = upright(plane_of(points_of(in_plane_of)));
    if (of_depths.n == 0 || !is_before_eye(of_depths, corners)) return faces.pop_back();
    faces.back().plane = reduced(of_depths);
  }

  std::vector<SeenFace> faces;

 private:
  [[nodiscard]] std::vector<CameraPoint> points_of(std::span<const VertexId> polygon) const {
    std::vector<CameraPoint> points;
    for (const VertexId v : polygon) points.push_back(camera_point(exact_, mesh_.position(v)));
    return points;
  }

  [[nodiscard]] static Plane upright(const Plane& plane) {
    return plane.n < 0 ? Plane{-plane.a, -plane.b, -plane.n, -plane.d} : plane;
  }

  // Parallel rays meet every plane somewhere.
  [[nodiscard]] bool is_before_eye(const Plane& plane, const std::vector<CameraPoint>& corners) const {
    if (camera_.projection == Projection::orthographic) return true;
    return std::ranges::all_of(corners, [&](const CameraPoint& p) {
      const auto& [x, y, w] = p.place;
      return plane.a * x + plane.b * y + plane.d * w < 0;
    });
  }

  void add(FaceId face, const Plane& plane, const std::vector<CameraPoint>& corners, bool is_front) {
    std::vector<Point> places;
    for (const CameraPoint& p : corners) places.push_back(reduced(p.place));
    const Outline outline = cut_to_view(outline_of(places), plane, camera_);
    if (!outline.empty()) faces.push_back({face, plane, outline, is_front});
  }

  const PolygonMesh& mesh_;
  const Camera& camera_;
  Sides sides_;
  ExactCamera exact_;
};

}  // namespace

std::vector<SeenFace> seen_faces(const PolygonMesh& mesh, const Camera& camera, Sides sides,
                                 const std::vector<FacetId>& planes) {
  Collector collector(mesh, camera, sides);
  const auto polygon_of_plane = [&](std::size_t facet, std::span<const VertexId> own) {
    return planes.empty() || planes[facet].index() == facet ? own : mesh.corners(planes[facet]);
  };
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const FaceId face(f);
    const std::size_t first = mesh.first_facet(face);
    const std::size_t end = mesh.end_facet(face);
    if (first == end) continue;
    if (mesh.face_planar[f] != 0) {
      collector.add(face, mesh.faces[f], polygon_of_plane(first, mesh.faces[f]));
    } else {
      for (std::size_t k = first; k < end; ++k)
        collector.add(face, mesh.corners(FacetId(k)), polygon_of_plane(k, mesh.corners(FacetId(k))));
    }
  }
  return std::move(collector.faces);
}

Line where_nearer(const Plane& p, const Plane& q) {
  return reduced(Line{p.n * q.a - q.n * p.a, p.n * q.b - q.n * p.b, p.n * q.d - q.n * p.d});
}

}  // namespace sightline::oracle::image
