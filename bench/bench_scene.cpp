#include "bench_scene.hpp"

#include <cmath>
#include <numbers>

#include "core/frame.hpp"
#include "sensor/camera/path_view.hpp"
#include "sim/scenario/read_scenario.hpp"

namespace nadir::bench {
namespace {

constexpr int tile_edge = 16;  // as in the renderer
constexpr int tile_step = 3;   // one tile of nine: the whole view in a tenth of the time
constexpr double first_um = 0.45, last_um = 1.65;
enum Dimension : std::uint32_t { pixel_area = 0, sun_disc = 1, bounce = 2 };

std::vector<PixelPath> pixel_paths(const sim::Camera& camera) {
  const sensor::DetectorArray& array = camera.arrays.front();
  std::vector<PixelPath> paths;
  const auto add_tile = [&](int first_sample, int first_line) {
    for (int line = first_line; line < first_line + tile_edge; ++line) {
      for (int sample = first_sample; sample < first_sample + tile_edge; ++sample) {
        const auto pixel = static_cast<std::uint64_t>(line * array.samples + sample);
        const Sampler numbers{mix(1, pixel), 0};
        const Vec2 inside = numbers.point(pixel_area);
        paths.push_back(
            {sensor::image_view(array, camera.platform, {sample + inside.x, line + inside.y}).ray,
             numbers});
      }
    }
  };
  constexpr int step = tile_edge * tile_step;
  for (int line = 0; line + tile_edge <= array.lines; line += step) {
    for (int sample = 0; sample + tile_edge <= array.samples; sample += step) {
      add_tile(sample, line);
    }
  }
  return paths;
}

void add_secondary_rays(const PixelPath& path, const radiometry::Target& sun, BenchScene& scene) {
  const auto hit = scene.world.scene.geometry.intersect(path.ray);
  if (!hit) return;
  const Vec3 towards = radiometry::direction_in_disc(sun, path.numbers.point(sun_disc));
  if (dot(towards, hit->normal) > 0.0) {
    scene.to_sun.push_back({geometry::leaving_origin(*hit, towards), towards});
  }
  // Malley: a uniform point on the disc, lifted to the hemisphere, follows the cosine.
  const Vec2 u = path.numbers.point(bounce);
  const double radius = std::sqrt(u.x), azimuth = 2.0 * std::numbers::pi * u.y;
  const Vec3 direction =
      frame_about(hit->normal)
          .to_world({radius * std::cos(azimuth), radius * std::sin(azimuth), std::sqrt(1.0 - u.x)});
  scene.bounces.push_back({geometry::leaving_origin(*hit, direction), direction});
}

}  // namespace

BenchScene load_scene(std::string name, const std::filesystem::path& file) {
  Diagnostics diagnostics;
  sim::InputFiles files;
  BenchScene scene{std::move(name),
                   sim::load_world(sim::read_scenario(file, diagnostics), files, diagnostics),
                   {},
                   {},
                   {},
                   {}};
  scene.paths = pixel_paths(scene.world.camera);
  const radiometry::LitScene lit = lit_at(scene.world, 1);
  const radiometry::Target& sun = lit.targets().at(0);
  for (const PixelPath& path : scene.paths) {
    scene.primary.push_back(path.ray);
    add_secondary_rays(path, sun, scene);
  }
  return scene;
}

radiometry::LitScene lit_at(const sim::World& world, int count) {
  std::vector<Micrometres> wavelengths;
  for (int i = 0; i < count; ++i) {
    wavelengths.emplace_back(first_um + (last_um - first_um) * (i + 0.5) / count);
  }
  Diagnostics diagnostics;
  return {world.scene, spectral::Lanes{std::move(wavelengths)}, diagnostics};
}

}  // namespace nadir::bench
