#include "formats/writing/coverage_table.h"

#include "formats/writing/csv_name.h"
#include "formats/writing/text_buffer.h"

namespace sightline::inline formats {

namespace {

void add_areas(TextBuffer& out, double visible, double reflecting, double whole) {
  out << ',' << visible << ',' << reflecting << ',' << share_of(visible, whole) << ',' << share_of(reflecting, whole)
      << '\n';
}

// These are the rows of the whole table.
class Rows {
 public:
  Rows(TextBuffer& out, const Coverage& coverage) : out_(out), coverage_(coverage) {}

  void add(const std::string& camera, const std::string& panel, double visible, double reflecting) {
    out_ << ',' << csv_name(camera) << ',' << csv_name(panel);
    add_areas(out_, visible, reflecting, coverage_.area);
  }
  void add_panels(const std::string& camera, const std::vector<std::string>& panels, const CoveredAreas& areas) {
    for (std::size_t p = 0; p < panels.size(); ++p) add(camera, panels[p], areas.visible, areas.panels[p]);
  }

 private:
  TextBuffer& out_;
  const Coverage& coverage_;
};

}  // namespace

double share_of(double part, double whole) {
  if (!(whole > 0)) return 0;
  return part < whole ? part / whole : 1;
}

std::string coverage_table(const Coverage& coverage, const std::vector<std::string>& cameras,
                           const std::vector<std::string>& panels) {
  TextBuffer out;
  out << "face,camera,panel,visible_area,reflecting_area,visible_share,reflecting_share\n";
  Rows rows(out, coverage);
  for (std::size_t c = 0; c < cameras.size(); ++c) rows.add_panels(cameras[c], panels, coverage.cameras[c]);
  for (std::size_t c = 0; c < cameras.size(); ++c)
    rows.add(cameras[c], "", coverage.cameras[c].visible, coverage.cameras[c].any_panel);
  rows.add_panels("", panels, coverage.together);
  rows.add("", "", coverage.together.visible, coverage.together.any_panel);
  for (std::size_t f = 0; f < coverage.faces.size(); ++f) {
    const FaceCoverage& face = coverage.faces[f];
    out << std::uint64_t{f} << ",,";
    add_areas(out, face.visible, face.reflecting, face.area);
  }
  return out.take();
}

}  // namespace sightline::inline formats
