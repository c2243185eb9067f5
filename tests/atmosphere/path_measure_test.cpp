#include "atmosphere/paths/path_measure.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "atmosphere/paths/spherical_path.hpp"
#include "support/catch.hpp"

namespace {

using namespace nadir::atmosphere;

/// The integral along the line by Gauss-Legendre quadrature in many short steps.
double by_quadrature(PathPoint from, double length_m) {
  const double node[] = {-0.9061798459386640, -0.5384693101056831, 0.0, 0.5384693101056831,
                         0.9061798459386640};
  const double weight[] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                           0.4786286704993665, 0.2369268850561891};
  const int steps = 40 + static_cast<int>(length_m / 500.0);
  const double step = length_m / steps;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    for (int k = 0; k < 5; ++k) {
      const double z = advanced(from, step * (i + 0.5 * (1.0 + node[k]))).height_m;
      const double w = z * (1.0 + z / (2.0 * earth_radius_m));
      sum += 0.5 * weight[k] * step * std::exp(-w / measure_scale_m);
    }
  }
  return sum;
}

double measure(PathPoint from, double length_m) {
  return air_measure_m(from.height_m, advanced(from, length_m).height_m, length_m);
}

}  // namespace

// The quadrature is good to 1e-13; 3e-12 is what the header promises. The heights of ends 1 m apart
// on a line of 10 km are given to 1e-12 m: nothing is lost there.
TEST_CASE("the measure is the integral of the air along the line", "[atmosphere][paths]") {
  for (const double height_m : {-400.0, 0.0, 2.0, 3000.0, 20e3, 80e3}) {
    for (const double mu : {-1.0, -0.5, -0.06, -0.03, -0.002, 0.0, 0.001, 0.1, 0.4, 1.0}) {
      for (const double length_m : {1e-3, 10.0, 2e3, 30e3, 33e3, 60e3, 300e3}) {
        if (advanced({height_m, mu}, length_m).height_m < -500.0) continue;
        CAPTURE(height_m, mu, length_m);
        CHECK(measure({height_m, mu}, length_m) ==
              Approx(by_quadrature({height_m, mu}, length_m)).epsilon(3e-12));
      }
    }
  }
}

TEST_CASE("the measure of a vertical way is the air's column", "[atmosphere][paths]") {
  // int_0^z exp(-(z + z^2 / 2R) / H) dz is H (1 - exp(-z/H)) to H / R
  CHECK(air_measure_m(0.0, 100e3, 100e3) == Approx(8000.0).epsilon(2.0 * 8000.0 / earth_radius_m));
  CHECK(air_measure_m(0.0, 1e-3, 1e-3) == Approx(1e-3).epsilon(1e-6));
  CHECK(air_measure_m(0.0, 36e6, 36e6) == Approx(air_measure_m(0.0, 2e5, 2e5)).epsilon(1e-9));
  CHECK(air_measure_m(5.0, 5.0, 0.0) == 0.0);
}

TEST_CASE("both directions of travel measure alike", "[atmosphere][paths]") {
  CHECK(air_measure_m(10.0, 900.0, 5e4) == air_measure_m(900.0, 10.0, 5e4));
}

TEST_CASE("the measures of pieces add up to the whole and grow all along", "[atmosphere][paths]") {
  for (const double mu : {-0.5, -0.05, -0.0355, 0.0, 0.02, 0.9}) {
    const PathPoint eye{4e3, mu};
    const double whole_m = way_to_end_m(100e3, 0.0, eye.height_m, mu);
    double sum = 0.0, before = 0.0;
    const int steps = 37;
    for (int i = 0; i < steps; ++i) {
      CAPTURE(mu, i);
      const double from = whole_m * i / steps, to = whole_m * (i + 1) / steps;
      const PathPoint a = advanced(eye, from), b = advanced(eye, to);
      sum += air_measure_m(a.height_m, b.height_m, to - from);
      const double here = measure(eye, to);
      CHECK(here == Approx(sum).epsilon(1e-11));
      CHECK(here > before);
      before = here;
    }
  }
}

// An eye at 36,000 km sees the air's column when it looks down, and twice a half at the limb.
TEST_CASE("satellites measure the air and nothing else", "[atmosphere][paths]") {
  CHECK(air_measure_m(36e6, 0.0, 36e6) == Approx(air_measure_m(100e3, 0.0, 100e3)).epsilon(1e-5));
  const double half = air_measure_m(0.0, 100e3, way_to_end_m(100e3, 0.0, 0.0, 0.0));
  const double far_m = way_up_to_m({0.0, 0.0}, 36e6);
  CHECK(air_measure_m(36e6, 36e6, 2.0 * far_m) == Approx(2.0 * half).epsilon(1e-5));
}
