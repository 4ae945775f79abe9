// Laws that a case names: closed sets, read by name and told of in the case reference.
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "helpers.hpp"

using namespace pmr;
using namespace pmr::test;
using Catch::Contains;

namespace {

const std::string rolling = "[models]\nmechanics = {rolling = \"cdt\"}\n";

template <class... Law>
std::vector<std::string> names(const std::variant<Law...>*) {
  return {Law::name...};
}
template <class Set>
std::vector<std::string> names_of() {
  return names(static_cast<const Set*>(nullptr));
}

// The reference's table row of a key, or "".
std::string row_of(const std::string& key) {
  std::ifstream in(PMR_SOURCE_DIR "/docs/case-reference.md");
  std::string rows;
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("| `" + key + "`")) rows += line;
  return rows;
}

}  // namespace

TEST_CASE("a case without contact laws has those of the demonstrator study") {
  const ContactModel contact = load(small_case).models.mechanics.contact;
  CHECK(std::holds_alternative<HertzCoulomb>(contact.force));
  CHECK(std::holds_alternative<Epsd2>(contact.rolling));
}

TEST_CASE("a case names its rolling law") {
  const Case made = load(small_case + rolling);
  CHECK(std::holds_alternative<Cdt>(made.models.mechanics.contact.rolling));
}

TEST_CASE("a law that is none is a fault that names the nearest, and hides no other fault") {
  const auto faults = faults_of(replaced(small_case + rolling, "\"cdt\"", "\"ctd\", skin = -1"));
  REQUIRE(faults.size() == 2);
  CHECK_THAT(faults[0], Contains("models.mechanics.rolling") && Contains("'cdt'"));
  CHECK_THAT(faults[1], Contains("models.mechanics.skin"));
}

TEST_CASE("the case reference names every law") {
  const std::pair<std::string, std::vector<std::string>> sets[] = {
      {"mechanics.contact", names_of<ForceLaw>()},
      {"mechanics.rolling", names_of<RollingLaw>()},
      {"redox.rate", names_of<RateLaw>()},
      {"heat", names_of<HeatLaw>()}};
  for (const auto& [key, laws] : sets)
    for (const std::string& law : laws) {
      INFO(key);
      CHECK_THAT(row_of(key), Contains("\"" + law + "\""));
    }
}
