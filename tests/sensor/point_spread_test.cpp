#include "sensor/optics/point_spread.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "sensor/optics/annular_aperture.hpp"
#include "support/catch.hpp"
#include "support/statistics.hpp"

namespace nadir::sensor {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double um = 1e-6;

spectral::Response box(double lo_um, double hi_um) {
  return spectral::BoxResponse{Micrometres{lo_um}, Micrometres{hi_um}};
}
const std::vector<spectral::Response> one_band{box(0.5, 0.6)};
const std::vector<spectral::Response> two_bands{box(0.45, 0.52), box(0.76, 0.9)};
const std::vector<spectral::Response> three_bands{box(0.4, 0.9), box(0.5, 0.52), box(2.1, 2.3)};

SpreadDescription diffraction(double f_number, double obscuration) {
  SpreadDescription description;
  description.diffraction = DiffractionSpread{f_number, obscuration};
  return description;
}
SpreadDescription gaussian(double x_um, double y_um) {
  SpreadDescription description;
  description.gaussians = {{x_um * um, y_um * um}};
  return description;
}
/// Two pictures that are like nothing but themselves: neither even nor symmetrical.
TabulatedSpread picture(int slices) {
  TabulatedSpread table{3, 2, 4.0 * um, {{0.45, {0.05, 0.4, 0.1, 0.0, 0.3, 0.15}}}};
  if (slices == 2) table.slices.push_back({0.85, {0.3, 0.1, 0.1, 0.2, 0.05, 0.25}});
  return table;
}
SpreadDescription tabulated(int slices) {
  SpreadDescription description;
  description.table = picture(slices);
  return description;
}
SpreadDescription with_stray(SpreadDescription description, double share) {
  description.stray = StraySpread{share, 3.0 * um, 1.5, 300.0 * um};
  return description;
}

/// Many draws: one scrambled low-discrepancy set.
template <class Of>
void every_draw(const PointSpread& spread, std::uint32_t draws, const Of& of) {
  for (std::uint32_t i = 0; i < draws; ++i) {
    of(spread.draw(Sampler{support::test_seed(), i}, 3));
  }
}

constexpr std::array<Vec2, 6> frequencies_per_m{Vec2{5e3, 0.0}, {2e4, 0.0},  {0.0, 6e4},
                                                {1e5, 0.0},     {6e4, -8e4}, {3e5, 1e5}};

/// The largest difference between the transfer function and the size of the weighted mean of
/// exp(2 pi i f d), over all bands and frequencies.
double worst_modulation(const SpreadDescription& description,
                        const std::vector<spectral::Response>& bands,
                        std::uint32_t draws = 1U << 15) {
  const PointSpread spread{description, bands};
  std::vector<std::array<std::complex<double>, frequencies_per_m.size()>> sums(bands.size());
  std::vector<double> weights(bands.size());
  every_draw(spread, draws, [&](const PointSpread::Draw& drawn) {
    spread.weights(drawn, weights);
    for (std::size_t f = 0; f < frequencies_per_m.size(); ++f) {
      const Vec2 frequency = frequencies_per_m[f], d = drawn.displacement_m;
      const auto turn = std::polar(1.0, 2.0 * pi * (frequency.x * d.x + frequency.y * d.y));
      for (std::size_t b = 0; b < bands.size(); ++b) sums[b][f] += weights[b] * turn;
    }
  });
  double worst = 0.0;
  for (std::size_t b = 0; b < bands.size(); ++b) {
    for (std::size_t f = 0; f < frequencies_per_m.size(); ++f) {
      const double drawn = std::abs(sums[b][f]) / draws;
      const double expected = spread.mtf(b, frequencies_per_m[f]);
      UNSCOPED_INFO("band " << b << ", frequency " << f << ": " << drawn << " for " << expected);
      worst = std::max(worst, std::abs(drawn - expected));
    }
  }
  return worst;
}

// 32768 even draws. Points of one dimension are even among themselves; what several dimensions (and
// weights, which vary) have in common has the noise of a mean, 1 / sqrt(2 draws) = 0.004 at most:
// 2.5 of these. The seed is fixed; the slow test below is sharper.
constexpr double noise = 0.01;

TEST_CASE("what is drawn has the transfer function that is told", "[sensor][spread]") {
  CHECK(worst_modulation(gaussian(2.0, 3.0), one_band) < 1e-3);  // one point decides
  CHECK(worst_modulation(diffraction(4.0, 0.0), one_band) < noise);
  CHECK(worst_modulation(diffraction(8.0, 0.5), one_band) < noise);
  CHECK(worst_modulation(tabulated(1), one_band) < noise);
  CHECK(worst_modulation(with_stray(gaussian(1.0, 1.0), 0.4), one_band) < noise);
}

TEST_CASE("weights give each band its own transfer function", "[sensor][spread]") {
  CHECK(worst_modulation(diffraction(4.0, 0.7), two_bands) < noise);
  CHECK(worst_modulation(diffraction(4.0, 0.95), two_bands) < noise);
  CHECK(worst_modulation(diffraction(6.0, 0.3), three_bands) < noise);
  CHECK(worst_modulation(tabulated(2), two_bands) < noise);
}

SpreadDescription all_of_them() {
  SpreadDescription all = with_stray(diffraction(4.0, 0.3), 0.1);
  all.gaussians = {{1.0 * um, 2.0 * um}, {1.5 * um, 0.5 * um}};
  return all;
}

TEST_CASE("all kinds together multiply their transfer functions", "[sensor][spread]") {
  SpreadDescription all = all_of_them();
  CHECK(worst_modulation(all, two_bands) < noise);
  all.diffraction.reset();
  all.table = picture(2);
  CHECK(worst_modulation(all, two_bands) < noise);
}

// Four million draws: noise of 4e-4 at most, three and a half of them.
TEST_CASE("no bias shows in millions of draws", "[.slow][sensor][spread]") {
  constexpr std::uint32_t many = 1U << 22;
  CHECK(worst_modulation(diffraction(4.0, 0.7), two_bands, many) < 1.4e-3);
  CHECK(worst_modulation(diffraction(4.0, 0.95), two_bands, many) < 1.4e-3);
  CHECK(worst_modulation(diffraction(6.0, 0.3), three_bands, many) < 1.4e-3);
  CHECK(worst_modulation(tabulated(2), two_bands, many) < 1.4e-3);
  CHECK(worst_modulation(all_of_them(), two_bands, many) < 1.4e-3);
}

TEST_CASE("the transfer function at no frequency is one", "[sensor][spread]") {
  for (const SpreadDescription& description :
       {with_stray(diffraction(4.0, 0.3), 0.1), with_stray(tabulated(2), 0.5),
        SpreadDescription{}}) {
    CHECK(PointSpread{description, one_band}.mtf(0, {}) == Approx(1.0).epsilon(1e-12));
  }
}

TEST_CASE("Gaussians add up in their squares", "[sensor][spread]") {
  SpreadDescription description;
  description.gaussians = {{3.0 * um, 0.0}, {4.0 * um, 2.0 * um}};
  const PointSpread spread{description, one_band};
  double xx = 0.0, yy = 0.0;
  constexpr std::uint32_t draws = 1U << 14;
  every_draw(spread, draws, [&](const PointSpread::Draw& drawn) {
    xx += drawn.displacement_m.x * drawn.displacement_m.x;
    yy += drawn.displacement_m.y * drawn.displacement_m.y;
  });
  CHECK(std::sqrt(xx / draws) == Approx(5.0 * um).epsilon(3e-3));  // the tail's last stratum
  CHECK(std::sqrt(yy / draws) == Approx(2.0 * um).epsilon(3e-3));
  // A standard deviation, not a width: exp(-2 pi^2 sigma^2 f^2).
  CHECK(spread.mtf(0, {4e4, 0.0}) == Approx(std::exp(-2.0 * pi * pi * 0.04)).epsilon(1e-12));
}

// At wavelength lambda nothing passes beyond 1 / (lambda N); half of it passes 0.391.
TEST_CASE("diffraction cuts off where wavelength and focal ratio say", "[sensor][spread]") {
  const PointSpread spread{diffraction(5.0, 0.0), {box(0.999, 1.001)}};
  CHECK(spread.mtf(0, {0.5 / (5.0 * um), 0.0}) == Approx(0.39100).margin(1e-4));
  CHECK(spread.mtf(0, {0.0, 0.998 / (5.0 * um)}) > 0.0);
  CHECK(spread.mtf(0, {0.0, 1.002 / (5.0 * um)}) == 0.0);
  // 83.8 % of the draws within 1.22 lambda N, 6.10 um; even draws: to 1e-3.
  int inside = 0;
  every_draw(spread, 1U << 14, [&](const PointSpread::Draw& drawn) {
    inside += std::hypot(drawn.displacement_m.x, drawn.displacement_m.y) < 6.098 * um ? 1 : 0;
  });
  CHECK(inside / double{1U << 14} == Approx(0.838).margin(1e-3));
}

TEST_CASE("weights average to one and never exceed the number of bands", "[sensor][spread]") {
  for (const SpreadDescription& description :
       {diffraction(6.0, 0.4), tabulated(2), with_stray(diffraction(6.0, 0.0), 0.2)}) {
    const PointSpread spread{description, three_bands};
    REQUIRE(spread.depends_on_band());
    std::array<double, 3> sum{}, weights{};
    bool legal = true;
    constexpr std::uint32_t draws = 1U << 15;
    every_draw(spread, draws, [&](const PointSpread::Draw& drawn) {
      spread.weights(drawn, weights);
      double all = 0.0;
      for (std::size_t b = 0; b < 3; ++b) {
        legal = legal && weights[b] >= 0.0 && weights[b] <= 3.0 + 1e-12;
        sum[b] += weights[b];
        all += weights[b];
      }
      legal = legal && std::abs(all - 3.0) < 1e-9;  // what one band gains the others lose
    });
    CHECK(legal);
    for (const double s : sum) CHECK(s / draws == Approx(1.0).margin(noise));
  }
}

TEST_CASE("bands with one function count alike", "[sensor][spread]") {
  CHECK_FALSE(PointSpread{diffraction(4.0, 0.2), one_band}.depends_on_band());
  CHECK_FALSE(PointSpread{tabulated(1), two_bands}.depends_on_band());
  CHECK_FALSE(PointSpread{gaussian(1.0, 1.0), two_bands}.depends_on_band());
  std::array<double, 2> weights{};
  const PointSpread spread{tabulated(1), two_bands};
  spread.weights(spread.draw(Sampler{1, 1}, 0), weights);
  CHECK(weights == std::array<double, 2>{1.0, 1.0});
}

// Pearson's test over 24 rings with weighted counts: sum w^2 is the variance of a ring's weighted
// count, n p (E[w^2] - p) at most; (sum w - n p)^2 / sum w^2 sums to a chi-square of 24 degrees
// but for a correlation of order p. Seed fixed, false alarm 1e-4 for both bands together.
TEST_CASE("weighted draws have each band's own radii", "[sensor][spread]") {
  const PointSpread spread{diffraction(4.0, 0.3), two_bands};
  const AnnularAperture aperture{0.3};
  const std::array<double, 2> lo{0.45, 0.76}, hi{0.52, 0.9};
  constexpr int rings = 24, draws = 200'000;
  constexpr double width = 0.5 * um;
  std::array<std::array<double, rings>, 2> sum{}, squares{};
  std::array<double, 2> weights{};
  for (int i = 0; i < draws; ++i) {
    const Sampler numbers{mix(support::test_seed(), static_cast<std::uint64_t>(i)), 0};
    const PointSpread::Draw drawn = spread.draw(numbers, 0);
    const double r = std::hypot(drawn.displacement_m.x, drawn.displacement_m.y);
    const auto ring = static_cast<std::size_t>(r / width);
    if (ring >= rings) continue;
    spread.weights(drawn, weights);
    for (std::size_t b = 0; b < 2; ++b) {
      sum[b][ring] += weights[b];
      squares[b][ring] += weights[b] * weights[b];
    }
  }
  for (std::size_t b = 0; b < 2; ++b) {
    double statistic = 0.0;
    for (std::size_t ring = 0; ring < rings; ++ring) {
      double expected = 0.0;  // of the light between two radii, over the band's wavelengths
      constexpr int wavelengths = 200;
      for (int k = 0; k < wavelengths; ++k) {
        const double lambda_m = (lo[b] + (hi[b] - lo[b]) * (k + 0.5) / wavelengths) * um;
        const double per_m = pi / (lambda_m * 4.0), at = static_cast<double>(ring);
        expected +=
            aperture.encircled((at + 1.0) * width * per_m) - aperture.encircled(at * width * per_m);
      }
      expected *= static_cast<double>(draws) / wavelengths;
      const double miss = sum[b][ring] - expected;
      statistic += miss * miss / squares[b][ring];
    }
    CAPTURE(b, statistic);
    CHECK(support::chi_square_tail(statistic, rings) > support::sidak(1e-4, 2));
  }
}

// The picture of a point says where light is thrown; a detector looks back along that way.
TEST_CASE("a detector looks against the way in which a picture throws light", "[sensor][spread]") {
  SpreadDescription description;  // all light goes to image right and down
  description.table = TabulatedSpread{3, 3, 2.0 * um, {{0.5, {0, 0, 0, 0, 0, 0, 0, 0, 1}}}};
  const PointSpread spread{description, one_band};
  every_draw(spread, 100, [&](const PointSpread::Draw& drawn) {
    CHECK(drawn.displacement_m.x == Approx(-2.0 * um).margin(1.0001 * um));
    CHECK(drawn.displacement_m.y == Approx(-2.0 * um).margin(1.0001 * um));
  });
}

TEST_CASE("a table's cells get their share of the draws", "[sensor][spread]") {
  const PointSpread spread{tabulated(1), one_band};
  const std::vector<double>& weights = spread.description().table->slices[0].weights;
  std::vector<double> found(6);
  constexpr std::uint32_t draws = 1U << 14;
  every_draw(spread, draws, [&](const PointSpread::Draw& drawn) {
    const auto column = static_cast<std::size_t>(1.5 - drawn.displacement_m.x / (4.0 * um));
    const auto row = static_cast<std::size_t>(1.0 - drawn.displacement_m.y / (4.0 * um));
    found.at(row * 3 + column) += 1.0 / draws;
  });
  for (std::size_t i = 0; i < 6; ++i) CHECK(found[i] == Approx(weights[i]).margin(2.0 / draws));
}

TEST_CASE("a band's picture lies between those of the wavelengths about it", "[sensor][spread]") {
  SpreadDescription description;  // all in the left cell at 0.4 um, in the right one at 0.8 um
  description.table = TabulatedSpread{2, 1, 2.0 * um, {{0.4, {1.0, 0.0}}, {0.8, {0.0, 1.0}}}};
  const PointSpread spread{description, {box(0.3, 0.35), box(0.49, 0.51), box(0.9, 1.0)}};
  std::array<double, 3> weights{}, right{};
  constexpr std::uint32_t draws = 1U << 12;
  every_draw(spread, draws, [&](const PointSpread::Draw& drawn) {
    spread.weights(drawn, weights);
    for (std::size_t b = 0; b < 3; ++b) {
      if (drawn.displacement_m.x < 0.0) right[b] += weights[b] / draws;
    }
  });
  CHECK(right[0] == 0.0);
  CHECK(right[1] == Approx(0.25).margin(1e-3));
  CHECK(right[2] == Approx(1.0).margin(1e-3));
}

std::string refusal(const SpreadDescription& description,
                    const std::vector<spectral::Response>& bands = one_band) {
  try {
    const PointSpread spread{description, bands};
    return "(accepted)";
  } catch (const InputError& error) {
    const std::string text = error.what();  // "error: ... \n"
    return text.substr(7, text.size() - 8);
  }
}

TEST_CASE("a table that cannot be the picture of a point is refused", "[sensor][spread]") {
  const auto with = [](const TabulatedSpread& table) {
    SpreadDescription description;
    description.table = table;
    return refusal(description);
  };
  CHECK(with(picture(2)) == "(accepted)");
  TabulatedSpread table = picture(1);
  table.slices[0].weights[1] = 0.5;
  CHECK(with(table) == "the point-spread function at 0.45 um sums to 1.1, not to one");
  table.slices[0].weights[1] = 0.4009;  // rounding
  CHECK(with(table) == "(accepted)");
  table.slices[0].weights[1] = -0.4;
  CHECK(
      with(table) ==
      "the point-spread function at 0.45 um has a weight of -0.4; light cannot be less than none");
  table.slices[0].weights[1] = std::numeric_limits<double>::quiet_NaN();
  CHECK(with(table).find("has a weight of nan") != std::string::npos);
  table.slices[0].weights.pop_back();
  CHECK(with(table) == "the point-spread function at 0.45 um has 5 weights for 6 cells");
  table = picture(2);
  std::swap(table.slices[0], table.slices[1]);
  CHECK(with(table) == "the wavelengths of a point-spread function must be positive and ascend");
  const std::string empty =
      "a table of a point-spread function needs cells, their pitch and a wavelength";
  table = picture(1);
  table.pitch_m = 0.0;
  CHECK(with(table) == empty);
  table.pitch_m = std::numeric_limits<double>::infinity();
  CHECK(with(table) == empty);
  CHECK(with({}) == empty);
}

TEST_CASE("figures of the optics out of range are refused", "[sensor][spread]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  SpreadDescription both = diffraction(4.0, 0.0);
  both.table = picture(1);
  CHECK(refusal(both) ==
        "a table of the point-spread function holds the diffraction already: give one of them");
  for (const double f_number : {0.0, -4.0, 1e5, nan}) {
    CHECK(refusal(diffraction(f_number, 0.0)) == "the focal ratio must lie in 0.1 .. 10000");
  }
  for (const double e : {-0.1, 0.96, nan}) {
    CHECK(refusal(diffraction(4.0, e)) == "the obscuration must lie in 0 .. 0.95");
  }
  for (const double sigma_um : {-1.0, 1e11, nan}) {
    CHECK(refusal(gaussian(1.0, sigma_um)) ==
          "the blur's standard deviation must lie in 0 .. 10000 m");
  }
  CHECK(refusal(gaussian(15e6, 15e6)) == "(accepted)");  // metres of an orthographic camera
  for (const double share : {-0.1, 1.0, nan}) {
    CHECK(refusal(with_stray({}, share)) == "the stray light's share must lie in 0 .. 0.999");
  }
  for (const StraySpread& stray :
       {StraySpread{0.1, 0.0, 1.5, 1.0}, StraySpread{0.1, 1.0, 1.5, 1.0},
        StraySpread{0.1, 1.0, -1.0, 2.0}, StraySpread{0.1, nan, 1.5, 2.0},
        StraySpread{0.1, 1.0, 1.5, 1e5}}) {
    SpreadDescription description;
    description.stray = stray;
    CHECK(refusal(description) ==
          "stray light needs 0 < core < reach <= 10000 m and a slope in 0 .. 20");
  }
  CHECK(refusal({}, {}) == "a point-spread function needs the bands that it serves");
}

}  // namespace
}  // namespace nadir::sensor
