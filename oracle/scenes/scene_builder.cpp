#include "oracle/scenes/scene_builder.h"

#include <algorithm>

#include "oracle/lattice/simple_polygon.h"

namespace sightline::lattice {
namespace {

bool coplanar(const std::vector<LatticePoint>& p) {
  const auto volume = [&](std::size_t i, std::size_t j, std::size_t k) {
    const auto u = std::array{p[i].x - p[0].x, p[i].y - p[0].y, p[i].depth - p[0].depth};
    const auto v = std::array{p[j].x - p[0].x, p[j].y - p[0].y, p[j].depth - p[0].depth};
    const auto w = std::array{p[k].x - p[0].x, p[k].y - p[0].y, p[k].depth - p[0].depth};
    return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
  };
  for (std::size_t i = 1; i < p.size(); ++i) {
    for (std::size_t j = i + 1; j < p.size(); ++j) {
      for (std::size_t k = j + 1; k < p.size(); ++k) {
        if (volume(i, j, k) != 0) return false;
      }
    }
  }
  return true;
}

void note(SceneNotes& all, const SceneNotes& more) {
  all.clipped |= more.clipped;
  all.behind |= more.behind;
  all.concave |= more.concave;
  all.not_planar |= more.not_planar;
  all.coplanar_overlap |= more.coplanar_overlap;
  all.edge_on |= more.edge_on;
}

SceneNotes notes_of(const PlacedFace& face) {
  SceneNotes notes;
  notes.edge_on = face.plane.c == 0;
  notes.behind = std::any_of(face.corners.begin(), face.corners.end(), [](const CameraPoint& p) { return p.w <= 0; });
  notes.clipped = std::any_of(face.corners.begin(), face.corners.end(),
                              [](const CameraPoint& p) { return std::abs(p.x) > p.w || std::abs(p.y) > p.w; });
  return notes;
}

// Leaves out the vertices that no face uses, except the first of them.
void drop_unused_vertices(RandomScene& scene) {
  std::vector<bool> used(scene.vertices.size());
  for (const Corners& corners : scene.faces) {
    for (const std::uint32_t c : corners) used[c] = true;
  }
  const auto kept = std::find(used.begin(), used.end(), false);
  if (kept != used.end()) *kept = true;
  std::vector<std::uint32_t> index(used.size());
  std::vector<Point3> vertices;
  for (std::size_t v = 0; v < used.size(); ++v) {
    index[v] = static_cast<std::uint32_t>(vertices.size());
    if (used[v]) vertices.push_back(scene.vertices[v]);
  }
  for (Corners& corners : scene.faces) {
    for (std::uint32_t& c : corners) c = index[c];
  }
  scene.vertices = std::move(vertices);
}

}  // namespace

std::uint32_t SceneBuilder::vertex(const LatticePoint& p) {
  const auto known = std::find(points_.begin(), points_.end(), p);
  if (known != points_.end() && !dice_->one_in(6)) return static_cast<std::uint32_t>(known - points_.begin());
  points_.push_back(p);
  return static_cast<std::uint32_t>(points_.size() - 1);
}

std::optional<PlacedFace> SceneBuilder::place(const std::vector<LatticePoint>& corners) const {
  PlacedFace face;
  for (const LatticePoint& p : corners) face.corners.push_back(to_camera_space(lattice_.camera, position(lattice_, p)));
  const auto plane = plane_of(face.corners);
  if (!plane) return std::nullopt;
  face.plane = *plane;
  if (plane->c == 0) return face;
  const auto clipped = clipped_image_of(face.corners);
  if (!clipped) return std::nullopt;
  const auto whole = image_of(face.corners);
  face.whole = whole.has_value();
  face.image = whole ? *whole : *clipped;
  return face;
}

std::optional<SceneBuilder::Proposal> SceneBuilder::propose(const Corners& corners) const {
  Proposal result;
  std::vector<LatticePoint> p;
  for (const std::uint32_t c : corners) p.push_back(points_[c]);
  result.key = p;
  std::sort(result.key.begin(), result.key.end());
  std::vector<std::vector<LatticePoint>> pieces{p};
  if (!coplanar(p)) {
    if (p.size() != 4) return std::nullopt;
    pieces = {{p[0], p[1], p[2]}, {p[0], p[2], p[3]}, {p[0], p[1], p[3]}, {p[1], p[2], p[3]}};
    result.notes.not_planar = true;
  } else if (const Ring ring = flattened(p); is_simple(ring)) {
    result.notes.concave = !is_convex(ring);
  } else {
    return std::nullopt;
  }
  for (const auto& piece : pieces) {
    const auto face = place(piece);
    if (!face) return std::nullopt;
    note(result.notes, notes_of(*face));
    result.pieces.push_back(*face);
  }
  return result;
}

bool SceneBuilder::fits(Proposal& proposal) const {
  if (keys_.count(proposal.key) != 0) return false;
  for (const PlacedFace& face : proposal.pieces) {
    for (const PlacedFace& other : placed_) {
      const bool may_cross = crossings_ == Crossings::allowed;
      if (!may_cross && !(face.whole && other.whole) && straddle(face, other)) return false;
      const Relation r = relation(face, other);
      if (r == Relation::crossing && !may_cross) return false;
      proposal.notes.coplanar_overlap |= r == Relation::coplanar;
    }
  }
  return true;
}

bool SceneBuilder::add_one(const Corners& corners) {
  auto proposal = propose(corners);
  if (!proposal || !fits(*proposal)) return false;
  if (proposal->notes.edge_on && !dice_->one_in(8)) return false;  // else they are the most of all
  faces_.push_back(corners);
  placed_.insert(placed_.end(), proposal->pieces.begin(), proposal->pieces.end());
  keys_.insert(proposal->key);
  note(notes_, proposal->notes);
  return true;
}

bool SceneBuilder::add(const std::vector<Corners>& faces) {
  const SceneBuilder before = *this;
  for (const Corners& corners : faces) {
    if (add_one(corners)) continue;
    const auto points = points_;
    *this = before;
    points_ = points;
    return false;
  }
  return true;
}

RandomScene scene_of(const SceneBuilder& builder, std::uint64_t seed, Sides sides, std::size_t most_faces) {
  RandomScene scene{seed, builder.lattice().camera, sides, {}, builder.faces(), builder.notes()};
  for (const LatticePoint& p : builder.points()) scene.vertices.push_back(position(builder.lattice(), p));
  if (scene.faces.size() > most_faces) scene.faces.resize(most_faces);
  drop_unused_vertices(scene);
  return scene;
}

}  // namespace sightline::lattice
