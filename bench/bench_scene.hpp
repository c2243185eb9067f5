#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/sampler.hpp"
#include "geometry/scene.hpp"
#include "radiometry/lit_scene.hpp"
#include "sim/run/world.hpp"

namespace nadir::bench {

/// A ray through a pixel and the random numbers of its path, as the renderer draws them.
struct PixelPath {
  geometry::Ray ray;
  Sampler numbers;
};

/// A scenario and the rays that are timed in it, in the order in which the renderer comes by them.
struct BenchScene {
  std::string name;
  sim::World world;
  std::vector<PixelPath> paths;        ///< one a pixel, tile by tile
  std::vector<geometry::Ray> primary;  ///< those of the paths
  std::vector<geometry::Ray> to_sun;   ///< from where they hit, if that faces the sun
  std::vector<geometry::Ray> bounces;  ///< from where they hit, cosine-weighted
};

/// @throws InputError
[[nodiscard]] BenchScene load_scene(std::string name, const std::filesystem::path& file);

/// The world at `count` wavelengths, 0.45 to 1.65 um, where all of the library is tabulated.
[[nodiscard]] radiometry::LitScene lit_at(const sim::World& world, int count);

}  // namespace nadir::bench
