// [control], [turning] and [time] of a machine file.
#include <algorithm>

#include "backend/robot/machine_table.h"

namespace arelem::robot {

namespace {

constexpr double farthest = 99999.0;  // degrees
/// Characters of the longest line of motion that an output has.
constexpr int leastLine = 128;

void control(Table& t, backend::ngc::Control& c) {
  std::size_t units = c.inches ? 1 : 0;
  t.choice("units", units, {"mm", "inch"});
  c.inches = units == 1;
  c.decimals = c.inches ? 5 : 4;
  t.whole("decimals", c.decimals, 1, 8);
  t.whole("angle_decimals", c.angleDecimals, 1, 8);
  t.number("blend", c.blend, 0.0, longestLength);
  t.number("arc_tolerance", c.arcTolerance, 0.0, longestLength);
  t.flag("arcs", c.arcs);
  t.flag("cycles", c.cycles);
  t.flag("tool_length", c.toolLength);
  t.flag("line_numbers", c.lineNumbers);
  std::size_t offset = 1;
  t.choice("offset", offset, {"", "G54", "G55", "G56", "G57", "G58", "G59"});
  c.offset = offset == 0 ? "" : "G5" + std::to_string(offset + 3);
  std::size_t end = 0;
  t.choice("end", end, {"M2", "M30"});
  c.end = end == 0 ? "M2" : "M30";
  int limit = static_cast<int>(c.lineLimit);
  t.whole("line_limit", limit, leastLine, 255);
  c.lineLimit = static_cast<std::size_t>(limit);
}

Vec3 directionOf(char letter) {
  return letter == 'A'   ? Vec3(Vec3::UnitX())
         : letter == 'B' ? Vec3(Vec3::UnitY())
                         : Vec3(Vec3::UnitZ());
}

void axis(Table& t, TurningAxis& one) {
  std::array<double, 3> values{one.direction.x(), one.direction.y(), one.direction.z()};
  t.list("direction", values, -1.0, 1.0);
  one.direction = {values[0], values[1], values[2]};
  if (!(one.direction.norm() > 0.1)) {
    t.wrong("direction", "a direction of a length above 0.1");
    one.direction = directionOf(one.letter);
  }
  one.direction.normalize();
  values = {};
  t.list("point", values, -longestLength, longestLength);
  one.point = {values[0], values[1], values[2]};
  Range range{one.low, one.high};
  t.range("range", range, -farthest, farthest);
  one.low = range.low;
  one.high = range.high;
}

bool isPair(const std::vector<std::string>& letters) {
  return letters.size() == 2 && letters[0] != letters[1] &&
         std::all_of(letters.begin(), letters.end(), [](const std::string& letter) {
           return letter == "A" || letter == "B" || letter == "C";
         });
}

void turning(Table& t, Turning& turning) {
  std::size_t kind = 3;
  t.choice("kinematics", kind, {"table-table", "head-head", "head-table"});
  if (kind == 3 && !t.has("kinematics")) {
    t.wrong("kinematics", R"(there: "table-table", "head-head" or "head-table")");
  }
  turning.kind = static_cast<Turning::Kind>(kind % 3);
  std::vector<std::string> letters;
  t.texts("axes", letters);
  if (!isPair(letters)) {
    t.wrong("axes", R"(two different letters of "A", "B", "C", such as ["A", "C"])");
    return;
  }
  t.flag("tool_point", turning.toolPoint);
  t.number("tolerance", turning.tolerance, 1e-6, longestLength);
  t.number("angle_tolerance", turning.angleTolerance, 1e-6, fullTurn);
  for (std::size_t i = 0; i < 2; ++i) {
    TurningAxis& one = turning.axes[i];
    one.letter = letters[i][0];
    one.direction = directionOf(one.letter);
    t.with(letters[i], [&](Table& inner) { axis(inner, one); });
  }
  if (turning.axes[0].direction.cross(turning.axes[1].direction).norm() < 0.1) {
    t.wrong("axes", "two axes of different directions");
  }
}

void time(Table& t, TimeLimits& limits) {
  t.number("velocity", limits.velocity, 1e-3, longestLength);
  t.number("acceleration", limits.acceleration, 1e-3, 1e9);
  t.number("jerk", limits.jerk, 1e-3, 1e12);
  t.number("corner", limits.corner, 0.0, longestLength);
  t.number("tool_change", limits.toolChange, 0.0, 1e6);
}

}  // namespace

void readControl(Table& top, Machine& machine) {
  top.with("control", [&](Table& t) { control(t, machine.control.emplace()); });
  top.with("turning", [&](Table& t) { turning(t, machine.turning.emplace()); });
  top.with("time", [&](Table& t) { time(t, machine.time.emplace()); });
}

}  // namespace arelem::robot
