#include "geometry/cutting/facet_contact.h"

#include <algorithm>
#include <array>
#include <boost/container/small_vector.hpp>

namespace sightline::inline geometry {
namespace {

// There is one sign per corner.
using CornerSigns = boost::container::small_vector<Sign, 8>;

bool has_corner(const ConvexFacet& facet, VertexId corner) {
  return std::find(facet.corners.begin(), facet.corners.end(), corner) != facet.corners.end();
}

// Both facets contain their shared corners, so also the hull of these; here the corners are on one line. They share all
// of that hull if it runs along shared edges, each from one shared corner to the next.
Contact contact_along_shared_corners(const ConvexFacet& a, const ConvexFacet& b) {
  const auto corners = std::count_if(a.corners.begin(), a.corners.end(), [&](VertexId v) { return has_corner(b, v); });
  if (corners < 2) return Contact::none;
  const auto a_edges = a.edges();
  const auto b_edges = b.edges();
  const auto edges = std::count_if(a_edges.begin(), a_edges.end(), [&](MeshEdgeId e) {
    return std::find(b_edges.begin(), b_edges.end(), e) != b_edges.end();
  });
  return edges == corners - 1 ? Contact::none : Contact::touching;
}

struct SignSummary {
  bool negative = false;
  bool positive = false;
  bool zero_apart = false;  // a corner on the plane or line that the other facet does not share
};

SignSummary summarise(const CornerSigns& signs, const ConvexFacet& facet, const ConvexFacet& other) {
  SignSummary summary;
  for (std::size_t i = 0; i < signs.size(); ++i) {
    if (signs[i] < 0) summary.negative = true;
    if (signs[i] > 0) summary.positive = true;
    if (signs[i] == 0 && !has_corner(other, facet.corners[i])) summary.zero_apart = true;
  }
  return summary;
}

// Returns whether all corners but the shared ones lie strictly on one side.
bool is_clear(const SignSummary& s) { return s.negative != s.positive && !s.zero_apart; }

// Returns on which sides of `other`'s plane `facet`'s corners lie.
CornerSigns sides_of_plane(const ConvexFacet& facet, const ConvexFacet& other) {
  const FacetPlane plane = plane_of(other);
  CornerSigns signs;
  for (std::size_t i = 0; i < facet.size(); ++i) {
    signs.push_back(has_corner(other, facet.corners[i]) ? 0 : side_of(plane, facet.position(i)));
  }
  return signs;
}

// A facet meets the other's plane in an interval of the planes' common line, which is seen in the direction of the
// cross product of the facet's normal with the other's. Each end is on an edge, given from its corner in front of the
// other's plane to its corner behind or on it.
struct PlaneInterval {
  std::array<Point3, 2> low;
  std::array<Point3, 2> high;
};

// The facet runs counter-clockwise around its normal, so it leaves the front side at the interval's high end.
// Precondition: it has corners strictly on both sides.
PlaneInterval plane_interval(const ConvexFacet& facet, const CornerSigns& sides) {
  PlaneInterval interval;
  for (std::size_t i = 0; i < facet.size(); ++i) {
    const std::size_t next = facet.next(i);
    if (sides[i] > 0 && sides[next] <= 0) interval.high = {facet.position(i), facet.position(next)};
    if (sides[i] <= 0 && sides[next] > 0) interval.low = {facet.position(next), facet.position(i)};
  }
  return interval;
}

// Two lines meet the common line of the planes of a and b, each from front to back of the other's plane; the first is
// in the plane of a. Returns +1 where the second meets it later in the direction of (normal of a) x (normal of b), 0
// where both meet it at one point.
//
// With directions s and t and meeting points P and Q = P + lambda u, u = n_a x n_b, orient3d is det(s, Q - P, t) =
// lambda u . (t x s) = lambda (n_a . t) (n_b . s), since n_a . s = 0, and both factors are negative.
Sign order_along(const std::array<Point3, 2>& in_a, const std::array<Point3, 2>& in_b) {
  return orient3d(in_a[0], in_a[1], in_b[0], in_b[1]);
}

// b's interval is seen in the opposite direction, so its high end is the low one for a.
bool intervals_overlap(const PlaneInterval& a, const PlaneInterval& b) {
  return order_along(a.low, b.low) > 0 && order_along(a.high, b.high) < 0;
}

bool straddles(const SignSummary& s) { return s.negative && s.positive; }

bool crosses(const ConvexFacet& a, const CornerSigns& a_sides, const ConvexFacet& b, const CornerSigns& b_sides) {
  return straddles(summarise(a_sides, a, b)) && straddles(summarise(b_sides, b, a)) &&
         intervals_overlap(plane_interval(a, a_sides), plane_interval(b, b_sides));
}

// Returns whether an edge of `facet` that passes strictly through the plane of `other` meets `other`.
bool touches_with_edge(const ConvexFacet& facet, const CornerSigns& sides, const ConvexFacet& other) {
  for (std::size_t i = 0; i < facet.size(); ++i) {
    if (sides[i] * sides[facet.next(i)] >= 0) continue;
    if (place_of_line(other, facet.position(i), {facet.position(facet.next(i)), 1}) != Place::outside) return true;
  }
  return false;
}

// Returns whether a corner of `facet` that `other` does not share lies in `other`.
bool touches_with_corner(const ConvexFacet& facet, const CornerSigns& sides, const ConvexFacet& other) {
  const int axis = projection_axis(plane_of(other));
  for (std::size_t i = 0; i < facet.size(); ++i) {
    if (sides[i] != 0 || has_corner(other, facet.corners[i])) continue;
    if (place_of_point(other, axis, facet.position(i)) != Place::outside) return true;
  }
  return false;
}

Contact contact_across_planes(const ConvexFacet& a, const CornerSigns& a_sides, const ConvexFacet& b,
                              const CornerSigns& b_sides) {
  if (crosses(a, a_sides, b, b_sides)) return Contact::crossing;
  if (touches_with_edge(a, a_sides, b) || touches_with_edge(b, b_sides, a)) return Contact::touching;
  if (touches_with_corner(a, a_sides, b) || touches_with_corner(b, b_sides, a)) return Contact::touching;
  return contact_along_shared_corners(a, b);
}

// For each edge of one facet this has the sides of the other facet's corners, positive towards the inside.
using SideTable = boost::container::small_vector<CornerSigns, 4>;

// Returns on which sides of `other`'s edge from corner `edge` on the corners of `facet` lie, for other's orientation in
// the projection.
CornerSigns sides_of_edge(const ConvexFacet& facet, const ConvexFacet& other, std::size_t edge, int axis,
                          Sign orientation) {
  const VertexId from = other.corners[edge];
  const VertexId to = other.corners[other.next(edge)];
  const Point2 p = drop_axis(other.position(edge), axis);
  const Point2 q = drop_axis(other.position(other.next(edge)), axis);
  CornerSigns signs;
  for (std::size_t i = 0; i < facet.size(); ++i) {
    const bool is_end = facet.corners[i] == from || facet.corners[i] == to;
    signs.push_back(is_end ? 0 : orientation * side_of_line(p, q, drop_axis(facet.position(i), axis)));
  }
  return signs;
}

SideTable sides_of_edges(const ConvexFacet& facet, const ConvexFacet& other, int axis) {
  const Sign orientation = orientation_in(plane_of(other), axis);
  SideTable table;
  for (std::size_t edge = 0; edge < other.size(); ++edge) {
    table.push_back(sides_of_edge(facet, other, edge, axis, orientation));
  }
  return table;
}

// Returns whether the line of an edge has the facet strictly outside, but for shared corners.
bool is_separated(const ConvexFacet& facet, const SideTable& table, const ConvexFacet& other) {
  return std::any_of(table.begin(), table.end(), [&](const CornerSigns& signs) {
    const SignSummary s = summarise(signs, facet, other);
    return is_clear(s) && s.negative;
  });
}

bool has_corner_inside(const ConvexFacet& facet, const SideTable& table, const ConvexFacet& other) {
  for (std::size_t i = 0; i < facet.size(); ++i) {
    const bool inside =
        std::none_of(table.begin(), table.end(), [i](const CornerSigns& signs) { return signs[i] < 0; });
    if (inside && !has_corner(other, facet.corners[i])) return true;
  }
  return false;
}

// a_sides are those of a's corners, per edge of b, and b_sides those of b's corners, per edge of a.
bool edges_cross(const ConvexFacet& a, const SideTable& a_sides, const ConvexFacet& b, const SideTable& b_sides) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (a_sides[j][i] * a_sides[j][a.next(i)] < 0 && b_sides[i][j] * b_sides[i][b.next(j)] < 0) return true;
    }
  }
  return false;
}

