#include <fmt/format.h>

#include "sim/scenario/build_context.hpp"

namespace nadir::sim {

void build_time(const BuildContext& context, const CheckedElement& root, Scenario& scenario) {
  const CheckedElement* time = root.child("time");
  if (time == nullptr) return;
  const auto utc = time->find<ephemeris::Instant>("utc");
  if (!utc) return;
  scenario.time = *utc;
  try {  // the instant's text is valid, so what may be wrong is its correction
    const Seconds ut1_utc{time->number("ut1_minus_utc_s")};
    scenario.time = ephemeris::Instant::parse_utc(utc->to_string(), ut1_utc);
  } catch (const InputError& error) {
    context.mistake(time->where("ut1_minus_utc_s"), error.issues().front().message);
  }
  if (const auto caution = scenario.time.caution()) context.warn(time->where("utc"), *caution);
}

IlluminationInput build_illumination(const BuildContext& context, const CheckedElement& element) {
  if (const CheckedElement* computed = element.child("ephemeris")) {
    ComputedSky sky;
    sky.solar_irradiance = computed->find<SpectralInput>("solar_irradiance");
    sky.lunar_irradiance = computed->find<SpectralInput>("lunar_irradiance");
    return sky;
  }
  FixedSky sky;
  const CheckedElement* fixed = element.child("fixed");
  if (fixed == nullptr) return sky;
  std::vector<const CheckedElement*> bodies;
  for (const CheckedElement& body : fixed->children) {
    bodies.push_back(&body);
    sky.bodies.push_back({body.value<std::string>("name"), body.number("azimuth_deg"),
                          body.number("elevation_deg"), body.number("angular_radius_deg"),
                          body.value<SpectralInput>("irradiance")});
  }
  context.check_unique(bodies, "body");
  return sky;
}

materials::SolverSettings build_solver(const CheckedElement& element,
                                       const materials::SolverSettings& base) {
  const auto whole = [&](const char* name, int otherwise) {
    return element.find<int>(name).value_or(otherwise);
  };
  return {whole("initial_sample_count", base.initial_sample_count),
          element.find<double>("sample_decay_rate").value_or(base.sample_decay_rate),
          whole("max_bounces", base.max_bounces),
          whole("mu_samples", base.mu_samples),
          whole("phi_samples", base.phi_samples),
          whole("min_quad_samples", base.min_quad_samples)};
}

}  // namespace nadir::sim
