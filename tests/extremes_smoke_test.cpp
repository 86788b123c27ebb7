#include <doctest/doctest.h>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include "tests/extremes/checked_scene.h"
TEST_CASE("smoke") {
  const char* name = std::getenv("SCENE");
  const auto scene = sightline::extremes::checked(name);
  for (const auto& s : scene.sights) {
    std::cout << name << " " << s.camera.name << " total " << sightline::extremes::total(s.areas).convert_to<double>()
              << " bound " << sightline::extremes::rounding_bound(s.view.scene).convert_to<double>() << " sides "
              << (s.sides == sightline::Sides::front) << "\n";
    if (scene.mesh.face_count() < 40)
      for (std::size_t f = 0; f < s.areas.size(); ++f)
        if (s.areas[f] != 0) std::cout << "  " << f << ": " << s.areas[f].convert_to<double>() << "\n";
  }
}
