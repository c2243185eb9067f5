#include "sim/files/air_table_file.hpp"

#include <cmath>
#include <cstring>
#include <limits>

#include "air_table_support.hpp"
#include "core/error.hpp"
#include "message_of.hpp"
#include "scratch_folder.hpp"
#include "sim/files/air_table_layout.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using support::changed;
using support::message_of;
using support::sealed;

namespace {

std::string good() { return air_table_bytes({support::some_table(), "abc"}); }

std::string told(const std::string& bytes) {
  return message_of([&] { static_cast<void>(parse_air_table(bytes, "t.air")); });
}

bool starts(const std::string& text, const std::string& with) {
  CAPTURE(text, with);
  return text.starts_with(with);
}

/// All numbers of a table in one row.
std::vector<double> numbers(const atmosphere::AirTable& table) {
  std::vector<double> all;
  for_each_array(table, [&](const std::string&, const auto& values, const AirShape& shape) {
    // Some arrays may be left out as a whole (docs/air-table-format.md).
    const bool right_size = values.empty() || values.size() == count_of(shape);
    REQUIRE(right_size);
    for (const auto value : values) all.push_back(static_cast<double>(value));
  });
  return all;
}

}  // namespace

TEST_CASE("a table of the air is the same to the last bit after a round trip", "[air_table]") {
  const atmosphere::AirTable table = support::some_table();
  const AirTableFile back = parse_air_table(good(), "t.air");
  CHECK(back.inputs == "abc");
  CHECK(numbers(back.table) == numbers(table));
  CHECK(back.table.made_by == table.made_by);
  CHECK(back.table.notes == table.notes);
  CHECK(back.table.bodies[1].name == "moon");
  CHECK(back.table.bodies[0].azimuth_rad == 1.0 / 3.0);
  CHECK(back.table.views[0].zenith_rad == table.views[0].zenith_rad);
  CHECK(back.table.lanes[1].absorption == table.lanes[1].absorption);
  CHECK(back.table.interpolation_error == 0.1);
  CHECK(air_table_bytes(back) == good());
}

TEST_CASE("a table without bodies, kinds, views and night sky makes the round trip",
          "[air_table]") {
  atmosphere::AirTable table = support::some_table();
  table.bodies.clear();
  table.kinds = 0;
  table.phase_grid.clear();
  table.phase.clear();
  table.views.clear();
  table.night_top.clear();
  table.sky = support::some_view(table, 120.5, {0.0}, {1.0});
  const std::string bytes = air_table_bytes({table, {}});
  const AirTableFile back = parse_air_table(bytes, "t.air");
  CHECK(back.inputs.empty());
  CHECK(back.table.night_top.empty());
  CHECK(air_table_bytes(back) == bytes);
}

TEST_CASE("a table is written and read as a file", "[air_table]") {
  const support::ScratchFolder folder;
  write_air_table(folder / "a.air", {support::some_table(), {}});
  CHECK(folder.entries() == 1);
  CHECK(read_air_table(folder / "a.air").table.lanes.size() == 3);
  CHECK(message_of([&] { static_cast<void>(read_air_table(folder / "none.air")); }) ==
        (folder / "none.air").string() + ": error: the file cannot be read\n");
  CHECK(starts(message_of([&] { static_cast<void>(read_air_table(folder.path())); }),
               folder.path().string() + ": error: the file cannot be read"));
}

TEST_CASE("every changed byte of a table's file is found", "[air_table]") {
  const std::string bytes = good();
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string bad = bytes;
    bad[i] = static_cast<char>(bad[i] ^ (1 << (i % 8)));
    CAPTURE(i);
    REQUIRE_THROWS_AS(parse_air_table(bad, "t.air"), InputError);
  }
}

TEST_CASE("a table that was cut short anywhere is refused", "[air_table]") {
  const std::string bytes = good();
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    CAPTURE(length);
    REQUIRE_THROWS_AS(parse_air_table(bytes.substr(0, length), "t.air"), InputError);
  }
  CHECK(told(bytes.substr(0, 200)) ==
        "t.air: error: the file ends within its head: it is cut short\n");
  const std::string cut = told(bytes.substr(0, bytes.size() - 1));
  CHECK(cut.find(" follow it: the file is cut short\n") != std::string::npos);
  CHECK(told(bytes + "x").find(" follow it\n") != std::string::npos);
}

TEST_CASE("other files and other versions are told apart", "[air_table]") {
  CHECK(told("<xml/>") ==
        "t.air: error: this is no table of the air: its first line is not \"nadir air table 1\"\n");
  CHECK(told(changed(good(), "table 1\n", "table 2\n")) ==
        "t.air:1:17: error: a table of version \"2\"; this program reads version 1\n"
        "    1 | nadir air table 2\n"
        "      |                 ^\n");
}

TEST_CASE("a head that was changed by hand says which checksum it would need", "[air_table]") {
  const std::string bad = changed(good(), "note = first", "note = other");
  const std::string message = told(bad);
  CHECK(message.find("error: the head was changed after it was written") != std::string::npos);
  const std::string key = "if it was changed on purpose, write ";
  const std::size_t at = message.find(key);
  REQUIRE(at != std::string::npos);
  CHECK(sealed(bad).find(message.substr(at + key.size(), 64)) != std::string::npos);
  CHECK(parse_air_table(sealed(bad), "t.air").table.notes[0] == "other");
}

