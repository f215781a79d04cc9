#include "runtime/tool/profile_check.h"

#include <vector>

#include <gtest/gtest.h>

namespace arelem::tool {
namespace {

std::string_view faultOf(const std::vector<double>& values) {
  const auto profile = makeProfile(values);
  if (!profile) {
    return profile.failure().row->code;
  }
  const auto bad = shapeFault(*profile);
  return bad ? bad->row->code : std::string_view("");
}

TEST(ProfileCheck, ToolsThatJoin) {
  for (const std::vector<double>& values :
       std::vector<std::vector<double>>{{0.75},
                                        {0.75, 0.375},
                                        {12.5, 6.25},
                                        {0},
                                        {0.75, 0.125, 0.266342, 0.125, 0, 8, 3},
                                        {1.5, 0.125, 0.649869, 0.241517, 10, 15, 3.5},
                                        {10, 0, 5, 3.004303, 31, 0, 130},
                                        {2, 0, 0, 0, 0, 0, 5},
                                        {10, 0, 0, 0, 31, 0, 130},
                                        {0.5, 0.25, 0, 0, 0, 0, 0.25}}) {
    EXPECT_EQ(faultOf(values), "") << values[0] << " with " << values.size();
  }
}

// Each with the one thing wrong that its old number names.
TEST(ProfileCheck, EachFaultHasItsCode) {
  const std::vector<std::pair<std::string_view, std::vector<double>>> cases = {
      {"E0526", {-1}},                              // 401
      {"E0527", {2, 0, 1, 0, 0, 0, -1}},            // 402
      {"E0528", {2, 0, 1, 1, 45, 45, 5}},           // 403
      {"E0529", {2, 0, 1, 0, -1, 0, 5}},            // 404
      {"E0530", {10, 0, 5, 5, 45, 0, 4.9}},         // 405
      {"E0531", {2, 0, 1, 0, 0, -1, 5}},            // 406
      {"E0532", {2, -0.1}},                         // 407
      {"E0533", {2, 0.25, 1.1, 0.25, 0, 0, 5}},     // 408
      {"E0534", {2, 0.25, 0.75, 0.24, 0, 0, 5}},    // 409
      {"E0535", {2, 0.25, 0.75, 0.26, 0, 0, 5}},    // 410
      {"E0536", {2, 0.25, 0.74, 0.25, 0, 0, 5}},    // 411
      {"E0537", {2, 0.25, 0.76, 0.25, 0, 0, 5}},    // 412
      {"E0538", {2, 0.25, 0.75, 0.25, 0, 0, 0.2}},  // 413
      {"E0538", {2, 0.25, 0.75, 0.2501, 0, 0, 0.2}},
      {"W0503", {2, 0.25, 0.75, 0.2501, 0, 0, 5}},  // 415
      {"W0504", {2, 0.25, 0.7501, 0.25, 0, 0, 5}},  // 416
      {"E0539", {2, 1.1}},                          // 417
  };
  for (const auto& [code, values] : cases) {
    EXPECT_EQ(faultOf(values), code);
  }
}

// e = f = 0: the center is its radius from both lines, and the cutter has no fault.
TEST(ProfileCheck, ACornerFollowsFromTheOtherValues) {
  for (const std::vector<double>& values : std::vector<std::vector<double>>{
           {20, 3, 0, 0, 10, 15, 40}, {20, 3, 0, 0, 30, 0, 40}, {20, 3, 0, 0, 0, 15, 40}}) {
    EXPECT_EQ(faultOf(values), "");
    const Profile cutter = *makeProfile(values);
    const double rim = 10 * cutter.sinAlpha / cutter.cosAlpha;
    EXPECT_NEAR(cutter.f * cutter.cosAlpha - cutter.e * cutter.sinAlpha, 3, 1e-12);
    EXPECT_NEAR((10 - cutter.e) * cutter.cosBeta + (cutter.f - rim) * cutter.sinBeta, 3, 1e-12);
  }
  EXPECT_EQ(faultOf({2, 1.3, 0, 0, 0, 10, 5}), "E0539");  // no room for it
}

// Rounded decimals are made exact: the corner's center is its radius from both lines.
TEST(ProfileCheck, RoundedValuesAreJoined) {
  for (const std::vector<double>& values :
       std::vector<std::vector<double>>{{0.75, 0.125, 0.266342, 0.125, 0, 8, 3},
                                        {0.8, 0.1, 0.3131, 0.1, 0, 8, 4},
                                        {1.5, 0.125, 0.649869, 0.241517, 10, 15, 3.5},
                                        {10, 0, 5, 3.0043, 31, 0, 130}}) {
    const Profile cutter = joined(*makeProfile(values));
    const double bottom = cutter.f * cutter.cosAlpha - cutter.e * cutter.sinAlpha;
    const double rim = cutter.d / 2 * cutter.sinAlpha / cutter.cosAlpha;
    const double side =
        (cutter.d / 2 - cutter.e) * cutter.cosBeta + (cutter.f - rim) * cutter.sinBeta;
    EXPECT_NEAR(bottom, cutter.r, 1e-15 * values[0] + 1e-15);
    EXPECT_NEAR(side, cutter.r, 1e-15 * values[0] + 1e-15);
    EXPECT_NEAR(cutter.e, values[2], 1e-3);
    EXPECT_EQ(cutter.d, values[0]);
  }
  // What does not touch stays as it is written: shapeFault refuses it.
  EXPECT_EQ(joined(*makeProfile(std::vector<double>{2, 0.25, 0.7, 0.25, 0, 0, 5})).e, 0.7);
}

}  // namespace
}  // namespace arelem::tool
