#pragma once

#include <fstream>
#include <string>

#include "sim/message_of.hpp"
#include "sim/run/load_platform.hpp"
#include "sim/scratch_folder.hpp"

namespace nadir::sim::support {

/// A scenario without anything but a platform, and a folder for its files.
class PlatformLoading {
 public:
  PlatformLoading() {
    scenario_.time = ephemeris::Instant::parse_utc("2026-06-21T16:00:00Z");
    scenario_.origin = {36.0, -84.0, 300.0};
    PlatformInput& platform = scenario_.platform;
    platform.where = {"a.xml", 14, 3};
    platform.position_where = {"a.xml", 15, 15};
    platform.attitude_where = {"a.xml", 16, 15};
    platform.position = Vec3{0.0, 0.0, 1000.0};
    platform.attitude = EulerInput{0.0, -90.0, 0.0};
  }

  std::filesystem::path text(const std::string& name, const std::string& content) const {
    std::ofstream{scratch_ / name, std::ios::binary} << content;
    return scratch_ / name;
  }
  PlatformInput& platform() { return scenario_.platform; }
  Scenario& scenario() { return scenario_; }
  [[nodiscard]] geometry::LocalFrame frame() const {
    return geometry::LocalFrame{scenario_.origin};
  }

  sensor::Platform load(sensor::TimeSpan span = {}, const TerrainProbe& terrain = {}) {
    return load_platform(scenario_, frame(), terrain, files_, span);
  }
  sensor::PlatformDescription describe(sensor::TimeSpan span = {}) {
    return describe_platform(scenario_, frame(), {}, files_, span);
  }
  /// What is wrong with it, without the scratch folder's path.
  std::string message(sensor::TimeSpan span = {}, const TerrainProbe& terrain = {}) {
    std::string all = message_of([&] { (void)load(span, terrain); });
    const std::string folder = scratch_.path().string() + "/";
    for (std::size_t at = all.find(folder); at != std::string::npos; at = all.find(folder)) {
      all.erase(at, folder.size());
    }
    return all;
  }
  [[nodiscard]] const InputFiles& files() const { return files_; }

 private:
  ScratchFolder scratch_;
  Scenario scenario_;
  InputFiles files_;
};

}  // namespace nadir::sim::support
