#include "sim/files/atomic_file.hpp"

#include <sys/resource.h>

#include <csignal>
#include <stdexcept>

#include "message_of.hpp"
#include "scratch_folder.hpp"
#include "sim/files/hash.hpp"
#include "support/catch.hpp"

using namespace nadir::sim;
using support::content_of;
using support::message_of;
using support::ScratchFolder;

TEST_CASE("a file appears only when it is committed", "[sim][files]") {
  const ScratchFolder folder;
  const auto file = folder / "image.img";
  {
    AtomicFile target{file};
    target.write("half of ");
    CHECK_FALSE(std::filesystem::exists(file));
    CHECK(folder.entries() == 1);  // the temporary lies beside it, so that a rename suffices
    target.write("the text");
    target.commit();
    CHECK(content_of(file) == "half of the text");
  }
  CHECK(folder.entries() == 1);
}

TEST_CASE("a file that is given up leaves the old one and no temporary", "[sim][files]") {
  const ScratchFolder folder;
  const auto file = folder / "image.img";
  write_file(file, "old");
  {
    AtomicFile target{file};
    target.write("new");
  }
  CHECK(content_of(file) == "old");
  CHECK(folder.entries() == 1);
}

TEST_CASE("an atomic file can go back and fill in what was left open", "[sim][files]") {
  const ScratchFolder folder;
  AtomicFile target{folder / "file"};
  target.write("....5678");
  CHECK(target.position() == 8);
  target.seek(0);
  target.write("1234");
  CHECK(target.position() == 4);
  target.commit();
  CHECK(content_of(folder / "file") == "12345678");
}

TEST_CASE("a file that cannot be made says why in the system's words", "[sim][files]") {
  const ScratchFolder folder;
  const auto file = folder / "missing" / "image.img";
  CHECK_THROWS_WITH(AtomicFile{file},
                    "cannot create " + file.string() + ": No such file or directory");
}

TEST_CASE("a commit that fails removes the temporary", "[sim][files]") {
  const ScratchFolder folder;
  const auto file = folder / "taken";
  std::filesystem::create_directories(file / "inside");  // a file cannot replace a folder
  CHECK_THROWS_WITH(write_file(file, "text"),
                    "cannot rename into place " + file.string() + ": Is a directory");
  CHECK(folder.entries() == 1);
}

// The system's limit on a file's size stands in for a full disc: it too takes part of the bytes
// and refuses the rest.
TEST_CASE("a write that the system refuses is an error and leaves nothing", "[sim][files]") {
  const ScratchFolder folder;
  rlimit before{};
  REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{4, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string message = message_of([&] { write_file(folder / "file", "12345678"); });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);

  CHECK(message == "cannot write " + (folder / "file").string() + ": File too large");
  CHECK(folder.entries() == 0);
}

// NIST, "Example values: SHA-256" (FIPS 180-4): one block, two blocks, and the empty message.
TEST_CASE("SHA-256 gives the published values", "[sim][files]") {
  CHECK(digest_bytes("abc").sha256 ==
        "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(digest_bytes("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq").sha256 ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(digest_bytes("").sha256 ==
        "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST_CASE("a file has the digest of its bytes", "[sim][files]") {
  const ScratchFolder folder;
  const std::string text(200'000, 'x');  // more than one block of the reader
  write_file(folder / "file", text);
  const FileDigest digest = digest_file(folder / "file");
  CHECK(digest.bytes == text.size());
  CHECK(digest.sha256 == digest_bytes(text).sha256);
  CHECK_THROWS_AS(digest_file(folder / "missing"), std::runtime_error);
  CHECK_THROWS_AS(digest_file(folder.path()), std::runtime_error);
}
