#pragma once

#include <string>

#include "sim/products/line_plot.hpp"
#include "sim/run/temperature_at.hpp"

namespace nadir::sim {

/// A place's temperature and its heat balance as a table for people: what it is made of, then a row
/// an hour over the last day before the picture.
[[nodiscard]] std::string heat_text(const TemperatureAt& at);

/// Every step of the record as CSV, units in the names of the columns.
[[nodiscard]] std::string heat_csv(const TemperatureAt& at);

/// Temperatures above, terms of the heat balance below, over the time of day.
[[nodiscard]] LinePlot heat_plot(const TemperatureAt& at);

}  // namespace nadir::sim
