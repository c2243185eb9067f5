#include "radiometry/volumes/bound_volume.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"
#include "spectral/planck.hpp"

namespace nadir::radiometry {
namespace {

using spectral::Lanes;

/// Gathers the mistakes of one volume.
class Check {
 public:
  Check(const Volume& volume, const Lanes& lanes) : volume_{&volume}, lanes_{&lanes} {
    coefficient("absorption", volume.medium.absorption);
    coefficient("scattering", volume.medium.scattering);
    if (volume.density) grid("density", *volume.density);
    if (const auto* kelvin = std::get_if<Kelvin>(&volume.temperature)) {
      if (!std::isfinite(kelvin->value) || kelvin->value < 0.0) {
        add("the temperature is " + number_text(kelvin->value) + " K; it must not be negative");
      }
    } else if (const auto& values = std::get<1>(volume.temperature)) {
      grid("temperature", *values);
    } else {
      add("the temperature is missing");
    }
    try {
      const materials::BoundPhase phase{volume.medium.phase, lanes};
    } catch (const InputError& error) {
      for (const InputIssue& issue : error.issues()) add(issue.message);
    }
    if (!issues_.empty()) throw InputError{std::move(issues_)};
  }

 private:
  void add(const std::string& message) {
    issues_.push_back({volume_->where, "volume \"" + volume_->name + "\": " + message, {}, {}});
  }

  void coefficient(const std::string& name, const spectral::Curve& curve) {
    for (const Micrometres wavelength : *lanes_) {
      const double value = curve.at(wavelength);
      const std::string at = " at " + number_text(wavelength.value) + " um";
      if (std::isnan(value)) return add(name + " is not tabulated" + at);
      // The greatest number of 1/m: beyond it a cell of a nanometre is opaque, and float overflows.
      if (value >= 0.0 && value <= 1e12) continue;
      return add(name + " is " + number_text(value) + " per m" + at +
                 "; it must be from 0 to 1e12");
    }
  }

  void grid(const std::string& name, const ScalarGrid& grid) {
    if (!std::holds_alternative<geometry::Box>(volume_->region.shape())) {
      add("the " + name + " grid needs a box, this volume has another shape");
    }
    const std::string size = std::to_string(grid.columns) + " x " + std::to_string(grid.rows) +
                             " x " + std::to_string(grid.layers);
    if (grid.columns < 1 || grid.rows < 1 || grid.layers < 1) {
      return add("the " + name + " grid is " + size +
                 " cells; it needs one or more along each axis");
    }
    const std::size_t cells = static_cast<std::size_t>(grid.columns) *
                              static_cast<std::size_t>(grid.rows) *
                              static_cast<std::size_t>(grid.layers);
    if (grid.value.size() != cells) {
      return add("the " + name + " grid is " + size + " cells, but has " +
                 std::to_string(grid.value.size()) + " values");
    }
    const auto bad = std::find_if(grid.value.begin(), grid.value.end(), [](float value) {
      return !(value >= 0.0F) || !std::isfinite(value);
    });
    if (bad == grid.value.end()) return;
    const auto index = static_cast<std::size_t>(bad - grid.value.begin());
    const auto columns = static_cast<std::size_t>(grid.columns);
    const auto rows = static_cast<std::size_t>(grid.rows);
    add("the " + name + " grid has the value " + number_text(static_cast<double>(*bad)) +
        " in column " + std::to_string(index % columns + 1) + ", row " +
        std::to_string(index / columns % rows + 1) + ", layer " +
        std::to_string(index / columns / rows + 1) + "; it must be finite and not negative");
  }

  const Volume* volume_;
  const Lanes* lanes_;
  std::vector<InputIssue> issues_;
};

const Volume& checked(const Volume& volume, const Lanes& lanes) {
  const Check check{volume, lanes};
  return volume;
}

}  // namespace

BoundVolume::BoundVolume(const Volume& volume, const Lanes& lanes)
    : region{checked(volume, lanes).region},
      phase{volume.medium.phase, lanes},
      scattering{volume.medium.scattering.at(lanes)},
      absorption{volume.medium.absorption.at(lanes)},
      extinction{scattering + absorption},
      emission{lanes.count()},
      max_extinction{extinction.max()},
      scatters{scattering.max() > 0.0F} {
  if (volume.density) density.emplace(volume.density);
  if (const auto* kelvin = std::get_if<Kelvin>(&volume.temperature)) {
    if (kelvin->value > 0.0) emission = absorption * spectral::planck(lanes, *kelvin);
    return;
  }
  temperature.emplace(std::get<1>(volume.temperature));
  if (absorption.max() <= 0.0F) return;
  const GridField::Range range = temperature->range();
  planck.emplace(lanes, PlanckTable::Reach{Kelvin{static_cast<double>(range.lo)},
                                           Kelvin{static_cast<double>(range.hi)}});
}

}  // namespace nadir::radiometry
