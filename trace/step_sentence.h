// A step in words: what happened and why.
//
// In:  a step with all but its sentence, the log's names, and the active edge list after the step.
// Out: plain text; names of faces and points are in it as they are.
#pragma once

#include <span>
#include <string>

#include "trace/sweep_log.h"

namespace sightline::trace {

[[nodiscard]] std::string sentence_of(const SweepStep& step, const SweepLog& log, std::span<const LoggedBundle> after);

}  // namespace sightline::trace
