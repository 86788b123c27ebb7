#include "cli/results/summary.h"

#include <fmt/format.h>

#include "formats/writing/coverage_table.h"

namespace sightline::cli {

namespace {

// The table of cameras, two lines of head above it, fills 80 columns.
constexpr const char* camera_table_line = "{:12} {:>7} {:>8} {:>7} {:>7} {:>7} {:>10} {:>7} {:>7}\n";
constexpr std::size_t camera_width = 12;
constexpr std::size_t name_width = 16;  // in the other tables

// Cut between characters: the bytes 10xxxxxx continue one.
std::string shortened(const std::string& name, std::size_t width) {
  if (name.size() <= width) return name;
  std::size_t end = width - 3;
  while ((static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80) --end;
  return name.substr(0, end) + "...";
}

std::string scene_line(const Report& report) {
  const Report::Surface& surface = report.surface;
  return fmt::format("{}: {} vertices, {} faces, area {:.6g}\n\n", surface.mesh_file, surface.vertices, surface.faces,
                     report.areas.surface);
}

std::string table_head() {
  const auto line = [](auto... words) { return fmt::format(camera_table_line, words...); };
  return line("", "faces", "reflect-", "", "out of", "back-", "area", "window", "time") +
         line("camera", "visible", "ing", "hidden", "view", "facing", "visible", "filled", "s");
}

// reflecting: of the visible faces those that show a panel. window filled: the share of the window, or of a lens's frame in it,
// that the surface covers.
std::string camera_line(const Report& report) {
  const Report::FaceCounts& faces = report.counts.faces;
  const double all = report.camera.lens_image ? frame_area(*report.camera.lens_image) : 4;
  const double filled = 100 * (1 - report.areas.image_uncovered / all);
  return fmt::format(camera_table_line, shortened(report.camera.name, camera_width), faces.visible, faces.reflecting,
                     faces.hidden, faces.out_of_view, faces.back_facing, fmt::format("{:.6g}", report.areas.visible),
                     fmt::format("{:.1f} %", filled), fmt::format("{:.3f}", report.seconds.total()));
}

// Says what each panel is worth to each camera: on the surface, and of what the camera sees of it.
std::string panel_lines(const std::vector<Report>& reports) {
  if (reports.front().reflection.panels.empty()) return "";
  std::string text =
      fmt::format("\n{:16} {:16} {:>16} {:>16}\n", "camera", "panel", "area reflecting", "of the visible");
  for (const Report& report : reports) {
    const double visible = report.areas.visible;
    for (const Report::ReflectedPanel& panel : report.reflection.panels) {
      text +=
          fmt::format("{:16} {:16} {:>16.6g} {:>14.2f} %\n", shortened(report.camera.name, name_width),
                      shortened(panel.name, name_width), panel.area, visible > 0 ? 100 * panel.area / visible : 0.0);
    }
  }
  return text;
}

// Says what the cameras see together, where that is more to say than a camera's own line.
std::string coverage_lines(const Coverage& coverage) {
  if (coverage.cameras.size() < 2) return "";
  const auto line = [&](const char* what, double area) {
    return fmt::format("{:33} {:>16.6g} {:>14.2f} %\n", what, area, 100 * share_of(area, coverage.area));
  };
  std::string text = fmt::format("\n{:33} {:>16} {:>16}\n", "all cameras together", "area", "of the surface");
  text += line("visible in one or more", coverage.together.visible);
  if (!coverage.together.panels.empty()) text += line("reflecting a panel in one or more", coverage.together.any_panel);
  return text;
}

// Says what is odd about cameras, of the first few: a view of nothing is a mistake that is better seen at once.
std::string doubt_lines(const std::vector<Report>& reports) {
  constexpr std::size_t most = 8;
  std::string text;
  std::size_t count = 0;
  for (const Report& report : reports) {
    for (const std::string& doubt : report.doubts) {
      if (++count <= most) text += fmt::format("  {}: {}\n", shortened(report.camera.name, name_width), doubt);
    }
  }
  return count <= most ? text : text + fmt::format("  and {} more\n", count - most);
}

std::string warnings_line(const std::vector<Report>& reports) {
  std::size_t count = 0;
  for (const Report& report : reports) count += report.warnings.size();
  if (count == 0) return "";
  return fmt::format("\n{} warning{}: see \"warnings\" in report.json\n", count, count == 1 ? "" : "s") +
         doubt_lines(reports);
}

}  // namespace

std::string summary(const std::vector<Report>& reports, const Coverage& coverage, const std::string& output,
                    bool with_page) {
  std::string text = scene_line(reports.front()) + table_head();
  for (const Report& report : reports) text += camera_line(report);
  text += panel_lines(reports);
  text += coverage_lines(coverage);
  text += warnings_line(reports);
  text += fmt::format("\nOne folder per camera in {}\n", output);
  text += "  view.svg       the visible polygons as the camera sees them\n";
  text += "  labelled.ply   the refined surface with labels (also labelled.obj)\n";
  text += "  faces.csv      how much of each face is seen (also segments.csv, report.json)\n";
  text += "Beside them: coverage.csv, how much cameras and panels cover together\n";
  if (with_page) text += "             report.html, all of this in 3D\n";
  text +=
      "Start with " + output + (with_page ? "/report.html" : "/" + reports.front().camera.name + "/view.svg") + "\n";
  return text;
}

}  // namespace sightline::cli
