// compare.csv and compare.json: a row per run. Empty, or null, is what does not apply or is not known.
//
// Shares are of the window, or of the length of all visible lines; relative errors are of a face's visible area, lengths in
// window units, seconds of processor time.
// Equal between runs except for seconds and peak_bytes.
#pragma once

#include <string>

#include "cli/compare/comparison.h"

namespace sightline::cli {

[[nodiscard]] std::string compare_table(const Comparison& comparison);
[[nodiscard]] std::string compare_json(const Comparison& comparison);

// The counts of a run in words: "pixels touched 400, nodes 12".
[[nodiscard]] std::string counts_text(const CompareRun& run);

}  // namespace sightline::cli
