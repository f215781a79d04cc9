#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "frontend/compile.h"
#include "frontend/lex/token.h"
#include "frontend/read/statement_text.h"

namespace arelem::frontend {

/// One physical card of a statement.
struct Card {
  std::string_view line;      ///< as it stands, without its end
  std::string_view field;     ///< without columns 73-80
  std::string comment;        ///< behind `$` or `$$`, which it does not hold
  std::size_t column = 0;     ///< where `$` or `$$` stood, counted from 0
  bool continued = false;     ///< ended by `$`
  bool commented = false;     ///< ended by `$$`
  std::string_view cardId;    ///< columns 73-80
  std::vector<Token> tokens;  ///< that begin on this card
};

/// One logical statement with its cards.
struct CardGroup {
  StatementText::Kind kind = StatementText::Kind::empty;
  bool plain = false;  ///< tokens and cards are known; else only the lines are
  std::vector<Card> cards;
};

/// What must not change: the statement without blanks and comments, its number and identification.
struct Essence {
  StatementText::Kind kind = StatementText::Kind::empty;
  std::uint32_t isn = 0;
  std::string text;
  std::string cardId;
  bool operator==(const Essence&) const = default;
};

/// A text cut into logical statements. Tokens point into `statements`, which must stay.
struct CardList {
  std::vector<CardGroup> groups;
  std::vector<Essence> essence;
  std::vector<StatementText> statements;
};

/// `text` must live as long as the result. With `tokens` false only `essence` is filled.
void readCards(std::string_view text, const Options& options, bool tokens, CardList& list);

}  // namespace arelem::frontend
