#include "radiometry/importance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/diagnostics.hpp"
#include "support/catch.hpp"
#include "support/quadrature.hpp"

using namespace nadir;
using radiometry::ImportanceSource;
using radiometry::ImportanceTable;
using radiometry::QuadHemisphere;

namespace {

using Function = double (*)(Vec3 wi, Vec3 wo);

std::vector<double> importance(const ImportanceTable& table, Vec3 wo) {
  std::vector<double> of_quads(static_cast<std::size_t>(table.quads()));
  table.importance(wo, of_quads.data());
  return of_quads;
}

double total(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double x : values) sum += x;
  return sum;
}

/// Rough mirror of GGX facets with height-correlated Smith masking, f |cos|: closed form.
/// Source: Walter et al., EGSR 2007, with F = 1; masking: Heitz, JCGT 3(2), 48 (2014), eq. 99.
ImportanceSource ggx(double alpha) {
  ImportanceSource source;
  source.scattered = [alpha](Vec3 wi, Vec3 wo) {
    if (wi.z * wo.z <= 0.0) return 0.0;
    const Vec3 h = normalised(wi + wo);
    const double a2 = alpha * alpha, t = h.z * h.z * (a2 - 1.0) + 1.0;
    const auto lambda = [a2](double mu) {
      return 0.5 * (std::sqrt(1.0 + a2 * (1.0 - mu * mu) / (mu * mu)) - 1.0);
    };
    const double d = a2 / (std::numbers::pi * t * t);
    return d / (1.0 + lambda(wi.z) + lambda(wo.z)) / (4.0 * std::fabs(wo.z));
  };
  return source;
}

ImportanceSource diffuse(double reflectance, double transmittance) {
  ImportanceSource source;
  source.scattered = [=](Vec3 wi, Vec3 wo) {
    return (wi.z * wo.z > 0.0 ? reflectance : transmittance) * std::fabs(wi.z) / std::numbers::pi;
  };
  source.transmits = transmittance > 0.0;
  return source;
}

}  // namespace

TEST_CASE("a Lambertian surface needs one part, whose importances are the quads' cosines",
          "[radiometry][importance]") {
  const QuadHemisphere quads{10, 20};
  const ImportanceTable table{diffuse(0.6, 0.0), quads};
  CHECK(table.rank() == 1);
  CHECK(table.error() < 1e-6);
  CHECK(table.peakedness() == 1.0);
  const Vec3 wo = support::direction(GENERATE(1e-6, 0.05, 0.5, 0.83, 1.0), 1.1);
  const std::vector<double> of_quads = importance(table, wo);
  for (int quad = 0; quad < quads.count(); ++quad) {
    // The mean cosine of a quad is that of its centre; tables are in float.
    CHECK(of_quads[static_cast<std::size_t>(quad)] ==
          Approx(0.6 * quads.centre(quad).z / std::numbers::pi).epsilon(1e-5));
  }
  CHECK(total(of_quads) * quads.solid_angle() == Approx(0.6).epsilon(1e-5));
}

TEST_CASE("a material gives the same table as its closed form", "[radiometry][importance]") {
  materials::Material material;
  material.reflectance = spectral::Curve::constant(0.6);
  Diagnostics diagnostics;
  const spectral::Lanes lanes{{Micrometres{0.5}, Micrometres{0.7}}};
  const QuadHemisphere quads{6, 8};
  const ImportanceTable table{materials::bind(material, lanes, diagnostics), quads};
  const ImportanceTable closed{diffuse(0.6, 0.0), quads};
  CHECK(table.quads() == 48);
  const Vec3 wo = support::direction(0.7, 0.2);
  const auto a = importance(table, wo), b = importance(closed, wo);
  for (std::size_t q = 0; q < a.size(); ++q) CHECK(a[q] == Approx(b[q]).epsilon(1e-5));
}

TEST_CASE("a leaf's importances lie on both sides, wherever it is seen from",
          "[radiometry][importance]") {
  const QuadHemisphere quads{10, 20};
  const ImportanceTable table{diffuse(0.5, 0.3), quads};
  CHECK(table.quads() == 400);
  const bool above = GENERATE(true, false);
  const Vec3 wo = support::direction(above ? 0.6 : -0.6, 2.0);
  const std::vector<double> of_quads = importance(table, wo);
  const auto below = of_quads.begin() + 200;
  const double upper = total({of_quads.begin(), below}), lower = total({below, of_quads.end()});
  // 0.1 %: the floor under the rim's quads on the side of transmission.
  CHECK(upper * quads.solid_angle() == Approx(above ? 0.5 : 0.3).epsilon(1e-3));
  CHECK(lower * quads.solid_angle() == Approx(above ? 0.3 : 0.5).epsilon(1e-3));
  CHECK(table.turn(wo).side == 1.0);
}

