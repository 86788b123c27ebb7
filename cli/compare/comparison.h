// `sightline compare` finds, for each peer, in a process of its own, how long it took on the scene, what memory, how
// wrong it is, and pictures.
//
// Holds: time and memory are the peer's alone, from the flat scene on, in one thread: not those of measuring it. Memory is
//      what the process held at most above what it had at the start.
// Errors: std::system_error where no process can be started; what goes wrong in the peer is in the result.
#pragma once

#include <cstddef>
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

// The end says what became of a run. An end that is not listed here does not exist.
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

struct Comparison {
  std::string scene;   // the file
  std::string camera;  // its name
  std::size_t faces = 0;
  std::size_t polygons = 0;  // in view: what the peers begin with
  std::size_t visible_faces = 0;
  double limit_seconds = 0;
  std::vector<CompareRun> runs;  // by peer, then by resolution
};

// The name of a run's picture, without what it shows and ".png": the peer and, where it has pixels, the resolution.
[[nodiscard]] std::string picture_name(const CompareRun& run);

// The runs of one peer each, in the order of the runs.
[[nodiscard]] std::vector<std::vector<const CompareRun*>> by_peer(const Comparison& comparison);

}  // namespace sightline::cli
