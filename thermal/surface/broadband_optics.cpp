#include "thermal/surface/broadband_optics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <variant>
#include <vector>

#include "core/error.hpp"
#include "materials/bound_material.hpp"
#include "spectral/planck.hpp"

namespace nadir::thermal {
namespace {

using materials::Material;
using spectral::Curve;

// Light from 45 degrees stands for the hemisphere: half of what a level surface receives of an even
// sky comes from above.
const Vec3 slanting{0.5 * std::numbers::sqrt2, 0.0, 0.5 * std::numbers::sqrt2};

constexpr double black_body_k = 300.0;
constexpr double solar_lo_um = 0.28, solar_hi_um = 4.0;  // of a sun without a table
constexpr double heat_lo_um = 3.0, heat_hi_um = 100.0;   // all but 0.5 % of a black body at 300 K
// Steps of 2 and 5.6 % of the wavelength: a model with tables of its own takes milliseconds a lane.
constexpr int solar_cells = 128;
constexpr int heat_cells = 64;

// ---- at which wavelengths a material's spectra are known ----------------------------------------

bool known(const Material& material, Micrometres at);

bool covers(const Curve& curve, Micrometres at) { return curve.covers(at, at); }
bool covers(const std::optional<Curve>& curve, Micrometres at) {
  return !curve || covers(*curve, at);
}
template <class... Curves>
bool all_cover(Micrometres at, const Curves&... curves) {
  return (covers(curves, at) && ...);
}

/// Whether the spectra that a model brings itself cover a wavelength.
struct ModelKnown {
  Micrometres at;

