#include "bench/side_by_side/side_by_side_goals.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bench/measuring/markdown_table.h"

namespace sightline::bench {
namespace {

constexpr std::array growing_families{"i", "ii", "iii", "iv"};

Goal at_most(double value) { return {Goal::Sense::at_most, value}; }
Goal at_least(double value) { return {Goal::Sense::at_least, value}; }

class GoalRows {
 public:
  explicit GoalRows(const std::vector<FamilyResult>& results) : results_(&results) {}

  // Returns null where it was not measured.
  [[nodiscard]] const FamilyResult* family(const std::string& number) const {
    const auto found = std::find_if(results_->begin(), results_->end(),
                                    [&](const FamilyResult& result) { return result.family.number == number; });
    return found == results_->end() || found->scenes.empty() ? nullptr : &*found;
  }

  void add(const std::string& what, const Goal& goal, const Figure& measured) {
    const char* const sense = goal.sense == Goal::Sense::at_most ? "<=" : ">=";
    rows_.push_back({what, fmt::format("{} {}", sense, goal.value), text_of(measured), reached(measured, goal)});
  }

  [[nodiscard]] const std::vector<FamilyResult>& results() const { return *results_; }
  [[nodiscard]] std::string table() const { return markdown_table({"what", "goal", "measured", "reached"}, rows_); }

 private:
  const std::vector<FamilyResult>* results_;
  std::vector<TableRow> rows_;
};

void add_parse(GoalRows& rows) {
  const FamilyResult* const sphere = rows.family("i");
  if (sphere == nullptr) return;
  const SceneResult& last = sphere->scenes.back();
  rows.add(fmt::format("(i) at {}: sum / tinyobjloader", last.label), at_most(1),
           ratio(last.view.sum, last.rivals.parse));
}

void add_exponents(GoalRows& rows) {
  for (const char* const number : growing_families) {
    const FamilyResult* const result = rows.family(number);
    if (result == nullptr) continue;
    const SceneResult& first = result->scenes.front();
    const SceneResult& last = result->scenes.back();
    const Growth size{static_cast<double>(first.triangles), static_cast<double>(last.triangles)};
    rows.add(fmt::format("({}): exponent of time in n, {} to {}", number, first.label, last.label), at_most(1.1),
             exponent(first.view.sum, last.view.sum, size));
  }
}

void add_sheets(GoalRows& rows) {
  const FamilyResult* const sheets = rows.family("v");
  if (sheets == nullptr) return;
  const SceneResult& one = sheets->scenes.front();
  const SceneResult& most = sheets->scenes.back();
  rows.add(fmt::format("(v): {} sheets / {} sheet, {} triangles", most.label, one.label, one.triangles), at_most(1.2),
           ratio(most.view.sum, one.view.sum));
}

void add_cgal(GoalRows& rows) {
  for (const FamilyResult& result : rows.results()) {
    const CgalResult* const row = largest_that_cgal_ends(result);
    if (row == nullptr) continue;
    rows.add(fmt::format("({}) at {}: CGAL / sum", result.family.number, row->label), at_least(100),
             ratio(row->envelope, row->view));
  }
}

void add_gl2ps(GoalRows& rows) {
  const FamilyResult* const soup = rows.family("iv");
  if (soup == nullptr) return;
  const SceneResult& last = soup->scenes.back();
  rows.add(fmt::format("(iv) at {}: gl2ps / sum", last.label), at_least(3), ratio(last.rivals.gl2ps, last.view.sum));
}

void add_embree(GoalRows& rows) {
  const FamilyResult* const sphere = rows.family("i");
  if (sphere == nullptr) return;
  const SceneResult& last = sphere->scenes.back();
  rows.add(fmt::format("(i) at {}: sum / Embree", last.label), at_most(3), ratio(last.view.sum, last.rivals.embree));
}

void add_memory(GoalRows& rows) {
  for (const char* const number : growing_families) {
    const FamilyResult* const result = rows.family(number);
    if (result == nullptr) continue;
    const SceneResult& last = result->scenes.back();
    rows.add(fmt::format("({}) at {}: bytes per triangle above the mesh", number, last.label), at_most(500),
             last.view.bytes_per_triangle);
  }
}

void add_arithmetic(GoalRows& rows) {
  const FamilyResult* const sphere = rows.family("i");
  if (sphere == nullptr) return;
  const SceneResult& last = sphere->scenes.back();
  rows.add(fmt::format("(i) at {}: exact / double arithmetic", last.label), at_most(1.2),
           ratio(last.view.sum, last.double_precision));
}

void add_command(GoalRows& rows, const CommandResult& command) {
  if (command.threads) {
    rows.add("1 thread / 2 threads, by the clock on the wall", at_least(1.7),
             ratio(command.threads->one, command.threads->two));
    rows.add("1 and 2 threads: the same bytes (1: yes)", at_least(1), command.threads->same_bytes);
  }
  if (command.reflection)
    rows.add("reflection / view", at_most(1), ratio(command.reflection->reflection, command.reflection->visibility));
  if (command.writing)
    rows.add("writing all outputs / view", at_most(1), ratio(command.writing->writing, command.writing->visibility));
}

}  // namespace

std::string goals_table(const std::vector<FamilyResult>& results, const CommandResult& command) {
  GoalRows rows(results);
  add_parse(rows);
  add_exponents(rows);
  add_sheets(rows);
  add_cgal(rows);
  add_gl2ps(rows);
  add_embree(rows);
  add_memory(rows);
  add_arithmetic(rows);
  add_command(rows, command);
  return "## Goals\n\n" + rows.table();
}

}  // namespace sightline::bench
