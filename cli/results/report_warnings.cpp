#include "cli/results/report_warnings.h"

#include <fmt/format.h>

#include <algorithm>

namespace sightline::cli {

namespace {

template <class Value>
void sort_distinct(std::vector<Value>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

std::string counted(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace

std::vector<std::array<FaceId, 2>> crossing_faces(const CutMesh& mesh) {
  const auto face = [&](WholeId whole) { return mesh.facet_face[mesh.cuts.first_facet[whole.index()].index()]; };
  std::vector<std::array<FaceId, 2>> pairs;
  for (const auto& [a, b] : mesh.cuts.crossing) pairs.push_back({face(a), face(b)});
  sort_distinct(pairs);
  return pairs;
}

std::vector<FaceId> faces_below_resolution(const VisiblePolygons& polygons) {
  std::vector<FaceId> faces;
  for (const VisiblePolygon& polygon : polygons.polygons) {
    if (polygon.below_resolution) faces.push_back(polygon.face);
  }
  sort_distinct(faces);
  return faces;
}

std::vector<std::string> report_warnings(const MeshInput& input, const View& view) {
  std::vector<std::string> warnings = input.warnings;
  const auto slivers = faces_below_resolution(view.polygons);
  if (!slivers.empty()) {
    warnings.push_back(fmt::format("visible polygons below resolution, which do not count as visible, on {}",
                                   counted(slivers.size(), "face")));
  }
  return warnings;
}

}  // namespace sightline::cli
