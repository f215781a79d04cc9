#include "backend/joints/trajectory.h"

#include <algorithm>
#include <cmath>

#include "ir/space/robot_tolerance.h"

namespace arelem::joints {

namespace {
/// A move between two knots.
struct Leg {
  Place from = Place::Zero();
  Place direction = Place::Zero();  // for one mm of path
  double length = 0.0;              // mm; of a turn on the spot: what its turn is worth
  double speed = 0.0;
  double begin = 0.0, end = 0.0;  // speeds at its ends
};

Place placeOf(const Knot& knot) {
  Place place;
  place << knot.point, knot.heading, knot.tilt;
  return place;
}

/// The moves; those without any change have length 0.
std::vector<Leg> legsOf(const std::vector<Knot>& knots) {
  constexpr double turnRate = 90.0;  // deg/s of a tool that turns on the spot
  std::vector<Leg> legs;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    Leg leg;
    leg.from = placeOf(knots[i]);
    leg.speed = knots[i + 1].speed;
    const Place way = placeOf(knots[i + 1]) - leg.from;
    const double turn = way.tail<2>().cwiseAbs().maxCoeff();
    leg.length = way.head<3>().norm();
    if (leg.length <= tolerance::onTheSpot) {
      leg.length = leg.speed * turn / turnRate;
    }
    if (leg.length > tolerance::onTheSpot) {
      leg.direction = way / leg.length;
    }
    legs.push_back(leg);
  }
  return legs;
}

/// The speed at which the tool may pass from one leg to the next: its change must not exceed the
/// acceleration, which is twice the mean one in the middle of the window.
double cornerSpeed(const Leg& before, const Leg& after, double acceleration, double window) {
  const double turn = (after.direction.head<3>() - before.direction.head<3>()).norm();
  const double slower = std::min(before.speed, after.speed);
  return turn > 0.0 ? std::min(slower, 0.5 * acceleration * window / turn) : slower;
}

void lookAhead(std::vector<Leg>& legs,
               const std::vector<Knot>& knots,
               double acceleration,
               double window) {
  for (std::size_t i = 1; i < legs.size(); ++i) {
    const double most =
        knots[i].stop ? 0.0 : cornerSpeed(legs[i - 1], legs[i], acceleration, window);
    legs[i - 1].end = legs[i].begin = most;
  }
  const auto reached = [&](double speed, const Leg& leg) {
    return std::sqrt(speed * speed + 2.0 * acceleration * leg.length);
  };
  for (std::size_t i = legs.size(); i-- > 0;) {
    legs[i].begin = std::min(legs[i].begin, reached(legs[i].end, legs[i]));
    if (i > 0) {
      legs[i - 1].end = legs[i].begin;
    }
  }
  for (std::size_t i = 0; i < legs.size(); ++i) {
    legs[i].end = std::min(legs[i].end, reached(legs[i].begin, legs[i]));
    if (i + 1 < legs.size()) {
      legs[i + 1].begin = legs[i].end;
    }
  }
}
}  // namespace

Place Trajectory::Phase::placeAt(double t) const {
  const double d = t - start;
  return from + (speed * d + 0.5 * acceleration * d * d) * direction;
}
Place Trajectory::Phase::speedAt(double t) const {
  return (speed + acceleration * (t - start)) * direction;
}
void Trajectory::add(Phase phase, double seconds) {
  if (seconds <= 0.0) {
    return;
  }
  phase.start = raw_;
  phases_.push_back(phase);
  raw_ += seconds;
}

void Trajectory::stand(const Place& place, double seconds, bool gun, std::size_t knot) {
  Phase phase;
  phase.from = place;
  phase.gun = gun;
  phase.knot = knot;
  add(phase, seconds);
}

