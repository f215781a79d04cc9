#include "app/nearest.h"

#include <vector>

#include <gtest/gtest.h>

namespace arelem::app {
namespace {

const std::vector<std::string> options = {"--dialect", "--define", "--diagnostics", "--include",
                                          "-o"};

TEST(Nearest, FindsOneSlipOfTheFinger) {
  EXPECT_EQ(nearest("--dialct", options), "--dialect");
  EXPECT_EQ(nearest("--dialcet", options), "--dialect");
  EXPECT_EQ(nearest("--includ", options), "--include");
  EXPECT_EQ(nearest("--defime", options), "--define");
}

TEST(Nearest, StaysSilentWhenNothingIsNear) {
  EXPECT_EQ(nearest("--frobnicate", options), "");
  EXPECT_EQ(nearest("", {}), "");
}

}  // namespace
}  // namespace arelem::app
