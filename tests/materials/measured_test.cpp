#include "materials/scattering/measured.hpp"

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "core/error.hpp"
#include "core/random.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"
#include "support/statistics.hpp"

using namespace nadir;
using namespace nadir::materials;
using spectral::Spectrum;
using support::direction;

namespace {

constexpr double pi = std::numbers::pi, degree = pi / 180.0;

using Function = std::function<double(double incidence, double view, double azimuth, double um)>;

std::vector<double> steps(double last_deg, int count) {
  std::vector<double> axis;
  for (int i = 0; i <= count; ++i) axis.push_back(last_deg * degree * i / count);
  return axis;
}

void fill(BrdfTable& table, const Function& f) {
  table.value.clear();
  for (const double i : table.incidence_rad) {
    for (const double v : table.view_rad) {
      for (const double a : table.azimuth_rad) {
        for (const double um : table.wavelength_um) {
          table.value.push_back(static_cast<float>(f(i, v, a, um)));
        }
      }
    }
  }
}

BrdfTable table_of(const Function& f) {
  BrdfTable table{steps(80.0, 8), steps(80.0, 8), steps(180.0, 12), {0.4, 0.8, 1.6}, {}};
  fill(table, f);
  return table;
}

BoundMeasured bound(const BrdfTable& table,
                    std::vector<Micrometres> lanes = {Micrometres{0.6}, Micrometres{1.6}}) {
  const spectral::Lanes bands{std::move(lanes)};
  const Spectrum none{bands.count()};
  return {Measured{std::make_shared<const BrdfTable>(table)}, BindContext{bands, none, none}};
}

double value(const BoundMeasured& model, Vec3 wi, Vec3 wo) {
  return static_cast<double>(model.eval(wi, wo)[0]);
}

Vec3 at(double zenith, double azimuth = 0.0) { return direction(std::cos(zenith), azimuth); }

/// Smooth, reciprocal, brighter towards forward scatter; well below 1 in albedo.
double smooth_lobe(double i, double v, double a, double um) {
  return 0.1 * um * (1.0 - 0.6 * std::sin(i) * std::sin(v) * std::cos(a));
}

/// A glossy peak in the mirror direction, ten degrees wide.
double glossy(double i, double v, double a, double /*um*/) {
  const double cosine = std::cos(i) * std::cos(v) - std::sin(i) * std::sin(v) * std::cos(a);
  return 0.05 + 2.0 * std::exp((cosine - 1.0) / 0.03);
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.issues().front().message;
  }
  return "(nothing thrown)";
}

}  // namespace

TEST_CASE("a table of one value is Lambertian everywhere", "[materials][measured]") {
  const auto model = bound(table_of([](auto...) { return 0.2; }));
  Rng rng{4};
  for (int n = 0; n < 200; ++n) {
    const Vec3 wi = support::random_direction(rng), wo = support::random_direction(rng);
    CHECK(value(model, wi, wo) == Approx(0.2).epsilon(1e-5));  // float, 64 terms
  }
  CHECK(model.albedo(at(0.4)).reflectance[0] == Approx(0.2 * pi).epsilon(1e-4));
}

TEST_CASE("tabulated values are kept, and wavelengths interpolated", "[materials][measured]") {
  const auto model = bound(table_of(smooth_lobe));
  for (const double i : {10.0, 40.0, 80.0}) {
    for (const double v : {20.0, 70.0}) {
      for (const double a : {0.0, 45.0, 180.0}) {
        const Vec3 wi = at(i * degree, 0.3), wo = at(v * degree, 0.3 + a * degree);
        const double expected = smooth_lobe(i * degree, v * degree, a * degree, 0.6);
        CHECK(value(model, wi, wo) == Approx(expected).epsilon(1e-5));  // float
        CHECK(model.eval(wi, wo)[1] == Approx(expected * 1.6 / 0.6).epsilon(1e-5));
      }
    }
  }
}

// The spline's error for a sine on steps of h = 10 and 15 degrees is h^3 / 12 or less: 1.5e-3 of
// it.
TEST_CASE("between the angles a smooth function is followed", "[materials][measured]") {
  const auto model = bound(table_of(smooth_lobe));
  Rng rng{8};
  for (int n = 0; n < 500; ++n) {
    const double i = 1.39 * rng.next(), v = 1.39 * rng.next(), a = pi * rng.next();
    CHECK(value(model, at(i), at(v, a)) == Approx(smooth_lobe(i, v, a, 0.6)).epsilon(3e-3));
  }
}

