// The labelled surface has, while it grows, vertices that all parts of it know and vertices that one part adds.
//
// A part's own vertices get the ids behind the common ones; where parts are put together they move up
// (labelled_mesh.cpp).
#pragma once

#include <vector>

#include "geometry/numbers/ids.h"
#include "geometry/numbers/vector3.h"

namespace sightline::inline reconstruct {

class NewVertices {
 public:
  explicit NewVertices(const std::vector<Point3>& common) : common_(common) {}

  [[nodiscard]] const Point3& operator[](VertexId v) const {
    return v.index() < common_.size() ? common_[v.index()] : added_[v.index() - common_.size()];
  }
  VertexId add(const Point3& position) {
    added_.push_back(position);
    return VertexId(common_.size() + added_.size() - 1);
  }
  [[nodiscard]] const std::vector<Point3>& added() const { return added_; }

 private:
  const std::vector<Point3>& common_;
  std::vector<Point3> added_;
};

}  // namespace sightline::inline reconstruct
