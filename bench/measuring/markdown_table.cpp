#include "bench/measuring/markdown_table.h"

#include <algorithm>
#include <cstddef>

namespace sightline::bench {
namespace {

using Widths = std::vector<std::size_t>;

void widen(Widths& widths, const TableRow& row) {
  for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
}

std::string line_of(const TableRow& row, const Widths& widths) {
  std::string line = "|";
  for (std::size_t i = 0; i < row.size(); ++i)
    line += " " + row[i] + std::string(widths[i] - row[i].size(), ' ') + " |";
  return line + "\n";
}

std::string rule_of(const Widths& widths) {
  std::string line = "|";
  for (const std::size_t width : widths) line += std::string(width + 2, '-') + "|";
  return line + "\n";
}

}  // namespace

std::string markdown_table(const TableRow& heading, const std::vector<TableRow>& rows) {
  Widths widths(heading.size(), 0);
  widen(widths, heading);
  for (const TableRow& row : rows) widen(widths, row);
  std::string text = line_of(heading, widths) + rule_of(widths);
  for (const TableRow& row : rows) text += line_of(row, widths);
  return text;
}

}  // namespace sightline::bench
