// Rows of cells in, a Markdown table out, its columns aligned for reading as it is.
//
// Holds: every row has as many cells as the heading. Complexity: O(text). Errors: none.
#pragma once

#include <string>
#include <vector>

namespace sightline::bench {

using TableRow = std::vector<std::string>;

[[nodiscard]] std::string markdown_table(const TableRow& heading, const std::vector<TableRow>& rows);

}  // namespace sightline::bench
