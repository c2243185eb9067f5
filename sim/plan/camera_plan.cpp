#include "sim/plan/camera_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"

namespace nadir::sim {
namespace {

using spectral::AbsorptionLane;
using spectral::LaneShare;

/// A node of a band's quadrature and the part of the band that it stands for.
using Node = std::pair<Micrometres, AbsorptionLane>;

std::size_t at_index(int number) { return static_cast<std::size_t>(number); }

/// The nodes of every band of an array.
std::vector<std::vector<Node>> nodes_of(const sensor::DetectorArray& array, const ArrayPlan& plan) {
  std::vector<std::vector<Node>> nodes;
  for (std::size_t band = 0; band < array.bands.size(); ++band) {
    const spectral::BandQuadrature& quadrature = plan.quadratures[band];
    const auto edges = spectral::interval_edges(array.bands[band].response, quadrature);
    auto& of_band = nodes.emplace_back();
    for (std::size_t i = 0; i < quadrature.wavelengths.size(); ++i) {
      of_band.emplace_back(quadrature.wavelengths[i],
                           AbsorptionLane{edges[i].value, edges[i + 1].value, 0});
    }
  }
  return nodes;
}

using CameraNodes = std::vector<std::vector<std::vector<Node>>>;  // [array][band][node]

CameraNodes nodes_of(const std::vector<sensor::DetectorArray>& arrays, const CameraPlan& plan) {
  CameraNodes nodes;
  for (std::size_t a = 0; a < arrays.size(); ++a) {
    nodes.push_back(nodes_of(arrays[a], plan.arrays[a]));
  }
  return nodes;
}

AirLanes distinct(const CameraNodes& of_arrays) {
  std::vector<Node> nodes;
  for (const auto& bands : of_arrays) {
    for (const auto& band : bands) nodes.insert(nodes.end(), band.begin(), band.end());
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  AirLanes found;
  for (const auto& [wavelength, interval] : nodes) {
    found.wavelengths.push_back(wavelength);
    found.intervals.push_back(interval);
  }
  return found;
}

AirLanes air_lanes(const CameraNodes& of_arrays, const atmosphere::Layered& air,
                   const atmosphere::AirSettings& settings) {
  AirLanes found = distinct(of_arrays);
  found.lanes = atmosphere::split_lanes(air, settings, found.wavelengths, found.intervals);
  std::sort(found.lanes.begin(), found.lanes.end(), [](const auto& a, const auto& b) {
    return std::pair{a.source, a.absorption} < std::pair{b.source, b.absorption};
  });
  return found;
}

/// The lanes that a table holds.
AirLanes lanes_of(const atmosphere::AirTable& table) {
  AirLanes found;
  for (const auto& [wavelength_um, absorption, weight] : table.lanes) {
    const AbsorptionLane interval{absorption.lo_um, absorption.hi_um, 0};
    const Node node{Micrometres{wavelength_um}, interval};
    if (found.wavelengths.empty() ||
        Node{found.wavelengths.back(), found.intervals.back()} != node) {
      found.wavelengths.push_back(node.first);
      found.intervals.push_back(interval);
    }
    found.lanes.push_back({static_cast<int>(found.wavelengths.size()) - 1, absorption, weight});
  }
  return found;
}

/// The lanes of a band: those of each of its nodes.
/// @throws InputError for a node that has none
std::vector<LaneShare> shares(const std::vector<Node>& nodes, const std::vector<double>& weights,
                              const AirLanes& air) {
  std::vector<LaneShare> found;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto before = [&](const atmosphere::SplitLane& lane, const Node& node) {
      const std::size_t source = at_index(lane.source);
      return Node{air.wavelengths[source], air.intervals[source]} < node;
    };
    auto lane = std::lower_bound(air.lanes.begin(), air.lanes.end(), nodes[i], before);
    const int source = lane == air.lanes.end() ? -1 : lane->source;
    const bool known = source >= 0 && !(nodes[i] < Node{air.wavelengths[at_index(source)],
                                                        air.intervals[at_index(source)]});
    if (!known) {
      throw InputError{
          fmt::format("the table of the air was made for other bands: it has no lanes "
                      "for {:.6g} um",
                      nodes[i].first.value)};
    }
    for (; lane != air.lanes.end() && lane->source == source; ++lane) {
      found.push_back({nodes[i].first, lane->absorption, weights[i] * lane->weight});
    }
  }
  return found;
}

/// Takes every array's lanes from those of the air.
void split(const CameraNodes& nodes, CameraPlan& plan) {
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    std::vector<std::vector<LaneShare>> bands;
    for (std::size_t band = 0; band < nodes[a].size(); ++band) {
      bands.push_back(shares(nodes[a][band], plan.arrays[a].quadratures[band].weights, plan.air));
    }
    plan.arrays[a].lanes = spectral::plan_split_lanes(bands);
  }
}

}  // namespace

WavelengthRange wavelength_range(const CameraPlan& plan) {
  WavelengthRange range{Micrometres{1e300}, Micrometres{0.0}};
  for (const ArrayPlan& array : plan.arrays) {
    for (const auto& quadrature : array.quadratures) {
      range.lo = std::min(range.lo, quadrature.wavelengths.front());
      range.hi = std::max(range.hi, quadrature.wavelengths.back());
    }
  }
  return range;
}

CameraPlan plan_camera(const std::vector<sensor::DetectorArray>& arrays,
                       const BandNodes& per_band) {
  CameraPlan plan;
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    plan.arrays.push_back(plan_array(arrays[i], per_band, i));
  }
  return plan;
}

AirLanes air_nodes(const std::vector<sensor::DetectorArray>& arrays, const BandNodes& per_band) {
  return distinct(nodes_of(arrays, plan_camera(arrays, per_band)));
}

CameraPlan plan_camera(const std::vector<sensor::DetectorArray>& arrays, const BandNodes& per_band,
                       const atmosphere::Layered& air, const atmosphere::AirSettings& settings) {
  CameraPlan plan = plan_camera(arrays, per_band);
  const CameraNodes nodes = nodes_of(arrays, plan);
  plan.air = air_lanes(nodes, air, settings);
  split(nodes, plan);
  return plan;
}

CameraPlan plan_camera(const std::vector<sensor::DetectorArray>& arrays, const BandNodes& per_band,
                       const atmosphere::AirTable& table) {
  CameraPlan plan = plan_camera(arrays, per_band);
  const bool is_split = std::any_of(table.lanes.begin(), table.lanes.end(), [](const auto& lane) {
    return lane.absorption != AbsorptionLane{};
  });
  if (!is_split) return plan;
  plan.air = lanes_of(table);
  split(nodes_of(arrays, plan), plan);
  return plan;
}

}  // namespace nadir::sim