TEST_CASE("mistakes of a head are told with their lines", "[air_table]") {
  const auto wrong = [](const std::string& from, const std::string& to) {
    return told(sealed(changed(good(), from, to)));
  };
  CHECK(starts(wrong("top_m = 100000", "top_m = high"),
               "t.air:8:9: error: expected a number, found \"high\"\n    8 | top_m = high\n"));
  CHECK(starts(wrong("top_m =", "topp_m ="), "t.air: error: the head has no \"top_m\"\n"));
  CHECK(starts(wrong("top_m =", "extra = 1\ntop_m ="), "t.air:8:1: error: the key \"extra\""));
  CHECK(starts(wrong("top_m =", "note_ = 1\ntop_m ="),
               "t.air:8:1: error: the key \"note_\" is not known\n    8 | note_ = 1\n"
               "      | ^\n    hint: did you mean \"note\"?\n"));
  CHECK(starts(wrong("ground_m = 120.5", "top_m = 1"),
               "t.air:9:9: error: the key \"top_m\" stands here a second time"));
  CHECK(starts(wrong("lanes = 3", "lanes = 4"),
               "t.air: error: the head promises 4 lanes and lists 3\n"));
  CHECK(wrong("lane = 10.1 0 0 0 1", "lane = 10.1 0 0 0.5 1").find("term (a whole number)") !=
        std::string::npos);
  CHECK(wrong("array = sky.even float32 3x1x3", "array = sky.even float32 3x1x4")
            .find("is said to be 3x1x4, by the axes it is 3x1x3") != std::string::npos);
  CHECK(wrong("array = sky.even float32", "array = sky.even int16")
            .find("expected type float32 or float64, found \"int16\"") != std::string::npos);
  CHECK(wrong("array = sky.even", "array = sky.evem").find("did you mean \"sky.even\"?") !=
        std::string::npos);
  CHECK(wrong("array = sky.even float32 3x1x3 664", "array = sky.even float32 3x1x3 700") ==
        "t.air: error: the arrays overlap or leave gaps between them\n");
  CHECK(wrong("3x1x3 664", "3x1x3 99664").find("reaches past the end") != std::string::npos);
  CHECK(wrong("kinds = 2", "kinds = 999999").find("by the axes it is") != std::string::npos);
  CHECK(wrong("kinds = 2", "no equals sign").find("expected \"key = value\"") != std::string::npos);
}

TEST_CASE("numbers that no table has are told with their array's line", "[air_table]") {
  std::string bytes = good();
  const std::size_t start = bytes.find("head_sha256 = ") + 14 + 64 + 1;
  const float bad = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(bytes.data() + start + 4, &bad, sizeof bad);  // body.0.irradiance, second lane
  const std::string key = "payload_sha256 = ";
  bytes.replace(bytes.find(key) + key.size(), 64, digest_bytes(bytes.substr(start)).sha256);
  const std::string message = told(sealed(bytes));
  CHECK(message.find("array = body.0.irradiance float32 3 0\n") != std::string::npos);
  CHECK(message.find("value 1 of the array is not a finite number") != std::string::npos);
}

TEST_CASE("what the check of a table refuses is told of its file", "[air_table]") {
  const std::string message =
      told(sealed(changed(good(), "sky.zenith_rad = 0 0.5 1.5", "sky.zenith_rad = 0 1.5 0.5")));
  CHECK(starts(message, "t.air:1:1: error: air table: sky zenith: expected ascending nodes"));
}

TEST_CASE("arrays of double are taken for float ones", "[air_table]") {
  std::string bytes = good();
  const std::size_t start = bytes.find("head_sha256 = ") + 14 + 64 + 1;
  const std::string line = "array = body.0.irradiance float32 3 0";
  std::string payload = bytes.substr(start);
  const std::size_t old = payload.size();
  for (const double value : {1.0, 2.0, 0.1}) {
    payload.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  // The first array moves to the end; its old place is filled by the last, spherical_albedo's
  // twin in size would overlap: so it is cut out, and all others keep their offsets less 12.
  payload.erase(0, 12);
  std::string head = bytes.substr(0, start);
  std::string moved;
  for (std::size_t at = 0; at < head.size();) {
    const std::size_t end = head.find('\n', at);
    std::string text = head.substr(at, end - at);
    at = end + 1;
    if (text == line) {
      text = "array = body.0.irradiance float64 3 " + std::to_string(old - 12);
    } else if (text.starts_with("array = ")) {
      const std::size_t blank = text.rfind(' ');
      text = text.substr(0, blank + 1) + std::to_string(std::stoul(text.substr(blank + 1)) - 12);
    } else if (text.starts_with("payload_bytes")) {
      text = "payload_bytes = " + std::to_string(payload.size());
    } else if (text.starts_with("payload_sha256")) {
      text = "payload_sha256 = " + digest_bytes(payload).sha256;
    }
    moved += text + "\n";
  }
  const AirTableFile back = parse_air_table(sealed(moved + payload), "t.air");
  CHECK(back.table.bodies[0].irradiance == std::vector<float>{1.0F, 2.0F, 0.1F});
  CHECK(back.table.sky.even == support::some_table().sky.even);
}

TEST_CASE("a table as text names each value's place", "[air_table]") {
  const std::string csv = air_table_csv(support::some_table());
  CHECK(csv.starts_with("array,indices,value\nbody.0.irradiance,lane=0,1900\n"));
  CHECK(csv.find("\nview.0.smooth,body=1 azimuth=2 zenith=3 share=1 lane=2,") != std::string::npos);
  CHECK(csv.find("\nphase_grid,angle=1,0.25\n") != std::string::npos);
}
