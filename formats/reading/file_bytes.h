// A file is opened here, and its first bytes are looked at before somebody reads them.
//
// Holds: the bytes are read once and in order, so that a pipe will do.
// Errors: InputError if the file cannot be opened, is a directory, or cannot be read to its end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "formats/reading/obj_scanner.h"

namespace sightline::inline formats {

[[nodiscard]] ByteSource bytes_of(const std::filesystem::path& file);

struct OpenedFile {
  std::string head;                   // its first bytes, at most so many as were asked for
  std::optional<std::uint64_t> size;  // of a regular file
  ByteSource bytes;                   // all of them, the head included
};
[[nodiscard]] OpenedFile open_file(const std::filesystem::path& file, std::size_t head_size);

}  // namespace sightline::inline formats
