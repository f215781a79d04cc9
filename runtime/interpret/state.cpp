#include "runtime/interpret/state.h"

#include <cmath>

#include "ir/diag/interpret.h"
#include "ir/diag/limits.h"
#include "runtime/interpret/expression.h"
#include "runtime/interpret/ignored.h"

namespace arelem::runtime {
Diagnostic noEffect(const Ignored& ignored) {
  return diagnose(ignored.first, diag::NoEffect, ignored.what, ignored.why, ignored.times,
                  ignored.times == 1 ? "" : "s");
}
}  // namespace arelem::runtime

namespace arelem::runtime::interpret {

State::State(const ir::Program& p, const Options& o, DiagnosticSink& sink, Evaluation& evaluation)
    : program(p), options(o), out(evaluation), store(p, o.limits, o.history), sink_(sink) {
  context.files = &options.files;
  context.mostCorners = options.limits.corners;
  if (options.carried != nullptr) {
    carried = *options.carried;
    multax = carried.multax;
  }
  for (const ir::Symbol& symbol : program.symbols) {
    if (symbol.arraySize > options.limits.array) {
      report(diagnose(symbol.definition, diag::LimitArray, symbol.name, symbol.arraySize,
                      options.limits.array));
    }
  }
}

void State::report(Diagnostic diagnostic) {
  if (!reported_.emplace(diagnostic.row, diagnostic.at).second) {
    return;
  }
  for (const CallChain* call = calls.get(); call != nullptr; call = call->outer.get()) {
    diagnostic.calledFrom.push_back(call->call);
  }
  sink_.accept(std::move(diagnostic));
}

std::optional<Place> State::place(const ir::Target& target) {
  const std::uint32_t size = store.arraySize(target.symbol);
  if (!target.subscript.valid()) {
    if (size == 0) {
      return store.place(target.symbol, 0);
    }
    report(diagnose(target.span, diag::ElementMissing, program[target.symbol].name, size));
    return std::nullopt;
  }
  if (size == 0) {
    report(diagnose(target.span, diag::ArrayNotReserved, program[target.symbol].name));
    return std::nullopt;
  }
  const std::optional<double> value = scalar(*this, target.subscript);
  if (!value) {
    return std::nullopt;
  }
  const double element = std::trunc(*value);
  if (element < 1.0 || element > size) {
    report(
        diagnose(target.span, diag::SubscriptOutside, program[target.symbol].name, *value, size));
    return std::nullopt;
  }
  return store.place(target.symbol, static_cast<std::uint32_t>(element));
}

std::string State::spellPlace(const Place& place) const {
  const std::string& name = program[place.symbol].name;
  return place.element == 0 ? name : fmt::format("{}({})", name, place.element);
}

bool State::assignedSomewhere(ir::SymbolId symbol) {
  if (assigned_.empty()) {
    assigned_.resize(program.symbols.size());
    const auto mark = [this](const ir::Target& target) {
      if (target.symbol.valid()) {
        assigned_[target.symbol.index] = true;
      }
    };
    for (const ir::Definition& definition : program.definitions) {
      mark(definition.target);
    }
    for (const ir::Expr& expr : program.exprs) {
      if (expr.kind == ir::Expr::Kind::assign) {
        mark(expr.target);
      }
    }
    for (const ir::Block& block : program.blocks) {
      for (const ir::Statement& s : block.statements) {
        if (const auto* assign = std::get_if<ir::Assign>(&s.body)) {
          mark(assign->target);
        } else if (const auto* obtain = std::get_if<ir::Obtain>(&s.body)) {
          for (const std::optional<ir::Target>& target : obtain->targets) {
            if (target) {
              mark(*target);
            }
          }
        }
      }
    }
  }
  return assigned_[symbol.index];
}

void State::reportEmpty(const Place& place, const Span& span) {
  // A name that no statement assigns lost its definition to an error of the frontend.
  if (assignedSomewhere(place.symbol)) {
    report(diagnose(span, diag::NoValue, spellPlace(place)));
  }
  store.poison(place);
}

void State::trace(std::string text) {
  if (out.trace.size() >= options.limits.records) {
    report(diagnose(statement->span, diag::LimitRecords, options.limits.records));
    stopped = true;
    return;
  }
  int depth = 0;
  for (const CallChain* call = calls.get(); call != nullptr; call = call->outer.get()) {
    ++depth;
  }
  out.trace.push_back({statement->span, depth, std::move(text)});
}

void State::ignore(std::string what, std::string why) {
  for (Ignored& known : out.ignored) {
    if (known.what == what) {
      ++known.times;
      return;
    }
  }
  out.ignored.push_back({std::move(what), std::move(why), statement->span, 1});
}

void State::reportIgnored() {
  for (const Ignored& known : out.ignored) {
    sink_.accept(noEffect(known));
  }
}

void State::meetImplied(std::string_view next, bool axial, bool positioning) {
  if (implied_ == nullptr) {
    return;
  }
  if (axial || positioning) {
    Diagnostic d = axial ? diagnose(implied_->span, diag::ImpliedBeforeAxial, next)
                         : diagnose(implied_->span, diag::ImpliedBeforePositioning, next);
    report(std::move(d).label(statement->span, "the next motion"));
  }
  implied_ = nullptr;
}

void State::endImplied() {
  if (implied_ != nullptr) {
    report(diagnose(implied_->span, diag::ImpliedAtEnd));
    implied_ = nullptr;
  }
}

void State::warnOfSystem() {
  if (!systems.atBase() && warnedSystems_.insert(systems.current()).second) {
    report(diagnose(statement->span, diag::MotionInSystem, systems.current()));
  }
}

/// No action looks over FROM, GOTO or GODLTA but CUTTER.
void State::handOver() {
  const Action::Body& last = out.actions.back().body;
  if (const auto* parameter = std::get_if<Parameter>(&last)) {
    newCutter_ = newCutter_ || parameter->word == Word::CUTTER;
  } else if (std::holds_alternative<Startup>(last) || std::holds_alternative<Follow>(last) ||
             std::holds_alternative<Pocket>(last)) {
    newCutter_ = false;
  }
  const auto* place = std::get_if<Locate>(&last);
  if (place == nullptr || newCutter_ || out.actions.size() < pieceSize) {
    return;
  }
  before = *place;
  handed_ += out.actions.size();
  piece(out.actions);
  if (!out.actions.empty()) {
    handed_ -= out.actions.size();
    piece = nullptr;
  }
}

void State::tooManyActions() {
  if (!stopped) {
    report(diagnose(statement->span, diag::LimitRecords, options.limits.records));
    stopped = true;
  }
}

}  // namespace arelem::runtime::interpret
