#include "app/stencil_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <ostream>

#include <nlohmann/json.hpp>

#include "ir/space/stencil_tolerance.h"
#include "runtime/stencil/overlap.h"

namespace arelem::app {

namespace {
using stencil::Evenness;
using stencil::Painted;
using stencil::Track;

constexpr double meters = 1e-3;

std::string_view ruleName(stencil::TiltRule rule) {
  switch (rule) {
    case stencil::TiltRule::trapezoid:
      return "TRAPZ";
    case stencil::TiltRule::quadrilateral:
      return "QUADR";
    case stencil::TiltRule::best:
      return "BEST";
    case stencil::TiltRule::off:
      break;
  }
  return "OFF";
}

/// Sums and extremes over all tracks.
struct Totals {
  std::size_t poses = 0;
  double way = 0.0;      ///< sprayed, mm
  double seconds = 0.0;  ///< spraying
  double slowest = 0.0, fastest = 0.0;
  double leastTilt = 0.0, mostTilt = 0.0;
  double tiltRate = 0.0;  ///< degrees a second
  double lowest = 0.0, highest = 0.0;
};

Totals totalsOf(const Painted& painted) {
  Totals t;
  bool any = false;
  for (const Track& track : painted.tracks) {
    t.poses += track.poses.size();
    for (std::size_t i = 0; i < track.poses.size(); ++i) {
      const stencil::Pose& pose = track.poses[i];
      t.leastTilt = std::min(t.leastTilt, pose.tilt);
      t.mostTilt = std::max(t.mostTilt, pose.tilt);
      t.lowest = any ? std::min(t.lowest, pose.height) : pose.height;
      t.highest = std::max(t.highest, pose.height);
      t.slowest = any ? std::min(t.slowest, pose.speed) : pose.speed;
      t.fastest = std::max(t.fastest, pose.speed);
      any = true;
      if (i + 1 < track.poses.size()) {
        const stencil::Pose& next = track.poses[i + 1];
        const double way = std::hypot((next.place - pose.place).norm(), next.height - pose.height);
        t.way += way;
        t.seconds += way / pose.speed;
        t.tiltRate = std::max(t.tiltRate, std::abs(next.tilt - pose.tilt) * pose.speed / way);
      }
    }
  }
  return t;
}

/// The tracks of one symbol of the text.
struct Letter {
  std::string name;
  Evenness even;
  double twice = 0.0;                          ///< area that is painted more than once, mm2
  stencil::Vec2 size = stencil::Vec2::Zero();  ///< of the box around its lines, mm
  double narrowest = 0.0, widest = 0.0;        ///< of its lines, mm
};

/// Size and lines of a letter by its tracks.
void measure(Letter& letter, const std::vector<Track>& tracks) {
  constexpr double none = std::numeric_limits<double>::max();
  stencil::Vec2 low = stencil::Vec2::Constant(none);
  stencil::Vec2 high = -low;
  letter.narrowest = none;
  for (const Track& track : tracks) {
    for (std::size_t i = track.first; i < track.poses.size(); ++i) {
      const stencil::Line& line = track.poses[i].line;
      low = low.cwiseMin(line.first).cwiseMin(line.second);
      high = high.cwiseMax(line.first).cwiseMax(line.second);
      letter.narrowest = std::min(letter.narrowest, stencil::widthOf(line));
      letter.widest = std::max(letter.widest, stencil::widthOf(line));
    }
  }
  letter.size = high - low;
}
std::vector<Letter> lettersOf(const Painted& painted) {
  std::map<std::size_t, std::vector<Track>> byPosition;
  for (const Track& track : painted.tracks) {
    byPosition[track.position].push_back(track);
  }
  std::vector<Letter> letters;
  for (const auto& [position, tracks] : byPosition) {
    letters.push_back({tracks.front().symbol,
                       stencil::evennessOf(tracks, painted.statement.job.gun),
                       stencil::overlapOf(tracks)});
    measure(letters.back(), tracks);
  }
  return letters;
}

Letter allOf(const Painted& painted) {
  return {"all", stencil::evennessOf(painted.tracks, painted.statement.job.gun),
          stencil::overlapOf(painted.tracks)};
}

/// In which the areas of a text are told.
struct AreaUnit {
  std::string_view name;
  double squareMillimeters;
};
AreaUnit areaUnitOf(double area) {
  constexpr std::array<AreaUnit, 3> units = {{{"m2", 1e6}, {"cm2", 1e2}, {"mm2", 1.0}}};
  constexpr double least = 0.1;
  const auto fits = std::find_if(units.begin(), units.end(), [&](const AreaUnit& unit) {
    return area >= least * unit.squareMillimeters;
  });
  return fits == units.end() ? units.back() : *fits;
}

/// Four digits, as they are read best: 0.0123, 12.34, 1234.
std::string fourDigits(double value) {
  return value < tolerance::printedNothing ? "0" : fmt::format("{:.4g}", value);
}

void printLetter(std::ostream& out, const Letter& letter, const AreaUnit& unit) {
  constexpr double percent = 100.0;
  const Evenness& even = letter.even;
  out << fmt::format("  {:<9}{:>6}{:>10}{:>10}{:>9.1f} to {:<5.1f}{:>8.3f} to {:<6.3f}{:>8.1f} %\n",
                     letter.name, even.cells, fourDigits(even.area / unit.squareMillimeters),
                     fourDigits(letter.twice / unit.squareMillimeters), even.leastShare,
                     even.mostShare, even.film.least, even.film.most,
                     percent * even.withinTenPercent);
}

std::size_t lineOf(const Compilation& job, const Painted& painted) {
  return job.sources.locate(painted.origin.buffer, painted.origin.begin).line;
}

nlohmann::ordered_json jsonOf(const Letter& letter) {
  const Evenness& even = letter.even;
  return {{"cells", even.cells},
          {"area", even.area},
          {"paintedTwice", letter.twice},
          {"shares", {even.leastShare, even.mostShare}},
          {"film", {even.film.least, even.film.most}},
          {"within10", even.withinTenPercent}};
}
}  // namespace

void printStencil(std::ostream& out, const Compilation& job, const Painted& painted) {
  const stencil::Statement& s = painted.statement;
  const Totals t = totalsOf(painted);
  out << fmt::format("line {}: STENCL '{}', height {:.6g} mm, fan {:.6g} degrees, TILT {}{}\n",
                     lineOf(job, painted), s.text, s.placement.height, s.job.gun.fan,
                     ruleName(s.job.tilt), s.job.asSource ? ", COMPAT" : "");
  out << fmt::format(
      "  {} runs, {} poses; sprayed way {:.4g} m in {:.4g} s; travels {:.4g} m, {:.4g} m "
      "in the order of the alphabet\n",
      painted.tracks.size(), t.poses, t.way * meters, t.seconds, painted.traveled * meters,
      painted.given * meters);
  out << fmt::format(
      "  speed {:.4g} to {:.4g} mm/s, {:.4g} over a grid unit; nozzle {:.4g} to {:.4g} mm high; "
      "tilt {:.3g} to {:.3g} degrees, {:.3g} a second\n",
      t.slowest, t.fastest, s.speed, t.lowest, t.highest, t.leastTilt, t.mostTilt, t.tiltRate);
  if (const double film = painted.meanFilm(); film > 0.0) {
    constexpr double micrometers = 1e3;
    out << fmt::format("  mean film {:.4g} um\n", film * micrometers);
  }
  const Letter all = allOf(painted);
  const AreaUnit unit = areaUnitOf(all.even.area);
  out << fmt::format(
      "  symbol    cells{:>10}     twice  shares of cells, %   film over the mean  within 10 %\n",
      fmt::format("area, {}", unit.name));
  for (const Letter& letter : lettersOf(painted)) {
    printLetter(out, letter, unit);
  }
  printLetter(out, all, unit);
}

void printStencilsJson(std::ostream& out, const Compilation& job) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const auto& painted : job.evaluation.stencils) {
    const stencil::Statement& s = painted->statement;
    const Totals t = totalsOf(*painted);
    nlohmann::ordered_json one = {{"line", lineOf(job, *painted)},
                                  {"text", s.text},
                                  {"height", s.placement.height},
                                  {"fan", s.job.gun.fan},
                                  {"tiltRule", ruleName(s.job.tilt)},
                                  {"runs", painted->tracks.size()},
                                  {"poses", t.poses},
                                  {"sprayedWay", t.way},
                                  {"sprayingTime", t.seconds},
                                  {"travel", painted->traveled},
                                  {"travelGiven", painted->given},
                                  {"speed", {t.slowest, t.fastest}},
                                  {"speedOfGridUnit", s.speed},
                                  {"nozzleHeight", {t.lowest, t.highest}},
                                  {"tilt", {t.leastTilt, t.mostTilt}},
                                  {"tiltRate", t.tiltRate},
                                  {"meanFilm", painted->meanFilm()},
                                  {"all", jsonOf(allOf(*painted))}};
    for (const Letter& letter : lettersOf(*painted)) {
      nlohmann::ordered_json row = {{"symbol", letter.name},
                                    {"size", {letter.size.x(), letter.size.y()}},
                                    {"lines", {letter.narrowest, letter.widest}}};
      row.update(jsonOf(letter));
      one["symbols"].push_back(std::move(row));
    }
    all.push_back(std::move(one));
  }
  out << all.dump(1) << '\n';
}

}  // namespace arelem::app
