#include <gmock/gmock.h>

#include "tests/unit/runtime/define/forms.h"

namespace arelem::define::test {
namespace {

TEST(Gun, AnOptionStandsOnce) {
  const Failure twice =
      refused(T::gun, {W::CONE, 20.0, W::STNDOF, 200.0, W::SPEED, 1.0, W::SPEED, 2.0});
  EXPECT_EQ(twice.message, "GUN/CONE has SPEED twice: each option stands once");
}

TEST(Gun, LeadTimesAreSeconds) {
  EXPECT_EQ(defined(T::gun, {W::ELLIPS, 1.0, 1.0, W::LEAD, 0.0, 10.0}).canon[9], 10.0);
  for (const auto& [on, off] : {std::pair(-0.1, 0.0), std::pair(0.0, 10.5)}) {
    EXPECT_THAT(refused(T::gun, {W::ELLIPS, 1.0, 1.0, W::LEAD, on, off}).message,
                testing::HasSubstr("it must be from 0 to 10 s"));
  }
}

TEST(Gun, ATableHasALimit) {
  P parameters = {W::TABLE};
  for (int i = 0; i <= 20000; ++i) {
    parameters.emplace_back(static_cast<double>(i));
    parameters.emplace_back(1.0);
  }
  EXPECT_THAT(refused(T::gun, parameters).message,
              testing::HasSubstr("20001 points; it needs at most 20000"));
}

}  // namespace
}  // namespace arelem::define::test
