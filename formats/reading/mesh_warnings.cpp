#include "formats/reading/mesh_warnings.h"

namespace sightline::inline formats {

std::string id_list(std::span<const FaceId> faces) {
  std::string list;
  for (std::size_t i = 0; i < faces.size() && i < 10; ++i) {
    list += (i == 0 ? "" : ", ") + std::to_string(faces[i].value);
  }
  return list + (faces.size() > 10 ? ", ..." : "");
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

void warn_about_defects(const Mesh& mesh, const std::string& name, std::vector<std::string>& warnings) {
  for (const Defect defect : {Defect::too_few_corners, Defect::zero_area, Defect::self_crossing, Defect::repeated_face,
                              Defect::repeated_corner}) {
    std::vector<FaceId> faces;
    for (const FaceDefect& d : mesh.defects) {
      if (d.defect == defect) faces.push_back(d.face);
    }
    if (faces.empty()) continue;
    const char* const done = is_skipped(defect) ? " skipped (" : " mended (";
    warnings.push_back(name + ": " + counted(faces.size(), "face") + done + to_string(defect) + "): " + id_list(faces));
  }
}

void warn_if_empty(const Mesh& mesh, const std::string& name, std::vector<std::string>& warnings) {
  if (mesh.facet_count() == 0) warnings.push_back(name + ": the scene is empty: no face is left to draw");
}

}  // namespace sightline::inline formats
