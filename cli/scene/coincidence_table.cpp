#include "cli/scene/coincidence_table.h"

namespace sightline::cli {

void read_coincidence(const TomlReader& table, ReflectionOptions& options) {
  table.allow_only({"distance", "policy"});
  options.coincidence = table.optional_number("distance").value_or(options.coincidence);
  if (!(options.coincidence >= 0 && options.coincidence < 1))
    table.fail("distance", "'distance' must be at least 0 and below 1: it is a share of the surface's size");
  if (!table.has("policy")) return;
  const std::string policy = table.text("policy");
  if (policy != "exact" && policy != "snap") table.fail("policy", "'policy' must be \"exact\" or \"snap\"");
  options.snaps = policy == "snap";
}

}  // namespace sightline::cli
