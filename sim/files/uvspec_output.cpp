#include "sim/files/uvspec_output.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/quantity.hpp"
#include "core/text.hpp"
#include "sim/files/text_tokens.hpp"
#include "sim/files/uvspec_input.hpp"

namespace nadir::sim {
namespace {

/// What stands for one wavelength and level.
struct Block {
  double lambda_nm = 0.0;
  double edir = 0.0, edn = 0.0, spherical_albedo = -1.0;
  std::vector<double> radiance;  ///< umu by umu, phi fastest
};

class Output {
 public:
  Output(const UvspecInput& input, const NamedText& output)
      : in_{input}, rest_{output.text}, issues_{output.name} {}

  /// [wavelength][level]
  std::vector<std::vector<Block>> blocks() {
    std::vector<std::vector<Block>> all;
    while (const auto line = next_row()) {
      const Block block = in_.columns.empty() ? disort_block(*line) : user_row(*line);
      if (all.empty() || all.back().size() == in_.level_m.size()) {
        if (!all.empty() && block.lambda_nm <= all.back().front().lambda_nm) {
          fail(*line, "the wavelengths do not ascend");
        }
        all.emplace_back();
      }
      if (!all.back().empty()) same_wavelength(*line, all.back().front(), block);
      all.back().push_back(block);
    }
    if (all.empty() || all.back().size() != in_.level_m.size()) {
      issues_.add(all.empty() ? "the output is empty" : "the output ends between two levels");
      issues_.throw_if_any();
    }
    return all;
  }

 private:
  struct Row {
    Token line;
    std::vector<double> values;
  };

  [[noreturn]] void fail(const Row& row, const std::string& message) {
    issues_.add(row.line, message);
    issues_.throw_if_any();
    throw InputError{message};  // not reached
  }

  void same_wavelength(const Row& row, const Block& first, const Block& block) {
    if (first.lambda_nm == block.lambda_nm) return;
    fail(row, "expected wavelength " + number_text(first.lambda_nm) +
                  " nm at the next level: there are " + std::to_string(in_.level_m.size()) +
                  " of them");
  }

  std::optional<Row> next_row() {
    while (!rest_.empty()) {
      const std::string_view text = take_line(rest_);
      Row row{{text, text, ++line_}, {}};
      std::string_view words = text.substr(0, text.find('#'));
      while (true) {
        words.remove_prefix(std::min(words.find_first_not_of(" \t"), words.size()));
        if (words.empty()) break;
        const std::string_view word = words.substr(0, words.find_first_of(" \t"));
        const auto number = strict_number_in<double>(word.front() == '+' ? word.substr(1) : word);
        if (!number) {
          issues_.add({word, text, line_},
                      "expected a number, found \"" + std::string{word} + "\"");
          issues_.throw_if_any();
        }
        row.values.push_back(*number);
        words.remove_prefix(word.size());
      }
      if (!row.values.empty()) return row;
    }
    return std::nullopt;
  }

  Row need_row(const Row& after, std::size_t count) {
    auto row = next_row();
    if (!row) fail(after, "the output ends within the block of this wavelength");
    if (row->values.size() != count) {
      fail(*row, "expected " + std::to_string(count) + " numbers, found " +
                     std::to_string(row->values.size()));
    }
    return *std::move(row);
  }

  [[nodiscard]] std::size_t azimuths() const {
    return std::max<std::size_t>(in_.phi_deg.size(), 1);
  }

  Block disort_block(const Row& row) {
    if (row.values.size() != 7) {
      fail(row, "expected a block of DISORT, lambda edir edn eup uavgdir uavgdn uavgup, found " +
                    std::to_string(row.values.size()) + " numbers");
    }
    Block block{row.values[0], row.values[1], row.values[2], -1.0, {}};
    if (in_.umu.empty()) return block;
    const std::size_t phis = in_.phi_deg.size();
    if (phis > 0) static_cast<void>(need_row(row, phis));
    for (const double umu : in_.umu) {
      const Row radiances = need_row(row, 2 + phis);
      // Printed with six decimals.
      if (std::abs(radiances.values[0] - umu) > 1e-5) {
        fail(radiances, "expected umu " + std::to_string(umu) + " as in the input");
      }
      // Without phi the radiance is the mean over azimuth, u0u.
      block.radiance.insert(block.radiance.end(), radiances.values.begin() + (phis > 0 ? 2 : 1),
                            radiances.values.end());
    }
    return block;
  }

