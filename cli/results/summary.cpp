#include "cli/results/summary.h"

#include <fmt/format.h>

#include <algorithm>

#include "formats/writing/coverage_table.h"

namespace sightline::cli {

namespace {

// The table of cameras, two lines of head above it, fills 80 columns.
constexpr const char* camera_table_line = "{:12} {:>7} {:>8} {:>7} {:>7} {:>7} {:>10} {:>7} {:>7}\n";
constexpr std::size_t camera_width = 12;
constexpr std::size_t name_width = 16;  // in the other tables
constexpr std::size_t region_width = 26;
constexpr std::size_t listed_regions = 8;

// Cut between characters: the bytes 10xxxxxx continue one.
std::string shortened(const std::string& name, std::size_t width) {
  if (name.size() <= width) return name;
  std::size_t end = width - 3;
  while ((static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80) --end;
  return name.substr(0, end) + "...";
}

std::string scene_line(const Report& report) {
  const Report::Surface& surface = report.surface;
  std::string text = fmt::format("{}{}: {} vertices, {} faces, area {:.6g}\n", surface.mesh_file,
                                 surface.parts.size() > 1 ? fmt::format(" and {} more", surface.parts.size() - 1) : "",
                                 surface.vertices, surface.faces, report.areas.surface);
  if (report.of_interest.were_chosen)
    text += fmt::format("of interest: {} faces, area {:.6g}; areas and shares below are theirs\n",
                        report.of_interest.faces, report.of_interest.surface);
  return text + "\n";
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
                     faces.hidden, faces.out_of_view, faces.back_facing,
                     fmt::format("{:.6g}", report.of_interest.visible), fmt::format("{:.1f} %", filled),
                     fmt::format("{:.3f}", report.seconds.total()));
}

// Says what each panel is worth to each camera: on the surface, and of what the camera sees of it.
std::string panel_lines(const std::vector<Report>& reports) {
  if (reports.front().reflection.panels.empty()) return "";
  std::string text =
      fmt::format("\n{:16} {:16} {:>16} {:>16}\n", "camera", "panel", "area reflecting", "of the visible");
  for (const Report& report : reports) {
    const double visible = report.of_interest.visible;
    for (const Report::ReflectedPanel& panel : report.reflection.panels) {
      text += fmt::format("{:16} {:16} {:>16.6g} {:>14.2f} %\n", shortened(report.camera.name, name_width),
                          shortened(panel.name, name_width), panel.area_of_interest,
                          visible > 0 ? 100 * panel.area_of_interest / visible : 0.0);
    }
  }
  return text;
}

// Says what the cameras see together, where that is more to say than a camera's own line.
std::string coverage_lines(const Coverage& coverage, bool of_interest) {
  if (coverage.cameras.size() < 2) return "";
  const auto line = [&](const char* what, double area) {
    return fmt::format("{:33} {:>16.6g} {:>14.2f} %\n", what, area, 100 * share_of(area, coverage.area));
  };
  std::string text = fmt::format("\n{:33} {:>16} {:>16}\n", "all cameras together", "area",
                                 of_interest ? "of interest" : "of the surface");
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

// Says how much of each object is seen, of the first ones.
std::string region_lines(const SeenRegions& seen, bool several_cameras, bool with_panels) {
  if (seen.regions.empty()) return "";
  const auto percent = [](double part, double whole) { return fmt::format("{:.2f} %", 100 * share_of(part, whole)); };
  std::string text = fmt::format("\n{:26} {:>10} {:>10} {:>9}", to_string(seen.kind), "area",
                                 several_cameras ? "seen by any" : "visible", "share");
  text += with_panels ? fmt::format(" {:>10} {:>9}\n", "reflecting", "share") : "\n";
  for (std::size_t r = 0; r < std::min(seen.regions.size(), listed_regions); ++r) {
    const SeenRegion& region = seen.regions[r];
    text += fmt::format("{:26} {:>10.6g} {:>10.6g} {:>9}", shortened(region.name, region_width), region.area,
                        region.visible, percent(region.visible, region.area));
    if (with_panels)
      text += fmt::format(" {:>10.6g} {:>9}", region.reflecting, percent(region.reflecting, region.area));
    text += '\n';
  }
  if (seen.regions.size() > listed_regions)
    text += fmt::format("and {} more in regions.csv\n", seen.regions.size() - listed_regions);
  return text;
}

// What every camera's report says is about the surface, and counts once.
std::size_t warning_count(const std::vector<Report>& reports) {
  const auto is_in_all = [&](const std::string& warning) {
    return std::ranges::all_of(reports, [&](const Report& report) {
      return std::ranges::find(report.warnings, warning) != report.warnings.end();
    });
  };
  std::size_t count = 0;
  for (const Report& report : reports) {
    const bool is_first = &report == &reports.front();
    count += static_cast<std::size_t>(std::ranges::count_if(
        report.warnings, [&](const std::string& warning) { return is_first || !is_in_all(warning); }));
  }
  return count;
}

std::string warnings_line(const std::vector<Report>& reports) {
  const std::size_t count = warning_count(reports);
  if (count == 0) return "";
  return fmt::format("\n{} warning{}: see \"warnings\" in report.json\n", count, count == 1 ? "" : "s") +
         doubt_lines(reports);
}

}  // namespace

std::string summary(const std::vector<Report>& reports, const Coverage& coverage, const SeenRegions& regions,
                    const std::string& output, bool with_page) {
  std::string text = scene_line(reports.front()) + table_head();
  for (const Report& report : reports) text += camera_line(report);
  text += panel_lines(reports);
  text += coverage_lines(coverage, reports.front().of_interest.were_chosen);
  text += region_lines(regions, reports.size() > 1, !coverage.together.panels.empty());
  text += warnings_line(reports);
  text += fmt::format("\nOne folder per camera in {}\n", output);
  text += "  view.svg       the visible polygons as the camera sees them\n";
  text += "  labelled.ply   the refined surface with labels (also labelled.obj)\n";
  text += "  faces.csv      how much of each face is seen (also segments.csv, report.json)\n";
  text += "Beside them: coverage.csv, how much cameras and panels cover together\n";
  text += "             regions.csv, how much of each object, group and material is seen\n";
  if (with_page) text += "             report.html, all of this in 3D\n";
  text +=
      "Start with " + output + (with_page ? "/report.html" : "/" + reports.front().camera.name + "/view.svg") + "\n";
  return text;
}

}  // namespace sightline::cli
