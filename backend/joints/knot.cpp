#include "backend/joints/knot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "backend/robot/envelope.h"
#include "backend/robot/feed.h"
#include "backend/robot/pose.h"
#include "ir/cl/feed.h"
#include "ir/cl/post_word.h"
#include "ir/diag/ngc.h"
#include "ir/diag/robot.h"
#include "ir/hole/cycle.h"
#include "ir/space/robot_tolerance.h"
#include "ir/words/units.h"

namespace arelem::joints {

void KnotReader::accept(const cl::Record& record) {
  if (const auto* moved = std::get_if<cl::Motion>(&record.body)) {
    motion(*moved, record.origin);
  } else if (const auto* word = std::get_if<cl::Post>(&record.body)) {
    post(*word, record.origin);
  } else if (const auto* units = std::get_if<cl::Units>(&record.body)) {
    millimeters_ = millimetersOf(units->unit);
  } else if (const auto* text = std::get_if<cl::Text>(&record.body);
             text != nullptr && text->word == Word::INSERT) {
    without("INSERT", record.origin);
  } else if (std::holds_alternative<cl::Raw>(record.body)) {
    without("a record of an unknown class", record.origin);
  }
}

void KnotReader::motion(const cl::Motion& motion, const Span& origin) {
  const std::size_t stride = motion.stride();
  for (std::size_t i = 0; i + stride <= motion.coordinates.size(); i += stride) {
    const double* c = motion.coordinates.data() + i;
    robot::Pose pose;
    pose.point = millimeters_ * Vec3(c[0], c[1], c[2]);
    if (motion.withAxis) {
      pose.axis = Vec3(c[3], c[4], c[5]);
    }
    if (motion.withSide) {
      pose.side = Vec3(c[6], c[7], c[8]);
    }
    ++location_;
    location(robot::inBase(machine_.frame, pose), origin);
  }
}

void KnotReader::location(const robot::Pose& pose, const Span& origin) {
  const std::optional<robot::Upright> upright = robot::uprightOf(pose);
  const std::string place = fmt::format("location {}", location_);
  if (!upright) {
    const double lean =
        std::acos(std::clamp(pose.axis.normalized().z(), -1.0, 1.0)) * 180.0 / std::numbers::pi;
    return object(
        {fail(diag::ToolNotUpright, place, lean, " but for the tilt along its side"), lean},
        origin);
  }
  if (auto objection = objectionToTilt(upright->tilt, place)) {
    return object(*std::move(objection), origin);
  }
  if (machine_.envelope) {
    if (auto objection = robot::objectionToPlace(*machine_.envelope, pose, place)) {
      return object(*std::move(objection), origin);
    }
  }
  if (!rapid_ && speed_ <= 0.0 && !knots_.empty() && !failed_) {
    sink_.accept(
        diagnose(origin, diag::NgcFeedMissing, pose.point.x(), pose.point.y(), pose.point.z()));
    failed_ = true;
  }
  Knot knot;
  knot.point = pose.point;
  const double before = knots_.empty() ? upright->heading : knots_.back().heading;
  constexpr double turn = 360.0;
  knot.heading = upright->heading + turn * std::round((before - upright->heading) / turn);
  knot.tilt = upright->tilt;
  knot.speed = rapid_ || speed_ <= 0.0 ? machine_.rapid : speed_;
  // A rapid move begins and ends at rest.
  knot.stop = knots_.empty() || rapid_;
  if (rapid_ && !knots_.empty()) {
    knots_.back().stop = true;
  }
  knot.gun = gun_;
  knot.location = location_;
  knot.origin = origin;
  rapid_ = false;
  knots_.push_back(knot);
}

std::optional<robot::Objection> KnotReader::objectionToTilt(double tilt,
                                                            const std::string& place) const {
  const double most = machine_.tilt ? machine_.tilt->most : 0.0;
  const bool arm = machine_.pantograph || machine_.elbow;  // without one nothing is planned
  const double excess = std::abs(tilt) - most;
  if (!arm || excess <= tolerance::uprightLean) {
    return std::nullopt;
  }
  return robot::Objection{machine_.tilt ? fail(diag::TiltRange, place, tilt, most, excess)
                                        : fail(diag::ToolNotUpright, place, std::abs(tilt), ""),
                          excess};
}

void KnotReader::object(robot::Objection objection, const Span& origin) {
  objections_.add(std::move(objection), location_, origin);
  failed_ = true;
}

void KnotReader::refuse(Failure failure, const Span& origin) {
  sink_.accept(at(origin, std::move(failure)));
  failed_ = true;
}

void KnotReader::stopHere(double seconds) {
  if (!knots_.empty()) {
    knots_.back().stop = true;
    knots_.back().dwell += seconds;
  }
}

void KnotReader::spray(const cl::Post& post) {
  gun_ = cl::has(post, Word::ON);
  if (!machine_.vplus.onTheFly) {
    stopHere(0.0);
  }
  if (!knots_.empty()) {
    knots_.back().gun = gun_;
  }
}

void KnotReader::post(const cl::Post& post, const Span& origin) {
  if (cl::isApplied(post)) {
    return;
  }
  switch (post.foreign.empty() ? post.word : Word::INSERT) {
    case Word::FEDRAT:
      if (Result<double> speed = robot::neededSpeed(post, millimeters_, turns_)) {
        speed_ = *speed;
      } else {
        refuse(speed.takeFailure(), origin);
      }
      rapid_ = false;
      return;
    case Word::RAPID:
      rapid_ = true;
      return;
    case Word::SPRAY:
      return spray(post);
    case Word::DELAY:
      if (Result<double> seconds = robot::secondsOf(post, turns_)) {
        stopHere(*seconds);
      } else {
        refuse(seconds.takeFailure(), origin);
      }
      return;
    case Word::CYCLE:
      if (auto failure = hole::objectionToDrilling(post)) {
        refuse(*std::move(failure), origin);
      }
      return;
    case Word::SPINDL:
      turns_ = cl::turnsBehind(post, turns_);
      break;
    case Word::STOP:
    case Word::OPSTOP:
      return stopHere(0.0);
    case Word::MACHIN:
    case Word::END:
      return;  // for others, or said by the end of the table
    default:
      break;
  }
  without(cl::nameOf(post), origin);
}

void KnotReader::without(std::string_view what, const Span& origin) {
  if (std::find(told_.begin(), told_.end(), what) == told_.end()) {
    told_.emplace_back(what);
    sink_.accept(diagnose(origin, diag::JointsWithout, told_.back()));
  }
}

}  // namespace arelem::joints
