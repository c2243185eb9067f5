#include "sim/files/grid_file.hpp"

#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "core/error.hpp"
#include "sim/files/phase_table.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

std::string grid_header(const std::string& type, const std::string& sizes = "2 1 3") {
  return "NRRD0004\n# from a plume model\ntype: " + type + "\ndimension: 3\nsizes: " + sizes +
         "\nspacings: 1 1 2\nendian: little\nencoding: raw\nauthor:=nobody\n\n";
}

template <class Number>
std::string bytes_of(const std::vector<Number>& values) {
  std::string bytes(values.size() * sizeof(Number), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

template <class Action>
std::string all_messages(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    std::string text;
    for (const InputIssue& issue : error.issues()) {
      text += std::to_string(issue.where.line) + ":" + std::to_string(issue.where.column) + ": " +
              issue.message + "\n";
    }
    return text;
  }
  return "(accepted)";
}

std::string mistakes(const std::string& bytes) {
  return all_messages([&] { (void)parse_grid(bytes, "plume.nrrd"); });
}

TEST_CASE("a grid is read from every type of number, the first axis fastest", "[sim][grid]") {
  const std::vector<double> values{0.0, 1.0, 2.0, 3.0, 200.0, 255.0};
  const auto as = [&](auto zero) {
    std::vector<decltype(zero)> numbers;
    for (const double value : values) numbers.push_back(static_cast<decltype(zero)>(value));
    return bytes_of(numbers);
  };
  for (const std::string& file : {grid_header("float") + as(0.0F), grid_header("double") + as(0.0),
                                  grid_header("uint8") + as(std::uint8_t{}),
                                  grid_header("unsigned short") + as(std::uint16_t{})}) {
    const auto grid = parse_grid(file, "plume.nrrd");
    CHECK(grid.columns == 2);
    CHECK(grid.rows == 1);
    CHECK(grid.layers == 3);
    CHECK(std::vector<double>(grid.value.begin(), grid.value.end()) == values);
  }
}

TEST_CASE("a header without endian will do for bytes, and CR LF is a line's end", "[sim][grid]") {
  const std::string text =
      "NRRD0001\r\ntype: uchar\r\ndimension: 3\r\nsizes: 1 1 2\r\nencoding: raw\r\n\r\n";
  CHECK(parse_grid(text + "\x01\x02", "a").value == std::vector<float>{1.0F, 2.0F});
}

TEST_CASE("mistakes of a grid's header are all found, with line and column", "[sim][grid]") {
  CHECK(mistakes("P6 2 2\n") ==
        "0:0: this is no NRRD file: its first line is not \"NRRD0001\" to \"NRRD0005\"\n");
  CHECK(mistakes("NRRD0004\ntype: int\ndimension: 2\nsizes: 4 x 3\nencoding: gzip\n"
                 "endian: big\ndata file: plume.raw\nnonsense\n\n") ==
        "2:7: expected type float, double, uint8 or uint16, found \"int\"\n"
        "3:12: a grid has dimension 3, found \"2\"\n"
        "4:8: expected three sizes from 1 to 65536, found \"4 x 3\"\n"
        "5:11: only encoding raw is supported, found \"gzip\"\n"
        "6:9: only little-endian data is supported, found \"big\"\n"
        "7:12: data in a file of its own is not supported: it must follow the header\n"
        "8:1: expected \"field: value\", found \"nonsense\"\n");
  CHECK(mistakes("NRRD0004\ntype: float\nbyte skip: -1\n") ==
        "3:12: skipping is not supported: the data must follow the header's empty line\n"
        "0:0: the header has no end: an empty line before the data is missing\n"
        "0:0: the header has no field \"dimension\"\n"
        "0:0: the header has no field \"sizes\"\n"
        "0:0: the header has no field \"encoding\"\n"
        "0:0: the header has no field \"endian\"\n");
}

TEST_CASE("a grid's data must fill it with finite, non-negative values", "[sim][grid]") {
  const std::vector<float> five(5, 1.0F);
  CHECK(mistakes(grid_header("float") + bytes_of(five)) ==
        "0:0: the header promises 2 x 1 x 3 = 6 values of 4 bytes, 24 in all; 20 bytes follow "
        "it\n");
  std::vector<double> values(6, 1.0);
  values[3] = -0.5;
  values[4] = 1e300;
  CHECK(mistakes(grid_header("double") + bytes_of(values)) ==
        "0:0: the value in column 2, row 1, layer 2 is -0.5; it must be finite and not negative\n"
        "0:0: the value in column 1, row 1, layer 3 is 1e+300; it must be finite and not "
        "negative\n");
  CHECK_THROWS_AS(read_grid("/nowhere/plume.nrrd"), InputError);
}

std::string table_mistakes(const std::string& text) {
  return all_messages([&] { (void)parse_phase_table(text, "haze.csv"); });
}

TEST_CASE("a phase table is read by wavelength", "[sim][phase]") {
  const auto table = parse_phase_table(
      "# haze\nangle_deg, 0.55, 10\n0, 9, 3\n90, 1, 2\n\n180, 2, 1\n", "haze.csv");
  CHECK(table.wavelength_um == std::vector<double>{0.55, 10.0});
  CHECK(table.angle_rad.back() == Approx(3.14159265358979).epsilon(1e-14));
  CHECK(table.value == std::vector<double>{9, 1, 2, 3, 2, 1});
}

TEST_CASE("holes and other mistakes of a phase table are found where they are", "[sim][phase]") {
  CHECK(table_mistakes("angle_deg,0.5,1\n0,1,\n90,1\n60,-1,x\n50,1,1\n") ==
        "2:5: a phase table has no holes: expected a number\n"
        "3:1: expected 3 cells, found 2\n"
        "4:4: expected a number that is not negative, found \"-1\"\n"
        "4:7: expected a number that is not negative, found \"x\"\n"
        "5:1: expected an angle from 0 to 180 deg, greater than the one before it\n"
        "5:1: angles must reach from 0 to 180 deg, found 0 to 50\n");
  CHECK(table_mistakes("theta,0.5\n") ==
        "1:1: expected \"angle_deg\" and one or more wavelengths in um\n");
  CHECK(table_mistakes("angle_deg,0.5,0.4\n") ==
        "1:15: expected a wavelength in um, greater than the one before it\n");
}

}  // namespace
}  // namespace nadir::sim
