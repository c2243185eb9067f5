#include "sim/run/ground_light.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "core/sampler.hpp"
#include "spectral/coverage.hpp"
#include "spectral/planck.hpp"

namespace nadir::sim {
namespace {

using spectral::Lanes;
using spectral::Spectrum;

/// Places that are looked at, along each side of the scene.
constexpr int ground_places = 32;
/// The mean direction of diffuse light: half of what a level surface sends up is above 45 degrees.
const Vec3 slanting{0.5 * std::numbers::sqrt2, 0.0, 0.5 * std::numbers::sqrt2};

/// How warm a material was at the places that showed it, and at how many it was so warm. Where
/// nobody asks for its temperature, its emission does not count: 0 K.
using GroundSeen = std::map<std::uint32_t, std::map<double, int>>;

GroundSeen look_down(const radiometry::SceneDescription& scene) {
  constexpr std::uint64_t map_draws = 0x67726F756E64;  // "ground": the numbers that maps draw with
  GroundSeen seen;
  const geometry::Bounds box = scene.geometry.bounds();
  const Vec3 size = box.hi - box.lo;
  for (int j = 0; j < ground_places; ++j) {
    for (int i = 0; i < ground_places; ++i) {
      const Vec3 from{box.lo.x + size.x * (i + 0.5) / ground_places,
                      box.lo.y + size.y * (j + 0.5) / ground_places, box.hi.z + 1.0};
      auto hit = scene.geometry.intersect({from, {0.0, 0.0, -1.0}});
      if (!hit) continue;
      const auto index = static_cast<std::uint32_t>(j * ground_places + i);
      radiometry::resolve_map(scene, *hit, Sampler{map_draws, index});
      const double kelvin = scene.temperature.at(*hit).value;
      ++seen[hit->material][std::isfinite(kelvin) ? kelvin : 0.0];
    }
  }
  return seen;
}

/// The ground at the wavelengths of one block, each once.
struct GroundBlock {
  Spectrum reflectance, emission, black_body;
};

GroundBlock mean_of(const GroundSeen& seen, const radiometry::SceneDescription& scene,
                    const Lanes& lanes, Diagnostics& diagnostics) {
  GroundBlock mean{Spectrum{lanes.count()}, Spectrum{lanes.count()}, Spectrum{lanes.count()}};
  int all = 0;
  for (const auto& [material, warmth] : seen) {
    for (const auto& [kelvin, count] : warmth) all += count;
  }
  for (const auto& [material, warmth] : seen) {
    const auto bound = materials::bind(scene.materials[material], lanes, diagnostics);
    const Spectrum reflectance = materials::albedo(bound.scattering, slanting).reflectance;
    const Spectrum emissivity = bound.emissivity(slanting);
    for (const auto& [kelvin, count] : warmth) {
      const auto share = static_cast<float>(count) / static_cast<float>(all);
      const Spectrum black = spectral::planck(lanes, Kelvin{kelvin});
      mean.reflectance.add_scaled(reflectance, share);
      mean.emission.add_scaled(emissivity * black, share);
      mean.black_body.add_scaled(black, share);
    }
  }
  return mean;
}

/// What is said of the ground replaces what was seen.
void apply(const GroundAbout& about, const Lanes& lanes, GroundBlock& ground) {
  if (about.reflectance) {
    ground.reflectance =
        spectral::at_all(*about.reflectance, lanes, "the reflectance of the ground about");
  }
  if (about.temperature) ground.black_body = spectral::planck(lanes, *about.temperature);
  if (!about.reflectance && !about.temperature) return;
  ground.emission = (Spectrum{lanes.count(), 1.0F} -= ground.reflectance) * ground.black_body;
}

}  // namespace

atmosphere::GroundLight ground_light(const radiometry::SceneDescription& scene,
                                     const GroundAbout& about,
                                     const std::vector<Micrometres>& wavelengths,
                                     Diagnostics& diagnostics) {
  const GroundSeen seen = look_down(scene);
  if (seen.empty() && !(about.reflectance && about.temperature)) {
    diagnostics.warn("the scene shows no surface from above: the ground about it counts as black");
  }
  std::vector<Micrometres> distinct = wavelengths;
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  std::vector<float> reflectance, emission;
  for (std::size_t first = 0; first < distinct.size(); first += spectral::lane_capacity) {
    const std::size_t last = std::min(first + spectral::lane_capacity, distinct.size());
    const Lanes lanes{{distinct.begin() + static_cast<std::ptrdiff_t>(first),
                       distinct.begin() + static_cast<std::ptrdiff_t>(last)}};
    GroundBlock ground = mean_of(seen, scene, lanes, diagnostics);
    apply(about, lanes, ground);
    for (int i = 0; i < lanes.count(); ++i) {
      reflectance.push_back(std::clamp(ground.reflectance[i], 0.0F, 1.0F));
      emission.push_back(std::max(ground.emission[i], 0.0F));
    }
  }
  atmosphere::GroundLight light;
  for (const Micrometres wavelength : wavelengths) {
    const auto at = static_cast<std::size_t>(
        std::lower_bound(distinct.begin(), distinct.end(), wavelength) - distinct.begin());
    light.reflectance.push_back(reflectance[at]);
    light.emission.push_back(emission[at]);
  }
  return light;
}

}  // namespace nadir::sim
