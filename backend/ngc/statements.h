#pragma once
#include <set>
#include <string>

#include "backend/ngc/block.h"
#include "backend/ngc/moves.h"
#include "backend/ngc/parameters.h"
#include "ir/diag/diagnostic.h"

namespace arelem::backend::ngc {

/// The statements for the machine that move no axis: spindle, coolant, tools, waits, stops. Each
/// parameter is written, or told: an error where the machine would do something else than the
/// statement says, else a warning and a comment.
class Statements {
 public:
  Statements(BlockWriter& block, const Control& control, Moves& moves, DiagnosticSink& sink)
      : block_(block), control_(control), moves_(moves), sink_(sink) {}

  /// A statement that the writer itself does not take.
  void accept(const cl::Post& post, const Span& origin);
  /// A comment and a warning, once for each word.
  void ignored(std::string_view word, std::string_view statement, const Span& origin);

 private:
  void line(std::string_view code);
  void refuse(const cl::Post& post, std::string why);
  void passed(std::string text);
  void spindle(const cl::Post& post);
  void coolant(const cl::Post& post);
  void compensation(const cl::Post& post);
  void delay(const cl::Post& post);
  void function(const cl::Post& post);
  void tool(const cl::Post& post);
  void nextTool(const cl::Post& post);
  void spray(const cl::Post& post);

  BlockWriter& block_;
  const Control& control_;
  Moves& moves_;
  DiagnosticSink& sink_;
  Span origin_;
  bool counter_ = false;  // the spindle turns counterclockwise
  std::set<std::string> warned_;
};

}  // namespace arelem::backend::ngc
