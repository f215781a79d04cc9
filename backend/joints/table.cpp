#include "backend/joints/table.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "backend/joints/slower.h"
#include "ir/diag/robot.h"
#include "ir/diag/told_factor.h"
#include "ir/space/robot_tolerance.h"

namespace arelem::joints {

namespace {
/// The worst of many departures from a limit.
struct Worst {
  double excess = 0.0;
  std::size_t knot = 0;
  std::size_t count = 0;

  void add(double by, std::size_t at) {
    if (by > tolerance::jointLimit) {
      ++count;
      knot = by > excess ? at : knot;
      excess = std::max(excess, by);
    }
  }
};

double radiusOf(const Knot& knot) {
  return std::hypot(knot.point.x(), knot.point.y());
}

bool withinReach(const Arm& arm, const std::vector<Knot>& knots, DiagnosticSink& sink) {
  const robot::Range reach = arm.reach();
  Worst far;
  Worst near;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    far.add(radiusOf(knots[i]) - reach.high, i);
    near.add(reach.low - radiusOf(knots[i]), i);
  }
  for (const Worst* worst : {&far, &near}) {
    if (worst->count > 0) {
      const Knot& knot = knots[worst->knot];
      sink.accept(diagnose(knot.origin, diag::JointsReach, worst->count, knots.size(),
                           knot.location, knot.point.x(), knot.point.y(), radiusOf(knot),
                           worst->excess, worst == &far ? "outside" : "inside",
                           worst == &far ? reach.high : reach.low));
    }
  }
  return far.count + near.count == 0;
}

/// Nearest that the move to knot `i` comes to the axis.
double nearestTo(const std::vector<Knot>& knots, std::size_t i) {
  const Eigen::Vector2d a = knots[i - 1].point.head<2>();
  const Eigen::Vector2d way = knots[i].point.head<2>() - a;
  const double square = way.squaredNorm();
  const double t = square > 0.0 ? std::clamp(-a.dot(way) / square, 0.0, 1.0) : 0.0;
  return (a + t * way).norm();
}

bool clearOfAxis(const Arm& arm, const std::vector<Knot>& knots, DiagnosticSink& sink) {
  constexpr double least = 1.0;  // mm; nearer the turn has no bounded speed
  const double clear = std::max(arm.reach().low, least);
  Worst worst;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    worst.add(clear - nearestTo(knots, i), i);
  }
  if (worst.count > 0) {
    const Knot& knot = knots[worst.knot];
    sink.accept(diagnose(knot.origin, diag::JointsAxis, knot.location, clear - worst.excess, clear,
                         worst.count));
  }
  return worst.count == 0;
}

bool withinTurn(const Arm& arm, const std::vector<Knot>& knots, DiagnosticSink& sink) {
  const robot::Range range = arm.range(1);
  Worst worst;
  double turn = 0.0;
  double worstTurn = 0.0;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    State state;
    state.place.head<3>() = knots[i].point;
    turn = arm.jointsOf(state, turn).place[1];
    const double before = worst.excess;
    worst.add(std::max(turn - range.high, range.low - turn), i);
    worstTurn = worst.excess > before ? turn : worstTurn;
  }
  if (worst.count > 0) {
    const Knot& knot = knots[worst.knot];
    sink.accept(diagnose(knot.origin, diag::JointsTurn, knot.location, worstTurn, range.low,
                         range.high, worst.count));
  }
  return worst.count == 0;
}

/// The fastest move against the largest speed of the tool point.
bool withinSpeed(double most, const std::vector<Knot>& knots, DiagnosticSink& sink) {
  const auto fastest = std::max_element(
      knots.begin(), knots.end(), [](const Knot& a, const Knot& b) { return a.speed < b.speed; });
  if (most <= 0.0 || fastest == knots.end() ||
      fastest->speed <= most * (1.0 + tolerance::jointLimit)) {
    return true;
  }
  sink.accept(diagnose(fastest->origin, diag::RobotSpeed,
                       fmt::format("location {}", fastest->location), fastest->speed, most,
                       diag::toldFactor(most / fastest->speed)));
  return false;
}

/// An arm that goes slower than the program while it sprays.
void warnOfFilm(const Trajectory::Spraying& spraying,
                const std::vector<Knot>& knots,
                DiagnosticSink& sink) {
  constexpr double told = 1.01;
  if (spraying.planned > 0.0 && spraying.open > told * spraying.planned) {
    const Knot& knot = knots[spraying.knot];
    sink.accept(diagnose(knot.origin, diag::JointsFilm, spraying.open, spraying.planned,
                         spraying.open / spraying.planned, knot.location, spraying.worst));
  }
}

