// One peer on one scene, in a process of its own: how long it took, what memory, how wrong it is, and pictures.
//
// Holds: time and memory are the peer's alone, from the flat scene on, in one thread: not those of measuring it. Memory is
//      what the process held at most above what it had at the start.
// Errors: std::system_error where no process can be started; what goes wrong in the peer is in the result.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/compare/compare_pictures.h"
#include "peers/errors/line_errors.h"
#include "peers/scene/errors_of_areas.h"
#include "peers/scene/exact_parts.h"
#include "peers/scene/peer.h"

namespace sightline::cli {

// What became of a run. An end that is not listed here does not exist.
enum class CompareEnd : std::uint8_t {
  done,
  out_of_time,
  refused,  // the peer cannot work on such a scene
  failed,   // it could not end: of memory, or of an invariant that its arithmetic broke
};
[[nodiscard]] const char* to_string(CompareEnd end);

struct CompareRun {
  peers::Peer peer;
  std::optional<int> resolution;  // where the peer has pixels
  CompareEnd end = CompareEnd::failed;
  std::string why;  // where the end is refused or failed
  double seconds = 0;
  std::uint64_t peak_bytes = 0;
  std::vector<peers::Count> counts;
  std::optional<peers::AreaErrors> areas;  // of item buffers and visible parts
  std::optional<peers::LineErrors> lines;  // of visible lines
  ComparePictures pictures;
};

// Errors are measured against `exact`.
[[nodiscard]] CompareRun run_peer(const peers::Peer& peer, const peers::FlatScene& scene,
                                  const peers::ExactParts& exact, std::optional<int> resolution, double limit_seconds);

}  // namespace sightline::cli
