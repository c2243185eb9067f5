#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

namespace nadir::sim {

/// A file that appears under its name only when it is whole: bytes go to a temporary file in the
/// same folder, which `commit` syncs to the disc and renames. Without `commit` the destructor
/// removes the temporary, and a file that stood under the name before stays as it was.
class AtomicFile {
 public:
  /// Creates the temporary. @throws std::runtime_error with the system's reason.
  explicit AtomicFile(std::filesystem::path destination);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Writes at the current position. @throws std::runtime_error with the system's reason.
  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);
  /// Bytes from the file's start where the next write goes.
  [[nodiscard]] std::uint64_t position() const noexcept { return position_; }
  void seek(std::uint64_t position);

  /// Syncs and closes the temporary; after this only `commit` may follow. Lets several files be
  /// made safe before the first of them takes its name.
  void finish();
  /// Gives the file its name (and finishes it first where that was not done).
  void commit();

  [[nodiscard]] const std::filesystem::path& destination() const noexcept { return destination_; }

 private:
  [[noreturn]] void fail(const char* action, int error) const;

  std::filesystem::path destination_, temporary_;
  int descriptor_ = -1;
  std::uint64_t position_ = 0;
  bool committed_ = false;
};

/// The whole of a small file in one call.
void write_file(const std::filesystem::path& destination, std::string_view text);

}  // namespace nadir::sim