/// Largest speeds and accelerations of the joints.
class Peaks {
 public:
  void add(double time, const JointState& joints, const Arm& arm) {
    for (std::size_t j = 0; j < 2; ++j) {
      const robot::Range range = arm.range(j);
      const double beyond = std::max(joints.place[j] - range.high, range.low - joints.place[j]);
      keep(beyond_[j], beyond, time);
      if (!std::isfinite(joints.speed[j]) || !std::isfinite(joints.acceleration[j])) {
        unbounded_ = unbounded_ ? unbounded_ : time;
      }
      keep(speed_[j], std::abs(joints.speed[j]), time);
      keep(acceleration_[j], std::abs(joints.acceleration[j]), time);
    }
  }
  void report(const Arm& arm,
              const Trajectory& path,
              const std::vector<Knot>& knots,
              const robot::Machine& machine,
              DiagnosticSink& sink) const {
    if (unbounded_) {
      const Knot& knot = knots[path.knotAt(*unbounded_)];
      sink.accept(diagnose(knot.origin, diag::JointsRow, knot.location, *unbounded_,
                           std::string("the arm fully stretched, where no speed of its joints has "
                                       "a bound")));
    }
    std::string slower;  // the same for all joints
    for (std::size_t j = 0; j < 2; ++j) {
      if (const Peak& peak = beyond_[j]; peak.value > tolerance::meanJointLimit) {
        const Knot& knot = knots[path.knotAt(peak.time)];
        const robot::Range range = arm.range(j);
        sink.accept(diagnose(
            knot.origin, diag::JointsRow, knot.location, peak.time,
            fmt::format("joint {} {:.4g} {} beyond its range, {:.6g} to {:.6g}", arm.jointName(j),
                        peak.value, arm.unit(j), range.low, range.high)));
      }
      const auto told = [&](const auto& row, const Peak& peak, double limit) {
        const Knot& knot = knots[path.knotAt(peak.time)];
        slower = slower.empty() ? slowerThatDoes(arm, knots, machine) : slower;
        sink.accept(diagnose(knot.origin, row, arm.jointName(j), peak.value, arm.unit(j),
                             knot.location, peak.time, limit, slower));
      };
      const double fast = arm.mostSpeed(j);
      const double hard = arm.mostAcceleration(j);
      if (speed_[j].value > fast * (1.0 + tolerance::jointLimit)) {
        told(diag::JointsSpeed, speed_[j], fast);
      }
      if (acceleration_[j].value > hard * (1.0 + tolerance::jointLimit)) {
        told(diag::JointsAcceleration, acceleration_[j], hard);
      }
    }
  }

 private:
  struct Peak {
    double value = 0.0;
    double time = 0.0;
  };
  static void keep(Peak& peak, double value, double time) {
    if (value > peak.value) {
      peak = {value, time};
    }
  }
  std::array<Peak, 2> speed_, acceleration_, beyond_;
  std::optional<double> unbounded_;  // when first
};
}  // namespace

bool canFollow(const Arm& arm,
               const std::vector<Knot>& knots,
               double mostSpeed,
               DiagnosticSink& sink) {
  return withinReach(arm, knots, sink) && clearOfAxis(arm, knots, sink) &&
         withinTurn(arm, knots, sink) && withinSpeed(mostSpeed, knots, sink);
}

Table tableOf(const Arm& arm,
              const std::vector<Knot>& knots,
              const robot::Machine& machine,
              DiagnosticSink& sink) {
  Table table;
  table.interval = machine.interval;
  const Trajectory path(knots, machine.acceleration, machine.blend);
  const double count = std::ceil(path.duration() / machine.interval - tolerance::jointLimit);
  if (!(count < mostRows)) {
    sink.accept(diagnose(knots.back().origin, diag::JointsSize, path.duration(), machine.interval,
                         mostRows));
    return table;
  }
  constexpr int between = 4;  // looks for the peaks, so that they do not hide between two rows
  Peaks peaks;
  double turn = 0.0;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(count); ++i) {
    const double time = static_cast<double>(i) * machine.interval;
    for (int k = 0; k < between; ++k) {
      const double look = time + k * machine.interval / between;
      const State tool = path.at(std::min(look, path.duration()));
      const JointState joints = arm.jointsOf(tool, turn);
      turn = joints.place[1];
      peaks.add(std::min(look, path.duration()), joints, arm);
      if (k == 0) {
        table.rows.push_back({time, tool, joints});
        table.paintingTime += tool.gun ? machine.interval : 0.0;
      }
    }
  }
  peaks.report(arm, path, knots, machine, sink);
  warnOfFilm(path.spraying(), knots, sink);
  return table;
}

}  // namespace arelem::joints
