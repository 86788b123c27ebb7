// The rounded polygon of a facet is given here as plain points.
#pragma once

#include <boost/container/small_vector.hpp>
#include <span>

#include "geometry/projection/projected_scene.h"

namespace sightline::inline sweep {

class FacetOutline {
 public:
  FacetOutline(const ProjectedScene& scene, FacetId f) {
    for (const ClippedCorner& corner : scene.polygon(f)) points_.push_back(scene.point(corner.point));
  }
  [[nodiscard]] std::span<const ImagePoint> points() const { return {points_.data(), points_.size()}; }

 private:
  boost::container::small_vector<ImagePoint, 6> points_;
};

}  // namespace sightline::inline sweep
