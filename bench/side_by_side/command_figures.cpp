#include "bench/side_by_side/command_figures.h"
#include "sightline/analyzer.h"

#include <stdlib.h>
#include <tbb/global_control.h>

#include <bit>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "bench/scenes/generated_scenes.h"
#include "cli/results/view_files.h"
#include "cli/system/resources.h"
#include "formats/writing/window_points.h"
#include "geometry/numbers/mix.h"

namespace sightline::bench {
using namespace cli;
namespace {

// The digest depends on the numbers and their order. As a double it has its upper 53 bits.
class Digest {
 public:
  void add(std::uint64_t number) { state_ = mix(state_ ^ number); }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add(const Point3& p) {
    for (const double c : {p.x(), p.y(), p.z()}) add(c);
  }
  [[nodiscard]] double value() const { return static_cast<double>(state_ >> 11U); }

 private:
  std::uint64_t state_ = 0;
};

double digest(const View& view) {
  Digest digest;
  for (const VisibleSegment& s : view.segments.segments) {
    for (const std::uint32_t id : {s.start.value, s.end.value, s.facet.value, s.other.value, s.edge.value})
      digest.add(std::uint64_t{id});
  }
  for (const Point3& p : view.labelled.vertices) digest.add(p);
  for (const LabelledTriangle& t : view.labelled.triangles) {
    for (const auto corner : t.corners) digest.add(std::uint64_t{corner.value});
    digest.add(std::uint64_t{t.face.value} << 8U | static_cast<std::uint64_t>(t.label) << 1U | (t.seen ? 1U : 0U));
  }
  return digest.value();
}

View view_of(const std::shared_ptr<const CutMesh>& mesh) {
  return Analyzer(mesh, {.sides = SidesPolicy::front}).view(overview());
}

std::vector<double> run_with_threads(const std::shared_ptr<const CutMesh>& mesh, std::size_t threads) {
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
  const Stopwatch watch;
  const View view = view_of(mesh);
  const double seconds = watch.seconds();
  return {seconds, digest(view)};
}

std::uintmax_t bytes_in(const std::filesystem::path& folder) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) bytes += entry.file_size();
  }
  return bytes;
}

std::vector<double> run_writing(const std::shared_ptr<const CutMesh>& mesh, const std::filesystem::path& folder) {
  const ProcessorTime of_view;
  const View view = view_of(mesh);
  const double visibility = of_view.seconds();
  const ProcessorTime of_writing;
  {
    ResultFolders results(folder);
    write_view_files(results, view, {}, measure_faces(view), window_points(view));
    results.publish();
  }
  const double writing = of_writing.seconds();
  return {visibility, writing, static_cast<double>(bytes_in(folder)) / 1e6};
}

// The folder is there as long as the value is.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string path = (std::filesystem::temp_directory_path() / "sightline-bench-XXXXXX").string();
    if (mkdtemp(path.data()) == nullptr) throw std::runtime_error("no temporary folder: " + path);
    path_ = path;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

ThreadFigures measure_threads(std::size_t triangles, const RunLimits& limits) {
  const auto mesh = std::make_shared<const CutMesh>(uncrossed(folded_sphere(triangles)));
  const auto outcomes =
      run_in_turns({[&] { return run_with_threads(mesh, 1); }, [&] { return run_with_threads(mesh, 2); }}, limits);
  ThreadFigures figures{figure_of(outcomes[0], 0, limits), figure_of(outcomes[1], 0, limits), {}};
  const Figure one = figure_of(outcomes[0], 1, limits);
  const Figure two = figure_of(outcomes[1], 1, limits);
  if (one.kind == Figure::Kind::exactly && two.kind == Figure::Kind::exactly)
    figures.same_bytes = exactly(one.value == two.value ? 1 : 0);
  return figures;
}

WritingFigures measure_writing(std::size_t triangles, const RunLimits& limits) {
  const auto mesh = std::make_shared<const CutMesh>(uncrossed(folded_sphere(triangles)));
  const TemporaryFolder folder;
  const Outcome outcome = run_in_turns({[&] { return run_writing(mesh, folder.path()); }}, limits).front();
  return {figure_of(outcome, 0, limits), figure_of(outcome, 1, limits), figure_of(outcome, 2, limits)};
}

}  // namespace sightline::bench
