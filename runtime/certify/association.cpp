#include "runtime/certify/association.h"

#include <algorithm>
#include <cmath>

#include "ir/cl/post_word.h"
#include "ir/diag/verify.h"
#include "ir/space/tolerance.h"
#include "runtime/spline/cubic.h"

namespace arelem::certify {

using runtime::Action;
using runtime::Follow;
using runtime::Locate;
using runtime::Startup;

Association::Association(const std::vector<Action>& actions,
                         const Options& options,
                         DiagnosticSink& sink)
    : actions_(actions), options_(options), sink_(sink), check_(options_, sink) {
  for (std::size_t i = 0; i < actions.size(); ++i) {
    if (const auto* label = std::get_if<runtime::Label>(&actions[i].body)) {
      labels_.emplace(label->key, i);
    }
  }
}

void Association::report(const Action& action, Failure failure) {
  sink_.accept(at(action.origin, std::move(failure)));
}

void Association::add(StatementResult result) {
  ++summary_.statements;
  summary_.faults += result.good ? 0 : 1;
  summary_.cutVectors += result.drive ? result.cutVectors : 0;
  for (const auto* g : {&result.drive, &result.part}) {
    summary_.places += *g ? (*g)->result.verdict.nodes : 0;
  }
  results_.push_back(std::move(result));
}

bool Association::putsOut(const Action& action) const {
  const auto* toggle = std::get_if<runtime::Toggle>(&action.body);
  if (toggle != nullptr) {
    return toggle->word == Word::CUT && !modal_.output;
  }
  return std::holds_alternative<Locate>(action.body) ||
         std::holds_alternative<Startup>(action.body) ||
         std::holds_alternative<Follow>(action.body) ||
         std::holds_alternative<runtime::Pocket>(action.body) ||
         std::holds_alternative<runtime::FollowSpline>(action.body);
}

/// SMOOTH/tol, ... A program that only ends smoothing moves nothing.
bool smooths(const cl::Body& body) {
  const auto* post = std::get_if<cl::Post>(&body);
  if (post == nullptr || post->arguments.empty()) {
    return false;
  }
  return cl::nameOf(*post) == "SMOOTH" && std::holds_alternative<double>(post->arguments.front());
}

const Action* Association::advance() {
  while (!ended_ && index_ < actions_.size() && !order_.expectsCopy()) {
    const Action& action = actions_[index_];
    if (putsOut(action)) {
      if (modal_.output || std::holds_alternative<runtime::Toggle>(action.body)) {
        return &action;
      }
      unseen(action);
      ++index_;
      continue;
    }
    ++index_;
    if (++steps_ > options_.limits.steps) {
      ended_ = true;
    } else if (const auto* pass = std::get_if<runtime::Pass>(&action.body)) {
      if (smooths(pass->body)) {
        report(action, fail(diag::NotCertified,
                            std::string("SMOOTH moves the path off the statements behind it; "
                                        "`verify OUTPUT --with PROGRAM` compares it")));
        ++summary_.faults;
        ended_ = gaveUp_ = true;
        break;
      }
      std::string objection;
      order_.apply(pass->body, objection);
      if (!objection.empty()) {
        report(action, fail(diag::NotCertified, objection));
      }
    } else if (const auto* transfer = std::get_if<runtime::Transfer>(&action.body)) {
      index_ = placeOf(transfer->label);
    } else if (std::holds_alternative<runtime::Fini>(action.body)) {
      ended_ = true;
    } else {
      modal_.apply(action);
    }
  }
  return nullptr;
}

std::size_t Association::placeOf(std::uint64_t label) const {
  // The next place with this label, or, where there is none ahead, the last one behind.
  const auto [first, last] = labels_.equal_range(label);
  std::optional<std::size_t> ahead, behind;
  for (auto i = first; i != last; ++i) {
    auto& slot = i->second >= index_ ? ahead : behind;
    slot = !slot                 ? i->second
           : i->second >= index_ ? std::min(*slot, i->second)
                                 : std::max(*slot, i->second);
  }
  return ahead ? *ahead : behind ? *behind : actions_.size();
}

void Association::moveTo(const Location& l) {
  modal_.toolEnd = l.toolEnd;
  modal_.axis = l.axis;
  modal_.positioned = true;
}

void Association::unseen(const Action& action) {
  modal_.startedOffPart = false;
  modal_.startedOffDrive.clear();
  if (const auto* locate = std::get_if<Locate>(&action.body)) {
    if (locate->axis && locate->axis->norm() > tolerance::nullDirection) {
      modal_.axis = locate->axis->normalized();
    }
    if (locate->word != Word::GODLTA) {
      modal_.toolEnd = locate->point;
      modal_.positioned = true;
    } else {
      modal_.toolEnd += locate->axial ? Vec3(*locate->axial * modal_.axis) : locate->point;
    }
    return;
  }
  if (const auto* along = std::get_if<runtime::FollowSpline>(&action.body)) {
    const auto curve = spline::CubicSpline::of(along->curve->canon);
    modal_.positioned = curve.ok();
    modal_.toolEnd = curve ? curve->at(curve->end()) : modal_.toolEnd;
    return;
  }
  if (std::holds_alternative<runtime::Pocket>(action.body)) {
    modal_.positioned = false;
    return;
  }
  modal_.takeAutomaticPart();
  if (const auto* startup = std::get_if<Startup>(&action.body);
      startup && startup->surfaces.size() > 1) {
    if (auto part = named(startup->surfaces[1].surface)) {
      modal_.part = *std::move(part);
    }
  }
  modal_.consumeOneShots();
  modal_.positioned = false;
}

bool Association::numberAhead(int isn) const {
  // A transfer may lead anywhere.
  const auto has = [&](std::size_t from) {
    return std::any_of(actions_.begin() + static_cast<std::ptrdiff_t>(from), actions_.end(),
                       [&](const Action& a) { return a.isn == isn && putsOut(a); });
  };
  return has(labels_.empty() ? index_ : 0);
}

/// A motion for which the file has nothing.
void Association::miss(const Action& action) {
  if (!options_.own) {
    report(action, fail(diag::MotionMissing, options_.file));
  }
  ++summary_.faults;
  unseen(action);
  ++index_;
}

void Association::judge(const Action& action, const Run& run) {
  if (std::holds_alternative<runtime::Pocket>(action.body)) {
    takePocket(action, run);
    return;
  }
  ++index_;
  if (const auto* locate = std::get_if<Locate>(&action.body)) {
    judgeLocate(action, *locate, run);
  } else if (const auto* startup = std::get_if<Startup>(&action.body)) {
    judgeStartup(action, *startup, run);
  } else if (const auto* along = std::get_if<runtime::FollowSpline>(&action.body)) {
    judgeAlong(action, *along, run);
  } else {
    modal_.apply(action);  // CUT puts out where the tool is
    moveTo(pathOf(run).back());
  }
}

std::vector<Location> Association::pathOf(const Run& run) const {
  std::vector<Location> path = run.locations;
  if (!run.withAxis) {
    for (Location& l : path) {
      l.axis = modal_.axis;
    }
  }
  return path;
}

Vec3 Association::wantedBy(const Locate& locate, const Location& from) {
  const bool relative = locate.word == Word::GODLTA;
  return relative ? from.toolEnd + (locate.axial ? Vec3(*locate.axial * from.axis) : locate.point)
                  : locate.point;
}

void Association::judgeLocate(const Action& action, const Locate& locate, const Run& run) {
  const bool known = modal_.positioned;
  modal_.startedOffPart = false;
  modal_.startedOffDrive.clear();
  if (locate.axis && locate.axis->norm() > tolerance::nullDirection) {
    modal_.axis = locate.axis->normalized();
  }
  const Location end = pathOf(run).back();
  const bool relative = locate.word == Word::GODLTA;
  StatementResult result;
  result.origin = action.origin;
  result.isn = action.isn;
  result.statement = arelem::spell(locate.word);
  result.cutVectors = run.locations.size();
  const double away = (end.toolEnd - wantedBy(locate, here())).norm();
  if (!(away <= options_.slack) && (known || !relative)) {
    result.good = false;
    report(action, fail(diag::LocationMoved, away));
  }
  moveTo(end);
  add(std::move(result));
}

void Association::judgeStartup(const Action& action, const Startup& startup, const Run& run) {
  modal_.takeAutomaticPart();
  const Location before{modal_.toolEnd, modal_.axis};
  Location after = pathOf(run).back();
  std::optional<Named> part;
  if (startup.surfaces.size() > 1) {
    if (auto second = named(startup.surfaces[1].surface)) {
      part = *std::move(second);
    }
  }
  auto drive = named(startup.surfaces[0].surface);
  if (!run.withAxis && drive) {
    const std::optional<Named> old = modal_.part;
    modal_.part = part ? part : old;
    after.axis = modal_.axisAt(after.toolEnd, drive->surface);
    modal_.part = old;
  }
  StatementResult result = check_.startup(modal_, action, startup, before, after);
  result.cutVectors = run.locations.size();
  if (part) {
    modal_.part = *std::move(part);
  }
  const bool offDrive = drive && startup.surfaces[0].condition != ir::Condition::on;
  modal_.startedOffDrive = offDrive ? drive->name : "";
  modal_.startedOffPart = part && startup.surfaces[1].condition != ir::Condition::on;
  if (modal_.startedOffPart && modal_.toolOnPart()) {
    modal_.partRelation = Word::TLOFPS;
  }
  modal_.consumeOneShots();
  moveTo(after);
  add(std::move(result));
}

std::optional<Goal> Association::impliedGoal() const {
  std::optional<Word> relation = modal_.driveRelation;
  for (std::size_t i = index_; i < actions_.size(); ++i) {
    const auto& body = actions_[i].body;
    if (const auto* r = std::get_if<runtime::ToolRelation>(&body)) {
      if (r->word != Word::TLONPS && r->word != Word::TLOFPS) {
        relation = r->word;
      }
    } else if (const auto* next = std::get_if<Follow>(&body)) {
      auto surface = named(next->drive);
      if (!surface) {
        return std::nullopt;
      }
      Goal goal{*std::move(surface), ir::Condition::tanto};
      const bool left = next->heading == ir::Heading::left;
      if (left || next->heading == ir::Heading::right) {
        const bool on = !relation || *relation == Word::TLON || *relation == Word::TLNDON;
        goal.condition = on                                   ? ir::Condition::on
                         : (*relation == Word::TLLFT) == left ? ir::Condition::to
                                                              : ir::Condition::past;
      }
      return goal;
    } else if (std::holds_alternative<Startup>(body) || std::holds_alternative<Locate>(body)) {
      break;
    }
  }
  return std::nullopt;
}

std::vector<Goal> Association::goalsOf(const Follow& follow) const {
  std::vector<Goal> goals;
  for (const runtime::CheckUse& c : follow.checks) {
    if (auto surface = named(c.use.surface)) {
      const auto condition =
          c.use.condition == ir::Condition::automatic ? ir::Condition::to : c.use.condition;
      goals.push_back({*std::move(surface), condition, c.nth});
    }
  }
  if (follow.checks.empty()) {
    if (auto goal = impliedGoal()) {
      goals.push_back(*std::move(goal));
    }
  }
  return goals;
}

void Association::judgeCopy(const Run& run) {
  const OutputOrder::Copy wanted = order_.takeCopy();
  const Action& copy = actions_[index_ - 1];
  const std::size_t count = std::min(run.locations.size(), wanted.run.locations.size());
  for (std::size_t i = 0; i < count; ++i) {
    const double away = (run.locations[i].toolEnd - wanted.run.locations[i].toolEnd).norm();
    if (!(away <= options_.slack)) {
      report(copy, fail(diag::CopyMoved, std::uint64_t{i + 1}, wanted.number, away));
      ++summary_.faults;
      return;
    }
  }
  if (run.locations.size() != wanted.run.locations.size()) {
    report(copy, fail(diag::CopyMoved, std::uint64_t{count + 1}, wanted.number, unbounded));
    ++summary_.faults;
  }
}

void Association::finish() {
  if (gaveUp_) {
    return;
  }
  choose(std::nullopt, nullptr);
  judgePocket();
  for (const Action* action = advance(); action != nullptr; action = advance()) {
    miss(*action);
  }
  if (order_.expectsCopy()) {
    report(actions_[index_ - 1], fail(diag::MotionMissing, options_.file));
    ++summary_.faults;
  }
  if (surplus_ > 0) {
    sink_.accept(diagnose(Span{}, diag::SurplusLocations, options_.file, surplus_,
                          firstSurplus_.x(), firstSurplus_.y(), firstSurplus_.z()));
    ++summary_.faults;
  }
}

}  // namespace arelem::certify
