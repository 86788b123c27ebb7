#include "cli/output_file.h"

#include <unistd.h>

#include <filesystem>

#include "cli/durable_file.h"

namespace sightline {

namespace {

void put_in_place(const std::filesystem::path& fresh, std::string_view content, const std::filesystem::path& place) {
  write_durably(create_file(fresh), content, place);
  std::error_code error;
  std::filesystem::rename(fresh, place, error);
  if (error) fail_to_write(place, error.value());
}

}  // namespace

void write_output_file(const std::string& path, std::string_view content) {
  const std::filesystem::path place(path);
  std::filesystem::path fresh = place;
  fresh += ".partial-" + std::to_string(getpid());
  try {
    put_in_place(fresh, content, place);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(fresh, ignored);
    throw;
  }
}

}  // namespace sightline
