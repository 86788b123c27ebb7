#include "sightline/analyzer.h"

#include <tbb/task_arena.h>

#include <chrono>
#include <type_traits>
#include <utility>

#include "geometry/cutting/coincidence.h"
#include "geometry/cutting/common_lines.h"
#include "geometry/cutting/snapped_planes.h"
#include "geometry/numbers/errors.h"
#include "geometry/projection/frame_cut.h"
#include "reflect/triangles/reflecting_triangles.h"

namespace sightline {
namespace {

// The value of `work`, whose beginning and end the hook is told.
template <class Work>
auto in_stage(AnalysisHook* hook, Stage stage, Work work) {
  if (hook == nullptr) return work();
  hook->begins(stage);
  const auto start = std::chrono::steady_clock::now();
  auto result = work();
  hook->ended(stage, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  return result;
}

// The value of `work`, done by at most so many threads.
template <class Work>
auto by_threads(std::size_t threads, Work work) {
  if (threads == 0) return work();
  tbb::task_arena arena(static_cast<int>(threads));
  return arena.execute(work);
}

// Returns a mesh that nothing was cut of, with what all but lies on each other made coplanar where that is wanted.
CutMesh taken(Mesh mesh, const ReflectionOptions& options) {
  CutMesh result = uncrossed(std::move(mesh));
  if (options.snaps && options.coincidence > 0)
    result.snapped_to = snapped_planes(result, options.coincidence * size_of(result));
  return result;
}

}  // namespace

// Without rounding nothing has to be cut, and how the mesh meets itself is only asked where that says which sides count.
Analyzer::Analyzer(Mesh mesh, AnalysisOptions options) : options_(std::move(options)) {
  const bool cuts = options_.precision.arithmetic != Arithmetic::unrounded;
  by_threads(options_.threads, [&] {
    if (!cuts) {
      mesh_ = std::make_shared<const CutMesh>(taken(std::move(mesh), options_.reflection));
      contacts_.emplace();
      if (options_.sides == SidesPolicy::automatic && is_closed(*mesh_))
        contacts_ = in_stage(options_.hook, Stage::contacts, [&] { return find_contacts(*mesh_); });
      return;
    }
    contacts_ = in_stage(options_.hook, Stage::contacts, [&] { return find_contacts(mesh); });
    mesh_ = in_stage(options_.hook, Stage::cut, [&] {
      return std::make_shared<const CutMesh>(cut_along_common_lines(std::move(mesh), *contacts_));
    });
  });
}

Analyzer::Analyzer(std::shared_ptr<const CutMesh> mesh, AnalysisOptions options, std::optional<MeshContacts> contacts)
    : options_(std::move(options)), contacts_(std::move(contacts)), mesh_(std::move(mesh)) {}

Analyzer::Analyzer(CutMesh mesh, AnalysisOptions options, std::optional<MeshContacts> contacts)
    : Analyzer(std::make_shared<const CutMesh>(std::move(mesh)), std::move(options), std::move(contacts)) {}

View Analyzer::view(const Camera& camera) const { return find_view(camera, nullptr); }

View Analyzer::view(const Camera& camera, const std::vector<Panel>& panels) const {
  return view(camera, world(panels));
}

View Analyzer::view(const Camera& camera, const MirrorWorld& world) const {
  return find_view(camera, world.panels.empty() ? nullptr : &world);
}

MirrorWorld Analyzer::world(std::vector<Panel> panels) const {
  return make_mirror_world(mesh_, std::move(panels), options_.reflection, options_.corner_normals,
                           options_.mirror_faces);
}

Visibility Analyzer::visible(const Camera& camera) const {
  return by_threads(options_.threads, [&] { return find_visible(camera); });
}

SidesDecision Analyzer::sides(const Camera& camera) const {
  if (options_.sides == SidesPolicy::automatic && !contacts_)
    return {Sides::both, "both sides: it is not known how the mesh meets itself"};
  return decide_sides(*mesh_, contacts_.value_or(MeshContacts{}), camera, options_.sides);
}

std::shared_ptr<const CutMesh> Analyzer::framed(const Camera& camera) const {
  if (!camera.lens_image) return mesh_;
  if (options_.precision.arithmetic != Arithmetic::unrounded || mesh_->is_cut()) {
    throw CameraError("camera \"" + camera.name +
                      "\" has a lens, which needs arithmetic without rounding; leave --arithmetic and --grid-bits out");
  }
  return std::make_shared<const CutMesh>(cut_along_frame(*mesh_, camera));
}

Visibility Analyzer::find_visible(const Camera& camera) const {
  AnalysisHook* const hook = options_.hook;
  Visibility found;
  found.sides = in_stage(hook, Stage::sides, [&] { return sides(camera); });
  found.scene = in_stage(hook, Stage::project,
                         [&] { return project(framed(camera), camera, found.sides.sides, options_.precision); });
  if (hook != nullptr) hook->projected(found.scene);
  found.segments = in_stage(hook, Stage::sweep, [&] {
    return find_visible_segments(found.scene, options_.engine, hook != nullptr ? hook->sweep_observer() : nullptr);
  });
  found.polygons =
      in_stage(hook, Stage::reconstruct, [&] { return reconstruct_polygons(found.scene, found.segments); });
  return found;
}

// Its mirrors are the facets that the view has; what is in the way are uncut facets, which keep their numbers.
MirrorWorld Analyzer::framed(const MirrorWorld& world, const View& view) {
  MirrorWorld of_view = world;
  of_view.surface = view.scene.surface;
  return of_view;
}

void Analyzer::reflect(const MirrorWorld& world, View& view) const {
  ReflectedView reflected = in_stage(options_.hook, Stage::reflect, [&] {
    return find_reflections(world, std::move(view.scene), std::move(view.segments), view.polygons);
  });
  view.scene = std::move(reflected.scene);
  view.segments = std::move(reflected.segments);
  view.reflections = std::move(reflected.reflections);
}

void Analyzer::label(View& view) const {
  view.labelled = in_stage(options_.hook, Stage::label, [&] {
    return label_mesh(view.scene, view.segments, view.polygons, panel_borders(view.reflections));
  });
}

// Marking whole triangles comes after labelling, since it marks the triangles of the labelled surface.
View Analyzer::find_view(const Camera& camera, const MirrorWorld* world) const {
  return by_threads(options_.threads, [&] {
    View view{find_visible(camera), {}, {}};
    std::optional<MirrorWorld> of_view;
    if (world != nullptr && camera.lens_image) world = &of_view.emplace(framed(*world, view));
    const bool marks_triangles = options_.reflection.mode == ReflectionMode::triangles;
    if (world != nullptr && !marks_triangles) reflect(*world, view);
    label(view);
    if (world != nullptr && marks_triangles) {
      view.reflections =
          in_stage(options_.hook, Stage::reflect, [&] { return reflecting_triangles(*world, camera, view.labelled); });
    }
    return view;
  });
}

}  // namespace sightline
