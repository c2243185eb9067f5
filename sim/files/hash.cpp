#include "sim/files/hash.hpp"

#include <openssl/evp.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <system_error>

namespace nadir::sim {
namespace {

class Sha256 {
 public:
  Sha256() : context_{EVP_MD_CTX_new(), EVP_MD_CTX_free} {
    check(context_ && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
  }
  void add(std::string_view bytes) {
    check(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()) == 1);
    count_ += bytes.size();
  }
  FileDigest result() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned length = 0;
    check(EVP_DigestFinal_ex(context_.get(), digest.data(), &length) == 1);
    std::string text;
    for (unsigned i = 0; i < length; ++i) {
      text += "0123456789abcdef"[digest[i] >> 4];
      text += "0123456789abcdef"[digest[i] & 15];
    }
    return {text, count_};
  }

 private:
  static void check(bool fine) {
    if (!fine) throw std::runtime_error("the OpenSSL library cannot compute SHA-256");
  }
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
  std::uint64_t count_ = 0;
};

[[noreturn]] void cannot_read(const std::filesystem::path& file, int error) {
  throw std::runtime_error("cannot read " + file.string() + ": " +
                           std::generic_category().message(error));
}

}  // namespace

FileDigest digest_file(const std::filesystem::path& file) {
  errno = 0;
  std::ifstream stream{file, std::ios::binary};
  if (!stream) cannot_read(file, errno);
  Sha256 hash;
  std::string block(1 << 16, '\0');
  while (stream) {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    hash.add(std::string_view{block}.substr(0, static_cast<std::size_t>(stream.gcount())));
  }
  if (stream.bad() || !stream.eof()) cannot_read(file, errno);
  return hash.result();
}

FileDigest digest_bytes(std::string_view bytes) {
  Sha256 hash;
  hash.add(bytes);
  return hash.result();
}

}  // namespace nadir::sim
