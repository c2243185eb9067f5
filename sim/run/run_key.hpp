#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace nadir::sim {

struct PreparedRun;
struct RunRequest;

/// Something that decides a run's samples: a name that a user knows it by, and its value.
using KeyPart = std::pair<std::string, std::string>;

/// What decides the samples of a run, bit by bit. Not in it: threads, the detectors' noise, which
/// files are written, where the folders lie.
struct RunKey {
  /// What is simulated. Runs that agree in it are of one picture, and may be merged: version,
  /// scenario, files, effects, wavelengths, solver, planes.
  std::vector<KeyPart> physics;
  /// How much is sampled. Runs that differ in it alone do not continue one another, but may be
  /// merged.
  std::vector<KeyPart> sampling;
  std::uint64_t seed = 1;

  // What a run has to be asked for to have this key; not part of it.
  std::filesystem::path scenario;
  std::optional<double> accuracy;
  std::optional<double> time_s;

  [[nodiscard]] bool same_physics(const RunKey& other) const { return physics == other.physics; }
  /// Whether the one run's samples are, bit by bit, the other's.
  [[nodiscard]] bool same_samples(const RunKey& other) const {
    return same_physics(other) && sampling == other.sampling && seed == other.seed;
  }
  /// SHA-256 over all three, 64 hexadecimal digits.
  [[nodiscard]] std::string digest() const;
};

/// What tells two runs apart, for a message: `scenario, file "mesa.obj", effects of array "wide"`;
/// empty where nothing does.
/// @param whole  sampling and seed count as well
[[nodiscard]] std::string differences(const RunKey& a, const RunKey& b, bool whole);

/// The digest of a scenario's content: its elements without <products> and <sampling>, which the
/// key has apart where they matter. Neither comments nor layout count.
/// @throws InputError for text that is not well-formed
[[nodiscard]] std::string scenario_digest(const std::string& text);

/// The key of a run that only has to be rendered.
[[nodiscard]] RunKey run_key(const PreparedRun& run, const RunRequest& request);

/// A key and the seeds of all samples beside it (a merged journal has several, that of the key
/// first) as JSON, and back.
struct KeyedSeeds {
  RunKey key;
  std::vector<std::uint64_t> seeds;
};
[[nodiscard]] std::string to_json(const KeyedSeeds& keyed);
/// @return nothing where the text is not such a JSON
[[nodiscard]] std::optional<KeyedSeeds> keyed_seeds_from(std::string_view json);

}  // namespace nadir::sim
