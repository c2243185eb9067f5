#pragma once

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

// Small weather files in the published layouts, made for tests.

namespace nadir::sim::support {

/// Sunlight on level ground of a made-up clear day that is lit from 6 to 18 by the clock.
inline double made_sunlight(double hour) {
  const double height = -std::cos(std::numbers::pi * hour / 12.0);
  return height > 0.0 ? std::round(800.0 * height) : 0.0;
}

/// An EPW file of whole days from a date on; hours end where they say. `change` may alter the
/// cells.
struct EpwDay {
  int year = 2001, month = 6, day = 20;
};
inline std::string epw_header(
    const std::string& location = "LOCATION,Somewhere,NC,USA,TMY3,723170,36.1,-79.95,-5.0,273.0",
    const std::string& records = "1") {
  return location +
         "\nDESIGN CONDITIONS,0\nTYPICAL/EXTREME PERIODS,0\nGROUND TEMPERATURES,0\n"
         "HOLIDAYS/DAYLIGHT SAVINGS,No,0,0,0\nCOMMENTS 1,made for a test\nCOMMENTS 2,\n"
         "DATA PERIODS,1," +
         records + ",Data,Sunday,6/20,6/22\n";
}
/// One row. 35 cells: date, flags, temperatures, humidity, pressure, radiation, illuminance, wind,
/// clouds, the rest missing.
inline std::string epw_row(const EpwDay& day, int hour, const std::string& dry = "25.0",
                           const std::string& infrared = "350") {
  const double light = made_sunlight(hour - 0.5);
  const char* dew = std::stod(dry) < 15.0 ? dry.c_str() : "15.0";
  return fmt::format(
      "{},{},{},{},60,?9?9?9?9E0,{},{},54,98000,0,0,{},{:g},{:g},{:g},0,0,0,0,200,3.1,5,4,"
      "20.0,77777,9,999999999,20,0.1,0,88,0.2,0.0,1.0\n",
      day.year, day.month, day.day, hour, dry, dew, infrared, light, 0.5 * light, 0.4 * light);
}

inline std::string surfrad_header() { return " Bondville\n   40.05  -88.37  213 m  version 1\n"; }
struct SurfradTime {
  int year = 2010, day_of_year = 171, month = 6, day = 20, minute_of_day = 0;
};
/// One row of 48 numbers; the values we read and their flags are as given, all else is missing.
inline std::string surfrad_row(const SurfradTime& t, double global, double temperature_c,
                               const std::string& global_flag = "0") {
  const std::string none = " -9999.9 0";
  std::string row =
      fmt::format(" {} {:3d} {:2d} {:2d} {:2d} {:2d} {:6.3f} 45.00", t.year, t.day_of_year, t.month,
                  t.day, t.minute_of_day / 60, t.minute_of_day % 60, t.minute_of_day / 60.0);
  row += fmt::format(" {:.1f} {}", global, global_flag) + none;            // dw_solar, uw_solar
  row += fmt::format(" {:.1f} 0 {:.1f} 0", 0.75 * global, 0.25 * global);  // direct_n, diffuse
  row += " 380.5 0";                                                       // dw_ir
  for (int i = 0; i < 10; ++i) row += none;                                // cases to totalnet
  row += fmt::format(" {:.1f} 0 60.0 0 3.5 0 180.0 0 990.2 0\n", temperature_c);
  return row;
}

}  // namespace nadir::sim::support
