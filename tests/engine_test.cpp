// The fast engine gives what the sweep of everything gives, to the last bit, however fine its cells are.
#include "sweep/engine.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "cli/scene_file.h"
#include "geometry/interpenetration.h"
#include "geometry/obj_reader.h"
#include "tests/model_shots.h"
#include "tests/oracle/crossing_scenes.h"
#include "tests/oracle/judge.h"
#include "tests/oracle/random_scenes.h"

namespace sightline::oracle {
namespace {

auto as_tuple(const Crossing& c) { return std::tuple(c.a, c.b, c.after); }
auto as_tuple(const VisibleSegment& s) { return std::tuple(s.start, s.end, s.facet, s.other, s.edge); }
auto as_tuple(const Thread& t) { return std::tuple(t.top, t.facet, t.segment); }

// Where two lists begin to differ; empty where they do not.
template <class Item>
std::string difference(const char* what, const std::vector<Item>& a, const std::vector<Item>& b) {
  const auto [x, y] = std::mismatch(a.begin(), a.end(), b.begin(), b.end(),
                                    [](const Item& p, const Item& q) { return as_tuple(p) == as_tuple(q); });
  if (x == a.end() && y == b.end()) return "";
  return std::string(what) + " differ from number " + std::to_string(x - a.begin()) + " on; ";
}

std::string difference(const VisibleSegments& fast, const VisibleSegments& full) {
  return difference("crossings", fast.crossings, full.crossings) +
         difference("segments", fast.segments, full.segments) + difference("threads", fast.threads, full.threads) +
         (fast.splits == full.splits ? "" : "splits differ");
}

struct Tally {
  std::uint64_t points = 0;
  std::uint64_t swept = 0;
};

// With cells as the engine chooses them, and on each of the levels.
std::string differences(const Mesh& mesh, const ProjectedScene& scene, std::initializer_list<int> levels,
                        Tally& tally) {
  const VisibleSegments full = find_visible_segments(mesh, scene, Engine::full);
  std::string found = difference(find_visible_segments(mesh, scene, Engine::fast), full);
  for (const int level : levels) {
    const VisibleSegments fast = fast_visible_segments(mesh, scene, level);
    tally.points += full.statistics.sweep_points;
    tally.swept += fast.statistics.sweep_points;
    const std::string here = difference(fast, full);
    if (!here.empty()) found += "level " + std::to_string(level) + ": " + here;
  }
  return found;
}

void report(const RandomScene& scene, int level) {
  const auto differs = [level](const RandomScene& s) {
    const Mesh mesh = cut(mesh_of(s));
    Tally tally;
    return !differences(mesh, project(mesh, s.camera, s.sides), {level}, tally).empty();
  };
  const RandomScene small = reduced(scene, differs);
  const Mesh mesh = cut(mesh_of(small));
  Tally tally;
  FAIL_CHECK(differences(mesh, project(mesh, small.camera, small.sides), {level}, tally), to_text(small));
}

void check_random_scenes(RandomScene (*scene_of)(std::uint64_t), std::uint64_t scenes, Tally& tally) {
  int failures = 0;
  for (std::uint64_t seed = 1; seed <= scenes && failures < 3; ++seed) {
    const RandomScene scene = scene_of(seed);
    const Mesh mesh = cut(mesh_of(scene));
    const int level = static_cast<int>(seed % 8);
    if (differences(mesh, project(mesh, scene.camera, scene.sides), {level}, tally).empty()) continue;
    ++failures;
    report(scene, level);
  }
}

bool is_scene(const std::filesystem::path& file) {
  return file.extension() == ".toml" && file.string().find("bad-") == std::string::npos;
}

}  // namespace

TEST_CASE("engines: random scenes") {
  Tally tally;
  check_random_scenes(random_scene, scene_count(10000), tally);
  MESSAGE(tally.swept << " of " << tally.points << " sweep points swept");
  CHECK(tally.swept < tally.points);
}

TEST_CASE("engines: random scenes whose faces pass through each other") {
  Tally tally;
  check_random_scenes(crossing_scene, scene_count(3000), tally);
  CHECK(tally.points > 0);
}

TEST_CASE("engines: fixtures") {
  std::size_t views = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(SIGHTLINE_FIXTURES_DIR)) {
    if (!is_scene(entry.path())) continue;
    const Scene scene = read_scene_file(entry.path().string());
    const Mesh whole = read_obj(std::filesystem::path(scene.mesh_file)).mesh;
    const MeshContacts contacts = find_contacts(whole);
    const Mesh mesh = cut(whole);
    for (const Camera& camera : scene.cameras) {
      INFO(entry.path().string(), " ", camera.name);
      Tally tally;
      const Sides sides = decide_sides(mesh, contacts, camera, scene.sides).sides;
      CHECK(differences(mesh, project(mesh, camera, sides), {2, 4, 7}, tally) == "");
      ++views;
    }
  }
  CHECK(views >= 30);
}

TEST_CASE("engines: models") {
  for (const std::filesystem::path& file : models()) {
    const Mesh whole = read_obj(file).mesh;
    const Mesh mesh = cut(whole);
    for (const Shot& shot : shots(whole)) {
      INFO(file.filename().string(), " ", shot.camera.name);
      Tally tally;
      CHECK(differences(mesh, project(mesh, shot.camera, shot.sides), {4, 7, 10}, tally) == "");
      MESSAGE(file.filename().string() << " " << shot.camera.name << ": " << tally.swept << " of " << tally.points
                                       << " sweep points swept");
    }
  }
}

}  // namespace sightline::oracle
