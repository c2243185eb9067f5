#include "sim/run/choose_wavelengths.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "sim/plan/air_spectra.hpp"
#include "sim/plan/surface_spectra.hpp"
#include "spectral/planck.hpp"

namespace nadir::sim {
namespace {

using radiometry::Effect;
using radiometry::EffectSet;

/// Light of sun, moon and night sky; heat of the ground and of the gases before it; the sky's.
enum Kin : int { shone, glowing, of_sky };

/// Pixels whose radiances are known on one scale: errors of the dark ones count against a floor.
enum Scale : int { natural, of_lamps, of_volumes, scales };

/// Puts together what may reach the sensor.
class LightMaker {
 public:
  LightMaker(const World& world, EffectSet effects, const spectral::Response& response)
      : world_{&world}, effects_{effects}, air_{air_of(world, response, light_.knots_um)} {
    keep_air();
  }

  [[nodiscard]] BandLight made() && {
    const auto& materials = world_->scene.materials;
    for (std::size_t i = 0; i < materials.size(); ++i) add_material(i);
    if (effects_.has(Effect::volumes)) add_volumes();
    if (materials.empty() && !air_alone_.empty())
      light_.pixels.push_back({air_alone_, 0.0, natural});
    return std::move(light_);
  }

 private:
  using Products = std::vector<std::size_t>;

  static AirSpectra air_of(const World& world, const spectral::Response& response,
                           std::vector<double>& knots_um);

  std::size_t function(SpectralFunction at) {
    light_.functions.push_back(std::move(at));
    return light_.functions.size() - 1;
  }
  BandLight::Product product(const AirLight& of) {
    BandLight::Product made;
    made.scale = of.scale;
    for (const AirFunction& factor : of.factors) {
      (factor.over_interval ? made.over_intervals : made.at_nodes).push_back(function(factor.at));
    }
    return made;
  }
  std::size_t add(BandLight::Product one) {
    light_.products.push_back(std::move(one));
    return light_.products.size() - 1;
  }
  static BandLight::Product times(BandLight::Product one, std::size_t function) {
    one.at_nodes.push_back(function);
    return one;
  }
  void keep(Effect effect, const std::vector<AirLight>& lights,
            std::vector<BandLight::Product>& products) {
    if (!effects_.has(effect)) return;
    const int kin = effect == Effect::sky_emission    ? of_sky
                    : effect == Effect::path_emission ? glowing
                                                      : shone;
    for (const AirLight& light : lights) {
      products.push_back(product(light));
      products.back().kin = kin;
    }
  }
  void keep_air();
  void keep_lamps();
  void add_material(std::size_t material);
  void add_surface(const SurfaceSpectra& surface, const std::vector<Kelvin>& temperatures);
  void add_volumes();
  std::size_t black_body(Kelvin temperature);

