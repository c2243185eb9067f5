#include "core/diagnostics.hpp"

#include <algorithm>
#include <thread>

#include "support/catch.hpp"

using namespace nadir;

TEST_CASE("warnings are kept in order, repeated ones once", "[core][diagnostics]") {
  Diagnostics d;
  CHECK(d.messages().empty());
  d.warn("first");
  d.warn("second");
  d.warn("first");
  CHECK(d.messages() == std::vector<std::string>{"first", "second"});
}

TEST_CASE("threads may warn at the same time", "[core][diagnostics]") {
  Diagnostics d;
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t) {
      threads.emplace_back([&d, t] {
        for (int i = 0; i < 50; ++i) d.warn(std::to_string((i + t) % 50));
      });
    }
  }
  const auto messages = d.messages();
  CHECK(messages.size() == 50);
  CHECK(std::count(messages.begin(), messages.end(), "17") == 1);
}
