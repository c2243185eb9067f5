#include "sim/run/audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "sim/run/accuracy_options.hpp"
#include "sim/run/air_stage.hpp"

namespace nadir::sim {
namespace {

using radiometry::Effect;

constexpr int first_audited = 16;
constexpr int most_audited = 4096;
// Pixels of the audit have numbers of their own, apart from the pilot's.
constexpr std::uint64_t audit_salt = 0x6175646974ULL;
// Where only some effects of the air were solved for, and it is not known what the rest takes: of
// one lane, 8 streams. Reading weather, and a cell of the heat balance that a path meets.
constexpr double audit_air_lane_s = 0.05, weather_s = 0.3, heat_cell_s_audited = 200e-6;

bool is_of_air(Effect effect) {
  return effect == Effect::sky_scattering || effect == Effect::sky_emission ||
         effect == Effect::path_scattering || effect == Effect::path_emission ||
         effect == Effect::path_transmittance;
}

/// Effects of which no radiance can tell: a rule decides about them, not the budget.
bool has_no_bound(Effect effect) {
  return effect == Effect::refraction || effect == Effect::detector_noise;
}

/// What `auto` left out of some array although the scene has it.
std::vector<Effect> dropped_effects(const EffectPlan& plan) {
  std::vector<Effect> dropped;
  for (const EffectDecision& decision : plan.decisions) {
    if (decision.asked != EffectState::automatic || has_no_bound(decision.effect)) continue;
    for (std::size_t i = 0; i < decision.on.size(); ++i) {
      const auto& bound = decision.bound[i];
      const bool there = std::any_of(bound.begin(), bound.end(), [](double b) { return b > 0.0; });
      if (decision.on[i] || !there) continue;
      dropped.push_back(decision.effect);
      break;
    }
  }
  return dropped;
}

double stage_cpu(const std::vector<StageTime>& stages, std::initializer_list<const char*> names) {
  double seconds = 0.0;
  for (const StageTime& stage : stages) {
    for (const char* name : names) {
      if (stage.name == name) seconds += stage.cpu_s;
    }
  }
  return seconds;
}

double all_cpu(const std::vector<StageTime>& stages) {
  double seconds = 0.0;
  for (const StageTime& stage : stages) seconds += stage.cpu_s;
  return seconds;
}

double lanes_of(const PreparedRun& run) {
  double lanes = 0.0;
  for (const ArrayPlan& array : run.plan.arrays) {
    for (const auto& block : array.lanes.blocks) lanes += block.count();
  }
  return lanes;
}

/// An audit that is being made.
class Audit {
 public:
  Audit(const AuditRequest& request, Diagnostics& diagnostics)
      : request_{request},
        run_{request.run},
        diagnostics_{diagnostics},
        seed_{mix(request.request.seed, audit_salt)} {
    report_.budget = run_.scenario.accuracy.effects_share * run_.world.effects.relative;
  }

  AuditReport make() {
    if (request_.pixels == 0) {
      report_.verdict = "no audit was asked for";
      return report_;
    }
    std::vector<Effect> dropped = dropped_effects(run_.world.effects);
    if (dropped.empty()) {
      report_.verdict = "nothing to audit: auto left nothing out that the scene has";
      return report_;
    }
    choose(std::move(dropped));
    if (!audited_.empty()) audit();
    conclude();
    return report_;
  }

 private:
  [[nodiscard]] double allowed_cpu_s() const {
    return request_.pixels ? HUGE_VAL : request_.most_share * all_cpu(request_.stages);
  }

  /// What it takes before the first pixel can be rendered with the air or the heat as well.
  [[nodiscard]] double fixed_cost(bool air) const {
    if (!air) return weather_s + first_audited * heat_cell_s_audited;
    const double solved_s = stage_cpu(request_.stages, {"air"});
    const bool layered = run_.world.air && run_.world.air->layered;
    return layered ? std::max(solved_s, lanes_of(run_) * audit_air_lane_s) : solved_s;
  }

