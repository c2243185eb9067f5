#include "atmosphere/table/air_table.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "atmosphere/synthetic_air.hpp"
#include "core/error.hpp"
#include "support/catch.hpp"

namespace {

using namespace nadir;
using namespace nadir::atmosphere;

SyntheticAir some_air() {
  SyntheticAir air;
  air.wavelengths_um = {0.5, 0.6, 0.8};
  air.extinction = constant(1e-5);
  air.smooth = [](const Place& p) { return 1.0 + static_cast<double>(p.lane); };
  air.kinds = 2;
  air.first = constant(1.0);
  air.phase = [](std::size_t, double) { return 0.25 / std::numbers::pi; };
  return air;
}

/// What `check` says of a table after a change; "" if nothing.
std::string refusal(const std::function<void(AirTable&)>& change) {
  AirTable table = some_air().table();
  change(table);
  try {
    check(table);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool says(const std::string& message, const std::string& part) {
  return message.find(part) != std::string::npos;
}

/// Bound at some wavelengths, over a black ground.
BoundAirTable at(const AirTable& table, const std::vector<double>& wavelengths_um,
                 std::vector<spectral::AbsorptionLane> absorption = {}) {
  std::vector<Micrometres> wavelengths;
  for (const double um : wavelengths_um) wavelengths.emplace_back(um);
  const std::vector<float> black(table.lanes.size(), 0.0F);
  return {std::make_shared<const AirTable>(table),
          {black, black},
          spectral::Lanes{wavelengths, std::move(absorption)}};
}

std::string refusal_at(const AirTable& table, const std::vector<double>& wavelengths_um,
                       std::vector<spectral::AbsorptionLane> absorption = {}) {
  try {
    (void)at(table, wavelengths_um, std::move(absorption));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// 0.5 um alone, 0.6 um in two terms of an interval, 0.8 and 0.9 um alone.
AirTable split_table() {
  SyntheticAir air = some_air();
  air.wavelengths_um = {0.5, 0.6, 0.6, 0.8, 0.9};
  AirTable table = air.table();
  table.lanes[1].absorption = {0.59, 0.61, 0};
  table.lanes[2].absorption = {0.59, 0.61, 1};
  table.lanes[1].weight = table.lanes[2].weight = 0.5;
  return table;
}

double sky(const BoundAirTable& table, int lane) {
  return static_cast<double>(table.sky({0.0, 0.6, 0.8})[lane]);
}

}  // namespace

TEST_CASE("a legal table passes its check", "[atmosphere][table]") {
  CHECK(refusal([](AirTable&) {}).empty());
  CHECK(refusal([](AirTable& t) { t.views.clear(); }).empty());
  CHECK(refusal([](AirTable& t) { t.night_top.assign(3, 1e-6F); }).empty());
}

TEST_CASE("two bands may share a wavelength and stand for other intervals", "[atmosphere][table]") {
  AirTable table = split_table();
  table.lanes[2].absorption = {0.59, 0.62, 0};  // of a wider band
  table.lanes[1].weight = table.lanes[2].weight = 1.0;
  check(table);
  CHECK(sky(at(table, {0.6}, {{0.59, 0.62, 0}}), 0) == sky(bound(table), 2));
  std::swap(table.lanes[1], table.lanes[2]);
  CHECK_THROWS_AS(check(table), InputError);
}

TEST_CASE("the check names the part that is wrong", "[atmosphere][table]") {
  using T = AirTable;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(says(refusal([](T& t) { t.lanes.clear(); }), "lanes: expected at least one"));
  CHECK(says(refusal([](T& t) { t.lanes[1].wavelength_um = 0.4; }),
             "lanes: expected ascending wavelengths, found 0.4 um after 0.5 um"));
  CHECK(says(refusal([](T& t) { t.lanes[1].weight = 1.5; }), "lanes: expected weights"));
  CHECK(says(refusal([](T& t) { t.top_m = -1.0; }), "top: expected one above the ground"));
  CHECK(says(refusal([](T& t) { t.bodies[0].transmittance[2] = 1.5F; }),
             "sun transmittance: expected at most 1, found 1.5 at 2"));
  CHECK(says(refusal([](T& t) { t.bodies[0].irradiance.pop_back(); }),
             "sun irradiance: expected 3 values, found 2"));
  CHECK(says(refusal([](T& t) { t.phase_grid[3] *= 1.1; }), "phase grid: expected even steps"));
  CHECK(says(refusal([](T& t) { t.phase[7] = -0.1F; }), "phase: expected no negative values"));
  CHECK(says(refusal([&](T& t) { t.sky.smooth[5] = nan; }), "sky smooth: expected finite"));
  CHECK(says(refusal([](T& t) { t.sky.share = {0.5, 1.0}; }), "sky extinction: expected"));
  CHECK(says(refusal([](T& t) { t.views[0].extinction[4] = -1.0F; }),
             "view 1 extinction: expected no negative values, found -1 at 4"));
  CHECK(says(refusal([](T& t) { t.views[0].first.clear(); }), "view 1 first: expected"));
  CHECK(says(refusal([](T& t) { t.views[0].share.back() = 0.9; }), "view 1 share: expected 1"));
  CHECK(says(refusal([](T& t) { t.views[0].height_m = 2e5; }), "view 1 height: expected one"));
  CHECK(says(refusal([](T& t) { t.views[0].azimuth_rad[1] = 4.0; }), "view 1 azimuth: expected"));
  CHECK(says(refusal([](T& t) { t.views[0].zenith_rad[3] = 0.0; }), "view 1 zenith: "));
  CHECK(says(refusal([](T& t) { t.views[0].zenith_rad[11] -= 1e-3; }), "the horizon, "));
  CHECK(says(refusal([](T& t) { t.views.push_back(t.views[0]); }), "views: expected ascending"));
  CHECK(says(refusal([](T& t) { t.spherical_albedo[0] = 1.0F; }), "spherical albedo: "));
  CHECK(says(refusal([](T& t) { t.even_ground_irradiance.clear(); }), "even ground irradiance: "));
}

TEST_CASE("wavelengths between those of the table are interpolated", "[atmosphere][table]") {
  const AirTable table = some_air().table();
  const BoundAirTable exact = bound(table);
  const BoundAirTable between = at(table, {0.5, 0.55, 0.75, 0.8});
  CHECK(sky(between, 0) == sky(exact, 0));
  CHECK(sky(between, 1) == Approx(0.5 * (sky(exact, 0) + sky(exact, 1))).epsilon(1e-6));
  CHECK(sky(between, 2) == Approx(0.25 * sky(exact, 1) + 0.75 * sky(exact, 2)).epsilon(1e-6));
  CHECK(sky(between, 3) == sky(exact, 2));
}

TEST_CASE("terms of absorption are matched, never mixed", "[atmosphere][table]") {
  const AirTable table = split_table();
  const BoundAirTable all = bound(table);
  const BoundAirTable one = at(table, {0.6}, {{0.59, 0.61, 1}});
  CHECK(sky(one, 0) == sky(all, 2));
  CHECK(sky(at(table, {0.85}), 0) == Approx(0.5 * (sky(all, 3) + sky(all, 4))).epsilon(1e-6));
}

TEST_CASE("a table that does not cover a wavelength says what it covers", "[atmosphere][table]") {
  CHECK(refusal_at(some_air().table(), {0.81}) ==
        "error: the air table has nothing for 0.81 um: it covers 3 lanes from 0.5 um to 0.8 um\n");
  CHECK(says(refusal_at(some_air().table(), {0.49}), "nothing for 0.49 um"));
  const AirTable split = split_table();
  CHECK(says(refusal_at(split, {0.6}, {{0.59, 0.61, 2}}), "(term 3 of 0.59 um to 0.61 um)"));
  CHECK(says(refusal_at(split, {0.6}, {{0.58, 0.61, 0}}), "(term 1 of 0.58 um to 0.61 um)"));
  // between an unsplit lane and another beyond split ones
  CHECK(says(refusal_at(split, {0.7}), "nothing for 0.7 um"));
}

// A band plan gives every wavelength an interval. A table from elsewhere that knows of none serves
// the first term, which is then the only one.
TEST_CASE("a table without intervals serves wavelengths with one", "[atmosphere][table]") {
  const AirTable table = some_air().table();
  CHECK(sky(at(table, {0.55}, {{0.54, 0.56, 0}}), 0) == sky(at(table, {0.55}), 0));
  CHECK(says(refusal_at(table, {0.55}, {{0.54, 0.56, 1}}), "(term 2 of"));
}

TEST_CASE("kinds that scatter nothing cost nothing and change nothing", "[atmosphere][table]") {
  SyntheticAir air = some_air();
  air.first = [](const Place& p) { return p.kind == 1 ? 2.0 : 0.0; };
  air.phase = [](std::size_t kind, double c) { return kind == 1 ? 0.1 * (1.0 + c * c) : 9.0; };
  SyntheticAir alone = air;
  alone.kinds = 1;
  alone.first = constant(2.0);
  alone.phase = [](std::size_t, double c) { return 0.1 * (1.0 + c * c); };
  const BoundAirTable a = bound(air.table()), b = bound(alone.table());
  for (const double zenith : {0.1, 0.7, 1.3}) {
    const Vec3 direction = towards(zenith, 1.0);
    CHECK(a.sky(direction)[1] == b.sky(direction)[1]);
    const PathTerms one = a.path({0.0, 0.0, 1500.0}, -direction, 900.0);
    const PathTerms other = b.path({0.0, 0.0, 1500.0}, -direction, 900.0);
    CHECK(one.radiance[2] == other.radiance[2]);
  }
}

// The lanes that pad a group must not show.
TEST_CASE("lanes do not depend on how many there are", "[atmosphere][table]") {
  SyntheticAir air = some_air();
  air.wavelengths_um.clear();
  for (int i = 0; i < 19; ++i) air.wavelengths_um.push_back(0.4 + 0.01 * i);
  const AirTable table = air.table();
  const BoundAirTable all = bound(table);
  const Vec3 eye{10.0, -5.0, 800.0}, direction = towards(2.0, 0.3);
  const PathTerms many = all.path(eye, direction, 700.0);
  for (int lane = 0; lane < 19; ++lane) {
    const BoundAirTable one = at(table, {air.wavelengths_um[static_cast<std::size_t>(lane)]});
    const PathTerms single = one.path(eye, direction, 700.0);
    CHECK(many.transmittance[lane] == single.transmittance[0]);
    CHECK(many.radiance[lane] == single.radiance[0]);
    CHECK(sky(all, lane) == sky(one, 0));
  }
  CHECK(many.radiance.max() < 1.0F);
  CHECK(many.transmittance.count() == 19);
}

TEST_CASE("the ground's light must be given at every wavelength", "[atmosphere][table]") {
  const auto table = std::make_shared<const AirTable>(some_air().table());
  const spectral::Lanes lanes{{Micrometres{0.5}, Micrometres{0.6}}};
  CHECK_THROWS_AS((BoundAirTable{table, {{0.1F}, {0.0F}}, lanes}), InputError);
}