  Block user_row(const Row& row) {
    const std::size_t radiances = in_.umu.size() * azimuths();
    const auto has_uu = std::count(in_.columns.begin(), in_.columns.end(), "uu");
    const std::size_t expected = in_.columns.size() + (has_uu != 0 ? radiances - 1 : 0);
    if (row.values.size() != expected) {
      fail(row, "output_user names " + std::to_string(expected) + " numbers, found " +
                    std::to_string(row.values.size()));
    }
    Block block;
    auto value = row.values.begin();
    for (const std::string& column : in_.columns) {
      if (column == "uu") {
        const auto end = value + static_cast<std::ptrdiff_t>(radiances);
        block.radiance.assign(value, end);
        value = end;
        continue;
      }
      set(block, column, *value);
      ++value;
    }
    if (!(block.lambda_nm > 0.0)) fail(row, "the row has no wavelength: output_user needs lambda");
    return block;
  }

  static void set(Block& block, const std::string& column, double value) {
    if (column == "lambda" || column == "wavelength" || column == "wvl") block.lambda_nm = value;
    if (column == "edir") block.edir = value;
    if (column == "edn") block.edn = value;
    if (column == "spher_alb") block.spherical_albedo = value;
  }

  const UvspecInput& in_;
  std::string_view rest_;
  FileIssues issues_;
  int line_ = 0;
};

class Runs {
 public:
  Runs(const UvspecInput& input, std::vector<std::vector<Block>> blocks, std::string name,
       const AirRunSettings& settings, const UvspecSettings& uvspec)
      : in_{input},
        blocks_{std::move(blocks)},
        name_{std::move(name)},
        settings_{settings},
        uvspec_{uvspec} {}

  AirRunSet set() {
    AirRunSet set;
    set.made_by = "libRadtran uvspec " + name_;
    for (const auto& block : blocks_) set.wavelength_um.push_back(block.front().lambda_nm * 1e-3);
    if (!in_.thermal) sun(set);
    albedo(set);
    if (!in_.black_ground) set.notes.push_back("the sky holds light from the ground of the runs");
    for (std::size_t level = 0; level < in_.level_m.size(); ++level) {
      if (!blocks_.front()[level].radiance.empty()) directions(set, level);
    }
    return set;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw InputError{name_ + ": " + message};
  }

  /// From the output's unit to per um.
  [[nodiscard]] double factor(double lambda_nm) const {
    const double watts = in_.thermal || uvspec_.watts ? 1.0 : 1e-3;
    if (in_.unit == UvspecUnit::per_nm) return watts * 1e3;
    const double nu = 1e7 / lambda_nm;
    return watts * nu * nu * 1e-4 / in_.band_cm;  // |d nu / d lambda| in cm^-1 per um
  }

  template <class Value>
  [[nodiscard]] std::vector<double> spectrum(std::size_t level, const Value& value) const {
    std::vector<double> result;
    for (const auto& block : blocks_) result.push_back(value(block[level]));
    return result;
  }

  [[nodiscard]] double mu0() const { return std::cos(in_.sun_zenith_deg * radians_per_degree); }
  [[nodiscard]] std::size_t top() const { return in_.level_m.size() - 1; }
  [[nodiscard]] bool has_top() const { return in_.level_m.back() >= settings_.top_m; }
  [[nodiscard]] bool has_ground() const {
    return std::abs(in_.level_m.front() - settings_.ground_m) < 1.0;
  }

  void sun(AirRunSet& set) const {
    set.sun_zenith_rad = in_.sun_zenith_deg * radians_per_degree;
    if (!(mu0() > 0.0)) return;
    if (has_top()) {
      set.sun_irradiance =
          spectrum(top(), [this](const Block& b) { return b.edir / mu0() * factor(b.lambda_nm); });
    }
    if (!has_ground()) return;
    if (in_.black_ground) {
      set.ground_irradiance =
          spectrum(0, [this](const Block& b) { return (b.edir + b.edn) * factor(b.lambda_nm); });
    }
    if (has_top()) set.sun_transmittance = transmittance(0, top(), mu0());
  }

  void albedo(AirRunSet& set) const {
    std::vector<double> values = spectrum(0, [](const Block& b) { return b.spherical_albedo; });
    const bool there = std::all_of(values.begin(), values.end(), [](double v) { return v >= 0.0; });
    if (there) set.spherical_albedo = std::move(values);
  }

