#include "sim/files/oem_file.hpp"

#include <fstream>
#include <string>

#include "sim/message_of.hpp"
#include "sim/scratch_folder.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

using Catch::Matchers::Contains;
using ephemeris::Instant;

struct Meta {
  std::string frame = "ITRF2014", times = "UTC", more;
};

std::string head(const Meta& meta = {}) {
  return "META_START\n"
         "OBJECT_NAME = LANDSAT 8\n"
         "OBJECT_ID = 2013-008A\n"
         "CENTER_NAME = EARTH\n"
         "REF_FRAME = " +
         meta.frame +
         "\n"
         "TIME_SYSTEM = " +
         meta.times +
         "\n"
         "START_TIME = 2026-06-21T16:00:00\n" +
         meta.more +
         "STOP_TIME = 2026-06-21T16:03:00\n"
         "META_STOP\n";
}
const std::string top =
    "CCSDS_OEM_VERS = 2.0\nCOMMENT a comment\nCREATION_DATE = 2026-06-21T10:00:00\n"
    "ORIGINATOR = NOBODY\n\n";
// Made up: a straight way, 60 s apart.
const std::string data =
    "COMMENT of the data\n"
    "2026-06-21T16:00:00.000 7000.0 0.0 0.0 0.0 1.0 7.0\n"
    "2026-06-21T16:01:00.000 7000.0 60.0 420.0 0.0 1.0 7.0 0.0 0.0 0.0\n"
    "2026-172T16:02:00Z 7000.0 +120.0 8.4e2 0.0 1.0 7.0\n"
    "2026-06-21T16:03:00 7000.0 180.0 1260.0 0.0 1.0 7.0\n";

