#include "sensor/optics/wavelength_quantiles.hpp"

#include <vector>

namespace nadir::sensor {

WavelengthQuantiles::WavelengthQuantiles(const spectral::Response& response) {
  constexpr std::size_t cells = 4096;  // finer than any published response
  const spectral::Support support = spectral::support(response);
  const double width_um = (support.hi.value - support.lo.value) / static_cast<double>(cells);
  const auto edge = [&](double cell) { return support.lo.value + cell * width_um; };
  std::vector<double> area{0.0};
  for (std::size_t i = 0; i < cells; ++i) {
    const Micrometres middle{edge(static_cast<double>(i) + 0.5)};
    area.push_back(area.back() + spectral::at(response, middle));
  }
  std::size_t cell = 0;
  for (std::size_t part = 0; part <= parts; ++part) {
    const double target = area.back() * static_cast<double>(part) / static_cast<double>(parts);
    while (cell + 1 < cells && area[cell + 1] < target) ++cell;
    const double inside = area[cell + 1] - area[cell];
    const double share = inside > 0.0 ? (target - area[cell]) / inside : 0.0;
    edges_um_[part] = edge(static_cast<double>(cell) + share);
  }
}

}  // namespace nadir::sensor
