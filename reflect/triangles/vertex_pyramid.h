// The pyramid through a triangle, between the triangle's plane and a panel's, for the vertices in it.
//
// In:  a triangle, counter-clockwise seen from the camera; the camera's eye (w = 0: the direction towards the viewer);
//      the panel's plane. Out: whether a point is strictly inside, by five conditions (Koucky 2014, 3.9), in floating
//      point.
// Units: positions are scaled so that products of four lengths neither overflow nor underflow.
#pragma once

#include <array>

#include "geometry/numbers/predicates.h"
#include "reflect/world/plane_form.h"

namespace sightline::inline reflect {

class VertexPyramid {
 public:
  VertexPyramid(const std::array<Point3, 3>& triangle, const HomogeneousPoint& eye, const PlaneForm& panel);

  [[nodiscard]] bool contains(const Point3& p) const;
  [[nodiscard]] bool may_touch(const Box& box) const;

 private:
  std::array<PlaneForm, 5> forms_;  // positive inside
};

}  // namespace sightline::inline reflect
