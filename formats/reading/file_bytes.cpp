#include "formats/reading/file_bytes.h"

#include <algorithm>
#include <fstream>
#include <memory>
#include <span>

#include "geometry/numbers/errors.h"

namespace sightline::inline formats {

namespace {

std::string first_bytes(const ByteSource& source, std::size_t count) {
  std::string head(count, '\0');
  std::size_t size = 0;
  while (size < count) {
    const std::size_t added = source(std::span(head).subspan(size));
    if (added == 0) break;
    size += added;
  }
  head.resize(size);
  return head;
}

ByteSource put_before(const std::string& head, ByteSource rest) {
  return [head, rest = std::move(rest), used = std::size_t{0}](std::span<char> to) mutable {
    if (used == head.size()) return rest(to);
    const std::size_t count = std::min(to.size(), head.size() - used);
    std::copy_n(head.data() + used, count, to.data());
    used += count;
    return count;
  };
}

}  // namespace

ByteSource bytes_of(const std::filesystem::path& file) {
  std::error_code unused;
  if (std::filesystem::is_directory(file, unused))
    throw InputError(file.string(), 0, "is a directory, not a file of a mesh; name a file in it");
  const auto in = std::make_shared<std::ifstream>(file, std::ios::binary);
  if (!*in) throw InputError(file.string(), 0, "cannot be opened; check its name, and whether you may read it");
  return [in, name = file.string()](std::span<char> to) {
    in->read(to.data(), static_cast<std::streamsize>(to.size()));
    if (in->bad()) throw InputError(name, 0, "cannot be read to its end; copy it again");
    return static_cast<std::size_t>(in->gcount());
  };
}

OpenedFile open_file(const std::filesystem::path& file, std::size_t head_size) {
  OpenedFile opened;
  ByteSource source = bytes_of(file);
  opened.head = first_bytes(source, head_size);
  std::error_code error;
  if (std::filesystem::is_regular_file(file, error)) {
    const auto size = std::filesystem::file_size(file, error);
    if (!error) opened.size = size;
  }
  opened.bytes = put_before(opened.head, std::move(source));
  return opened;
}

}  // namespace sightline::inline formats
