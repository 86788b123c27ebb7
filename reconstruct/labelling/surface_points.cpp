#include "reconstruct/labelling/surface_points.h"

#include <algorithm>

namespace sightline::inline reconstruct {

void SurfacePoints::sort() {
  std::sort(entries_.begin(), entries_.end(), [this](const Entry& a, const Entry& b) {
    return a.point != b.point ? image_.sweeps_before(a.point, b.point) : a.vertex < b.vertex;
  });
  const auto same_point = [](const Entry& a, const Entry& b) { return a.point == b.point; };
  entries_.erase(std::unique(entries_.begin(), entries_.end(), same_point), entries_.end());
}

void SurfacePoints::place_in_plane(const Point3& a, const Point3& b, const Point3& c, const NewVertices& vertices) {
  const Vector3 ab = b - a;
  const Vector3 x_axis = (1 / norm(ab)) * ab;
  const Vector3 normal = x_axis.cross(c - a);
  const Vector3 y_axis = (1 / norm(normal)) * normal.cross(x_axis);
  placed_ = true;
  for (Entry& entry : entries_) {
    const Vector3 d = vertices[entry.vertex] - a;
    entry.in_plane = {d.dot(x_axis), d.dot(y_axis)};
    placed_ = placed_ && std::isfinite(entry.in_plane.x) && std::isfinite(entry.in_plane.y);
  }
}

std::vector<SurfacePoints::Entry>::const_iterator SurfacePoints::find(PointId p) const {
  return std::lower_bound(entries_.begin(), entries_.end(), p,
                          [this](const Entry& e, PointId q) { return image_.sweeps_before(e.point, q); });
}

bool SurfacePoints::contains(PointId p) const {
  const auto found = find(p);
  return found != entries_.end() && found->point == p;
}

PlanarPointId SurfacePoints::index(PointId p) const {
  return PlanarPointId(static_cast<std::size_t>(find(p) - entries_.begin()));
}

Sign SurfacePoints::orient(PlanarPointId a, PlanarPointId b, PlanarPointId c) const {
  return image_.orientation((*this)[a].point, (*this)[b].point, (*this)[c].point);
}

bool SurfacePoints::flip_improves(PlanarPointId a, PlanarPointId b, PlanarPointId c, PlanarPointId d) const {
  if (!placed_) return false;
  return in_circle((*this)[a].in_plane, (*this)[b].in_plane, (*this)[c].in_plane, (*this)[d].in_plane) * turn_ > 0;
}

}  // namespace sightline::inline reconstruct
