// The depth of facets: the part of StepPredicates that follows DepthOrder (depth_order.h) through its cases.
#include "geometry/mesh/facet_plane.h"
#include "geometry/projection/unfiltered.h"
#include "trace/step_predicates.h"

namespace sightline::trace {

void StepPredicates::add_depth(FacetId f, FacetId g) {
  const bool nearer = depth_.nearer(f, g);
  const FacetId front = nearer ? f : g;
  const FacetId back = nearer ? g : f;
  if (!ranges_.empty() && ranges_[front.index()].farthest < ranges_[back.index()].nearest) {
    add_verdict(front, back, "ranges", "all of it is less deep");
  } else if (whole_of(f) == whole_of(g)) {
    add_verdict(front, back, "rule", "they are parts of one face");
  } else if (mesh_.is_cut() && pieces_.applies_to(whole_of(f), whole_of(g))) {
    add_verdict(front, back, "exact", "they were cut along their common line");
  } else if (!add_corners_against_plane(std::min(f, g), std::max(f, g)) &&
             !add_corners_against_plane(std::max(f, g), std::min(f, g))) {
    add_verdict(front, back, "exact", "where the eye sees them overlap");
  }
}

// As DepthOrder: stops as soon as f is known to straddle g's plane.
bool StepPredicates::add_corners_against_plane(FacetId f, FacetId g) {
  bool front = false;
  bool behind = false;
  for (const VertexId v : corners(f)) {
    const Sign side = add_corner_against_plane(v, g);
    front = front || side > 0;
    behind = behind || side < 0;
    if (front && behind) return false;
  }
  if (!front && !behind) add_verdict(std::min(f, g), std::max(f, g), "rule", "in one plane the lower face is in front");
  return true;
}

Sign StepPredicates::add_corner_against_plane(VertexId v, FacetId plane) {
  std::array<VertexId, 3> abc = plane_corners(mesh_, plane);
  if (scene_.facing[plane.index()] == Facing::back) std::swap(abc[1], abc[2]);
  LoggedPredicate predicate{"depth", {}, "orient3d(a, b, c, d)", {}, 0, {}, to_string(scene_.arithmetic)};
  for (const VertexId corner : {abc[0], abc[1], abc[2], v}) {
    const Point3& p = mesh_.position(corner);
    predicate.operands.push_back({name_of_vertex(corner, names_), {p.x(), p.y(), p.z()}});
  }
  const Point3& a = mesh_.position(abc[0]);
  const Point3& b = mesh_.position(abc[1]);
  const Point3& c = mesh_.position(abc[2]);
  const HomogeneousPoint d{mesh_.position(v), 1};
  const std::optional<Sign> filtered = predicates::filter::orient3d(a, b, c, d);
  const Sign exact = filtered ? *filtered : predicates::exact::orient3d(a, b, c, d);
  predicate.sign = exact;
  if (scene_.arithmetic == Arithmetic::exact) {
    predicate.decided_by = filtered ? "filter" : "exact";
  } else {
    predicate.sign = unfiltered::orient3d(scene_.arithmetic, a, b, c, d);
    if (predicate.sign != exact) predicate.exact_sign = exact;
  }
  const char* place = predicate.sign > 0 ? " lies before " : (predicate.sign < 0 ? " lies behind " : " lies in ");
  predicate.says = predicate.operands.back().name + place + "the plane of " + name(plane);
  found_.push_back(predicate);
  return predicate.sign;
}

void StepPredicates::add_verdict(FacetId f, FacetId g, const std::string& decided_by, const std::string& because) {
  LoggedPredicate verdict{"depth", name(f) + " is in front of " + name(g) + ": " + because, "", {}, 1, {}, decided_by};
  if (decided_by == "ranges") {
    verdict.formula = "farthest of the one < nearest of the other";
    verdict.operands = {{name(f), {ranges_[f.index()].farthest}}, {name(g), {ranges_[g.index()].nearest}}};
  }
  found_.push_back(std::move(verdict));
}

std::span<const VertexId> StepPredicates::corners(FacetId f) const {
  return mesh_.is_cut() ? mesh_.cuts.wholes[whole_of(f).index()] : mesh_.corners(f);
}

WholeId StepPredicates::whole_of(FacetId f) const {
  return mesh_.is_cut() ? mesh_.cuts.whole_of[f.index()] : WholeId(f.index());
}

}  // namespace sightline::trace
