#include "sim/files/attitude_file.hpp"

#include "sim/message_of.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;

namespace {

AttitudeFile parse_attitude(const std::string& text) {
  return parse_attitude_file(text, "turn.csv",
                             ephemeris::Instant::parse_utc("2026-06-21T12:00:00Z"));
}
std::string attitude_message(const std::string& text) {
  return support::message_of([&] { (void)parse_attitude(text); });
}

}  // namespace

TEST_CASE("orientations are quaternions, scalar first, or three angles", "[sim][attitude_file]") {
  const AttitudeFile turns = parse_attitude("time_s,x,y,z,w\n0,0,0,0,1\n\n1,0.6002,0,0,0.8002\n");
  CHECK(turns.times_s == std::vector<double>{0.0, 1.0});
  CHECK(turns.lines == std::vector<int>{2, 4});
  const auto& q = std::get<std::vector<Quaternion>>(turns.orientations);
  REQUIRE(q.size() == 2);
  CHECK(q[0].w == 1.0);
  // Rounded figures are brought back to length 1: (0.8002, 0.6002) has 1.00028.
  CHECK(q[1].w * q[1].w + q[1].x * q[1].x == Approx(1.0).epsilon(1e-15));
  CHECK(q[1].x / q[1].w == Approx(0.6002 / 0.8002).epsilon(1e-15));
  const AttitudeFile angles =
      parse_attitude("time_utc,yaw_deg,pitch_deg,roll_deg\n2026-06-21T12:00:03Z,90,-80,5\n");
  const auto& a = std::get<std::vector<AttitudeAngles>>(angles.orientations);
  REQUIRE(a.size() == 1);
  CHECK(angles.times_s[0] == Approx(3.0).margin(1e-9));  // Instants are good to 1e-10 s
  CHECK(a[0].yaw_deg == 90.0);
  CHECK(a[0].pitch_deg == -80.0);
  CHECK(a[0].roll_deg == 5.0);
}

TEST_CASE("mistakes in a table of orientations have their places", "[sim][attitude_file]") {
  CHECK(attitude_message("time_s,w,x,y,z\n0,0.9,0,0,0.1\n1,1.5,0,0,0\n") ==
        "turn.csv:3:3: error: w must lie from -1.001 to 1.001\n"
        "    3 | 1,1.5,0,0,0\n"
        "      |   ^\n");
  CHECK(attitude_message("time_s,w,x,y,z\n0,0.5,0,0,0\n") ==
        "turn.csv:2:3: error: a quaternion of length 0.5, expected 1 within 0.001\n"
        "    2 | 0,0.5,0,0,0\n"
        "      |   ^\n");
  CHECK(attitude_message("time_s,w,x,y\n0,1,0,0\n") ==
        "turn.csv:1:1: error: the column \"z\" is missing\n"
        "    1 | time_s,w,x,y\n"
        "      | ^\n");
  CHECK(attitude_message("time_s,w,x,y,z,yaw_deg\n0,1,0,0,0,5\n") ==
        "turn.csv:1:1: error: give either the columns w, x, y, z or yaw_deg, pitch_deg, roll_deg, "
        "not both\n"
        "    1 | time_s,w,x,y,z,yaw_deg\n"
        "      | ^\n");
  CHECK(attitude_message("time_s\n0\n") ==
        "turn.csv:1:1: error: expected the columns w, x, y, z or yaw_deg, pitch_deg, roll_deg\n"
        "    1 | time_s\n"
        "      | ^\n");
  CHECK(attitude_message("time_s,w,x,y,z\n0,1,0,0,0\n0,1,0,0,0\n") ==
        "turn.csv:3:1: error: time_s must ascend: 0 follows 0\n"
        "    3 | 0,1,0,0,0\n"
        "      | ^\n");
}
