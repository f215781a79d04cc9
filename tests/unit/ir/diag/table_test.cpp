#include <cctype>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "ir/diag/diagnostic.h"

namespace arelem {
namespace {

TEST(DiagnosticTable, CodesAndNamesAreUnique) {
  std::set<std::string_view> codes;
  std::set<std::string_view> names;
  for (const DiagRow& row : diagnosticTable()) {
    EXPECT_TRUE(codes.insert(row.code).second) << row.code << ' ' << row.name;
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
  }
}

TEST(DiagnosticTable, RowsFollowTheWordingRules) {
  for (const DiagRow& row : diagnosticTable()) {
    ASSERT_EQ(row.code.size(), 5U) << row.code;
    EXPECT_EQ(row.code.front(), row.severity == Severity::error ? 'E' : 'W') << row.code;
    EXPECT_NE(row.text.back(), '.') << row.code;
    const bool begins =
        std::islower(static_cast<unsigned char>(row.text.front())) != 0 ||
        std::string_view("{`/").find(row.text.front()) != std::string_view::npos ||
        (row.text.size() > 1 && std::isupper(static_cast<unsigned char>(row.text[1])) != 0);
    EXPECT_TRUE(begins) << row.code
                        << ": begins in lower case, or with a word of the language: " << row.text;
  }
}

}  // namespace
}  // namespace arelem
