#include "sim/run/run_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sim/files/hash.hpp"
#include "sim/scenario/xml_document.hpp"

namespace nadir::sim {
namespace {

using KeyJson = nlohmann::ordered_json;

/// Lengths before the texts: no two different elements give the same bytes.
void add_key_text(std::string& bytes, const std::string& text) {
  bytes += fmt::format("{}:{}", text.size(), text);
}

bool decides_samples(const XmlElement& element) {
  return element.name != "products" && element.name != "sampling";
}

void add_key_element(std::string& bytes, const XmlElement& element) {
  add_key_text(bytes, element.name);
  for (const XmlAttribute& attribute : element.attributes) {
    add_key_text(bytes, attribute.name);
    add_key_text(bytes, attribute.value);
  }
  bytes += '(';
  for (const XmlElement& child : element.children) {
    if (decides_samples(child)) add_key_element(bytes, child);
  }
  bytes += ')';
}

void add_differences(std::vector<std::string>& found, const std::vector<KeyPart>& a,
                     const std::vector<KeyPart>& b) {
  // Names may stand more than once: two files of one name in two folders.
  const auto lacks = [](const std::vector<KeyPart>& parts, const KeyPart& part) {
    return std::find(parts.begin(), parts.end(), part) == parts.end();
  };
  const auto note = [&](const std::string& name) {
    if (std::find(found.begin(), found.end(), name) == found.end()) found.push_back(name);
  };
  for (const KeyPart& part : a) {
    if (lacks(b, part)) note(part.first);
  }
  for (const KeyPart& part : b) {
    if (lacks(a, part)) note(part.first);
  }
  if (found.empty() && a != b) note("the order of inputs");
}

KeyJson json_of(const std::vector<KeyPart>& parts) {
  KeyJson json = KeyJson::array();
  for (const KeyPart& part : parts) json.push_back({part.first, part.second});
  return json;
}

std::vector<KeyPart> parts_of(const KeyJson& json) {
  std::vector<KeyPart> parts;
  for (const KeyJson& part : json) {
    parts.emplace_back(part.at(0).get<std::string>(), part.at(1).get<std::string>());
  }
  return parts;
}

std::optional<double> optional_number(const KeyJson& json) {
  return json.is_null() ? std::nullopt : std::optional{json.get<double>()};
}

}  // namespace

std::string RunKey::digest() const {
  std::string bytes;
  for (const auto* parts : {&physics, &sampling}) {
    for (const KeyPart& part : *parts) {
      add_key_text(bytes, part.first);
      add_key_text(bytes, part.second);
    }
    bytes += ';';
  }
  add_key_text(bytes, fmt::format("{}", seed));
  return digest_bytes(bytes).sha256;
}

std::string differences(const RunKey& a, const RunKey& b, bool whole) {
  std::vector<std::string> found;
  add_differences(found, a.physics, b.physics);
  if (whole) {
    add_differences(found, a.sampling, b.sampling);
    if (a.seed != b.seed) found.emplace_back("seed");
  }
  return fmt::format("{}", fmt::join(found, ", "));
}

std::string scenario_digest(const std::string& text) {
  std::string bytes;
  add_key_element(bytes, parse_xml(SourceText{"scenario", text}));
  return digest_bytes(bytes).sha256;
}

std::string to_json(const KeyedSeeds& keyed) {
  const RunKey& key = keyed.key;
  KeyJson json;
  json["scenario"] = key.scenario.string();
  json["accuracy"] = key.accuracy ? KeyJson(*key.accuracy) : KeyJson();
  json["time_s"] = key.time_s ? KeyJson(*key.time_s) : KeyJson();
  json["seeds"] = keyed.seeds;
  json["physics"] = json_of(key.physics);
  json["sampling"] = json_of(key.sampling);
  return json.dump(1, ' ', false, KeyJson::error_handler_t::replace);
}

std::optional<KeyedSeeds> keyed_seeds_from(std::string_view text) try {
  const KeyJson json = KeyJson::parse(text);
  KeyedSeeds keyed;
  keyed.key.scenario = json.at("scenario").get<std::string>();
  keyed.key.accuracy = optional_number(json.at("accuracy"));
  keyed.key.time_s = optional_number(json.at("time_s"));
  keyed.seeds = json.at("seeds").get<std::vector<std::uint64_t>>();
  keyed.key.physics = parts_of(json.at("physics"));
  keyed.key.sampling = parts_of(json.at("sampling"));
  if (keyed.seeds.empty()) return std::nullopt;
  keyed.key.seed = keyed.seeds.front();
  return keyed;
} catch (const KeyJson::exception&) {
  return std::nullopt;
}

}  // namespace nadir::sim
