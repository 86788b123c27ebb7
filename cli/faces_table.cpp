#include "cli/faces_table.h"

#include "cli/text_buffer.h"

namespace sightline {

std::string faces_table(const std::vector<FaceMeasures>& faces) {
  TextBuffer out;
  out << "face,facing,area,in_view_area,visible_area,image_area,visible_image_area\n";
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const FaceMeasures& face = faces[f];
    out << std::uint64_t{f} << ',' << to_string(face.facing) << ',' << face.area << ',' << face.in_view_area << ','
        << face.visible_area << ',' << face.image_area << ',' << face.visible_image_area << '\n';
  }
  return out.take();
}

}  // namespace sightline