TEST_CASE("value and slope are continuous across a tabulated angle", "[materials][measured]") {
  const auto model = bound(table_of(glossy));
  const Vec3 wo = at(30.0 * degree);
  const double step = 1e-3;
  for (const double zenith : {20.0, 30.0, 40.0}) {
    const auto f = [&](double offset) {
      return value(model, at(zenith * degree + offset, pi), wo);
    };
    const double below = f(0.0) - f(-step), above = f(step) - f(0.0);
    // second differences are f'' step^2, up to 1e-4 at the peak; a kink would give 1e-2
    CHECK(above == Approx(below).margin(3e-4));
  }
}

TEST_CASE("beyond the last angle the value is held", "[materials][measured]") {
  const auto model = bound(table_of(smooth_lobe));
  const double last = value(model, at(80.0 * degree), at(0.5, 1.0));
  CHECK(value(model, at(85.0 * degree), at(0.5, 1.0)) == Approx(last).epsilon(1e-6));
  CHECK(value(model, at(89.99 * degree), at(0.5, 1.0)) == Approx(last).epsilon(1e-6));
}

TEST_CASE("a table that is not reciprocal is averaged", "[materials][measured]") {
  const auto model =
      bound(table_of([](double i, double v, auto...) { return 0.03 * (1 + i + 2 * v); }));
  const Vec3 wi = at(30.0 * degree), wo = at(60.0 * degree, 2.0);
  const double mean = 0.03 * (1.0 + 1.5 * (30.0 + 60.0) * degree);
  CHECK(value(model, wi, wo) == Approx(mean).epsilon(1e-5));
  CHECK(value(model, wo, wi) == Approx(mean).epsilon(1e-5));
  Rng rng{6};
  for (int n = 0; n < 200; ++n) {
    const Vec3 a = support::random_direction(rng), b = support::random_direction(rng);
    CHECK(value(model, a, b) == Approx(value(model, b, a)).epsilon(1e-5));  // float, 64 terms
  }
}

// Light from 0, 20 and 40 degrees only: light from 70 seen at 30 is taken from 30 seen at 70.
TEST_CASE("directions measured one way round stand for the other", "[materials][measured]") {
  BrdfTable table = table_of(smooth_lobe);
  table.incidence_rad = steps(40.0, 2);
  fill(table, smooth_lobe);
  const auto model = bound(table);
  const double expected = smooth_lobe(20.0 * degree, 70.0 * degree, 1.0, 0.6);
  CHECK(value(model, at(70.0 * degree), at(20.0 * degree, 1.0)) == Approx(expected).epsilon(3e-3));
}

TEST_CASE("azimuth means nothing where a direction is vertical", "[materials][measured]") {
  const auto model =
      bound(table_of([](double, double, double a, double) { return 0.1 + 0.01 * a; }));
  const Vec3 up{0.0, 0.0, 1.0};
  const double mean = 0.1 + 0.005 * pi;
  for (const double azimuth : {0.0, 1.0, 3.0}) {
    CHECK(value(model, up, at(0.7, azimuth)) == Approx(mean).epsilon(1e-5));
  }
}

TEST_CASE("a measured surface looks the same from below and is dark across", "[materials]") {
  const auto model = bound(table_of(glossy));
  const Vec3 wi = at(0.3), wo = at(0.9, 2.0);
  const Vec3 wi_down{wi.x, wi.y, -wi.z}, wo_down{wo.x, wo.y, -wo.z};
  CHECK(value(model, wi_down, wo_down) == value(model, wi, wo));
  CHECK(model.pdf(wi_down, wo_down) == model.pdf(wi, wo));
  CHECK(model.eval(wi_down, wo).max() == 0.0F);
  CHECK(model.pdf(wi, wo_down) == 0.0);
  const auto s = model.sample(wo_down, {0.5, {0.3, 0.6}});
  REQUIRE(s.has_value());
  CHECK(s->wi.z < 0.0);
}

TEST_CASE("weights are f cos / pdf, bounded, and their mean is the albedo", "[materials]") {
  const auto model = bound(table_of(glossy));
  const double mu = GENERATE(0.1, 0.5, 0.95);
  const Vec3 wo = direction(mu, 0.3);
  Rng rng{12};
  double sum = 0.0, square = 0.0;
  constexpr int draws = 20'000;
  for (int n = 0; n < draws; ++n) {
    const Vec2 point{rng.next(), rng.next()};
    const auto s = model.sample(wo, {0.0, point});
    REQUIRE(s.has_value());
    const auto weight = static_cast<double>(s->weight[0]);
    REQUIRE(weight * s->pdf == Approx(value(model, s->wi, wo) * s->wi.z).epsilon(1e-5));
    REQUIRE(s->pdf == model.pdf(s->wi, wo));
    REQUIRE(weight < 6.0);  // a cell's mean may be below its peak; cosine draws bound the rest
    sum += weight;
    square += weight * weight;
  }
  const double mean = sum / draws, error = std::sqrt((square / draws - mean * mean) / draws);
  // 5 standard errors, and 2e-3 of the albedo for the table's own rule
  CHECK(static_cast<double>(model.albedo(wo).reflectance[0]) ==
        Approx(mean).margin(5.0 * error + 2e-3 * mean));
  CHECK(error * std::sqrt(static_cast<double>(draws)) < mean);  // the lobe is sampled: sigma < mean
}

