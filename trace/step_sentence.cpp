#include "trace/step_sentence.h"

#include <algorithm>

#include "trace/names.h"

namespace sightline::trace {

namespace {

std::string name_of(EdgeId edge, const SweepLog& log) {
  const SceneEdge& e = log.scene.edge(edge);
  return name_of_edge(log.point_names[e.top.index()], log.point_names[e.bottom.index()]);
}

std::string name_of(FacetId facet, const SweepLog& log) { return log.face_names[log.face_of[facet.index()].index()]; }

template <class Ids>
std::string names_of(const Ids& ids, const SweepLog& log) {
  std::vector<std::string> names;
  for (const auto id : ids) names.push_back(name_of(id, log));
  return listed(names);
}

std::string numbers_of(const std::vector<SegmentNumber>& numbers) {
  std::vector<std::string> words;
  for (const SegmentNumber number : numbers) words.push_back(std::to_string(number));
  return (numbers.size() == 1 ? "segment " : "segments ") + listed(words);
}

const char* verb(std::size_t count, const char* one, const char* many) { return count == 1 ? one : many; }

std::string edges_that(const std::vector<EdgeId>& edges, const SweepLog& log, const char* one, const char* many) {
  return names_of(edges, log) + " " + verb(edges.size(), one, many);
}

std::string of_crossing(const SweepStep& step, const SweepLog& log) {
  if (step.passed.size() == 2) return step.name + " is a crossing: " + names_of(step.passed, log) + " change places.";
  return step.name + " is a crossing of several edges: " + names_of(step.passed, log) + " turn round.";
}

std::string of_vertex(const SweepStep& step, const SweepLog& log) {
  std::string text = step.name + " is a " + to_string(step.kind) + " vertex: ";
  if (step.kind == PointKind::top) {
    text += step.started.empty()
                ? "nothing starts here"
                : "no edge ends here, so its place is searched; " + edges_that(step.started, log, "starts", "start");
  } else if (step.kind == PointKind::side) {
    text += edges_that(step.ended, log, "ends", "end") + ", and " + edges_that(step.started, log, "starts", "start") +
            " in its place";
  } else {
    text += edges_that(step.ended, log, "ends", "end") + ", and nothing starts";
  }
  if (!step.passed.empty()) text += "; it lies on " + edges_that(step.passed, log, "which goes on", "which go on");
  if (!step.place.crossings.empty()) text += "; edges cross here, too";
  return text + ".";
}

std::string of_bundles(const SweepStep& step, const SweepLog& log) {
  std::string text;
  for (const LoggedBundle& bundle : step.inserted) {
    if (bundle.edges.size() > 1) text += " " + names_of(bundle.edges, log) + " lie on each other and are one bundle.";
  }
  return text;
}

bool has_side(EdgeId edge, FacetId facet, const SweepLog& log) {
  const auto sides = log.scene.sides_of(edge);
  return std::any_of(sides.begin(), sides.end(), [&](const EdgeSide& side) { return side.facet == facet; });
}

// Returns whether no edge at the point is seen, and all are behind the facet that is topmost left of it.
bool is_behind(FacetId front, const SweepStep& step, const SweepLog& log) {
  for (const auto* edges : {&step.ended, &step.started, &step.passed}) {
    if (std::any_of(edges->begin(), edges->end(), [&](EdgeId e) { return has_side(e, front, log); })) return false;
  }
  return std::all_of(step.inserted.begin(), step.inserted.end(),
                     [](const LoggedBundle& bundle) { return bundle.left_segment == 0 && bundle.right_segment == 0; });
}

std::string of_nothing_seen(const SweepStep& step, const SweepLog& log, std::span<const LoggedBundle> after) {
  const bool covered = step.position > 0 && !after[step.position - 1].nodes.empty();
  const FacetId front = covered ? after[step.position - 1].nodes.front() : FacetId();
  if (!covered || !is_behind(front, step, log)) return " What is seen stays as it is.";
  return " All of it is behind " + name_of(front, log) + ": what is seen stays as it is.";
}

std::string of_visibility(const SweepStep& step, const SweepLog& log, std::span<const LoggedBundle> after) {
  std::string text;
  if (!step.appeared.empty())
    text += " " + names_of(step.appeared, log) + verb(step.appeared.size(), " comes", " come") + " into view here.";
  if (!step.vanished.empty())
    text += " " + names_of(step.vanished, log) + verb(step.vanished.size(), " goes", " go") + " out of view here.";
  if (!step.covered.empty()) text += " From here on " + edges_that(step.covered, log, "is hidden.", "are hidden.");
  if (!step.surfaced.empty()) text += " From here on " + edges_that(step.surfaced, log, "is seen.", "are seen.");
  const bool nothing = step.opened.empty() && step.closed.empty();
  return nothing && text.empty() ? of_nothing_seen(step, log, after) : text;
}

std::string of_segments(const SweepStep& step) {
  std::string text;
  if (!step.closed.empty()) text += numbers_of(step.closed) + verb(step.closed.size(), " ends", " end");
  if (!step.closed.empty() && !step.opened.empty()) text += ", ";
  if (!step.opened.empty()) text += numbers_of(step.opened) + verb(step.opened.size(), " starts", " start");
  if (text.empty()) return "";
  text[0] = 'S';
  if (step.thread) text += "; a thread leads to segment " + std::to_string(*step.thread) + ", in case this is a hole";
  return " " + text + ".";
}

}  // namespace

std::string sentence_of(const SweepStep& step, const SweepLog& log, std::span<const LoggedBundle> after) {
  return (step.kind == PointKind::crossing ? of_crossing(step, log) : of_vertex(step, log)) + of_bundles(step, log) +
         of_visibility(step, log, after) + of_segments(step);
}

}  // namespace sightline::trace
