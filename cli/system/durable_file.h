// Files that are on the disk before anyone is told of them, and the errors of writing.
//
// Why: a rename may reach the disk before the bytes of the renamed file do; after a power cut the name would then stand
// for an empty file. And some file systems find out only here that they are full.
// Errors: OutputError, one line with the path and the cause.
#pragma once

#include <filesystem>
#include <string_view>
#include <utility>

#include "geometry/numbers/errors.h"

namespace sightline::cli {

class OutputError : public Error {
  using Error::Error;
};

// error: as in errno.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, int error);

// An open file or folder, closed at the end.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor();

  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool valid() const { return number_ >= 0; }

 private:
  int number_;
};

// A new, empty file.
[[nodiscard]] Descriptor create_file(const std::filesystem::path& path);

// path is for messages.
void write_all(const Descriptor& file, std::string_view content, const std::filesystem::path& path);

// Returns when what was written is on the disk.
void sync_file(const Descriptor& file, const std::filesystem::path& path);

// Returns when the names in the folder are on the disk, where the file system can do that.
void sync_folder(const std::filesystem::path& folder);

}  // namespace sightline::cli
