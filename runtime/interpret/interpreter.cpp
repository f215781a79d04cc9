#include "runtime/interpret/interpreter.h"

#include <algorithm>

#include "ir/diag/interpret.h"
#include "ir/diag/limits.h"
#include "runtime/interpret/command.h"
#include "runtime/interpret/definition.h"
#include "runtime/interpret/expression.h"
#include "runtime/interpret/motion.h"
#include "runtime/interpret/printing.h"

namespace arelem::runtime::interpret {

namespace {
/// Statements between two looks at the interrupt flag: well under a millisecond.
constexpr std::uint64_t pollMask = 0x3FF;

template <class... Ts>
struct Overloaded : Ts... {
  using Ts::operator()...;
};
template <class... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;
}  // namespace

Interpreter::Interpreter(const ir::Program& program,
                         const Options& options,
                         DiagnosticSink& sink,
                         Evaluation& out)
    : state_(program, options, sink, out) {
  findTargets();
}

void Interpreter::handOver(const PieceCall& piece) {
  const bool hasTargets = std::ranges::any_of(isTarget_, [](const std::vector<bool>& targets) {
    return std::ranges::find(targets, true) != targets.end();
  });
  state_.piece = hasTargets ? PieceCall() : piece;
}

void Interpreter::findTargets() {
  for (const ir::Block& block : state_.program.blocks) {
    std::vector<bool>& targets = isTarget_.emplace_back(block.statements.size());
    jumpsBack_.emplace_back(block.statements.size());
    const auto mark = [&targets](const ir::LabelRef& label) {
      if (label.statement < targets.size()) {
        targets[label.statement] = true;
      }
    };
    for (const ir::Statement& statement : block.statements) {
      if (const auto* transfer = std::get_if<ir::Transfer>(&statement.body)) {
        mark(transfer->label);
      } else if (const auto* follow = std::get_if<ir::Follow>(&statement.body)) {
        for (const ir::CheckUse& check : follow->checks) {
          if (check.label) {
            mark(*check.label);
          }
        }
      }
    }
  }
}

void Interpreter::run() {
  if (state_.program.blocks.empty()) {
    return;
  }
  state_.out.actions.reserve(std::min<std::uint64_t>(state_.program.blocks[0].statements.size() + 1,
                                                     state_.options.limits.records));
  frames_.push_back({ir::BlockId{0}, 0, nullptr});
  while (!frames_.empty() && !finished_) {
    Frame& frame = frames_.back();
    const std::vector<ir::Statement>& statements = state_.program[frame.block].statements;
    if (frame.next >= statements.size()) {
      frames_.pop_back();
      if (!frames_.empty()) {
        state_.calls = frames_.back().calls;
      }
      continue;
    }
    const ir::Statement& statement = statements[frame.next];
    state_.statement = &statement;
    if (!mayGoOn()) {
      break;
    }
    if (isTarget_[frame.block.index][frame.next]) {
      state_.emit(Label{std::uint64_t{frame.block.index} << 32U | frame.next});
    }
    ++frame.next;
    step(frame, statement);
  }
  finish();
}

bool Interpreter::mayGoOn() {
  if (state_.stopped) {
    return false;
  }
  if (steps_ >= state_.options.limits.steps) {
    reportSteps();
    state_.stopped = true;
    return false;
  }
  const InterruptFlag* flag = state_.options.interrupted;
  if ((steps_ & pollMask) == 0 && flag != nullptr && flag->load(std::memory_order_relaxed)) {
    state_.report(diagnose(state_.statement->span, diag::EvaluationInterrupted, steps_));
    state_.stopped = true;
    return false;
  }
  ++steps_;
  return true;
}

void Interpreter::reportSteps() {
  Diagnostic d = diagnose(state_.statement->span, diag::LimitSteps, state_.options.limits.steps);
  // The loop is the label that was jumped back to most often.
  const ir::Statement* loop = nullptr;
  std::uint64_t turns = 0;
  for (std::size_t b = 0; b < jumpsBack_.size(); ++b) {
    for (std::size_t s = 0; s < jumpsBack_[b].size(); ++s) {
      if (jumpsBack_[b][s] > turns) {
        turns = jumpsBack_[b][s];
        loop = &state_.program.blocks[b].statements[s];
      }
    }
  }
  if (loop != nullptr) {
    d.labels.push_back(
        {loop->span, fmt::format("the loop from `{}` went round {} times", loop->label, turns)});
  }
  state_.report(std::move(d));
}

void Interpreter::step(Frame& frame, const ir::Statement& statement) {
  std::visit(
      Overloaded{
          [&](const ir::Branch& b) { branch(frame, b); },
          [&](const ir::Jump& j) {
            if (state_.tracing) {
              state_.trace("JUMPTO" + wayTo(frame, j.label));
            }
            jump(frame, j.label);
          },
          [&](const ir::Call& c) { call(c); },
          [&](const ir::Transfer& t) {
            state_.emit(Transfer{std::uint64_t{frame.block.index} << 32U | t.label.statement});
          },
          [&](const ir::Follow& f) { execute(state_, f, frame.block); },
          [&](const ir::Fini&) {
            state_.endImplied();
            state_.emit(Fini{});
            finished_ = true;
          },
          [&](const auto& other) { execute(state_, other); },
      },
      statement.body);
}

void Interpreter::branch(Frame& frame, const ir::Branch& b) {
  // Without a value no way is the right one: execution goes on behind the IF.
  if (const std::optional<double> value = compared(state_, b.value)) {
    const ir::LabelRef& way = *value < 0.0 ? b.negative : *value == 0.0 ? b.zero : b.positive;
    if (state_.tracing) {
      state_.trace(fmt::format("IF {}{}", *value, wayTo(frame, way)));
    }
    jump(frame, way);
  }
}

std::string Interpreter::wayTo(const Frame& frame, const ir::LabelRef& label) const {
  const auto& statements = state_.program[frame.block].statements;
  const bool known = label.statement < statements.size();
  return known && !statements[label.statement].label.empty()
             ? " goes on at " + statements[label.statement].label
             : " goes on";
}

void Interpreter::jump(Frame& frame, const ir::LabelRef& label) {
  if (label.statement >= state_.program[frame.block].statements.size()) {
    return;  // the frontend has reported the label
  }
  if (label.statement < frame.next) {
    ++jumpsBack_[frame.block.index][label.statement];
  }
  frame.next = label.statement;
}

void Interpreter::call(const ir::Call& c) {
  if (frames_.size() > state_.options.limits.depth) {
    state_.report(diagnose(state_.statement->span, diag::CallDepth, c.macro, frames_.size(),
                           state_.options.limits.depth));
    return;
  }
  if (!c.block.valid()) {
    return;  // the frontend has reported the macro
  }
  if (state_.tracing) {
    state_.trace(fmt::format("CALL {}", c.macro));
  }
  state_.calls = std::make_shared<const CallChain>(CallChain{state_.statement->span, state_.calls});
  frames_.push_back({c.block, 0, state_.calls});
}

void Interpreter::finish() {
  state_.out.steps = steps_;
  if (state_.options.carried != nullptr) {
    state_.carried.multax = state_.multax;
    *state_.options.carried = state_.carried;
  }
  state_.out.complete = !state_.stopped;
  if (!state_.stopped) {
    state_.endImplied();
  }
  state_.reportIgnored();
  state_.out.defined = state_.store.defined();
  state_.out.history = state_.store.history();
}

}  // namespace arelem::runtime::interpret
