// The sweep of a view, traced: mesh and camera in, SweepLog out.
//
// In:  a mesh whose facets do not pass through each other, a camera, and names for its parts.
// Out: the log of the full sweep, with rings, each in the step in which its last segment closes. In float and double
//      the sweep may end early, or its segments may make no rings: then `broken` says why, and the log has what came
//      before.
// Complexity: steps times the length of the active edge list.
// Errors: TooManySteps beyond most_traced_points; InternalError.
#pragma once

#include <memory>

#include "trace/names.h"
#include "trace/sweep_log.h"
#include "trace/sweep_recorder.h"

namespace sightline::trace {

constexpr std::size_t most_traced_points = 5000;

// This view is traced, and its vertices, edges and faces are called so.
struct TracedView {
  std::shared_ptr<const CutMesh> mesh;
  Camera camera;
  Sides sides = Sides::both;
  Precision precision;
  SceneNames names;
};

[[nodiscard]] SweepLog trace_sweep(const TracedView& view, std::size_t most_points = most_traced_points);

}  // namespace sightline::trace
