#include "cli/pages/page_template.h"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <new>

#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

constexpr std::string_view place_of_data = "@DATA@";

constexpr int gzip_window_bits = 15 + 16;  // the largest window, and the header and trailer of gzip
constexpr int usual_memory_level = 8;
constexpr std::size_t chunk_bytes = std::size_t{1} << 16;

class Deflater {
 public:
  explicit Deflater(std::string_view bytes) {
    if (deflateInit2(&stream_, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzip_window_bits, usual_memory_level,
                     Z_DEFAULT_STRATEGY) != Z_OK) {
      throw std::bad_alloc();
    }
    rest_ = bytes;
  }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;
  ~Deflater() { deflateEnd(&stream_); }

  // Appends up to a chunk; false when that was the last one.
  bool append_chunk(std::string& out) {
    const std::size_t begin = out.size();
    out.resize(begin + chunk_bytes);
    stream_.next_out = reinterpret_cast<Bytef*>(out.data() + begin);
    stream_.avail_out = static_cast<uInt>(chunk_bytes);
    feed();
    const int state = deflate(&stream_, rest_.empty() ? Z_FINISH : Z_NO_FLUSH);
    if (state != Z_OK && state != Z_STREAM_END && state != Z_BUF_ERROR) throw InternalError("zlib does not compress");
    out.resize(out.size() - stream_.avail_out);
    return state != Z_STREAM_END;
  }

 private:
  // zlib counts in 32 bits.
  void feed() {
    if (stream_.avail_in > 0 || rest_.empty()) return;
    const std::size_t count = std::min(rest_.size(), std::size_t{std::numeric_limits<uInt>::max()});
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(rest_.data()));
    stream_.avail_in = static_cast<uInt>(count);
    rest_.remove_prefix(count);
  }

  z_stream stream_{};
  std::string_view rest_;  // what zlib has not been given
};

constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

// The four digits of up to three bytes; those that none of them reaches are '='.
void append_group(std::string& out, std::string_view bytes) {
  unsigned long bits = 0;
  for (std::size_t i = 0; i < 3; ++i)
    bits = bits << 8U | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U);
  for (std::size_t i = 0; i < 4; ++i) out += i <= bytes.size() ? digits[bits >> (18 - 6 * i) & 63U] : '=';
}

}  // namespace

void require_page(PageName page) {
  if (!page_pieces(page).empty()) return;
  throw PageError(
      "this sightline was built without its pages; install nodejs and npm, and build it again with the network at "
      "hand");
}

std::string page_with_data(PageName page, std::string_view packed_data) {
  require_page(page);
  std::string text;
  for (const char* const piece : page_pieces(page)) text += piece;
  const std::size_t place = text.find(place_of_data);
  if (place == std::string::npos) throw InternalError("the page has no place for its data");
  text.replace(place, place_of_data.size(), packed_data);
  return text;
}

std::string gzip(std::string_view bytes) {
  Deflater deflater(bytes);
  std::string out;
  while (deflater.append_chunk(out)) {
  }
  return out;
}

std::string base64(std::string_view bytes) {
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) append_group(out, bytes.substr(i, 3));
  return out;
}

std::string packed(std::string_view bytes) { return base64(gzip(bytes)); }

}  // namespace sightline::cli
