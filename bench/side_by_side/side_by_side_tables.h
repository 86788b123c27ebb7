// These tables show in Markdown what was measured.
#pragma once

#include <string>

#include "bench/side_by_side/command_figures.h"
#include "bench/side_by_side/side_by_side_results.h"

namespace sightline::bench {

// Returns a heading, the times, the ratios, and the rows for CGAL.
[[nodiscard]] std::string family_tables(const FamilyResult& result);

[[nodiscard]] std::string reflection_table(std::size_t triangles, const ReflectionFigures& figures);
[[nodiscard]] std::string threads_table(std::size_t triangles, const ThreadFigures& figures);
[[nodiscard]] std::string writing_table(std::size_t triangles, const WritingFigures& figures);

}  // namespace sightline::bench
