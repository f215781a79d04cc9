#include "backend/ngc/moves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "backend/ngc/arc.h"
#include "backend/ngc/parameters.h"
#include "ir/diag/ngc.h"
#include "ir/space/tolerance.h"
#include "ir/words/units.h"

namespace arelem::backend::ngc {

namespace {
using robot::ToolPose;
using robot::TurnedPlace;

constexpr double secondsOfAMinute = 60.0;
constexpr int feedDecimals = 4;
/// Coordinates have at most six digits before the point, mm.
constexpr double farthest = 999999.0;
/// An arc is kept if, after rounding, its radius differs by at most so many resolutions between its
/// ends.
constexpr double radiusResolutions = 2.0;
/// Degrees of a turn under a standing tool that are told.
constexpr double leastStanding = 1.0;
}  // namespace

void Moves::report(Failure failure) {
  if (reported_.insert(failure.row).second) {
    sink_.accept(at(record_->origin, std::move(failure)));
  }
}

void Moves::feed(const cl::Post& post) {
  if (const auto feed = readFeed(post)) {
    feed_.set(*feed);
  }
}

std::optional<cl::Feed> Moves::readFeed(const cl::Post& post) {
  cl::FeedReading reading = cl::readFeed(post, unit_);
  if (!reading.feed) {
    report(fail(diag::NgcStatement, written(post), std::move(reading.why)));
  }
  return reading.feed;
}

bool Moves::turnsAllowed(const Vec3& axis) {
  const bool tilted = std::hypot(axis.x(), axis.y()) > tolerance::nullDirection || axis.z() < 0.0;
  if (tilted && turning_ == nullptr) {
    report(fail(diag::NgcTilted, axis.x(), axis.y(), axis.z()));
    return false;
  }
  return true;
}

void Moves::move(const cl::Motion& motion) {
  if (motion.points() == 0) {
    return;
  }
  if (motion.kind == cl::Motion::Kind::continuation) {
    rapid_ = rapidRun_;  // records of one motion go at one speed
  } else {
    rapidRun_ = rapid_;
    run_ = std::exchange(surface_, std::nullopt);
    if (run_ && run_->canon.size() == 7) {
      for (const std::size_t i : {0U, 1U, 2U, 6U}) {
        run_->canon[i] *= unit_;
      }
    }
  }
  points(motion);
  rapid_ = false;
}

void Moves::points(const cl::Motion& motion) {
  const std::size_t stride = motion.stride();
  std::vector<Vec3> places;
  std::vector<Vec3> axes;
  for (std::size_t i = 0; i + stride <= motion.coordinates.size(); i += stride) {
    places.push_back(unit_ * Vec3(&motion.coordinates[i]));
    axes.push_back(motion.withAxis ? Vec3(Vec3(&motion.coordinates[i + 3]).normalized())
                                   : Vec3(Vec3::UnitZ()));
    if (!turnsAllowed(axes.back())) {
      return;
    }
  }
  if (motion.kind == cl::Motion::Kind::from) {
    return from({places.back(), axes.back()});
  }
  for (std::size_t i = 0; i < places.size();) {
    if (auto objection = cycles_.objection()) {
      report(*std::move(objection));
    }
    if (cycles_.now() != nullptr) {
      drill({places[i], axes[i]});
      ++i;
      continue;
    }
    std::size_t same = i;
    while (same < axes.size() && (axes[same] - now_.pose.axis).norm() <= tolerance::symmetric) {
      ++same;
    }
    const std::size_t taken = arc(std::span(places).subspan(i, same - i));
    if (taken == 0) {
      line({places[i], axes[i]});
    }
    i += std::max<std::size_t>(taken, 1);
  }
}

/// The first FROM tells where the tool stands; later ones are moves.
void Moves::from(const ToolPose& pose) {
  if (placed_ && sure_) {
    return line(pose);
  }
  now_.pose = pose;
  placed_ = true;
  sure_ = false;
  const Vec3& end = pose.end;
  block_.comment(fmt::format("FROM {} {} {}", block_.rounded(end.x()), block_.rounded(end.y()),
                             block_.rounded(end.z())));
}

Vec3 Moves::onMachine(const Vec3& place) const {
  return turning_ == nullptr || turning_->toolPoint
             ? place
             : robot::linearAxes(*turning_, place, now_.angles);
}

/// Whether a move there would be below the resolution of the output.
bool Moves::standsAt(const Vec3& linear, const robot::Angles& angles) const {
  return block_.holdsLength('X', linear.x()) && block_.holdsLength('Y', linear.y()) &&
         block_.holdsLength('Z', linear.z()) &&
         (turning_ == nullptr || (block_.holdsAngle(turning_->axes[0].letter, angles[0]) &&
                                  block_.holdsAngle(turning_->axes[1].letter, angles[1])));
}

void Moves::putAxes(const TurnedPlace& to) {
  now_ = to;
  const Vec3 linear = onMachine(to.pose.end);
  if (!(linear.cwiseAbs().maxCoeff() <= farthest)) {
    return report(fail(diag::NgcTooFar, linear.x(), linear.y(), linear.z(), farthest));
  }
  block_.changedLength('X', linear.x());
  block_.changedLength('Y', linear.y());
  block_.changedLength('Z', linear.z());
  if (turning_ != nullptr) {
    const bool inOrder = turning_->axes[0].letter < turning_->axes[1].letter;
    for (const std::size_t i : {inOrder ? 0U : 1U, inOrder ? 1U : 0U}) {
      block_.changedAngle(turning_->axes[i].letter, to.angles[i]);
    }
  }
}

bool Moves::feedIsKnown(const Vec3& to) {
  const bool known = feed_.now().value > 0.0;
  if (!known) {
    report(fail(diag::NgcFeedMissing, to.x() / unit_, to.y() / unit_, to.z() / unit_));
  }
  return known;
}

/// The feed of a move; with a `length` above 0 as the time of this move alone.
void Moves::putFeed(double length) {
  const auto& [value, per] = feed_.now();
  if (per == cl::Feed::Per::turn && !(turns_ > 0.0)) {
    report(fail(diag::NgcSpindle));
  }
  const bool timed = per == cl::Feed::Per::move || length > 0.0;
  if (timed) {
    const double perMinute = per == cl::Feed::Per::turn ? value * turns_ : value;
    block_.modal('f', "G93");
    const bool inverse = per == cl::Feed::Per::move;
    block_.number('F', inverse ? value / share_ : perMinute / length, feedDecimals);
    block_.forget('F');
    return;
  }
  block_.modal('f', per == cl::Feed::Per::turn ? "G95" : "G94");
  const double scale = control_.inches ? 1.0 / millimetersOfAnInch : 1.0;
  if (value * scale < 0.5 * std::pow(10.0, -feedDecimals)) {
    report(fail(
        diag::NgcValue,
        fmt::format("a feed of {:.3g} a minute or turn is 0 with the {} decimals of the output",
                    value * scale, feedDecimals)));
  }
  block_.modal('F', fmt::format("F{:.{}f}", value * scale, feedDecimals));
}

/// The places of a move; none where it is refused.
std::optional<std::vector<TurnedPlace>> Moves::way(const ToolPose& to) {
  if (turning_ == nullptr) {
    return std::vector{TurnedPlace{to, {}}};
  }
  if (sure_) {
    Result<std::vector<TurnedPlace>> places = robot::turnedMove(*turning_, now_, to);
    if (places) {
      return *std::move(places);
    }
    if (!rapid_ || places.failure().row != diag::TurningJump.row) {
      report(places.takeFailure());
      return std::nullopt;
    }
  }
  const Result<robot::Angles> angles = robot::nextAngles(*turning_, to.axis, now_.angles);
  if (!angles) {
    report(angles.failure());
    return std::nullopt;
  }
  if (sure_) {
    const double swing = robot::turnBetween(now_.angles, *angles);
    sink_.accept(diagnose(record_->origin, diag::TurningUnwinds, swing));
  }
  return std::vector{TurnedPlace{to, *angles}};
}

void Moves::line(const ToolPose& to) {
  if (!rapid_ && !feedIsKnown(to.end)) {
    return;
  }
  if (const auto places = way(to)) {
    tellStanding(*places);
    double turn = 0.0;
    robot::Angles before = now_.angles;
    for (const TurnedPlace& place : *places) {
      turn += robot::turnBetween(std::exchange(before, place.angles), place.angles);
    }
    for (const TurnedPlace& place : *places) {
      share_ = places->size() > 1 ? robot::turnBetween(now_.angles, place.angles) / turn : 1.0;
      straight(place);
    }
  }
}

/// At a pole the table turns under the tool before the move goes on.
void Moves::tellStanding(const std::vector<TurnedPlace>& places) {
  double turned = 0.0;
  for (const TurnedPlace& place : places) {
    if ((place.pose.end - now_.pose.end).norm() <= block_.resolution()) {
      turned = std::max(turned, robot::turnBetween(now_.angles, place.angles));
    }
  }
  const bool goesOn = (places.back().pose.end - now_.pose.end).norm() > block_.resolution();
  if (goesOn && turned > leastStanding && !rapid_) {
    const Vec3& end = now_.pose.end;
    sink_.accept(diagnose(record_->origin, diag::TurningStands, turned, end.x(), end.y(), end.z()));
  }
}

/// A move of all axes at once. Where turning axes move as well, the feed of the tool end needs the
/// time of the move.
void Moves::straight(const TurnedPlace& to) {
  const double turned = robot::turnBetween(now_.angles, to.angles);
  const double length = placed_ ? (to.pose.end - now_.pose.end).norm() : 0.0;
  const robot::Angles before = std::exchange(now_.angles, to.angles);
  const Vec3 linear = onMachine(to.pose.end);
  now_.angles = before;
  if (standsAt(linear, to.angles)) {
    now_ = to;
    return;
  }
  if (compensation_.isOn() && turned > tolerance::nullDirection) {
    report(fail(diag::NgcValue, std::string("the turning axes move while CUTCOM is on; a control "
                                            "offsets in one plane")));
  }
  compensation_.put();
  block_.modal('m', rapid_ ? "G0" : "G1");
  putAxes(to);
  if (!rapid_) {
    // Where the tool end stands still, the axes turn as many degrees a minute as millimeters.
    const bool turns = turned > tolerance::nullDirection;
    putFeed(!turns ? 0.0 : length > block_.resolution() ? length : turned);
  }
  block_.end();
  placed_ = sure_ = true;
}

/// Puts out an arc from here through the first of `rest` and tells how many it replaces.
std::size_t Moves::arc(std::span<const Vec3> rest) {
  const bool possible = control_.arcs && run_ && run_->canon.size() == 7 && !rapid_ && placed_ &&
                        feed_.now().value > 0.0 && feed_.now().per != cl::Feed::Per::move &&
                        !compensation_.isPending();
  if (!possible || rest.empty()) {
    return 0;
  }
  if (!sure_) {
    line(now_.pose);  // where FROM says that the tool stands: an arc needs its start
  }
  // As the linear axes see it: a circle square to the tool axis lies level on a turned table.
  cl::SurfaceValue round = *run_;
  const Vec3 center(round.canon.data());
  const Vec3 middle = onMachine(center);
  const Vec3 direction = onMachine(center + Vec3(&round.canon[3])) - middle;
  std::copy(middle.begin(), middle.end(), round.canon.begin());
  std::copy(direction.begin(), direction.end(), round.canon.begin() + 3);
  std::vector<Vec3> places;
  std::transform(rest.begin(), rest.end(), std::back_inserter(places),
                 [&](const Vec3& place) { return onMachine(place); });
  const Vec3 from = onMachine(now_.pose.end);
  const auto found = arcThrough(round, from, places, control_.arcTolerance, band_);
  if (!found || (compensation_.isOn() && found->axis != 2)) {
    return 0;  // a control does not change planes while it offsets the path
  }
  constexpr std::array planes = {"G19", "G18", "G17"};
  constexpr std::array offsets = {'I', 'J', 'K'};
  const auto rounded = [&](const Vec3& p) {
    return Vec3(block_.rounded(p.x()), block_.rounded(p.y()), block_.rounded(p.z()));
  };
  const Vec3 start = rounded(from);
  const Vec3 end = rounded(found->end);
  const Vec3 toCenter = rounded(found->center - start);
  const auto radial = [&](Vec3 v) {
    v(found->axis) = 0.0;
    return v.norm();
  };
  const double mismatch = std::abs(radial(toCenter) - radial(end - start - toCenter));
  const double chord = radial(end - start);
  if (mismatch > radiusResolutions * block_.resolution() ||
      chord <= radiusResolutions * block_.resolution()) {
    report(fail(diag::NgcArcBroken, radial(toCenter), block_.resolution(), mismatch, chord));
    return 0;
  }
  block_.modal('p', planes.at(static_cast<std::size_t>(found->axis)));
  block_.modal('m', found->positive ? "G3" : "G2");
  putAxes({{rest[found->points - 1], now_.pose.axis}, now_.angles});
  for (int k = 0; k < 3; ++k) {
    if (k != found->axis) {
      block_.length(offsets.at(static_cast<std::size_t>(k)), toCenter(k));
    }
  }
  putFeed(0.0);
  block_.end();
  return found->points;
}

}  // namespace arelem::backend::ngc
