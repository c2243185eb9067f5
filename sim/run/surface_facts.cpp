#include "sim/run/surface_facts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "materials/bound_material.hpp"
#include "sim/run/load_heat.hpp"
#include "spectral/planck.hpp"

namespace nadir::sim {
namespace {

using materials::Material;

constexpr double hottest_stated_k = 6000.0;  // what a file may say at most

/// Bounds of what the weather heats and cools.
///
/// Cold: the coldest air ever measured on the ground was 184 K, and 40 K is more than a clear sky
/// has been seen to cool a surface below the air (radiators made for it). Warm: what the sun heats
/// stays below 400 K (thermal/temperature.hpp); by night ordinary ground stays within 30 K of the
/// day's warmest air.
struct WeatherBounds {
  double air_low_k = 184.0, air_high_k = 333.0;
  bool stated = false;
  static constexpr double cooled_k = 40.0, kept_warm_k = 30.0;

  [[nodiscard]] double coldest() const { return air_low_k - cooled_k; }
  [[nodiscard]] double warmest(Kelvin heated, bool night) const {
    const bool by_sun_alone = heated <= thermal::warmest_under_the_sun;
    if (!night || !stated || !by_sun_alone) return heated.value;
    return std::min(heated.value, air_high_k + kept_warm_k);
  }
};

WeatherBounds weather_bounds(const Scenario& scenario) {
  WeatherBounds bounds;
  if (!scenario.heat) return bounds;
  const auto* clear = std::get_if<ClearSkyInput>(&scenario.heat->weather);
  if (clear == nullptr) return bounds;
  return {clear->air_low_k, clear->air_high_k, true};
}

/// Collects the range of one material after the other.
struct WarmthCollector {
  const Scenario& scenario;
  const std::map<std::uint32_t, double>& hottest_vertex_k;
  bool night;
  WeatherBounds weather;
  SurfaceWarmth found{1e9, 0.0, 0.0};
  std::uint32_t material = 0;

