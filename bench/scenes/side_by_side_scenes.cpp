#include "bench/scenes/side_by_side_scenes.h"

#include <algorithm>
#include <iterator>

#include "bench/scenes/generated_scenes.h"
#include "bench/scenes/side_by_side_models.h"

namespace sightline::bench {
namespace {

using SceneOfSize = std::function<BenchScene(std::size_t triangles)>;

constexpr std::size_t sheets_for_cgal = 8;
constexpr std::size_t most_sheets = 64;
constexpr std::ptrdiff_t models_shown = 5;

std::vector<SceneMaker> of_sizes(const SceneOfSize& make, const std::vector<std::size_t>& sizes) {
  std::vector<SceneMaker> makers;
  for (const std::size_t size : sizes) makers.push_back({std::to_string(size), [make, size] { return make(size); }});
  return makers;
}

// The sizes are 100, 300, 1000, 3000, ...
std::vector<std::size_t> sizes_for_cgal(std::size_t largest) {
  std::vector<std::size_t> sizes;
  for (std::size_t power = 100; power <= largest; power *= 10) {
    sizes.push_back(power);
    if (3 * power <= largest) sizes.push_back(3 * power);
  }
  return sizes;
}

SceneFamily growing(const std::string& name, const std::string& number, const std::string& title,
                    const SceneOfSize& make, const std::vector<std::size_t>& sizes) {
  return {name, number, title, "size", of_sizes(make, sizes), of_sizes(make, sizes_for_cgal(sizes.back()))};
}

BenchScene scene_of(Mesh mesh, const Camera& camera, Sides sides) {
  return {std::make_shared<const CutMesh>(uncrossed(std::move(mesh))), camera, sides, {}, 0};
}

SceneFamily sheet_family(const std::string& name, const std::string& number, const std::string& title, FrontSheet front,
                         std::size_t triangles) {
  const auto scene = [front](std::size_t size, std::size_t count) {
    return scene_of(sheets(size, count, front), view_into_box(), Sides::both);
  };
  SceneFamily family{name, number, title, "sheets", {}, {}};
  for (std::size_t count = 1; count <= most_sheets; count *= 2) {
    family.scenes.push_back({std::to_string(count), [=] { return scene(triangles, count); }});
  }
  family.for_cgal = of_sizes([=](std::size_t size) { return scene(size, sheets_for_cgal); }, sizes_for_cgal(triangles));
  return family;
}

SceneFamily model_family() {
  SceneFamily family{"models", "vii", "the largest models", "model", {}, model_makers()};
  const auto& all = family.for_cgal;
  const auto shown = std::min(models_shown, std::ssize(all));
  family.scenes.assign(all.end() - shown, all.end());
  return family;
}

std::vector<SceneFamily> all_families(const std::vector<std::size_t>& sizes) {
  const auto scene = [](Mesh (*make)(std::size_t), Camera (*camera)(), Sides sides) {
    return [=](std::size_t size) { return scene_of(make(size), camera(), sides); };
  };
  std::vector<SceneFamily> families{
      growing("sphere", "i", "a closed surface with folds", scene(folded_sphere, overview, Sides::front), sizes),
      growing("terrain", "ii", "a terrain at a grazing angle", scene(terrain, grazing_view, Sides::both), sizes),
      growing("shrinking-soup", "iii", "a soup of triangles, five deep",
              scene(shrinking_soup, view_into_box, Sides::both), sizes),
      growing("deep-soup", "iv", "a soup of triangles of one size", scene(deep_soup, view_into_box, Sides::both),
              sizes),
      sheet_family("sheets", "v", "sheets, the front one hides all", FrontSheet::whole, sizes.back()),
      sheet_family("leaves", "vi", "sheets behind leaves", FrontSheet::leaves, sizes.back()),
      model_family(),
  };
  families.front().compares_arithmetic = true;
  return families;
}

}  // namespace

bool is_wanted(const SideBySideOptions& options, const std::string& name) {
  return options.only.empty() || std::find(options.only.begin(), options.only.end(), name) != options.only.end();
}

std::vector<SceneFamily> scene_families(const SideBySideOptions& options) {
  std::vector<SceneFamily> wanted = all_families(options.sizes);
  std::erase_if(wanted, [&](const SceneFamily& family) { return !is_wanted(options, family.name); });
  return wanted;
}

}  // namespace sightline::bench
