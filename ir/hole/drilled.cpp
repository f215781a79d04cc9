#include "ir/hole/drilled.h"

#include <utility>

#include "ir/hole/steps.h"

namespace arelem::hole {

void Drilled::say(const cl::Record& from, cl::Post post) {
  cl::Record record = from;
  record.body = std::move(post);
  next_.accept(record);
}

void Drilled::change(const cl::Record& record, const cl::Post& post) {
  const auto changed = cycles_.read(post);
  if (!changed) {
    next_.accept(record);
    passed_ = true;
  } else if (std::exchange(passed_, false)) {
    say(record, {Word::CYCLE, "", {Word::OFF}});
  }
  if (cycles_.now() == nullptr && ownFeed_ && feed_) {
    say(record, *feed_);
    ownFeed_ = false;
  }
}

void Drilled::accept(const cl::Record& record) {
  const auto* post = std::get_if<cl::Post>(&record.body);
  if (post != nullptr && post->foreign.empty() && post->word == Word::CYCLE) {
    return change(record, *post);
  }
  if (post != nullptr && post->foreign.empty() && post->word == Word::FEDRAT) {
    feed_ = *post;
  }
  const auto* motion = std::get_if<cl::Motion>(&record.body);
  if (motion == nullptr || motion->points() == 0) {
    return next_.accept(record);
  }
  if (cycles_.now() != nullptr && at_ && motion->kind != cl::Motion::Kind::from) {
    return drill(record, *motion);
  }
  next_.accept(record);
  at_ = Vec3(&motion->coordinates[(motion->points() - 1) * motion->stride()]);
}

void Drilled::drill(const cl::Record& record, const cl::Motion& motion) {
  const std::optional<cl::Post> own = feedOf(*cycles_.now());
  for (std::size_t i = 0; i < motion.points(); ++i) {
    const auto first =
        motion.coordinates.begin() + static_cast<std::ptrdiff_t>(i * motion.stride());
    const Vec3 end(&*first);
    const Vec3 axis = motion.withAxis ? Vec3(&*first + 3) : Vec3(Vec3::UnitZ());
    const Cycle cycle = cycleFrom(*cycles_.now(), (*at_ - end).dot(axis));
    bool begins = i == 0;
    const auto go = [&](const Vec3& place) {
      cl::Record one = record;
      cl::Motion& move = std::get<cl::Motion>(one.body);
      move.kind = std::exchange(begins, false) ? motion.kind : cl::Motion::Kind::continuation;
      move.coordinates.assign(first, first + static_cast<std::ptrdiff_t>(motion.stride()));
      for (int k = 0; k < 3; ++k) {
        move.coordinates[static_cast<std::size_t>(k)] = place[k];
      }
      next_.accept(one);
      at_ = place;
    };
    for (const Vec3& place : wayOver(*at_, end + cycle.clearance * axis, axis)) {
      say(record, {Word::RAPID, "", {}});
      go(place);
    }
    for (const Step& step : timedStepsOf(cycle)) {
      if (step.kind == Step::Kind::dwell) {
        say(record, {Word::DELAY, "", {step.seconds}});
        continue;
      }
      if (step.kind == Step::Kind::rapid) {
        say(record, {Word::RAPID, "", {}});
      } else if (own || feed_) {
        say(record, own ? *own : *feed_);
        ownFeed_ = own.has_value();
      }
      go(end + step.height * axis);
    }
  }
}

}  // namespace arelem::hole
