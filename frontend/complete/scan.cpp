#include "frontend/complete/scan.h"

#include <algorithm>

namespace arelem::frontend {

namespace {
using enum TokenKind;
using define::Symbol;

/// One open parenthesis, or the statement itself.
struct Level {
  enum class Kind : std::uint8_t { open, definition, statement, function, subscript };
  Kind kind = Kind::open;
  Word word = Word::END;
  bool value = false;  ///< behind `=`
  std::vector<Symbol> given;
  std::optional<Symbol> current;  ///< the parameter being written
  bool operation = false;         ///< an operator came last

  void restart() {
    const bool keep = kind == Kind::function || kind == Kind::subscript;
    kind = keep ? kind : Kind::open;
    given.clear();
    current.reset();
    operation = false;
  }
};

class Scan {
 public:
  explicit Scan(std::span<const KnownName> names) : names_(names) {}

  void token(const Token& t) {
    Level& level = levels_.back();
    switch (t.kind) {
      case comma:
        separate(level);
        break;
      case slash:
        slashBehind(level);
        break;
      case equals:
        level.restart();
        level.value = true;
        break;
      case leftParen:
        open();
        break;
      case rightParen:
        close();
        break;
      case plus:
      case minus:
      case star:
      case power:
        level.operation = true;
        level.current = Symbol::scalar();
        break;
      default:
        level.current = level.operation ? Symbol::scalar() : symbolOf(t);
        level.operation = false;
    }
    last_ = t;
  }

  [[nodiscard]] Place place() const {
    const Level& level = levels_.back();
    Place place;
    place.given = level.given;
    place.word = level.word;
    place.definition = level.kind == Level::Kind::definition;
    const bool afterName = level.current.has_value() && !level.operation;
    if (afterName) {
      place.kind = Place::Kind::nothing;
    } else if (level.operation) {
      place.kind = Place::Kind::expression;
    } else if (level.kind == Level::Kind::definition || level.kind == Level::Kind::statement) {
      place.kind = level.word == Word::CALL ? Place::Kind::macroName
                   : level.word == Word::JUMPTO || level.word == Word::TRANTO ? Place::Kind::label
                   : level.word == Word::RESERV ? Place::Kind::nothing  // new names, whole numbers
                                                : Place::Kind::parameter;
    } else if (level.kind == Level::Kind::function) {
      place.kind = Place::Kind::functionArgument;
    } else if (level.kind == Level::Kind::subscript) {
      place.kind = Place::Kind::subscript;
    } else if (level.value || levels_.size() > 1) {
      place.kind = condition_ && levels_.size() == 2 ? Place::Kind::expression : Place::Kind::value;
    } else {
      place.kind = condition_ ? Place::Kind::label
                   : chained_ ? Place::Kind::motion
                              : Place::Kind::head;
    }
    return place;
  }

 private:
  [[nodiscard]] Symbol symbolOf(const Token& t) const {
    if (t.kind == number) {
      return Symbol::scalar();
    }
    if (t.kind == string) {
      return Symbol::text();
    }
    if (isWordKind(t.kind)) {
      return Symbol::of(t.word);
    }
    const auto known = std::find_if(names_.begin(), names_.end(),
                                    [&](const KnownName& n) { return n.name == t.text; });
    return known != names_.end() && known->kind == KnownName::Kind::entity ? Symbol::of(known->type)
                                                                           : Symbol::scalar();
  }

  void separate(Level& level) {
    const bool inStatement = level.kind == Level::Kind::open && levels_.size() == 1;
    if (inStatement && !level.value) {  // RAPID, GOTO/ ...: the next word is a head again
      level.current.reset();
      chained_ = true;
    } else {
      level.given.push_back(level.current.value_or(Symbol::empty()));
      level.current.reset();
    }
    level.operation = false;
  }

  /// `/` behind a word begins its parameters; else it divides.
  void slashBehind(Level& level) {
    const bool word = isWordKind(last_.kind) && level.kind == Level::Kind::open;
    if (!word) {
      level.operation = true;
      level.current = Symbol::scalar();
      return;
    }
    level.kind = last_.kind == TokenKind::type ? Level::Kind::definition : Level::Kind::statement;
    level.word = last_.word;
    level.given.clear();
    level.current.reset();
  }

  void open() {
    Level level;
    if (last_.kind == TokenKind::function) {
      level.kind = Level::Kind::function;
      level.word = last_.word;
    } else if (last_.kind == symbol) {
      level.kind = Level::Kind::subscript;
    } else if (last_.kind == ifWord) {
      condition_ = true;
    }
    levels_.push_back(level);
  }

  void close() {
    if (levels_.size() == 1) {  // behind a label
      levels_.back() = Level();
      return;
    }
    const Level closed = levels_.back();
    levels_.pop_back();
    Level& level = levels_.back();
    level.operation = false;
    if (condition_ && levels_.size() == 1) {
      level.current.reset();
    } else if (closed.kind == Level::Kind::definition) {
      const auto type = entityType(closed.word);
      level.current = type ? Symbol::of(*type) : Symbol::scalar();
    } else if (closed.kind == Level::Kind::open && !closed.given.empty()) {
      level.current = Symbol::of(EntityType::point);
    } else if (closed.kind != Level::Kind::subscript) {
      level.current = Symbol::scalar();
    }
  }

  std::span<const KnownName> names_;
  std::vector<Level> levels_ = std::vector<Level>(1);
  Token last_;              ///< of kind end at first
  bool condition_ = false;  ///< behind IF (
  bool chained_ = false;    ///< behind a comma that joins words to one statement
};
}  // namespace

Place placeBehind(std::span<const Token> tokens, std::span<const KnownName> names) {
  Scan scan(names);
  for (const Token& token : tokens) {
    scan.token(token);
  }
  return scan.place();
}

}  // namespace arelem::frontend
