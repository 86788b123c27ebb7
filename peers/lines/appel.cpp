#include "peers/lines/appel.h"

#include <algorithm>
#include <optional>

#include "geometry/projection/camera_forms.h"
#include "peers/lines/active_edges.h"
#include "peers/lines/obscuring.h"

namespace sightline::peers {
namespace {

// These are the lines at each vertex, the vertices in order.
class LinesAtVertices {
 public:
  explicit LinesAtVertices(const std::vector<SceneLine>& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const LineEnd* end : {&lines[i].from, &lines[i].to}) {
        if (end->vertex.valid()) ends_.push_back({end->vertex, i});
      }
    }
    std::sort(ends_.begin(), ends_.end());
  }

  template <class Visit>
  void for_each(VertexId vertex, Visit visit) const {
    auto at = std::lower_bound(ends_.begin(), ends_.end(), End{vertex, 0});
    for (; at != ends_.end() && at->vertex == vertex; ++at) visit(at->line);
  }

 private:
  struct End {
    VertexId vertex;
    std::size_t line = 0;
    friend auto operator<=>(const End&, const End&) = default;
  };
  std::vector<End> ends_;
};

int total_change(const std::vector<ActiveCrossing>& crossings) {
  int total = 0;
  for (const ActiveCrossing& crossing : crossings) total += crossing.change;
  return total;
}

// Returns the middle of the longest segment between crossings.
double seed_of(const std::vector<ActiveCrossing>& crossings) {
  double begin = 0;
  double seed = 0.5;
  double longest = 0;
  const auto add_piece = [&](double end) {
    if (end - begin > longest) seed = begin + (end - begin) / 2;
    longest = std::max(longest, end - begin);
    begin = end;
  };
  for (const ActiveCrossing& crossing : crossings) add_piece(crossing.t);
  add_piece(1);
  return seed;
}

class Propagation {
 public:
  Propagation(const FlatScene& scene, const std::vector<SceneLine>& lines)
      : lines_(lines), active_(lines), obscuring_(scene), at_vertices_(lines), is_known_(lines.size(), false) {
    vertex_is_known_.resize(scene.mesh->vertices.size(), false);
  }

  QuantitativeInvisibility run() {
    for (std::size_t line = 0; line < lines_.size(); ++line) {
      if (is_known_[line]) continue;
      set_by_seed(line);
      while (!reached_.empty()) propagate();
    }
    return std::move(result_);
  }

 private:
  // This is a vertex, with how many polygons that do not have it obscure it.
  struct Reached {
    VertexId vertex;
    int Q_v = 0;
  };

  void set_by_seed(std::size_t line) {
    const std::vector<ActiveCrossing> crossings = active_.crossings_of(lines_[line]);
    const double seed = seed_of(crossings);
    int Q_v = obscuring_.count_at(lines_[line], seed);
    for (const ActiveCrossing& crossing : crossings) {
      if (crossing.t < seed) Q_v -= crossing.change;
    }
    ++result_.counts.seeds;
    follow(line, Q_v, crossings);
  }

  void propagate() {
    const Reached from = reached_.back();
    reached_.pop_back();
    at_vertices_.for_each(from.vertex, [&](std::size_t line) {
      if (is_known_[line]) return;
      const bool is_start = lines_[line].from.vertex == from.vertex;
      const LineEnd& end = is_start ? lines_[line].from : lines_[line].to;
      const std::vector<ActiveCrossing> crossings = active_.crossings_of(lines_[line]);
      const int Q_v = from.Q_v + obscuring_.count_beside(lines_[line], end);
      ++result_.counts.propagations;
      follow(line, is_start ? Q_v : Q_v - total_change(crossings), crossings);
    });
  }

