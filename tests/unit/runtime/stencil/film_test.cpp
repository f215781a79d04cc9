#include "runtime/stencil/film.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/stencil/overlap.h"
#include "runtime/stencil/stencil.h"
#include "tests/unit/runtime/stencil/alphabets.h"

namespace arelem::stencil {
namespace {

Statement statementOf(const std::string& text, TiltRule rule) {
  Statement s;
  s.text = text;
  s.placement.height = 2500.0;  // a grid unit of 100 mm
  s.speed = 600.0;
  s.job.gun.fan = 63.5;
  s.job.tilt = rule;
  return s;
}
Painted painted(const Statement& s, const Alphabet& alphabet) {
  auto result = paint(s, alphabet, Limits{}, Vec2::Zero());
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.failure().message);
  return *std::move(result);
}

/// The optimised tilt and division are never worse than a rule of the source, for every symbol.
TEST(Film, BestIsTheEvenest) {
  const Alphabet alphabet = roadway();
  for (const Symbol& symbol : alphabet.symbols) {
    const auto departure = [&](TiltRule rule) {
      const Painted p = painted(statementOf(symbol.name, rule), alphabet);
      return evennessOf(p.tracks, p.statement.job.gun).film.worst();
    };
    const double best = departure(TiltRule::best);
    constexpr double grid = 0.005;  // tilts are looked for in a grid
    EXPECT_LE(best, departure(TiltRule::off) + grid) << symbol.name;
    EXPECT_LE(best, departure(TiltRule::trapezoid) + grid) << symbol.name;
    EXPECT_LE(best, departure(TiltRule::quadrilateral) + grid) << symbol.name;
    // What is reached: docs/manual/stencil.md. The rings of the 8 are the tightest.
    EXPECT_LT(best, symbol.name == "8" ? 0.1 : 0.065) << symbol.name;
  }
}

/// Both limits are reached, and not passed.
TEST(Film, TiltsKeepTheirLimits) {
  const Alphabet alphabet = roadway();
  for (const TiltRule rule : {TiltRule::trapezoid, TiltRule::quadrilateral, TiltRule::best}) {
    Statement s = statementOf("SB8K", rule);
    s.job.limits = {12.0, 10.0};
    double most = 0.0;
    double fastest = 0.0;
    for (const Track& track : painted(s, alphabet).tracks) {
      for (std::size_t i = 0; i < track.poses.size(); ++i) {
        most = std::max(most, std::abs(track.poses[i].tilt));
        if (i > 0) {
          const Pose& a = track.poses[i - 1];
          const Pose& b = track.poses[i];
          const double way = std::hypot((b.place - a.place).norm(), b.height - a.height);
          fastest = std::max(fastest, std::abs(b.tilt - a.tilt) * a.speed / way);
        }
      }
    }
    EXPECT_NEAR(most, 12.0, 0.1);
    EXPECT_LE(most, 12.0 + 1e-9);
    EXPECT_GT(fastest, 9.0);
    EXPECT_LE(fastest, 10.0 * 1.001);
  }
}

/// A straight stroke has the same film everywhere; a second one over it doubles that.
TEST(Film, StrokesAddUp) {
  const Alphabet alphabet = alphabetOf(
      "GRID 4 25\nSYMBOL +\nSTROKE 5 1,0 2,0 TO 1,20 2,20\nSTROKE 5 0,10 0,12 TO 4,10 4,12\n");
  const Painted p = painted(statementOf("+", TiltRule::off), alphabet);
  const film::Map map = filmMap(filmPatches(p.tracks, p.statement.job.gun), 10.0, 0.5);
  // 400 mm by 2000 mm in cells of 10 mm.
  std::size_t once = 0, twice = 0;
  for (std::size_t i = 0; i < map.film.size(); ++i) {
    if (map.onWork[i]) {
      const bool both = map.film[i] > 0.75;
      (both ? twice : once) += 1;
      EXPECT_NEAR(map.film[i], both ? 1.0 : 0.5, 2e-3);
    }
  }
  EXPECT_NEAR(overlapOf(p.tracks), 100.0 * 200.0, 1e-6);
  EXPECT_EQ(twice, 200U);  // 100 mm by 200 mm
  EXPECT_EQ(once, 2000U + 800U - 2U * 200U);
}

/// Only B, 3, 8 and Q have strokes that cover each other (docs/manual/roadway_alphabet.md); what a
/// symbol covers and covers twice adds up to its cells.
TEST(Film, StrokesCoverEachOtherInFewSymbols) {
  const Alphabet alphabet = roadway();
  std::set<std::string> twice;
  for (const Symbol& symbol : alphabet.symbols) {
    const Painted p = painted(statementOf(symbol.name, TiltRule::off), alphabet);
    const double overlap = overlapOf(p.tracks);
    EXPECT_GE(overlap, -1e-6);
    if (overlap > 1.0) {  // mm2 of letters 2.5 m tall
      twice.insert(symbol.name);
    }
    const film::Map map = filmMap(filmPatches(p.tracks, p.statement.job.gun), 4.0, 1.0);
    double cells = 0.0;
    for (const PaintedCell& cell : cellsOf(p.tracks, p.statement.job.gun)) {
      cells += cell.area;
    }
    EXPECT_NEAR(map.statistics.area, cells - overlap, 0.01 * cells) << symbol.name;
  }
  EXPECT_EQ(twice, (std::set<std::string>{"3", "8", "B", "Q"}));
}

/// The cells of a bowl cover its area, and the film's integral is the paint.
TEST(Film, MapHoldsThePaint) {
  const Alphabet alphabet = roadway();
  const Painted p = painted(statementOf("O", TiltRule::quadrilateral), alphabet);
  const auto cells = cellsOf(p.tracks, p.statement.job.gun);
  double area = 0.0;
  for (const PaintedCell& cell : cells) {
    area += cell.area;
  }
  const film::Map map = filmMap(filmPatches(p.tracks, p.statement.job.gun), 2.0, 1.0);
  double painted = 0.0;
  for (const double film : map.film) {
    painted += film * map.cell * map.cell;
  }
  EXPECT_NEAR(map.statistics.area, area, 0.005 * area);
  EXPECT_NEAR(painted, area, 0.005 * area);
}

/// Film and speed: 2 l/min, 90 % of it on the road, over lines 100 mm wide at 500 mm/s are
/// 30000 mm3/s over 50000 mm2/s.
TEST(Film, FollowsFromTheFlow) {
  const Alphabet alphabet = alphabetOf("GRID 4 25\nSYMBOL I\nSTROKE 5 0,0 1,0 TO 0,25 1,25\n");
  Statement s = statementOf("I", TiltRule::off);
  s.job.gun.flow = 2e6 / 60.0;
  s.job.gun.efficiency = 0.9;
  s.speed = 500.0;
  EXPECT_NEAR(painted(s, alphabet).meanFilm(), 0.6, 1e-12);
  s.speed = 0.0;
  s.film = 0.3;
  EXPECT_NEAR(painted(s, alphabet).statement.speed, 1000.0, 1e-9);
  // Neither: as fast as the gun goes.
  s.film = 0.0;
  s.job.gun.speed = 700.0;
  const Painted fastest = painted(s, alphabet);
  EXPECT_NEAR(fastest.tracks[0].poses[0].speed, 700.0, 1.0);
  EXPECT_LE(fastest.tracks[0].poses[0].speed, 700.0);
}

}  // namespace
}  // namespace arelem::stencil
