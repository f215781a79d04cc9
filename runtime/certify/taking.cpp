// The locations of a file, one by one, to the statements that they belong to.
#include <utility>

#include "ir/diag/motion.h"
#include "ir/diag/verify.h"
#include "runtime/certify/association.h"

namespace arelem::certify {

using runtime::Action;
using runtime::Follow;

namespace {
/// Locations that may stray before the motion counts as ended before them.
constexpr std::size_t mostHeld = 1000;
}  // namespace

void Association::begin(std::optional<int> isn, bool withAxis) {
  choose(isn, nullptr);
  Taking& t = taking_.emplace();
  t.numbered = isn.has_value();
  t.run.withAxis = withAxis;
  if (pocket_ && isn && pocket_->action->isn != *isn) {
    judgePocket();
  }
  const Action* action = advance();
  while (isn && action != nullptr && action->isn != *isn && numberAhead(*isn)) {
    miss(*action);
    action = advance();
  }
  t.copy = order_.expectsCopy();
  if (!t.copy) {
    order_.goOn();
  }
  if (t.copy || action == nullptr || (isn && action->isn != *isn)) {
    return;
  }
  t.action = action;
  if (const auto* follow = std::get_if<Follow>(&action->body)) {
    t.follow = follow;
    ++index_;  // what comes behind it implies check surfaces
    beginFollow(*follow);
  } else if (const auto* along = std::get_if<runtime::FollowSpline>(&action->body); along && !isn) {
    if (auto curve = spline::CubicSpline::of(along->curve->canon)) {
      t.curve = *std::move(curve);
      t.walk.emplace(*t.curve, options_.slack);
    }
  }
}

void Association::add(const Location& location, bool withAxis, bool onCurve) {
  const Held next{location, withAxis, onCurve};
  if (taking_ && taking_->mayEnd && !goesOn(next)) {
    close();
  }
  if (!taking_) {
    choose(std::nullopt, &location);
    begin(std::nullopt, withAxis);
  }
  if (!holdsBack(next)) {
    take(next);
  }
}

bool Association::holdsBack(const Held& next) {
  Taking& t = *taking_;
  if (t.numbered || t.copy || t.follow == nullptr || !t.proof || t.proof->cutVectors() == 0) {
    return false;
  }
  const auto [there, met, strays] = behind(next);
  if (strays && t.held.empty() && isNext(there.place().toolEnd)) {
    close();
    add(next.location, next.withAxis, next.onCurve);
    return true;
  }
  if (met || !strays) {
    for (const Held& before : std::exchange(t.held, {})) {
      take(before);
    }
    return false;
  }
  t.held.push_back(next);
  if (t.held.size() >= mostHeld) {
    release();
  }
  return true;
}

Association::Behind Association::behind(const Held& next) {
  Behind found{taking_->proof->end()};
  found.end.moveTo(placed(order_.programmed(next.location)));
  found.met = isMet(found.end);
  found.strays = taking_->proof->strays(found.end.place());
  return found;
}

bool Association::isMet(const PathEnd& end) const {
  const Taking& t = *taking_;
  for (std::size_t g = 0; g < t.goals.size(); ++g) {
    if (t.proof->mayEndAt(g) &&
        check_.missed(modal_, t.goals[g], g, end, t.drive->surface) == 0.0) {
      return true;
    }
  }
  return false;
}

bool Association::goesOn(const Held& next) {
  const Vec3 last = taking_->proof->end().place().toolEnd;
  const Behind found = behind(next);
  const Location& place = found.end.place();
  const bool moved = (place.toolEnd - last).norm() > options_.slack || !isStartupNext();
  return (found.met ? moved : !suitsNext(place)) && !isNext(place.toolEnd) &&
         taking_->proof->keeps(place);
}

bool Association::isStartupNext() const {
  const Action* action = outputFrom(index_);
  return action != nullptr && std::holds_alternative<runtime::Startup>(action->body);
}

bool Association::suitsNext(const Location& place) const {
  const auto& checks = taking_->follow->checks;
  const bool branches = std::any_of(checks.begin(), checks.end(), [](auto& c) { return c.label; });
  const Action* action = branches ? nullptr : outputFrom(index_);
  const auto* follow = action != nullptr ? std::get_if<Follow>(&action->body) : nullptr;
  const auto drive = follow != nullptr ? named(follow->drive) : fail(diag::NotCertified, "");
  if (!drive) {
    return true;
  }
  // The statements between may change the rest of it.
  const auto isAt = [&](bool on) {
    const GuideTask task = check_.taskOf(modal_, driveRole, *drive, on);
    const double most = std::max(task.allowed.inner, task.allowed.outer) + task.allowed.slack;
    return !FollowProof::isOff(task, place, most);
  };
  return isAt(false) || isAt(true);
}

bool Association::leadsTo(std::size_t way, const Location& from, const Vec3& place) const {
  const Action* action = outputFrom(way);
  const auto* locate = action != nullptr ? std::get_if<runtime::Locate>(&action->body) : nullptr;
  return locate != nullptr && (wantedBy(*locate, from) - place).norm() <= options_.slack;
}

bool Association::isNext(const Vec3& place) const {
  const Location end = taking_->proof->end().place();
  const auto leads = [&](std::size_t way) { return leadsTo(way, end, place); };
  const auto& checks = taking_->follow->checks;
  return modal_.output && (leads(index_) || std::any_of(checks.begin(), checks.end(), [&](auto& c) {
                             return c.label && leads(placeOf(*c.label));
                           }));
}

void Association::release() {
  const std::vector<Held> held = std::exchange(taking_->held, {});
  close();
  for (const Held& next : held) {
    add(next.location, next.withAxis, next.onCurve);
  }
}

void Association::take(const Held& next) {
  if (!taking_) {
    begin(std::nullopt, next.withAxis);
  }
  Taking& t = *taking_;
  if (!t.counts()) {
    if (!gaveUp_ && surplus_++ == 0) {
      firstSurplus_ = next.location.toolEnd;
    }
    return;
  }
  if (t.follow == nullptr || t.copy || order_.keeps()) {
    t.run.locations.push_back(next.location);
  }
  if (t.follow != nullptr) {
    addFollow(order_.programmed(next.location));
  }
  if (!t.numbered && !next.onCurve && complete()) {
    t.mayEnd = t.follow != nullptr && t.proof.has_value();
    if (!t.mayEnd) {
      close();
    }
  }
}

void Association::end() {
  while (taking_ && !taking_->held.empty()) {
    release();
  }
  close();
}

void Association::close() {
  if (!taking_) {
    return;
  }
  Taking& t = *taking_;
  if (t.copy && !t.run.locations.empty()) {
    judgeCopy(t.run);
  } else if (t.follow != nullptr) {
    order_.keep(t.run);
    endFollow();
  } else if (t.action != nullptr && !t.run.locations.empty()) {
    order_.keep(t.run);
    judge(*t.action, order_.programmed(t.run));
  }
  taking_.reset();
}

bool Association::complete() {
  const Taking& t = *taking_;
  if (t.copy) {
    return t.run.locations.size() >= order_.copyLength();
  }
  if (t.walk) {
    return taking_->walk->arrives(order_.programmed(t.run.locations.back()).toolEnd);
  }
  if (t.follow == nullptr || !t.drive || !t.proof) {
    return t.follow == nullptr || !t.drive;
  }
  return isMet(t.proof->end());
}

void Association::beginFollow(const Follow& follow) {
  Taking& t = *taking_;
  modal_.takeAutomaticPart();
  t.goals = goalsOf(follow);
  auto drive = named(follow.drive);
  if (!drive) {
    StatementResult result;
    result.origin = t.action->origin;
    result.isn = t.action->isn;
    result.statement = spell(follow.heading);
    check_.report(result, *t.action, fail(diag::NotCertified, drive.failure().message));
    add(std::move(result));
    return;
  }
  t.drive = *std::move(drive);
  if (modal_.positioned) {
    prove({modal_.toolEnd, modal_.axis});
  } else {
    report(*t.action,
           fail(diag::NotCertified, std::string("the file does not tell where it begins")));
    ++summary_.faults;
  }
}

/// The motion begins here.
void Association::prove(const Location& first) {
  Taking& t = *taking_;
  modal_.standsOn = modal_.isLeftOn(t.drive->surface, first.toolEnd);
  if (modal_.standsOn && !options_.own) {  // of our own path the computation told
    report(*t.action, fail(diag::OnAsItStands, arelem::spell(*modal_.driveRelation), t.drive->name,
                           modal_.cutterFor(driveRole)->maxRadius()));
  }
  t.proof.emplace(check_, modal_, *t.drive, t.goals, first, options_.interrupted);
}

/// A location with the program's axis where the file has none.
Location Association::placed(const Location& location) {
  Location l = location;
  if (!taking_->run.withAxis) {
    l.axis = taking_->drive ? modal_.axisAt(l.toolEnd, taking_->drive->surface) : modal_.axis;
  }
  return l;
}

void Association::addFollow(const Location& location) {
  Taking& t = *taking_;
  const Location l = placed(location);
  if (t.proof) {
    t.proof->add(l);
  } else if (t.drive) {
    prove(l);
  } else {
    t.last = l;
  }
}

/// The check surfaces that were met: the one that the end is nearest to, and others at which it is.
std::vector<std::size_t> Association::metOf(const Taking& t) const {
  if (!t.proof || t.goals.size() < 2) {
    return {0};
  }
  std::vector<std::size_t> met;
  std::size_t nearest = 0;
  double least = unbounded;
  for (std::size_t i = 0; i < t.goals.size(); ++i) {
    const double missed = check_.missed(modal_, t.goals[i], i, t.proof->end(), t.drive->surface);
    if (missed < least) {
      least = missed;
      nearest = i;
    }
    if (missed == 0.0) {
      met.push_back(i);
    }
  }
  return met.empty() ? std::vector{nearest} : met;
}

void Association::endFollow() {
  Taking& t = *taking_;
  const std::vector<std::size_t> atChecks = metOf(t);
  const std::size_t met = atChecks.front();
  if (t.proof && t.proof->cutVectors() > 0) {
    add(t.proof->finish(*t.action, t.goals, met));
  }
  const std::optional<Location> last = t.proof ? t.proof->end().place() : t.last;
  modal_.consumeOneShots();
  modal_.startedOffDrive.clear();
  if (last) {
    moveTo(*last);
  }
  for (const std::size_t i : atChecks) {
    const auto& checks = t.follow->checks;
    ways_.push_back(i < checks.size() && checks[i].label ? placeOf(*checks[i].label) : index_);
  }
  if (ways_.size() == 1) {
    choose(std::nullopt, nullptr);
  }
}

const Action* Association::outputFrom(std::size_t index) const {
  // More steps than there are actions go round for ever.
  for (std::size_t steps = 0; index < actions_.size() && steps < actions_.size(); ++steps) {
    const Action& action = actions_[index];
    if (putsOut(action)) {
      return &action;
    }
    const auto* transfer = std::get_if<runtime::Transfer>(&action.body);
    index = transfer != nullptr ? placeOf(transfer->label) : index + 1;
  }
  return nullptr;
}

void Association::choose(std::optional<int> isn, const Location* next) {
  if (ways_.empty()) {
    return;
  }
  const auto fits = [&](std::size_t way) {
    const Action* action = outputFrom(way);
    return isn ? action != nullptr && action->isn == *isn
               : next != nullptr && leadsTo(way, here(), next->toolEnd);
  };
  const auto way = std::find_if(ways_.begin(), ways_.end(), fits);
  index_ = way != ways_.end() ? *way : ways_.front();
  ways_.clear();
}

}  // namespace arelem::certify
