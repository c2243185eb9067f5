#include "atmosphere/particles/particles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "atmosphere/particles/haze_profile.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::atmosphere {
namespace {

/// Relative humidity of the haze above the boundary layer, that of the free troposphere of the US
/// standard air. Below 70 % the haze hardly swells: between 0 and 70 % its extinction differs by
/// less than 0.6 % from 0.3 to 1.06 um, its asymmetry by 0.017.
constexpr double tropospheric_humidity = 0.5;

std::string name_of(AerosolType type) {
  switch (type) {
    case AerosolType::rural:
      return "rural";
    case AerosolType::urban:
      return "urban";
    case AerosolType::maritime:
      return "maritime";
    case AerosolType::tropospheric:
      return "tropospheric";
    case AerosolType::fog_advection:
      return "fog_advection";
    case AerosolType::fog_radiation:
      return "fog_radiation";
    default:
      return "";
  }
}

/// LOWTRAN pairs moderate eruptions with the aged, stronger ones with the fresh veil.
std::string stratospheric_kind(Volcanic state) {
  if (state == Volcanic::background) return "stratospheric";
  return state == Volcanic::moderate ? "volcanic_aged" : "volcanic_fresh";
}

bool fog(AerosolType type) {
  return type == AerosolType::fog_advection || type == AerosolType::fog_radiation;
}

/// Place of x in an ascending table: the interval and how far into it, ends held.
struct Place {
  std::size_t index = 0;
  double share = 0.0;
};
Place place(const std::vector<double>& table, double x, double (*scale)(double)) {
  const auto above = std::upper_bound(table.begin() + 1, table.end() - 1, x);
  const auto i = static_cast<std::size_t>(above - table.begin() - 1);
  const double share = (scale(x) - scale(table[i])) / (scale(table[i + 1]) - scale(table[i]));
  return {i, std::clamp(share, 0.0, 1.0)};
}
double plain(double x) { return x; }
double logarithm(double x) { return std::log(x); }

double mix(double a, double b, double share) { return a + share * (b - a); }

void check_levels(const std::vector<double>& level_height_m) {
  bool descending = level_height_m.size() >= 2;
  for (std::size_t i = 1; i < level_height_m.size(); ++i) {
    descending = descending && level_height_m[i] < level_height_m[i - 1];
  }
  if (!descending) throw InputError{"the levels of the air must descend, two at least"};
}

void check_cloud(const Cloud& cloud, double room_m) {
  const std::string name = "the cloud \"" + cloud.type + "\" ";
  const std::string heights =
      number_text(cloud.base_m) + " to " + number_text(cloud.top_m) + " m above the ground";
  if (!(cloud.base_m < cloud.top_m)) {
    throw InputError{name + "has no thickness: " + heights};
  }
  if (!(cloud.base_m >= 0.0 && cloud.top_m <= room_m)) {
    throw InputError{name + "does not lie within the air: " + heights + ", the air reaches to " +
                     number_text(room_m) + " m"};
  }
  if (!(cloud.optical_depth_550 >= 0.0 && std::isfinite(cloud.optical_depth_550))) {
    throw InputError{name + "cannot have an optical depth of " +
                     number_text(cloud.optical_depth_550)};
  }
}

double checked_visibility(const Aerosol& aerosol) {
  const double visibility = aerosol.visibility_km;
  if (visibility > 0.0 && visibility < HazeProfile::clean_air_km) return visibility;
  throw InputError{
      "the visibility must be greater than 0 and less than that of clean air, 337 km, "
      "found " +
      number_text(visibility) + " km"};
}

}  // namespace

Particles::Particles(std::shared_ptr<const ParticleTables> tables, const Aerosol& aerosol,
                     const std::vector<Cloud>& clouds, const std::vector<double>& level_height_m)
    : tables_{std::move(tables)} {
  check_levels(level_height_m);
  if (aerosol.type != AerosolType::none) add_haze(aerosol, level_height_m);
  for (const Cloud& cloud : clouds) add_cloud(cloud, level_height_m);
}

