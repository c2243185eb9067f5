#include "thermal/solve/material_heat.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace nadir::thermal {
namespace {

std::vector<double> behind_the_back(const LayerStack& layers, const SharedStages& shared) {
  std::vector<double> room_k(shared.grid.stages(), 0.0);
  const auto* room = std::get_if<RoomBack>(&layers.back);
  if (room == nullptr) return room_k;
  for (std::size_t i = 0; i < room_k.size(); ++i) {
    room_k[i] = room->temperature ? room->temperature->value
                                  : shared.weather[i].air_temperature_k + room->offset_k;
  }
  return room_k;
}

/// A series at the stages of the first day's long steps: mean of each, twice.
std::vector<double> at_long_stages(const std::vector<double>& series, const SharedStages& shared) {
  const std::vector<double>& mean = shared.long_steps.mean;
  std::vector<double> result;
  for (std::size_t step = 0; step < shared.grid.long_steps(); ++step) {
    double sum = 0.0;
    for (std::size_t i = 0; i < mean.size(); ++i) sum += mean[i] * series[step * mean.size() + i];
    result.insert(result.end(), 2, sum);
  }
  return result;
}

/// The day's mean flux into a surface that is held at a temperature, from some three dozen stages.
SurfaceFlux mean_flux(const ColumnRun& day, double temperature_k) {
  const std::size_t stride = std::max<std::size_t>(1, day.steps() / 36);
  SurfaceFlux sum;
  double count = 0.0;
  for (std::size_t step = 0; step < day.steps(); step += stride) {
    const SurfaceFlux one = day.stages[2 * step + 1](temperature_k);
    sum.w_m2 += one.w_m2;
    sum.per_k_w_m2_k += one.per_k_w_m2_k;
    count += 1.0;
  }
  return {sum.w_m2 / count, sum.per_k_w_m2_k / count};
}

/// A column through which heat flows steadily: flux into its surface = per_k T_surface + offset.
struct SteadyColumn {
  double per_k_w_m2_k = 0.0, offset_w_m2 = 0.0;
};
/// With H_i the heat released down to node i, q + H_i flows on from there, and what arrives at the
/// back leaves through it.
SteadyColumn steady_column(const DepthGrid& grid, const Back& back, double room_k) {
  double released = 0.0, resistance = 0.0, fall_k = 0.0;
  for (std::size_t i = 0; i + 1 < grid.nodes(); ++i) {
    released += grid.heat_w_m2[i];
    resistance += 1.0 / grid.conductance_w_m2_k[i];
    fall_k += released / grid.conductance_w_m2_k[i];
  }
  if (const auto* fixed = std::get_if<FixedBack>(&back)) {
    return {1.0 / resistance, -(fixed->temperature.value + fall_k) / resistance};
  }
  released += grid.heat_w_m2.back();
  const auto* room = std::get_if<RoomBack>(&back);
  const double film = room == nullptr ? 0.0 : room->film_w_m2_k;
  const double all = 1.0 + film * resistance;
  return {film / all, -(film * (fall_k + room_k) + released) / all};
}

/// Where the day's mean load leaves a surface in the steady state.
double steady_surface(const ColumnRun& day, const SteadyColumn& column) {
  double low = least_temperature.value, high = greatest_temperature.value, surface_k = low;
  constexpr int halvings = 24;  // to a tenth of a millikelvin: the days that follow do the rest
  for (int i = 0; i < halvings; ++i) {
    surface_k = 0.5 * (low + high);
    const double into = mean_flux(day, surface_k).w_m2;
    const bool warms = into > column.per_k_w_m2_k * surface_k + column.offset_w_m2;
    (warms ? low : high) = surface_k;
  }
  return surface_k;
}

double emitted_at(double temperature_k) {
  const double t2 = temperature_k * temperature_k;
  return si::stefan_boltzmann * t2 * t2;
}

}  // namespace

