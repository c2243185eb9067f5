#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/run/tile_store.hpp"

namespace nadir::sim {

/// What a frame of a journal holds.
enum class FrameKind : std::uint32_t {
  header = 1,    ///< whose samples these are; the first frame
  names = 2,     ///< a list of names; its number stands for the round
  tile = 3,      ///< a finished tile
  begun = 4,     ///< nothing but a number of rounds, in its key: a run is to make that many
  finished = 5,  ///< likewise: a run has made that many
};

/// Where a frame lies in the file, and what it says outside.
struct Frame {
  FrameKind kind{};
  TileKey key{};
  std::uint64_t offset = 0;  ///< of its content
  std::uint32_t stored = 0;  ///< bytes of the content in the file
  std::uint32_t length = 0;  ///< of the content; more than `stored`: deflated
  std::uint32_t sum = 0;     ///< over everything of the frame
};

/// What was found in a file.
struct JournalScan {
  std::vector<Frame> frames;  ///< the whole ones, in their order
  std::uint64_t end = 0;      ///< behind the last whole one; 0: not a journal of this format
  std::uint64_t size = 0;     ///< of the file
  std::uint64_t damaged = 0;  ///< bytes before `end` that belong to no whole frame
  [[nodiscard]] std::uint64_t torn() const { return size - end; }  ///< bytes behind it
};

/// A file of frames that only grows. Each has a checksum, and is found again behind a damaged one.
/// One process at a time may write. Reading is thread-safe, writing is not.
class JournalFile {
 public:
  enum class Access { read, write };
  /// Opens the file; to write, it is made where it is missing.
  /// @throws InputError where another process has it; std::runtime_error where it cannot be opened
  JournalFile(std::filesystem::path file, Access access);
  ~JournalFile();
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;

  /// Looks for frames from the file's start.
  [[nodiscard]] JournalScan scan() const;
  /// The content of a frame; nothing where it is no longer what was written.
  [[nodiscard]] std::optional<std::string> read(const Frame& frame) const;

  /// Empties the file and gives it its first frame.
  void start_anew(std::string_view frame);
  /// Cuts off what stands behind the last whole frame.
  void cut_at(std::uint64_t end);
  /// Adds a frame that `frame_bytes` made, with one write; after this returns it survives the
  /// process.
  Frame append(std::string_view frame);
  /// Makes all that was written survive a power cut.
  void sync() const;
  /// Gives the file another name.
  void rename(const std::filesystem::path& name);

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  [[nodiscard]] std::uint64_t size() const noexcept { return end_; }

 private:
  [[noreturn]] void fail(const char* action, int error) const;
  void write_at_end(std::string_view bytes);

  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uint64_t end_ = 0;
};

/// A frame as it is written: made apart from the file, so that threads deflate at once.
[[nodiscard]] std::string frame_bytes(FrameKind kind, const TileKey& key, std::string_view content);

}  // namespace nadir::sim