OrbitEphemeris read_oem(const std::string& text) { return parse_oem(text, "o.oem", Seconds{0.1}); }
std::string oem_message(const std::string& text) {
  return support::message_of([&] { static_cast<void>(read_oem(text)); });
}
std::string changed(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST_CASE("an orbit ephemeris message gives places and times", "[sim][oem]") {
  const OrbitEphemeris orbit = read_oem(top + head() + data);
  CHECK(orbit.object == "LANDSAT 8");
  REQUIRE(orbit.points.size() == 4);
  CHECK(orbit.points[0].time.to_string() == "2026-06-21T16:00:00Z");
  CHECK(orbit.points[2].time.to_string() == "2026-06-21T16:02:00Z");  // day 172 of the year
  CHECK(orbit.points[2].time.ut1_utc().value == 0.1);
  CHECK(orbit.points[2].ecef.position == Vec3{7e6, 120e3, 840e3});
  CHECK(orbit.points[2].ecef.velocity == Vec3{0.0, 1e3, 7e3});
  CHECK(orbit.first_useable == 0);
  CHECK(orbit.last_useable == 3);
}

TEST_CASE("covariances of a message are passed over", "[sim][oem]") {
  const std::string covariance =
      "COVARIANCE_START\nEPOCH = 2026-06-21T16:00:00\nCOV_REF_FRAME = RTN\n3.3e-04\n"
      "4.6e-04 6.7e-04\nCOVARIANCE_STOP\n";
  CHECK(read_oem(top + head() + data + covariance).points.size() == 4);
}

TEST_CASE("every time system names the same moment", "[sim][oem]") {
  // TAI - UTC 37 s, TT - TAI 32.184 s, TAI - GPS 19 s, UT1 - UTC 0.1 s.
  const auto first = [&](const std::string& system, const std::string& time) {
    return read_oem(top + head({"ITRF2014", system, ""}) +
                    changed(data, "2026-06-21T16:00:00.000", "2026-06-21T" + time))
        .points[0]
        .time;
  };
  const Instant utc = Instant::parse_utc("2026-06-21T15:59:20Z");
  // 1e-9 s: what an Instant keeps through sums.
  CHECK((first("UTC", "15:59:20") - utc).value == Approx(0.0).margin(1e-9));
  CHECK((first("TAI", "15:59:57") - utc).value == Approx(0.0).margin(1e-9));
  CHECK((first("TT", "16:00:29.184") - utc).value == Approx(0.0).margin(1e-9));
  CHECK((first("GPS", "15:59:38") - utc).value == Approx(0.0).margin(1e-9));
  CHECK((first("UT1", "15:59:20.1") - utc).value == Approx(0.0).margin(1e-9));
}

TEST_CASE("frames of the sky are turned to the earth", "[sim][oem]") {
  for (const std::string frame : {"TEME", "EME2000", "GCRF", "ICRF"}) {
    const OrbitEphemeris orbit = read_oem(top + head({frame, "UTC", ""}) + data);
    const sensor::StateVector sky{{7e6, 60e3, 420e3}, {0.0, 1e3, 7e3}};
    const Instant time = Instant::parse_utc("2026-06-21T16:01:00Z", Seconds{0.1});
    const sensor::StateVector expected = frame == "TEME"      ? sensor::ecef_from_teme(sky, time)
                                         : frame == "EME2000" ? sensor::ecef_from_eme2000(sky, time)
                                                              : sensor::ecef_from_gcrf(sky, time);
    CAPTURE(frame);
    CHECK(length(orbit.points[1].ecef.position - expected.position) < 1e-8);
    CHECK(length(orbit.points[1].ecef.velocity - expected.velocity) < 1e-11);
    CHECK(length(expected.position - sky.position) > 1e6);
  }
  CHECK(read_oem(top + head({"WGS-84", "UTC", ""}) + data).points[0].ecef.position ==
        Vec3{7e6, 0.0, 0.0});
}

TEST_CASE("only the useable part of a message is used", "[sim][oem]") {
  const std::string text =
      top +
      head({"ITRF2014", "UTC",
            "USEABLE_START_TIME = 2026-06-21T16:00:30\nUSEABLE_STOP_TIME = "
            "2026-06-21T16:02:00\nINTERPOLATION = LAGRANGE\nINTERPOLATION_DEGREE = 7\n"}) +
      data;
  const OrbitEphemeris orbit = read_oem(text);
  CHECK(orbit.points.size() == 4);
  CHECK(orbit.first_useable == 1);
  CHECK(orbit.last_useable == 2);
  const support::ScratchFolder folder;
  std::ofstream{folder / "o.oem"} << text;
  const std::vector<EphemerisPoint> points = read_orbit_ephemeris(folder / "o.oem");
  REQUIRE(points.size() == 2);
  CHECK(points[0].ecef.position.y == 60e3);
  CHECK(points[1].ecef.position.y == 120e3);
}

TEST_CASE("segments are joined where they meet", "[sim][oem]") {
  const std::string onward =
      "2026-06-21T16:03:00 7000.0 180.0 1260.0 0.0 1.0 7.0\n"
      "2026-06-21T16:04:00 7000.0 240.0 1680.0 0.0 1.0 7.0\n";
  const OrbitEphemeris orbit = read_oem(top + head() + data + head() + onward);
  REQUIRE(orbit.points.size() == 5);
  CHECK(orbit.points[4].ecef.position.y == 240e3);
  CHECK(orbit.last_useable == 4);
  CHECK_THAT(oem_message(top + head() + data + head() + changed(onward, "16:03:00", "16:03:10")),
             Contains("o.oem:20:1: error: the segment's useable part begins 10 s after"));
  // A manoeuvre: 1 m/s more.
  CHECK_THAT(
      oem_message(top + head() + data + head() + changed(onward, "0.0 1.0 7.0", "0.0 1.0 7.001")),
      Contains("o.oem:20:1: error: the segment begins 0 m and 1"));
  CHECK_THAT(oem_message(top + head() + data + changed(head(), "LANDSAT 8", "TERRA") + onward),
             Contains("the segment is of \"TERRA\", the one before of \"LANDSAT 8\""));
}

TEST_CASE("mistakes of an orbit ephemeris message have their places", "[sim][oem]") {
  const std::string good = top + head() + data;
  CHECK(
      oem_message(changed(good, "ITRF2014", "MOON_ME")) ==
      "o.oem:10:13: error: the frame is \"MOON_ME\", expected ITRF.., WGS84, ECEF, EFG, TDR, GRC, "
      "TEME, EME2000, GCRF or ICRF\n"
      "    10 | REF_FRAME = MOON_ME\n"
      "       |             ^\n");
  CHECK_THAT(oem_message(changed(good, "= UTC", "= TDB")),
             Contains("o.oem:11:15: error: the time system is \"TDB\", expected UTC, UT1, TAI"));
  CHECK_THAT(oem_message(changed(good, "EARTH", "MARS")),
             Contains("o.oem:9:15: error: the orbit is about \"MARS\", expected EARTH"));
  CHECK_THAT(oem_message(changed(good, "OBJECT_ID", "OBJECT_IB")),
             Contains("o.oem:8:1: error: expected a keyword of the metadata and its value") &&
                 Contains("hint: did you mean \"OBJECT_ID\"?") &&
                 Contains("o.oem:6:1: error: the segment has no OBJECT_ID"));
  CHECK_THAT(oem_message(changed(good, "16:01:00.000", "16:00:00.000")),
             Contains("o.oem:17:1: error: times must ascend"));
  CHECK_THAT(oem_message(changed(good, "16:01:00.000", "16:61:00.000")),
             Contains("o.oem:17:1: error: time \"2026-06-21T16:61:00.000Z\": minute 61"));
  CHECK_THAT(oem_message(changed(good, "420.0", "42o.0")),
             Contains("o.oem:17:37: error: expected a number, found \"42o.0\""));
  CHECK_THAT(oem_message(changed(good, "7000.0 0.0", "7000.0e3 0.0")),
             Contains("the place is 7e+06 km from the earth's centre, expected 6300 to 2000000"));
  CHECK_THAT(oem_message(changed(good, " 0.0 1.0 7.0\n", " 0.0\n")),
             Contains("o.oem:16:1: error: expected a time, three coordinates in km") &&
                 Contains("found 5 words"));
  CHECK_THAT(
      oem_message(changed(good, "STOP_TIME", "REF_FRAME_EPOCH = 2026-06-21T00:00:00\nSTOP_TIME")),
      Contains("a frame that stands still at an epoch is not read"));
}

TEST_CASE("what is no orbit ephemeris message is told", "[sim][oem]") {
  CHECK_THAT(oem_message(""), Contains("o.oem: error: this is no orbit ephemeris message: "
                                       "CCSDS_OEM_VERS is missing") &&
                                  Contains("the message has no segment"));
  CHECK_THAT(oem_message(top + "META_START\nOBJECT_NAME = A\n"),
             Contains("o.oem:6:1: error: there is no META_STOP for it"));
  CHECK_THAT(oem_message(top + head()), Contains("fewer than two points that may be used"));
  CHECK_THAT(oem_message("<oem>\n"),
             Contains("o.oem:1:1: error: expected a keyword of the header"));
}

}  // namespace nadir::sim
