#include "sim/study/study_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/study/log_plot.hpp"
#include "sim/study/page_plots.hpp"
#include "sim/study/page_tables.hpp"

namespace nadir::sim {
namespace {

constexpr const char* style = R"(<style>
:root { color-scheme: light; }
body { font: 16px/1.5 "Helvetica Neue", Helvetica, Arial, "Liberation Sans", sans-serif;
  color: #1a1a1a; background: #fff; max-width: 62rem; margin: 2rem auto; padding: 0 1.2rem; }
h1 { font-size: 1.7rem; line-height: 1.25; margin: 0 0 .2rem; }
h2 { font-size: 1.2rem; margin: 2.2rem 0 .5rem; border-bottom: 1px solid #ccc; padding-bottom: .2rem; }
p, ul { margin: .5rem 0; } .sub { color: #555; }
table { border-collapse: collapse; width: 100%; font-size: .86rem; margin: .6rem 0;
  font-variant-numeric: tabular-nums; }
th, td { padding: .28rem .55rem; text-align: right; vertical-align: top; border-bottom: 1px solid #e2e2e2; }
th { border-bottom: 2px solid #888; font-weight: 600; } th.w, td.w { text-align: left; }
tr.front td:first-child > span.n { font-weight: 600; } td { white-space: nowrap; } td.w { white-space: normal; } td.bad { color: #a00000; }
pre { background: #f5f5f5; border: 1px solid #ddd; padding: .6rem .8rem; font-size: .82rem;
  white-space: pre-wrap; }
svg.plot { width: 100%; height: auto; display: block; margin: .8rem 0; }
svg.plot text { font: 13px "Helvetica Neue", Helvetica, Arial, "Liberation Sans", sans-serif; fill: #222; }
svg.plot text.t { font-weight: 600; font-size: 14px; } svg.plot text.l { font-size: 14px; }
svg.plot .g { stroke: #d6d6d6; } svg.plot .h { stroke: #f0f0f0; }
.pictures { display: grid; grid-template-columns: 1fr 1fr; gap: 1.2rem; }
figure { margin: 0; } figure img { width: 100%; height: auto; image-rendering: pixelated; border: 1px solid #999; }
figcaption { font-size: .88rem; line-height: 1.4; }
@media (max-width: 40rem) { .pictures { grid-template-columns: 1fr; } }
@media print { body { margin: 0; max-width: none; font-size: 11pt; }
  h2 { break-after: avoid; } figure, svg.plot, tr { break-inside: avoid; } }
</style>
)";

std::string head(const StudyHeader& header) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         // nothing may be fetched, whatever a title may hold
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
         "img-src data:; style-src 'unsafe-inline'\">\n"
         "<link rel=\"icon\" href=\"data:,\">\n<title>Accuracy study: " +
         escape_markup(header.title) + "</title>\n" + style + "</head>\n<body>\n";
}

double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double value : values) most = std::max(most, value);
  return most;
}

std::string introduction(const StudyRecord& record, const StudyResult& result) {
  const StudyHeader& header = record.header;
  int pixels = 0;
  double image = 0.0;
  for (const int count : header.pixels_of_array) pixels += count;
  for (const std::uint64_t count : header.image_pixels) image += static_cast<double>(count);
  std::string html = fmt::format(
      "<h1>{}</h1>\n<p class=\"sub\">What accuracy costs in time \u00B7 picture of {} \u00B7 {} "
      "\u00B7 nadir {}</p>\n",
      escape_markup(header.title), escape_markup(header.time_utc),
      escape_markup(header.scenario.substr(header.scenario.find_last_of('/') + 1)),
      escape_markup(header.version));
  html += fmt::format(
      "<p>{} ways of computing the picture were tried on {} of its {:.0f} pixels (stratified, "
      "drawn at random) in {} band{}, against a reference by the unbiased path solver with {:.0f} "
      "paths a pixel, whose own standard error is {:.2g} % in the worst band. "
      "The study took {} of {} on {} thread{} ({}).</p>\n",
      result.rows.size(), pixels, image, header.bands.size(), header.bands.size() == 1 ? "" : "s",
      result.reference.paths, 100.0 * largest(result.reference.error),
      readable_time(record.spent_s), readable_time(record.finished_budget_s), header.threads,
      header.threads == 1 ? "" : "s", escape_markup(header.processor));
  return html;
}

std::string picture_figure(const StudyPicture& picture) {
  const double shown = static_cast<double>(picture.width) * picture.height;
  std::string html = fmt::format(
      "<figure><img alt=\"{}\" width=\"{}\" height=\"{}\" src=\"data:image/png;base64,{}\">"
      "<figcaption><b>{}</b>: {}, {:g} path{} a pixel<br>",
      escape_markup(picture.label), picture.width, picture.height, picture.png_base64,
      escape_markup(picture.label), escape_markup(picture.settings), picture.paths,
      picture.paths > 1.0 ? "s" : "");
  html += fmt::format(
      "error {:.2g} % (median of its pixels) \u00B7 {} for all pixels \u00B7 {:.0f} "
      "shown in {}</figcaption></figure>\n",
      100.0 * picture.error, readable_time(picture.picture_s), shown,
      readable_time(picture.wall_s));
  return html;
}

std::string pictures(const StudyRecord& record) {
  if (record.pictures.empty()) return "";
  std::string html = "<h2>Pictures along the curve</h2>\n<p>";
  html += "Array " + escape_markup(record.array_shown) + ", the same stretch in all";
  const int step = record.pictures.front().step;
  if (step > 1) html += fmt::format("; one of {0} \u00D7 {0} pixels is shown", step);
  html += ".</p>\n<div class=\"pictures\">\n";
  for (const StudyPicture& picture : record.pictures) html += picture_figure(picture);
  return html + "</div>\n";
}

std::string limits(const StudyRecord& record, const StudyResult& result) {
  std::string html =
      "<h2>Limits</h2>\n<ul>\n"
      "<li>Errors are relative to each pixel's radiance, or to a floor where the pixel is darker; "
      "floors: ";
  for (std::size_t b = 0; b < result.reference.floor.size() && b < 6; ++b) {
    html += fmt::format("{}{} {:.3g}", b > 0 ? ", " : "",
                        escape_markup(record.header.bands[b].name), result.reference.floor[b]);
  }
  html +=
      " W m<sup>-2</sup> sr<sup>-1</sup> \u00B5m<sup>-1</sup>. Without a stated floor it is a "
      "tenth of the band's mean.</li>\n"
      "<li>The pixels are a sample: a rare bright object that none of them sees has no part in "
      "any figure.</li>\n"
      "<li>A bias is told from noise only as far as the reference's own error lets: limits "
      "hold with 95 % confidence, one-sided.</li>\n"
      "<li>Times are this machine's, under the load that it had; loading the scene, its air "
      "and its temperatures is not counted. Beyond the measured points (dashed curves) "
      "they and the errors follow the fitted laws.</li>\n"
      "<li>The reference has the scenario's wavelengths, air and terrain: what those leave out "
      "is not seen here, but for what \u201CWavelengths and air\u201D tells.</li>\n"
      "<li>Memory is that of this process while the row was measured; a run adds some tens of "
      "megabytes of image.</li>\n</ul>\n";
  if (record.warnings.empty()) return html;
  html += "<h2>Warnings of the scenario</h2>\n<ul>\n";
  for (const std::string& warning : record.warnings) {
    html += "<li>" + escape_markup(warning) + "</li>\n";
  }
  return html + "</ul>\n";
}

}  // namespace

std::string study_page(const StudyRecord& record, const StudyResult& result) {
  std::string html = head(record.header) + introduction(record, result);
  html += recommendation_table(record, result);
  html +=
      "<h2>Error against time</h2>\n<p>Each mark is a row at one number of paths; the dashed "
      "curves go on as its noise and bias predict, and flatten out at its bias. Marks on the red "
      "front "
      "are beaten by none in both time and error.</p>\n";
  html += trade_plots(record, result);
  html += pictures(record);
  html +=
      "<h2>Convergence</h2>\n<p>Error<sup>2</sup> = bias<sup>2</sup> + (c "
      "N<sup>\u2212p</sup>)<sup>2</sup>. Independent paths have p = 0.5; low-discrepancy points do "
      "better where the radiance is smooth.</p>\n";
  html += convergence_plot(result);
  html += front_table(result);
  html += row_table(record, result);
  html += paired_table(record, result);
  html += skipped_table(record);
  html += limits(record, result);
  return html + "</body>\n</html>\n";
}

}  // namespace nadir::sim
