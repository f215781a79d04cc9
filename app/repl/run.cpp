#include "app/repl/run.h"

#include <algorithm>
#include <array>

#include "ir/diag/frontend.h"
#include "ir/diag/interpret.h"
#include "ir/diag/motion.h"

namespace arelem::app::repl {

namespace {
template <std::size_t n>
bool isOneOf(const Diagnostic& d, const std::array<const DiagRow*, n>& rows) {
  return std::find(rows.begin(), rows.end(), d.row) != rows.end();
}

/// What says that more is to come.
bool isOpen(const Diagnostic& d) {
  static const std::array rows = {diag::NothingToContinue.row, diag::LoopNotEnded.row,
                                  diag::MacroNotEnded.row, diag::BlockNotEnded.row};
  return isOneOf(d, rows);
}

bool isWaiting(const Diagnostic& d) {
  static const std::array rows = {diag::ImpliedAtEnd.row, diag::ImpliedCheckPending.row};
  return isOneOf(d, rows);
}

bool isError(const Diagnostic& d) {
  return d.severity() == Severity::error;
}

bool isKnown(const Diagnostic& d, const Run* before) {
  if (d.row == diag::FiniMissing.row) {
    return true;
  }
  if (before == nullptr) {
    return false;
  }
  const std::vector<Diagnostic>& known = before->job.log.all();
  return std::any_of(known.begin(), known.end(), [&](const Diagnostic& k) {
    return k.row == d.row && k.at == d.at && k.message == d.message;
  });
}

/// Whether a line cannot be read whatever stands around it; other errors of an open block are
/// judged when it is closed.
bool isUnreadable(const Diagnostic& d) {
  static const std::array rows = {diag::BadStatementStart.row, diag::UnmatchedClose.row,
                                  diag::UnmatchedOpen.row,     diag::EndsWithPunctuation.row,
                                  diag::AdjacentOperators.row, diag::OperatorExpected.row,
                                  diag::EmptyParentheses.row};
  return isError(d) && !isOpen(d) && (d.kind().code < "E0116" || isOneOf(d, rows));
}

bool moves(const runtime::Action& action) {
  return !std::holds_alternative<runtime::Label>(action.body) &&
         !std::holds_alternative<runtime::Fini>(action.body);
}

void findNew(const Run& run, const Run* before, Verdict& verdict) {
  for (const Diagnostic& d : run.job.log.all()) {
    if (!isKnown(d, before)) {
      verdict.found.push_back(d);
    }
  }
}

void judge(Run& run, Verdict& verdict, const InterruptFlag& interrupted) {
  std::vector<Diagnostic>& found = verdict.found;
  using State = Verdict::State;
  if (interrupted) {
    verdict.state = State::interrupted;
  } else if (std::any_of(found.begin(), found.end(), isUnreadable)) {
    verdict.state = State::refused;
    verdict.unreadable = true;
    std::erase_if(found, isOpen);  // the end may still come
  } else if (std::any_of(found.begin(), found.end(), isOpen)) {
    verdict.state = State::open;
  } else if (std::any_of(found.begin(), found.end(),
                         [](const Diagnostic& d) { return isError(d) && !isWaiting(d); })) {
    verdict.state = State::refused;
  }
  if (verdict.state == State::good) {
    const auto& all = run.job.log.all();  // what waited before still does
    const auto waits = std::find_if(all.begin(), all.end(), isWaiting);
    if (waits != all.end()) {
      run.waiting = waits->calledFrom.empty() ? waits->at : waits->calledFrom.back();
    }
    std::erase_if(found, isWaiting);
  }
}

void findPath(Run& run, const Run* before, const InterruptFlag& interrupted) {
  const auto& actions = run.job.evaluation.actions;
  const bool same = before != nullptr && !before->waiting &&
                    before->job.evaluation.actions.size() == actions.size();
  if (same) {
    run.path = before->path;
    run.job.motion = before->job.motion;
    return;
  }
  if (std::none_of(actions.begin(), actions.end(), moves)) {
    return;
  }
  auto path = std::make_shared<cl::Recording>();
  static_cast<void>(execute(run.job, *path, interrupted));
  run.path = std::move(path);
}
}  // namespace

Verdict carryOut(Run& run,
                 const Run* before,
                 const std::string& name,
                 std::string text,
                 const InterruptFlag& interrupted) {
  Verdict verdict;
  const bool read = load(run.job, name, std::move(text), interrupted);
  findNew(run, before, verdict);
  judge(run, verdict, interrupted);
  if (!read || verdict.state != Verdict::State::good) {
    verdict.state = verdict.state == Verdict::State::good ? Verdict::State::refused : verdict.state;
    return verdict;
  }
  static_cast<void>(evaluate(run.job, interrupted, true));
  verdict.found.clear();
  findNew(run, before, verdict);
  judge(run, verdict, interrupted);
  if (verdict.state == Verdict::State::good) {
    findPath(run, before, interrupted);
    verdict.found.clear();
    findNew(run, before, verdict);
    judge(run, verdict, interrupted);
  }
  return verdict;
}

}  // namespace arelem::app::repl
