#include "sim/files/modtran_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/error.hpp"

namespace nadir::sim {
namespace {

using Column = ModtranColumn;

constexpr auto modtran_names = std::to_array<std::pair<std::string_view, Column>>({
    {"freq", Column::frequency},
    {"tottrans", Column::transmittance},
    {"trans", Column::transmittance},
    {"combin", Column::transmittance},
    {"combintrans", Column::transmittance},
    {"pathtrans", Column::transmittance},
    {"pththrml", Column::path_thermal},
    {"thrmlem", Column::emitted},
    {"pathemiss", Column::emitted},
    {"thrmlsct", Column::thermal_scattered},
    {"thrmlscat", Column::thermal_scattered},
    {"paththermalscat", Column::thermal_scattered},
    {"surfemis", Column::surface},
    {"surfaceemiss", Column::surface},
    {"solscat", Column::solar_all},
    {"multscat", Column::solar_multiple},
    {"pathmultiscat", Column::solar_multiple},
    {"singscat", Column::solar_single},
    {"snglscat", Column::solar_single},
    {"grndrflt", Column::ground},
    {"drctrflt", Column::other},
    {"totalrad", Column::total},
    {"refsol", Column::sun_to_eye},
    {"irradref", Column::sun_to_eye},
    {"sol@obs", Column::sun_at_eye},
    {"soltr", Column::sun_at_eye},
    {"irradobs", Column::sun_at_eye},
    {"toasun", Column::sun_outside},
    {"toairrad", Column::sun_outside},
    {"solar", Column::sun_outside},
    {"depth", Column::other},
    {"natlogpathtrans", Column::other},
    {"direm", Column::other},
    {"directemiss", Column::other},
    {"bbodyt[k]", Column::other},
    {"bbodytemp", Column::other},
});

class Spectra {
 public:
  Spectra(const ModtranSpectrum& spectrum, const RunGeometry& geometry,
          const AirRunSettings& settings)
      : spectrum_{spectrum}, geometry_{geometry}, settings_{settings} {
    frequency_ = values(Column::frequency);
    if (frequency_.empty()) fail("there is no column FREQ");
    order();
  }

  AirRunSet set() {
    AirRunSet set;
    for (const double nu : frequency_) set.wavelength_um.push_back(1e4 / nu);
    transmittance_ = values(Column::transmittance);
    if (transmittance_.empty()) fail("there is no column of the transmittance");
    for (const double t : transmittance_) {
      // Rounded prints reach a little above 1.
      if (!(t >= 0.0 && t <= 1.0 + 1e-6)) fail(fmt::format("a transmittance is {}", t));
    }
    set.sun_irradiance = per_um(Column::sun_outside);
    const bool radiance = has(Column::total);
    if (!radiance && has(Column::sun_at_eye)) {
      direct(set);
    } else {
      path(set, radiance);
    }
    return set;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw InputError{spectrum_.name + ": " + message};
  }
  [[nodiscard]] bool has(Column column) const { return !values(column).empty(); }

  /// Empty where there is no such column, or it is blank.
  [[nodiscard]] std::vector<double> values(Column column) const {
    const auto& columns = spectrum_.columns;
    const auto at = std::find(columns.begin(), columns.end(), column);
    if (at == columns.end()) return {};
    std::vector<double> result;
    std::size_t blank = 0;
    for (const auto& row : spectrum_.rows) {
      result.push_back(row[static_cast<std::size_t>(at - columns.begin())]);
      if (std::isnan(result.back())) ++blank;
    }
    if (blank == result.size()) return {};
    if (blank > 0) fail("a column is blank in some rows and not in others");
    if (reversed_) std::reverse(result.begin(), result.end());
    return result;
  }

  /// Wavelengths are to ascend.
  void order() {
    if (frequency_.empty()) fail("there is no row");
    const bool ascends = frequency_.size() < 2 || frequency_[1] > frequency_[0];
    for (std::size_t i = 0; i < frequency_.size(); ++i) {
      if (!(frequency_[i] > 0.0)) fail(fmt::format("a wavenumber is {}", frequency_[i]));
      if (i > 0 &&
          !((frequency_[i] > frequency_[i - 1]) == ascends && frequency_[i] != frequency_[i - 1])) {
        fail(fmt::format("the wavenumbers turn back at {} cm^-1", frequency_[i]));
      }
    }
    reversed_ = ascends;
    if (reversed_) std::reverse(frequency_.begin(), frequency_.end());
  }

  [[nodiscard]] std::vector<double> per_um(Column column) const {
    std::vector<double> result = values(column);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] *= frequency_[i] * frequency_[i];
    return result;
  }

