#include "cli/report_warnings.h"

#include <fmt/format.h>

#include <algorithm>

namespace sightline {

namespace {

constexpr std::size_t listed_pairs = 20;

template <class Value>
void sort_distinct(std::vector<Value>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

std::string counted(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string interpenetration_warning(const std::vector<std::array<FaceId, 2>>& pairs) {
  std::string list;
  for (std::size_t i = 0; i < std::min(pairs.size(), listed_pairs); ++i) {
    list += fmt::format("{}{}-{}", i == 0 ? "" : ", ", pairs[i][0].value, pairs[i][1].value);
  }
  return fmt::format("{} of faces interpenetrate; their common line is not part of the sweep yet: {}{}",
                     counted(pairs.size(), "pair"), list, pairs.size() > listed_pairs ? ", ..." : "");
}

}  // namespace

std::vector<std::array<FaceId, 2>> interpenetrating_faces(const MeshInput& input, const View& view) {
  std::vector<std::array<FaceId, 2>> pairs = view.segments.conflicts;
  for (const auto& [a, b] : input.contacts.crossing) {
    const auto [low, high] = std::minmax(input.mesh.facet_face[a.index()], input.mesh.facet_face[b.index()]);
    pairs.push_back({low, high});
  }
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
  const auto pairs = interpenetrating_faces(input, view);
  if (!pairs.empty()) warnings.push_back(interpenetration_warning(pairs));
  const auto slivers = faces_below_resolution(view.polygons);
  if (!slivers.empty()) {
    warnings.push_back(fmt::format("visible polygons below resolution, which do not count as visible, on {}",
                                   counted(slivers.size(), "face")));
  }
  return warnings;
}

}  // namespace sightline