  // Goes along the line, which begins with Q_v.
  void follow(std::size_t line, int Q_v, const std::vector<ActiveCrossing>& crossings) {
    is_known_[line] = true;
    result_.counts.intersections += crossings.size();
    reach(line, lines_[line].from, Q_v);
    double begin = 0;
    for (const ActiveCrossing& crossing : crossings) {
      if (crossing.t > begin) result_.segments.push_back({line, begin, crossing.t, Q_v});
      begin = crossing.t;
      Q_v += crossing.change;
    }
    if (begin < 1) result_.segments.push_back({line, begin, 1, Q_v});
    reach(line, lines_[line].to, Q_v);
  }

  void reach(std::size_t line, const LineEnd& end, int Q_v) {
    if (!end.vertex.valid() || vertex_is_known_[end.vertex.index()]) return;
    vertex_is_known_[end.vertex.index()] = true;
    reached_.push_back({end.vertex, Q_v - obscuring_.count_beside(lines_[line], end)});
  }

  const std::vector<SceneLine>& lines_;
  ActiveEdges active_;
  Obscuring obscuring_;
  LinesAtVertices at_vertices_;
  std::vector<bool> is_known_;
  std::vector<bool> vertex_is_known_;
  std::vector<Reached> reached_;
  QuantitativeInvisibility result_;
};

bool is_within_bounds(const Camera& camera, const Point3& p) {
  const double distance = CameraForms<double>(camera).depth_at(p);
  return (!camera.near_distance || distance >= *camera.near_distance) &&
         (!camera.far_distance || distance <= *camera.far_distance);
}

void refuse_cuts_by_bounds(const FlatScene& scene) {
  for (const FlatPolygon& polygon : scene.polygons) {
    for (const VertexId v : scene.mesh->corners(polygon.facet)) {
      if (is_within_bounds(scene.projected->camera, scene.mesh->position(v))) continue;
      throw RefusedScene(
          "the camera's near or far bound cuts faces open, and such a cut is no edge of the mesh; leave them out");
    }
  }
}

VisibleLines visible_lines(const CutMesh& mesh, const std::vector<SceneLine>& lines,
                           const std::vector<LineSegment>& segments) {
  VisibleLines visible;
  for (const LineSegment& segment : segments) {
    const SceneLine& line = lines[segment.line];
    if (segment.Q_v != 0 || !parts_surfaces(mesh, line)) continue;
    const Corner from = line.at(segment.from);
    const Corner to = line.at(segment.to);
    visible.push_back({{from.x, from.y}, {to.x, to.y}});
  }
  return visible;
}

Outcome draw_visible_lines(const FlatScene& scene, int /*resolution*/) {
  refuse_cuts_by_bounds(scene);
  const std::vector<SceneLine> lines = scene_lines(scene);
  const QuantitativeInvisibility found = quantitative_invisibility(scene, lines);
  return {visible_lines(*scene.mesh, lines, found.segments),
          {{"lines", lines.size()},
           {"seeds", found.counts.seeds},
           {"propagations", found.counts.propagations},
           {"intersections with active edges", found.counts.intersections}}};
}

}  // namespace

QuantitativeInvisibility quantitative_invisibility(const FlatScene& scene, const std::vector<SceneLine>& lines) {
  return Propagation(scene, lines).run();
}

Peer appel() {
  return {
      "appel",
      "Appel's quantitative invisibility",
      "slides 004, Quantitative Invisibility",
      ComputedAt::object_precision,
      "Draws the edges, not the faces. Every edge has a number, its quantitative invisibility: how many faces hide it. "
      "The number changes only where the edge passes behind an active edge, one at which the surface turns away from "
      "the viewer or ends. One point is tested against all faces; from there the number is carried along the edge, up "
      "and down by what it passes behind, and on to the edges that begin where it ends. Edges with the number 0 are "
      "seen.",
      "Where edges cross is rounded, so the parts that are seen end a few last digits off. Where faces touch without "
      "sharing an edge (a corner that stands on a face, faces that lie on each other) one number may come out wrong, "
      "and is "
      "then carried along to the neighbours: whole edges appear or disappear.",
      draw_visible_lines};
}

}  // namespace sightline::peers
