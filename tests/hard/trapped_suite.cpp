// Every test case of the suite runs with floating-point traps: a NaN or infinity that arithmetic
// makes ends the case by SIGFPE, whoever would have swallowed it later. Catch2 names the case.
#define CATCH_CONFIG_EXTERNAL_INTERFACES  // listeners, in Catch2 2
#include <oneapi/tbb/global_control.h>

#include <optional>

#include "support/catch.hpp"
#include "support/floating_point_traps.hpp"

namespace nadir::support {
namespace {

#if defined(CATCH_VERSION_MAJOR) && CATCH_VERSION_MAJOR >= 3
using ListenerBase = Catch::EventListenerBase;
#else
using ListenerBase = Catch::TestEventListenerBase;
#endif

class TrapListener : public ListenerBase {
 public:
  using ListenerBase::ListenerBase;

  void testCaseStarting(const Catch::TestCaseInfo& info) override {
    ListenerBase::testCaseStarting(info);
    if (!traps_are_honest()) return;
    // One thread: a task of Embree's own would trap in a worker that began as one of ours.
    using Control = oneapi::tbb::global_control;
    one_thread_.emplace(Control::max_allowed_parallelism, std::size_t{1});
    print_where_it_trapped();
    trap_floating_point();
  }
  void testCaseEnded(const Catch::TestCaseStats& stats) override {
    ignore_floating_point();
    one_thread_.reset();
    ListenerBase::testCaseEnded(stats);
  }

 private:
  std::optional<oneapi::tbb::global_control> one_thread_;
};

CATCH_REGISTER_LISTENER(TrapListener)

}  // namespace
}  // namespace nadir::support
