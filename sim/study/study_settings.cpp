#include "sim/study/study_settings.hpp"

#include <fmt/format.h>

namespace nadir::sim {
namespace {

std::string nodes_text(const BandNodes& nodes) {
  if (nodes.by_array.empty()) return fmt::format("{}", nodes.everywhere);
  std::string text;
  for (const auto& array : nodes.by_array) {
    if (!text.empty()) text += ";";
    for (std::size_t band = 0; band < array.size(); ++band) {
      text += fmt::format("{}{}", band > 0 ? "," : "", array[band]);
    }
  }
  return text;
}

std::string solver_words(const StudySettings& settings) {
  const materials::SolverSettings& s = settings.generic;
  if (settings.method == radiometry::Method::path) {
    if (settings.path_max_bounces == 0) return "path solver";
    return fmt::format("path solver, at most {} bounces", settings.path_max_bounces);
  }
  return fmt::format("generic: {} sample{}, decay {:g}, {} bounce{}, {} x {} quads, top-up {}",
                     s.initial_sample_count, s.initial_sample_count == 1 ? "" : "s",
                     s.sample_decay_rate, s.max_bounces, s.max_bounces == 1 ? "" : "s",
                     s.mu_samples, s.phi_samples, s.min_quad_samples);
}

}  // namespace

std::string readable(const StudySettings& settings) {
  std::string text = solver_words(settings);
  if (settings.air_streams == 2) text += ", air of two streams";
  if (settings.air_streams > 2) text += fmt::format(", air of {} streams", settings.air_streams);
  return text;
}

std::string key_of(const StudySettings& settings) {
  return fmt::format("{}|wavelengths {}|air {}", solver_words(settings),
                     nodes_text(settings.wavelengths), settings.air_streams);
}

std::string solver_element(const StudySettings& settings) {
  const materials::SolverSettings& s = settings.generic;
  if (settings.method == radiometry::Method::path) {
    if (settings.path_max_bounces == 0) return R"(<solver method="path"/>)";
    return fmt::format(R"(<solver method="path" path_max_bounces="{}"/>)",
                       settings.path_max_bounces);
  }
  return fmt::format(
      R"(<solver method="generic" initial_sample_count="{}" sample_decay_rate="{:g}" )"
      R"(max_bounces="{}" mu_samples="{}" phi_samples="{}" min_quad_samples="{}"/>)",
      s.initial_sample_count, s.sample_decay_rate, s.max_bounces, s.mu_samples, s.phi_samples,
      s.min_quad_samples);
}

}  // namespace nadir::sim
