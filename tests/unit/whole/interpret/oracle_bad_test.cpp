#include <gtest/gtest.h>

#include "tests/unit/whole/interpret/section_one.h"

// Every faulty program of the old system's suite is refused here as well, with the same number
// where the message has one, and Section 2 is asked where the old system finds the fault only
// there.
namespace arelem {
namespace {

namespace fs = std::filesystem;

struct Bad {
  std::string name;
  std::vector<std::string> legacy;  ///< each is reported
  bool motion = false;              ///< by Section 2
  frontend::Dialect dialect = frontend::Dialect::automatic;
};

void PrintTo(const Bad& bad, std::ostream* out) {
  *out << bad.name;
}

class OracleBad : public testing::TestWithParam<Bad> {};

TEST_P(OracleBad, IsRefused) {
  const Bad& bad = GetParam();
  test::SectionOne run(fs::path(ARELEM_SOURCE_DIR) / "tests/data/oracle/bad" / (bad.name + ".apt"),
                       bad.dialect);
  if (bad.motion) {
    EXPECT_EQ(run.sink.errors(), 0U) << run.messages();
    cl::Recording records;
    (void)runtime::execute(run.evaluation.actions, {}, records, run.sink);
  }
  for (const std::string& number : bad.legacy) {
    EXPECT_TRUE(run.reports(number)) << number << " is missing in\n" << run.messages();
  }
}

// Other numbers than the old system's, with the same meaning: b12 finds the tool on its drive
// surface (40) where it went on with a warning; b13 misses the cutter at the first motion of any
// kind (312) and not only at a startup (311).
INSTANTIATE_TEST_SUITE_P(
    Programs,
    OracleBad,
    testing::Values(Bad{"b01_undefined_symbol", {"101"}},
                    Bad{"b02_name_too_long", {"1"}, false, frontend::Dialect::apt360},
                    Bad{"b03_paren", {"10"}},
                    Bad{"b04_redefined", {"1002"}},
                    Bad{"b05_parallel_intof", {"1005"}},
                    Bad{"b06_no_intersection", {"1005"}},
                    Bad{"b07_bad_number", {"20"}},
                    Bad{"b08_arg_count", {"1000"}},
                    Bad{"b09_vocab_as_name", {"7"}},
                    Bad{"b10_arith", {"63", "67"}},
                    Bad{"b11_no_tanto", {"721"}, true},
                    Bad{"b12_no_from", {"40"}, true},
                    Bad{"b13_no_cutter", {"312"}, true},
                    Bad{"b14_no_fini", {"23"}},
                    Bad{"b15_jumpto", {"407"}, false, frontend::Dialect::apt360},
                    Bad{"b16_macro_args", {"230", "233"}},
                    Bad{"b17_subscript", {"104", "108"}},
                    Bad{"b18_cs_behind", {"724"}, true},
                    Bad{"b19_numpts", {"803"}, true},
                    Bad{"b20_unknown_word", {"82"}},
                    Bad{"b21_dup_label", {"6"}},
                    Bad{"b22_wrong_ds", {"503"}, true}),
    [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace arelem
