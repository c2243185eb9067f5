#include "sim/run/audit.hpp"

#include <algorithm>
#include <cmath>

#include "sim/prepared_run.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

using radiometry::Effect;
using support::SmallRun;
using support::SmallScenario;

/// A pixel of one band with these replicates.
ProbedPixel pixel_of(int sample, const std::vector<double>& replicates) {
  Welford sum;
  for (const double value : replicates) sum.add(value);
  return {{0, sample, 0}, {sum.estimate()}, {replicates}, 8, 0.0};
}

const CameraNames one_band{{"a", {"b"}}};

AuditReport compared_audit(const std::vector<ProbedPixel>& dropped,
                           const std::vector<ProbedPixel>& complete, double floor = 0.0) {
  AuditReport report;
  report.budget = 0.01;
  compare_pixels(dropped, complete, {{floor}}, one_band, report);
  return report;
}

/// As if the planner had left an effect out of every array, by a bound that is wrong.
void forge_dropped(PreparedRun& run, Effect effect) {
  EffectDecision& decision = run.world.effects.decisions[radiometry::index_of(effect)];
  decision.asked = EffectState::automatic;
  std::fill(decision.on.begin(), decision.on.end(), false);
  for (auto& bounds : decision.bound) std::fill(bounds.begin(), bounds.end(), 1e-6);
  for (auto& set : run.world.effects.by_array) set = set.without(effect);
  run.world.effects.any = run.world.effects.any.without(effect);
}

AuditReport audited(SmallRun& small, std::optional<int> pixels, double run_cpu_s = 1000.0) {
  std::vector<StageTime> stages = small.clock.stages();
  stages.push_back({"other work", run_cpu_s, run_cpu_s});
  return audit_run({small.request, small.run, stages, 8.0, 1, pixels}, small.diagnostics);
}

TEST_CASE("equal pixels are within any budget", "[sim][audit]") {
  const std::vector<ProbedPixel> pixels{pixel_of(0, {1.0, 2.0, 3.0, 4.0}),
                                        pixel_of(1, {0.0, 0.0, 0.0, 0.0})};
  const AuditReport report = compared_audit(pixels, pixels);
  CHECK(report.pixels == 2);
  CHECK(report.largest == 0.0);
  CHECK(report.beyond == 0);
  // 1 - 0.05^(1/2); rounding alone.
  CHECK(report.beyond_share == Approx(1.0 - std::sqrt(0.05)).epsilon(1e-12));
}

TEST_CASE("an audit finds the largest difference, its place and its error", "[sim][audit]") {
  const std::vector<ProbedPixel> dropped{pixel_of(3, {1.0, 1.0, 1.0, 1.0}),
                                         pixel_of(7, {1.9, 2.1, 2.0, 2.0})};
  const std::vector<ProbedPixel> complete{pixel_of(3, {1.005, 1.005, 1.005, 1.005}),
                                          pixel_of(7, {2.0, 2.2, 2.0, 2.2})};
  const AuditReport report = compared_audit(dropped, complete);
  // The differences are 0.1, 0.1, 0, 0.2: mean 0.1, standard error sqrt(0.02 / 3) / 2, of 2.1.
  CHECK(report.largest == Approx(0.1 / 2.1).epsilon(1e-12));
  CHECK(report.largest_error == Approx(0.5 * std::sqrt(0.02 / 3.0) / 2.1).epsilon(1e-12));
  CHECK(report.sample == 7);
  CHECK(report.band == "b");
  CHECK(report.beyond == 1);
  // 0.1 - 2 x 0.0408 = 0.018 is still above 1 % of 2.1; half the budget is not for the other pixel.
  CHECK(report.surely_beyond == 0);  // (0.1 - 0.0816) / 2.1 = 0.88 %
}

TEST_CASE("differences of dark pixels count against the floor", "[sim][audit]") {
  const std::vector<ProbedPixel> dropped{pixel_of(0, {0.0, 0.0, 0.0, 0.0})};
  const std::vector<ProbedPixel> complete{pixel_of(0, {0.02, 0.02, 0.02, 0.02})};
  CHECK(compared_audit(dropped, complete, 10.0).beyond == 0);
  CHECK(compared_audit(dropped, complete, 1.0).surely_beyond == 1);
  CHECK(compared_audit(dropped, complete, 1.0).largest == Approx(0.02).epsilon(1e-12));
}

