#include "cli/system/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace sightline::cli {

namespace {

constexpr const char* erase_line = "\r\033[K";

}  // namespace

bool Progress::watched() { return isatty(STDERR_FILENO) == 1; }

void Progress::stage(const std::string& text) {
  stage_ = text;
  write(stage_ + " ...");
}

void Progress::percent(std::size_t percent) { write(fmt::format("{} ... {} %", stage_, percent)); }

void Progress::clear() { write(""); }

void Progress::write(const std::string& line) const {
  if (!shown_) return;
  fmt::print(stderr, "{}{}", erase_line, line);
  std::fflush(stderr);
}

void SweepProgress::on_point(const SweepPoint& point) {
  const std::size_t percent = points_ == 0 ? 100 : 100 * point.points_done / points_;
  if (percent == shown_percent_) return;
  shown_percent_ = percent;
  progress_->percent(percent);
}

}  // namespace sightline::cli
