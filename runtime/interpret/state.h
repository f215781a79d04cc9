#pragma once
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "runtime/define/define.h"
#include "runtime/interpret/store.h"
#include "runtime/interpret/systems.h"
#include "runtime/pieces.h"

namespace arelem::runtime::interpret {

/// Everything that changes while Section 1 runs, and the way out for actions and diagnostics.
class State {
 public:
  State(const ir::Program& program, const Options& options, DiagnosticSink& sink, Evaluation& out);

  const ir::Program& program;
  const Options& options;
  Evaluation& out;
  Store store;
  Systems systems;
  define::Context context;   ///< ZSURF, unit and data files, as definitions see them
  bool redefinable = false;  ///< CANON/ON
  bool listing = false;      ///< PRINT/ON
  bool tracing = false;      ///< DEBUG/SEC1 or DEBUG/ON
  bool multax = false;       ///< MULTAX
  Carried carried;           ///< what CL text says once

  const ir::Statement* statement = nullptr;  ///< the one being executed
  std::shared_ptr<const CallChain> calls;
  bool stopped = false;          ///< a limit or an interrupt ended the run
  PieceCall piece;               ///< empty where all actions are kept
  std::optional<Locate> before;  ///< with which the last piece ended

  /// Reports with the active CALLs. The same kind at the same place is reported once, so that a
  /// loop does not repeat it for every turn.
  void report(Diagnostic diagnostic);
  void reportFailure(const Span& at, Failure failure) {
    report(arelem::at(at, std::move(failure)));
  }

  template <class Body>
  void emit(Body body) {
    if (handed_ + out.actions.size() >= options.limits.records) {
      tooManyActions();
      return;
    }
    Action& action = out.actions.emplace_back();
    action.origin = statement->span;
    action.isn = static_cast<int>(statement->isn);
    action.cardId = statement->cardId;
    action.calls = calls;
    action.body = std::move(body);
    if (piece) {
      handOver();
    }
  }

  /// The place of a name, its subscript evaluated and checked.
  [[nodiscard]] std::optional<Place> place(const ir::Target& target);
  /// The name as it is written in messages: "A" or "A(3)".
  [[nodiscard]] std::string spellPlace(const Place& place) const;
  /// Reports a use of a name without a value, once, and poisons it.
  void reportEmpty(const Place& place, const Span& span);

  /// Keeps what the statement did, where DEBUG asks for it; look at `tracing` before the text is
  /// made.
  void trace(std::string text);

  /// Counts a statement that has no effect here; `reportIgnored` tells of all of them at the end.
  void ignore(std::string what, std::string why);
  void reportIgnored();

  /// Implied check surfaces (spec 4.8): `follow` waits for the motion that supplies it.
  void expectImplied() { implied_ = statement; }
  void meetImplied(std::string_view next, bool axial, bool positioning);
  void endImplied();
  /// Warns once a system that motion inside REFSYS is moved to the base system.
  void warnOfSystem();

 private:
  void tooManyActions();
  void handOver();
  [[nodiscard]] bool assignedSomewhere(ir::SymbolId symbol);

  DiagnosticSink& sink_;
  std::set<std::pair<const DiagRow*, Span>> reported_;
  std::vector<bool> assigned_;  // by symbol; empty until first needed
  const ir::Statement* implied_ = nullptr;
  std::size_t handed_ = 0;  // actions that pieces took away
  bool newCutter_ = false;  // CUTTER is judged by the motions behind it
  std::set<std::string> warnedSystems_;
};

}  // namespace arelem::runtime::interpret
