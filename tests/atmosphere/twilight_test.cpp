#include "atmosphere/make/twilight.hpp"

#include <cmath>

#include "atmosphere/hand_made_air.hpp"
#include "atmosphere/make/path_light.hpp"
#include "support/catch.hpp"

namespace nadir::atmosphere::test {

TEST_CASE("Ground illuminance is that of the almanac", "[atmosphere][twilight]") {
  // Seidelmann (1992), table 9.3: sun in the zenith, at the horizon, end of civil, nautical and
  // astronomical twilight. 3 %: the table's own rounding.
  CHECK(ground_illuminance_lux(90.0) == Approx(129e3).epsilon(0.03));
  CHECK(ground_illuminance_lux(0.0) == Approx(759.0).epsilon(0.03));
  CHECK(ground_illuminance_lux(-6.0) == Approx(3.41).epsilon(0.03));
  CHECK(ground_illuminance_lux(-12.0) == Approx(8.06e-3).epsilon(0.03));
  CHECK(ground_illuminance_lux(-18.0) == Approx(6.5e-4).epsilon(0.03));
  for (double h = -17.5; h < 90.0; h += 0.5) {
    // the six pieces meet within a tenth
    CHECK(ground_illuminance_lux(h) > 0.9 * ground_illuminance_lux(h - 0.5));
  }
}

TEST_CASE("Light of a set sun is made up to the measured twilight", "[atmosphere][twilight]") {
  CHECK(twilight_growth(30.0) == 1.0);
  CHECK(twilight_growth(-2.0) == 1.0);
  CHECK(twilight_growth(-3.5) == Approx(0.5 * (1.09 + 1.35)).epsilon(1e-12));
  CHECK(twilight_growth(-17.0) == twilight_growth(-6.0));
}

TEST_CASE("Far below the horizon the sky fades as measured", "[atmosphere][twilight]") {
  const auto lit = [](double elevation) {
    TableJob job = job_of({.rayleigh = 0.1, .haze = 0.2}, 0.55);
    job.settings.paths = false;
    job.bodies = {body_at(elevation)};
    const AirTable table = filled_table(job);
    check(table);
    CHECK(table.notes.empty() == (elevation >= -2.0));
    return static_cast<double>(table.bodies[0].ground_irradiance[0]);
  };
  const double last = lit(-6.0);
  CHECK(lit(-2.0) > 10.0 * last);
  for (const double elevation : {-9.0, -12.0, -17.0}) {
    const double measured = ground_illuminance_lux(elevation) / ground_illuminance_lux(-6.0);
    CHECK(lit(elevation) / last == Approx(measured).epsilon(1e-5));
  }
}

TEST_CASE("A set sun leaves the sky brightest above where it set", "[atmosphere][twilight]") {
  TableJob job = job_of({.rayleigh = 0.1, .haze = 0.2}, 0.55);
  job.settings.paths = false;
  job.bodies = {body_at(-3.0)};
  const AirTable table = filled_table(job);
  const AirTable::View& sky = table.sky;
  const std::size_t away = sky.azimuth_rad.size() - 1, low = sky.zenith_rad.size() - 5;
  const BodyPlace sun{std::sin(-3.0 * degree), 0.0};
  const auto light = [&](std::size_t z, std::size_t a) {
    const double cosine = scattering_cosine(sky.zenith_rad[z], sky.azimuth_rad[a], sun);
    return PhaseFunction::rayleigh(0.0).at(cosine) * value(sky.first, sky, {z, 0}, 0) +
           PhaseFunction::henyey_greenstein(0.7).at(cosine) * value(sky.first, sky, {z, 0}, 1) +
           value(sky.smooth, sky, {z, 0}, a);
  };
  CHECK(light(low, 0) > 1.2 * light(low, away));
  CHECK(light(low, 0) > 1.2 * light(0, 0));
  CHECK(table.bodies[0].transmittance[0] == 0.0F);
}

TEST_CASE("A sun that has half set still shines", "[atmosphere][twilight]") {
  TableJob job = job_of({.rayleigh = 0.05}, 0.8);
  job.settings.paths = false;
  job.bodies = {body_at(-0.1)};
  CHECK(filled_table(job).bodies[0].transmittance[0] > 0.0F);
}

}  // namespace nadir::atmosphere::test
