// A ZIP archive in memory, its files as they are.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/tools/mesh_bytes.h"

namespace sightline::tests {

inline std::string stored_zip(const std::vector<std::pair<std::string, std::string>>& files) {
  std::string archive;
  std::string directory;
  for (const auto& [name, content] : files) {
    const auto checksum = static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size())));
    const auto size = static_cast<std::uint32_t>(content.size());
    const std::string common = raw(std::uint16_t{20}) + std::string(8, '\0') + raw(checksum) + raw(size) + raw(size) +
                               raw(static_cast<std::uint16_t>(name.size())) + std::string(2, '\0');
    directory += "PK\x01\x02" + raw(std::uint16_t{20}) + common + std::string(10, '\0') +
                 raw(static_cast<std::uint32_t>(archive.size())) + name;
    archive += "PK\x03\x04" + common + name + content;
  }
  const auto count = static_cast<std::uint16_t>(files.size());
  return archive + directory + "PK\x05\x06" + std::string(4, '\0') + raw(count) + raw(count) +
         raw(static_cast<std::uint32_t>(directory.size())) + raw(static_cast<std::uint32_t>(archive.size())) +
         std::string(2, '\0');
}

}  // namespace sightline::tests
