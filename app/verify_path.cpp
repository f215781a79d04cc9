#include "app/verify_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/ranges.h>

#include "backend/robot/feed.h"
#include "ir/cl/feed.h"
#include "ir/cl/post_word.h"
#include "ir/diag/render_text.h"
#include "ir/diag/verify.h"
#include "ir/space/tolerance.h"
#include "ir/words/units.h"

namespace arelem::app {

void Path::accept(const cl::Record& record) {
  if (const auto* units = std::get_if<cl::Units>(&record.body)) {
    millimeters = millimetersOf(units->unit);
  }
  if (const auto* values = std::get_if<cl::Values>(&record.body)) {
    const double value = values->values.empty() ? 0.0 : std::abs(values->values.back());
    inner_ = values->word == Word::INTOL ? value : inner_;
    outer_ = values->word == Word::OUTTOL ? value : outer_;
  }
  if (const auto* post = std::get_if<cl::Post>(&record.body);
      post != nullptr && post->foreign.empty()) {
    word(*post);
  }
  const auto* motion = std::get_if<cl::Motion>(&record.body);
  if (motion == nullptr) {
    return;
  }
  for (std::size_t i = 0; i + motion->stride() <= motion->coordinates.size();
       i += motion->stride()) {
    const double* c = motion->coordinates.data() + i;
    Location location{{c[0], c[1], c[2]}, std::nullopt, std::nullopt, record.origin, {}};
    location.band = inner_ + outer_;
    location.on = on_;
    if (motion->withAxis) {
      location.axis = Vec3(c[3], c[4], c[5]);
    }
    if (motion->withSide) {
      location.side = Vec3(c[6], c[7], c[8]);
    }
    const bool isFrom = motion->kind == cl::Motion::Kind::from;
    if (cycles_.now() != nullptr && !isFrom) {
      location.hole = holeAt(location.point, location.axis.value_or(Vec3::UnitZ()));
    }
    location.rapid = isFrom || rapid_;
    location.speed = isFrom || (rapid_ && !location.hole) ? 0.0 : speed_.now();
    rapid_ = false;
    locations.push_back(location);
  }
}

/// The cycle in force, which may return to the height where the tool is now.
hole::Cycle Path::holeAt(const Vec3& point, const Vec3& axis) const {
  if (locations.empty()) {
    return *cycles_.now();
  }
  const Location& last = locations.back();
  const Vec3 before = last.axis.value_or(Vec3::UnitZ());
  if ((before - axis).norm() > tolerance::symmetric) {
    return hole::cycleFrom(*cycles_.now(), std::nullopt);
  }
  const double over = last.hole ? last.hole->retract : 0.0;
  return hole::cycleFrom(*cycles_.now(), (last.point - point).dot(axis) + over);
}

void Path::word(const cl::Post& post) {
  if (post.word == Word::CYCLE) {
    cycle(post);
  } else if (post.word == Word::FEDRAT) {
    speed_.set(robot::speedOf(post, millimeters, turns_).value_or(0.0));
    rapid_ = false;
  } else if (post.word == Word::RAPID) {
    rapid_ = true;
  } else if (post.word == Word::SPINDL) {
    turns_ = cl::turnsBehind(post, turns_);
  } else if (!locations.empty() && post.word == Word::DELAY) {
    if (const Result<double> seconds = robot::secondsOf(post, turns_)) {
      locations.back().wait += *seconds;
    }
  } else if (post.word == Word::SPRAY) {
    switchOutput(post);
  }
}

void Path::cycle(const cl::Post& post) {
  const auto change = cycles_.read(post);
  if (!change || *change == hole::Cycles::Change::none) {
    return;
  }
  speed_.endCycle();
  const hole::Cycle* begun = cycles_.now();
  if (const auto own = begun != nullptr ? hole::feedOf(*begun) : std::nullopt) {
    speed_.beginCycle(robot::speedOf(*own, millimeters, turns_).value_or(0.0));
  }
}

void Path::switchOutput(const cl::Post& post) {
  int output = 1;
  bool on = false;
  for (const cl::Value& value : post.arguments) {
    if (const double* number = std::get_if<double>(&value)) {
      output = static_cast<int>(*number);
    } else if (const Word* word = std::get_if<Word>(&value)) {
      on = *word == Word::ON;
    }
  }
  on ? void(on_.insert(output)) : void(on_.erase(output));
  if (!locations.empty()) {
    locations.back().on = on_;
  }
}

std::string listed(const std::set<int>& outputs) {
  return outputs.empty() ? "none" : fmt::format("{}", fmt::join(outputs, ", "));
}

double degreesBetween(const Vec3& a, const Vec3& b) {
  constexpr double degreesOfARadian = 180.0 / std::numbers::pi;
  return degreesOfARadian * std::atan2(a.cross(b).norm(), a.dot(b));
}

std::optional<Diagnostic> difference(const Location& wanted,
                                     const Location& found,
                                     std::size_t number,
                                     const std::string& name,
                                     const Allowed& allowed) {
  const double distance = (wanted.point - found.point).norm();
  if (!(distance <= allowed.distance)) {
    return diagnose(wanted.origin, diag::PathDiffers, number, name, distance, allowed.distance);
  }
  const double turned = wanted.axis && found.axis ? degreesBetween(*wanted.axis, *found.axis) : 0.0;
  if (!(turned <= allowed.degrees)) {
    return diagnose(wanted.origin, diag::AxisDiffers, number, name, turned, allowed.degrees);
  }
  const double about = wanted.side && found.side ? degreesBetween(*wanted.side, *found.side) : 0.0;
  if (!(about <= allowed.degrees)) {
    return diagnose(wanted.origin, diag::SideDiffers, number, name, about, allowed.degrees);
  }
  return std::nullopt;
}

std::optional<Diagnostic> firstDifference(const Path& wanted,
                                          const Path& found,
                                          const std::string& name,
                                          const Allowed& allowed) {
  const std::size_t count = std::min(wanted.locations.size(), found.locations.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (auto other = difference(wanted.locations[i], found.locations[i], i + 1, name, allowed)) {
      return other;
    }
  }
  if (wanted.locations.size() != found.locations.size()) {
    return diagnose(nowhere, diag::PathLength, name, found.locations.size(),
                    wanted.locations.size());
  }
  return std::nullopt;
}

}  // namespace arelem::app
