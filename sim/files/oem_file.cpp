#include "sim/files/oem_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "core/error.hpp"
#include "core/text.hpp"
#include "ephemeris/iso_time.hpp"
#include "sim/files/text_tokens.hpp"

namespace nadir::sim {
namespace {

using ephemeris::Instant;
using sensor::StateVector;
using OemWords = std::vector<Token>;

// ---- Times -------------------------------------------------------------------------------------

std::string two_digits_of(int number) { return (number < 10 ? "0" : "") + std::to_string(number); }

/// The month and day of a day of the year, as 12-18; nothing for a day that the year has not.
std::optional<std::string> month_and_day(int year, int day_of_year) {
  const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
  const std::array lengths{31, leap ? 29 : 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  int day = day_of_year, month = 1;
  for (const int length : lengths) {
    if (day >= 1 && day <= length) return two_digits_of(month) + "-" + two_digits_of(day);
    day -= length;
    ++month;
  }
  return std::nullopt;
}

/// 1996-353T12:00:00.331 and 1996-12-18T12:00:00.331Z, both of which the format allows, as the
/// second with a Z; decimals past the nanosecond are cut off.
std::string iso_time(std::string_view text) {
  std::string time{text};
  if (!time.empty() && time.back() == 'Z') time.pop_back();
  if (const std::size_t point = time.find('.'); point != std::string::npos) {
    time.resize(std::min(time.size(), point + 10));
    if (time.back() == '.') time.pop_back();
  }
  if (time.size() > 8 && time[4] == '-' && time[8] == 'T') {
    const auto year = strict_number_in<int>(std::string_view{time}.substr(0, 4));
    const auto day = strict_number_in<int>(std::string_view{time}.substr(5, 3));
    const auto date = year && day ? month_and_day(*year, *day) : std::nullopt;
    if (date) time.replace(5, 3, *date);
  }
  return time + "Z";
}

/// How a clock runs against atomic time. UTC and UT1 follow the earth.
struct TimeSystem {
  std::string_view name;
  bool is_atomic;
  double behind_tai_s;
};
constexpr std::array<TimeSystem, 5> time_systems{{{"UTC", false, 0.0},
                                                  {"UT1", false, 0.0},
                                                  {"TAI", true, 0.0},
                                                  {"TT", true, -32.184},
                                                  {"GPS", true, 19.0}}};

/// @throws InputError without a place
Instant instant_of(std::string_view text, const TimeSystem& system, Seconds ut1_utc) {
  const std::string iso = iso_time(text);
  if (system.name == "UTC") return Instant::parse_utc(iso, ut1_utc);
  const ephemeris::CalendarTime clock = ephemeris::parse_iso_time(iso);
  const double second = 3600.0 * clock.hour + 60.0 * clock.minute + clock.second;
  if (clock.year < 1960) {
    throw InputError{"time \"" + std::string{text} + "\": before 1960 only UTC is read"};
  }
  const Instant midnight = Instant::parse_utc(iso.substr(0, 10) + "T00:00:00Z", ut1_utc);
  if (!system.is_atomic) return midnight + Seconds{second - ut1_utc.value};
  const ephemeris::UtcDate utc = midnight.utc();
  const ephemeris::TaiDate tai = midnight.tai();
  const double tai_utc_s = 86400.0 * ((tai.day - utc.day) + (tai.fraction - utc.fraction));
  return midnight + Seconds{second + system.behind_tai_s - tai_utc_s};
}

// ---- Frames ------------------------------------------------------------------------------------

using ToEarth = StateVector (*)(const StateVector&, const Instant&);
StateVector as_it_is(const StateVector& state, const Instant& /*time*/) { return state; }

struct OemFrame {
  std::string_view name;  // all that begin with it
  ToEarth to_earth;
};
constexpr std::array<OemFrame, 11> oem_frames{{{"ITRF", as_it_is},
                                               {"WGS84", as_it_is},
                                               {"WGS-84", as_it_is},
                                               {"ECEF", as_it_is},
                                               {"EFG", as_it_is},
                                               {"TDR", as_it_is},
                                               {"GRC", as_it_is},
                                               {"TEME", sensor::ecef_from_teme},
                                               {"EME2000", sensor::ecef_from_eme2000},
                                               {"GCRF", sensor::ecef_from_gcrf},
                                               {"ICRF", sensor::ecef_from_gcrf}}};

// ---- Segments ----------------------------------------------------------------------------------

const std::vector<std::string> oem_header_keys{"CCSDS_OEM_VERS", "CLASSIFICATION", "CREATION_DATE",
                                               "ORIGINATOR", "MESSAGE_ID"};
const std::vector<std::string> needed_oem_keys{"OBJECT_NAME", "OBJECT_ID",   "CENTER_NAME",
                                               "REF_FRAME",   "TIME_SYSTEM", "START_TIME",
                                               "STOP_TIME"};
const std::vector<std::string> optional_oem_keys{"REF_FRAME_EPOCH", "USEABLE_START_TIME",
                                                 "USEABLE_STOP_TIME", "INTERPOLATION",
                                                 "INTERPOLATION_DEGREE"};

OemWords oem_words(const Token& line) {
  OemWords words;
  std::size_t at = 0;
  while ((at = line.text.find_first_not_of(" \t", at)) != std::string_view::npos) {
    const std::size_t end = std::min(line.text.find_first_of(" \t", at), line.text.size());
    words.push_back({line.text.substr(at, end - at), line.line_text, line.line});
    at = end;
  }
  return words;
}

struct OemSegment {
  Token begin;  // its META_START
  std::map<std::string, Token, std::less<>> meta;
  const TimeSystem* time_system = nullptr;
  ToEarth to_earth = nullptr;
  OrbitEphemeris orbit;
};

class OemParser {
 public:
  OemParser(std::string_view text, const std::string& name, Seconds ut1_utc)
      : issues_{name}, ut1_utc_{ut1_utc} {
    for (int number = 1; !text.empty(); ++number) {
      const std::string_view line = take_line(text);
      const std::string_view inner = without_blanks(line);
      if (inner.empty() || inner.substr(0, 7) == "COMMENT") continue;
      read_line({inner, line, number});
    }
    if (in_ == Part::meta) issues_.add(segments_.back().begin, "there is no META_STOP for it");
    if (!has_version_) issues_.add("this is no orbit ephemeris message: CCSDS_OEM_VERS is missing");
    if (segments_.empty()) issues_.add("the message has no segment: there is no META_START");
    issues_.throw_if_any();
  }

  OrbitEphemeris joined() {
    for (OemSegment& segment : segments_) set_useable(segment);
    issues_.throw_if_any();
    OrbitEphemeris whole = segments_.front().orbit;
    for (std::size_t i = 1; i < segments_.size(); ++i) append(whole, segments_[i]);
    issues_.throw_if_any();
    return whole;
  }

 private:
  enum class Part { header, meta, data, covariance };

  void read_line(const Token& line) {
    if (line.text == "META_START") {
      in_ = Part::meta;
      segments_.emplace_back();
      segments_.back().begin = line;
    } else if (line.text == "META_STOP" && in_ == Part::meta) {
      in_ = Part::data;
      end_of_meta(segments_.back());
    } else if (line.text == "COVARIANCE_START" && in_ == Part::data) {
      in_ = Part::covariance;
    } else if (in_ == Part::covariance) {
      if (line.text == "COVARIANCE_STOP") in_ = Part::data;
    } else if (in_ == Part::data) {
      read_data(line, segments_.back());
    } else {
      read_key(line);
    }
  }

  void read_key(const Token& line) {
    const std::size_t equals = line.text.find('=');
    const std::string_view key = without_blanks(line.text.substr(0, equals));
    std::vector<std::string> known = oem_header_keys;
    if (in_ == Part::meta) {
      known = needed_oem_keys;
      known.insert(known.end(), optional_oem_keys.begin(), optional_oem_keys.end());
    }
    if (equals == std::string_view::npos ||
        std::find(known.begin(), known.end(), key) == known.end()) {
      const std::string nearest = nearest_name(std::string{key}, known);
      issues_.add(line,
                  "expected a keyword of " +
                      std::string{in_ == Part::meta ? "the metadata" : "the header"} +
                      " and its value, found " + start_in_quotes(line.text),
                  nearest.empty() ? "" : "did you mean \"" + nearest + "\"?");
      return;
    }
    if (key == "CCSDS_OEM_VERS") has_version_ = true;
    const std::string_view value = without_blanks(line.text.substr(equals + 1));
    const Token token{value.empty() ? line.text : value, line.line_text, line.line};
    if (in_ == Part::meta) segments_.back().meta[std::string{key}] = token;
  }

  void end_of_meta(OemSegment& segment) {
    for (const std::string& key : needed_oem_keys) {
      if (!segment.meta.count(key)) issues_.add(segment.begin, "the segment has no " + key);
    }
    if (const auto centre = segment.meta.find("CENTER_NAME");
        centre != segment.meta.end() && centre->second.text != "EARTH") {
      issues_.add(centre->second,
                  "the orbit is about " + in_quotes(centre->second.text) + ", expected EARTH");
    }
    if (const auto epoch = segment.meta.find("REF_FRAME_EPOCH"); epoch != segment.meta.end()) {
      issues_.add(epoch->second,
                  "a frame that stands still at an epoch is not read: only frames of date are");
    }
    choose_frame(segment);
    choose_time_system(segment);
    if (const auto name = segment.meta.find("OBJECT_NAME"); name != segment.meta.end()) {
      segment.orbit.object = name->second.text;
    }
  }

  void choose_frame(OemSegment& segment) {
    const auto found = segment.meta.find("REF_FRAME");
    if (found == segment.meta.end()) return;
    for (const OemFrame& frame : oem_frames) {
      if (found->second.text.substr(0, frame.name.size()) == frame.name) {
        segment.to_earth = frame.to_earth;
        return;
      }
    }
    issues_.add(found->second, "the frame is " + in_quotes(found->second.text) +
                                   ", expected ITRF.., WGS84, ECEF, EFG, TDR, GRC, TEME, EME2000, "
                                   "GCRF or ICRF");
  }

  void choose_time_system(OemSegment& segment) {
    const auto found = segment.meta.find("TIME_SYSTEM");
    if (found == segment.meta.end()) return;
    for (const TimeSystem& system : time_systems) {
      if (found->second.text == system.name) segment.time_system = &system;
    }
    if (!segment.time_system) {
      issues_.add(found->second, "the time system is " + in_quotes(found->second.text) +
                                     ", expected UTC, UT1, TAI, TT or GPS");
    }
  }

  std::optional<Instant> time(const Token& token, const OemSegment& segment) {
    try {
      return instant_of(token.text, *segment.time_system, ut1_utc_);
    } catch (const InputError& error) {
      issues_.add(token, error.issues().front().message);
      return std::nullopt;
    }
  }

  /// Six numbers after the time. The rest of a line, accelerations, is passed over.
  std::optional<StateVector> state_km(const OemWords& words) {
    std::array<double, 6> v{};
    bool all = true;
    for (std::size_t i = 0; i < v.size(); ++i) {
      const Token& word = words[i + 1];
      const bool plus = word.text.size() > 1 && word.text[0] == '+';
      const auto value = strict_number_in<double>(word.text.substr(plus ? 1 : 0));
      if (!value) issues_.add(word, "expected a number, found " + in_quotes(word.text));
      all = all && value;
      v[i] = value.value_or(0.0);
    }
    if (!all) return std::nullopt;
    if (const double r = length(Vec3{v[0], v[1], v[2]}); r < 6300.0 || r > 2e6) {
      issues_.add(words[1], "the place is " + number_text(std::round(r)) +
                                " km from the earth's centre, expected 6300 to 2000000 km");
    }
    return StateVector{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
  }

  void read_data(const Token& line, OemSegment& segment) {
    const OemWords words = oem_words(line);
    if (words.size() != 7 && words.size() != 10) {
      issues_.add(
          line,
          "expected a time, three coordinates in km and three velocities in km/s (and three "
          "accelerations), found " +
              std::to_string(words.size()) + " words");
      return;
    }
    if (!segment.time_system || !segment.to_earth) return;  // told already
    const std::optional<Instant> at = time(words[0], segment);
    const std::optional<StateVector> km = state_km(words);
    if (!at || !km) return;
    std::vector<EphemerisPoint>& points = segment.orbit.points;
    if (!points.empty() && (*at - points.back().time).value <= 0.0) {
      issues_.add(words[0], "times must ascend: this is not later than the line before");
    }
    points.push_back({*at, segment.to_earth({1e3 * km->position, 1e3 * km->velocity}, *at)});
  }

  /// Which of the points may be used: by USEABLE_START_TIME and USEABLE_STOP_TIME.
  void set_useable(OemSegment& segment) {
    OrbitEphemeris& orbit = segment.orbit;
    constexpr double rounding_s = 1e-6;
    const auto limit = [&](const char* key) -> std::optional<Instant> {
      const auto found = segment.meta.find(key);
      return found == segment.meta.end() ? std::nullopt : time(found->second, segment);
    };
    const std::optional<Instant> first = limit("USEABLE_START_TIME"),
                                 last = limit("USEABLE_STOP_TIME");
    const auto& points = orbit.points;
    std::size_t begin = 0, end = points.size();
    while (begin < end && first && (points[begin].time - *first).value < -rounding_s) ++begin;
    while (begin < end && last && (points[end - 1].time - *last).value > rounding_s) --end;
    if (end - begin < 2) {
      issues_.add(segment.begin, "the segment has fewer than two points that may be used");
      return;
    }
    orbit.first_useable = begin;
    orbit.last_useable = end - 1;
  }

  /// Joins the next segment where it begins as the one before ends, to 1 us, 1 m and 1 cm/s.
  void append(OrbitEphemeris& whole, const OemSegment& next) {
    if (next.orbit.object != whole.object) {
      issues_.add(next.begin, "the segment is of " + in_quotes(next.orbit.object) +
                                  ", the one before of " + in_quotes(whole.object) +
                                  ": one object a file is read");
      return;
    }
    const auto& from = next.orbit.points;
    const EphemerisPoint &end = whole.points[whole.last_useable],
                         &begin = from[next.orbit.first_useable];
    const double gap_s = (begin.time - end.time).value;
    if (std::abs(gap_s) > 1e-6) {
      issues_.add(next.begin, "the segment's useable part begins " +
                                  number_text(std::round(1e6 * gap_s) / 1e6) +
                                  " s after that of the one before ends: a gap or an overlap "
                                  "cannot be joined");
      return;
    }
    const double step_m = length(begin.ecef.position - end.ecef.position);
    const double step_m_s = length(begin.ecef.velocity - end.ecef.velocity);
    if (step_m > 1.0 || step_m_s > 0.01) {
      issues_.add(next.begin, "the segment begins " + number_text(step_m) + " m and " +
                                  number_text(step_m_s) +
                                  " m/s off the end of the one before: such segments are not "
                                  "interpolated as one");
      return;
    }
    whole.points.resize(whole.last_useable + 1, end);
    whole.points.insert(whole.points.end(),
                        from.begin() + static_cast<std::ptrdiff_t>(next.orbit.first_useable) + 1,
                        from.end());
    whole.last_useable += next.orbit.last_useable - next.orbit.first_useable;
  }

  FileIssues issues_;
  Seconds ut1_utc_;
  Part in_ = Part::header;
  bool has_version_ = false;
  std::vector<OemSegment> segments_;
};

}  // namespace

OrbitEphemeris parse_oem(std::string_view text, const std::string& name, Seconds ut1_utc) {
  return OemParser{text, name, ut1_utc}.joined();
}

OrbitEphemeris read_oem(const std::filesystem::path& file, Seconds ut1_utc) {
  const std::string text = read_bytes(file);
  return parse_oem(text, file.string(), ut1_utc);
}

std::vector<EphemerisPoint> read_orbit_ephemeris(const std::filesystem::path& file,
                                                 Seconds ut1_utc) {
  const OrbitEphemeris orbit = read_oem(file, ut1_utc);
  const auto begin = orbit.points.begin();
  return {begin + static_cast<std::ptrdiff_t>(orbit.first_useable),
          begin + static_cast<std::ptrdiff_t>(orbit.last_useable) + 1};
}

}  // namespace nadir::sim
