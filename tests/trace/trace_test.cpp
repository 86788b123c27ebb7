// The sweep is written down step by step. This tests Fang's tables row by row, the golden log, what holds in every log,
// and the built-in scenes, which have the degeneracies that they are called by.
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "cli/trace/sweep_log_json.h"
#include "cli/trace/trace_examples.h"
#include "geometry/numbers/errors.h"
#include "tests/tools/analyzed.h"
#include "trace/trace_sweep.h"

namespace sightline::tests::trace_test {
using namespace cli;
using namespace trace;

namespace {

TracedView view_of(const TraceScene& scene, Arithmetic arithmetic = Arithmetic::exact) {
  return {std::make_shared<const CutMesh>(scene.mesh),
          scene.camera,
          Sides::both,
          {arithmetic, scene.precision.grid_bits},
          scene.names};
}

SweepLog log_of(const TraceScene& scene, Arithmetic arithmetic = Arithmetic::exact) {
  return trace_sweep(view_of(scene, arithmetic));
}

SweepLog log_of(const std::string& example) { return log_of(trace_example_named(example)->make()); }

std::string face_of(const SweepLog& log, FacetId surface) {
  return log.face_names[log.face_of[surface.index()].index()];
}

// Returns "o f d'" and "1 2 5 8" of a face after so many steps.
std::string vertices_until(const SweepLog& log, std::size_t steps, const std::string& face) {
  std::string text;
  for (std::size_t i = 0; i < steps; ++i) {
    for (const EmittedVertex& vertex : log.steps[i].vertices) {
      if (face_of(log, vertex.surface) == face) text += (text.empty() ? "" : " ") + vertex.name;
    }
  }
  return text;
}

std::string segments_until(const SweepLog& log, std::size_t steps, const std::string& face) {
  std::string text;
  for (std::size_t i = 0; i < steps; ++i) {
    for (const SegmentNumber number : log.steps[i].opened) {
      if (face_of(log, log.segments[number - 1].surface) == face)
        text += (text.empty() ? "" : " ") + std::to_string(number);
    }
  }
  return text;
}

std::string ends_of(const LoggedSegment& segment) {
  return segment.upwards ? segment.lower + " " + segment.upper : segment.upper + " " + segment.lower;
}

std::vector<LoggedBundle> replaced(std::vector<LoggedBundle> list, const SweepStep& step) {
  const auto first = list.begin() + static_cast<std::ptrdiff_t>(step.position);
  const auto place = list.erase(first, first + static_cast<std::ptrdiff_t>(step.removed));
  list.insert(place, step.inserted.begin(), step.inserted.end());
  return list;
}

void check_lists(const SweepLog& log) {
  std::vector<LoggedBundle> list;
  for (std::size_t i = 0; i < log.steps.size(); ++i) {
    const SweepStep& step = log.steps[i];
    INFO("step ", step.name);
    REQUIRE(step.position + step.removed <= list.size());
    list = replaced(std::move(list), step);
    std::set<EdgeId> edges;
    for (const LoggedBundle& bundle : list) {
      for (const EdgeId edge : bundle.edges) CHECK(edges.insert(edge).second);
      for (const SegmentNumber number : {bundle.left_segment, bundle.right_segment}) {
        if (number == 0) continue;
        CHECK(log.segments[number - 1].opened <= i);
        CHECK(log.segments[number - 1].closed.value() > i);
      }
    }
    if (!list.empty()) CHECK(list.back().nodes.empty());
  }
  CHECK(list.empty());
}

void check_segments(const SweepLog& log) {
  std::vector<std::size_t> opened(log.segments.size());
  std::vector<std::size_t> closed(log.segments.size());
  for (std::size_t i = 0; i < log.steps.size(); ++i) {
    for (const SegmentNumber number : log.steps[i].opened) {
      ++opened[number - 1];
      CHECK(log.segments[number - 1].opened == i);
    }
    for (const SegmentNumber number : log.steps[i].closed) {
      ++closed[number - 1];
      CHECK(log.segments[number - 1].closed == i);
    }
  }
  CHECK(opened == std::vector<std::size_t>(log.segments.size(), 1));
  CHECK(closed == opened);
}

// The ends of a ring's segments are the same points of the same surface.
void check_rings(const SweepLog& log) {
  std::size_t in_rings = 0;
  for (const LoggedRing& ring : log.rings) {
    in_rings += ring.segments.size();
    for (std::size_t i = 0; i < ring.segments.size(); ++i) {
      const LoggedSegment& segment = log.segments[ring.segments[i] - 1];
      const LoggedSegment& next = log.segments[ring.segments[(i + 1) % ring.segments.size()] - 1];
      CHECK((segment.upwards ? segment.upper : segment.lower) == (next.upwards ? next.lower : next.upper));
      CHECK(segment.surface == next.surface);
    }
  }
  CHECK(in_rings == log.segments.size());
}

template <class Holds>
bool any_step(const SweepLog& log, Holds holds) {
  return std::any_of(log.steps.begin(), log.steps.end(), holds);
}

bool has_bundle_of(const SweepStep& step, std::size_t edges) {
  return std::any_of(step.inserted.begin(), step.inserted.end(),
                     [&](const LoggedBundle& bundle) { return bundle.edges.size() >= edges; });
}

bool is_horizontal(const SweepLog& log, EdgeId edge) {
  const SceneEdge& e = log.scene.edge(edge);
  return log.scene.point(e.top).y == log.scene.point(e.bottom).y;
}

}  // namespace

TEST_CASE("trace: each row of table 5.2") {
  struct Row {
    std::string point, kind, vertices, segments, pentagon_vertices, pentagon_segments;
  };
  const std::vector<Row> table{
      {"O", "top", "o", "1 2", "", ""},
      {"E", "top", "o", "1 2", "e", "3 4"},
      {"F", "crossing", "o f", "1 2 5", "e", "3 4"},
      {"A", "side", "o f", "1 2 5", "e a", "3 4 6"},
      {"D", "side", "o f d'", "1 2 5 8", "e a d", "3 4 6 7"},
      {"G", "crossing", "o f d' g", "1 2 5 8 9 10", "e a d", "3 4 6 7"},
      {"C", "side", "o f d' g c'", "1 2 5 8 9 10 12", "e a d c", "3 4 6 7 11"},
      {"P", "side", "o f d' g c' p", "1 2 5 8 9 10 12 13", "e a d c", "3 4 6 7 11"},
      {"H", "crossing", "o f d' g c' p h", "1 2 5 8 9 10 12 13", "e a d c", "3 4 6 7 11"},
      {"I", "crossing", "o f d' g c' p h i", "1 2 5 8 9 10 12 13 14", "e a d c", "3 4 6 7 11"},
      {"B", "bottom", "o f d' g c' p h i", "1 2 5 8 9 10 12 13 14", "e a d c b", "3 4 6 7 11"},
      {"Q", "bottom", "o f d' g c' p h i q", "1 2 5 8 9 10 12 13 14", "e a d c b", "3 4 6 7 11"}};
  const SweepLog log = log_of("fang");
  REQUIRE(log.steps.size() == table.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    INFO("sweep point ", table[i].point);
    CHECK(log.steps[i].name == table[i].point);
    CHECK(to_string(log.steps[i].kind) == table[i].kind);
    CHECK(vertices_until(log, i + 1, "OPQ") == table[i].vertices);
    CHECK(segments_until(log, i + 1, "OPQ") == table[i].segments);
    CHECK(vertices_until(log, i + 1, "ABCDE") == table[i].pentagon_vertices);
    CHECK(segments_until(log, i + 1, "ABCDE") == table[i].pentagon_segments);
  }
}

TEST_CASE("trace: each row of table 5.4, and the rings that follow from it") {
  const std::vector<std::string> table{"o f",   "q o", "e a", "d e", "f d'", "a b", "c d",
                                       "d' c'", "g p", "h g", "b c", "c' i", "p h", "i q"};
  const SweepLog log = log_of("fang");
  REQUIRE(log.segments.size() == table.size());
  for (std::size_t i = 0; i < table.size(); ++i) CHECK(ends_of(log.segments[i]) == table[i]);
  std::set<std::set<SegmentNumber>> rings;
  for (const LoggedRing& ring : log.rings) rings.insert({ring.segments.begin(), ring.segments.end()});
  CHECK(rings == std::set<std::set<SegmentNumber>>{{1, 5, 8, 12, 14, 2}, {9, 10, 13}, {3, 4, 6, 7, 11}});
}

TEST_CASE("trace: a step says what happened, and what comes next") {
  const SweepLog log = log_of("fang");
  CHECK(log.steps[2].says ==
        "F is a crossing: ED and OP change places. From here on OP is hidden. Segment 1 ends, segment 5 starts.");
  CHECK(log.steps[8].says ==
        "H is a crossing: PQ and AB change places. OPQ goes out of view here. From here on PQ is hidden. Segments 13 "
        "and 10 end. With that a ring closes.");
  REQUIRE(log.steps[4].upcoming.size() == 5);
  CHECK_FALSE(log.steps[4].upcoming.front().vertex.valid());
  CHECK(log.steps.back().upcoming.empty());
  const LoggedPredicate& order = log.steps[4].predicates.front();
  CHECK(order.says == "D comes before the crossing of AB and OP: higher");
  CHECK(order.decided_by == "integers");
}

TEST_CASE("trace: what holds in the log of every built-in scene") {
  for (const TraceExample& example : trace_examples()) {
    INFO(example.name);
    const TraceScene scene = example.make();
    const SweepLog log = log_of(scene);
    CHECK(log.broken.empty());
    check_lists(log);
    check_segments(log);
    check_rings(log);
    const VisibleSegments untraced = plain_sweep(log.scene);
    CHECK(untraced.statistics.sweep_points == log.steps.size());
    CHECK(untraced.segments.size() == log.segments.size());
    for (const SweepStep& step : log.steps) {
      for (const LoggedPredicate& predicate : step.predicates) CHECK_FALSE(predicate.exact_sign.has_value());
    }
  }
}

TEST_CASE("trace: the built-in scenes have what they are called by") {
  const auto lies_on_edge = [](const SweepStep& s) { return s.place.vertex.valid() && !s.passed.empty(); };
  CHECK(any_step(log_of("vertex-on-edge"), lies_on_edge));
  CHECK(any_step(log_of("t-junction"), lies_on_edge));
  CHECK(any_step(log_of("edge-on-edge"), [](const SweepStep& s) { return has_bundle_of(s, 3); }));
  CHECK(any_step(log_of("many-through-one"), [](const SweepStep& s) { return s.passed.size() >= 4; }));
  CHECK(any_step(log_of("vertex-on-vertex"), [](const SweepStep& s) { return s.ended.size() >= 3; }));
  CHECK(any_step(log_of("hole"), [](const SweepStep& s) { return s.thread.has_value(); }));
  const SweepLog horizontal = log_of("horizontal");
  CHECK(any_step(horizontal, [&](const SweepStep& s) {
    return std::any_of(s.started.begin(), s.started.end(), [&](EdgeId e) { return is_horizontal(horizontal, e); });
  }));
  const SweepLog hole = log_of("hole");
  CHECK(std::count_if(hole.rings.begin(), hole.rings.end(), [](const LoggedRing& r) { return r.is_hole; }) == 2);
  CHECK(trace_example_named("interpenetrating")->make().mesh.is_cut());
  const SweepLog edge_on = log_of("edge-on");
  CHECK(std::count(edge_on.scene.status.begin(), edge_on.scene.status.end(), FacetStatus::edge_on) == 1);
}

TEST_CASE("trace: of coplanar faces the lower index is in front, by a rule and no arithmetic") {
  const SweepLog log = log_of("coplanar");
  CHECK(any_step(log, [](const SweepStep& step) {
    return std::any_of(step.predicates.begin(), step.predicates.end(), [](const LoggedPredicate& p) {
      return p.says == "ABC is in front of DEF: in one plane the lower face is in front" && p.decided_by == "rule";
    });
  }));
}

TEST_CASE("trace: where float is wrong the log has its wrong signs, and where it stops the invariant") {
  const TraceScene wrong = trace_example_named("float-wrong")->make();
  CHECK(wrong.precision.arithmetic == Arithmetic::single_precision);
  const SweepLog log = log_of(wrong, Arithmetic::single_precision);
  CHECK(log.broken.empty());
  CHECK(log.segments.size() != log_of(wrong).segments.size());
  CHECK(any_step(log, [](const SweepStep& step) {
    return std::any_of(step.predicates.begin(), step.predicates.end(), [](const LoggedPredicate& p) {
      return p.question == "depth" && p.decided_by == "float" && p.exact_sign.has_value();
    });
  }));
  const SweepLog stopped = log_of(trace_example_named("float-stops")->make(), Arithmetic::single_precision);
  CHECK(stopped.broken.starts_with("the bundles through the point are not next to each other"));
  CHECK(stopped.steps.size() > 10);
}

TEST_CASE("trace: predicates name the tier that decided") {
  std::map<std::string, int> tiers;
  for (const TraceExample& example : trace_examples()) {
    for (const SweepStep& step : log_of(example.make()).steps) {
      for (const LoggedPredicate& predicate : step.predicates) ++tiers[predicate.decided_by];
    }
  }
  for (const char* tier : {"integers", "filter", "exact", "ranges", "rule"}) {
    INFO(tier);
    CHECK(tiers[tier] > 0);
  }
  CHECK(tiers.size() == 5);
}

TEST_CASE("trace: a sweep with more points than there is room for is refused") {
  const TraceScene scene = trace_example_named("fang")->make();
  CHECK_THROWS_AS((void)trace_sweep(view_of(scene), 11), TooManySteps);
  CHECK_THROWS_AS((void)trace_sweep(view_of(scene), 7), TooManySteps);
  CHECK(trace_sweep(view_of(scene), 12).steps.size() == 12);
}

}  // namespace sightline::tests::trace_test
