#include "formats/importing/whole_file.h"

#include <span>

#include "formats/reading/file_bytes.h"
#include "geometry/numbers/errors.h"

namespace sightline::inline formats {

std::string whole_file(const std::filesystem::path& file, const ReadLimits& limits) {
  const ByteSource source = bytes_of(file);
  std::string bytes;
  std::string portion(std::size_t{1} << 20, '\0');
  for (std::size_t size = source(portion); size > 0; size = source(portion)) {
    if (bytes.size() + size > limits.memory)
      throw InputError(file.string(), 0,
                       "the file is larger than the limit on memory, " + std::to_string(limits.memory) +
                           " bytes; raise it with --max-memory");
    bytes.append(portion, 0, size);
  }
  return bytes;
}

}  // namespace sightline::inline formats
