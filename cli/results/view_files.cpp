#include "cli/results/view_files.h"

#include "cli/results/face_measures.h"
#include "formats/writing/labelled_obj.h"
#include "formats/writing/labelled_ply.h"
#include "formats/writing/segments_table.h"
#include "formats/writing/view_svg.h"

namespace sightline::cli {

void write_view_files(ResultFolders& results, const View& view, const std::vector<std::string>& panels,
                      const std::vector<FaceMeasures>& faces, const std::vector<Point2>& places) {
  const std::string& name = view.scene.camera.name;
  results.write(name, "faces.csv", [&](TextBuffer& out) { write_faces_table(faces, panels, out); });
  results.write(name, "labelled.ply", [&](TextBuffer& out) { write_labelled_ply(view.labelled, panels, out); });
  results.write(name, "labelled.obj", [&](TextBuffer& out) { write_labelled_obj(view.labelled, panels, out); });
  results.write(name, "view.svg", [&](TextBuffer& out) { write_view_svg(view, places, panels, out); });
  results.write(name, "segments.csv", [&](TextBuffer& out) { write_segments_table(view, places, out); });
}

}  // namespace sightline::cli
