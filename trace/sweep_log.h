// The sweep of one view, written down step by step: what a page shows, a golden file holds, and a reader can check.
//
// Holds: a step is a sweep point. Segments are numbered from 1 in the order in which they open, as in Fang's tables
//      5.2 and 5.4. The active edge list after a step is the one before it with `removed` bundles, from `position`
//      on, replaced by `inserted`; all other bundles, their node lists and open segments are as they were.
// Source: Fang 1993, section 5.3.1, figure 5.6 (kinds of points), tables 5.2 and 5.4.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/projection/projected_scene.h"
#include "sweep/plain/sweep_state.h"

namespace sightline::trace {

// These are the points of Fang's figure 5.6. A vertex that lies on an edge which goes on is what its own edges make of
// it.
enum class PointKind : std::uint8_t { top, side, bottom, crossing };
[[nodiscard]] const char* to_string(PointKind kind);

// Numbers go from 1 on; 0 is none.
using SegmentNumber = std::uint32_t;

// This is one entry of the active edge list, with the node list of the span to its right: the topmost facet first, and
// then, where depth is an order, shallowest first.
struct LoggedBundle {
  std::vector<EdgeId> edges;
  std::vector<FacetId> nodes;
  SegmentNumber left_segment = 0;
  SegmentNumber right_segment = 0;
};

// A face gets a vertex of the output here: Fang's 2D vertex. Where several faces get one, they are told apart by
// primes: d and d'.
struct EmittedVertex {
  FacetId surface;
  std::string name;
};

struct Operand {
  std::string name;
  std::vector<double> coordinates;  // in grid units (x, y), of the input (x, y, z, and w for the eye), or a depth
};

// This is a decision behind a step.
struct LoggedPredicate {
  std::string question;  // side | direction | order | depth
  std::string says;      // the answer in words
  std::string formula;   // of the operands
  std::vector<Operand> operands;
  Sign sign = 0;
  std::optional<Sign> exact_sign;  // where the sweep's arithmetic is not exact and got it wrong
  std::string decided_by;          // filter | exact | integers | ranges | rule | float | double
};

struct SweepStep {
  PointKind kind = PointKind::top;
  SweepPlace place;
  std::string name;
  std::string says;                    // what happened and why, in words
  std::vector<EdgeId> ended, started;  // at this point
  std::vector<EdgeId> passed;          // edges that go on through it
  std::size_t position = 0;
  std::size_t removed = 0;
  std::vector<LoggedBundle> inserted;
  std::vector<SegmentNumber> opened, closed;
  std::vector<EmittedVertex> vertices;
  std::vector<FacetId> appeared,
      vanished;  // surfaces that are topmost at the point below it and not above, or the reverse
  std::vector<EdgeId> surfaced, covered;  // edges that go on, and are seen from here on, or no longer
  std::optional<SegmentNumber> thread;    // what starts here may be a hole: this segment is left of it
  std::vector<std::size_t> rings;         // that close here
  std::vector<SweepPlace> upcoming;       // the event queue's first entries
  std::vector<LoggedPredicate> predicates;
};

// The visible segment has the number i + 1. It runs from the point of one step to that of another.
struct LoggedSegment {
  FacetId surface;
  FacetId other;  // on its right, at its upper end; invalid: nothing
  EdgeId edge;
  bool upwards = false;  // it starts at its lower end
  std::size_t opened = 0;
  std::optional<std::size_t> closed;
  std::string upper, lower;  // the 2D vertices at its ends
};

struct LoggedRing {
  FacetId surface;
  std::size_t polygon = 0;
  bool is_hole = false;
  std::vector<SegmentNumber> segments;
};

struct SweepLog {
  ProjectedScene scene;
  std::vector<std::string> point_names;  // of the scene's points
  std::vector<std::string> face_names;   // by face
  std::vector<FaceId> face_of;           // by facet
  bool depth_is_transitive = true;
  std::vector<SweepStep> steps;
  std::vector<LoggedSegment> segments;
  std::vector<LoggedRing> rings;
  std::string broken;  // the invariant at which it ended, in float and double; empty: it did not
};

}  // namespace sightline::trace
