#include "thermal/solve/record_maker.hpp"

#include <numeric>

namespace nadir::thermal {
namespace {

void add_terms(BalanceTerms& sum, const BalanceTerms& more) {
  sum.direct += more.direct;
  sum.diffuse += more.diffuse;
  sum.reflected += more.reflected;
  sum.sky_long_wave += more.sky_long_wave;
  sum.surroundings_long_wave += more.surroundings_long_wave;
  sum.emitted += more.emitted;
  sum.convected += more.convected;
  sum.evaporated += more.evaporated;
}

}  // namespace

BalanceTerms RecordMaker::terms(std::size_t stage, double surface_k) const {
  BalanceTerms sum;
  const std::size_t sides = heat_.open() ? 2 : 1;
  for (std::size_t i = 0; i < sides; ++i) {
    const SideLoad& side = memory_.sides[i];
    const Film film = heat_.film_at(stage, heat_.relative_film(side.place_up));
    add_terms(sum, balance(heat_.surface(), side.at(stage, shared_, film), surface_k));
  }
  return sum;
}

void RecordMaker::fill(HeatRecord& record) const {
  const Column& column = heat_.column();
  const std::vector<double>& temperature_k = memory_.temperature_k;
  const auto& released = column.grid().heat_w_m2;
  const double inner_w_m2 = std::accumulate(released.begin(), released.end(), 0.0);
  const double step_s = shared_.grid.step_s;
  const double before_j_m2 = column.heat_j_m2(temperature_k);
  record.rows.reserve(shared_.grid.steps);
  heat_.run(memory_).march(memory_.temperature_k, [&](std::size_t step, const StepFlux& flux) {
    const std::size_t stage = 2 * step + 1;
    HeatRecord::Row row;
    row.time_s = shared_.grid.stage_s(stage);
    row.surface_k = temperature_k.front();
    row.back_k = temperature_k.back();
    row.terms = terms(stage, row.surface_k);
    row.conducted = flux.surface_w_m2;
    row.sun_cosine = asked_.sun_cosine[stage];
    row.weather = shared_.weather[stage];
    record.rows.push_back(row);
    record.received_j_m2 += step_s * (flux.surface_w_m2 + flux.back_w_m2 + inner_w_m2);
  });
  record.stored_j_m2 = column.heat_j_m2(temperature_k) - before_j_m2;
}

}  // namespace nadir::thermal