  /// Of a slant way between two levels, from the sun's beam: T = (E_lower / E_upper)^(mu0 / mu).
  [[nodiscard]] std::vector<double> transmittance(std::size_t lower, std::size_t upper,
                                                  double mu) const {
    std::vector<double> result;
    for (const auto& block : blocks_) {
      const double above = block[upper].edir;
      const double ratio = above > 0.0 ? std::clamp(block[lower].edir / above, 0.0, 1.0) : 0.0;
      result.push_back(std::pow(ratio, mu0() / mu));
    }
    return result;
  }

  void directions(AirRunSet& set, std::size_t level) const {
    const std::size_t phis = std::max<std::size_t>(in_.phi_deg.size(), 1);
    for (std::size_t u = 0; u < in_.umu.size(); ++u) {
      if (in_.umu[u] == 0.0) fail("umu must not be 0");
      // Down from the lowest level and up from the top there is no air.
      const bool down = in_.umu[u] > 0.0;
      if ((down && level == 0) || (!down && level == top() && has_top())) continue;
      if (down) check_ground();
      std::vector<double> seen;
      for (std::size_t p = 0; p < phis; ++p) {
        AirRun looks = run(level, u, p);
        // The air is alike left and right of the sun: phi often goes all around.
        const double azimuth = looks.azimuth_rad.value_or(0.0);
        const bool again = std::any_of(seen.begin(), seen.end(), [&](double other) {
          return std::abs(other - azimuth) < 1e-6;
        });
        if (again) continue;
        seen.push_back(azimuth);
        set.runs.push_back(std::move(looks));
      }
    }
  }

  void check_ground() const {
    if (!in_.black_ground) {
      fail("looking down, the ground's light cannot be told from the air's: use albedo 0");
    }
    if (in_.thermal && !in_.cold_ground) {
      fail(
          "looking down, the ground's emission cannot be told from the air's: use "
          "sur_temperature 1");
    }
  }

  [[nodiscard]] AirRun run(std::size_t level, std::size_t u, std::size_t p) const {
    const double umu = in_.umu[u];
    const std::size_t at = u * std::max<std::size_t>(in_.phi_deg.size(), 1) + p;
    AirRun run;
    run.name = name_;
    run.height_m = in_.level_m[level];
    // umu is the cosine of where light goes: the eye looks the other way.
    run.zenith_rad = std::acos(std::clamp(-umu, -1.0, 1.0));
    std::vector<double> radiance =
        spectrum(level, [&](const Block& b) { return b.radiance[at] * factor(b.lambda_nm); });
    if (in_.thermal) {
      run.even = std::move(radiance);
      return run;
    }
    run.solar = std::move(radiance);
    azimuth(run, p);
    const bool down = umu > 0.0;
    if (mu0() > 0.0 && down && has_ground()) {
      run.transmittance = transmittance(0, level, umu);
    } else if (mu0() > 0.0 && !down && has_top()) {
      run.transmittance = transmittance(level, top(), -umu);
    }
    return run;
  }

  void azimuth(AirRun& run, std::size_t p) const {
    const bool vertical = std::abs(std::cos(run.zenith_rad)) > 1.0 - 1e-9;
    if (in_.phi_deg.empty()) {
      if (!vertical)
        fail("solar radiance needs phi: without it only the mean over azimuth is there");
      return;
    }
    run.azimuth_rad =
        std::abs(std::remainder(in_.phi_deg[p] - in_.sun_phi_deg, 360.0)) * radians_per_degree;
  }

  const UvspecInput& in_;
  std::vector<std::vector<Block>> blocks_;
  std::string name_;
  const AirRunSettings& settings_;
  const UvspecSettings& uvspec_;
};

}  // namespace

AirRunSet parse_uvspec(const NamedText& input, const NamedText& output,
                       const AirRunSettings& settings, const UvspecSettings& uvspec) {
  const UvspecInput in = parse_uvspec_input(input, settings.top_m);
  return Runs{in, Output{in, output}.blocks(), output.name, settings, uvspec}.set();
}

AirRunSet read_uvspec(const std::filesystem::path& input, const std::filesystem::path& output,
                      const AirRunSettings& settings, const UvspecSettings& uvspec) {
  const std::string in = read_bytes(input), out = read_bytes(output);
  return parse_uvspec({input.string(), in}, {output.string(), out}, settings, uvspec);
}

}  // namespace nadir::sim
