#include "trace/step_predicates.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/mesh/facet_plane.h"
#include "geometry/projection/unfiltered.h"
#include "sweep/segments/image_decisions.h"

namespace sightline::trace {

namespace {

struct ImageSign {
  Sign sign = 0;
  std::optional<Sign> exact;  // where it differs
};

// Returns the sign of a planar test of the sweep, in the scene's arithmetic and exactly; `ask` is a function of a
// decisions policy (image_decisions.h).
template <class Ask>
ImageSign image_sign(Arithmetic arithmetic, const Ask& ask) {
  const Sign exact = ask(ExactDecisions{});
  if (arithmetic == Arithmetic::exact) return {exact, std::nullopt};
  const Sign sign = arithmetic == Arithmetic::single_precision ? ask(UnfilteredDecisions<float>{})
                                                               : ask(UnfilteredDecisions<double>{});
  return {sign, sign == exact ? std::nullopt : std::optional<Sign>(exact)};
}

ImageSign side_of_edge(const ProjectedScene& scene, EdgeId edge, PointId point) {
  const SceneEdge& e = scene.edge(edge);
  return image_sign(scene.arithmetic, [&](auto decisions) {
    return decisions.side(scene.point(e.top), scene.point(e.bottom), scene.point(point));
  });
}

ImageSign turn_of_edges(const ProjectedScene& scene, EdgeId a, EdgeId b) {
  return image_sign(scene.arithmetic, [&](auto decisions) {
    const auto direction = [&](EdgeId e) {
      return decisions.direction(scene.point(scene.edge(e).top), scene.point(scene.edge(e).bottom));
    };
    return decisions.turn(direction(a), direction(b));
  });
}

}  // namespace

StepPredicates::StepPredicates(const SweepLog& log, const SceneNames& names)
    : mesh_(log.scene.mesh()),
      log_(log),
      scene_(log.scene),
      names_(names),
      ranges_(log.scene.arithmetic == Arithmetic::exact ? depth_ranges(log.scene) : std::vector<DepthRange>{}),
      depth_(log.scene, ranges_),
      pieces_(log.scene) {}

// Insertion sort ends whatever the order is. Where depths are no order the topmost facet need not be the first.
void StepPredicates::sort_by_depth(std::vector<FacetId>& facets, FacetId topmost) {
  for (std::size_t i = 1; i < facets.size(); ++i) {
    for (std::size_t k = i; k > 0 && depth_.nearer(facets[k], facets[k - 1]); --k) std::swap(facets[k], facets[k - 1]);
  }
  const auto first = std::find(facets.begin(), facets.end(), topmost);
  if (first != facets.end()) std::rotate(facets.begin(), first, first + 1);
}

std::vector<LoggedPredicate> StepPredicates::of(const SweepStep& step, std::span<const LoggedBundle> before,
                                                std::span<const LoggedBundle> after) {
  found_.clear();
  add_order(step);
  add_sides(step, before, after);
  add_directions(step);
  add_meetings(step, after);
  add_depths(step, before);
  return std::move(found_);
}

// Two crossings of nearly the same height need wide integers, anything else does not.
void StepPredicates::add_order(const SweepStep& step) {
  if (step.upcoming.empty()) return;
  const SweepPlace& next = step.upcoming.front();
  const bool both_cross = !step.place.vertex.valid() && !next.vertex.valid();
  const bool far_apart = std::fabs(std::ldexp(step.place.y - next.y, scene_.grid_bits)) > crossing_order_bound;
  const auto operand_of = [](std::string name, const SweepPlace& place) {
    return Operand{std::move(name), {place.x, place.y}};
  };
  const std::string next_name = next.vertex.valid() ? log_.point_names[next.vertex.index()]
                                                    : "the crossing of " + name(next.crossings.front()[0]) + " and " +
                                                          name(next.crossings.front()[1]);
  const std::string exactly = !both_cross ? "integers" : (far_apart ? "filter" : "exact");
  found_.push_back({"order",
                    step.name + " comes before " + next_name + (step.place.y == next.y ? ": further left" : ": higher"),
                    "y descending, then x ascending",
                    {operand_of(step.name, step.place), operand_of(next_name, next)},
                    -1,
                    {},
                    scene_.arithmetic == Arithmetic::exact ? exactly : to_string(scene_.arithmetic)});
}

void StepPredicates::add_sides(const SweepStep& step, std::span<const LoggedBundle> before,
                               std::span<const LoggedBundle> after) {
  const PointId point = step.place.vertex;
  if (!point.valid()) return;
  if (step.position > 0) add_side(after[step.position - 1].edges.front(), point);
  for (const LoggedBundle& bundle : before.subspan(step.position, step.removed)) {
    const EdgeId edge = bundle.edges.front();
    if (scene_.edge(edge).bottom != point) add_side(edge, point);
  }
  const std::size_t right = step.position + step.inserted.size();
  if (right < after.size()) add_side(after[right].edges.front(), point);
}

void StepPredicates::add_directions(const SweepStep& step) {
  EdgeId last;
  for (const LoggedBundle& bundle : step.inserted) {
    for (const EdgeId edge : bundle.edges) {
      if (last.valid()) add_direction(last, edge);
      last = edge;
    }
  }
}

void StepPredicates::add_meetings(const SweepStep& step, std::span<const LoggedBundle> after) {
  const std::size_t right = step.position + step.inserted.size();
  if (step.position > 0 && step.position < after.size())
    add_meeting(after[step.position - 1].edges.front(), after[step.position].edges.front());
  if (!step.inserted.empty() && right < after.size())
    add_meeting(after[right - 1].edges.front(), after[right].edges.front());
}

// Neighbours that were neighbours in a list around the point before are in order already.
void StepPredicates::add_depths(const SweepStep& step, std::span<const LoggedBundle> before) {
  using Pair = std::array<FacetId, 2>;
  std::vector<Pair> known;
  const auto neighbours = [](const LoggedBundle& bundle, const auto& visit) {
    for (std::size_t i = 1; i < bundle.nodes.size(); ++i) visit(Pair{bundle.nodes[i - 1], bundle.nodes[i]});
  };
  const std::size_t first = step.position == 0 ? 0 : step.position - 1;
  for (const LoggedBundle& bundle : before.subspan(first, step.position + step.removed - first))
    neighbours(bundle, [&](const Pair& pair) { known.push_back(pair); });
  for (const LoggedBundle& bundle : step.inserted) {
    neighbours(bundle, [&](const Pair& pair) {
      if (std::find(known.begin(), known.end(), pair) != known.end()) return;
      known.push_back(pair);
      add_depth(pair[0], pair[1]);
    });
  }
}

Sign StepPredicates::add_side(EdgeId edge, PointId point) {
  const ImageSign side = side_of_edge(scene_, edge, point);
  const std::string place = side.sign > 0 ? " lies right of " : (side.sign < 0 ? " lies left of " : " lies on ");
  found_.push_back({"side",
                    log_.point_names[point.index()] + place + name(edge),
                    "(lower - upper) x (point - upper)",
                    {operand(scene_.edge(edge).top), operand(scene_.edge(edge).bottom), operand(point)},
                    side.sign,
                    side.exact,
                    integers()});
  return side.sign;
}

Sign StepPredicates::add_direction(EdgeId a, EdgeId b) {
  const ImageSign turn = turn_of_edges(scene_, a, b);
  const std::string place = turn.sign > 0 ? " leads further left than " : " leads further right than ";
  found_.push_back({"direction",
                    name(a) + (turn.sign == 0 ? " has the same direction as " : place) + name(b),
                    "(a.lower - a.upper) x (b.lower - b.upper)",
                    {operand(scene_.edge(a).top), operand(scene_.edge(a).bottom), operand(scene_.edge(b).top),
                     operand(scene_.edge(b).bottom)},
                    turn.sign,
                    turn.exact,
                    integers()});
  return turn.sign;
}

// Edges that come nearer to each other cross where the one that ends first ends beyond the other.
void StepPredicates::add_meeting(EdgeId left, EdgeId right) {
  if (add_direction(left, right) >= 0) {
    found_.back().says += ": they do not come nearer to each other";
    return;
  }
  const PointId left_end = scene_.edge(left).bottom;
  const PointId right_end = scene_.edge(right).bottom;
  if (left_end == right_end) {
    found_.back().says += ": they meet where both end";
    return;
  }
  const bool left_first = left_end < right_end;
  const Sign side = left_first ? add_side(right, left_end) : add_side(left, right_end);
  found_.back().says += (left_first ? side > 0 : side < 0) ? ": they cross further down" : ": they do not cross";
}

const std::string& StepPredicates::name(FacetId f) const {
  return log_.face_names[mesh_.facet_face[f.index()].index()];
}

std::string StepPredicates::name(EdgeId e) const {
  return name_of_edge(log_.point_names[scene_.edge(e).top.index()], log_.point_names[scene_.edge(e).bottom.index()]);
}

Operand StepPredicates::operand(PointId p) const {
  const ImagePoint& point = scene_.point(p);
  return {log_.point_names[p.index()], {static_cast<double>(point.x), static_cast<double>(point.y)}};
}

const char* StepPredicates::integers() const {
  return scene_.arithmetic == Arithmetic::exact ? "integers" : to_string(scene_.arithmetic);
}

// The depth of facets follows DepthOrder (depth_order.h) through its cases.
void StepPredicates::add_depth(FacetId f, FacetId g) {
  const bool nearer = depth_.nearer(f, g);
  const FacetId front = nearer ? f : g;
  const FacetId back = nearer ? g : f;
  if (!ranges_.empty() && ranges_[front.index()].farthest < ranges_[back.index()].nearest) {
    add_verdict(front, back, "ranges", "all of it is less deep");
  } else if (mesh_.uncut_facet(f) == mesh_.uncut_facet(g)) {
    add_verdict(front, back, "rule", "they are parts of one face");
  } else if (mesh_.is_cut() && pieces_.applies_to(mesh_.uncut_facet(f), mesh_.uncut_facet(g))) {
    add_verdict(front, back, "exact", "they were cut along their common line");
  } else if (!add_corners_against_plane(std::min(f, g), std::max(f, g)) &&
             !add_corners_against_plane(std::max(f, g), std::min(f, g))) {
    add_verdict(front, back, "exact", "where the eye sees them overlap");
  }
}

// Like DepthOrder, this stops as soon as f is known to straddle g's plane.
bool StepPredicates::add_corners_against_plane(FacetId f, FacetId g) {
  bool front = false;
  bool behind = false;
  for (const VertexId v : mesh_.uncut_corners(mesh_.uncut_facet(f))) {
    const Sign side = add_corner_against_plane(v, g);
    front = front || side > 0;
    behind = behind || side < 0;
    if (front && behind) return false;
  }
  if (!front && !behind) add_rule_of_one_plane(std::min(f, g), std::max(f, g));
  return true;
}

void StepPredicates::add_rule_of_one_plane(FacetId f, FacetId g) {
  const auto is_turned = [&](FacetId facet) { return scene_.facing[facet.index()] == FacetFacing::back; };
  if (is_turned(f) == is_turned(g)) return add_verdict(f, g, "rule", "in one plane the lower face is in front");
  const auto [front, back] = is_turned(f) ? std::pair(g, f) : std::pair(f, g);
  add_verdict(front, back, "rule", "in one plane the face that looks at the eye is in front");
}

Sign StepPredicates::add_corner_against_plane(VertexId v, FacetId plane) {
  std::array<VertexId, 3> abc = plane_corners(mesh_, plane);
  if (scene_.facing[plane.index()] == FacetFacing::back) std::swap(abc[1], abc[2]);
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

}  // namespace sightline::trace