Particles::Kind Particles::humid_kind(const std::string& name, double relative_humidity) const {
  if (!(relative_humidity >= 0.0 && relative_humidity <= 0.99)) {
    throw InputError{"the relative humidity of haze must lie from 0 to 0.99, found " +
                     number_text(relative_humidity)};
  }
  // linear in ln(100 - RH), as LOWTRAN
  constexpr std::array<int, 4> tabulated{0, 70, 80, 99};
  const double percent = 100.0 * relative_humidity;
  std::size_t i = 0;
  while (i + 2 < tabulated.size() && percent >= tabulated[i + 1]) ++i;
  const auto dryness = [](double rh) { return std::log(100.0 - rh); };
  const double share = (dryness(percent) - dryness(tabulated[i])) /
                       (dryness(tabulated[i + 1]) - dryness(tabulated[i]));
  return {&tables_->kinds.at(name + "_" + std::to_string(tabulated[i])),
          &tables_->kinds.at(name + "_" + std::to_string(tabulated[i + 1])),
          std::clamp(share, 0.0, 1.0)};
}

void Particles::add_haze(const Aerosol& aerosol, const std::vector<double>& level_height_m) {
  const double ground_m = level_height_m.back();
  visibility_km_ = aerosol.optical_depth_550 ? visibility_of_depth(*tables_, aerosol, ground_m)
                                             : checked_visibility(aerosol);
  const auto single = [this](const std::string& name) {
    const ParticleOptics* const row = &tables_->kinds.at(name);
    return Kind{row, row, 0.0};
  };
  const std::string type = name_of(aerosol.type);
  const std::array<Kind, HazeProfile::regions> kinds{
      fog(aerosol.type) ? single(type) : humid_kind(type, aerosol.relative_humidity),
      humid_kind("tropospheric", tropospheric_humidity),
      single(stratospheric_kind(aerosol.volcanic)), single("meteoric_dust")};
  const HazeProfile profile{*tables_, aerosol, visibility_km_, ground_m};
  for (int region = 0; region < HazeProfile::regions; ++region) {
    std::vector<double> depth;
    for (std::size_t k = 0; k + 1 < level_height_m.size(); ++k) {
      const double difference = profile.depth_below(region, level_height_m[k]) -
                                profile.depth_below(region, level_height_m[k + 1]);
      depth.push_back(std::max(difference, 0.0));  // rounding above the region
    }
    add(kinds[static_cast<std::size_t>(region)], depth);
  }
}

void Particles::add_cloud(const Cloud& cloud, const std::vector<double>& level_height_m) {
  const std::vector<std::string> known = cloud_types();
  if (std::find(known.begin(), known.end(), cloud.type) == known.end()) {
    const std::string nearest = nearest_name(cloud.type, known);
    std::string all;
    for (const std::string& name : known) all += (all.empty() ? "" : ", ") + name;
    throw InputError{
        InputIssue{{},
                   "unknown cloud \"" + cloud.type + "\"",
                   nearest.empty() ? "clouds are " + all : "did you mean \"" + nearest + "\"?",
                   {}}};
  }
  const double ground_m = level_height_m.back();
  check_cloud(cloud, level_height_m.front() - ground_m);
  const double base_m = ground_m + cloud.base_m, top_m = ground_m + cloud.top_m;
  std::vector<double> depth;
  for (std::size_t k = 0; k + 1 < level_height_m.size(); ++k) {
    const double within =
        std::min(top_m, level_height_m[k]) - std::max(base_m, level_height_m[k + 1]);
    depth.push_back(cloud.optical_depth_550 * std::max(within, 0.0) / (top_m - base_m));
  }
  const ParticleOptics* const row = &tables_->kinds.at(cloud.type);
  add({row, row, 0.0}, depth);
}

