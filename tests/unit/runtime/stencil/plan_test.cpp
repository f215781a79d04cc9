#include "runtime/stencil/plan.h"

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace arelem::stencil {
namespace {

using testing::HasSubstr;

const Alphabet& roadway() {
  static const Alphabet alphabet = [] {
    std::ifstream in(ARELEM_SOURCE_DIR "/stdlib/roadway.alphabet");
    std::stringstream text;
    text << in.rdbuf();
    return *readAlphabet(text.str(), "roadway.alphabet");
  }();
  return alphabet;
}

std::vector<stencil::Run> runs(const std::string& text,
                               double height = 2500.0,
                               double angle = 0.0) {
  auto made = runsOf(text, roadway(), {Vec2::Zero(), height, angle, std::nullopt}, {}, {});
  EXPECT_TRUE(made.ok());
  return *std::move(made);
}

Job job(TiltRule tilt = TiltRule::off) {
  Job made;
  made.tilt = tilt;
  made.speedTimesWidth = 60000.0;
  return made;
}

TEST(Message, SymbolsStandSideBySide) {
  // A grid unit is 100: an I is 100 wide, the gap 100, a blank 400.
  const auto made = runs("I I");
  ASSERT_EQ(made.size(), 2U);
  EXPECT_NEAR(made[0].lines[0].first.x(), 0.0, 1e-9);
  EXPECT_NEAR(made[1].lines[0].first.x(), 100 + 100 + 400 + 100, 1e-9);
  const auto spaced = runsOf("II", roadway(), {Vec2(5, 7), 2500, 90, 30.0}, {}, {});
  // Written upwards: the second I is 130 further along y, its height runs to -x.
  EXPECT_NEAR(((*spaced)[1].lines[0].first - Vec2(5, 7 + 130)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(((*spaced)[1].lines[1].first - Vec2(5 - 2500, 7 + 130)).norm(), 0.0, 1e-9);
}

TEST(Message, WhatCannotBePaintedIsNamed) {
  const auto failure = [](const std::string& text, Limits limits = {}) {
    auto made = runsOf(text, roadway(), {Vec2::Zero(), 100, 0, std::nullopt}, {}, limits);
    EXPECT_FALSE(made.ok());
    return made.ok() ? Failure{} : made.takeFailure();
  };
  EXPECT_THAT(failure("AB?").message, HasSubstr("character 3 of the text, `?`"));
  EXPECT_THAT(failure("AB?").message, HasSubstr("A B C D"));
  EXPECT_THAT(failure("<BACK>").message, HasSubstr("`<BACK>`"));
  const Failure small = failure("ABc");
  EXPECT_THAT(small.message, HasSubstr("character 3 of the text, `c`"));
  EXPECT_THAT(small.help, HasSubstr("`C` is there"));
  EXPECT_EQ(failure("   ").row->code, "E0563");
  Limits few;
  few.points = 10;
  EXPECT_EQ(failure("SSS", few).row->code, "E0564");
}

TEST(Plan, StraightStrokeHasSpeedAndHeightOfItsWidth) {
  const auto track = planRun(runs("I")[0], job());
  ASSERT_TRUE(track.ok());
  ASSERT_EQ(track->poses.size(), 2U);
  EXPECT_NEAR(track->poses[0].speed, 600.0, 1e-9);  // 60000 / 100
  EXPECT_NEAR(track->poses[0].height, 50.0 / std::tan(31.75 * std::numbers::pi / 180), 1e-9);
  EXPECT_NEAR(track->poses[0].yaw, 0.0, 1e-12);
}

TEST(Plan, AFasterGunThanThereIsIsRefusedWithTheFactor) {
  Job slow = job();
  slow.gun.speed = 450.0;
  const auto refusal = [&](double most) {
    const auto track = planRun(runs("I")[0], slow);
    EXPECT_TRUE(track.ok());
    return objectionToSpeeds({&*track, 1}, slow, [&] { return most; });
  };
  auto failure = refusal(1.0);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->row->code, "E0562");
  EXPECT_THAT(failure->message, HasSubstr("needs 600 mm/s"));
  EXPECT_THAT(failure->message, HasSubstr("0.75 times"));
  EXPECT_THAT(refusal(0.56789)->message, HasSubstr("0.5678 times"));  // not rounded up
  slow.gun.speed = 600.0;
  EXPECT_FALSE(refusal(1.0));
}

TEST(Plan, GunIsSwitchedEarlierByItsLeadTimes) {
  Job leading = job();
  leading.gun.leadOn = 0.05;   // 30 mm at 600 mm/s
  leading.gun.leadOff = 0.02;  // 12 mm
  const auto track = planRun(runs("I")[0], leading);
  ASSERT_TRUE(track.ok());
  ASSERT_EQ(track->poses.size(), 4U);
  EXPECT_EQ(track->on, 0U);
  EXPECT_EQ(track->off, 2U);
  EXPECT_NEAR(track->poses[0].place.y(), -30.0, 1e-9);
  EXPECT_NEAR(track->poses[2].place.y(), 2500.0 - 12.0, 1e-9);
  EXPECT_NEAR(track->poses[3].place.y(), 2500.0, 1e-9);
}

/// An I of 2500 at 600 mm/s takes 4.17 s: the gun would be switched off before it is on.
TEST(Plan, ALeadLongerThanTheStrokeIsRefused) {
  for (const double on : {0.0, 0.1}) {
    Job leading = job();
    leading.gun.leadOn = on;
    leading.gun.leadOff = 5.0;
    auto track = planRun(runs("I")[0], leading);
    ASSERT_FALSE(track.ok());
    EXPECT_EQ(track.failure().row->code, "E0742");
    EXPECT_THAT(track.failure().message, HasSubstr("takes 4.167 s, and LEAD"));
    leading.gun.leadOff = 4.1;
    auto shorter = planRun(runs("I")[0], leading);
    ASSERT_TRUE(shorter.ok());
    EXPECT_LT(shorter->on, shorter->off);
  }
}

TEST(Plan, TiltKeepsItsLimits) {
  for (const TiltRule rule : {TiltRule::trapezoid, TiltRule::quadrilateral, TiltRule::best}) {
    Job tilted = job(rule);
    tilted.limits = {12.0, 40.0};
    double most = 0.0;
    double fastest = 0.0;
    for (const stencil::Run& run : runs("SBDG3")) {
      const auto track = planRun(run, tilted);
      ASSERT_TRUE(track.ok());
      for (std::size_t i = 0; i + 1 < track->poses.size(); ++i) {
        const Pose& a = track->poses[i];
        const Pose& b = track->poses[i + 1];
        most = std::max(most, std::abs(a.tilt));
        const Vec3 way(b.place.x() - a.place.x(), b.place.y() - a.place.y(), b.height - a.height);
        fastest = std::max(fastest, std::abs(b.tilt - a.tilt) * a.speed / way.norm());
      }
    }
    EXPECT_NEAR(most, 12.0, 0.1);
    EXPECT_LE(most, 12.0 + 1e-12);
    EXPECT_GT(fastest, 35.0);
    EXPECT_LE(fastest, 40.0 * 1.001);
  }
}

TEST(Plan, FilmGetsEvenerWithEachRule) {
  const stencil::Run bowl = runs("P")[1];
  double before = 1e9;
  for (const TiltRule rule : {TiltRule::off, TiltRule::trapezoid, TiltRule::quadrilateral}) {
    Job wide = job(rule);
    wide.limits = {45.0, 1e9};
    const auto track = planRun(bowl, wide);
    const Evenness even = evennessOf({&*track, 1}, wide.gun);
    EXPECT_LT(even.mostShare, before);
    before = even.mostShare;
    EXPECT_LE(even.leastShare + even.mostShare, 100.0 + 1e-9);
  }
  // Square cells are even whatever the rule.
  const auto straight = planRun(runs("I")[0], job(TiltRule::best));
  const Evenness even = evennessOf({&*straight, 1}, {});
  EXPECT_NEAR(even.film.worst(), 0.0, 1e-9);
  EXPECT_NEAR(even.area, 100.0 * 2500.0, 1e-6);
  EXPECT_NEAR(even.withinTenPercent, 1.0, 1e-9);
}

TEST(Plan, ShorterOrdersPaintTheSame) {
  std::vector<stencil::Run> given = runs("SCHOOL XING");
  std::vector<stencil::Run> ordered = given;
  shorten(ordered, Vec2::Zero());
  EXPECT_LT(travelOf(ordered, Vec2::Zero()), travelOf(given, Vec2::Zero()));
  EXPECT_EQ(ordered.size(), given.size());
  const auto area = [](const std::vector<stencil::Run>& all) {
    double sum = 0.0;
    for (const stencil::Run& run : all) {
      for (std::size_t i = 0; i + 1 < run.lines.size(); ++i) {
        sum += areaOf(run.lines[i], run.lines[i + 1]);
      }
    }
    return sum;
  };
  EXPECT_NEAR(area(ordered), area(given), 1e-6 * area(given));
}

TEST(Cell, PaintOfATiltedFan) {
  EXPECT_NEAR(paintUpTo(0.0, 63.5, 10.0), 0.0, 1e-12);
  EXPECT_NEAR(paintUpTo(1.0, 63.5, 10.0), 1.0, 1e-12);
  EXPECT_NEAR(paintUpTo(0.3, 63.5, 0.0), 0.3, 1e-12);
  // Half the paint lies on either side of the fan's middle.
  EXPECT_NEAR(paintUpTo(shareOf(10.0, 63.5), 63.5, 10.0), 0.5, 1e-12);
}

/// Moving lines leaves the strokes as they are.
TEST(Plan, LeaningKeepsTheStrokes) {
  const Alphabet alphabet = roadway();
  Placement placement;
  placement.height = 25.0;
  Writing leaning;
  leaning.leaning = true;
  for (const Symbol& symbol : alphabet.symbols) {
    const auto equal = runsOf(symbol.name, alphabet, placement, {}, Limits{});
    const auto moved = runsOf(symbol.name, alphabet, placement, leaning, Limits{});
    ASSERT_EQ(equal->size(), moved->size()) << symbol.name;
    for (std::size_t i = 0; i < equal->size(); ++i) {
      const std::vector<Line>& a = (*equal)[i].lines;
      const std::vector<Line>& b = (*moved)[i].lines;
      ASSERT_EQ(a.size(), b.size()) << symbol.name;
      EXPECT_LT((middleOf(a.front()) - middleOf(b.front())).norm(), 1e-9) << symbol.name;
      EXPECT_LT((middleOf(a.back()) - middleOf(b.back())).norm(), 1e-9) << symbol.name;
      double areaA = 0.0;
      double areaB = 0.0;
      for (std::size_t k = 0; k + 1 < a.size(); ++k) {
        areaA += areaOf(a[k], a[k + 1]);
        areaB += areaOf(b[k], b[k + 1]);
      }
      // Chords between other points of the same curves.
      EXPECT_NEAR(areaA, areaB, 2e-3 * areaA) << symbol.name << " " << i;
    }
  }
}

}  // namespace
}  // namespace arelem::stencil
