// How an Analyzer works, and the hook by which it can be watched and stopped.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/numbers/arithmetic.h"
#include "geometry/numbers/export.h"
#include "geometry/projection/culling.h"
#include "reflect/world/reflection_options.h"
#include "sweep/engine.h"

namespace sightline {

// The stages of an analysis, in their order. The first two come once for a mesh, if at all: cutting on a grid only, contacts
// also where they say whether a closed surface may be culled. The others come once for a camera.
enum class Stage : std::uint8_t { contacts, cut, sides, project, sweep, reconstruct, reflect, label };

// Whoever wants to show progress, take times, check memory or cancel derives from this. Whatever a function throws ends the
// analysis with that exception; so does what the sweep's observer throws.
class SIGHTLINE_EXPORT AnalysisHook {
 public:
  AnalysisHook() = default;
  AnalysisHook(const AnalysisHook&) = delete;
  AnalysisHook& operator=(const AnalysisHook&) = delete;
  virtual ~AnalysisHook() = default;

  virtual void begins(Stage /*stage*/) {}
  virtual void ended(Stage /*stage*/, double /*seconds*/) {}

  // The scene is projected: from its counts one can tell what the sweep will need.
  virtual void projected(const ProjectedScene& /*scene*/) {}

  // The sweep that begins now has this observer; null where nobody looks.
  [[nodiscard]] virtual SweepObserver* sweep_observer() { return nullptr; }
};

// Results depend on sides, precision and reflection only. Nothing is rounded unless precision says otherwise.
struct AnalysisOptions {
  SidesPolicy sides = SidesPolicy::automatic;
  Precision precision{Arithmetic::unrounded, default_grid_bits};
  Engine engine = Engine::fast;
  std::size_t threads = 0;  // at most so many; 0: as many as the calling task arena (oneTBB) has
  ReflectionOptions reflection{};
  // Normals that were given: per corner of the input's faces, zero where there is none; or nothing at all.
  std::vector<Vector3> corner_normals{};
  AnalysisHook* hook = nullptr;              // outlives the analyzer
  std::vector<std::uint8_t> mirror_faces{};  // per face of the input 1 where it mirrors panels; empty: all faces do
};

}  // namespace sightline