// With the view's azimuth 0 the density's 32 x 64 cells are those of the count: no quadrature
// error.
TEST_CASE("measured directions follow their density", "[materials][measured]") {
  const auto model = bound(table_of(glossy));
  const double mu = GENERATE(0.05, 0.6, 1.0);
  const Vec3 wo = direction(mu, 0.0);
  constexpr int rows = 32, columns = 64, draws = 60'000;
  std::vector<double> expected(rows * columns), counts(rows * columns, 0.0);
  double total = 0.0;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double azimuth = 2.0 * pi * (column + 0.5) / columns;
      const double share =
          model.pdf(direction((row + 0.5) / rows, azimuth), wo) * 2.0 * pi / (rows * columns);
      expected[static_cast<std::size_t>(row * columns + column)] = share * draws;
      total += share;
    }
  }
  CHECK(total == Approx(1.0).epsilon(1e-5));  // float cells
  Rng rng{support::test_seed(), 77};
  for (int n = 0; n < draws; ++n) {
    const Vec2 point{rng.next(), rng.next()};
    const auto s = model.sample(wo, {0.0, point});
    REQUIRE(s.has_value());
    double turn = std::atan2(s->wi.y, s->wi.x) / (2.0 * pi);
    if (turn < 0.0) turn += 1.0;
    const int row = std::min(rows - 1, static_cast<int>(s->wi.z * rows));
    const int column = std::min(columns - 1, static_cast<int>(turn * columns));
    counts[static_cast<std::size_t>(row * columns + column)] += 1.0;
  }
  // about 30 draws a cell: a chance wrong by 5 % throughout a row would give p < 1e-3
  CHECK(support::chi_square_p_value(counts, expected) > support::sidak(0.001, 3));
}

TEST_CASE("a black table is drawn by its cosine", "[materials][measured]") {
  const auto model = bound(table_of([](auto...) { return 0.0; }));
  const auto s = model.sample(at(0.5), {0.0, {0.3, 0.4}});
  REQUIRE(s.has_value());
  CHECK(s->weight.max() == 0.0F);
}

TEST_CASE("tables that gain energy or do not cover the lanes are refused", "[materials]") {
  CHECK_THAT(message_of([] { (void)bound(table_of([](auto...) { return 1.03 / pi; })); }),
             Catch::Matchers::StartsWith("measured: it reflects 1.03 of the light"));
  CHECK_NOTHROW(bound(table_of([](auto...) { return 1.01 / pi; })));
  CHECK(message_of([] { (void)bound(table_of(smooth_lobe), {Micrometres{1.7}}); }) ==
        "the measured reflectance is tabulated from 0.4 to 1.6 um, but the bands need it at 1.7 "
        "um");
}

TEST_CASE("tables with impossible axes or values are refused", "[materials][measured]") {
  const auto message = [](auto change) {
    BrdfTable table = table_of(smooth_lobe);
    change(table);
    return message_of([&] { (void)bound(table); });
  };
  using T = BrdfTable&;
  CHECK(message([](T t) { t.value.pop_back(); }) ==
        "the measured reflectance has 3158 values; its axes need 3159");
  CHECK(message([](T t) { t.value[5] = -0.1F; }) ==
        "the measured reflectance holds a value that is negative or not finite");
  CHECK(message([](T t) { t.view_rad[3] = t.view_rad[2]; }) ==
        "the view angles of the measured reflectance do not ascend");
  CHECK(message([](T t) { t.incidence_rad[0] = 0.01; }) ==
        "the angles of incidence of the measured reflectance must run from 0 to at most 90 "
        "degrees");
  CHECK(message([](T t) { t.azimuth_rad.back() = 3.0; }) ==
        "the relative azimuths of the measured reflectance must run from 0 to 180 degrees");
  CHECK(message([](T t) { t.wavelength_um.clear(); }) ==
        "the measured reflectance needs at least 1 wavelengths");
}
