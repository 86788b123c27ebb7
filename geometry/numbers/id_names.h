// Messages name an id by its kind and number: "facet 12".
#pragma once

#include <string>

#include "geometry/numbers/ids.h"

namespace sightline::inline geometry {

[[nodiscard]] inline std::string name(FaceId f) { return "face " + std::to_string(f.value); }
[[nodiscard]] inline std::string name(FacetId f) { return "facet " + std::to_string(f.value); }
[[nodiscard]] inline std::string name(VertexId v) { return "vertex " + std::to_string(v.value); }
[[nodiscard]] inline std::string name(MeshEdgeId e) { return "mesh edge " + std::to_string(e.value); }
[[nodiscard]] inline std::string name(UncutFacetId u) { return "uncut facet " + std::to_string(u.value); }
[[nodiscard]] inline std::string name(PointId p) { return "point " + std::to_string(p.value); }
[[nodiscard]] inline std::string name(EdgeId e) { return "edge " + std::to_string(e.value); }
[[nodiscard]] inline std::string name(SegmentId s) { return "segment " + std::to_string(s.value); }

}  // namespace sightline::inline geometry