TEST_CASE("a radiance that is not a number is beyond any budget", "[sim][audit]") {
  const std::vector<ProbedPixel> good{pixel_of(0, {1.0, 1.0, 1.0, 1.0})};
  const std::vector<ProbedPixel> bad{pixel_of(0, {NAN, 1.0, 1.0, 1.0})};
  CHECK(compared_audit(good, bad).surely_beyond == 1);
  CHECK(compared_audit(bad, good).surely_beyond == 1);
}

TEST_CASE("an audit finds an effect that was wrongly dropped", "[sim][audit]") {
  SmallRun small{{}};
  forge_dropped(small.run, Effect::solar_reflection);
  const AuditReport report = audited(small, 5);
  CAPTURE(report.verdict);
  CHECK(report.pixels == 5);
  CHECK(report.surely_beyond == 5);
  // Without the sun all of the radiance is missing; 1e-6: nothing else is there.
  CHECK(report.largest == Approx(1.0).epsilon(1e-6));
  CHECK(std::count(report.effects.begin(), report.effects.end(), "solar_reflection") == 1);
  CHECK(report.found_any());
}

TEST_CASE("an audit is silent where a dropped effect changes nothing", "[sim][audit]") {
  SmallRun small{{}};
  forge_dropped(small.run, Effect::shadows);  // of a plane alone
  const AuditReport report = audited(small, 5);
  CAPTURE(report.verdict);
  CHECK(report.pixels == 5);
  CHECK(report.beyond == 0);
  // Where nothing throws a shadow the sun need not be sampled over its disc, whose cosine differs
  // from that of its centre by the square of its radius, 2e-5.
  CHECK(report.largest < 3e-5);
  CHECK(report.verdict.find("none of 5 pixels") == 0);
}

TEST_CASE("what nobody dropped is not audited", "[sim][audit]") {
  SmallScenario scenario;
  scenario.more = R"(<effects sky_scattering="off" lamps="off"/>)";
  SmallRun small{scenario};
  for (EffectDecision& decision : small.run.world.effects.decisions) {
    if (decision.asked != EffectState::automatic) continue;
    for (auto& bounds : decision.bound) std::fill(bounds.begin(), bounds.end(), 0.0);
  }
  const AuditReport report = audited(small, 5);
  CHECK(report.pixels == 0);
  CHECK(report.verdict.find("nothing to audit") == 0);
  CHECK(audited(small, 0).verdict == "no audit was asked for");
}

TEST_CASE("an audit that would cost more than its share is not made, and says so", "[sim][audit]") {
  SmallRun small{{}};
  forge_dropped(small.run, Effect::solar_reflection);
  const AuditReport report = audited(small, {}, 1e-9);  // a run of no time
  CHECK(report.pixels == 0);
  REQUIRE_FALSE(report.not_audited.empty());
  CHECK(report.not_audited.front().find("solar_reflection: loading the scene again") == 0);
  CHECK(report.not_audited.front().find("--audit 200") != std::string::npos);
  CHECK(report.verdict.find("not audited") == 0);
}

TEST_CASE("a long run is audited by itself, every pixel at most once", "[sim][audit]") {
  SmallRun small{{}};
  forge_dropped(small.run, Effect::solar_reflection);
  const AuditReport report = audited(small, {});
  CHECK(report.pixels >= 16);  // the first batch at least
  CHECK(report.pixels <= 64);  // all there are
}

TEST_CASE("the pixels of an audit are the run's own", "[sim][audit]") {
  // What the audit renders without the dropped effect is what the run rendered, to the last bit.
  SmallRun small{{}};
  const RenderOptions options = render_options(small.run, 1);
  const std::vector<PixelPlace> places = random_pixels(small.run.world, 4, 7);
  const ProbeResult probed = probe_pixels(small.run.world, options, places, small.diagnostics);
  const RenderResult image =
      render(small.run.world.scene, small.run.world.camera, options, small.diagnostics);
  for (const ProbedPixel& pixel : probed.pixels) {
    const auto at = static_cast<std::size_t>(pixel.place.line * 8 + pixel.place.sample);
    CHECK(static_cast<float>(pixel.bands[0].mean) == image.images[0].bands[0].radiance[at]);
  }
}

}  // namespace
}  // namespace nadir::sim
