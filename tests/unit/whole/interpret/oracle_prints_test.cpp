#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/unit/whole/interpret/section_one.h"

// What the old system printed for its geometry cases, against PRINT of ours: value by value to 1e-9
// of the larger of 1 and the value (its constant for degrees is wrong in the 12th digit).
namespace arelem {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

const fs::path cases = fs::path(ARELEM_SOURCE_DIR) / "tests/data/oracle/cases";

std::vector<std::string> geometryCases() {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(cases)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".apt" && name.front() == 'g') {
      names.push_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Where the old system is not right, or less exact than elsewhere.
struct Deviation {
  std::string_view program, name;
  double tolerance;
  std::string_view why;
};
constexpr Deviation deviations[] = {
    {"g05_vectors", "V25", 1e-8, "its VECTOR/ATANGL is exact to nine digits only"},
    {"g05_vectors", "V26", 1e-8, "its VECTOR/ATANGL is exact to nine digits only"},
    {"g12_arith", "X1", 4.0, "it computes -A**2 as (-A)**2; the language says -(A**2)"},
};

double toleranceOf(std::string_view program, const json& want) {
  for (const Deviation& d : deviations) {
    if (d.program == program && want["name"] == d.name) {
      return d.tolerance;
    }
  }
  return 1e-9;
}

bool sameValues(const runtime::Printed& got, const json& want, double tolerance) {
  const std::vector<double> values =
      got.entity ? got.entity->canon : std::vector<double>{got.scalar};
  const std::string type = got.entity ? std::string(spell(got.entity->type)) : "SCALAR";
  if (type != want["type"] || values.size() != want["values"].size()) {
    return false;
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double w = want["values"][i].get<double>();
    if (std::abs(values[i] - w) > tolerance * std::max(1.0, std::abs(w))) {
      return false;
    }
  }
  return true;
}

/// The old system computes nested definitions from right to left, we from left to right: those of a
/// run of unnamed ones are compared in any order.
std::vector<json> inOurOrder(const std::vector<const runtime::Printed*>& got, const json& prints) {
  std::vector<json> ordered(prints.begin(), prints.end());
  const auto nested = [](const json& p) { return p["name"] == "*NESTED*"; };
  for (auto first = ordered.begin(); first != ordered.end(); ++first) {
    const auto last = std::find_if_not(first, ordered.end(), nested);
    const auto match = std::find_if(first, last, [&](const json& want) {
      return sameValues(*got[static_cast<std::size_t>(first - ordered.begin())], want, 1e-9);
    });
    if (match != last) {
      std::iter_swap(first, match);
    }
  }
  return ordered;
}

/// The old system can print neither patterns nor tabulated cylinders.
bool isComparable(const runtime::Printed& p) {
  return p.title.empty() && p.mode != 0 && !p.undefined &&
         (!p.entity || canonicalCount(p.entity->type) != 0);
}

class OraclePrints : public testing::TestWithParam<std::string> {};

TEST_P(OraclePrints, AgreeWithTheOldSystem) {
  const test::SectionOne run(cases / (GetParam() + ".apt"));
  for (const Diagnostic& d : run.sink.all()) {
    EXPECT_NE(d.severity(), Severity::error)
        << run.messages();
  }
  std::ifstream in(cases / (GetParam() + ".json"));
  const json prints = json::parse(in)["prints"];
  std::vector<const runtime::Printed*> got;
  for (const runtime::Printed& p : run.evaluation.printed) {
    if (isComparable(p)) {
      got.push_back(&p);
    }
  }
  ASSERT_EQ(got.size(), prints.size());
  const std::vector<json> wanted = inOurOrder(got, prints);
  for (std::size_t i = 0; i < got.size(); ++i) {
    const json& want = wanted[i];
    const std::string name = want["name"].get<std::string>();
    EXPECT_EQ(got[i]->name, name == "*NESTED*" ? "" : name) << i;
    EXPECT_EQ(got[i]->subscript, want["subscript"].get<int>()) << i;
    EXPECT_TRUE(sameValues(*got[i], want, toleranceOf(GetParam(), want)))
        << i << ": the old system has " << want.dump() << ", here "
        << (got[i]->entity ? json(got[i]->entity->canon) : json(got[i]->scalar)).dump();
  }
}

INSTANTIATE_TEST_SUITE_P(Programs,
                         OraclePrints,
                         testing::ValuesIn(geometryCases()),
                         [](const auto& parameter) { return parameter.param; });

}  // namespace
}  // namespace arelem
