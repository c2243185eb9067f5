#include "radiometry/lamps/lamp_binder.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <variant>

#include "core/text.hpp"
#include "spectral/coverage.hpp"

namespace nadir::radiometry {
namespace {

void require(bool good, const std::string& message) {
  if (!good) throw InputError{message};
}

/// Unit to what scenario files give, made unit to rounding.
Vec3 unit(Vec3 v, const char* what) {
  require(is_finite(v) && std::abs(length(v) - 1.0) < 1e-6,
          std::string{what} + " must be a unit vector");
  return normalised(v);
}

}  // namespace

void BoundLamps::Binder::add(const Lamp& lamp) {
  try {
    Emitter emitter;
    bind_flux(lamp.flux, emitter);
    LightTreeItem item =
        std::visit([&](const auto& form) { return bind(form, emitter); }, lamp.form);
    item.weight *= static_cast<double>(bound_->spectra_[emitter.spectrum].mean()) * emitter.factor;
    items_.push_back(item);
    bound_->emitters_.push_back(emitter);
  } catch (const InputError& error) {
    for (InputIssue issue : error.issues()) {
      if (issue.where.file.empty()) issue.where = lamp.where;
      issue.message = "lamp " + lamp.name + ": " + issue.message;
      issues_.push_back(std::move(issue));
    }
  }
}

void BoundLamps::Binder::bind_flux(const LampFlux& flux, Emitter& emitter) {
  require(flux.curve != nullptr, "its flux is missing");
  require(flux.curve->min_value() >= 0.0, "its flux must not be negative, found " +
                                              number_text(flux.curve->min_value()) + " W um^-1");
  require(std::isfinite(flux.factor) && flux.factor >= 0.0,
          "the factor of its flux must not be negative, found " + number_text(flux.factor));
  emitter.factor = flux.factor;
  auto& spectra = bound_->spectra_;
  if (const auto known = known_curves_.find(flux.curve.get()); known != known_curves_.end()) {
    emitter.spectrum = known->second;
    return;
  }
  emitter.spectrum = static_cast<std::uint32_t>(spectra.size());
  spectra.push_back(spectral::at_all(*flux.curve, *lanes_, "its flux"));
  known_curves_[flux.curve.get()] = emitter.spectrum;
}

std::uint32_t BoundLamps::Binder::shape_index(const IntensityShape& shape) {
  const auto look_up = [&](auto& known, const auto& key) {
    auto entry = known.find(key);
    if (entry == known.end()) {
      bound_->shapes_.emplace_back(shape);  // first, since it may be refused
      entry = known.emplace(key, static_cast<std::uint32_t>(bound_->shapes_.size() - 1)).first;
    }
    return entry->second;
  };
  if (const auto* cosine = std::get_if<CosinePower>(&shape)) {
    return look_up(known_cosines_, std::pair{cosine->power, cosine->half_angle_rad});
  }
  return look_up(known_tables_, std::get<std::shared_ptr<const IntensityTable>>(shape).get());
}

LightTreeItem BoundLamps::Binder::bind(const PointLamp& lamp, Emitter& emitter) {
  require(is_finite(lamp.position), "its place must be finite");
  const Vec3 axis = unit(lamp.axis, "its axis"), side = unit(lamp.side, "its side");
  require(std::abs(dot(axis, side)) < 1e-6, "its side must be at right angles to its axis");
  emitter.is_point = true;
  emitter.index = static_cast<std::uint32_t>(bound_->points_.size());
  const std::uint32_t shape = shape_index(lamp.shape);
  bound_->points_.push_back({lamp.position, axis, side, cross(side, axis), shape});
  const EmissionBound& bound = bound_->shapes_[shape].bound();
  return {{lamp.position, lamp.position}, axis, bound.spread_rad, bound.fade_rad, bound.peak};
}

LightTreeItem BoundLamps::Binder::bind(const AreaLamp& lamp, Emitter& emitter) {
  const EmittingSurface surface{lamp};
  take_object(lamp.object);
  emitter.is_point = false;
  emitter.index = static_cast<std::uint32_t>(bound_->surfaces_.size());
  emitter.factor /= std::numbers::pi * surface.area();  // radiance of a diffuse front
  bound_->surfaces_.push_back(surface);
  LightTreeItem item = surface.bound();
  // Intensity along the normal is radiance times the area seen: of a sphere a quarter of its own.
  const bool ball = std::holds_alternative<geometry::Sphere>(lamp.surface);
  item.weight = surface.area() * (ball ? 0.25 : 1.0);
  return item;
}

void BoundLamps::Binder::take_object(std::uint32_t object) {
  constexpr std::uint32_t most = 1U << 28U;  // a table of objects that fits into memory
  require(object < most, "the number of its object is too large");
  auto& table = bound_->lamp_of_object_;
  if (object >= table.size()) table.resize(object + 1, none);
  require(table[object] == none, "its object is another lamp's as well");
  table[object] = static_cast<std::uint32_t>(items_.size());
}

void BoundLamps::Binder::finish() {
  if (!issues_.empty()) throw InputError{std::move(issues_)};
  bound_->tree_ = LightTree{items_};
}

}  // namespace nadir::radiometry
