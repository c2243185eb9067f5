#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "support/catch.hpp"

// Hard scenes given to the command as a user would: a process of its own, without traps.

namespace nadir::sim {
namespace {

struct Ran {
  int status = -1;
  std::string said;
};

/// Runs the command on a scenario in a folder of its own.
Ran run(const std::string& name, const std::string& scenario) {
  const auto folder = std::filesystem::temp_directory_path() /
                      ("nadir_hard_" + name + "_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream{folder / "scene.xml"} << scenario;
  const std::string command = std::string{NADIR_COMMAND} + " run " +
                              (folder / "scene.xml").string() + " -o " + (folder / "out").string() +
                              " 2>&1";
  Ran ran;
  if (FILE* pipe = ::popen(command.c_str(), "r"); pipe != nullptr) {
    char part[512];
    while (std::fgets(part, sizeof part, pipe) != nullptr) ran.said += part;
    const int status = ::pclose(pipe);
    if (WIFEXITED(status)) ran.status = WEXITSTATUS(status);
  }
  std::filesystem::remove_all(folder);
  return ran;
}

struct Parts {
  std::string place = "latitude_deg=\"36\" longitude_deg=\"-84\"";
  std::string geometry = "<plane material=\"grey\" size_x_m=\"100\" size_y_m=\"100\"/>";
  int pitch_deg = -90;
};
std::string scenario(const Parts& parts) {
  return "<scenario name=\"hard\"><time utc=\"2026-06-21T16:00:00Z\"/><site " + parts.place +
         " height_m=\"300\"/><illumination><fixed/></illumination><atmosphere><none/></atmosphere>"
         "<materials default_temperature_k=\"300\"><material name=\"grey\" reflectance=\"0.5\"/>"
         "</materials><geometry>" +
         parts.geometry +
         "</geometry><platform><position><local east_m=\"0\" north_m=\"0\" "
         "up_m=\"1000\"/></position>"
         "<attitude><euler yaw_deg=\"0\" pitch_deg=\"" +
         std::to_string(parts.pitch_deg) +
         "\"/></attitude></platform><camera><orthographic><array name=\"main\" samples=\"4\" "
         "lines=\"3\" ground_pitch_m=\"1\"><band_box name=\"thermal\" lo_um=\"8\" hi_um=\"12\"/>"
         "</array></orthographic></camera></scenario>";
}

TEST_CASE("command: a scene of nothing is refused with what is missing, exit code 2",
          "[hard][command]") {
  const Ran ran = run("nothing", scenario({.geometry = ""}));
  CAPTURE(ran.said);
  CHECK(ran.status == 2);
  CHECK(ran.said.find("<geometry> needs") != std::string::npos);
}

TEST_CASE("command: a camera that sees the sky alone is told so, exit code 2", "[hard][command]") {
  const Ran ran = run("sky", scenario({.pitch_deg = 90}));
  CAPTURE(ran.said);
  CHECK(ran.status == 2);
  CHECK(ran.said.find("error:") != std::string::npos);
}

TEST_CASE("command: scenes on the date line and at the poles are rendered", "[hard][command]") {
  for (const char* place :
       {"latitude_deg=\"10\" longitude_deg=\"180\"", "latitude_deg=\"-10\" longitude_deg=\"-180\"",
        "latitude_deg=\"90\" longitude_deg=\"0\"", "latitude_deg=\"-90\" longitude_deg=\"77\""}) {
    const Ran ran = run("place", scenario({.place = place}));
    CAPTURE(place, ran.said);
    CHECK(ran.status == 0);
  }
}

}  // namespace
}  // namespace nadir::sim
