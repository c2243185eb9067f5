#include "sim/files/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace nadir::sim {
namespace {

/// A name that no other writer uses: process and running number. Hidden, so that a glob over the
/// products never meets it.
std::filesystem::path temporary_beside(const std::filesystem::path& destination) {
  static std::atomic<unsigned> counter{0};
  const std::string name =
      fmt::format(".{}.{}-{}.tmp", destination.filename().string(), ::getpid(), counter++);
  return destination.parent_path() / name;
}

/// Makes the rename itself survive a power cut. Some file systems refuse to sync a folder, which
/// costs that guarantee but not the file, so the result is not checked.
void sync_folder_of(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path destination)
    : destination_{std::move(destination)}, temporary_{temporary_beside(destination_)} {
  // 0666 less the user's mask, as for any file that a program creates.
  descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail("create", errno);
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!committed_) ::unlink(temporary_.c_str());
}

void AtomicFile::fail(const char* action, int error) const {
  throw std::runtime_error("cannot " + std::string{action} + " " + destination_.string() + ": " +
                           std::generic_category().message(error));
}

void AtomicFile::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("write", errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    position_ += static_cast<std::uint64_t>(written);
  }
}

void AtomicFile::write(std::string_view text) { write(std::as_bytes(std::span{text})); }

void AtomicFile::seek(std::uint64_t position) {
  if (::lseek(descriptor_, static_cast<off_t>(position), SEEK_SET) < 0) fail("seek in", errno);
  position_ = position;
}

void AtomicFile::finish() {
  if (descriptor_ < 0) return;
  if (::fsync(descriptor_) < 0) fail("sync", errno);
  const int result = ::close(std::exchange(descriptor_, -1));
  if (result < 0) fail("close", errno);
}

void AtomicFile::commit() {
  finish();
  if (::rename(temporary_.c_str(), destination_.c_str()) < 0) fail("rename into place", errno);
  committed_ = true;
  sync_folder_of(destination_);
}

void write_file(const std::filesystem::path& destination, std::string_view text) {
  AtomicFile file{destination};
  file.write(text);
  file.commit();
}

}  // namespace nadir::sim
