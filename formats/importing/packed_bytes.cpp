#include "formats/importing/packed_bytes.h"

// What is inflated is not written to.
#define ZLIB_CONST
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <vector>

#include "formats/reading/input_bytes.h"
#include "formats/reading/printable.h"

namespace sightline::inline formats {

namespace {

std::optional<unsigned> value_of_base64(char c) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t place = letters.find(c);
  if (place == std::string_view::npos) return std::nullopt;
  return static_cast<unsigned>(place);
}

std::uint64_t number_at(std::string_view bytes, std::size_t place, std::size_t size) {
  if (place > bytes.size() || size > bytes.size() - place) throw std::runtime_error("the archive ends too soon");
  if (size == 2) return unsigned_of<std::uint16_t>(bytes.substr(place, 2), std::endian::little);
  return unsigned_of<std::uint32_t>(bytes.substr(place, 4), std::endian::little);
}

// Returns where the record is that ends the directory: the last one, before a comment of up to 65 535 bytes.
std::size_t end_record(std::string_view archive) {
  constexpr std::size_t record_size = 22;
  constexpr std::size_t longest_comment = 65535;
  const std::size_t from = archive.size() - std::min(archive.size(), record_size + longest_comment);
  const std::size_t place = archive.substr(from).rfind("PK\x05\x06");
  if (place == std::string_view::npos || archive.size() - from - place < record_size)
    throw std::runtime_error("the archive has no directory at its end");
  return from + place;
}

// A file as the directory describes it.
struct PackedFile {
  std::uint64_t flags = 0;
  std::uint64_t method = 0;
  std::uint64_t checksum = 0;
  std::uint64_t packed_size = 0;
  std::uint64_t size = 0;
  std::uint64_t place = 0;  // of its own header
};

PackedFile packed_file_at(std::string_view archive, std::size_t entry) {
  const auto field = [&](std::size_t place, std::size_t size) { return number_at(archive, entry + place, size); };
  return {field(8, 2), field(10, 2), field(16, 4), field(20, 4), field(24, 4), field(42, 4)};
}

PackedFile find_file(std::string_view archive, std::string_view name) {
  const std::size_t end = end_record(archive);
  const std::uint64_t count = number_at(archive, end + 10, 2);
  std::size_t entry = number_at(archive, end + 16, 4);
  for (std::uint64_t i = 0; i < count; ++i) {
    if (number_at(archive, entry, 4) != 0x02014b50) throw std::runtime_error("the archive's directory is damaged");
    const std::uint64_t name_size = number_at(archive, entry + 28, 2);
    if (archive.substr(entry + 46).substr(0, name_size) == name) return packed_file_at(archive, entry);
    entry += 46 + name_size + number_at(archive, entry + 30, 2) + number_at(archive, entry + 32, 2);
  }
  throw std::runtime_error("the archive has no file " + printable(name));
}

std::string_view packed_bytes_of(std::string_view archive, const PackedFile& file) {
  if ((file.flags & 1U) != 0) throw std::runtime_error("the archive needs a password");
  if (file.packed_size == 0xFFFFFFFF || file.size == 0xFFFFFFFF) throw std::runtime_error("the archive is ZIP64");
  if (number_at(archive, file.place, 4) != 0x04034b50) throw std::runtime_error("the archive is damaged");
  const std::uint64_t start =
      file.place + 30 + number_at(archive, file.place + 26, 2) + number_at(archive, file.place + 28, 2);
  if (start > archive.size() || file.packed_size > archive.size() - start)
    throw std::runtime_error("the archive ends too soon");
  return archive.substr(start, file.packed_size);
}

// What inflates a stream, and lets go of its memory.
class Inflater {
 public:
  explicit Inflater(std::string_view packed) {
    stream_.next_in = reinterpret_cast<const Bytef*>(packed.data());
    stream_.avail_in = static_cast<uInt>(packed.size());
    if (inflateInit2(&stream_, -MAX_WBITS) != Z_OK) throw std::bad_alloc();
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() { inflateEnd(&stream_); }

  // Returns the next portion, empty at the end.
  std::string_view next() {
    if (at_end_) return {};
    stream_.next_out = reinterpret_cast<Bytef*>(portion_.data());
    stream_.avail_out = static_cast<uInt>(portion_.size());
    const int result = inflate(&stream_, Z_NO_FLUSH);
    at_end_ = result == Z_STREAM_END;
    const std::size_t size = portion_.size() - stream_.avail_out;
    if (result != Z_OK && !at_end_) throw std::runtime_error("the archive is damaged");
    if (size == 0 && !at_end_) throw std::runtime_error("the archive is damaged");
    return {portion_.data(), size};
  }

 private:
  z_stream stream_{};
  std::vector<char> portion_ = std::vector<char>(std::size_t{1} << 16);
  bool at_end_ = false;
};

class Checked {
 public:
  explicit Checked(const std::function<bool(std::string_view)>& take) : take_(take) {}
  bool take(std::string_view portion) {
    checksum_ = crc32(checksum_, reinterpret_cast<const Bytef*>(portion.data()), static_cast<uInt>(portion.size()));
    size_ += portion.size();
    return take_(portion);
  }
  void require(const PackedFile& file) const {
    if (checksum_ != file.checksum || size_ != file.size)
      throw std::runtime_error("a file of the archive is damaged: its checksum is another");
  }

 private:
  const std::function<bool(std::string_view)>& take_;
  uLong checksum_ = crc32(0, nullptr, 0);
  std::uint64_t size_ = 0;
};

}  // namespace

std::optional<std::string> from_base64(std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const auto value = value_of_base64(c);
    if (!value) return std::nullopt;
    bits = bits << 6 | *value;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xFF);
  }
  if (count >= 6) return std::nullopt;
  return bytes;
}

void unpack(std::string_view archive, std::string_view file, const std::function<bool(std::string_view)>& take) {
  const PackedFile found = find_file(archive, file);
  const std::string_view packed = packed_bytes_of(archive, found);
  if (found.method != 0 && found.method != 8)
    throw std::runtime_error("the archive is compressed by method " + std::to_string(found.method));
  Checked checked(take);
  if (found.method == 0) {
    if (!checked.take(packed)) return;
  } else {
    Inflater inflater(packed);
    for (auto portion = inflater.next(); !portion.empty(); portion = inflater.next()) {
      if (!checked.take(portion)) return;
    }
  }
  checked.require(found);
}

}  // namespace sightline::inline formats