MaterialHeat::MaterialHeat(const HeatModel& model, const HeatMaterial& material,
                           const SharedStages& shared)
    : material_{material},
      column_{material.layers, model.settings.grid, Seconds{shared.grid.step_s}},
      open_{std::holds_alternative<OpenBack>(material.layers.back)},
      room_k_{behind_the_back(material.layers, shared)} {
  for (const WeatherState& weather : shared.weather) {
    const AirFlow flow{weather.wind_speed_m_s * material_.surface.wind_factor, 1.0};
    forced_level_.push_back(film(material_.surface.convection, flow).forced_w_m2_k);
  }
  if (shared.grid.in_long_step > 1) {
    const auto longer = static_cast<double>(shared.grid.in_long_step);
    long_column_.emplace(material.layers, model.settings.grid,
                         Seconds{longer * shared.grid.step_s});
    long_forced_level_ = at_long_stages(forced_level_, shared);
    long_room_k_ = at_long_stages(room_k_, shared);
  }
  solve_references(model, shared);
}

Film MaterialHeat::relative_film(double place_up) const noexcept {
  const Convection& law = material_.surface.convection;
  Film result = film(law, {1.0, place_up});
  const double level = film(law, {1.0, 1.0}).forced_w_m2_k;
  result.forced_w_m2_k = level > 0.0 ? result.forced_w_m2_k / level : 1.0;
  return result;
}

void MaterialHeat::balance_stages(const SharedStages& shared, CellMemory& memory) const {
  const SideLoad &front = memory.sides[0], &back = memory.sides[1];
  const Film front_film = relative_film(front.place_up);
  const Film back_film = open_ ? relative_film(back.place_up) : front_film;
  const std::size_t stages = shared.grid.stages();
  memory.stages.clear();
  memory.stages.reserve(stages);
  for (std::size_t i = 0; i < stages; ++i) {
    const SurfaceLoad load = front.at(i, shared, film_at(i, front_film));
    if (open_) {
      memory.stages.emplace_back(surface(), load, back.at(i, shared, film_at(i, back_film)));
    } else {
      memory.stages.emplace_back(surface(), load);
    }
  }
  if (long_column_) balance_long_stages(shared, memory);
}

void MaterialHeat::balance_long_stages(const SharedStages& shared, CellMemory& memory) const {
  const SideLoad &front = memory.sides[0], &back = memory.sides[1];
  Film front_film = relative_film(front.place_up);
  Film back_film = open_ ? relative_film(back.place_up) : front_film;
  const double front_forced = front_film.forced_w_m2_k, back_forced = back_film.forced_w_m2_k;
  memory.long_stages.clear();
  memory.long_stages.reserve(long_forced_level_.size());
  for (std::size_t i = 0; i < long_forced_level_.size(); ++i) {
    front_film.forced_w_m2_k = front_forced * long_forced_level_[i];
    const SurfaceLoad load = front.at_long(i, shared, front_film);
    if (open_) {
      back_film.forced_w_m2_k = back_forced * long_forced_level_[i];
      memory.long_stages.emplace_back(surface(), load, back.at_long(i, shared, back_film));
    } else {
      memory.long_stages.emplace_back(surface(), load);
    }
  }
}

void MaterialHeat::load_reference(const HeatModel& model, const SharedStages& shared, bool lit,
                                  CellMemory& memory) const {
  Exposure open_ground;
  open_ground.epochs = shared.epochs;
  open_ground.sun_cosine.assign(shared.level_cosine.size(), 0.0F);
  if (lit) {
    for (std::size_t i = 0; i < shared.level_cosine.size(); ++i) {
      open_ground.sun_cosine[i] = static_cast<float>(shared.level_cosine[i]);
    }
  }
  open_ground.seen.assign(shared.epochs.size(), {});
  find_load(model, shared, open_ground, 1.0, memory.sides[0]);
  if (!open_) return;
  // The lower side of a sheet sees nothing but the ground about.
  Exposure below = open_ground;
  below.sun_cosine.assign(shared.level_cosine.size(), 0.0F);
  SurroundingPatch ground{ground_about, 1.0, 1.0, {0.0, 0.0, 1.0}, {}};
  if (lit) ground.sun_cosine = shared.level_patch_cosine;
  below.seen.assign(shared.epochs.size(), {0.0, {ground}});
  find_load(model, shared, below, -1.0, memory.sides[1]);
}