// Returns whether the corners that the facets share do not lie on one line: then they overlap in the hull of these.
bool shared_corners_span_area(const ConvexFacet& a, const ConvexFacet& b) {
  boost::container::small_vector<Point3, 4> shared;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (has_corner(b, a.corners[i])) shared.push_back(a.position(i));
  }
  if (shared.size() < 3) return false;
  return std::any_of(shared.begin(), shared.end(),
                     [&](const Point3& p) { return !collinear(shared[0], shared[1], p); });
}

Contact contact_in_plane(const ConvexFacet& a, const ConvexFacet& b) {
  const int axis = projection_axis(plane_of(a));
  const SideTable a_sides = sides_of_edges(a, b, axis);
  if (is_separated(a, a_sides, b)) return contact_along_shared_corners(a, b);
  const SideTable b_sides = sides_of_edges(b, a, axis);
  if (is_separated(b, b_sides, a)) return contact_along_shared_corners(a, b);
  if (has_corner_inside(a, a_sides, b) || has_corner_inside(b, b_sides, a)) return Contact::touching;
  if (edges_cross(a, a_sides, b, b_sides) || shared_corners_span_area(a, b)) return Contact::touching;
  return contact_along_shared_corners(a, b);
}

}  // namespace

// A facet that is clear of the other's plane meets it in the hull of the corners they share.
Contact contact_of(const ConvexFacet& a, const ConvexFacet& b) {
  const CornerSigns b_sides = sides_of_plane(b, a);
  const SignSummary b_summary = summarise(b_sides, b, a);
  if (is_clear(b_summary)) return contact_along_shared_corners(a, b);
  if (!b_summary.negative && !b_summary.positive) return contact_in_plane(a, b);
  const CornerSigns a_sides = sides_of_plane(a, b);
  if (is_clear(summarise(a_sides, a, b))) return contact_along_shared_corners(a, b);
  return contact_across_planes(a, a_sides, b, b_sides);
}

}  // namespace sightline::inline geometry