  bool operator()(const materials::Lambertian& /*m*/) const { return true; }
  bool operator()(const materials::OrenNayar& /*m*/) const { return true; }
  bool operator()(const materials::Minnaert& /*m*/) const { return true; }
  bool operator()(const materials::Leaf& /*m*/) const { return true; }
  bool operator()(const materials::Mirror& m) const { return all_cover(at, m.n, m.k); }
  bool operator()(const materials::ClearSheet& m) const { return all_cover(at, m.n, m.absorption); }
  bool operator()(const materials::Ward& m) const { return covers(m.specular, at); }
  bool operator()(const materials::Microfacet& m) const { return all_cover(at, m.n, m.k); }
  bool operator()(const materials::PriestGermer& m) const { return all_cover(at, m.n, m.k); }
  bool operator()(const materials::CoxMunk& m) const {
    return all_cover(at, m.n, m.k, m.water_body);
  }
  bool operator()(const materials::RossLi& m) const {
    return all_cover(at, m.isotropic, m.volumetric, m.geometric);
  }
  bool operator()(const materials::RahmanPintyVerstraete& m) const {
    return all_cover(at, m.rho0, m.k, m.asymmetry, m.rho_c);
  }
  bool operator()(const materials::Hapke& m) const {
    return covers(m.single_scattering_albedo, at);
  }
  bool operator()(const materials::Measured& m) const {
    const auto& table = m.table->wavelength_um;
    return !table.empty() && table.front() <= at.value && at.value <= table.back();
  }
  bool operator()(const materials::Mixture& m) const {
    return std::all_of(m.parts.begin(), m.parts.end(),
                       [&](const auto& part) { return known(*part.material, at); });
  }
};

bool known(const Material& material, Micrometres at) {
  const bool scaled = materials::curves_taken(material.scattering).reflectance;
  const bool own = (material.reflectance && covers(*material.reflectance, at)) ||
                   (material.emissivity && covers(*material.emissivity, at));
  return (own || !scaled) && covers(material.transmittance, at) &&
         std::visit(ModelKnown{at}, material.scattering);
}

// ---- means --------------------------------------------------------------------------------------

/// A piece of the spectrum, by its middle.
struct Cell {
  Micrometres middle;
  double weight = 0.0;
};

/// Cells evenly spaced in the logarithm of wavelength. @param energy  of light between two
/// wavelengths
template <class Energy>
std::vector<Cell> cells_of(double lo_um, double hi_um, int count, const Energy& energy) {
  std::vector<Cell> cells;
  const double step = std::log(hi_um / lo_um) / count;
  for (int i = 0; i < count; ++i) {
    const double a = lo_um * std::exp(i * step);
    const double b = i + 1 == count ? hi_um : lo_um * std::exp((i + 1) * step);
    cells.push_back({Micrometres{0.5 * (a + b)}, energy(Micrometres{a}, Micrometres{b})});
  }
  return cells;
}

double sum_of(const std::vector<Cell>& cells) {
  double sum = 0.0;
  for (const Cell& cell : cells) sum += cell.weight;
  return sum;
}

struct Means {
  double reflectance = 0.0, transmittance = 0.0, emissivity = 0.0;
  double weight = 0.0;
};

void add_bound(Means& means, const Material& material, const std::vector<Cell>& block) {
  std::vector<Micrometres> wavelengths;
  for (const Cell& cell : block) wavelengths.push_back(cell.middle);
  Diagnostics told_elsewhere;  // whoever binds the material for a picture reports
  const auto bound = materials::bind(material, spectral::Lanes{wavelengths}, told_elsewhere);
  const auto albedo = materials::albedo(bound.scattering, slanting);
  const auto emissivity = bound.emissivity(slanting);
  for (std::size_t i = 0; i < block.size(); ++i) {
    const int lane = static_cast<int>(i);
    const double w = block[i].weight;
    means.reflectance += w * static_cast<double>(albedo.reflectance[lane]);
    means.transmittance += w * static_cast<double>(albedo.transmittance[lane]);
    means.emissivity += w * static_cast<double>(emissivity[lane]);
    means.weight += w;
  }
}

/// What a model refuses at some wavelengths, as constants of metals out of its range, is not known
/// there: no picture may ever ask for them. Such cells are found by halving.
void add_block(Means& means, const Material& material, const std::vector<Cell>& block) {
  try {
    add_bound(means, material, block);
  } catch (const InputError&) {
    if (block.size() < 2) return;
    const auto half = block.begin() + static_cast<std::ptrdiff_t>(block.size() / 2);
    add_block(means, material, {block.begin(), half});
    add_block(means, material, {half, block.end()});
  }
}

/// Over the cells at which the material is known.
Means means_over(const Material& material, const std::vector<Cell>& cells) {
  Means means;
  std::vector<Cell> block;
  const auto flush = [&] {
    if (!block.empty()) add_block(means, material, block);
    block.clear();
  };
  for (const Cell& cell : cells) {
    if (!(cell.weight > 0.0) || !known(material, cell.middle)) continue;
    block.push_back(cell);
    if (block.size() == static_cast<std::size_t>(spectral::lane_capacity)) flush();
  }
  flush();
  if (means.weight <= 0.0) return {};
  means.reflectance /= means.weight;
  means.transmittance /= means.weight;
  means.emissivity /= means.weight;
  return means;
}

std::vector<Cell> sunlight_cells(const Curve& sunlight) {
  const bool table = !sunlight.is_constant();
  return cells_of(
      table ? sunlight.first().value : solar_lo_um, table ? sunlight.last().value : solar_hi_um,
      solar_cells,
      [&](Micrometres a, Micrometres b) { return sunlight.mean(a, b) * (b.value - a.value); });
}

}  // namespace

BroadbandOptics broadband_optics(const Material& material, const Curve& sunlight) {
  const auto solar_cells_of = sunlight_cells(sunlight);
  const auto heat_cells_of =
      cells_of(heat_lo_um, heat_hi_um, heat_cells, [](Micrometres a, Micrometres b) {
        return spectral::planck_band(a, b, Kelvin{black_body_k}).value;
      });
  const Means solar = means_over(material, solar_cells_of);
  const Means heat = means_over(material, heat_cells_of);
  BroadbandOptics optics;
  const double sun = sum_of(solar_cells_of);
  optics.solar_covered = sun > 0.0 ? solar.weight / sun : 0.0;
  optics.long_wave_covered = heat.weight / sum_of(heat_cells_of);
  if (solar.weight > 0.0) {
    optics.solar_reflectance = solar.reflectance;
    optics.solar_transmittance = solar.transmittance;
    optics.solar_absorptance = 1.0 - solar.reflectance - solar.transmittance;
  }
  if (heat.weight > 0.0) optics.emissivity = heat.emissivity;
  return optics;
}

}  // namespace nadir::thermal
