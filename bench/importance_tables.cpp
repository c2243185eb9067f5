// What does a table of importances cost? README.md says how to read the rows.

#include <benchmark/benchmark.h>

#include <string>
#include <utility>
#include <vector>

#include "core/diagnostics.hpp"
#include "materials/bound_material.hpp"
#include "radiometry/generic_plan.hpp"
#include "radiometry/importance.hpp"

namespace nadir::bench {
namespace {

constexpr int mu_samples = 10, phi_samples = 20, lane_count = 16;

spectral::Lanes lanes() {
  std::vector<Micrometres> wavelengths;
  for (int i = 0; i < lane_count; ++i) wavelengths.emplace_back(0.4 + 0.1 * i);
  return spectral::Lanes{std::move(wavelengths)};
}

materials::Material scaled(materials::Scattering scattering) {
  materials::Material material;
  material.reflectance = spectral::Curve::constant(0.3);
  material.scattering = std::move(scattering);
  return material;
}

materials::Material with_own_spectra(materials::Scattering scattering) {
  materials::Material material;
  material.scattering = std::move(scattering);
  return material;
}

void add_row(const std::string& name, const materials::Material& material) {
  Diagnostics diagnostics;
  const materials::BoundMaterial bound = materials::bind(material, lanes(), diagnostics);
  const auto work = [bound](benchmark::State& state) {
    const radiometry::QuadHemisphere quads{mu_samples, phi_samples};
    const radiometry::ImportanceTable table{bound, quads};
    for ([[maybe_unused]] auto _ : state) {
      const radiometry::ImportanceTable timed{bound, quads};
      benchmark::DoNotOptimize(timed.rank());
    }
    state.counters["rank"] = table.rank();
    state.counters["relative_rmse"] = table.error();
    state.counters["peakedness"] = table.peakedness();
    state.counters["bytes"] = static_cast<double>(table.memory_bytes());
  };
  const auto plan = [bound](benchmark::State& state) {
    const materials::SolverSettings settings{.mu_samples = mu_samples, .phi_samples = phi_samples};
    for ([[maybe_unused]] auto _ : state) {
      const radiometry::GenericPlan timed{bound, settings};
      state.counters["by_lobes"] = timed.importance().has_value() ? 0.0 : 1.0;
    }
  };
  benchmark::RegisterBenchmark(("plan/" + name).c_str(), plan)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark(("importance_table/" + name).c_str(), work)
      ->Unit(benchmark::kMillisecond);
}

/// One look-up, as at every hit.
void add_look_up(const std::string& name, const materials::Material& material) {
  Diagnostics diagnostics;
  const materials::BoundMaterial bound = materials::bind(material, lanes(), diagnostics);
  const auto work = [bound](benchmark::State& state) {
    const radiometry::ImportanceTable table{bound, {mu_samples, phi_samples}};
    std::vector<double> importance(static_cast<std::size_t>(table.quads()));
    for ([[maybe_unused]] auto _ : state) {
      table.importance({0.48, 0.6, 0.64}, importance.data());
      benchmark::DoNotOptimize(importance.data());
    }
    state.counters["rank"] = table.rank();
  };
  benchmark::RegisterBenchmark(("importance_look_up/" + name).c_str(), work)
      ->Unit(benchmark::kMicrosecond);
}

void add_rows() {
  using namespace materials;
  Material leaf = scaled(Leaf{});
  leaf.transmittance = spectral::Curve::constant(0.2);
  const Material wide = with_own_spectra(Microfacet{.alpha_x = 0.3, .alpha_y = 0.3});
  add_row("lambertian", scaled(Lambertian{}));
  add_row("leaf", leaf);
  add_row("oren_nayar", scaled(OrenNayar{.slope_sigma_rad = 0.4}));
  add_row("minnaert", scaled(Minnaert{.k = 1.3}));
  add_row("ward", scaled(Ward{.specular = spectral::Curve::constant(0.2)}));
  add_row("ward_anisotropic",
          scaled(Ward{.specular = spectral::Curve::constant(0.2), .alpha_x = 0.1, .alpha_y = 0.3}));
  add_row("microfacet_wide", wide);
  add_row("microfacet_narrow", with_own_spectra(Microfacet{.alpha_x = 0.01, .alpha_y = 0.01}));
  add_row("rough_glass",
          with_own_spectra(Microfacet{.alpha_x = 0.3, .alpha_y = 0.3, .transmits = true}));
  add_row("rough_glass_anisotropic",
          with_own_spectra(Microfacet{.alpha_x = 0.2, .alpha_y = 0.4, .transmits = true}));
  add_row("priest_germer", scaled(PriestGermer{.slope_sigma = 0.2}));
  add_row("cox_munk", with_own_spectra(CoxMunk{}));
  add_row("ross_li", with_own_spectra(RossLi{.isotropic = spectral::Curve::constant(0.2),
                                             .volumetric = spectral::Curve::constant(0.1),
                                             .geometric = spectral::Curve::constant(0.02)}));
  add_row("rahman_pinty_verstraete", with_own_spectra(RahmanPintyVerstraete{}));
  add_row("hapke", with_own_spectra(Hapke{.opposition_b0 = 1.0, .mean_slope_rad = 0.3}));
  add_look_up("lambertian", scaled(Lambertian{}));
  add_look_up("microfacet_wide", wide);
}

}  // namespace
}  // namespace nadir::bench

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  nadir::bench::add_rows();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
