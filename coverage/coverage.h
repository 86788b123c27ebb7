// Coverage: what several cameras see together, and what mirrors a panel into any of them: areas of unions, not sums.
//
// In:  a mesh (cut along common lines), and what each camera sees of it (seen_part.h).
// Out: areas in input units squared, per camera and of all cameras together, per panel and of all panels together.
// Holds: what several cameras or panels cover together is no less than what one of them does, and no more than the
//      surface, also as rounded doubles; it is no more than the sum, but for the rounding of sums. A skipped face has
//      zeros. The order of the cameras changes nothing, but for rounding.
// Method: cameras see the same planar surfaces, each in triangles of its own. Where one camera sees all of a surface,
//      or all but one nothing, the union is known; else union_share.h finds it, and says how exactly.
// Complexity: O(s c p) for s surfaces, c cameras and p panels, and a sweep per surface that several cameras see in
//      part, and per panel that several see mirrored in part of it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "coverage/seen_part.h"
#include "geometry/numbers/export.h"

namespace sightline::inline coverage {

// These are the areas covered by one camera, or by all of them together.
struct CoveredAreas {
  double visible = 0;
  double any_panel = 0;        // mirrors one panel or more
  std::vector<double> panels;  // mirrors this panel
};

// This is what all cameras and panels together cover of a face.
struct FaceCoverage {
  double area = 0;
  double visible = 0;
  double reflecting = 0;
};

struct Coverage {
  double area = 0;                    // of the surface: of all facets that count
  std::vector<CoveredAreas> cameras;  // each for itself
  CoveredAreas together;
  std::vector<FaceCoverage> faces;
};

// counting: per face 1 where it counts in the areas of the surface, of cameras and of all together; where it is empty, all do.
// Each face has its own areas whether it counts or not.
[[nodiscard]] SIGHTLINE_EXPORT Coverage cover(const CutMesh& mesh, std::span<const SeenPart> cameras,
                                              std::size_t panel_count, std::span<const std::uint8_t> counting = {});

}  // namespace sightline::inline coverage
