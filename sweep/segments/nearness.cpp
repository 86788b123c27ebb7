#include "sweep/segments/nearness.h"

#include "geometry/mesh/facet_plane.h"
#include "geometry/projection/camera_forms.h"

namespace sightline::inline sweep {
namespace {

// Negates all where k < 0.
template <class Number>
Nearness<Number> with_positive_divisor(const Nearness<Number>& form, bool is_negative) {
  return is_negative ? Nearness<Number>{-form.a, -form.b, -form.c, -form.k} : form;
}

template <class Number, class Vector>
Nearness<Number> nearness_of_plane(Projection projection, const Vector& normal, const Number& at_corner) {
  if (projection == Projection::perspective) return {normal.x(), normal.y(), normal.z(), at_corner};
  return {normal.x(), normal.y(), -at_corner, normal.z()};
}

}  // namespace

// The ways along the plane are taken before they are turned into the camera's coordinates: small facets that are far away
// would else lose what they have of bits.
std::optional<Nearness<Bounded>> bounded_nearness(const ProjectedScene& scene, FacetId surface) {
  const auto corners = depth_plane_corners(scene.mesh(), surface);
  const CameraForms<Bounded> forms(scene.camera);
  const auto position = [&](std::size_t i) { return bounded(scene.mesh().position(corners[i])); };
  const auto in_camera = [&](const BoundedVector& way) {
    return BoundedVector(forms.value(forms.right, way), forms.value(forms.up, way), forms.value(forms.forward, way));
  };
  const BoundedVector u = in_camera(position(1) - position(0));
  const BoundedVector v = in_camera(position(2) - position(0));
  const BoundedVector normal(u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(),
                             u.x() * v.y() - u.y() * v.x());
  const Bounded at_corner = forms.value(normal, in_camera(position(0) - forms.origin));
  const auto form = nearness_of_plane(scene.camera.projection, normal, at_corner);
  if (!form.k.is_positive() && !form.k.is_negative()) return std::nullopt;
  return with_positive_divisor(form, form.k.is_negative());
}

// Each corner is (X, Y, depth, one), and so a common multiple of what the method says.
const Nearness<BigInteger>& ExactNearness::of(FacetId surface) {
  const auto [known, is_new] = known_.try_emplace(surface.value);
  if (!is_new) return known->second;
  using Vector = CameraForms<BigInteger>::Vector;
  const auto corners = depth_plane_corners(scene_.mesh(), surface);
  std::array<ExactCorner, 3> p;
  std::ranges::transform(corners, p.begin(), [&](VertexId v) { return corners_.of(scene_.mesh(), v); });
  const auto place = [&](std::size_t i) { return Vector(p[i].x, p[i].y, p[i].depth); };
  const auto way_to = [&](std::size_t i) { return Vector(place(i) * p[0].one - place(0) * p[i].one); };
  const Vector u = way_to(1);
  const Vector v = way_to(2);
  const Vector normal(u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(), u.x() * v.y() - u.y() * v.x());
  const BigInteger at_corner = normal.x() * p[0].x + normal.y() * p[0].y + normal.z() * p[0].depth;
  const Vector scaled = normal * p[0].one;
  known->second = nearness_of_plane<BigInteger>(scene_.camera.projection, scaled, at_corner);
  known->second = with_positive_divisor(known->second, known->second.k < 0);
  return known->second;
}

}  // namespace sightline::inline sweep
