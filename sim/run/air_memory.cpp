#include "sim/run/air_memory.hpp"

namespace nadir::sim {

double air_table_memory(const LayeredTask& task, std::size_t lanes, std::size_t bodies) {
  // As AirTable lays its arrays out.
  constexpr double haze_kinds = 4.0, molecules = 1.0, phase_nodes = 257.0;
  constexpr double even_rows = 3.0;  // extinction, E, H
  constexpr double body_rows = 3.0, lane_rows = 3.0;
  constexpr double copies = 2.0;
  const atmosphere::AirSettings& settings = task.settings;
  const bool haze = task.air.aerosol.type != atmosphere::AerosolType::none;
  const double kinds =
      molecules + (haze ? haze_kinds : 0.0) + static_cast<double>(task.air.clouds.size());
  const auto of_bodies = static_cast<double>(bodies);
  const double azimuths = bodies == 0 ? 1.0 : settings.azimuth_nodes;
  const double rows = even_rows + of_bodies * (kinds + azimuths);
  const double one_more_share = 1.0;             // before the night sky
  const double places = settings.zenith_nodes +  // the sky's, then the view's
                        2.0 * settings.zenith_nodes * (settings.share_nodes + one_more_share);
  const double floats = places * rows + kinds * phase_nodes + of_bodies * body_rows + lane_rows;
  return static_cast<double>(lanes) * floats * sizeof(float) * copies;
}

}  // namespace nadir::sim
