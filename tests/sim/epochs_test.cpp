#include "sim/run/epochs.hpp"

#include "core/error.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

using ephemeris::Instant;

Instant utc(const char* time) { return Instant::parse_utc(time); }

Scenario scene_with(const std::vector<PresenceInput>& presences) {
  Scenario scenario;
  scenario.time = utc("2026-06-21T16:00:00Z");
  for (const PresenceInput& presence : presences) {
    ObjectInput object;
    object.presence = presence;
    scenario.geometry.emplace_back(object);
  }
  return scenario;
}

TEST_CASE("what has no times is there in every epoch", "[sim][epochs]") {
  const Epochs epochs{scene_with({{}})};
  CHECK(epochs.of({}) == geometry::always);
  CHECK(epochs.at(0.0) == 1U);
  CHECK(epochs.at(-1e6) == 1U);
}

TEST_CASE("what left before the picture is in the epochs before it left", "[sim][epochs]") {
  const PresenceInput car{std::nullopt, utc("2026-06-21T15:00:00Z")};
  const Epochs epochs{scene_with({car})};
  CHECK((epochs.of(car) & epochs.at(0.0)) == 0U);
  CHECK((epochs.of(car) & epochs.at(-3600.0)) == 0U);  // the moment at which it leaves
  CHECK((epochs.of(car) & epochs.at(-3601.0)) != 0U);
  CHECK((epochs.of(car) & epochs.at(-90000.0)) != 0U);
}

TEST_CASE("two objects' times cut the past into epochs of their own", "[sim][epochs]") {
  const PresenceInput a{utc("2026-06-21T10:00:00Z"), utc("2026-06-21T14:00:00Z")};
  const PresenceInput b{utc("2026-06-21T12:00:00Z"), std::nullopt};
  const Epochs epochs{scene_with({a, b})};
  const auto there = [&](const PresenceInput& object, double hours_before) {
    return (epochs.of(object) & epochs.at(-3600.0 * hours_before)) != 0U;
  };
  for (const double hours : {0.0, 1.0, 1.9}) CHECK_FALSE(there(a, hours));
  for (const double hours : {2.5, 3.9, 4.5, 6.0}) CHECK(there(a, hours));
  for (const double hours : {6.1, 30.0}) CHECK_FALSE(there(a, hours));
  for (const double hours : {0.0, 3.0, 4.0}) CHECK(there(b, hours));
  for (const double hours : {4.1, 9.0}) CHECK_FALSE(there(b, hours));
}

TEST_CASE("the first change counts within the days that are asked for", "[sim][epochs]") {
  const PresenceInput car{utc("2026-06-20T10:00:00Z"), utc("2026-06-21T15:00:00Z")};
  const PresenceInput barn{utc("2026-05-01T00:00:00Z"), std::nullopt};
  const Epochs epochs{scene_with({car, barn})};
  CHECK(epochs.first_change_s(10.0 * 86400.0) == Approx(30.0 * 3600.0).margin(1e-6));
  CHECK(epochs.first_change_s(3600.5) == Approx(3600.0).margin(1e-6));
  CHECK(epochs.first_change_s(60.0) == 0.0);
  CHECK(Epochs{scene_with({{}})}.first_change_s(1e9) == 0.0);
}

TEST_CASE("what comes after the picture is in no epoch and cuts none", "[sim][epochs]") {
  const PresenceInput later{utc("2026-06-21T17:00:00Z"), std::nullopt};
  const PresenceInput leaves_later{std::nullopt, utc("2026-06-21T17:00:00Z")};
  const Epochs epochs{scene_with({later, leaves_later})};
  CHECK(epochs.of(later) == 0U);
  CHECK((epochs.of(leaves_later) & epochs.at(0.0)) != 0U);
  CHECK(epochs.at(-7200.0) == 1U);
}

TEST_CASE("more times than there are bits are refused", "[sim][epochs]") {
  std::vector<PresenceInput> many;
  const Instant first = utc("2026-06-21T10:00:00Z");
  for (int i = 0; i < 32; ++i) many.push_back({first + Seconds{60.0 * i}, std::nullopt});
  CHECK_THROWS_WITH(Epochs{scene_with(many)},
                    Catch::Contains("objects come or go at 32 different times"));
  many.pop_back();
  CHECK_NOTHROW(Epochs{scene_with(many)});
}

}  // namespace
}  // namespace nadir::sim
