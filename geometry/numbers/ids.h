// Index types are strong: an index into one kind of array cannot be used for another.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace sightline::inline geometry {

template <class Tag>
struct Id {
  std::uint32_t value = std::numeric_limits<std::uint32_t>::max();

  constexpr Id() = default;
  constexpr explicit Id(std::size_t index) : value(static_cast<std::uint32_t>(index)) {}

  // A default-constructed id names nothing.
  [[nodiscard]] constexpr bool valid() const { return *this != Id{}; }
  [[nodiscard]] constexpr std::size_t index() const { return value; }

  friend constexpr auto operator<=>(Id, Id) = default;
};

using VertexId = Id<struct VertexTag>;          // a vertex of the input, in file order
using FaceId = Id<struct FaceTag>;              // a face of the input, in file order
using FacetId = Id<struct FacetTag>;            // a convex planar piece of a face
using UncutFacetId = Id<struct UncutFacetTag>;  // a facet before it was cut along common lines
using MeshEdgeId = Id<struct MeshEdgeTag>;      // an edge of the mesh, by position of its ends
using PointId = Id<struct PointTag>;            // a point of the image: see image_point.h
using MadeCornerId = Id<struct MadeCornerTag>;  // a corner that clipping made
using EdgeId = Id<struct EdgeTag>;              // an edge of the projected scene
using SegmentId = Id<struct SegmentTag>;        // a visible segment

}  // namespace sightline::inline geometry