TEST_CASE("an opaque surface looks alike from behind, with its quads mirrored",
          "[radiometry][importance]") {
  const ImportanceTable table{ggx(0.4), {10, 20}};
  CHECK(table.quads() == 200);
  const Vec3 wo = support::direction(0.4, 0.9), behind{wo.x, wo.y, -wo.z};
  CHECK(importance(table, wo) == importance(table, behind));
  CHECK(table.turn(wo)({0.0, 0.6, 0.8}).z == 0.8);
  CHECK(table.turn(behind)({0.0, 0.6, 0.8}).z == -0.8);
}

// The quad with the largest importance of a lobe that fits into it is the one that the mirror
// direction lies in or next to; quads are counted from the azimuth of the view.
TEST_CASE("the importance peaks where the mirror direction is", "[radiometry][importance]") {
  const QuadHemisphere quads{10, 20};
  const ImportanceTable table{ggx(0.1), quads};
  const Vec3 wo = support::direction(GENERATE(0.25, 0.5, 0.75), GENERATE(0.0, 1.0, 4.0));
  const std::vector<double> of_quads = importance(table, wo);
  const auto largest = std::max_element(of_quads.begin(), of_quads.end()) - of_quads.begin();
  const Vec3 peak = table.turn(wo)(quads.centre(static_cast<int>(largest)));
  // Half a quad's diagonal, 0.17 to 0.2 rad, and a little for lobes tilted to the rim.
  CHECK(dot(peak, Vec3{-wo.x, -wo.y, wo.z}) > std::cos(0.25));
  const Vec3 back = table.turn(wo).back(table.turn(wo)({0.1, 0.2, 0.3}));
  CHECK(length(back - Vec3{0.1, 0.2, 0.3}) < 1e-15);
}

TEST_CASE("importances are the means over their quads, to the stated error",
          "[radiometry][importance]") {
  const double alpha = GENERATE(0.8, 0.3, 0.2);
  const QuadHemisphere quads{10, 20};
  const ImportanceSource source = ggx(alpha);
  const ImportanceTable table{source, quads, 0.05};
  CAPTURE(alpha, table.rank(), table.error());
  CHECK(table.error() <= 0.055);
  CHECK(table.rank() <= 8);
  CHECK(table.memory_bytes() < 24 * 200 * sizeof(float) / 2);            // half of the full table
  const Vec3 wo = support::direction(20.5 * 20.5 / (23.5 * 23.5), 0.0);  // a tabulated view
  const std::vector<double> of_quads = importance(table, wo);
  double left = 0.0, all = 0.0;
  for (int quad = 0; quad < quads.count(); ++quad) {
    double mean = 0.0;
    for (int i = 0; i < 64; ++i) {
      mean +=
          source.scattered(quads.direction(quad, {(i % 8 + 0.5) / 8.0, (i / 8 + 0.5) / 8.0}), wo) /
          64.0;
    }
    left += std::pow(of_quads[static_cast<std::size_t>(quad)] - mean, 2);
    all += mean * mean;
  }
  // The error is a mean over views: one may have twice of it.
  CHECK(std::sqrt(left / all) < 0.1);
}

// Energy: the facets' visible area is conserved but for what multiple scattering would carry, so
// that the total of smooth ones is 1. Views from 82 degrees up: closer to the horizon lobes get so
// oblong that their ends are missed (20 % at 86 degrees), which peakedness leaves out as well.
TEST_CASE("a lobe far narrower than a quad is found, and none of its energy is lost",
          "[radiometry][importance]") {
  const double alpha = GENERATE(0.02, 1e-3, 1e-4);
  const QuadHemisphere quads{10, 20};
  const ImportanceTable table{ggx(alpha), quads};
  for (const int node : {8, 14, 20, 23}) {
    const double root = (node + 0.5) / 23.5;
    const auto of_quads = importance(table, support::direction(root * root, 0.7));
    CAPTURE(alpha, node);
    // The floor adds up to 2 %, the quadrature loses up to 5 % at 82 degrees.
    CHECK(total(of_quads) * quads.solid_angle() == Approx(1.0).epsilon(0.06));
  }
}