void Particles::add(const Kind& kind, const std::vector<double>& depth) {
  if (std::all_of(depth.begin(), depth.end(), [](double d) { return d <= 0.0; })) return;
  const auto found = std::find(kinds_.begin(), kinds_.end(), kind);
  if (found == kinds_.end()) {
    kinds_.push_back(kind);
    depth_550_.push_back(depth);
    return;
  }
  std::vector<double>& sum = depth_550_[static_cast<std::size_t>(found - kinds_.begin())];
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += depth[k];
}

Particles::Amounts Particles::amounts(const Kind& kind, double wavelength_um) const {
  const std::vector<double>& grid = tables_->wavelength_um;
  if (!(wavelength_um >= grid.front() && wavelength_um <= grid.back())) {
    throw InputError{"the tables of haze and clouds reach from " + number_text(grid.front()) +
                     " to " + number_text(grid.back()) + " um, not to " +
                     number_text(wavelength_um) + " um"};
  }
  const Place at = place(grid, wavelength_um, plain);
  const auto value = [&](std::vector<double> ParticleOptics::*quantity) {
    const std::vector<double>& low = kind.low->*quantity;
    const std::vector<double>& high = kind.high->*quantity;
    return mix(mix(low[at.index], low[at.index + 1], at.share),
               mix(high[at.index], high[at.index + 1], at.share), kind.share);
  };
  Amounts result;
  result.absorption = value(&ParticleOptics::absorption);
  result.scattering = std::max(value(&ParticleOptics::extinction) - result.absorption, 0.0);
  result.asymmetry = value(&ParticleOptics::asymmetry);
  return result;
}

double Particles::scattering(int kind, Micrometres wavelength) const {
  return amounts(kinds_[static_cast<std::size_t>(kind)], wavelength.value).scattering;
}

KindOptics Particles::optics(int kind, Micrometres wavelength) const {
  const Kind& rows = kinds_[static_cast<std::size_t>(kind)];
  const Amounts found = amounts(rows, wavelength.value);
  const bool tabulated = !rows.low->phase.empty();
  return {found.scattering, found.absorption,
          tabulated ? phase(rows, wavelength.value)
                    : std::make_shared<const PhaseFunction>(
                          PhaseFunction::henyey_greenstein(found.asymmetry))};
}

std::shared_ptr<const PhaseFunction> Particles::phase(const Kind& kind,
                                                      double wavelength_um) const {
  const Place at = place(tables_->phase_wavelength_um, wavelength_um, logarithm);
  std::vector<double> values(tables_->phase_angle_rad.size(), 0.0);
  const auto blend = [&](const ParticleOptics& row, std::size_t index, double weight) {
    if (weight <= 0.0) return;
    const auto number = static_cast<std::size_t>(row.phase[index]);
    const std::vector<double>& function = tables_->phase_functions[number];
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += weight * function[i];
  };
  blend(*kind.low, at.index, (1.0 - kind.share) * (1.0 - at.share));
  blend(*kind.low, at.index + 1, (1.0 - kind.share) * at.share);
  blend(*kind.high, at.index, kind.share * (1.0 - at.share));
  blend(*kind.high, at.index + 1, kind.share * at.share);
  return std::make_shared<const PhaseFunction>(tables_->phase_angle_rad, std::move(values));
}

std::vector<double> Particles::edges_m(const Aerosol& aerosol, const std::vector<Cloud>& clouds,
                                       double ground_height_m) {
  std::vector<double> edges;
  if (aerosol.type != AerosolType::none) {
    // where regions end and fade into the next, in the tables' heights
    for (const double table_km : {1.0, 2.0, 3.0, 10.0, 11.0, 30.0, 35.0}) {
      edges.push_back(1e3 * squeezed_km(table_km, 1e-3 * ground_height_m));
    }
  }
  for (const Cloud& cloud : clouds) {
    edges.push_back(ground_height_m + cloud.base_m);
    edges.push_back(ground_height_m + cloud.top_m);
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  edges.erase(std::remove_if(edges.begin(), edges.end(),
                             [&](double edge) { return edge <= ground_height_m; }),
              edges.end());
  return edges;
}

}  // namespace nadir::atmosphere
