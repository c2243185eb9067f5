#include "sim/study/page_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "sim/study/log_plot.hpp"
#include "sim/study/page_plots.hpp"

namespace nadir::sim {
namespace {

std::string percent_text(double share) { return fmt::format("{:.2g} %", 100.0 * share); }

double largest_advice_bias(const Recommendation& advice) {
  double most = 0.0;
  for (const double bias : advice.bias) most = std::max(most, bias);
  return most;
}

std::string bias_text(const Recommendation& advice) {
  const bool path = advice.settings.method == radiometry::Method::path;
  if (path && advice.settings.path_max_bounces == 0) return "none";
  const double most = largest_advice_bias(advice);
  return most > 0.0 ? percent_text(most) : std::string{"none seen"};
}

std::string recommendation_line(const Recommendation& advice) {
  std::string html = fmt::format("<tr><td>{:g} %</td>", 100.0 * advice.target);
  if (!advice.reached) {
    return html + "<td class=\"w bad\" colspan=\"6\">" + escape_markup(advice.reason) +
           "</td></tr>\n";
  }
  html += fmt::format("<td class=\"w\">{}<br><span class=\"sub\">{}</span></td>",
                      escape_markup(readable(advice.settings)), escape_markup(advice.reason));
  html += fmt::format("<td>{} = {} \u00D7 {}</td>", advice.replicates * advice.samples,
                      advice.replicates, advice.samples);
  html += fmt::format(
      "<td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", percent_text(advice.error),
      std::isfinite(advice.found_error) ? percent_text(advice.found_error) : "not tried",
      bias_text(advice), readable_time(advice.picture_s));
  return html;
}

/// What to write into the scenario, each once.
std::string elements_of(const StudyResult& result) {
  std::string text;
  for (const Recommendation& advice : result.recommendations) {
    if (!advice.reached) continue;
    text += fmt::format(
        "for {:g} %:\n  {}\n  <sampling replicates=\"{}\" "
        "samples_per_replicate=\"{}\" .../>\n",
        100.0 * advice.target, solver_element(advice.settings), advice.replicates, advice.samples);
  }
  return text.empty() ? "" : "<pre>" + escape_markup(text) + "</pre>\n";
}

/// The band whose figure is largest.
template <class Figure>
std::size_t worst_band(const RowFigures& row, Figure figure) {
  std::size_t worst = 0;
  for (std::size_t b = 1; b < row.bands.size(); ++b) {
    if (figure(row.bands[b]) > figure(row.bands[worst])) worst = b;
  }
  return worst;
}

std::string bias_cell(const RowBand& band) {
  const bool seen = std::abs(band.bias) > 3.0 * band.bias_error;
  return fmt::format("<td>{}{:+.2g} \u00B1 {:.1g}{}</td>", seen ? "<b>" : "", 100.0 * band.bias,
                     100.0 * band.bias_error, seen ? "</b>" : "");
}

std::string pixel_bias_cell(const RowFigures& row) {
  if (row.point.unbiased()) return "<td>0</td>";
  const RowBand& band =
      row.bands[worst_band(row, [](const RowBand& b) { return b.pixel_bias_limit; })];
  const double square = band.pixel_bias * band.pixel_bias;
  if (square > band.pixel_bias_limit * band.pixel_bias_limit - square) {  // beyond its own margin
    return fmt::format("<td>{:.2g}</td>", 100.0 * band.pixel_bias);
  }
  return fmt::format("<td>&lt; {:.2g}</td>", 100.0 * band.pixel_bias_limit);
}

std::string rate_cell(const RateFit& rate) {
  if (!std::isfinite(rate.rate_uncertainty)) return "<td></td>";
  return fmt::format("<td>{:.2f} \u00B1 {:.2f}</td>", rate.rate,
                     std::max(0.01, rate.rate_uncertainty));
}

std::string row_line(const RowFigures& row, const StudyHeader& header, bool on_front) {
  const std::size_t biased = worst_band(
      row, [](const RowBand& b) { return std::abs(b.bias) / std::max(b.bias_error, 1e-12); });
  const std::size_t noisy = worst_band(row, [](const RowBand& b) { return b.path_noise; });
  std::string html = fmt::format(
      "<tr{}><td class=\"w\"><span class=\"n\">{}</span><br><span class=\"sub\">{}</span></td>",
      on_front ? " class=\"front\"" : "", escape_markup(row.point.name),
      escape_markup(readable(row.point.settings)));
  html += fmt::format("<td>{:.3g}</td>", 100.0 * row.bands[noisy].path_noise);
  html += bias_cell(row.bands[biased]);
  html += fmt::format("<td class=\"w\">{}</td>", escape_markup(header.bands[biased].name));
  html += pixel_bias_cell(row) + rate_cell(row.rate);
  html += fmt::format("<td>{:.1f}</td><td>{:.3g}</td><td>{:.3g}</td><td>{:.0f}</td></tr>\n",
                      row.rays_per_path, 1e6 * row.path_cpu_s, 1e6 * row.path_wall_s,
                      1e-6 * row.peak_memory_bytes);
  return html;
}

}  // namespace

std::string recommendation_table(const StudyRecord& record, const StudyResult& result) {
  std::string html =
      "<h2>Recommended settings</h2>\n<table>\n<tr><th>error wanted</th><th class=\"w\">settings"
      "</th><th>paths a pixel</th><th>error predicted</th><th>found when tried</th><th>of it bias"
      "</th><th>time of the picture</th></tr>\n";
  for (const Recommendation& advice : result.recommendations) html += recommendation_line(advice);
  html += fmt::format(
      "</table>\n<p class=\"sub\">Error: rms over pixels, of the worst of all bands. Paths: "
      "replicates \u00D7 samples of each. Time: of all pixels on {} thread{}, without "
      "loading.</p>\n",
      record.header.threads, record.header.threads == 1 ? "" : "s");
  return html + elements_of(result);
}

std::string front_table(const StudyResult& result) {
  std::string html =
      "<h2>The front in figures</h2>\n<p>The least error in a given time, the least time for a "
      "given error (worst band), of what was measured.</p>\n<table>\n<tr><th>time of the "
      "picture</th><th>error</th><th>paths a pixel</th><th class=\"w\">row</th></tr>\n";
  for (const TradePoint& point : result.pareto) {
    const RowFigures& row = result.rows[point.row];
    html += fmt::format("<tr><td>{}</td><td>{}</td><td>{:g}</td><td class=\"w\">{}</td></tr>\n",
                        readable_time(point.cost.time_s), percent_text(point.cost.error),
                        row.levels[point.level].paths, escape_markup(row.point.name));
  }
  return html + "</table>\n";
}

std::string row_table(const StudyRecord& record, const StudyResult& result) {
  std::set<std::size_t> front;
  for (const TradePoint& point : result.pareto) front.insert(point.row);
  std::string html =
      "<h2>Bias and noise apart</h2>\n<table>\n<tr><th class=\"w\">row</th><th>noise of one path, "
      "%</th><th>bias of the mean, %</th><th class=\"w\">in band</th><th>rms bias of a pixel, %"
      "</th><th>rate p</th><th>rays a path</th><th>processor, \u00B5s a path</th><th>clock, "
      "\u00B5s a "
      "path</th><th>memory, MB</th></tr>\n";
  for (std::size_t r = 0; r < result.rows.size(); ++r) {
    if (!result.rows[r].point.paired) {
      html += row_line(result.rows[r], record.header, front.contains(r));
    }
  }
  return html +
         "</table>\n<p class=\"sub\">Noise: standard deviation of one path, rms over pixels, of "
         "the "
         "noisiest band. Bias: signed, of the mean over pixels, \u00B1 its standard error, in the "
         "band "
         "where it stands out most; <b>bold</b> beyond three standard errors. Rms bias of a pixel: "
         "noise of both sides taken off; \u201C&lt;\u201D where it is not told from none. Rows of "
         "the "
         "front have bold names. All figures by band are in study.csv and study.json.</p>\n";
}

std::string paired_table(const StudyRecord& record, const StudyResult& result) {
  std::string lines;
  for (const RowFigures& row : result.rows) {
    if (!row.point.paired) continue;
    const std::size_t worst = worst_band(row, [](const RowBand& b) { return b.pixel_bias_limit; });
    lines += fmt::format("<tr><td class=\"w\">{}</td>", escape_markup(row.point.name));
    lines += bias_cell(row.bands[worst]);
    lines += fmt::format("<td>{:.2g}</td><td class=\"w\">{}</td><td>{:.3g}</td></tr>\n",
                         100.0 * row.bands[worst].pixel_bias,
                         escape_markup(record.header.bands[worst].name), 1e6 * row.path_cpu_s);
  }
  if (lines.empty()) return "";
  return "<h2>Wavelengths and air</h2>\n<p>What else the answer depends on: the path solver with "
         "the same random numbers as in its own row, so that nearly all noise cancels. The "
         "reference has the scenario's: twice the wavelengths tell what that leaves out of every "
         "row.</p>\n<table>\n<tr><th class=\"w\">changed</th><th>mean difference, %</th><th>rms "
         "of a pixel, %</th><th class=\"w\">in band</th><th>processor, \u00B5s a path</th></tr>\n" +
         lines + "</table>\n";
}

std::string skipped_table(const StudyRecord& record) {
  if (record.skips.empty()) return "";
  std::string html =
      "<h2>Not measured</h2>\n<table>\n<tr><th class=\"w\">row</th>"
      "<th class=\"w\">why</th></tr>\n";
  const auto points = study_points(record.header.scope);
  for (const StudySkip& skip : record.skips) {
    std::string name = skip.key;
    for (const StudyPoint& point : points) {
      if (key_of(point.settings) == skip.key) name = point.name;
    }
    html += fmt::format("<tr><td class=\"w\">{}</td><td class=\"w\">{}</td></tr>\n",
                        escape_markup(name), escape_markup(skip.reason));
  }
  return html + "</table>\n";
}

}  // namespace nadir::sim
