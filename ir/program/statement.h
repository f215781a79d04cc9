#pragma once
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ir/program/expr.h"
#include "ir/space/vector.h"

namespace arelem::ir {

/// Where IF, JUMPTO, TRANTO and labelled check surfaces go: a statement of the same block.
struct LabelRef {
  std::uint32_t statement = Id<void>::none;  ///< index into Block::statements
  std::string name;
  Span span;
};

/// How the tool meets a surface. `automatic` where none was written (TO, or by the implied-check
/// rule).
enum class Condition : std::uint8_t { automatic, to, on, past, tanto, pstan };
enum class Heading : std::uint8_t { left, right, forward, back, up, down };

struct Assign {
  Target target;
  ExprId value;
};
struct Define {
  DefinitionId definition;
};
struct Branch {
  ExprId value;
  LabelRef negative, zero, positive;
};
struct Jump {
  LabelRef label;
};
/// Executes a macro instance: the body with the parameters of this CALL substituted.
struct Call {
  BlockId block;
  std::string macro;
};
/// OBTAIN, TYPE/ source, a, b, ...: missing targets are omitted parameters.
struct Obtain {
  EntityType type = EntityType::point;
  Argument source;
  std::vector<std::optional<Target>> targets;
};
/// PARTNO, PPRINT, INSERT, TITLES: text as it stands in columns 7 to 72.
struct Text {
  Word word = Word::PPRINT;
  std::string text;
};
/// FROM, GOTO, GODLTA (also GOTO/pattern with its modifiers).
struct Locate {
  Word word = Word::GOTO;
  std::vector<Argument> arguments;
};
/// GOTO or FROM with plain numbers only: the fast lane for CL files.
struct LocateNumbers {
  Word word = Word::GOTO;
  std::uint8_t count = 0;
  std::array<double, 10> numbers{};  ///< x y z, axis i j k, side u v w, feed
};
struct SurfaceUse {
  Condition condition = Condition::automatic;
  Argument surface;
  Span conditionSpan;
};
/// GO/ and OFFSET/: drive, part, check surface in this order.
struct Startup {
  bool offset = false;
  std::vector<SurfaceUse> surfaces;
  ExprId feed;
};
struct CheckUse {
  SurfaceUse use;
  ExprId nth;
  std::optional<LabelRef> label;
};
/// GOLFT ... GODOWN: no check surface means that the next motion's drive surface is implied.
struct Follow {
  Heading heading = Heading::forward;
  Argument drive;
  std::vector<CheckUse> checks;
  ExprId feed;
};
struct Transfer {
  LabelRef label;
};  ///< TRANTO
struct Fini {};
/// Every other statement: WORD or WORD/ parameters (post words, ARELEM parameters and switches,
/// tool positions, REFSYS, ZSURF, CANON, PRINT, TRACUT, COPY, run control, ...). `slash` tells
/// WORD/ from WORD.
struct Command {
  Word word = Word::END;
  bool slash = false;
  std::vector<Argument> arguments;
};
/// A post statement whose major word is not in the vocabulary: passed on as it stands.
struct ForeignCommand {
  std::string word;
  bool slash = false;
  std::vector<Argument> arguments;
};

using Body = std::variant<Assign,
                          Define,
                          Branch,
                          Jump,
                          Call,
                          Obtain,
                          Text,
                          Locate,
                          LocateNumbers,
                          Startup,
                          Follow,
                          Transfer,
                          Fini,
                          Command,
                          ForeignCommand>;

/// One statement. Prefix words (RAPID, TLLFT, ...) of a motion are statements of their own before
/// it, with the same isn. A statement that failed to parse is absent, its diagnostic reported.
struct Statement {
  Span span;
  std::uint32_t isn = 0;  ///< internal statement number, from 1, as the old listing counts
  std::string cardId;     ///< columns 73-80, "" when blank
  std::string label;      ///< "" when none
  Body body;
};

}  // namespace arelem::ir
