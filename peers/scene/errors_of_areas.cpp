#include "peers/scene/errors_of_areas.h"

#include <algorithm>
#include <cmath>

namespace sightline::peers {

AreaErrors compare_faces(const FaceAreas& seen, const FaceAreas& exact) {
  AreaErrors errors;
  for (const auto& [face, area] : exact) {
    const auto found = seen.find(face);
    const double shown = found == seen.end() ? 0 : found->second;
    if (shown == 0) ++errors.missed_faces;
    const double relative = std::abs(shown - area) / area;
    errors.largest_relative_error = std::max(errors.largest_relative_error, relative);
    errors.mean_relative_error += relative / static_cast<double>(exact.size());
  }
  for (const auto& [face, area] : seen) errors.hidden_faces_shown += area > 0 && !exact.contains(face) ? 1U : 0U;
  return errors;
}

}  // namespace sightline::peers
