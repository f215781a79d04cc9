// SPRAY: words to a job, its strokes to actions.
#include "ir/diag/spray.h"

#include <algorithm>
#include <cmath>

#include "ir/diag/interpret.h"
#include "ir/space/spray_tolerance.h"
#include "ir/space/tolerance.h"
#include "runtime/define/choice.h"
#include "runtime/geometry/triangle_mesh.h"
#include "runtime/interpret/command.h"
#include "runtime/interpret/spray_work.h"
#include "runtime/spray/region_job.h"
#include "runtime/spray/units.h"

namespace arelem::runtime::interpret {

namespace {

using spray::Sprayed;
using spray::Stroke;

/// A measured film may lie more to one side.
bool isAlikeOnBothSides(const spray::Profile& profile) {
  return std::all_of(profile.points().begin(), profile.points().end(), [&](const auto& point) {
    return std::abs(point.second - profile.density(-point.first)) <= tolerance::similarity;
  });
}

/// Puts the strokes of a job into the stream: poses of the gun, its switching, feeds.
class StrokeWriter {
 public:
  StrokeWriter(State& state, const Sprayed& sprayed)
      : state_(state), sprayed_(sprayed), unit_(state.context.millimeters) {
    const spray::Footprint& print = sprayed.gun.footprint;
    isRound_ = std::abs(print.along - print.across) <= tolerance::similarity * print.across &&
               isAlikeOnBothSides(sprayed.gun.profile());
  }

  void write() {
    const bool multax = state_.multax;
    if (!multax) {
      state_.emit(Toggle{Word::MULTAX, true});
    }
    if (sprayed_.chosen.operation.flow > 0.0) {
      post(Word::FLOW, {spray::toldFlow(sprayed_.chosen.operation.flow)});
    }
    if (!sprayed_.gun.spreads() && !sprayed_.trials.empty()) {
      state_.emit(Pass{cl::Post{Word::END, "FAN", {sprayed_.chosen.across / unit_}}});
    }
    for (std::size_t i = 0; i < sprayed_.strokes.size(); ++i) {
      stroke(i);
    }
    off();
    if (!multax) {
      state_.emit(Toggle{Word::MULTAX, false});
    }
  }

 private:
  void post(Word word, std::vector<cl::Value> values) {
    state_.emit(Pass{cl::Post{word, "", std::move(values)}});
  }
  void on() {
    if (!spraying_) {
      post(Word::SPRAY, {Word::ON, static_cast<double>(sprayed_.gun.output)});
    }
    spraying_ = true;
  }
  void off() {
    if (spraying_) {
      post(Word::SPRAY, {Word::OFF, static_cast<double>(sprayed_.gun.output)});
    }
    spraying_ = false;
  }
  void feed(double speed) {
    if (speed != feed_) {
      post(Word::FEDRAT, {speed, Word::MMPS});
      feed_ = speed;
    }
  }
  /// The nozzle stands off along the normal. A footprint that is not round lies with its width
  /// across the travel, and is not turned over from pass to pass.
  void goOver(const Vec3& place, const Vec3& normal, const Vec3& along) {
    go({place + sprayed_.gun.standOff * normal, normal}, along);
  }
  void go(const spray::GunPose& pose, const Vec3& along) {
    Locate locate;
    locate.word = Word::GOTO;
    locate.point = pose.place / unit_;
    locate.axis = pose.axis;
    const Vec3 across = pose.axis.cross(along);
    if (!isRound_ && across.norm() > tolerance::nullDirection) {
      side_ = across.normalized() * (side_ && side_->dot(across) < 0.0 ? -1.0 : 1.0);
      locate.side = side_;
    }
    state_.emit(std::move(locate));
  }

  /// The way to a pass that does not go straight.
  void goRound(std::size_t stroke, const Vec3& along) {
    const auto way =
        std::lower_bound(sprayed_.ways.begin(), sprayed_.ways.end(), stroke,
                         [](const spray::WayRound& w, std::size_t i) { return w.stroke < i; });
    if (way == sprayed_.ways.end() || way->stroke != stroke) {
      return;
    }
    for (const spray::GunPose& pose : way->poses) {
      post(Word::RAPID, {});
      go(pose, along);
    }
  }

