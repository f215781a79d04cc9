#include "app/manual_pages.h"

#include <map>
#include <string>

#include <gtest/gtest.h>

#include "ir/diag/diagnostic.h"

namespace arelem::app {
namespace {

std::map<std::string_view, std::string_view> pagesByCode() {
  std::map<std::string_view, std::string_view> pages;
  for (const ManualPage& page : manualPages()) {
    EXPECT_TRUE(pages.emplace(page.code, page.text).second) << page.code;
  }
  return pages;
}

TEST(ManualPages, EveryRowHasAPageThatBeginsWithItsCode) {
  const auto pages = pagesByCode();
  for (const DiagRow& row : diagnosticTable()) {
    const auto page = pages.find(row.code);
    ASSERT_NE(page, pages.end()) << "docs/manual/diagnostics/" << row.code << ".md is missing";
    EXPECT_TRUE(page->second.starts_with("# " + std::string(row.code) + ": ")) << row.code;
    EXPECT_GT(page->second.size(), 100U) << row.code << ": tell what it means";
  }
}

TEST(ManualPages, NoPageWithoutARow) {
  for (const ManualPage& page : manualPages()) {
    EXPECT_NE(findDiagnostic(page.code), nullptr) << page.code;
  }
}

}  // namespace
}  // namespace arelem::app
