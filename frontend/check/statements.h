#pragma once
#include "frontend/check/control.h"

namespace arelem::frontend {

/// Statements that begin with a word, except control and macros: one head word and its parameters.
class Statements {
 public:
  Statements(Context& context, Values& values, BlockWriter& block, Control& control)
      : context_(context), values_(values), block_(block), control_(control) {}

  /// [prefix word ,] ... WORD [/ parameters]
  void command();
  void assign();
  void define();

 private:
  struct Parts {
    Word word = Word::END;
    Span span;  ///< of the word
    bool slash = false;
    NodeId first = noNode;
  };
  bool prefixes(Parts& main);
  void dispatch(const Parts& p);
  void motion(const Parts& p);
  void termac(const Parts& p);
  void plain(const Parts& p, ArgumentRules rules);
  void units(const Parts& p);
  void postWord(const Parts& p);
  void locate(const Parts& p);
  void startup(const Parts& p);
  void follow(const Parts& p);
  void obtain(const Parts& p);
  void reserv(const Parts& p);
  void refsys(const Parts& p);
  void surfaceOrNumbers(const Parts& p);
  void print(const Parts& p);
  void pocket(const Parts& p);
  void fini(const Parts& p);
  void unnamed(const Parts& p);
  void runControl(const Parts& p);

  bool numbersOnly(const Parts& p, std::vector<ir::Argument>& list);
  bool checkPostArguments(const Parts& p, const std::vector<ir::Argument>& list);
  bool obtainTargets(NodeId first, ir::Obtain& obtain);
  bool reservPair(const Node& name, const Node& size);
  bool takeSuffix(std::vector<ir::Argument>& list, Word& suffix) const;
  void emitCommand(const Parts& p, std::vector<ir::Argument> list);

  Context& context_;
  Values& values_;
  BlockWriter& block_;
  Control& control_;
};

}  // namespace arelem::frontend