  void stroke(std::size_t i) {
    const Stroke& s = sprayed_.strokes[i];
    const Vec3 step = s.to - s.from;
    const double length = step.norm();
    const Vec3 along = length > 0.0 ? Vec3(step / length) : Vec3(Vec3::Zero());
    const bool last = i + 1 == sprayed_.strokes.size() || !sprayed_.strokes[i + 1].painting ||
                      sprayed_.strokes[i + 1].newPass;
    if (s.newPass) {
      off();
      goRound(i, along);
      post(Word::RAPID, {});
      feed_ = 0.0;
      go(sprayed_.beginOf(s), along);
    }
    if (s.painting) {
      on();
      const double speed = sprayed_.nozzleSpeed(s);
      feed(speed);
      const double closing = last ? std::min(speed * sprayed_.gun.leadOff, length) : 0.0;
      if (closing > 0.0) {
        goOver(s.to - closing * along, s.normalTo, along);
        off();
      }
      go(sprayed_.endOf(s), along);
      return;
    }
    off();
    feed(s.speed);
    // The next piece is switched on early: the gap ends before its place.
    const double before = sprayed_.chosen.operation.speed * sprayed_.gun.leadOn;
    goOver(s.to - std::min(before, length) * along, s.normalTo, along);
  }

  State& state_;
  const Sprayed& sprayed_;
  double unit_;
  bool isRound_ = true;
  std::optional<Vec3> side_;
  bool spraying_ = false;
  double feed_ = 0.0;
};

void refuse(State& state, const SprayWords& words, Failure failure) {
  reportAt(state, state.statement->span, std::move(failure), words.items);
}

void finish(State& state, const SprayWords& words, Sprayed result) {
  auto sprayed = std::make_shared<Sprayed>(std::move(result));
  sprayed->origin = state.statement->span;
  sprayed->isn = static_cast<int>(state.statement->isn);
  sprayed->work = words.work->name;
  StrokeWriter(state, *sprayed).write();
  state.out.sprayed.push_back(std::move(sprayed));
}

void sprayRegion(State& state, const SprayWords& words) {
  spray::RegionJob job;
  job.region = region::Region::of(words.work->canon);
  job.unit = state.context.millimeters;
  job.gun = spray::Gun::of(words.gun->canon);
  job.film = words.film;
  job.overlap = words.overlap;
  job.inset = words.inset;
  if (const double* length = std::get_if<double>(&words.inset)) {
    job.inset = *length * job.unit;
  }
  job.degrees = words.degrees;
  job.speed = words.speed;
  job.otherSide = words.otherSide;
  job.prices = words.prices;
  job.angles = words.angles;
  job.limits = state.options.limits;
  job.sizes = words.sizes;
  if (job.sizes) {
    for (double* value : {&job.sizes->from, &job.sizes->to, &job.sizes->step}) {
      *value *= job.unit;
    }
  }
  const spray::Progress progress = [&state](std::size_t done, std::size_t all) {
    if (state.options.progress) {
      state.options.progress("MINCST", done, all);
    }
  };
  Result<spray::RegionResult> result = spray::sprayRegion(job, state.options.interrupted, progress);
  if (!result) {
    refuse(state, words, result.takeFailure());
    return;
  }
  for (Failure& warning : result->warnings) {
    state.reportFailure(state.statement->span, std::move(warning));
  }
  finish(state, words, std::move(result->sprayed));
}

Vec3 vec(const Entity& entity) {
  return {entity.canon[0], entity.canon[1], entity.canon[2]};
}

/// How the lines run, as the job wants it.
void setLines(spray::SurfaceJob& job, const SprayWords& words, double unit) {
  using Lines = SprayWords::Lines;
  using Job = spray::SurfaceJob;
  switch (words.lines) {
    case Lines::sections:
      job.lines = Job::Parallel{vec(*words.plane).normalized()};
      return;
    case Lines::radial:
      job.lines = Job::Radial{vec(*words.axisPlace) * unit, vec(*words.axisVector).normalized()};
      return;
    default:
      job.lines = words.lines == Lines::alongV ? Job::Way::alongV : Job::Way::alongU;
  }
}

/// Where the tool stands, mm, as far as the statements before tell: at a place of FROM or GOTO.
std::optional<spray::GunPose> standing(const State& state) {
  const auto placeOf = [unit = state.context.millimeters](const Locate& locate) {
    const bool known = locate.word != Word::GODLTA;
    const Vec3 axis = locate.axis.value_or(Vec3::Zero());
    return known ? std::optional(spray::GunPose{locate.point * unit, axis.normalized()})
                 : std::nullopt;
  };
  for (auto action = state.out.actions.rbegin(); action != state.out.actions.rend(); ++action) {
    if (const auto* locate = std::get_if<Locate>(&action->body)) {
      return placeOf(*locate);
    }
    if (std::holds_alternative<FollowSpline>(action->body) ||
        std::holds_alternative<Startup>(action->body) ||
        std::holds_alternative<Follow>(action->body) ||
        std::holds_alternative<Pocket>(action->body)) {
      return std::nullopt;
    }
  }
  return state.before ? placeOf(*state.before) : std::nullopt;
}

void spraySurface(State& state, const SprayWords& words) {
  const double unit = state.context.millimeters;
  spray::SurfaceJob job;
  if (auto failure = setWork(job, words, unit)) {
    refuse(state, words, *std::move(failure));
    return;
  }
  job.gun = spray::Gun::of(words.gun->canon);
  job.film = words.film;
  job.step = words.step * unit;
  job.chord = words.chord ? *words.chord * unit : job.chord;
  job.checkRadius = words.checkRadius;
  if (words.clear) {
    job.clear = *words.clear * unit;
  }
  job.mostPoints = state.options.limits.points;
  job.mostLines = state.options.limits.passes;
  job.speed = words.speed;
  job.stands = standing(state);
  setLines(job, words, unit);
  Result<Sprayed> sprayed = spray::spraySurface(job);
  if (!sprayed) {
    refuse(state, words, sprayed.takeFailure());
    return;
  }
  sprayed->work = words.work->name;
  if (sprayed->unclear > 0) {
    state.reportFailure(state.statement->span, fail(diag::SprayUnclear, sprayed->unclear,
                                                    sprayed->label(), sprayed->clearance));
  }
  if (sprayed->leftOut > 0) {
    state.reportFailure(
        state.statement->span,
        fail(diag::ShortLines, sprayed->leftOut, sprayed->leftOut + sprayed->lines,
             sprayed->label(), tolerance::shortestLine * sprayed->gun.footprint.across,
             sprayed->shortest));
  }
  finish(state, words, *std::move(sprayed));
}

/// SPRAY/ ON or OFF [, n]: an output is a whole number.
void sprayGun(State& state, const ir::Command& command) {
  constexpr double most = 9999.0;
  auto items = evaluate(state, command.arguments, Use::motion);
  if (!items) {
    return;
  }
  const double* output = items->size() == 2 ? (*items)[1].number() : nullptr;
  if (items->size() > 1 && output == nullptr) {
    state.reportFailure(state.statement->span,
                        fail(diag::SprayForm, describe(items->back()) + " behind ON or OFF",
                             "one number may stand there, that of the output"));
    return;
  }
  if (output != nullptr && !(*output >= 1.0 && *output <= most && *output == std::floor(*output))) {
    reportAt(
        state, state.statement->span,
        fail(diag::SprayValue, "the output", *output, fmt::format("a whole number, 1 to {}", most)),
        *items);
    return;
  }
  post(state, command);
}

}  // namespace

void spray(State& state, const ir::Command& command) {
  const Word* first =
      command.arguments.empty() ? nullptr : std::get_if<Word>(&command.arguments.front().value);
  if (first != nullptr && (*first == Word::ON || *first == Word::OFF)) {
    sprayGun(state, command);
    return;
  }
  auto items = evaluate(state, command.arguments, Use::motion);
  if (!items) {
    return;
  }
  Result<SprayWords> words = readSprayWords(*std::move(items));
  if (!words) {
    state.reportFailure(state.statement->span, words.takeFailure());
    return;
  }
  words->ofRegion() ? sprayRegion(state, *words) : spraySurface(state, *words);
}

}  // namespace arelem::runtime::interpret
