#include "sweep/unrounded/swap_edges.h"

#include <algorithm>

#include "geometry/mesh/facet_plane.h"

namespace sightline::inline sweep {

EdgeId SwapEdges::between(FacetId f, FacetId g) {
  const auto [first, second] = std::minmax({surface_of(scene_.mesh(), f), surface_of(scene_.mesh(), g)});
  const auto [known, is_new] = known_.try_emplace(std::uint64_t{first.value} << 32 | second.value);
  if (is_new) {
    known->second = EdgeId(scene_.edge_count() + edges_.size());
    edges_.push_back(made(first, second));
  }
  return known->second;
}

Sign SwapEdges::nearer_side(EdgeId e, FacetId f) const {
  const SwapEdge& edge = edges_[e.index() - scene_.edge_count()];
  return surface_of(scene_.mesh(), f) == edge.surfaces[0] ? edge.first_nearer : -edge.first_nearer;
}

// A line runs down where a > 0, and a horizontal one to the right where b > 0.
SwapEdge SwapEdges::made(FacetId f, FacetId g) {
  const Nearness& of_f = nearness(f);
  const Nearness& of_g = nearness(g);
  ExactLine line{of_f.a * of_g.k - of_g.a * of_f.k, of_f.b * of_g.k - of_g.b * of_f.k,
                 of_f.c * of_g.k - of_g.c * of_f.k};
  if (line.a == 0 && line.b == 0) return {{f, g}, line, 0, 0, 1, sign_of(line.c), false};
  const bool runs_down = line.a > 0 || (line.a == 0 && line.b > 0);
  BigInteger divisor = gcd(gcd(line.a, line.b), line.c);
  if (!runs_down) divisor = -divisor;
  line = {line.a / divisor, line.b / divisor, line.c / divisor};
  const BigInteger largest = std::max({BigInteger(abs(line.a)), BigInteger(abs(line.b)), BigInteger(abs(line.c))});
  return {{f, g},
          line,
          rounded_quotient(line.a, largest),
          rounded_quotient(line.b, largest),
          rounded_quotient(line.c, largest),
          runs_down ? 1 : -1,
          true};
}

// With n_i the nearness of corner P_i, and its coordinates the columns of a matrix of determinant k, the form is the sum of
// n_i times the cross product of the other two: at P_i it is n_i k.
const SwapEdges::Nearness& SwapEdges::nearness(FacetId surface) {
  const auto [known, is_new] = nearness_.try_emplace(surface);
  Nearness& form = known->second;
  if (!is_new) return form;
  const Camera& camera = scene_.camera;
  const bool perspective = camera.projection == Projection::perspective;
  std::array<ExactCorner, 3> corners;
  std::ranges::transform(plane_corners(scene_.mesh(), surface), corners.begin(),
                         [&](VertexId v) { return exact_corner(scene_.mesh(), v, camera); });
  for (std::size_t i = 0; i < 3; ++i) {
    const ExactLine opposite = line_through(place_of(corners[(i + 1) % 3]), place_of(corners[(i + 2) % 3]));
    const BigInteger near = perspective ? corners[i].one : BigInteger(-corners[i].depth);
    form.a += near * opposite.a;
    form.b += near * opposite.b;
    form.c += near * opposite.c;
    if (i == 0) form.k = opposite.a * corners[0].x + opposite.b * corners[0].y + opposite.c * corners[0].w;
  }
  if (form.k < 0) form = {-form.a, -form.b, -form.c, -form.k};
  return form;
}

}  // namespace sightline::inline sweep
