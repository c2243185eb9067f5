#pragma once

#include <string>

#include "scenario_support.hpp"

// Small cameras for the tests of scenarios and sensor files.

namespace nadir::test {

/// The minimal scenario with another camera; one line an argument keeps the messages' lines.
inline std::string with_camera(const std::string& inside) {
  std::string text = minimal_text();
  const std::size_t begin = text.find("<camera>"), end = text.find("</camera>");
  return text.replace(begin, end - begin, "<camera>\n" + inside);
}

/// A perspective camera with what its array holds, in line 21 of the scenario, and what else the
/// array says.
inline std::string with_array(const std::string& inside, const std::string& attributes = {}) {
  return with_camera(
      "<perspective focal_length_mm=\"50\">\n<array name=\"a\" samples=\"100\" "
      "lines=\"40\" pitch_um=\"10\" " +
      attributes + ">\n" + inside + "\n</array></perspective>\n");
}

inline sim::Scenario read_text(const std::string& text) {
  Diagnostics diagnostics;
  return sim::parse_scenario(text, data_folder() / "test.xml", diagnostics);
}

constexpr const char* green_band = R"(<band_box name="g" lo_um="0.5" hi_um="0.6"/>)";

/// A camera of two line arrays that look at the ground one after the other, the second with pixels
/// of half the size.
constexpr const char* pushbroom_sensor = R"(<sensor name="twin" title="Two rows" platform="bird"
  nominal_height_m="500000" ground_speed_m_s="7000" source="a test">
<perspective focal_length_mm="1000">
<array name="ms" samples="1000" lines="200" pitch_um="20" offset_y_um="-100">
<pushbroom line_period_ms="1.5" exposure_ms="1"/>
<module first_sample="0" samples="500" offset_y_um="30"/>
<module first_sample="500" samples="500" offset_y_um="-30" rotation_deg="0.1"/>
<band_box name="g" lo_um="0.5" hi_um="0.6"/>
</array>
<array name="pan" samples="2000" lines="400" pitch_um="10" offset_y_um="100">
<pushbroom line_period_ms="0.75" exposure_ms="0.7"/>
<band_box name="p" lo_um="0.4" hi_um="0.8"/>
</array>
</perspective>
</sensor>
)";

}  // namespace nadir::test
