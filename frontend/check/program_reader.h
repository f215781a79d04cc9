#pragma once
#include <set>

#include "frontend/check/statements.h"
#include "frontend/expand/library.h"
#include "frontend/expand/macro.h"
#include "frontend/lex/lexer.h"
#include "frontend/parse/parse.h"
#include "frontend/read/card_reader.h"

namespace arelem::frontend {

/// One compilation: reads the cards of a program and of what it includes, and builds the checked
/// program.
class ProgramReader {
 public:
  ProgramReader(SourceMap& sources, const Options& options, Reporter& reporter);
  ir::Program run(BufferId buffer);

 private:
  /// What belongs to one block that is being written.
  struct Frame {
    Frame(Context& context, ir::BlockId id, BlockWriter::Area area)
        : values(context),
          block(context, id, area),
          control(context, values, block),
          statements(context, values, block, control) {
      values.setTree(tree);
    }
    StatementTree tree;
    Values values;
    BlockWriter block;
    Control control;
    Statements statements;
  };

  // program_reader.cpp
  bool checkBuffer(BufferId buffer);
  void readBuffer(BufferId buffer, Frame& frame);
  void readStatement(CardReader& reader, const StatementText& statement, Frame& frame);
  void emitFrame(const StatementText& statement, Frame& frame);
  void emitText(const StatementText& statement, Frame& frame);
  void afterFini(CardReader& reader);
  void finish(Frame& frame);
  void applyDefines(Frame& frame);
  bool replaceByDefine(Frame& frame);

  // lower.cpp
  void lower(const std::vector<Token>& tokens, Frame& frame);
  void lowerShape(Frame& frame);
  void lowerLabel(const std::vector<Token>& tokens, std::size_t& first, Frame& frame);
  bool checkHead(const std::vector<Token>& tokens, std::size_t first);
  void unknownHead(const Token& head);
  std::optional<Diagnostic> unknownType(const std::vector<Token>& tokens,
                                        std::size_t first,
                                        bool mayDivide);
  void poison(const std::vector<Token>& tokens, bool noType = false);
  void unknownSynonym(const Token& name, const Token& word);
  void synonyms(const std::vector<Token>& tokens, std::size_t first, Frame& frame);
  void library(Frame& frame);
  void include(Frame& frame);
  bool readSegment(Frame& frame);

  // macros.cpp
  bool record(const StatementText& statement, const std::vector<Token>& tokens);
  void recordForbidden(const Token& head, const Token& next);
  void beginMacro(Frame& frame);
  void addVariable(Macro& macro, const Node& node, const StatementTree& tree);
  void call(Frame& frame);
  Macro* findMacro(const Node& name);
  bool loadMacro(const std::string& name, const Span& at);
  bool bindValues(const StatementTree& tree,
                  const Macro& macro,
                  std::map<std::string_view, Token>& values);
  bool valueToken(const Node& node, const StatementTree& tree, Token& token);
  ir::BlockId instantiate(Macro& macro,
                          const std::map<std::string_view, Token>& values,
                          const Span& at);
  void checkUncalled();

  // foreign.cpp
  bool lowerClMotion(const StatementText& statement, Frame& frame);
  bool lowerForeign(const StatementText& statement, Frame& frame);

  // deck.cpp
  void readDeck(Frame& frame);
  bool deckLine(std::string_view line, const Span& at, Frame& frame);

  Context context_;
  Lexer lexer_;
  StatementParser parser_;
  Library library_;
  MacroTable macros_;
  std::set<std::string, std::less<>> libraryNames_;
  std::map<std::string, ir::BlockId> instances_;
  std::map<std::string, double> pendingDefines_;
  std::vector<Token> tokens_;
  Macro* recording_ = nullptr;
  std::size_t nestedMacros_ = 0;
  CardReader* reader_ = nullptr;  ///< the innermost open text
  BufferId buffer_;
  std::uint32_t isn_ = 1;
  bool finished_ = false;
  bool anyStatement_ = false;  ///< that is not blank
};

}  // namespace arelem::frontend
