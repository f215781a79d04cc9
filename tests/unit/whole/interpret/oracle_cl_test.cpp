#include <gtest/gtest.h>

#include "runtime/path/transform.h"
#include "tests/unit/backend/oracle_records.h"
#include "tests/unit/whole/interpret/section_one.h"

// Whole programs of positioning, patterns, post words, loops, TRACUT and COPY against the records
// of the old system: record by record, statement by statement, coordinates to 1e-9.
namespace arelem {
namespace {

namespace fs = std::filesystem;

std::vector<cl::Record> recordsOf(test::SectionOne& run) {
  cl::Recording out;
  const auto transformer = path::makeTransformer(out, run.sink);
  (void)runtime::execute(run.evaluation.actions, {}, *transformer, run.sink);
  transformer->finish();
  return out.records;
}

std::vector<cl::Record> comparable(const std::vector<cl::Record>& all) {
  std::vector<cl::Record> result;
  for (const cl::Record& record : all) {
    if (!std::holds_alternative<cl::Card>(record.body)) {
      result.push_back(record);
    }
  }
  return result;
}

void expectNear(const std::vector<double>& got,
                const std::vector<double>& want,
                const std::string& where) {
  ASSERT_EQ(got.size(), want.size()) << where;
  for (std::size_t i = 0; i < got.size(); ++i) {
    EXPECT_NEAR(got[i], want[i], 5e-9 * std::max(1.0, std::abs(want[i])))
        << where << " number " << i;
  }
}

void expectSameValue(const cl::Value& got, const cl::Value& want, const std::string& where) {
  ASSERT_EQ(got.index(), want.index()) << where;
  if (const double* number = std::get_if<double>(&want)) {
    expectNear({std::get<double>(got)}, {*number}, where);
  } else if (const auto* surface = std::get_if<cl::SurfaceValue>(&want)) {
    expectNear(std::get<cl::SurfaceValue>(got).canon, surface->canon, where);
  } else {
    EXPECT_EQ(got, want) << where;
  }
}

void expectSame(const cl::Record& got, const cl::Record& want, const std::string& where) {
  ASSERT_EQ(got.body.index(), want.body.index()) << where;
  EXPECT_EQ(cl::typeCode(got.body).sub, cl::typeCode(want.body).sub) << where;
  if (const auto* motion = std::get_if<cl::Motion>(&want.body)) {
    EXPECT_EQ(got.isn, want.isn) << where;
    EXPECT_EQ(std::get<cl::Motion>(got.body).name, motion->name) << where;
    EXPECT_EQ(std::get<cl::Motion>(got.body).subscript, motion->subscript) << where;
    expectNear(std::get<cl::Motion>(got.body).coordinates, motion->coordinates, where);
  } else if (const auto* post = std::get_if<cl::Post>(&want.body)) {
    const std::vector<cl::Value>& arguments = std::get<cl::Post>(got.body).arguments;
    ASSERT_EQ(arguments.size(), post->arguments.size()) << where;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      expectSameValue(arguments[i], post->arguments[i], where);
    }
  } else if (const auto* values = std::get_if<cl::Values>(&want.body)) {
    expectNear(std::get<cl::Values>(got.body).values, values->values, where);
  }
}

class OracleCl : public testing::TestWithParam<std::string> {};

TEST_P(OracleCl, AgreesRecordByRecord) {
  const fs::path base = fs::path(ARELEM_SOURCE_DIR) / "tests/data/oracle/cases" / GetParam();
  test::SectionOne run(fs::path(base.string() + ".apt"));
  const std::vector<cl::Record> got = comparable(recordsOf(run));
  ASSERT_EQ(run.sink.errors(), 0U) << run.messages();
  const std::vector<cl::Record> want =
      comparable(test::readOracleCase(base.string() + ".json").records);
  ASSERT_EQ(got.size(), want.size());
  for (std::size_t i = 0; i < want.size(); ++i) {
    expectSame(got[i], want[i], fmt::format("record {} of statement {}", i, want[i].isn));
  }
}

INSTANTIATE_TEST_SUITE_P(Programs,
                         OracleCl,
                         testing::Values("e01_goto_godlta",
                                         "e02_post_words",
                                         "e04_copy_xyrot",
                                         "e05_copy_transl",
                                         "e10_loop",
                                         "e16_synonym_case",
                                         "e21_helix_loop",
                                         "e23_transl_tracut_copy",
                                         "e30_tracut_multax",
                                         "e31_goto_ijk",
                                         "g11_patern"),
                         [](const auto& parameter) { return parameter.param; });

TEST(SystemMacros, StartAndEndTheWorkOfATool) {
  test::SectionOne run(
      std::string("LIBRY/STRTUP,TLEND\n"
                  "SPT1=POINT/-2,2,0\n"
                  "CALL/STRTUP,TL=1,SFMIN=1000,CUTR=.25,SPT=SPT1\n"
                  "CALL/STRTUP,TL=2,SFMIN=100,CUTR=.5,SPT=SPT1\n"
                  "CALL/TLEND\n"
                  "FINI\n"));
  const std::vector<cl::Record> records = recordsOf(run);
  ASSERT_EQ(run.sink.errors(), 0U) << run.messages();
  std::vector<std::string> seen;
  for (const cl::Record& record : records) {
    if (const auto* motion = std::get_if<cl::Motion>(&record.body)) {
      seen.push_back("GOTO " + motion->name);
    } else if (const auto* values = std::get_if<cl::Values>(&record.body)) {
      seen.push_back(fmt::format("{} {}", spell(values->word), values->values[0]));
    } else if (const auto* post = std::get_if<cl::Post>(&record.body)) {
      const double* number =
          post->arguments.empty() ? nullptr : std::get_if<double>(&post->arguments[0]);
      seen.push_back(std::string(spell(post->word)) +
                     (number != nullptr ? fmt::format(" {}", *number) : ""));
    }
  }
  // 4 * 1000 / .25 = 16000 is more than the spindle of 10000 gives; 4 * 100 / .5 = 800 is not.
  const std::vector<std::string> want = {
      "CLRSRF",     "LOADTL 1",  "CUTTER 0.25", "SPINDL 10000", "CUTCOM",    "COOLNT",
      "RAPID",      "GOTO SPT1", "CLRSRF",      "CLRSRF",       "LOADTL 2",  "CUTTER 0.5",
      "SPINDL 800", "CUTCOM",    "COOLNT",      "RAPID",        "GOTO SPT1", "CLRSRF",
      "RAPID",      "CLRSRF",    "COOLNT",      "SPINDL",       "OPSTOP"};
  EXPECT_EQ(seen, want);
}

}  // namespace
}  // namespace arelem