  void add(double coldest, double warmest, bool solved = false) {
    found.coldest = std::min(found.coldest, std::max(coldest, 0.0));
    found.warmest = std::max(found.warmest, warmest);
    if (solved) found.warmest_solved = std::max(found.warmest_solved, warmest);
  }
  void operator()(const ConstantTemperatureInput& input) { add(input.kelvin, input.kelvin); }
  void operator()(const TemperatureRasterInput& /*input*/) { add(0.0, hottest_stated_k); }
  void operator()(const TemperatureTableInput& /*input*/) { add(0.0, hottest_stated_k); }
  void operator()(const VertexTemperatureInput& /*input*/) {
    const auto hottest = hottest_vertex_k.find(material);
    add(0.0, hottest != hottest_vertex_k.end() ? hottest->second : hottest_stated_k);
  }
  void operator()(const AirTemperatureInput& input) {
    add(weather.air_low_k + input.offset_k, weather.air_high_k + input.offset_k, true);
  }
  void operator()(const HeatBalanceInput& /*input*/) {
    add(weather.coldest(), weather.warmest(warmest_solved(scenario), night), true);
  }
};

/// What a material reflects, lets through and emits in a band.
struct Optics {
  CurveRange scattered, emissivity;  // scattered: reflected and transmitted
  double transmitted = 0.0;
};
constexpr Optics anything{{0.0, 1.0}, {0.0, 1.0}, 1.0};

bool known(const CurveRange& range) {
  return std::isfinite(range.least) && std::isfinite(range.greatest);
}

bool follows_its_curves(const Material& material) {
  return std::holds_alternative<materials::Lambertian>(material.scattering) ||
         std::holds_alternative<materials::Leaf>(material.scattering);
}

Optics optics_by_curves(const Material& m, BandEnds band) {
  const CurveRange through =
      m.transmittance ? range_within(*m.transmittance, band) : CurveRange{0.0, 0.0};
  CurveRange emitted{0.0, 0.0}, reflected{0.0, 0.0};
  if (m.emissivity) emitted = range_within(*m.emissivity, band);
  if (m.reflectance) {
    reflected = range_within(*m.reflectance, band);
  } else if (m.emissivity) {
    reflected = {1.0 - emitted.greatest - through.greatest, 1.0 - emitted.least - through.least};
  }
  if (!m.emissivity) {
    emitted = {1.0 - reflected.greatest - through.greatest, 1.0 - reflected.least - through.least};
  }
  if (!known(through) || !known(emitted) || !known(reflected)) return anything;
  return {{reflected.least + through.least, reflected.greatest + through.greatest},
          emitted,
          through.greatest};
}

void widen(CurveRange& range, const spectral::Spectrum& values) {
  for (int lane = 0; lane < values.count(); ++lane) {
    range.least = std::min(range.least, static_cast<double>(values[lane]));
    range.greatest = std::max(range.greatest, static_cast<double>(values[lane]));
  }
}

spectral::Lanes lanes_within(BandEnds band) {
  constexpr int count = 8;
  std::vector<Micrometres> wavelengths;
  for (int i = 0; i < count; ++i) {
    wavelengths.emplace_back(band.lo_um + (band.hi_um - band.lo_um) * (i + 0.5) / count);
  }
  return spectral::Lanes{wavelengths};
}

Optics optics_by_directions(const Material& material, BandEnds band) {
  constexpr double margin = 0.1;
  Diagnostics unheard;  // what is wrong is told when the scene is bound
  const auto bound = materials::bind(material, lanes_within(band), unheard);
  Optics found{{1.0, 0.0}, {1.0, 0.0}, 0.0};
  CurveRange through{1.0, 0.0};
  for (const double cosine : {1.0, 0.7, 0.35, 0.1}) {
    const Vec3 wo{std::sqrt(1.0 - cosine * cosine), 0.0, cosine};
    const materials::Albedo albedo = materials::albedo(bound.scattering, wo);
    auto all = albedo.reflectance;
    all += albedo.transmittance;
    widen(found.scattered, all);
    widen(through, albedo.transmittance);
    widen(found.emissivity, bound.emissivity(wo));
  }
  found.transmitted = (1.0 + margin) * through.greatest;
  found.scattered.greatest *= 1.0 + margin;
  found.scattered.least *= 1.0 - margin;
  found.emissivity.least *= 1.0 - margin;
  return found;
}

Optics optics_of(const Material& material, BandEnds band) {
  if (follows_its_curves(material)) return optics_by_curves(material, band);
  try {
    return optics_by_directions(material, band);
  } catch (const InputError&) {  // told when the scene is bound
    return anything;
  }
}

/// Rough surfaces whose brightness changes slowly with direction.
bool is_smooth(const Material& material) {
  return std::holds_alternative<materials::OrenNayar>(material.scattering) ||
         std::holds_alternative<materials::Minnaert>(material.scattering) ||
         std::holds_alternative<materials::RossLi>(material.scattering) ||
         std::holds_alternative<materials::RahmanPintyVerstraete>(material.scattering) ||
         std::holds_alternative<materials::Hapke>(material.scattering);
}

/// Greatest pi f cos(i) over directions, the hot spot among them.
double greatest_diffuse_factor(const Material& material, BandEnds band) {
  constexpr int azimuths = 6;
  Diagnostics unheard;
  const auto bound = materials::bind(material, lanes_within(band), unheard);
  const auto direction = [](double cosine, double azimuth) {
    const double sine = std::sqrt(1.0 - cosine * cosine);
    return Vec3{sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
  };
  CurveRange factor{0.0, 0.0};
  for (const double out : {1.0, 0.85, 0.6, 0.35, 0.15, 0.05}) {
    for (const double in : {1.0, 0.85, 0.6, 0.35, 0.15, 0.05}) {
      for (int i = 0; i <= azimuths; ++i) {
        auto f = materials::eval(bound.scattering, direction(in, std::numbers::pi * i / azimuths),
                                 direction(out, 0.0));
        f *= static_cast<float>(std::numbers::pi * in);
        widen(factor, f);
      }
    }
  }
  return factor.greatest;
}

double unit(double value) { return std::clamp(value, 0.0, 1.0); }

}  // namespace

SurfaceWarmth surface_warmth(const Scenario& scenario,
                             const std::map<std::uint32_t, double>& hottest_vertex_k, bool night) {
  WarmthCollector collector{scenario, hottest_vertex_k, night, weather_bounds(scenario)};
  for (const MaterialInput& material : scenario.materials) {
    std::visit([&](const auto& input) { collector(input); }, material.temperature);
    ++collector.material;
  }
  if (scenario.materials.empty()) return {};
  return collector.found;
}

double greatest_planck(BandEnds band, double kelvin) {
  if (!(kelvin > 0.0)) return 0.0;
  constexpr double wien_um_k = 2897.772;  // CODATA 2018
  const double peak = std::clamp(wien_um_k / kelvin, band.lo_um, band.hi_um);
  return spectral::planck(Micrometres{peak}, Kelvin{kelvin}).value;
}

double least_planck(BandEnds band, double kelvin) {  // it has one peak: least at an end
  if (!(kelvin > 0.0)) return 0.0;
  return std::min(spectral::planck(Micrometres{band.lo_um}, Kelvin{kelvin}).value,
                  spectral::planck(Micrometres{band.hi_um}, Kelvin{kelvin}).value);
}

CurveRange range_within(const spectral::Curve& curve, BandEnds band) {
  const double lo = curve.at(Micrometres{band.lo_um}), hi = curve.at(Micrometres{band.hi_um});
  if (!std::isfinite(lo) || !std::isfinite(hi)) return {lo + hi, lo + hi};
  CurveRange range{std::min(lo, hi), std::max(lo, hi)};
  const std::vector<double>& knots = curve.wavelengths_um();
  const auto first = std::lower_bound(knots.begin(), knots.end(), band.lo_um);
  for (auto knot = first; knot != knots.end() && *knot <= band.hi_um; ++knot) {
    const double value = curve.values()[static_cast<std::size_t>(knot - knots.begin())];
    range = {std::min(range.least, value), std::max(range.greatest, value)};
  }
  return range;
}

void add_surface_spectra(const std::vector<Material>& materials, BandFacts& band) {
  Optics all{{1.0, 0.0}, {1.0, 0.0}, 0.0};
  for (const Material& material : materials) {
    const Optics one = optics_of(material, {band.lo_um, band.hi_um});
    all.scattered = {std::min(all.scattered.least, one.scattered.least),
                     std::max(all.scattered.greatest, one.scattered.greatest)};
    all.emissivity = {std::min(all.emissivity.least, one.emissivity.least),
                      std::max(all.emissivity.greatest, one.emissivity.greatest)};
    all.transmitted = std::max(all.transmitted, one.transmitted);
  }
  if (materials.empty()) all = {{0.0, 0.0}, {0.0, 0.0}, 0.0};
  band.least_reflectance = unit(all.scattered.least);
  band.greatest_reflectance = unit(all.scattered.greatest);
  band.greatest_transmittance = unit(all.transmitted);
  band.least_emissivity = unit(all.emissivity.least);
  band.greatest_emissivity = unit(all.emissivity.greatest);
}

double greatest_gloss(const Material& material, const BandFacts& band) {
  // The moon's smallest disc, r = 0.245 degrees: 5.7e-5 sr. A reflection of the disc is no brighter
  // than the disc times the reflectance; a diffuse surface spreads it over pi.
  constexpr double glossy = std::numbers::pi / 5.7e-5;
  if (follows_its_curves(material)) return 1.0;
  if (!is_smooth(material)) return glossy;
  if (!(band.greatest_reflectance > 0.0)) return 1.0;
  constexpr double margin = 1.5;  // between the directions that are tried
  try {
    const double most = greatest_diffuse_factor(material, {band.lo_um, band.hi_um});
    return std::clamp(margin * most / band.greatest_reflectance, 1.0, glossy);
  } catch (const InputError&) {  // told when the scene is bound
    return glossy;
  }
}

bool lets_through(const Material& material) {
  if (const auto* facets = std::get_if<materials::Microfacet>(&material.scattering)) {
    return facets->transmits;
  }
  if (const auto* mixture = std::get_if<materials::Mixture>(&material.scattering)) {
    return std::any_of(mixture->parts.begin(), mixture->parts.end(),
                       [](const auto& part) { return lets_through(*part.material); });
  }
  return std::holds_alternative<materials::Leaf>(material.scattering) ||
         std::holds_alternative<materials::ClearSheet>(material.scattering);
}

}  // namespace nadir::sim
