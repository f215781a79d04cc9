// Canonical forms printed by the old system (tests/data/golden/definitions.json, made from programs
// of ours).
#include <fstream>
#include <map>

#include <nlohmann/json.hpp>

#include "tests/unit/runtime/define/forms.h"

namespace arelem::define::test {
namespace {

using Names = std::map<std::string, EntityPtr>;

Parameter parameterOf(const nlohmann::json& value, const Names& names) {
  if (value.is_null()) {
    return Omitted{};
  }
  if (value.is_number()) {
    return value.get<double>();
  }
  if (value.contains("word")) {
    return *findWord(value["word"].get<std::string>());
  }
  return names.at(value["entity"].get<std::string>());
}

Context contextOf(const nlohmann::json& row) {
  if (!row.contains("zsurf")) {
    return {};
  }
  const auto& z = row["zsurf"];
  return {z[0].get<double>(), z[1].get<double>(), z[2].get<double>(), z[3].get<double>()};
}

/// Where the old system is less exact than 1e-9 (each explained in docs/differences.md): what it
/// may be off by.
double allowanceFor(const std::string& place) {
  static const std::map<std::string, double> known = {
      {"g05_vectors V25", 3e-9},  // turned by 2.7e-9 radians
      {"g05_vectors V26", 3e-9},
  };
  const auto found = known.find(place);
  return found == known.end() ? 1e-9 : found->second;
}

TEST(OldSystem, CanonicalFormsAgree) {
  std::ifstream file(std::string(ARELEM_SOURCE_DIR) + "/tests/data/golden/definitions.json");
  ASSERT_TRUE(file);
  const nlohmann::json rows = nlohmann::json::parse(file);
  std::map<std::string, Names> programs;
  int compared = 0;
  for (const auto& row : rows) {
    Names& names = programs[row["case"].get<std::string>()];
    const auto name = row["name"].get<std::string>();
    P parameters;
    for (const auto& value : row["parameters"]) {
      parameters.push_back(parameterOf(value, names));
    }
    const EntityType type = *entityType(*findWord(row["type"].get<std::string>()));
    const Entity entity = defined(type, parameters, contextOf(row));
    names[name] = std::make_shared<const Entity>(entity);
    if (row.contains("expected")) {
      const std::string place = row["case"].get<std::string>() + " " + name;
      expectCanon(entity.canon, row["expected"].get<std::vector<double>>(), allowanceFor(place),
                  place);
      ++compared;
    }
  }
  EXPECT_GE(compared, 234);
}

}  // namespace
}  // namespace arelem::define::test
