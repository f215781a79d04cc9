#pragma once
#include <vector>

#include "runtime/interpret/state.h"

namespace arelem::runtime::interpret {

/// Executes the blocks of a program statement by statement, with its own stack of active CALLs.
class Interpreter {
 public:
  Interpreter(const ir::Program& program,
              const Options& options,
              DiagnosticSink& sink,
              Evaluation& out);
  void run();
  /// Hands finished actions over, where no motion goes on at a label.
  void handOver(const PieceCall& piece);

 private:
  struct Frame {
    ir::BlockId block;
    std::uint32_t next = 0;
    std::shared_ptr<const CallChain> calls;  // those active in this block
  };

  void findTargets();
  [[nodiscard]] bool mayGoOn();
  void step(Frame& frame, const ir::Statement& statement);
  /// How a trace tells where a jump leads.
  [[nodiscard]] std::string wayTo(const Frame& frame, const ir::LabelRef& label) const;
  void jump(Frame& frame, const ir::LabelRef& label);
  void branch(Frame& frame, const ir::Branch& branch);
  void call(const ir::Call& call);
  void finish();
  void reportSteps();

  State state_;
  std::vector<Frame> frames_;
  std::vector<std::vector<bool>> isTarget_;  // of TRANTO or a check, by block and statement
  std::vector<std::vector<std::uint64_t>> jumpsBack_;  // backward jumps to a statement, by block
  std::uint64_t steps_ = 0;
  bool finished_ = false;
};

}  // namespace arelem::runtime::interpret
