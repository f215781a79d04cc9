#include "frontend/format/layout.h"

#include <algorithm>
#include <iterator>

namespace arelem::frontend {

namespace {
using enum TokenKind;

constexpr std::size_t step = 2;          // blanks a level
constexpr std::size_t continuation = 4;  // more blanks on the cards that continue a statement
constexpr std::size_t fieldColumns = 72;
constexpr std::size_t cardColumns = 80;
constexpr std::size_t deepest = 12;  // levels that are still shown

/// Index of the first token behind a label.
std::size_t headOf(const std::vector<Token>& tokens) {
  return tokens.size() > 1 && tokens[1].kind == rightParen ? 2 : 0;
}

bool opensBlock(const std::vector<Token>& tokens, std::size_t head) {
  const Token& first = tokens[head];
  const bool branch = first.kind == ifWord && tokens.back().kind == then;
  const bool isMacro =
      std::any_of(tokens.begin(), tokens.end(), [](const Token& t) { return t.kind == macro; });
  return (first.kind == word && first.word == Word::LOOPST) || first.kind == doWord || branch ||
         isMacro;
}

bool closesBlock(const Token& first) {
  return (first.kind == word && (first.word == Word::LOOPND || first.word == Word::TERMAC)) ||
         first.kind == endDo || first.kind == endIf;
}

bool isMiddle(const Token& first) {
  return first.kind == elseWord || first.kind == elseIf;
}

std::string textOf(const Token& token) {
  return token.kind == string ? "'" + std::string(token.text) + "'" : std::string(token.text);
}

/// Writes the tokens of a statement one after another and knows where a blank belongs.
class Spacing {
 public:
  /// `token` is number `index` of the whole statement.
  std::string blanksBefore(const Token& token, std::size_t index, std::size_t head) {
    const TokenKind before = last_;
    last_ = token.kind;
    const bool afterCondition = condition_ && before == rightParen && depth_ == 0;
    depth_ += token.kind == leftParen ? 1 : 0;
    depth_ -= token.kind == rightParen && index != 1 ? 1 : 0;
    if (index == head && (token.kind == ifWord || token.kind == elseIf)) {
      condition_ = true;
      return index > 0 ? " " : "";
    }
    const bool afterLabel = index == head && index > 0;
    const bool opensCondition = condition_ && index == head + 1;
    return afterLabel || opensCondition || afterCondition || isDotted(token.kind) ||
                   isDotted(before)
               ? " "
               : "";
  }