  [[nodiscard]] std::vector<double> sum(std::initializer_list<Column> columns) const {
    std::vector<double> result;
    for (const Column column : columns) {
      const std::vector<double> part = per_um(column);
      if (part.empty()) continue;
      if (result.empty()) result.assign(part.size(), 0.0);
      for (std::size_t i = 0; i < part.size(); ++i) result[i] += part[i];
    }
    return result;
  }

  [[nodiscard]] bool on_ground(double height_m) const {
    return std::abs(height_m - settings_.ground_m) < 1.0;
  }

  /// The sun's light alone, printed with four decimals and three digits: the better of both.
  void direct(AirRunSet& set) const {
    set.sun_zenith_rad = geometry_.zenith_rad;
    if (!on_ground(geometry_.height_m)) return;
    const std::vector<double> eye = per_um(Column::sun_at_eye);
    set.sun_transmittance = transmittance_;
    for (std::size_t i = 0; i < transmittance_.size(); ++i) {
      const double outside = set.sun_irradiance.empty() ? 0.0 : set.sun_irradiance[i];
      if (transmittance_[i] < 0.05 && outside > 0.0) {
        set.sun_transmittance[i] = std::min(eye[i] / outside, 1.0);
      }
    }
  }

  void path(AirRunSet& set, bool radiance) const {
    AirRun run{spectrum_.name,
               geometry_.height_m,
               geometry_.zenith_rad,
               geometry_.azimuth_rad,
               geometry_.length_m,
               transmittance_,
               {},
               {}};
    for (double& t : run.transmittance) t = std::min(t, 1.0);
    if (radiance) {
      // PTH_THRML and SOL_SCAT are sums already; the names of MODTRAN 6 are of parts.
      run.even = has(Column::path_thermal) ? per_um(Column::path_thermal)
                                           : sum({Column::emitted, Column::thermal_scattered});
      run.solar = has(Column::solar_all) ? per_um(Column::solar_all)
                                         : sum({Column::solar_multiple, Column::solar_single});
      check_total(run);
      sun(set);
    } else {
      set.notes.push_back("some runs give transmittances alone: no radiance along those ways");
    }
    set.runs.push_back(std::move(run));
  }

  void check_total(const AirRun& run) const {
    const std::vector<double> total = per_um(Column::total);
    const std::vector<double> below = sum({Column::surface, Column::ground});
    const double largest = *std::max_element(total.begin(), total.end());
    for (std::size_t i = 0; i < total.size(); ++i) {
      const double parts = (run.even.empty() ? 0.0 : run.even[i]) +
                           (run.solar.empty() ? 0.0 : run.solar[i]) +
                           (below.empty() ? 0.0 : below[i]);
      // The parts have five digits each.
      if (std::abs(parts - total[i]) > 2e-3 * total[i] + 1e-5 * largest) {
        fail(
            fmt::format("at {} cm^-1 emission, scattering and ground add up to {:.5g} "
                        "W m^-2 sr^-1 um^-1, but the total radiance is {:.5g}",
                        frequency_[i], parts, total[i]));
      }
    }
  }

  void sun(AirRunSet& set) const {
    const std::vector<double>& outside = set.sun_irradiance;
    if (outside.empty()) return;
    if (on_ground(geometry_.height_m)) {
      set.sun_transmittance = ratio(per_um(Column::sun_at_eye), outside);
    }
    const bool to_ground =
        geometry_.zenith_rad > std::numbers::pi / 2.0 && std::isinf(geometry_.length_m);
    if (to_ground) {
      const std::vector<double> there = ratio(per_um(Column::sun_to_eye), outside);
      set.sun_transmittance_rough = ratio(there, transmittance_);
    }
  }

  static std::vector<double> ratio(std::vector<double> above, const std::vector<double>& below) {
    for (std::size_t i = 0; i < above.size(); ++i) {
      above[i] = below[i] > 0.0 ? std::clamp(above[i] / below[i], 0.0, 1.0) : 0.0;
    }
    return above;
  }

  const ModtranSpectrum& spectrum_;
  const RunGeometry& geometry_;
  const AirRunSettings& settings_;
  bool reversed_ = false;
  std::vector<double> frequency_, transmittance_;
};

}  // namespace

std::optional<ModtranColumn> modtran_column(std::string_view name) {
  std::string plain;
  for (const char c : name) {
    if (c == ' ' || c == '_' || c == '-') continue;
    plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  const auto found = std::find_if(modtran_names.begin(), modtran_names.end(),
                                  [&](const auto& entry) { return entry.first == plain; });
  if (found == modtran_names.end()) return std::nullopt;
  return found->second;
}

AirRunSet run_of_modtran(const ModtranSpectrum& spectrum, const RunGeometry& geometry,
                         const AirRunSettings& settings) {
  return Spectra{spectrum, geometry, settings}.set();
}

}  // namespace nadir::sim
