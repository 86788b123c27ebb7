#include "sweep/plain/snapped_order.h"

#include "geometry/numbers/exact_position.h"

namespace sightline::inline sweep {

Sign SnappedOrder::nearer_at(FacetId f, FacetId g, VertexId corner) { return nearer_on(f, g, ray_to(corner)); }

// The ray is the one between c and d that is in the plane through the eye, a and b.
Sign SnappedOrder::nearer_at_crossing(FacetId f, FacetId g, VertexId a, VertexId b, VertexId c, VertexId d) {
  const ExactVector across = cross(ray_to(a), ray_to(b));
  const ExactVector to_c = ray_to(c);
  const ExactVector to_d = ray_to(d);
  const BigInteger of_c = abs(dot(across, to_d));
  const BigInteger of_d = abs(dot(across, to_c));
  return nearer_on(f, g, ExactVector(to_c * of_c + to_d * of_d));
}

// Without perspective W is what all of the corner is a multiple by.
ExactVector SnappedOrder::ray_to(VertexId corner) {
  const ExactCorner exact = corners_.of(scene_.mesh(), corner);
  return {exact.x, exact.y, exact.w};
}

Sign SnappedOrder::nearer_on(FacetId f, FacetId g, const ExactVector& ray) {
  const Nearness<BigInteger>& of_f = nearness_.of(f);
  const Nearness<BigInteger>& of_g = nearness_.of(g);
  const auto at = [&](const Nearness<BigInteger>& form) {
    return BigInteger(form.a * ray.x() + form.b * ray.y() + form.c * ray.z());
  };
  return sign_of(BigInteger(at(of_f) * of_g.k - at(of_g) * of_f.k));
}

}  // namespace sightline::inline sweep
