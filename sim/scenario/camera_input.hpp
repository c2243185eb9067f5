#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/error.hpp"

// What a scenario or a sensor file says of a camera. A preset that a scenario names is taken apart
// while the scenario is read: what follows knows arrays only.

namespace nadir::sim {

// ---- bands --------------------------------------------------------------------------------------

struct BoxBand {
  double lo_um = 0.0, hi_um = 0.0;
};
struct GaussianBand {
  double centre_um = 0.0, fwhm_um = 0.0;
};
struct TabulatedBand {
  std::filesystem::path file;
  std::string column;
  bool quantum = false;  ///< counts photons: to be multiplied by the wavelength
};

/// A published figure of a band's noise: a signal-to-noise ratio at a radiance, or a
/// noise-equivalent temperature difference at a temperature of the scene.
struct SnrFigure {
  double radiance = 0.0;  ///< W m^-2 sr^-1 um^-1
  double snr = 0.0;
};
struct NedtFigure {
  double temperature_k = 300.0;
  double nedt_k = 0.0;
};
using NoiseFigureInput = std::variant<SnrFigure, NedtFigure>;

struct BandInput {
  std::string name;
  std::variant<BoxBand, GaussianBand, TabulatedBand> response;
  std::optional<double> reference_radiance{};  ///< W m^-2 sr^-1 um^-1
  std::vector<NoiseFigureInput> figures{};     ///< for PublishedNoiseInput
  /// Largest radiance, of PublishedNoiseInput, or the black body that has it.
  std::optional<double> saturation_radiance{}, saturation_temperature_k{};
  std::optional<double> efficiency{}, transmittance{};  ///< instead of the array's
  SourceLocation where{};
};

// ---- timing -------------------------------------------------------------------------------------

// `start_s`: centre of the first exposure, after the scenario's time; none: the image's middle is
// at the scenario's time.

struct GlobalShutterInput {
  double exposure_ms = 0.0, delay_ms = 0.0;
};
struct RollingShutterInput {
  double line_period_ms = 0.0, exposure_ms = 0.0;
  std::optional<double> start_s{};
};
struct PushbroomInput {
  double line_period_ms = 0.0, exposure_ms = 0.0;
  std::optional<double> start_s{};
  int tdi_stages = 1;
  bool tdi_behind = false;  ///< charge moves towards +y: for a platform that flies towards -y
};
struct WhiskbroomInput {
  double sample_period_us = 0.0, scan_period_ms = 0.0;
  int lines_per_scan = 1;
  double exposure_us = 0.0;
  std::optional<double> start_s{};
};
struct BolometerInput {
  double time_constant_ms = 0.0;
  double line_period_us = 0.0;  ///< 0: all lines are read at once
  std::optional<double> start_s{};
};
using TimingInput = std::variant<GlobalShutterInput, RollingShutterInput, PushbroomInput,
                                 WhiskbroomInput, BolometerInput>;

/// Centre of the first exposure after the scenario's time: `start_s`, or what centres the image.
[[nodiscard]] double first_exposure_s(const TimingInput& timing, int samples, int lines);
/// From line to line, on average over a sweep; 0 for those that take all lines at once.
[[nodiscard]] double line_period_s(const TimingInput& timing);
/// The `start_s` of a timing that has one; null for those that take all lines at once.
[[nodiscard]] std::optional<double>* start_of(TimingInput& timing);
/// Whether the image's lines come by scanning rather than from rows of detectors.
[[nodiscard]] bool is_scanned(const TimingInput& timing);

// ---- optics, blur, detector ---------------------------------------------------------------------

struct LensInput {
  double focal_length_mm = 0.0;
  double k1 = 0.0, k2 = 0.0, p1 = 0.0, p2 = 0.0, k3 = 0.0;
  double principal_x_um = 0.0, principal_y_um = 0.0;  ///< of the axis, from the arrays' origin
};

struct ModuleInput {
  int first_sample = 0, samples = 0;
  double offset_x_um = 0.0, offset_y_um = 0.0;
  double rotation_deg = 0.0;
};

struct OpticsInput {
  double f_number = 0.0, obscuration = 0.0;
  double transmittance = 1.0, falloff_power = 4.0;
  double temperature_k = 0.0, emissivity = 0.0, shield_temperature_k = 0.0;
};

struct DiffractionInput {
  double f_number = 0.0, obscuration = 0.0;
};
struct GaussianBlurInput {
  double sigma_x_um = 0.0, sigma_y_um = 0.0;
};
struct StrayLightInput {
  double share = 0.0, core_um = 0.0, slope = 1.5, reach_um = 0.0;
};
struct BlurInput {
  std::optional<DiffractionInput> diffraction;
  std::vector<GaussianBlurInput> gaussians;
  std::optional<std::filesystem::path> table;
  std::optional<StrayLightInput> stray;

