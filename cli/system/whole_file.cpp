#include "cli/system/whole_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "geometry/numbers/errors.h"

namespace sightline::cli {

std::string whole_file(const std::string& path, const std::string& what) {
  const auto unreadable = [&](int cause) {
    return InputError(path, 0, fmt::format("{} cannot be read: {}; name one that can be", what, std::strerror(cause)));
  };
  std::error_code none;
  if (std::filesystem::is_directory(path, none)) throw unreadable(EISDIR);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw unreadable(errno);
  std::string text;
  for (std::string chunk(1 << 16, '\0'); file.read(chunk.data(), 1 << 16), file.gcount() > 0;) {
    text.append(chunk, 0, static_cast<std::size_t>(file.gcount()));
    if (text.size() > longest_text_file)
      throw InputError(path, 0, fmt::format("{} has more than {} bytes; divide it", what, longest_text_file));
  }
  if (file.bad()) throw unreadable(EIO);
  return text;
}

}  // namespace sightline::cli