Trajectory::Trajectory(const std::vector<Knot>& knots, double acceleration, double window)
    : window_(window) {
  std::vector<Leg> legs = legsOf(knots);
  lookAhead(legs, knots, acceleration, window);
  // The mean over the window lags by half of it: so does the gun.
  bool gun = false;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (knots[i].stop) {
      stand(placeOf(knots[i]), 0.5 * window, gun, i);
      stand(placeOf(knots[i]), 0.5 * window + knots[i].dwell, knots[i].gun, i);
    }
    gun = knots[i].gun;
    if (i == legs.size() || legs[i].direction.isZero()) {
      continue;
    }
    const Leg& leg = legs[i];
    const double squares = 0.5 * (leg.begin * leg.begin + leg.end * leg.end);
    const double top = std::min(leg.speed, std::sqrt(acceleration * leg.length + squares));
    const double faster = (top - leg.begin) / acceleration;
    const double slower = (top - leg.end) / acceleration;
    const double ways = 0.5 * ((leg.begin + top) * faster + (top + leg.end) * slower);
    const double even = std::max(0.0, (leg.length - ways) / top);
    Phase phase;
    phase.direction = leg.direction;
    phase.gun = gun;
    phase.knot = i;
    phase.from = leg.from;
    phase.speed = leg.begin;
    phase.acceleration = acceleration;
    add(phase, faster);
    phase.from = leg.from + 0.5 * (leg.begin + top) * faster * leg.direction;
    phase.speed = top;
    phase.acceleration = 0.0;
    add(phase, even);
    phase.from += top * even * leg.direction;
    phase.acceleration = -acceleration;
    add(phase, slower);
  }
  if (!knots.empty()) {
    stand(placeOf(knots.back()), 0.5 * window, gun, knots.size() - 1);
  }
  keepSpraying(knots);
}

void Trajectory::keepSpraying(const std::vector<Knot>& knots) {
  std::vector<double> open(knots.size(), 0.0);
  for (std::size_t i = 0; i < phases_.size(); ++i) {
    const double end = i + 1 < phases_.size() ? phases_[i + 1].start : raw_;
    open[phases_[i].knot] += phases_[i].gun ? end - phases_[i].start : 0.0;
  }
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const bool gun = knots[i].gun;
    const bool goes = gun && i + 1 < knots.size() && knots[i + 1].speed > 0.0;
    const double way = goes ? (knots[i + 1].point - knots[i].point).norm() : 0.0;
    const double planned = goes ? way / knots[i + 1].speed : 0.0;
    const double waits = gun ? knots[i].dwell : 0.0;
    spraying_.open += open[i];
    spraying_.planned += planned + waits;
    if (way > tolerance::onTheSpot && open[i] - waits > spraying_.worst * planned) {
      spraying_.worst = (open[i] - waits) / planned;
      spraying_.knot = i;
    }
  }
}

const Trajectory::Phase& Trajectory::phaseAt(double t) const {
  const auto next = std::upper_bound(phases_.begin() + 1, phases_.end(), t,
                                     [](double time, const Phase& p) { return time < p.start; });
  return *(next - 1);
}

Place Trajectory::rawPlace(double t) const {
  const double within = std::clamp(t, 0.0, raw_);
  return phaseAt(within).placeAt(within);
}
Place Trajectory::rawSpeed(double t) const {
  return t <= 0.0 || t >= raw_ ? Place(Place::Zero()) : phaseAt(t).speedAt(t);
}

double Trajectory::nextBreak(double t) const {
  if (t < 0.0) {
    return 0.0;
  }
  const auto next = std::upper_bound(phases_.begin(), phases_.end(), t,
                                     [](double time, const Phase& p) { return time < p.start; });
  return next != phases_.end() ? next->start : t < raw_ ? raw_ : t + window_;
}

/// The weighted mean over the window that ends at `time`. Between breaks a place times its weight
/// is cubic in time, which two points of Gauss integrate exactly.
template <class Quantity>
Place Trajectory::mean(double time, const Quantity& of) const {
  const double half = 0.5 * window_;
  const double middle = time - half;
  const double point = 1.0 / std::sqrt(3.0);
  Place sum = Place::Zero();
  for (double from = time - window_; from < time;) {
    const double to = std::min({time, from < middle ? middle : time, nextBreak(from)});
    const double center = 0.5 * (from + to);
    const double reach = 0.5 * (to - from);
    for (const double t : {center - point * reach, center + point * reach}) {
      sum += reach * (half - std::abs(t - middle)) * of(t);
    }
    from = to;
  }
  return sum / (half * half);
}

State Trajectory::at(double time) const {
  const double half = 0.5 * window_;
  State state;
  state.place = mean(time, [&](double t) { return rawPlace(t); });
  state.speed = mean(time, [&](double t) { return rawSpeed(t); });
  state.acceleration =
      (rawPlace(time) - 2.0 * rawPlace(time - half) + rawPlace(time - window_)) / (half * half);
  state.gun = phaseAt(std::clamp(time - half, 0.0, raw_)).gun;
  return state;
}

std::size_t Trajectory::knotAt(double time) const {
  return phaseAt(std::clamp(time - 0.5 * window_, 0.0, raw_)).knot;
}

}  // namespace arelem::joints