void MaterialHeat::set_steady(const SharedStages& shared, CellMemory& memory) const {
  const ColumnRun day = run(memory).first(shared.grid.day_steps);
  const DepthGrid& grid = column_.grid();
  double room_k = 0.0;
  for (std::size_t i = 0; i < day.room_k.size(); ++i) room_k += day.room_k[i];
  room_k /= static_cast<double>(day.room_k.size());
  const SteadyColumn column = steady_column(grid, material_.layers.back, room_k);
  double k = steady_surface(day, column);
  double flows = column.per_k_w_m2_k * k + column.offset_w_m2;
  memory.temperature_k.assign(grid.nodes(), k);
  for (std::size_t i = 0; i + 1 < grid.nodes(); ++i) {
    flows += grid.heat_w_m2[i];
    k -= flows / grid.conductance_w_m2_k[i];
    memory.temperature_k[i + 1] =
        std::clamp(k, least_temperature.value, greatest_temperature.value);
  }
}

void MaterialHeat::solve_references(const HeatModel& model, const SharedStages& shared) {
  CellMemory memory;
  const SpinUpLimits limits{model.settings.spin_up_k, model.settings.spin_up_days};
  for (const bool lit : {true, false}) {
    load_reference(model, shared, lit, memory);
    balance_stages(shared, memory);
    const ColumnRun all = run(memory), day = all.first(shared.grid.day_steps);
    if (lit) {  // the first one: from scratch
      set_steady(shared, memory);
      day_map_.emplace(day, memory.temperature_k);
      common_k_ = memory.temperature_k.front();
      flux_per_k_ = mean_flux(day, common_k_).per_k_w_m2_k;
    }
    memory.days.resize(2 * column_.nodes());
    const SpinUp done = spin_up(day, *day_map_, limits, memory.temperature_k, memory.days);
    if (!done.repeats) ++references_.not_repeating;
    Reference& reference = lit ? lit_ : shaded_;
    reference.begin_k = memory.temperature_k;
    reference.flux_w_m2 = mean_flux(day, common_k_).w_m2;
    std::vector<double>& series = lit ? emission_.lit : emission_.shaded;
    double before_k = memory.temperature_k.front();
    const std::size_t held = all.march(memory.temperature_k, [&](std::size_t, const StepFlux&) {
      const double after_k = memory.temperature_k.front();
      series.push_back(emitted_at(before_k + Column::gamma * (after_k - before_k)));
      series.push_back(emitted_at(after_k));
      before_k = after_k;
    });
    if (held > 0) ++references_.held;
    memory.temperature_k = reference.begin_k;
  }
}

void MaterialHeat::guess_begin(const SharedStages& shared, CellMemory& memory) const {
  // On the line through the references, by the mean flux that the day would bring to one and the
  // same temperature; what leads far off that line warms or cools the column as a whole.
  const double flux = mean_flux(run(memory).first(shared.grid.day_steps), common_k_).w_m2;
  const double range = lit_.flux_w_m2 - shaded_.flux_w_m2;
  constexpr double least_range_w_m2 = 5.0;
  double place = 0.0;
  if (range > least_range_w_m2) {
    place = std::clamp((flux - shaded_.flux_w_m2) / range, -0.5, 1.5);
  }
  double rest_k = 0.0;
  const Back& back = material_.layers.back;
  if (flux_per_k_ < -1.0 && (open_ || std::holds_alternative<AdiabaticBack>(back))) {
    rest_k = (flux - shaded_.flux_w_m2 - place * range) / -flux_per_k_;
  }
  memory.temperature_k.resize(column_.nodes());
  for (std::size_t i = 0; i < memory.temperature_k.size(); ++i) {
    const double k = shaded_.begin_k[i] + place * (lit_.begin_k[i] - shaded_.begin_k[i]) + rest_k;
    memory.temperature_k[i] = std::clamp(k, least_temperature.value, greatest_temperature.value);
  }
}

SpinUp MaterialHeat::find_begin(const HeatModel& model, const SharedStages& shared,
                                CellMemory& memory) const {
  guess_begin(shared, memory);
  memory.days.resize(2 * column_.nodes());
  if (long_column_ && day_map_->steps_far()) {
    approach({&*long_column_, memory.long_stages, long_room_k_}, *day_map_, memory.temperature_k,
             memory.days);
  }
  return spin_up(run(memory).first(shared.grid.day_steps), *day_map_,
                 {model.settings.spin_up_k, model.settings.spin_up_days}, memory.temperature_k,
                 memory.days);
}

}  // namespace nadir::thermal
