// Progress on standard error: one line, rewritten in place; silent unless a person watches.
#pragma once

#include <cstddef>
#include <string>

#include "sweep/plain/sweep.h"

namespace sightline::cli {

class Progress {
 public:
  // shown: whether to write at all; see watched().
  explicit Progress(bool shown) : shown_(shown) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() { clear(); }

  // Whether standard error is a terminal.
  [[nodiscard]] static bool watched();

  [[nodiscard]] bool shown() const { return shown_; }
  void stage(const std::string& text);
  void percent(std::size_t percent);
  void clear();

 private:
  void write(const std::string& line) const;
  bool shown_;
  std::string stage_;
};

// Tells Progress how far the sweep is.
class SweepProgress : public SweepObserver {
 public:
  SweepProgress(Progress& progress, std::size_t points) : progress_(&progress), points_(points) {}
  void on_point(const SweepPoint& point) override;

 private:
  Progress* progress_;
  std::size_t points_;
  std::size_t shown_percent_ = 0;
};

}  // namespace sightline::cli