 private:
  static bool isDotted(TokenKind kind) {
    return kind == relation || kind == andOp || kind == orOp || kind == notOp;
  }
  TokenKind last_ = end;
  int depth_ = 0;
  bool condition_ = false;
};

/// One piece of a card: a token with the blanks before it.
struct Piece {
  std::string text;
  bool mayBreak = false;  ///< a comma: the card may end behind it
};

/// Cuts the pieces into lines of at most `width` columns, behind commas where there are any.
std::vector<std::string> wrap(const std::vector<Piece>& pieces,
                              const std::string& lead,
                              const std::string& next,
                              std::size_t width) {
  std::vector<std::string> lines;
  std::size_t from = 0;
  while (from < pieces.size()) {
    std::string line = lines.empty() ? lead : next;
    std::size_t to = from;
    std::size_t comma = 0;
    for (std::size_t length = line.size(); to < pieces.size(); ++to) {
      length += pieces[to].text.size();
      if (length > width && to > from) {
        break;
      }
      comma = pieces[to].mayBreak ? to + 1 : comma;
    }
    const std::size_t cut = to < pieces.size() && comma > from ? comma : to;
    for (std::size_t i = from; i < cut; ++i) {
      line += i == from && from > 0 ? pieces[i].text.substr(pieces[i].text.find_first_not_of(' '))
                                    : pieces[i].text;
    }
    lines.push_back(std::move(line));
    from = cut;
  }
  return lines;
}

std::size_t columns(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

/// Fills up with blanks to a column, with at least `least` of them.
void padTo(std::string& line, std::size_t column, std::size_t least) {
  const std::size_t now = columns(line);
  line.append(std::max(column > now ? column - now : 0, now == 0 ? 0 : least), ' ');
}

/// Adds `$` or `$$` with the comment, in the column where it stood if that is free.
void addEnd(std::string& line, const Card& card) {
  if (card.continued) {
    if (!card.comment.empty()) {
      padTo(line, card.column, 1);
    }
    line += "$" + card.comment;
  } else if (card.commented) {
    padTo(line, line.empty() ? 0 : card.column, 2);
    line += "$$" + card.comment;
  }
}

bool addId(std::string& line, std::string_view id) {
  const bool continued = !line.empty() && line.back() == '$' && columns(line) < fieldColumns;
  if (continued) {
    line.pop_back();
    padTo(line, fieldColumns - 1, 0);
    line += '$';
  }
  if (columns(line) > fieldColumns) {
    return false;
  }
  padTo(line, fieldColumns, 0);
  line += id;
  padTo(line, cardColumns, 0);
  return true;
}

std::string withoutTrailingBlanks(std::string line) {
  line.erase(line.find_last_not_of(" \t") + 1);
  return line;
}

/// The lines of one card; `pieces` are its tokens.
std::vector<std::string> cardLines(const Card& card,
                                   const std::vector<Piece>& pieces,
                                   const std::string& lead,
                                   const std::string& next,
                                   CardIds ids) {
  const bool identified = ids == CardIds::keep && !card.cardId.empty();
  const std::size_t room = fieldColumns - (identified ? 2 : 0);
  std::size_t length = lead.size() + (card.continued ? 1 : 0);
  for (const Piece& piece : pieces) {
    length += piece.text.size();
  }
  std::vector<std::string> lines =
      length <= room ? wrap(pieces, lead, next, room) : wrap(pieces, lead, next, room - 1);
  if (lines.empty()) {
    lines.push_back(card.comment.empty() && !card.continued && !card.commented ? "" : lead);
  }
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    lines[i] += '$';
  }
  addEnd(lines.back(), card);
  if (identified && !addId(lines.front(), card.cardId)) {
    return {};
  }
  if (!identified) {
    std::transform(lines.begin(), lines.end(), lines.begin(), withoutTrailingBlanks);
  }
  return lines;
}
}  // namespace

std::size_t Indent::next(const CardGroup& group) {
  std::vector<Token> tokens;
  for (const Card& card : group.cards) {
    tokens.insert(tokens.end(), card.tokens.begin(), card.tokens.end());
  }
  const std::size_t head = headOf(tokens);
  if (head >= tokens.size()) {
    return std::min(depth_, deepest);
  }
  const Token& first = tokens[head];
  const bool closes = closesBlock(first);
  if (closes && depth_ > 0) {
    --depth_;
  }
  const std::size_t here = isMiddle(first) && depth_ > 0 ? depth_ - 1 : depth_;
  depth_ += opensBlock(tokens, head) ? 1 : 0;
  return std::min(here, deepest);
}

std::vector<std::string> layOut(const CardGroup& group, std::size_t levels, CardIds ids) {
  std::size_t head = 0;
  std::vector<Token> all;
  for (const Card& card : group.cards) {
    all.insert(all.end(), card.tokens.begin(), card.tokens.end());
  }
  head = headOf(all);
  const std::string indent(levels * step, ' ');
  const std::string further = indent + std::string(continuation, ' ');
  Spacing spacing;
  std::vector<std::string> lines;
  std::size_t index = 0;
  for (const Card& card : group.cards) {
    std::vector<Piece> pieces;
    for (const Token& token : card.tokens) {
      const std::string blanks = spacing.blanksBefore(token, index, head);
      pieces.push_back({(pieces.empty() ? "" : blanks) + textOf(token), token.kind == comma});
      ++index;
    }
    const bool first = &card == &group.cards.front();
    std::vector<std::string> made = cardLines(card, pieces, first ? indent : further, further, ids);
    if (made.empty()) {
      return {};
    }
    std::move(made.begin(), made.end(), std::back_inserter(lines));
  }
  return lines;
}

std::vector<std::string> asItStands(const CardGroup& group, CardIds ids) {
  std::vector<std::string> lines;
  for (const Card& card : group.cards) {
    const bool identified = ids == CardIds::keep && !card.cardId.empty();
    const std::string_view kept = ids == CardIds::keep ? card.line : card.field;
    lines.push_back(identified ? std::string(card.line) : withoutTrailingBlanks(std::string(kept)));
  }
  return lines;
}

}  // namespace arelem::frontend