  /// What the first pixels take: each twice, and more with everything on.
  [[nodiscard]] double first_pixels_s() const {
    constexpr double dearer = 1.5;
    double pixels = 0.0;
    for (const sensor::DetectorArray& array : run_.world.camera.arrays) {
      pixels += static_cast<double>(array.samples) * static_cast<double>(array.lines);
    }
    const double share = pixels > 0.0 ? std::min(1.0, first_audited / pixels) : 0.0;
    const SamplingInput audited = sampling();
    const double of_paths =
        run_.goal && request_.mean_paths > 0.0
            ? audited.replicates * audited.samples_per_replicate / request_.mean_paths
            : 1.0;
    return (1.0 + dearer) * share * of_paths * stage_cpu(request_.stages, {"render"});
  }

  /// Leaves out what does not fit into the time allowed, and says so.
  void choose(std::vector<Effect> dropped) {
    const double allowed_s = allowed_cpu_s();
    double cost_s = stage_cpu(request_.stages, {"read scenario", "build scene"}) + first_pixels_s();
    if (cost_s > allowed_s) {
      return leave_out(dropped, cost_s, "loading the scene again for a few pixels");
    }
    for (const bool air : {true, false}) {
      std::vector<Effect> group;
      for (const Effect effect : dropped) {
        const bool of_group = air ? is_of_air(effect) : effect == Effect::thermal_solve;
        // What some array has is there already.
        if (of_group && !run_.world.effects.any.has(effect)) group.push_back(effect);
      }
      if (group.empty()) continue;
      const double more_s = fixed_cost(air);
      if (cost_s + more_s <= allowed_s) {
        cost_s += more_s;
        continue;
      }
      leave_out(group, more_s, air ? "solving for the air" : "solving heat balances");
      for (const Effect effect : group) std::erase(dropped, effect);
    }
    audited_ = std::move(dropped);
    for (const Effect effect : audited_) report_.effects.emplace_back(name_of(effect));
  }

  void leave_out(const std::vector<Effect>& effects, double cost_s, const std::string& what) {
    for (const Effect effect : effects) {
      left_out_ = left_out_.with(effect);
      report_.not_audited.push_back(fmt::format(
          "{}: {} takes about {} of processor time, for which {:.2g} % of the run's {} do not "
          "suffice; --audit 200 does it",
          name_of(effect), what, duration_text(cost_s), 100.0 * request_.most_share,
          duration_text(all_cpu(request_.stages))));
    }
  }

  /// The run's scenario with everything on but what is too dear or decided by rule.
  [[nodiscard]] Scenario complete_scenario() const {
    Scenario scenario = run_.scenario;
    scenario.sampling = run_.sampling;
    for (const EffectDecision& decision : run_.world.effects.decisions) {
      if (decision.asked != EffectState::automatic || has_no_bound(decision.effect)) continue;
      scenario.effects.states[radiometry::index_of(decision.effect)] =
          left_out_.has(decision.effect) ? EffectState::off : EffectState::on;
    }
    return scenario;
  }

  /// The world with what was dropped, and with the run's solver.
  [[nodiscard]] World complete_world(const Scenario& scenario) {
    InputFiles files;
    World world = load_world(scenario, files, unheard_, request_.request.seed);
    radiometry::SceneDescription& scene = world.scene;
    const radiometry::SceneDescription& rendered = run_.world.scene;
    scene.method = rendered.method;
    scene.path_max_bounces = rendered.path_max_bounces;
    scene.solver = rendered.solver;
    for (std::size_t i = 0; i < std::min(scene.materials.size(), rendered.materials.size()); ++i) {
      scene.materials[i].solver = rendered.materials[i].solver;
    }
    static_cast<void>(finish_air(world, run_.sampling, unheard_, {}, world.effects.by_array));
    return world;
  }

  /// As the run's pixels were sampled; where each had paths of its own, as the mean of them.
  [[nodiscard]] SamplingInput sampling() const {
    SamplingInput sampling = run_.sampling;
    if (!run_.goal) return sampling;
    constexpr double most_of_a_replicate = 64.0;  // a difference needs no more
    sampling.replicates = run_.goal->replicates;
    const double mean = request_.mean_paths / sampling.replicates;
    sampling.samples_per_replicate = static_cast<int>(std::lround(
        std::clamp(mean, static_cast<double>(run_.goal->first_samples), most_of_a_replicate)));
    return sampling;
  }

  [[nodiscard]] RenderOptions options() const {
    RenderOptions render = render_options(run_, request_.request.seed);
    render.sampling = sampling();
    render.threads = request_.threads;
    render.goal = nullptr;
    return render;
  }

