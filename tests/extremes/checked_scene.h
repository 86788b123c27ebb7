// Every test of an extreme scene has this frame: it reads the scene, checks what holds for all of them, and hands back
// what each camera sees for the checks that are the scene's own.
#pragma once

#include "tests/extremes/checks.h"

namespace sightline::extremes {

struct CheckedScene {
  Mesh mesh;
  std::vector<Sight> sights;

  [[nodiscard]] const Sight& from(std::string_view camera) const { return sight_from(sights, camera); }
};

// These say what a scene allows.
struct Allowances {
  // Where faces overlap in one plane the lower index is in front: then only the sum of the areas stays.
  bool coplanar = false;
  // The scene has too many faces for the rational oracle.
  bool large = false;
  // Doubles are as far apart as the scene is large: points that the labelled surface adds have none of their own, so
  // what its checker says of it is left out.
  bool coarse_doubles = false;
};

[[nodiscard]] CheckedScene checked(const std::string& name, const Allowances& allowances = {});

}  // namespace sightline::extremes