  const World* world_;
  EffectSet effects_;
  BandLight light_;  // before air_, which adds its knots
  AirSpectra air_;
  BandLight::Product view_;  // the way to the sensor
  std::vector<BandLight::Product> bodies_, sky_, lamps_;
  Products air_alone_;
  std::map<double, std::size_t> black_bodies_;
};

double secant_of(const Camera& camera) {
  const double down = -middle_pose(camera).axes.z.z;
  return 1.0 / std::clamp(down, 1.0 / 6.0, 1.0);
}

AirSpectra LightMaker::air_of(const World& world, const spectral::Response& response,
                              std::vector<double>& knots_um) {
  const ephemeris::Illumination& bodies = world.scene.illumination;
  AirView view{middle_pose(world.camera).position.z, secant_of(world.camera)};
  if (!world.air || !world.air->layered) {
    return air_spectra(world.scene.atmosphere, bodies, view, knots_um);
  }
  const LayeredTask& task = *world.air->layered;
  view.observer_height_m = task.settings.observer_height_m;
  return at_element(world.air->where, [&] {
    return air_spectra(task.air, bodies, view, spectral::support(response), knots_um);
  });
}

void LightMaker::keep_air() {
  if (effects_.has(Effect::path_transmittance)) view_ = product({air_.view, 1.0});
  const ephemeris::Illumination& bodies = world_->scene.illumination;
  for (std::size_t i = 0; i < air_.bodies.size(); ++i) {
    const bool moon = i < bodies.size() && bodies[i].name == "moon";
    if (!effects_.has(moon ? Effect::lunar_reflection : Effect::solar_reflection)) continue;
    bodies_.push_back(product(air_.bodies[i]));
  }
  keep(Effect::sky_scattering, air_.sky_scattering, sky_);
  keep(Effect::sky_emission, air_.sky_emission, sky_);
  std::vector<BandLight::Product> alone;
  keep(Effect::path_scattering, air_.path_scattering, alone);
  keep(Effect::path_emission, air_.path_emission, alone);
  for (auto& one : alone) air_alone_.push_back(add(std::move(one)));
  if (effects_.has(Effect::lamps)) keep_lamps();
}

void LightMaker::keep_lamps() {
  std::set<const spectral::Curve*> known;
  for (const radiometry::Lamp& lamp : world_->scene.lamps) {
    if (!known.insert(lamp.flux.curve.get()).second) continue;
    lamps_.push_back(times(view_, function(function_of(*lamp.flux.curve, light_.knots_um))));
  }
}

std::size_t LightMaker::black_body(Kelvin temperature) {
  const auto known = black_bodies_.find(temperature.value);
  if (known != black_bodies_.end()) return known->second;
  const std::size_t made = function([temperature](double lambda_um) {
    return spectral::planck(Micrometres{lambda_um}, temperature).value;
  });
  black_bodies_.emplace(temperature.value, made);
  return made;
}

void LightMaker::add_material(std::size_t material) {
  const thermal::TemperatureField& field = world_->scene.temperature;
  std::vector<Kelvin> temperatures;
  if (material < field.size() && effects_.has(Effect::surface_emission)) {
    // A roof under a clear winter's sky; what the heat balance allows at all says nothing. A
    // surface at 0 K does not emit.
    constexpr double coldest_solved_k = 250.0;
    const double coldest =
        field.solved(material) ? coldest_solved_k : field.range(material).coldest.value;
    for (const double kelvin : {coldest, field.warmest_expected(material).value}) {
      const bool repeated = !temperatures.empty() && temperatures.back().value == kelvin;
      if (kelvin > 0.0 && std::isfinite(kelvin) && !repeated) temperatures.emplace_back(kelvin);
    }
  }
  for (const SurfaceSpectra& surface :
       surface_spectra(world_->scene.materials[material], light_.knots_um)) {
    add_surface(surface, temperatures);
  }
}

void LightMaker::add_surface(const SurfaceSpectra& surface,
                             const std::vector<Kelvin>& temperatures) {
  const std::size_t scatters = function(surface.scatters);
  Products shaded = air_alone_;
  for (const auto& light : sky_) shaded.push_back(add(times(light, scatters)));
  Products lit = shaded;
  for (const auto& light : bodies_) lit.push_back(add(times(light, scatters)));
  if (effects_.has(Effect::interreflection) && !bodies_.empty()) {
    const std::size_t often = function(surface.scatters_often);
    for (const auto& light : bodies_) lit.push_back(add(times(light, often)));
  }
  for (const auto& lamp : lamps_) {
    light_.pixels.push_back({{add(times(lamp, scatters))}, 0.0, of_lamps});
  }
  std::vector<Products> states{shaded, lit};
  if (!temperatures.empty()) {
    BandLight::Product emitted = times(view_, function(surface.emits));
    emitted.kin = glowing;
    states.clear();
    for (const Kelvin temperature : temperatures) {
      const std::size_t heat = add(times(emitted, black_body(temperature)));
      for (Products state : {shaded, lit}) {
        state.push_back(heat);
        states.push_back(std::move(state));
      }
    }
  }
  for (Products& state : states) light_.pixels.push_back({std::move(state), 0.0, natural});
}

void LightMaker::add_volumes() {
  for (const radiometry::Volume& volume : world_->scene.volumes) {
    const std::size_t scatters = function(function_of(volume.medium.scattering, light_.knots_um));
    for (const auto& light : bodies_) {
      light_.pixels.push_back({{add(times(light, scatters))}, 0.0, of_volumes});
    }
    const auto* kelvin = std::get_if<Kelvin>(&volume.temperature);
    constexpr double hot_gas_k = 600.0;  // of a grid of temperatures, which is not searched
    const Kelvin temperature = kelvin != nullptr ? *kelvin : Kelvin{hot_gas_k};
    if (!(temperature.value > 0.0)) continue;
    const std::size_t absorbs = function(function_of(volume.medium.absorption, light_.knots_um));
    const auto glow = times(times(view_, absorbs), black_body(temperature));
    light_.pixels.push_back({{add(glow)}, 0.0, of_volumes});
  }
}

/// Gives pixels their floor: what is asked for, or a tenth of the mean of those they compare with.
void set_floors(const std::vector<double>& means, double floor, BandLight& light) {
  constexpr double share_of_mean = 0.1;
  std::array<double, scales> sum{}, count{};
  const auto radiance = [&](const BandLight::Pixel& pixel) {
    double all = 0.0;
    for (const std::size_t product : pixel.products) all += means[product];
    return all;
  };
  for (const BandLight::Pixel& pixel : light.pixels) {
    sum.at(static_cast<std::size_t>(pixel.scale)) += radiance(pixel);
    count.at(static_cast<std::size_t>(pixel.scale)) += 1.0;
  }
  for (BandLight::Pixel& pixel : light.pixels) {
    const auto scale = static_cast<std::size_t>(pixel.scale);
    const bool given = pixel.scale == natural && floor >= 0.0;
    pixel.floor = given ? floor : share_of_mean * sum.at(scale) / count.at(scale);
  }
}

/// Calls `f(array, band, errors)` for all bands.
template <class F>
void for_each_band(const World& world, const std::vector<EffectSet>& effects, const ByBand& floor,
                   const F& f) {
  for (std::size_t a = 0; a < world.camera.arrays.size(); ++a) {
    const auto& bands = world.camera.arrays[a].bands;
    for (std::size_t b = 0; b < bands.size(); ++b) {
      BandLight light = band_light(world, effects.at(a), bands[b].response);
      BandErrors errors{bands[b].response, light};
      set_floors(errors.means(), floor.empty() ? -1.0 : floor.at(a).at(b), light);
      f(a, b, errors);
    }
  }
}

/// Table of the air whose lanes are split by gases; null for other air.
const atmosphere::AirTable* split_table(const World& world) {
  const auto* air = std::get_if<atmosphere::Tabulated>(&world.scene.atmosphere);
  if (air == nullptr) return nullptr;
  const auto& lanes = air->table->lanes;
  const bool split = std::any_of(lanes.begin(), lanes.end(), [](const auto& lane) {
    return lane.absorption != spectral::AbsorptionLane{};
  });
  return split ? air->table.get() : nullptr;
}

/// Whether a table has lanes for all nodes of a band.
bool serves(const atmosphere::AirTable& table, const spectral::Response& response, int count) {
  const auto band = spectral::gauss_quadrature(response, count);
  const auto edges = spectral::interval_edges(response, band);
  for (std::size_t i = 0; i < band.wavelengths.size(); ++i) {
    const bool found = std::any_of(table.lanes.begin(), table.lanes.end(), [&](const auto& lane) {
      return lane.wavelength_um == band.wavelengths[i].value &&
             lane.absorption.lo_um == edges[i].value && lane.absorption.hi_um == edges[i + 1].value;
    });
    if (!found) return false;
  }
  return true;
}

/// The number that a split table was made for; where it was made for other bands, the usual one:
/// the plan of the camera says what is wrong.
CountChoice count_of_table(const atmosphere::AirTable& table, const spectral::Response& response,
                           BandErrors& errors) {
  int count = 1;
  while (count <= BandErrors::most && !serves(table, response, count)) ++count;
  if (count > BandErrors::most) count = BandNodes{}.everywhere;
  return {count, errors.stated(count)};
}

}  // namespace

BandLight band_light(const World& world, EffectSet effects, const spectral::Response& response) {
  return LightMaker{world, effects, response}.made();
}

WavelengthChoice choose_wavelengths(const World& world, const std::vector<EffectSet>& effects,
                                    double share, Diagnostics& diagnostics, const ByBand& floor) {
  WavelengthChoice choice;
  choice.nodes = BandNodes{0};
  const atmosphere::AirTable* table = split_table(world);
  choice.nodes.by_array.resize(world.camera.arrays.size());
  choice.error.resize(world.camera.arrays.size());
  for_each_band(world, effects, floor, [&](std::size_t a, std::size_t b, BandErrors& errors) {
    const sensor::Band& band = world.camera.arrays[a].bands[b];
    const CountChoice found = table != nullptr ? count_of_table(*table, band.response, errors)
                                               : choose_count(errors, share);
    choice.nodes.by_array[a].push_back(found.count);
    choice.error[a].push_back(found.error);
    if (found.error <= share) return;
    diagnostics.warn(
        fmt::format("band {} is integrated to {:.2g} %, not to {:.2g} %, with {} wavelengths{}",
                    band.name, 100.0 * found.error, 100.0 * share, found.count,
                    table != nullptr ? ", for which the table of the air was made"
                                     : "; more than 32 cannot be had"));
  });
  return choice;
}

ByBand wavelength_errors(const World& world, const std::vector<EffectSet>& effects,
                         const BandNodes& nodes, const ByBand& floor) {
  ByBand error(world.camera.arrays.size());
  for_each_band(world, effects, floor, [&](std::size_t a, std::size_t b, BandErrors& errors) {
    error[a].push_back(errors.stated(nodes.of(a, b)));
  });
  return error;
}

}  // namespace nadir::sim
