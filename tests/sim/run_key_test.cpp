#include "sim/run/run_key.hpp"

#include "core/error.hpp"
#include "sim/kept_samples.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

using support::some_key;

TEST_CASE("a run key changes with everything that decides samples", "[sim][run_key]") {
  const RunKey key = some_key();
  RunKey physics = key, sampling = key, seed = key, fewer = key;
  physics.physics[1].second = "abd";
  sampling.sampling[0].second = "4 x 3";
  seed.seed = 2;
  fewer.physics.pop_back();
  for (const RunKey& other : {physics, sampling, seed, fewer}) {
    CHECK(other.digest() != key.digest());
    CHECK_FALSE(other.same_samples(key));
  }
  CHECK(sampling.same_physics(key));
  CHECK(seed.same_physics(key));
  CHECK_FALSE(physics.same_physics(key));
  RunKey moved = key;
  moved.scenario = "/elsewhere/yard.xml";
  CHECK(moved.digest() == key.digest());
  CHECK(moved.same_samples(key));
}

TEST_CASE("parts of a key cannot flow into one another", "[sim][run_key]") {
  RunKey a, b;
  a.physics = {{"x", "yz"}};
  b.physics = {{"xy", "z"}};
  CHECK(a.digest() != b.digest());
  a.physics = {};
  a.sampling = {{"x", "y"}};
  b.physics = {{"x", "y"}};
  CHECK(a.digest() != b.digest());
}

TEST_CASE("differences are named, each once", "[sim][run_key]") {
  const RunKey key = some_key();
  CHECK(differences(key, key, true).empty());
  RunKey other = key;
  other.physics[1].second = "changed";
  other.physics[2].second = "changed";
  other.sampling[0].second = "4 x 3";
  other.seed = 9;
  CHECK(differences(key, other, false) == "scenario, file \"ball.obj\"");
  CHECK(differences(other, key, true) == "scenario, file \"ball.obj\", samples, seed");
  RunKey more = key;
  more.physics.emplace_back("file \"shed.obj\"", "123");
  CHECK(differences(key, more, false) == "file \"shed.obj\"");
  CHECK(differences(more, key, false) == "file \"shed.obj\"");
}

TEST_CASE("layout, comments, products and sampling are not of the scenario's digest",
          "[sim][run_key]") {
  const std::string digest = scenario_digest(
      "<scenario name=\"a\"><time utc=\"t\"/><sampling replicates=\"4\"/></scenario>");
  CHECK(digest.size() == 64);
  CHECK(scenario_digest("<!-- new -->\n<scenario  name='a' >\n  <time utc=\"t\"/>\n"
                        "  <products netcdf=\"true\"/></scenario>") == digest);
  CHECK(scenario_digest("<scenario name=\"a\"><time utc=\"u\"/></scenario>") != digest);
  CHECK(scenario_digest("<scenario name=\"a\"><time utc=\"t\"/><time utc=\"t\"/></scenario>") !=
        digest);
  CHECK(scenario_digest("<scenario name=\"a\"><x><time utc=\"t\"/></x></scenario>") !=
        scenario_digest("<scenario name=\"a\"><x/><time utc=\"t\"/></scenario>"));
  CHECK_THROWS_AS(scenario_digest("<scenario"), InputError);
}

TEST_CASE("a key comes back from its text", "[sim][run_key]") {
  RunKey key = some_key(0xFFFFFFFFFFFFFFFFU);
  key.accuracy = 0.1;
  const auto back = keyed_seeds_from(to_json(KeyedSeeds{key, {key.seed, 3}}));
  REQUIRE(back);
  CHECK(back->key.same_samples(key));
  CHECK(back->key.scenario == key.scenario);
  CHECK(back->key.accuracy == key.accuracy);
  CHECK_FALSE(back->key.time_s);
  CHECK(back->seeds == std::vector<std::uint64_t>{key.seed, 3});
  for (const char* text : {"", "{}", "[1]", "{\"seeds\": 1}"}) CHECK_FALSE(keyed_seeds_from(text));
  CHECK_FALSE(keyed_seeds_from(to_json(KeyedSeeds{key, {}})));
}

}  // namespace
}  // namespace nadir::sim
