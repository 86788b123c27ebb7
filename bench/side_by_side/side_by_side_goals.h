// Which of the goals are reached.
//
// In:  the results of all families, and of what else was measured.
// Out: a Markdown table: the goal, what was measured, whether that is enough. A goal whose scenes were not measured has
//      no row. A further goal is a further function that adds rows.
// Complexity: O(rows). Errors: none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/side_by_side/command_figures.h"
#include "bench/side_by_side/side_by_side_results.h"

namespace sightline::bench {

struct CommandResult {
  std::optional<ThreadFigures> threads;
  std::optional<ReflectionFigures> reflection;
  std::optional<WritingFigures> writing;
};

[[nodiscard]] std::string goals_table(const std::vector<FamilyResult>& results, const CommandResult& command);

}  // namespace sightline::bench
