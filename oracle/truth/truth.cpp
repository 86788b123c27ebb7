#include "oracle/truth/truth.h"

#include <algorithm>

#include "oracle/truth/covered_area.h"
#include "oracle/truth/seen_face.h"

namespace sightline::oracle {
namespace {

using image::Line;
using image::Outline;
using image::seen_faces;
using image::SeenFace;
using image::Shape;
using image::where_nearer;

// Of faces in one plane those that look at the eye are in front, and then the lower index.
bool is_in_front_in_plane(const std::vector<SeenFace>& faces, std::size_t a, std::size_t b) {
  return faces[a].is_front == faces[b].is_front ? a < b : faces[a].is_front;
}

// Returns where `other` hides the face of `faces` with this index.
Outline hiding_part(const std::vector<SeenFace>& faces, std::size_t other, std::size_t hidden) {
  const Line nearer = where_nearer(faces[other].plane, faces[hidden].plane);
  if (nearer == Line{}) return is_in_front_in_plane(faces, other, hidden) ? faces[other].outline : Outline{};
  return cut(faces[other].outline, nearer);
}

// The face comes first, then a shape for each other face that hides some place.
std::vector<Shape> face_and_hiders(const std::vector<SeenFace>& faces, std::size_t face) {
  std::vector<Shape> shapes{{faces[face].outline}};
  for (std::size_t other = 0; other < faces.size(); ++other) {
    if (other == face) continue;
    if (Outline part = hiding_part(faces, other, face); !part.empty()) shapes.push_back({std::move(part)});
  }
  return shapes;
}

std::vector<Shape> window_and_faces(const std::vector<SeenFace>& faces) {
  std::vector<Shape> shapes{{image::window()}};
  for (const SeenFace& face : faces) shapes.push_back({face.outline});
  return shapes;
}

// Returns whether nothing of the shapes [first, end) is there.
bool none(const std::vector<int>& windings, std::size_t first, std::size_t end) {
  return std::all_of(windings.begin() + static_cast<std::ptrdiff_t>(first),
                     windings.begin() + static_cast<std::ptrdiff_t>(end), [](int winding) { return winding <= 0; });
}

Truth truth_of(const std::vector<SeenFace>& faces, std::size_t face_count) {
  const auto alone = [](const std::vector<int>& windings) { return none(windings, 1, windings.size()); };
  Truth truth{std::vector<Rational>(face_count), area_where(window_and_faces(faces), alone)};
  for (std::size_t i = 0; i < faces.size(); ++i) {
    truth.visible_area[faces[i].face.index()] += area_where(face_and_hiders(faces, i), alone);
  }
  return truth;
}

image::Point point_of(const RationalPoint& p) {
  const image::Integer w = lcm(denominator(p.x), denominator(p.y));
  return {numerator(p.x) * (w / denominator(p.x)), numerator(p.y) * (w / denominator(p.y)), w};
}

// Returns what is claimed for each face; for most it may be nothing.
std::vector<Shape> claimed_shapes(const std::vector<Claim>& claims, std::size_t face_count) {
  std::vector<Shape> shapes(face_count);
  for (const Claim& claim : claims) {
    for (const auto& ring : claim.rings) {
      std::vector<image::Point> corners;
      for (const RationalPoint& p : ring) corners.push_back(point_of(p));
      shapes[claim.face.index()].push_back(image::outline_of(corners));
    }
  }
  return shapes;
}

// Returns the area of those places that only the first shape covers where, of all claims, only the one with this index
// is there, or none where it is the index of no claim.
Rational rightly_claimed(std::vector<Shape> shapes, const std::vector<Shape>& claimed, std::size_t right) {
  const std::size_t first_claim = shapes.size();
  shapes.insert(shapes.end(), claimed.begin(), claimed.end());
  const std::size_t right_claim = first_claim + right;
  return area_where(shapes, [=](const std::vector<int>& windings) {
    if (right_claim >= windings.size()) return none(windings, 1, windings.size());
    return windings[right_claim] > 0 && none(windings, 1, right_claim) &&
           none(windings, right_claim + 1, windings.size());
  });
}

}  // namespace

Truth true_visibility(const PolygonMesh& mesh, const Camera& camera, Sides sides, const std::vector<FacetId>& planes) {
  return truth_of(seen_faces(mesh, camera, sides, planes), mesh.face_count());
}

Comparison compare(const PolygonMesh& mesh, const Camera& camera, Sides sides, const std::vector<Claim>& claims) {
  const std::vector<SeenFace> faces = seen_faces(mesh, camera, sides);
  const std::vector<Shape> claimed = claimed_shapes(claims, mesh.face_count());
  Rational right = rightly_claimed(window_and_faces(faces), claimed, claimed.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    right += rightly_claimed(face_and_hiders(faces, i), claimed, faces[i].face.index());
  }
  return {truth_of(faces, mesh.face_count()), 4 - right};
}

}  // namespace sightline::oracle
