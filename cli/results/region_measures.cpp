#include "cli/results/region_measures.h"

#include <algorithm>

#include "formats/writing/coverage_table.h"
#include "formats/writing/csv_name.h"

namespace sightline::cli {

namespace {

std::vector<std::uint8_t> kinds_with_names(const FaceRegions& regions) {
  std::vector<std::uint8_t> has_names(region_kinds.size(), 0);
  for (const Region& region : regions.regions) {
    if (!region.name.empty()) has_names[static_cast<std::size_t>(region.kind)] = 1;
  }
  return has_names;
}

std::size_t count_of(const FaceRegions& regions, RegionKind kind) {
  return static_cast<std::size_t>(std::ranges::count(regions.regions, kind, &Region::kind));
}

bool has_several_meshes(const FaceRegions& regions) { return count_of(regions, RegionKind::mesh) > 1; }

std::string full_name(const Region& region, bool with_mesh) {
  const std::string name = region.name.empty() ? "(no name)" : region.name;
  return with_mesh && region.name != region.mesh ? region.mesh + "/" + name : name;
}

}  // namespace

// Of a region, summed over its faces.
struct RegionTable::Areas {
  std::uint64_t faces = 0;
  double area = 0;
  double in_view = 0;
  double visible = 0;
  double image = 0;
  double visible_image = 0;
  double reflecting = 0;
  std::vector<double> panels;

  void add(const FaceMeasures& face) {
    ++faces;
    area += face.area;
    in_view += face.in_view_area;
    visible += face.visible_area;
    image += face.image_area;
    visible_image += face.visible_image_area;
    reflecting += face.any_reflecting_area;
    for (std::size_t p = 0; p < panels.size(); ++p) panels[p] += face.reflecting_area[p];
  }
  void add(const FaceCoverage& face) {
    ++faces;
    area += face.area;
    visible += face.visible;
    reflecting += face.reflecting;
  }
};

SeenRegions seen_regions(const FaceRegions& regions, const Coverage& coverage) {
  for (const RegionKind kind : {RegionKind::object, RegionKind::group}) {
    if (count_of(regions, kind) < 2) continue;
    const bool with_mesh = has_several_meshes(regions);
    std::vector<SeenRegion> all;
    for (const Region& region : regions.regions) all.push_back({full_name(region, with_mesh)});
    for (std::size_t f = 0; f < coverage.faces.size(); ++f) {
      regions.for_each(FaceId(f), [&](RegionId id) {
        all[id.index()].area += coverage.faces[f].area;
        all[id.index()].visible += coverage.faces[f].visible;
        all[id.index()].reflecting += coverage.faces[f].reflecting;
      });
    }
    SeenRegions result{kind, {}};
    for (std::size_t r = 0; r < all.size(); ++r) {
      if (regions.regions[r].kind == kind) result.regions.push_back(std::move(all[r]));
    }
    return result;
  }
  return {};
}

RegionTable::RegionTable(const FaceRegions& regions, const std::vector<std::uint8_t>& of_interest,
                         const std::vector<std::string>& panels)
    : regions_(regions), of_interest_(of_interest), panel_count_(panels.size()), has_rows_(kinds_with_names(regions)) {
  out_ << "camera,kind,mesh,name,faces,area,in_view_area,visible_area,image_area,visible_image_area,visible_share,"
          "reflecting_area,reflecting_share";
  for (const std::string& panel : panels) out_ << ",reflecting_area:" << panel;
  out_ << '\n';
}

// The sums are of all faces, of those of interest, and of each region.
template <class Face>
std::vector<RegionTable::Areas> RegionTable::sums_of(const std::vector<Face>& faces) const {
  Areas nothing;
  nothing.panels.resize(panel_count_);
  std::vector<Areas> sums(2 + regions_.regions.size(), nothing);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    sums[0].add(faces[f]);
    if (!of_interest_.empty() && of_interest_[f] != 0) sums[1].add(faces[f]);
    regions_.for_each(FaceId(f), [&](RegionId region) { sums[2 + region.index()].add(faces[f]); });
  }
  return sums;
}

void RegionTable::write(const std::string& camera, const std::vector<Areas>& sums, bool is_one_camera) {
  const auto row = [&](const char* kind, const std::string& mesh, const std::string& name, const Areas& areas) {
    out_ << csv_name(camera) << ',' << kind << ',' << csv_name(mesh) << ',' << csv_name(name) << ',' << areas.faces
         << ',' << areas.area << ',';
    if (is_one_camera) out_ << areas.in_view;
    out_ << ',' << areas.visible << ',';
    if (is_one_camera) out_ << areas.image << ',' << areas.visible_image << ',';
    if (!is_one_camera) out_ << ",,";
    out_ << share_of(areas.visible, areas.area) << ',' << areas.reflecting << ','
         << share_of(areas.reflecting, areas.area);
    for (const double area : areas.panels) {
      out_ << ',';
      if (is_one_camera) out_ << area;
    }
    out_ << '\n';
  };
  row("all", "", "", sums[0]);
  if (!of_interest_.empty()) row("of_interest", "", "", sums[1]);
  for (const RegionKind kind : region_kinds) {
    if (has_rows_[static_cast<std::size_t>(kind)] == 0) continue;
    for (std::size_t r = 0; r < regions_.regions.size(); ++r) {
      const Region& region = regions_.regions[r];
      if (region.kind == kind) row(to_string(kind), region.mesh, region.name, sums[2 + r]);
    }
  }
}

void RegionTable::add_camera(const std::string& camera, const std::vector<FaceMeasures>& faces) {
  write(camera, sums_of(faces), true);
}

void RegionTable::add_all_cameras(const Coverage& coverage) { write("", sums_of(coverage.faces), false); }

}  // namespace sightline::cli
