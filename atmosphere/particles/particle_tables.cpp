#include "atmosphere/particles/particle_tables.hpp"

namespace nadir::atmosphere {

std::vector<std::string> required_kinds() {
  std::vector<std::string> names;
  for (const char* const type : {"rural", "urban", "maritime", "tropospheric"}) {
    for (const char* const humidity : {"_0", "_70", "_80", "_99"}) {
      names.push_back(std::string{type} + humidity);
    }
  }
  names.insert(names.end(), {"stratospheric", "volcanic_aged", "volcanic_fresh", "meteoric_dust"});
  for (std::string& type : cloud_types()) names.push_back(std::move(type));
  return names;
}

std::vector<std::string> required_haze() {
  std::vector<std::string> names;
  for (const char* const visibility : {"50", "23", "10", "5", "2"}) {
    names.push_back(std::string{"boundary_"} + visibility);
  }
  for (const char* const season : {"spring_summer", "autumn_winter"}) {
    for (const char* const visibility : {"_50", "_23"}) {
      names.push_back(std::string{"tropospheric_"} + season + visibility);
    }
    for (const char* const state : {"_background", "_moderate", "_high", "_extreme"}) {
      names.push_back(std::string{"stratospheric_"} + season + state);
    }
  }
  names.insert(names.end(), {"upper_background", "upper_moderate", "upper_extreme"});
  return names;
}

std::vector<std::string> cloud_types() {
  return {"cumulus", "altostratus", "stratus",       "stratocumulus", "nimbostratus",
          "cirrus",  "cirrus_thin", "fog_advection", "fog_radiation"};
}

}  // namespace nadir::atmosphere
