#include "sim/study/page_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "sim/run/progress.hpp"
#include "sim/study/log_plot.hpp"

namespace nadir::sim {
namespace {

// M. Okabe and K. Ito, "Color universal design" (2008): told apart also by the colour-blind.
constexpr std::array key_colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                 "#B8860B", "#56B4E9", "#000000"};
constexpr const char* other_colour = "#b5b5b5";
constexpr int curve_beyond = 64;  // curves go on to so many times the paths that were measured

/// Bands of one array, by their number in the study.
std::vector<std::size_t> bands_of_array(const StudyHeader& header, std::size_t array) {
  std::vector<std::size_t> bands;
  for (std::size_t b = 0; b < header.bands.size(); ++b) {
    if (header.bands[b].array_number == array) bands.push_back(b);
  }
  return bands;
}

double worst_in(const LevelFigures& level, const std::vector<std::size_t>& bands) {
  double worst = 0.0;
  for (const std::size_t b : bands) worst = std::max(worst, level.error[b]);
  return worst;
}

/// A row's law: what it would do with more and more paths, down to its bias.
std::vector<LogPoint> law_of(const RowFigures& row, const StudyHeader& header,
                             const std::vector<std::size_t>& bands) {
  std::vector<LogPoint> curve;
  const double last = static_cast<double>(curve_beyond) * row.levels.back().samples;
  for (double samples = row.levels.front().samples; samples <= 1.001 * last; samples *= 2.0) {
    double worst = 0.0;
    for (const std::size_t b : bands) {
      worst = std::max(worst, row.error(b, header.replicates, samples));
    }
    curve.push_back(
        {row.picture_s(header.replicates * samples, header.threads), 100.0 * worst, 0.0, {}});
  }
  return curve;
}

std::vector<LogPoint> levels_of(const RowFigures& row, const std::vector<std::size_t>& bands) {
  std::vector<LogPoint> points;
  for (const LevelFigures& level : row.levels) {
    const double worst = worst_in(level, bands);
    points.push_back({level.picture_s, 100.0 * worst, 0.0,
                      fmt::format("{}: {:g} paths a pixel, {:.3g} %, {}", row.point.name,
                                  level.paths, 100.0 * worst, readable_time(level.picture_s))});
  }
  return points;
}

LogSeries front_series(const StudyResult& result, const std::vector<std::size_t>& bands) {
  std::vector<CostPoint> costs;
  std::vector<LogPoint> points;
  for (const TradePoint& point : result.points) {
    const LevelFigures& level = result.rows[point.row].levels[point.level];
    costs.push_back({level.picture_s, worst_in(level, bands)});
    points.push_back({costs.back().time_s, 100.0 * costs.back().error, 0.0, {}});
  }
  LogSeries front{"Pareto front", {"#c00000", true, true, 5.5, true, false}, {}};
  for (const std::size_t i : pareto_front(costs)) front.points.push_back(points[i]);
  return front;
}

std::string trade_plot(const StudyHeader& header, const StudyResult& result, std::size_t array) {
  const auto bands = bands_of_array(header, array);
  const std::string name = header.bands[bands.front()].array;
  LogPlot plot{fmt::format("Array {}: error against time (the worst of its {} band{})", name,
                           bands.size(), bands.size() == 1 ? "" : "s"),
               fmt::format("time of the whole picture on {} thread{}, s", header.threads,
                           header.threads == 1 ? "" : "s"),
               "rms error of a pixel, % of its radiance",
               {}};
  plot.series.push_back(front_series(result, bands));
  const auto keys = key_rows(result);
  LogSeries others{"other rows", {other_colour, false, false, 2.6}, {}};
  for (std::size_t r = 0; r < result.rows.size(); ++r) {
    const RowFigures& row = result.rows[r];
    if (row.point.paired || std::find(keys.begin(), keys.end(), r) != keys.end()) continue;
    for (LogPoint& point : levels_of(row, bands)) others.points.push_back(std::move(point));
  }
  if (!others.points.empty()) plot.series.push_back(std::move(others));
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const RowFigures& row = result.rows[keys[k]];
    plot.series.push_back({"", {key_colours[k], true, true, 0.0}, law_of(row, header, bands)});
    plot.series.push_back(
        {row.point.name, {key_colours[k], false, false, 3.6}, levels_of(row, bands)});
  }
  return to_svg(plot);
}

}  // namespace

std::string readable_time(double seconds) {
  if (!std::isfinite(seconds)) return "-";
  if (seconds < 0.1) return fmt::format("{:.2g} ms", 1e3 * seconds);
  if (seconds < 1.0) return fmt::format("{:.2g} s", seconds);
  if (seconds < 20.0) return fmt::format("{:.1f} s", seconds);
  if (seconds < 48.0 * 3600.0) return readable_duration(seconds);
  return fmt::format("{:.0f} days", seconds / 86400.0);
}

std::vector<std::size_t> key_rows(const StudyResult& result) {
  std::vector<std::size_t> keys;
  const auto add = [&](std::size_t row) {
    if (keys.size() < key_colours.size() && !result.rows[row].point.paired &&
        std::find(keys.begin(), keys.end(), row) == keys.end()) {
      keys.push_back(row);
    }
  };
  for (std::size_t r = 0; r < result.rows.size(); ++r) {
    if (result.rows[r].point.group == "method") add(r);
  }
  for (const Recommendation& advice : result.recommendations) {
    for (std::size_t r = 0; r < result.rows.size(); ++r) {
      if (advice.reached && result.rows[r].point.name == advice.row) add(r);
    }
  }
  for (const TradePoint& point : result.pareto) add(point.row);
  for (std::size_t r = 0; r < result.rows.size(); ++r) {
    if (result.rows[r].point.group == "known good") add(r);
  }
  return keys;
}

std::string trade_plots(const StudyRecord& record, const StudyResult& result) {
  std::string html;
  std::set<std::size_t> arrays;
  for (const StudyBand& band : record.header.bands) arrays.insert(band.array_number);
  for (const std::size_t array : arrays) html += trade_plot(record.header, result, array);
  return html;
}

std::string convergence_plot(const StudyResult& result) {
  LogPlot plot{"Error of one replicate against the reference, rms over pixels and bands",
               "paths a pixel",
               "error, % of the radiance",
               {}};
  const auto keys = key_rows(result);
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const RowFigures& row = result.rows[keys[k]];
    if (row.errors.empty()) continue;
    LogSeries measured{"", {key_colours[k], false, false, 3.6}, {}};
    for (const RatePoint& p : row.errors) {
      measured.points.push_back({p.paths, 100.0 * p.error, 100.0 * p.uncertainty, {}});
    }
    double bias2 = 0.0;
    for (const RowBand& band : row.bands) bias2 += band.pixel_bias * band.pixel_bias;
    bias2 /= static_cast<double>(row.bands.size());
    LogSeries fitted{row.point.name, {key_colours[k], true, false, 0.0}, {}};
    const double last = row.errors.back().paths;
    for (double paths = row.errors.front().paths; paths <= 1.001 * last; paths *= 2.0) {
      const double noise = row.rate.error(paths);
      fitted.points.push_back({paths, 100.0 * std::sqrt(noise * noise + bias2), 0.0, {}});
    }
    if (std::isfinite(row.rate.rate_uncertainty)) {
      fitted.name += fmt::format(", p = {:.2f} \u00B1 {:.2f}", row.rate.rate,
                                 std::max(0.01, row.rate.rate_uncertainty));
    }
    plot.series.push_back(std::move(measured));
    plot.series.push_back(std::move(fitted));
  }
  return to_svg(plot);
}

}  // namespace nadir::sim
