// The fast engine gives what the sweep of everything gives, on every mesh of the optional folder of models.
#include <doctest/doctest.h>

#include "geometry/obj_reader.h"
#include "tests/engine_comparison.h"
#include "tests/model_shots.h"
#include "tests/oracle/judge.h"

namespace sightline::oracle {

TEST_CASE("engines: models") {
  for (const std::filesystem::path& file : models()) {
    const Mesh whole = read_obj(file).mesh;
    const Mesh mesh = cut(whole);
    for (const Shot& shot : shots(whole)) {
      INFO(file.filename().string(), " ", shot.camera.name);
      testing::EngineTally tally;
      CHECK(testing::engine_differences(mesh, project(mesh, shot.camera, shot.sides),
                                        {{4, 1}, {7, 7}, {8, 64}, {10, 2}}, tally) == "");
      MESSAGE(file.filename().string() << " " << shot.camera.name << ": " << tally.swept << " of " << tally.points
                                       << " sweep points swept");
    }
  }
}

}  // namespace sightline::oracle
