#include "sim/run/journal_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "sim/files/packed_bytes.hpp"

namespace nadir::sim {
namespace {

// The last two bytes are the format's version, so that another version's file is not one of ours.
constexpr std::string_view journal_magic{"NADIR-SAMPLES\n\1\0", 16};
// Text as a user may not have it in a name, so that it seldom stands for anything else.
constexpr std::string_view frame_mark{"\nTILE\0\xF0\x0D", 8};

/// What stands before a frame's content, behind the mark.
struct FrameHead {
  std::uint32_t kind = 0;
  std::uint32_t round = 0, array = 0;
  std::int32_t first_sample = 0, first_line = 0, samples = 0, lines = 0;
  std::uint32_t stored = 0, length = 0;
  std::uint32_t sum = 0;  ///< over all before this and the content
};
static_assert(sizeof(FrameHead) == 40);
constexpr std::size_t head_bytes = frame_mark.size() + sizeof(FrameHead);

std::string_view bytes_before_sum(const FrameHead& head) {
  return {reinterpret_cast<const char*>(&head), sizeof head - sizeof head.sum};
}

Frame frame_of(const FrameHead& head, std::uint64_t content_offset) {
  return {static_cast<FrameKind>(head.kind),
          {head.round, head.array, head.first_sample, head.first_line, head.samples, head.lines},
          content_offset,
          head.stored,
          head.length,
          head.sum};
}

FrameHead head_of(const Frame& frame) {
  const TileKey& key = frame.key;
  return {static_cast<std::uint32_t>(frame.kind),
          key.round,
          key.array,
          key.first_sample,
          key.first_line,
          key.samples,
          key.lines,
          frame.stored,
          frame.length,
          frame.sum};
}

std::uint32_t sum_of(const FrameHead& head, std::string_view content) {
  return checksum(content, checksum(bytes_before_sum(head)));
}

/// The whole frame that begins at a place of the file; nothing where none does.
std::optional<Frame> frame_at(std::string_view file, std::uint64_t offset) {
  const std::string_view rest = file.substr(offset);
  if (rest.size() < head_bytes || !rest.starts_with(frame_mark)) return std::nullopt;
  FrameHead head;
  std::memcpy(&head, rest.data() + frame_mark.size(), sizeof head);
  if (head.stored > rest.size() - head_bytes) return std::nullopt;
  if (sum_of(head, rest.substr(head_bytes, head.stored)) != head.sum) return std::nullopt;
  return frame_of(head, offset + head_bytes);
}

JournalScan scan_bytes(std::string_view file) {
  JournalScan found;
  found.size = file.size();
  if (!file.starts_with(journal_magic)) return found;
  found.end = journal_magic.size();
  for (std::size_t at = found.end; at < file.size();) {
    if (const auto frame = frame_at(file, at)) {
      found.damaged += at - found.end;
      found.frames.push_back(*frame);
      at = found.end = frame->offset + frame->stored;
    } else {
      at = file.find(frame_mark, at + 1);  // npos: none
    }
  }
  return found;
}

/// A file's bytes while it lives.
class Mapping {
 public:
  Mapping(int descriptor, std::size_t size) : size_{size} {
    if (size_ == 0) return;
    data_ = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, descriptor, 0);
    if (data_ == MAP_FAILED) size_ = 0;
  }
  ~Mapping() {
    if (size_ > 0) ::munmap(data_, size_);
  }
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;
  [[nodiscard]] std::string_view bytes() const { return {static_cast<const char*>(data_), size_}; }

 private:
  void* data_ = nullptr;
  std::size_t size_;
};

}  // namespace

JournalFile::JournalFile(std::filesystem::path file, Access access) : path_{std::move(file)} {
  const bool writes = access == Access::write;
  descriptor_ = ::open(path_.c_str(), writes ? O_RDWR | O_CREAT | O_CLOEXEC : O_RDONLY | O_CLOEXEC,
                       0666);  // less the user's mask
  if (descriptor_ < 0) fail("open", errno);
  if (::flock(descriptor_, (writes ? LOCK_EX : LOCK_SH) | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(descriptor_);
    throw InputError{InputIssue{{path_.string(), 0, 0},
                                "another run is at work in this folder",
                                "wait for its end, or name another folder with --output",
                                {}}};
  }
  struct stat status {};
  if (::fstat(descriptor_, &status) == 0) end_ = static_cast<std::uint64_t>(status.st_size);
}

JournalFile::~JournalFile() { ::close(descriptor_); }

void JournalFile::fail(const char* action, int error) const {
  throw std::runtime_error("cannot " + std::string{action} + " " + path_.string() + ": " +
                           std::generic_category().message(error));
}

JournalScan JournalFile::scan() const {
  const Mapping mapping{descriptor_, static_cast<std::size_t>(end_)};
  if (mapping.bytes().size() != end_) fail("read", errno);
  return scan_bytes(mapping.bytes());
}

std::optional<std::string> JournalFile::read(const Frame& frame) const {
  std::string content(frame.stored, '\0');
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t got = ::pread(descriptor_, content.data() + done, content.size() - done,
                                static_cast<off_t>(frame.offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return std::nullopt;
    done += static_cast<std::size_t>(got);
  }
  if (sum_of(head_of(frame), content) != frame.sum) return std::nullopt;
  if (frame.length == frame.stored) return content;
  return unpack_bytes(content, frame.length);
}

void JournalFile::cut_at(std::uint64_t end) {
  if (::ftruncate(descriptor_, static_cast<off_t>(end)) != 0) fail("cut", errno);
  end_ = end;
}

void JournalFile::start_anew(std::string_view frame) {
  cut_at(0);
  std::string bytes{journal_magic};
  bytes += frame;
  write_at_end(bytes);
}

void JournalFile::write_at_end(std::string_view bytes) {
  std::uint64_t at = end_;
  while (!bytes.empty()) {
    const ssize_t written =
        ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (written < 0 && errno == EINTR) continue;
    // What was written of it is overwritten by the next, or cut off when the file is opened.
    if (written < 0) fail("write", errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
    at += static_cast<std::uint64_t>(written);
  }
  end_ = at;
}

Frame JournalFile::append(std::string_view frame) {
  FrameHead head;
  std::memcpy(&head, frame.data() + frame_mark.size(), sizeof head);
  const std::uint64_t content = end_ + head_bytes;
  write_at_end(frame);
  return frame_of(head, content);
}

void JournalFile::sync() const { static_cast<void>(::fdatasync(descriptor_)); }

void JournalFile::rename(const std::filesystem::path& name) {
  std::filesystem::rename(path_, name);
  path_ = name;
}

std::string frame_bytes(FrameKind kind, const TileKey& key, std::string_view content) {
  if (content.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw std::length_error{"a tile of more than 4 GB"};
  }
  const auto packed = pack_bytes(content);
  const std::string_view stored = packed ? std::string_view{*packed} : content;
  FrameHead head = head_of({kind, key, 0, static_cast<std::uint32_t>(stored.size()),
                            static_cast<std::uint32_t>(content.size()), 0});
  head.sum = sum_of(head, stored);
  std::string bytes{frame_mark};
  bytes.append(reinterpret_cast<const char*>(&head), sizeof head);
  bytes += stored;
  return bytes;
}

}  // namespace nadir::sim
