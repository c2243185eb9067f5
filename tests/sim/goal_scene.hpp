#pragma once

#include <cstddef>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "sim/run/render.hpp"
#include "sim/run/tile_store.hpp"
#include "sim/run/world.hpp"
#include "sim/scenario/read_scenario.hpp"
#include "sim/scratch_folder.hpp"

namespace nadir::sim::test {

/// A grey plain at 300 K under a cold sky in a thermal band, with a sphere beside it that the
/// camera does not see: what the plain reflects of it is found by chance.
struct PlainScene {
  double sphere_k = 600.0;
  double radius_m = 20.0, distance_m = 60.0;
  int samples = 20, lines = 12;
};

inline World plain_world(const PlainScene& plain, const support::ScratchFolder& folder) {
  const auto number = [](auto value) { return std::to_string(value); };
  const auto file = folder / "plain.xml";
  std::ofstream{file} << R"(<scenario name="plain">
  <time utc="2026-06-21T16:00:00Z"/>
  <site latitude_deg="36.4" longitude_deg="-84.2" height_m="300"/>
  <illumination><fixed/></illumination><atmosphere><none/></atmosphere>
  <solver method="path"/>
  <materials default_temperature_k="300">
    <material name="ground" reflectance="0.4"/>
    <material name="hot" emissivity="1" temperature_k=")"
                      << number(plain.sphere_k) << R"("/></materials>
  <geometry><plane material="ground" size_x_m="1000" size_y_m="1000"/>
    <sphere material="hot" radius_m=")"
                      << number(plain.radius_m) << R"(" east_m=")" << number(plain.distance_m)
                      << R"(" up_m=")" << number(plain.radius_m) << R"("/></geometry>
  <platform>
    <position><local east_m="0" north_m="0" up_m="500"/></position>
    <attitude><euler yaw_deg="0" pitch_deg="-90"/></attitude>
  </platform>
  <camera><orthographic><array name="a" samples=")"
                      << plain.samples << R"(" lines=")" << plain.lines
                      << R"(" ground_pitch_m="1"><band_box name="t" lo_um="10" hi_um="11"/>
  </array></orthographic></camera>
</scenario>)";
  Diagnostics diagnostics;
  InputFiles files;
  return load_world(read_scenario(file, diagnostics), files, diagnostics);
}

inline SamplingGoal goal_of(double relative, int most_samples = 4096) {
  SamplingGoal goal;
  goal.bands = {{{relative, 0.0}}};
  goal.most_samples = most_samples;
  return goal;
}

inline ArrayImage rendered(const World& world, const RenderOptions& options) {
  Diagnostics diagnostics;
  return std::move(render(world.scene, world.camera, options, diagnostics).images.front());
}

/// Keeps tiles in memory.
class MemoryStore : public TileStore {
 public:
  [[nodiscard]] std::optional<TileRecord> find(const TileKey& key) override {
    const std::scoped_lock lock{mutex_};
    const auto found = tiles.find(key);
    if (found == tiles.end()) return std::nullopt;
    ++found_tiles;
    return found->second;
  }
  void keep(const TileRecord& record) override {
    const std::scoped_lock lock{mutex_};
    ++kept_tiles;
    tiles.insert_or_assign(record.key, record);
  }
  std::map<TileKey, TileRecord> tiles;
  int found_tiles = 0, kept_tiles = 0;

 private:
  std::mutex mutex_;
};

}  // namespace nadir::sim::test
