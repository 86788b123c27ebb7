#include "cli/results/faces_table.h"

namespace sightline::cli {

void write_faces_table(const std::vector<FaceMeasures>& faces, const std::vector<std::string>& panels,
                       TextBuffer& out) {
  out << "face,facing,area,in_view_area,visible_area,image_area,visible_image_area";
  for (const std::string& panel : panels) out << ",reflecting_area:" << panel;
  out << '\n';
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const FaceMeasures& face = faces[f];
    out << std::uint64_t{f} << ',' << to_string(face.facing) << ',' << face.area << ',' << face.in_view_area << ','
        << face.visible_area << ',' << face.image_area << ',' << face.visible_image_area;
    for (const double area : face.reflecting_area) out << ',' << area;
    out << '\n';
  }
}

}  // namespace sightline::cli
