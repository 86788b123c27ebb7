#include "coverage/coverage.h"

#include <algorithm>
#include <bit>

#include "geometry/mesh/area.h"
#include "geometry/mesh/facet_plane.h"

namespace sightline::inline coverage {
namespace {

// The selection says which triangles are asked for: those that are seen, or those that mirror one of the panels.
struct Selection {
  bool visible = false;
  std::uint64_t panels = 0;

  [[nodiscard]] bool has(const SeenTriangle& t) const { return visible || (t.reflecting & panels) != 0; }
  [[nodiscard]] bool has_all_of(const SeenSurface& s) const {
    return visible ? s.seen_everywhere : (s.reflecting_everywhere & panels) != 0;
  }
};

constexpr Selection visible_part{true, 0};

// A sight is what one camera sees of one surface.
struct Sight {
  const SeenSurface* surface = nullptr;
  std::span<const SeenTriangle> triangles;
};

// This is one surface, with those that see some of it.
class SurfaceCover {
 public:
  SurfaceCover(const CutMesh& mesh, FacetId surface) : mesh_(&mesh), surface_(surface) {
    for (FacetId f = surface; f < end_of_surface(mesh, surface); f = FacetId(f.index() + 1))
      area_ += facet_area(mesh, f);
  }

  void add(const Sight& sight) {
    sights_.push_back(sight);
    panels_ |= sight.surface->reflecting_somewhere;
  }

  [[nodiscard]] double area() const { return area_; }
  [[nodiscard]] std::uint64_t panels() const { return panels_; }  // those that some of it mirrors

  // Returns the area of the selected triangles of one camera, which do not overlap.
  [[nodiscard]] double alone(const Sight& sight, const Selection& selection) const {
    if (selection.has_all_of(*sight.surface)) return area_;
    double sum = 0;
    for (const SeenTriangle& t : sight.triangles) {
      if (selection.has(t)) sum += triangle_area(t.corners[0], t.corners[1], t.corners[2]);
    }
    return std::min(sum, area_);
  }

  [[nodiscard]] double together(const Selection& selection) const {
    double largest = 0;
    double sum = 0;
    std::size_t count = 0;
    for (const Sight& sight : sights_) {
      const double area = alone(sight, selection);
      largest = std::max(largest, area);
      sum += area;
      count += area > 0 ? 1U : 0U;
    }
    if (count < 2 || largest == area_) return largest;
    const double share = union_share(*mesh_, surface_, selected(selection)).share;
    return std::clamp(share * area_, largest, std::min(sum, area_));
  }

 private:
  [[nodiscard]] std::vector<SpaceTriangle> selected(const Selection& selection) const {
    std::vector<SpaceTriangle> triangles;
    for (const Sight& sight : sights_) {
      for (const SeenTriangle& t : sight.triangles) {
        if (selection.has(t)) triangles.push_back(t.corners);
      }
    }
    return triangles;
  }

  const CutMesh* mesh_;
  FacetId surface_;
  double area_ = 0;
  std::vector<Sight> sights_;
  std::uint64_t panels_ = 0;
};

// Adds what a surface has of each kind, by `area(selection)`, and returns the areas visible and reflecting. Where the
// sweeps of two selections round differently, what has more keeps more, and no union exceeds the sum.
template <class Area>
std::array<double, 2> add_areas(CoveredAreas& sums, std::uint64_t panels, Area area) {
  double largest = 0;
  double sum = 0;
  for (std::size_t p = 0; p < sums.panels.size(); ++p) {
    if ((panels >> p & 1U) == 0) continue;
    const double mirrors_panel = area(Selection{false, std::uint64_t{1} << p});
    sums.panels[p] += mirrors_panel;
    largest = std::max(largest, mirrors_panel);
    sum += mirrors_panel;
  }
  const bool is_known = std::popcount(panels) < 2;
  const double reflecting = is_known ? largest : std::clamp(area(Selection{false, panels}), largest, sum);
  const double visible = std::max(reflecting, area(visible_part));
  sums.any_panel += reflecting;
  sums.visible += visible;
  return {visible, reflecting};
}

// This goes through the surfaces in order, and with them through what each camera sees.
class Accumulation {
 public:
  Accumulation(const CutMesh& mesh, std::span<const SeenPart> cameras, std::size_t panel_count,
               std::span<const std::uint8_t> counting)
      : mesh_(mesh), cameras_(cameras), counting_(counting), next_(cameras.size(), 0) {
    const CoveredAreas nothing{0, 0, std::vector<double>(panel_count, 0)};
    result_.cameras.assign(cameras.size(), nothing);
    result_.together = nothing;
    uncounted_ = nothing;
    result_.faces.resize(mesh.face_count());
  }

  Coverage run() {
    for (FacetId surface(0); surface.index() < mesh_.facet_count(); surface = end_of_surface(mesh_, surface))
      add(surface);
    return std::move(result_);
  }

 private:
  void add(FacetId surface) {
    SurfaceCover cover(mesh_, surface);
    const std::size_t face_number = mesh_.facet_face[surface.index()].index();
    const bool counts = counting_.empty() || counting_[face_number] != 0;
    for (std::size_t c = 0; c < cameras_.size(); ++c)
      add_sight(cover, surface, c, counts ? result_.cameras[c] : uncounted_);
    FaceCoverage& face = result_.faces[face_number];
    if (counts) result_.area += cover.area();
    face.area += cover.area();
    const auto [visible, reflecting] = add_areas(counts ? result_.together : uncounted_, cover.panels(),
                                                 [&](const Selection& s) { return cover.together(s); });
    face.visible += visible;
    face.reflecting += reflecting;
  }

  void add_sight(SurfaceCover& cover, FacetId surface, std::size_t camera, CoveredAreas& sums) {
    const SeenPart& part = cameras_[camera];
    const std::size_t i = next_[camera];
    if (i == part.surfaces.size() || part.surfaces[i].surface != surface) return;
    ++next_[camera];
    const Sight sight{&part.surfaces[i], part.triangles_of(i)};
    cover.add(sight);
    add_areas(sums, sight.surface->reflecting_somewhere, [&](const Selection& s) { return cover.alone(sight, s); });
  }

  const CutMesh& mesh_;
  std::span<const SeenPart> cameras_;
  std::span<const std::uint8_t> counting_;
  std::vector<std::size_t> next_;  // per camera, into its surfaces
  CoveredAreas uncounted_;         // sums of faces that do not count: nobody reads them
  Coverage result_;
};

}  // namespace

Coverage cover(const CutMesh& mesh, std::span<const SeenPart> cameras, std::size_t panel_count,
               std::span<const std::uint8_t> counting) {
  return Accumulation(mesh, cameras, panel_count, counting).run();
}

}  // namespace sightline::inline coverage
