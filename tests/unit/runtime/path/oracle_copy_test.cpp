#include <cstdlib>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "runtime/path/affine.h"
#include "runtime/path/transform.h"
#include "tests/unit/backend/oracle_records.h"

// The records of the old system's Section 3, compared with ours. The input is rebuilt from its
// output: copies are cut out and the effect of TRACUT on the originals is undone.
namespace arelem::path {
namespace {

using Records = std::vector<cl::Record>;

const cl::Post* post(const cl::Record& record, Word word) {
  const auto* p = std::get_if<cl::Post>(&record.body);
  return p != nullptr && p->word == word ? p : nullptr;
}

/// INDEX/i without NOMORE: the number, else 0.
double opened(const cl::Record& record) {
  const cl::Post* p = post(record, Word::INDEX);
  return p != nullptr && p->arguments.size() == 1 ? std::get<double>(p->arguments[0]) : 0.0;
}

Records withoutCards(const Records& records) {
  Records result;
  for (const cl::Record& record : records) {
    if (!std::holds_alternative<cl::Card>(record.body)) {
      result.push_back(record);
    }
  }
  return result;
}

Records withoutCopies(const Records& records) {
  Records result;
  std::vector<double> seen;
  bool copies = false;
  for (const cl::Record& record : records) {
    const double index = opened(record);
    if (index != 0.0) {
      copies = copies || std::find(seen.begin(), seen.end(), index) != seen.end();
      seen.push_back(index);
    }
    copies = copies && post(record, Word::COPY) == nullptr;
    if (!copies) {
      result.push_back(record);
    }
  }
  return result;
}

void undoTracut(Records& records) {
  std::optional<Affine> undo;
  for (cl::Record& record : records) {
    if (const cl::Post* p = post(record, Word::TRACUT)) {
      const auto* matrix = std::get_if<cl::SurfaceValue>(&p->arguments[0]);
      undo.reset();
      if (matrix != nullptr) {
        const Affine m = Affine::fromRows(matrix->canon);
        undo = Affine{m.linear.inverse(), -(m.linear.inverse() * m.shift)};
      }
    } else if (undo) {
      move(record, *undo);
    }
  }
}

void expectSame(const cl::Record& got, const cl::Record& want, const std::string& where) {
  ASSERT_EQ(got.body.index(), want.body.index()) << where;
  EXPECT_EQ(cl::typeCode(got.body).sub, cl::typeCode(want.body).sub) << where;
  if (const auto* motion = std::get_if<cl::Motion>(&want.body)) {
    const auto& ours = std::get<cl::Motion>(got.body);
    EXPECT_EQ(ours.name, motion->name) << where;
    ASSERT_EQ(ours.coordinates.size(), motion->coordinates.size()) << where;
    for (std::size_t i = 0; i < motion->coordinates.size(); ++i) {
      EXPECT_NEAR(ours.coordinates[i], motion->coordinates[i], 1e-9) << where << " number " << i;
    }
  }
  if (const auto* post = std::get_if<cl::Post>(&want.body)) {
    EXPECT_EQ(std::get<cl::Post>(got.body).arguments, post->arguments) << where;
  }
}

class OracleCopy : public testing::TestWithParam<std::string> {};

TEST_P(OracleCopy, RepeatsWhatTheOldSystemRepeats) {
  std::filesystem::path file =
      std::filesystem::path(ARELEM_SOURCE_DIR) / "tests/data/oracle/cases" / (GetParam() + ".json");
  if (!std::filesystem::exists(file)) {
    const char* shared = std::getenv("ARELEM_SHARED");
    file = std::filesystem::path(shared != nullptr ? shared : ARELEM_SOURCE_DIR "/../shared") /
           "oracle/examples" / (GetParam() + ".json");
  }
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << "needs the examples of other authors: set ARELEM_SHARED";
  }
  const Records want = withoutCards(test::readOracleCase(file).records);
  Records input = withoutCopies(want);
  undoTracut(input);

  cl::Recording got;
  CollectingSink sink;
  const auto transformer = makeTransformer(got, sink);
  for (const cl::Record& record : input) {
    transformer->accept(record);
  }
  transformer->finish();

  EXPECT_EQ(sink.errors(), 0U);
  EXPECT_LT(input.size(), want.size() + (GetParam() == "e30_tracut_multax" ? 1 : 0));
  ASSERT_EQ(got.records.size(), want.size());
  for (std::size_t i = 0; i < want.size(); ++i) {
    expectSame(got.records[i], want[i], "record " + std::to_string(i));
  }
}

INSTANTIATE_TEST_SUITE_P(Programs,
                         OracleCopy,
                         testing::Values("e04_copy_xyrot",
                                         "e05_copy_transl",
                                         "e23_transl_tracut_copy",
                                         "e30_tracut_multax",
                                         "square",
                                         "slotarray",
                                         "race_4th",
                                         "hrw1111ps"),
                         [](const auto& parameter) { return parameter.param; });

}  // namespace
}  // namespace arelem::path
