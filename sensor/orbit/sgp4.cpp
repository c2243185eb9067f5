#include "sensor/orbit/sgp4.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/quantity.hpp"
#include "core/text.hpp"
#include "sensor/orbit/sgp4_near_earth.hpp"
#include "sensor/orbit/sgp4_periodics.hpp"
#include "sensor/orbit/sgp4_resonance.hpp"
#include "sensor/orbit/sgp4_sun_moon.hpp"

namespace nadir::sensor {
namespace {

using sgp4::Elements;

/// From this period on sun, moon and resonances count.
constexpr double deep_space_period_min = 225.0;

std::string two_digits(int value) { return (value < 10 ? "0" : "") + std::to_string(value); }

/// The epoch of a two-line set. UT1 - UTC is left at 0: within the model it turns the earth, whose
/// field pulls, by at most 13 arcsec.
ephemeris::Instant epoch_of(int year, double day_of_year) {
  const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
  const int february = leap ? 29 : 28;
  const int lengths[] = {31, february, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  if (!(day_of_year >= 1.0 && day_of_year < (leap ? 367.0 : 366.0))) {
    throw PropagationError{"SGP4: the epoch's day " + number_text(day_of_year) +
                           " is not one of the year " + std::to_string(year)};
  }
  const double whole = std::floor(day_of_year);
  int day = static_cast<int>(whole), month = 0;
  while (day > lengths[month]) day -= lengths[month++];
  const ephemeris::Instant midnight = ephemeris::Instant::parse_utc(
      std::to_string(year) + "-" + two_digits(month + 1) + "-" + two_digits(day) + "T00:00:00Z");
  return midnight + Seconds{86400.0 * (day_of_year - whole)};
}

Elements elements_of(const TwoLineElements& set) {
  if (!(set.mean_motion_rev_day > 0.0) || !std::isfinite(set.mean_motion_rev_day)) {
    throw PropagationError{"SGP4: the mean motion is " + number_text(set.mean_motion_rev_day) +
                           " revolutions a day; it must be above 0"};
  }
  if (!(set.eccentricity >= 0.0 && set.eccentricity < 1.0)) {
    throw PropagationError{"SGP4: the eccentricity is " + number_text(set.eccentricity) +
                           "; it must lie in [0, 1)"};
  }
  constexpr double degree = radians_per_degree;
  return {set.mean_motion_rev_day * sgp4::two_pi / sgp4::minutes_per_day,
          set.eccentricity,
          set.inclination_deg * degree,
          set.ascending_node_deg * degree,
          set.argument_of_perigee_deg * degree,
          set.mean_anomaly_deg * degree};
}

void check_eccentricity(double value, double least, const char* which) {
  if (value >= least && value < 1.0) return;
  throw PropagationError{std::string{"SGP4: the "} + which + " eccentricity is " +
                         number_text(value) + ", outside " +
                         (least < 0.0 ? number_text(least) : "0") + " to 1"};
}

}  // namespace

struct Sgp4::Model {
  struct DeepSpace {
    sgp4::SunAndMoonPull pull;
    sgp4::Resonance resonance;
  };

  explicit Model(const TwoLineElements& set)
      : epoch{epoch_of(set.epoch_year, set.epoch_day)},
        start{sgp4::with_brouwer_motion(elements_of(set))},
        deep{sgp4::two_pi / start.mean_motion >= deep_space_period_min},
        near_earth{start, set.drag_term, deep},
        terms{sgp4::inclination_terms(start.inclination)} {
    if (!deep) return;
    // A Julian date in one double, good to 40 us, as in the programs that elements are made with.
    const double date = epoch.utc().value(), midnight = std::floor(date - 0.5) + 0.5;
    const sgp4::SunAndMoonPull pull{start, date - 2433281.5};
    const double sidereal = mean_sidereal_time({midnight, date - midnight}).value;
    deep_space.emplace(
        DeepSpace{pull, sgp4::Resonance{{start, near_earth.rates(), pull.rates(), sidereal}}});
  }

  [[nodiscard]] Elements mean(double minutes) const;

  ephemeris::Instant epoch;
  Elements start;
  bool deep;
  sgp4::NearEarth near_earth;
  sgp4::InclinationTerms terms;
  std::optional<DeepSpace> deep_space;
};

namespace {

Elements with_rates(Elements e, const Elements& rates, double minutes) {
  e.eccentricity += rates.eccentricity * minutes;
  e.inclination += rates.inclination * minutes;
  e.node += rates.node * minutes;
  e.perigee += rates.perigee * minutes;
  e.mean_anomaly += rates.mean_anomaly * minutes;
  return e;
}

/// Drag's share of size, shape and longitude.
Elements with_drag(Elements e, const sgp4::Drifted& drag, double mean_motion_at_epoch) {
  if (!(e.mean_motion > 0.0)) {
    throw PropagationError{"SGP4: the mean motion has fallen to " + number_text(e.mean_motion) +
                           " rad/min: the elements are too far from their epoch"};
  }
  const double shrunk = std::abs(drag.axis_factor);  // of the square root of the axis
  e.mean_motion /= shrunk * shrunk * shrunk;
  e.eccentricity -= drag.eccentricity_loss;
  check_eccentricity(e.eccentricity, -0.001, "mean");
  e.eccentricity = std::max(e.eccentricity, 1e-6);
  e.mean_anomaly += mean_motion_at_epoch * drag.longitude_gain;
  return e;
}

/// An inclination below 0 is the same plane, its node on the other side.
Elements with_positive_inclination(Elements e) {
  if (e.inclination >= 0.0) return e;
  e.inclination = -e.inclination;
  e.node += std::numbers::pi;
  e.perigee -= std::numbers::pi;
  return e;
}

}  // namespace

Elements Sgp4::Model::mean(double minutes) const {
  const sgp4::Drifted drifted = near_earth.at(minutes);
  Elements now = drifted.elements;
  if (deep) {
    now =
        deep_space->resonance.applied(with_rates(now, deep_space->pull.rates(), minutes), minutes);
  }
  now = with_drag(now, drifted, start.mean_motion);
  if (!deep) return now;
  now = with_positive_inclination(deep_space->pull.with_periods(now, minutes));
  check_eccentricity(now.eccentricity, 0.0, "perturbed");
  return now;
}

Sgp4::Sgp4(const TwoLineElements& elements) : model_{std::make_unique<const Model>(elements)} {}
Sgp4::~Sgp4() = default;
Sgp4::Sgp4(Sgp4&&) noexcept = default;
Sgp4& Sgp4::operator=(Sgp4&&) noexcept = default;

StateVector Sgp4::teme_km(double minutes) const {
  const Elements mean = model_->mean(minutes);
  return sgp4::osculating_state(
      mean, model_->deep ? sgp4::inclination_terms(mean.inclination) : model_->terms);
}

const ephemeris::Instant& Sgp4::epoch() const { return model_->epoch; }

StateVector orbit_state(const Sgp4& orbit, const ephemeris::Instant& time) {
  const double minutes = (time - orbit.epoch()).value / 60.0;
  const StateVector teme = orbit.teme_km(minutes);
  return ecef_from_teme({1e3 * teme.position, 1e3 * teme.velocity}, time);
}

}  // namespace nadir::sensor