  [[nodiscard]] bool is_none() const {
    return !diffraction && gaussians.empty() && !table && !stray;
  }
};

struct PhotonDetectorInput {
  double efficiency = 0.0;           ///< of bands that have none of their own
  std::optional<double> area_um2{};  ///< none: the sensitive part of the pitch
  double dark_e_s = 0.0;
  double temperature_k = 293.15;
  std::optional<double> dark_reference_k{};  ///< none: dark_e_s is that at temperature_k
  double dark_doubling_k = 7.0;
  double read_noise_e = 0.0, line_noise_e = 0.0, line_correlation = 0.0;
  double flicker_noise_e = 0.0;
  double prnu = 0.0, dsnu_e = 0.0, full_well_e = 0.0;
};
/// Bands say how much.
struct PublishedNoiseInput {};

struct DetectorInput {
  std::variant<PhotonDetectorInput, PublishedNoiseInput> element;
  int bits = 12;
  double black_level_dn = 0.0;
  std::optional<double> gain_dn_e{};
  bool flat = true;
  double dead_share = 0.0;
  int pattern_seed = 1;
  SourceLocation where{};
};

// ---- arrays and camera --------------------------------------------------------------------------

struct ArrayInput {
  std::string name;
  int samples = 0, lines = 0;  ///< columns and rows of the image
  double pitch_um = 0.0;       ///< centre to centre on the focal plane; not orthographic
  double pitch_y_um = 0.0;     ///< the same along y; 0: as pitch_um
  double offset_x_um = 0.0, offset_y_um = 0.0;  ///< of the array's centre on the focal plane
  double ground_pitch_m = 0.0;                  ///< orthographic: centre to centre across the beam
  double ground_pitch_y_m = 0.0;                ///< the same along y; 0: as ground_pitch_m
  double offset_x_m = 0.0, offset_y_m = 0.0;    ///< orthographic: of the array's centre
  std::vector<BandInput> bands;
  double fill_x = 1.0, fill_y = 1.0;  ///< sensitive part of the pitch
  TimingInput timing = GlobalShutterInput{};
  std::vector<ModuleInput> modules{};  ///< ascending and complete, or none
  bool own_lens = false;               ///< of the camera's focal length if `lens` says nothing else
  std::optional<LensInput> lens{};     ///< in place of the camera's
  std::optional<std::filesystem::path> view_table{};  ///< lines of sight instead of a lens
  bool is_cut = false;                                ///< a part of what the sensor file has
  int first_sample = 0, first_line = 0;               ///< of that part, in the whole
  std::optional<OpticsInput> optics{};
  BlurInput blur{};
  std::optional<DetectorInput> detector{};
  SourceLocation where{};
};

struct CameraInput {
  bool orthographic = false;
  LensInput lens;             ///< of a perspective
  std::string name;           ///< of the instrument; may be empty
  std::string platform_name;  ///< that carries it, if a sensor file says so; may be empty
  std::optional<std::filesystem::path> sensor_file{};  ///< where the arrays come from, if not from
                                                       ///< the scenario
  std::vector<ArrayInput> arrays;
  SourceLocation where{};
};

/// What a sensor file says: a camera, and what a data sheet of it needs.
struct SensorInput {
  std::string name, title, source;
  double nominal_height_m = 0.0;
  double ground_speed_m_s = 0.0;  ///< 0: not known
  CameraInput camera;
};

}  // namespace nadir::sim
