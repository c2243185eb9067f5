#include "sim/files/data_directory.hpp"

#include <cstdlib>
#include <string>

#include "core/error.hpp"
#include "support/catch.hpp"

using nadir::sim::data_directory;

namespace {
/// Sets the variable for one test and puts it back.
class WithData {
 public:
  explicit WithData(const std::string& value) {
    if (const char* old = std::getenv("NADIR_DATA")) before_ = old;
    setenv("NADIR_DATA", value.c_str(), 1);
  }
  ~WithData() {
    if (before_.empty()) {
      unsetenv("NADIR_DATA");
    } else {
      setenv("NADIR_DATA", before_.c_str(), 1);
    }
  }
  WithData(const WithData&) = delete;
  WithData& operator=(const WithData&) = delete;

 private:
  std::string before_;
};
}  // namespace

TEST_CASE("a build in the tree finds the tree's data", "[files]") {
  const WithData unset{""};
  CHECK(data_directory() == std::filesystem::path{NADIR_SOURCE_DIR} / "scenes");
}

TEST_CASE("NADIR_DATA names the data's folder", "[files]") {
  const WithData set{NADIR_SOURCE_DIR "/docs/../tests"};
  CHECK(data_directory() == std::filesystem::path{NADIR_SOURCE_DIR} / "tests");
}

TEST_CASE("a folder in NADIR_DATA that does not exist is an error, not passed over", "[files]") {
  const WithData set{"/nowhere/at/all"};
  std::string message;
  try {
    static_cast<void>(data_directory());
  } catch (const nadir::InputError& error) {
    message = error.what();
  }
  CHECK(message ==
        "error: the environment's NADIR_DATA is \"/nowhere/at/all\", which is not a folder\n");
}
