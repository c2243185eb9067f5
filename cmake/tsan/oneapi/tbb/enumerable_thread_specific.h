#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <thread>

namespace oneapi::tbb {

template <class Value>
class enumerable_thread_specific {
 public:
  Value& local() {
    const std::lock_guard lock{mutex_};
    auto& slot = values_[std::this_thread::get_id()];
    if (!slot) slot = std::make_unique<Value>();
    return *slot;
  }

 private:
  std::mutex mutex_;
  std::map<std::thread::id, std::unique_ptr<Value>> values_;
};

}  // namespace oneapi::tbb
namespace tbb = oneapi::tbb;
