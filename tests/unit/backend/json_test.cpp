#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/unit/backend/oracle_records.h"
#include "tests/unit/backend/writing.h"

namespace arelem::test {
namespace {

using nlohmann::json;

void expectEqualLines(const std::vector<OracleCase>& cases) {
  for (const OracleCase& c : cases) {
    const std::vector<std::string> out = lines(written("json", c.records));
    ASSERT_EQ(out.size(), c.cl.size()) << c.name;
    for (std::size_t i = 0; i < out.size(); ++i) {
      EXPECT_EQ(json::parse(out[i]), c.cl[i]) << c.name << " record " << i << "\n" << out[i];
    }
  }
}

TEST(Json, LinesEqualTheRecordsOfTheOldSystem) {
  const std::vector<OracleCase> cases = readOracleCases();
  ASSERT_GE(cases.size(), 80U);
  expectEqualLines(cases);
}

TEST(Json, LinesEqualTheRecordsOfTheOldExamples) {
  const std::vector<OracleCase> examples = readOracleExamples();
  if (examples.empty()) {
    GTEST_SKIP() << "the old system's examples are not here; ARELEM_SHARED names their folder";
  }
  expectEqualLines(examples);
}

TEST(Json, FieldsStandInTheOrderOfTheOldRecords) {
  cl::Motion motion;
  motion.name = "L1";
  motion.coordinates = {1.0, -0.25, 1e-5};
  EXPECT_EQ(
      written("json", {record(7, motion)}),
      "{\"rec\": 2, \"type\": 5000, \"sub\": 5, \"isn\": 7, \"kind\": \"GOTO\", \"name\": \"L1\", "
      "\"subscript\": 0, \"points\": [[1.0, -0.25, 1e-05]]}\n");
}

TEST(Json, HostileTextStaysOneValidLine) {
  const std::string hostile = "A\"}\n{\"rec\":1}\\\x1b[2J\xff\xc2\x9b\xe2\x80\xae<b>";
  const std::vector<std::string> out =
      lines(written("json", {record(1, cl::Text{Word::PPRINT, hostile})}));
  ASSERT_EQ(out.size(), 1U);
  const json parsed = json::parse(out[0]);
  EXPECT_EQ(parsed["text"], "A\"}\n{\"rec\":1}\\\x1b[2J\xef\xbf\xbd\xc2\x9b\xe2\x80\xae<b>");
  EXPECT_EQ(out[0].find('\x1b'), std::string::npos);
}

TEST(Json, NewKindsOfRecords) {
  const std::vector<std::string> out =
      lines(written("json", {record(1, cl::Units{Word::INCHES}),
                             record(2, cl::Post{Word::END, "CSI_SET", {1.5, std::string("ABC")}}),
                             record(3, cl::Raw{15000, 2, {1, 0x3ff0000000000000}})}));
  ASSERT_EQ(out.size(), 3U);
  EXPECT_EQ(json::parse(out[0]),
            json::parse(R"({"rec":2,"type":9000,"sub":9,"isn":1,"kind":"UNITS","unit":"INCHES"})"));
  EXPECT_EQ(
      json::parse(out[1]),
      json::parse(
          R"({"rec":4,"type":2000,"sub":0,"isn":2,"kind":"POST","word":"CSI_SET","args":[1.5,"ABC"]})"));
  EXPECT_EQ(json::parse(out[2]), json::parse(R"({"rec":6,"type":15000,"sub":2,"isn":3,"kind":"RAW",
                                                "words":["0000000000000001","3ff0000000000000"]})"));
}

}  // namespace
}  // namespace arelem::test