  void audit() {
    const Scenario scenario = complete_scenario();
    std::optional<World> world;
    clock_.stage("load", [&] { world.emplace(complete_world(scenario)); });
    const CameraPlan plan = plan_camera(*world, run_.sampling);
    ReportValues said;
    const auto bending = camera_bending(*world, said);
    const RenderOptions dropped = options();
    RenderOptions complete = dropped;
    complete.plan = &plan;
    complete.bending = bending ? &*bending : nullptr;
    complete.asks_for_heat = &world->asks_for_heat;
    complete.effects = &world->effects.by_array;
    complete.frame = &world->frame;
    complete.object_names = &world->object_names;
    const auto look = [&](int count, std::uint64_t seed) {
      clock_.stage("pixels", [&] { compare(new_places(count, seed), dropped, complete, *world); });
    };
    look(request_.pixels ? *request_.pixels : first_audited, seed_);
    if (request_.pixels || report_.pixels == 0) return;
    const double spent_s = all_cpu(clock_.stages());
    const double a_pixel_s =
        std::max(clock_.stages().back().cpu_s, 1e-6) / static_cast<double>(report_.pixels);
    constexpr double cautious = 0.8;  // pixels differ, and the first few are a small sample
    const double more =
        std::min<double>(most_audited, cautious * (allowed_cpu_s() - spent_s) / a_pixel_s);
    if (more >= 1.0) look(static_cast<int>(more), mix(seed_, 1));
  }

  /// Random pixels that have not been looked at.
  std::vector<PixelPlace> new_places(int count, std::uint64_t seed) {
    std::vector<PixelPlace> places = random_pixels(run_.world, count, seed);
    std::erase_if(places, [this](const PixelPlace& place) {
      return !seen_.emplace(place.array, place.line, place.sample).second;
    });
    return places;
  }

  void compare(const std::vector<PixelPlace>& places, const RenderOptions& dropped,
               const RenderOptions& complete, const World& world) {
    if (places.empty()) return;
    const ProbeResult without = probe_pixels(run_.world, dropped, places, diagnostics_);
    const ProbeResult with = probe_pixels(world, complete, places, unheard_);
    compare_pixels(without.pixels, with.pixels, run_.world.effects.floor_radiance,
                   camera_names(run_.world.camera), report_);
  }

  void conclude() {
    for (const StageTime& stage : clock_.stages()) {
      report_.seconds += stage.wall_s;
      report_.cpu_s += stage.cpu_s;
    }
    if (report_.pixels == 0) {
      report_.verdict =
          "not audited: " + (report_.not_audited.empty() ? std::string{"the camera has no pixels"}
                                                         : report_.not_audited.front());
      return;
    }
    const std::string budget = fmt::format("{:.2g} %", 100.0 * report_.budget);
    const std::string largest = fmt::format(
        "the largest difference is {:.2g} +- {:.1g} % (array {}, band {}, sample {}, line {})",
        100.0 * report_.largest, 100.0 * report_.largest_error, report_.array, report_.band,
        report_.sample, report_.line);
    report_.verdict =
        report_.beyond == 0
            ? fmt::format(
                  "none of {} pixels differs by more than {} from one with everything on; "
                  "with 95 % confidence fewer than {:.2g} % of all do; {}",
                  report_.pixels, budget, 100.0 * report_.beyond_share, largest)
            : fmt::format(
                  "{} of {} pixels differ by more than {} from one with everything on, {} "
                  "of them by more than chance explains; {}",
                  report_.beyond, report_.pixels, budget, report_.surely_beyond, largest);
  }

  const AuditRequest& request_;
  const PreparedRun& run_;
  Diagnostics& diagnostics_;
  Diagnostics unheard_;  // the run has told the same
  std::uint64_t seed_;
  StageClock clock_;
  std::vector<Effect> audited_;
  radiometry::EffectSet left_out_;
  std::set<std::tuple<int, int, int>> seen_;
  AuditReport report_;
};

}  // namespace

AuditReport audit_run(const AuditRequest& request, Diagnostics& diagnostics) {
  return Audit{request, diagnostics}.make();
}

}  // namespace nadir::sim
