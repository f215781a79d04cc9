#include "backend/report/report.h"

#include <fstream>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace arelem::backend {
namespace {

using nlohmann::json;

/// The part of JSON Schema that report.schema.json uses. Returns the first violation, or "".
class Validator {
 public:
  explicit Validator(json schema) : root_(std::move(schema)) {}
  std::string check(const json& value) const { return check(root_, value, "$"); }

 private:
  static bool isOfType(const json& value, const std::string& type) {
    return (type == "object" && value.is_object()) || (type == "array" && value.is_array()) ||
           (type == "string" && value.is_string()) || (type == "boolean" && value.is_boolean()) ||
           (type == "null" && value.is_null()) || (type == "number" && value.is_number()) ||
           (type == "integer" && value.is_number_integer());
  }
  std::string check(const json& given, const json& value, const std::string& at) const {
    const json& schema =
        given.contains("$ref") ? root_["$defs"][given["$ref"].get<std::string>().substr(8)] : given;
    bool fits = !schema.contains("type");
    for (const json& type :
         schema["type"].is_array() ? schema["type"] : json::array({schema["type"]})) {
      fits = fits || isOfType(value, type.get<std::string>());
    }
    if (!fits) {
      return at + " has the wrong type";
    }
    if (schema.contains("const") && value != schema["const"]) {
      return at + " has the wrong value";
    }
    if (value.is_number() && schema.contains("minimum") &&
        value.get<double>() < schema["minimum"].get<double>()) {
      return at + " is too small";
    }
    if (value.is_array()) {
      for (std::size_t i = 0; i < value.size(); ++i) {
        if (const std::string fault =
                check(schema["items"], value[i], at + "[" + std::to_string(i) + "]");
            !fault.empty()) {
          return fault;
        }
      }
    }
    return value.is_object() ? checkObject(schema, value, at) : "";
  }
  std::string checkObject(const json& schema, const json& value, const std::string& at) const {
    for (const json& name : schema.value("required", json::array())) {
      if (!value.contains(name.get<std::string>())) {
        return at + " lacks " + name.get<std::string>();
      }
    }
    for (const auto& [name, member] : value.items()) {
      const bool known = schema.contains("properties") && schema["properties"].contains(name);
      const json& additional = schema["additionalProperties"];
      if (!known && !additional.is_object()) {
        return at + " has the unknown member " + name;
      }
      const std::string fault =
          check(known ? schema["properties"][name] : additional, member, at + "." + name);
      if (!fault.empty()) {
        return fault;
      }
    }
    return "";
  }
  json root_;
};

Validator validator() {
  std::ifstream in(std::string(ARELEM_SOURCE_DIR) + "/docs/manual/report.schema.json");
  return Validator(json::parse(in));
}

Report sample() {
  Report report;
  report.toolVersion = "0.1.0";
  report.sources = {"part.apt", "lib \"x\"\n.apt"};
  report.statements = {{"GOTO", 2}, {"CIRCLE", 1}};
  report.motions = {{{"part.apt", 12},
                     9,
                     "GOFWD",
                     3,
                     40,
                     12.5,
                     ReportedMotion::Deviation{-0.001, 0.0005},
                     ReportedMotion::Deviation{-0.0, 0.0},
                     0.25},
                    {{"part.apt", 13}, 10, "GOTO", 1, 1, 1.5, std::nullopt, std::nullopt, 0.5}};
  report.wordsWithoutEffect = {{{"part.apt", 3}, "NOPLOT", "chosen by the command", 2}};
  report.features = {{"PT-04", 3}};
  report.dialect = "auto";
  report.errors = 1;
  report.warnings = 2;
  return report;
}

std::string text(const Report& report) {
  std::ostringstream out;
  writeReport(out, report);
  return out.str();
}

TEST(Report, SatisfiesItsSchema) {
  Report report = sample();
  EXPECT_EQ(validator().check(json::parse(text(report))), "");
  report.timing = Timing{0.1, 0.2, 0.3, 0.4};
  EXPECT_EQ(validator().check(json::parse(text(report))), "");
  EXPECT_EQ(validator().check(json::parse(text(Report{}))), "");
}

TEST(Report, TheSchemaRefusesWhatIsWrong) {
  const json good = json::parse(text(sample()));
  json bad = good;
  bad["motions"][0].erase("isn");
  EXPECT_EQ(validator().check(bad), "$.motions[0] lacks isn");
  bad = good;
  bad["motions"][1]["drive"] = 3;
  EXPECT_EQ(validator().check(bad), "$.motions[1].drive has the wrong type");
  bad = good;
  bad["extra"] = 1;
  EXPECT_EQ(validator().check(bad), "$ has the unknown member extra");
  Report report = sample();
  report.motions[0].pathLength = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(validator().check(json::parse(text(report))),
            "$.motions[0].pathLength has the wrong type");
}

TEST(Report, Values) {
  const json document = json::parse(text(sample()));
  EXPECT_EQ(document["totals"]["cutVectors"], 41);
  EXPECT_EQ(document["totals"]["pathLength"], 14.0);
  EXPECT_EQ(document["motions"][0]["drive"]["outer"], 0.0005);
  EXPECT_EQ(document["motions"][0]["part"]["inner"].dump(), "0.0");
  EXPECT_TRUE(document["motions"][1]["part"].is_null());
  EXPECT_FALSE(document.contains("timing"));
}

TEST(Report, TimesStandApart) {
  Report fast = sample();
  fast.timing = Timing{};
  Report slow = sample();
  slow.timing = Timing{1, 2, 3, 4};
  slow.motions[0].seconds = 9.0;
  json a = json::parse(text(fast));
  json b = json::parse(text(slow));
  EXPECT_EQ(b["timing"]["motions"], json::array({9.0, 0.5}));
  a.erase("timing");
  b.erase("timing");
  EXPECT_EQ(a, b);
}

}  // namespace
}  // namespace arelem::backend
