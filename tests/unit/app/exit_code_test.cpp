#include "app/exit_code.h"

#include <gtest/gtest.h>

namespace arelem::app {
namespace {

ExitCode codeOf(std::string_view code) {
  DiagRow row{};
  row.code = code;
  row.severity = code.front() == 'E' ? Severity::error : Severity::warning;
  return exitCodeFor(row);
}

TEST(ExitCode, FollowsTheRoomOfTheDiagnostic) {
  EXPECT_EQ(codeOf("E0201"), ExitCode::programHasErrors);
  EXPECT_EQ(codeOf("E0401"), ExitCode::programHasErrors);
  EXPECT_EQ(codeOf("E0301"), ExitCode::geometryUnsolvable);
  EXPECT_EQ(codeOf("E0501"), ExitCode::geometryUnsolvable);
  EXPECT_EQ(codeOf("E0601"), ExitCode::outputNotWritten);
  EXPECT_EQ(codeOf("E0701"), ExitCode::inputUnreadable);
  EXPECT_EQ(codeOf("E0801"), ExitCode::limitReached);
  for (const char* limit : {"E0239", "E0358", "E0359", "E0375", "E0393", "E0418", "E0513", "E0525",
                            "E0564", "E0732", "E0891", "E0895"}) {
    EXPECT_EQ(codeOf(limit), ExitCode::limitReached) << limit;
  }
  for (const char* file : {"E0102", "E0650", "E0651", "E0652"}) {
    EXPECT_EQ(codeOf(file), ExitCode::inputUnreadable) << file;
  }
  EXPECT_EQ(codeOf("W0701"), ExitCode::ok);
}

TEST(ExitCode, TheCauseThatMakesTheOthersMootWins) {
  EXPECT_EQ(worse(ExitCode::geometryUnsolvable, ExitCode::limitReached), ExitCode::limitReached);
  EXPECT_EQ(worse(ExitCode::programHasErrors, ExitCode::inputUnreadable),
            ExitCode::inputUnreadable);
  EXPECT_EQ(worse(ExitCode::ok, ExitCode::outputNotWritten), ExitCode::outputNotWritten);
  EXPECT_EQ(worse(ExitCode::geometryUnsolvable, ExitCode::programHasErrors),
            ExitCode::programHasErrors);
  EXPECT_EQ(worse(ExitCode::ok, ExitCode::ok), ExitCode::ok);
}

}  // namespace
}  // namespace arelem::app
