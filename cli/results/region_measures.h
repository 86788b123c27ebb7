// What the cameras see of each region of the surface: the table regions.csv, and what the summary says of it.
//
// In:  regions, the faces' measures per camera, and what all cameras cover together.
// Out: rows, a camera after the other, then those of all cameras together, whose `camera` is empty. Each has a row `all` of the whole
//      surface, one `of_interest` where faces were chosen so, and one per mesh, object, group, material and smoothing group, in the
//      order of the file; kinds of which nothing has a name have no rows. A region without a name has the faces that are in none.
// Holds: meshes, objects, materials and smoothing groups each add up to the whole surface. A face in several groups counts in each.
// Columns: camera, kind, mesh, name (csv_name.h), faces; then areas as in faces.csv, summed: area, in_view_area, visible_area,
//      image_area, visible_image_area; visible_share, of the area; reflecting_area (any panel), reflecting_share; and per panel
//      reflecting_area:NAME. Of all cameras together there is no image and no area per panel: these are empty.
// Complexity: O(faces) per camera, for groups times those of a face.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/results/face_measures.h"
#include "coverage/coverage.h"
#include "formats/reading/face_regions.h"

namespace sightline::cli {

// What all cameras together see of a region.
struct SeenRegion {
  std::string name;  // with that of its mesh, where there are several meshes
  double area = 0;
  double visible = 0;
  double reflecting = 0;
};

// The regions of the first kind that has two or more: objects, else groups. Empty where neither has.
struct SeenRegions {
  RegionKind kind = RegionKind::object;
  std::vector<SeenRegion> regions;
};

[[nodiscard]] SeenRegions seen_regions(const FaceRegions& regions, const Coverage& coverage);

class RegionTable {
 public:
  // `of_interest` is per face, or empty. Both outlive the table.
  RegionTable(const FaceRegions& regions, const std::vector<std::uint8_t>& of_interest,
              const std::vector<std::string>& panels);

  void add_camera(const std::string& camera, const std::vector<FaceMeasures>& faces);
  void add_all_cameras(const Coverage& coverage);

  [[nodiscard]] std::string take() { return out_.take(); }

 private:
  struct Areas;

  template <class Face>
  [[nodiscard]] std::vector<Areas> sums_of(const std::vector<Face>& faces) const;
  void write(const std::string& camera, const std::vector<Areas>& sums, bool is_one_camera);

  const FaceRegions& regions_;
  const std::vector<std::uint8_t>& of_interest_;
  std::size_t panel_count_;
  std::vector<std::uint8_t> has_rows_;  // per kind of region
  TextBuffer out_;
};

}  // namespace sightline::cli