TEST_CASE("peakedness parts lobes that fill their quads from narrow ones",
          "[radiometry][importance]") {
  const QuadHemisphere quads{10, 20};
  for (const double alpha : {1.0, 0.5, 0.3}) {
    CAPTURE(alpha);
    CHECK(ImportanceTable{ggx(alpha), quads}.peakedness() < radiometry::lobe_is_narrow);
  }
  double wider = radiometry::lobe_is_narrow;
  for (const double alpha : {0.2, 0.15, 0.1, 0.05, 0.01, 1e-3, 1e-4}) {
    CAPTURE(alpha);
    const double peakedness = ImportanceTable{ggx(alpha), quads}.peakedness();
    CHECK(peakedness > wider);  // and ever more so
    wider = peakedness;
  }
  // The cosine within few and large quads stays below 2.
  CHECK(ImportanceTable{diffuse(0.5, 0.0), {2, 4}}.peakedness() < 2.0);
}

TEST_CASE("a narrow lobe that the mirror direction does not show is found where it is drawn",
          "[radiometry][importance]") {
  const QuadHemisphere quads{10, 20};
  // A cap of 0.01 rad around a direction off the plane of view.
  const Vec3 axis = support::direction(0.63, 1.234);
  ImportanceSource source;
  source.anisotropic = true;
  source.scattered = [axis](Vec3 wi, Vec3) { return dot(wi, axis) > std::cos(0.01) ? 1e3 : 0.0; };
  source.likely = [axis](Vec3, int) { return axis; };
  const ImportanceTable table{source, quads};
  CHECK(table.peakedness() > 50.0);  // 0.0314 sr / (pi 1e-4 sr) = 100 if it lies in one quad
  // Where to find it does not depend on the view, but the quads turn with it.
  const Vec3 wo = support::direction(1.0, 0.0);
  const std::vector<double> of_quads = importance(table, wo);
  const auto largest = std::max_element(of_quads.begin(), of_quads.end()) - of_quads.begin();
  CHECK(static_cast<int>(largest) == quads.place(axis).quad);
}

TEST_CASE("no quad is starved, and a black surface has no importance at all",
          "[radiometry][importance]") {
  const ImportanceTable table{ggx(0.1), {10, 20}};
  const std::vector<double> of_quads = importance(table, support::direction(0.5, 0.3));
  const double least = *std::min_element(of_quads.begin(), of_quads.end());
  CHECK(least >= 0.0199 * total(of_quads) / 200.0 / 1.02);  // 2 % of the mean before the floor
  const ImportanceTable black{diffuse(0.0, 0.0), {10, 20}};
  CHECK(black.rank() == 0);
  CHECK(black.peakedness() == 1.0);
  CHECK(total(importance(black, support::direction(0.5, 0.3))) == 0.0);
}

TEST_CASE("between tabulated views importances change steadily", "[radiometry][importance]") {
  ImportanceSource source = ggx(0.3);
  source.anisotropic = GENERATE(false, true);
  const ImportanceTable table{source, {5, 8}};
  std::vector<double> before = importance(table, support::direction(0.0, 0.0));
  double largest_step = 0.0;
  for (int i = 1; i <= 2000; ++i) {
    const std::vector<double> now = importance(table, support::direction(i / 2000.0, i / 300.0));
    double step = 0.0;
    for (std::size_t q = 0; q < now.size(); ++q) step += std::fabs(now[q] - before[q]);
    largest_step = std::max(largest_step, step / total(now));
    before = now;
  }
  // A jump from one node to the next would be of order 0.3; near mu = 0 the square root is steep.
  CHECK(largest_step < 0.1);
}

// A number that is none, from a model at the edge of its domain, must not spoil the rest.
TEST_CASE("values that are not numbers leave a sound table", "[radiometry][importance]") {
  ImportanceSource source = diffuse(0.5, 0.0);
  source.scattered = [inner = source.scattered](Vec3 wi, Vec3 wo) {
    return wi.z < 0.1 ? std::nan("") : inner(wi, wo);
  };
  const ImportanceTable table{source, {10, 20}};
  for (const double x : importance(table, support::direction(0.5, 0.0))) {
    CHECK(std::isfinite(x));
  }
}
