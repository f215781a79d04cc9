#pragma once
#include "frontend/check/blocks.h"
#include "frontend/check/values.h"

namespace arelem::frontend {

/// Jumps and blocks: IF, JUMPTO, TRANTO, LOOPST, and the block forms IF ... THEN, DO, which become
/// branches.
class Control {
 public:
  Control(Context& context, Values& values, BlockWriter& block)
      : context_(context), values_(values), block_(block) {}

  void branch();                                       // IF (e) a, b, c
  void jump(Word word, NodeId argument, bool single);  // JUMPTO, TRANTO
  void loopStart();
  void loopEnd();
  void ifBlock();
  void elseIf();
  void elseWord();
  void endIf();
  void doBlock();
  void endDo();
  /// The end of the program or macro: blocks that are still open are errors.
  void finish();
  [[nodiscard]] bool inDo() const;

 private:
  struct Open {
    bool isDo = false;
    bool elseSeen = false;
    Span span;
    std::vector<Jump> toElse;  // IF: condition false
    std::vector<Jump> toEnd;
    std::uint32_t top = 0;  // DO: where the test begins
    ir::Target counter;
    ir::ExprId step;
    bool broken = false;
    bool wasLenient = false;
  };
  struct Exits {
    std::vector<Jump> whenTrue;
    std::vector<Jump> whenFalse;
  };
  bool labelText(NodeId id, Word word, std::string_view& text);
  bool mayJump(std::string_view word);
  bool condition(NodeId id, Exits& exits);
  bool compare(const Node& node, Exits& exits);
  void openCondition(Open& open);
  void elsePart(Open& open, bool jumpOver);
  Open* innermost(bool isDo, std::string_view end, std::string_view start);
  bool emitTest(Open& open, ir::ExprId last);

  Context& context_;
  Values& values_;
  BlockWriter& block_;
  std::vector<Open> open_;
  bool jumps_ = false;  // IF or JUMPTO stood outside loops and macros
};

}  // namespace arelem::frontend
