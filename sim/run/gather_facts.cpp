#include "sim/run/gather_facts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include "core/constants.hpp"
#include "core/frame.hpp"
#include "ephemeris/eclipse.hpp"
#include "ephemeris/sun_moon.hpp"
#include "sensor/detector/signal_chain.hpp"
#include "sim/plan/light_envelope.hpp"
#include "sim/run/air_facts.hpp"
#include "sim/run/pixel_ray.hpp"
#include "sim/run/surface_facts.hpp"
#include "sim/run/view_facts.hpp"
#include "spectral/response.hpp"

namespace nadir::sim {
namespace {

constexpr double beyond_knowledge = std::numeric_limits<double>::infinity();
constexpr Angle end_of_twilight = degrees(-18.0), moon_drowned_by = degrees(5.0);

/// What is stated, where that needs no file.
std::optional<double> stated_number(const SpectralInput& input) {
  const double* number = std::get_if<double>(&input.source);
  return number == nullptr ? std::nullopt : std::optional{*number};
}

/// Sun or moon (or bodies by hand that count as such), as far as it is known without its file.
struct BodyFacts {
  bool there = false;   ///< some of its disc is above the horizon
  bool shines = false;  ///< or its twilight is
  Vec3 direction{0.0, 0.0, -1.0};
  std::vector<Vec3> others{};  ///< of all bodies that count as this one
  Angle elevation = degrees(-90.0);
  double radius_rad = 0.0;
  double stated = 0.0;  ///< W m^-2 um^-1; infinity: from a file
  bool modelled = false;
  double factor = 1.0;  ///< of what is modelled
  Angle phase{0.0};     ///< of the moon
};

struct SkyFacts {
  BodyFacts sun, moon;
  double eclipsed_share = 0.0;
  bool drowned = false;  ///< the moon, by a sun that stands high
};

void place_body(BodyFacts& body, const ephemeris::BodyPosition& at, double dip_rad) {
  body.direction = at.direction_enu;
  body.elevation = at.elevation;
  body.radius_rad = at.angular_radius.value;
  // A table of the air lifts bodies by refraction, at most 0.6 degrees.
  constexpr Angle lifted = degrees(0.6);
  body.there = at.elevation + lifted > Angle{-at.angular_radius.value};
  body.shines = at.elevation > end_of_twilight - Angle{dip_rad} - lifted;
}

double dip_of(double height_m) {
  constexpr double earth_radius_m = 6'371'000.0;
  return std::acos(earth_radius_m / (earth_radius_m + std::max(0.0, height_m)));
}

/// What an irradiance from the scenario is, or that a model stands for it.
void take_light(const std::optional<SpectralInput>& given, BodyFacts& body) {
  if (!given) {
    body.modelled = true;
  } else {
    body.stated = stated_number(*given).value_or(beyond_knowledge);
  }
}

double eclipsed(const ephemeris::Eclipse& eclipse) {
  if (!eclipse.any()) return 0.0;
  double least = 1.0;
  for (const double um : {0.3, 0.5, 1.0, 2.0, 5.0, 14.0}) {
    least = std::min(least, eclipse.factor(Micrometres{um}));
  }
  return std::clamp(1.0 - least, 0.0, 1.0);
}

SkyFacts sky_facts(const ComputedSky& sky, const Scenario& scenario) {
  const auto seen = ephemeris::sun_and_moon(
      scenario.time,
      {scenario.origin.latitude_deg, scenario.origin.longitude_deg, scenario.origin.height_m});
  SkyFacts facts;
  const double dip = dip_of(scenario.origin.height_m);
  place_body(facts.sun, seen.sun, dip);
  place_body(facts.moon, seen.moon, dip);
  if (sky.sun_shines) take_light(sky.solar_irradiance, facts.sun);
  if (sky.moon_shines) take_light(sky.lunar_irradiance, facts.moon);
  const double distance_au = seen.sun.distance.value / astro::astronomical_unit_m;
  facts.sun.factor = 1.0 / (distance_au * distance_au);
  if (!facts.sun.modelled) facts.sun.stated *= facts.sun.factor;
  facts.moon.phase = seen.phase.phase_angle;
  // The loader leaves it out (load_light.hpp): less than 1e-4 of the sun's.
  facts.drowned = facts.moon.modelled && facts.sun.elevation >= moon_drowned_by &&
                  (facts.sun.modelled || facts.sun.stated > 0.0);
  if (facts.drowned) facts.moon.there = facts.moon.shines = false;
  if (sky.eclipses && facts.sun.shines)
    facts.eclipsed_share = eclipsed(ephemeris::solar_eclipse(seen));
  if (sky.eclipses && facts.moon.shines && facts.moon.modelled) {
    facts.eclipsed_share =
        std::max(facts.eclipsed_share,
                 eclipsed(ephemeris::lunar_eclipse(ephemeris::earth_shadow(scenario.time))));
  }
  return facts;
}

/// Bodies other than one called moon count as suns (LitScene). Several count as one that is as
/// bright as all, and as high as the highest.
SkyFacts sky_facts(const FixedSky& sky, const Scenario& /*scenario*/) {
  SkyFacts facts;
  for (const FixedBody& given : sky.bodies) {
    BodyFacts& body = given.name == "moon" ? facts.moon : facts.sun;
    const Angle elevation = degrees(given.elevation_deg),
                radius = degrees(given.angular_radius_deg);
    const Vec3 direction = direction_enu(degrees(given.azimuth_deg).value, elevation.value);
    body.others.push_back(direction);
    if (elevation > body.elevation) {
      body.elevation = elevation;
      body.direction = direction;
    }
    body.radius_rad = std::max(body.radius_rad, radius.value);
    body.there = body.there || elevation > Angle{-radius.value};
    body.shines = body.shines || elevation > end_of_twilight;
    body.stated += stated_number(given.irradiance).value_or(beyond_knowledge);
  }
  return facts;
}

SkyFacts sky_facts(const Scenario& scenario) {
  return std::visit([&](const auto& sky) { return sky_facts(sky, scenario); },
                    scenario.illumination);
}

double sunlight(const BodyFacts& sun, Micrometres wavelength) {
  return sun.modelled ? sun.factor * sun_envelope(wavelength) : sun.stated;
}
double moonlight(const BodyFacts& moon, Micrometres wavelength) {
  return moon.modelled ? moon_envelope(wavelength, moon.phase) : moon.stated;
}

/// Outside the air, at nine wavelengths of the band: envelopes are smooth.
BandIrradiance band_light(const SkyFacts& sky, const BandFacts& band) {
  constexpr int count = 9;
  BandIrradiance light;
  for (int i = 0; i < count; ++i) {
    const double um = band.lo_um + (band.hi_um - band.lo_um) * i / (count - 1.0);
    light.wavelengths_um.push_back(um);
    light.sun.push_back(sky.sun.shines ? sunlight(sky.sun, Micrometres{um}) : 0.0);
    light.moon.push_back(sky.moon.shines ? moonlight(sky.moon, Micrometres{um}) : 0.0);
  }
  return light;
}

double greatest(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

bool in_view(const ViewFacts& view, const BodyFacts& body) {
  if (!body.there) return false;
  constexpr double margin_rad = 0.01;  // between the lines of sight, and what the optics spread
  const double limit = std::cos(body.radius_rad + margin_rad);
  return greatest_cosine(view, body.direction) > limit ||
         std::any_of(body.others.begin(), body.others.end(),
                     [&](Vec3 other) { return greatest_cosine(view, other) > limit; });
}

/// What of a body's light falls on level ground.
double level_share(const BodyFacts& body) {
  return body.there ? std::max(0.0, std::sin(body.elevation.value)) : 0.0;
}

/// One plane or disc alone: nothing that it could see.
bool is_one_flat_surface(const Scenario& scenario) {
  if (scenario.geometry.size() != 1 || !scenario.volumes.empty() || !scenario.lamps.empty()) {
    return false;
  }
  const auto* object = std::get_if<ObjectInput>(&scenario.geometry.front());
  const auto* form = object == nullptr ? nullptr : std::get_if<ShapeInput>(&object->form);
  return form != nullptr && (std::holds_alternative<geometry::Plane>(form->shape) ||
                             std::holds_alternative<geometry::Disc>(form->shape));
}

bool heat_is_solved(const Scenario& scenario) {
  return std::any_of(scenario.materials.begin(), scenario.materials.end(),
                     [](const MaterialInput& material) {
                       return std::holds_alternative<HeatBalanceInput>(material.temperature) ||
                              std::holds_alternative<AirTemperatureInput>(material.temperature);
                     });
}

/// Gathers the facts of one scenario.
class FactGatherer {
 public:
  FactGatherer(const Scenario& scenario, const FactsSources& sources)
      : scenario_{scenario}, sources_{sources}, sky_{sky_facts(scenario)} {
    constexpr Angle night_begins = degrees(-6.0);
    warmth_ = surface_warmth(scenario, sources.geometry.hottest_vertex_k,
                             sky_.sun.elevation < night_begins);
  }

  [[nodiscard]] SceneFacts gather() {
    describe_scene();
    for (const sensor::DetectorArray& array : sources_.camera.arrays) {
      views_.push_back(view_facts(sources_.geometry.scene, sources_.camera.platform, array));
      const ViewFacts& view = views_.back();
      facts_.body_in_view |= in_view(view, sky_.sun) || in_view(view, sky_.moon);
      facts_.sky_in_view |= view.misses_surfaces;
      auto& bands = surfaces_.emplace_back();
      for (const sensor::Band& band : array.bands) bands.push_back(surfaces_at(band));
    }
    add_gloss();
    bent_pixels_ = refraction_pixels();
    for (std::size_t i = 0; i < views_.size(); ++i) facts_.arrays.push_back(array_facts(i));
    return facts_;
  }

 private:
  void describe_scene() {
    const auto* task = layers();
    facts_.has_sun = sky_.sun.there && (sky_.sun.modelled || sky_.sun.stated > 0.0);
    facts_.has_moon = sky_.moon.there && (sky_.moon.modelled || sky_.moon.stated > 0.0);
    facts_.sun_elevation_deg = sky_.sun.elevation.value / radians_per_degree;
    facts_.moon_elevation_deg = sky_.moon.elevation.value / radians_per_degree;
    facts_.moon_drowned = sky_.drowned;
    facts_.has_lamps = !sources_.geometry.lamps.empty();
    facts_.has_volumes = !scenario_.volumes.empty();
    facts_.has_leaves =
        std::any_of(sources_.materials.begin(), sources_.materials.end(), lets_through);
    facts_.has_air = task != nullptr || !std::holds_alternative<atmosphere::None>(sources_.air);
    facts_.has_refraction = task != nullptr && task->layered->refraction;
    facts_.has_solved_temperatures = heat_is_solved(scenario_);
    facts_.eclipsed_share = sky_.eclipsed_share;
    facts_.one_convex_surface = is_one_flat_surface(scenario_);
    facts_.wants_temperatures = scenario_.products.truth_temperature;
  }

  [[nodiscard]] const AirTask* layers() const {
    const bool there = sources_.air_task.has_value() && sources_.air_task->layered.has_value();
    return there ? &*sources_.air_task : nullptr;
  }

  /// What surfaces are like in a band.
  [[nodiscard]] BandFacts surfaces_at(const sensor::Band& band) const {
    const spectral::Support range = spectral::support(band.response);
    BandFacts facts;
    facts.name = band.name;
    facts.centre_um = spectral::centre(band.response).value;
    facts.lo_um = range.lo.value;
    facts.hi_um = range.hi.value;
    add_surface_spectra(sources_.materials, facts);
    return facts;
  }

  void add_gloss() {
    for (const auto& bands : surfaces_) {
      for (const BandFacts& band : bands) {
        for (const materials::Material& material : sources_.materials) {
          facts_.gloss = std::max(facts_.gloss, greatest_gloss(material, band));
        }
      }
    }
  }

  [[nodiscard]] ArrayFacts array_facts(std::size_t index) const {
    const sensor::DetectorArray& array = sources_.camera.arrays[index];
    ArrayFacts facts;
    facts.name = array.name;
    facts.smear_pixels = smear_pixels(sources_.camera.platform, array);
    facts.spread_pixels = array.spread == nullptr ? 0.0 : beyond_knowledge;
    facts.refraction_pixels = bent_pixels_;
    for (std::size_t band = 0; band < array.bands.size(); ++band) {
      facts.bands.push_back(band_facts(index, band));
      add_noise(index, band, facts);
    }
    return facts;
  }

  [[nodiscard]] BandFacts band_facts(std::size_t index, std::size_t band) const {
    BandFacts facts = surfaces_[index][band];
    const BandEnds ends{facts.lo_um, facts.hi_um};
    facts.coldest_emission = least_planck(ends, warmth_.coldest);
    facts.warmest_emission = greatest_planck(ends, warmth_.warmest);
    facts.warmest_solved_emission = greatest_planck(ends, warmth_.warmest_solved);
    const BandIrradiance light = band_light(sky_, facts);
    if (sky_.sun.there) facts.sun_irradiance = greatest(light.sun);
    if (sky_.moon.there) facts.moon_irradiance = greatest(light.moon);
    facts.level_irradiance =
        (1.0 - sky_.eclipsed_share) * (facts.sun_irradiance * level_share(sky_.sun) +
                                       facts.moon_irradiance * level_share(sky_.moon));
    add_lamps(views_[index], facts);
    const AirSurroundings about{
        {sky_.sun.elevation, greatest_cosine(views_[index], sky_.sun.direction)},
        {sky_.moon.elevation, greatest_cosine(views_[index], sky_.moon.direction)},
        views_[index].air_mass,
        warmth_.warmest,
        facts_.gloss > 1.0 || facts_.sky_in_view};
    add_air_light(sources_.air, layers(), light, about, facts);
    // The sky itself, where it is seen, has come into the line of sight; a corner of it may be seen
    // that none of the lines of sight that were tried has met.
    facts.path_scattering += facts.sky_scattering;
    facts.path_emission += facts.sky_emission;
    return facts;
  }

  /// All light of all lamps on one pixel: its surface is no smaller than the pixel looks.
  void add_lamps(const ViewFacts& view, BandFacts& facts) const {
    double all = 0.0, of_areas = 0.0;
    for (const radiometry::Lamp& lamp : sources_.geometry.lamps) {
      const double most =
          range_within(*lamp.flux.curve, {facts.lo_um, facts.hi_um}).greatest * lamp.flux.factor;
      const double flux = std::isfinite(most) ? most : beyond_knowledge;
      all += flux;
      if (std::holds_alternative<radiometry::AreaLamp>(lamp.form)) of_areas += flux;
    }
    const auto over_pixel = [&](double flux) {
      if (flux == 0.0) return 0.0;
      return view.least_pixel_m2 > 0.0 ? flux / view.least_pixel_m2 : beyond_knowledge;
    };
    facts.lamp_irradiance = over_pixel(all);
    facts.lamp_radiance = over_pixel(of_areas) / std::numbers::pi;
  }

  void add_noise(std::size_t index, std::size_t band, ArrayFacts& facts) const {
    const auto& electronics = sources_.camera.electronics;
    if (index >= electronics.size() || band >= electronics[index].size()) return;
    const auto& detector = electronics[index][band].detector;
    if (!detector) return;
    facts.has_detector = true;
    try {
      const sensor::SignalChain chain{sources_.camera.arrays[index], band, *detector, 1};
      facts.bands[band].noise_radiance = chain.noise_equivalent_radiance(0.0);
    } catch (const InputError&) {  // told when the detector is made
    }
  }

  /// As camera_bending finds it: one wavelength for all, the worst array counts.
  [[nodiscard]] double refraction_pixels() const {
    if (!facts_.has_refraction) return 0.0;
    double sum = 0.0, count = 0.0;
    for (const auto& bands : surfaces_) {
      for (const BandFacts& band : bands) sum += band.centre_um;
      count += static_cast<double>(bands.size());
    }
    const atmosphere::Layered& air = layers()->layered->air;
    const RayBending bending{atmosphere::Refractivity{air.profile, Micrometres{sum / count}},
                             air.ground_height_m};
    double most = 0.0;
    for (const sensor::DetectorArray& array : sources_.camera.arrays) {
      most = std::max(most, bending_in_pixels(sources_.geometry.scene, bending, array,
                                              sources_.camera.platform));
    }
    return most;
  }

  const Scenario& scenario_;
  const FactsSources& sources_;
  SkyFacts sky_;
  SurfaceWarmth warmth_;
  std::vector<ViewFacts> views_;                  // by array
  std::vector<std::vector<BandFacts>> surfaces_;  // by array and band
  double bent_pixels_ = 0.0;
  SceneFacts facts_;
};

}  // namespace

SceneFacts gather_facts(const Scenario& scenario, const FactsSources& sources) {
  return FactGatherer{scenario, sources}.gather();
}

}  // namespace nadir::sim
