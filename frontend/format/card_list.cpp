#include "frontend/format/card_list.h"

#include "frontend/check/names.h"
#include "frontend/check/prescan.h"
#include "frontend/check/reporter.h"
#include "frontend/lex/lexer.h"
#include "frontend/read/card_reader.h"
#include "frontend/read/characters.h"
#include "frontend/read/columns.h"
#include "ir/text/source_map.h"

namespace arelem::frontend {

namespace {
constexpr std::size_t tabStop = 8;
constexpr std::size_t cardColumns = 80;

std::vector<std::string_view> linesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  std::size_t at = 0;
  while (at < text.size()) {
    std::size_t end = text.find_first_of("\r\n", at);
    end = end == std::string_view::npos ? text.size() : end;
    lines.push_back(text.substr(at, end - at));
    const bool pair = end + 1 < text.size() && text[end] == '\r' && text[end + 1] == '\n';
    at = end + (pair ? 2 : 1);
  }
  return lines;
}

std::size_t columnOf(std::string_view before) {
  std::size_t column = 0;
  for (const char c : before) {
    if (c == '\t') {
      column = (column / tabStop + 1) * tabStop;
    } else if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) {
      ++column;
    }
  }
  return column;
}

Card cardOf(std::string_view line, std::size_t pieceLength, Dialect dialect) {
  Card card;
  card.line = line;
  const CardFields fields = splitCard(line, dialect);
  card.cardId = fields.cardId;
  const std::string_view field = line.substr(0, fields.fieldEnd);
  card.field = field;
  if (pieceLength >= field.size()) {
    return card;
  }
  card.column = columnOf(field.substr(0, pieceLength));
  std::size_t second = pieceLength + 1;
  while (second < field.size() && isBlank(field[second])) {
    ++second;
  }
  card.commented = second < field.size() && field[second] == '$';
  card.continued = !card.commented;
  std::string_view comment = field.substr(card.commented ? second + 1 : pieceLength + 1);
  while (!comment.empty() && isBlank(comment.back())) {
    comment.remove_suffix(1);
  }
  card.comment = comment;
  return card;
}

/// Gives each token to the card on which it begins.
void deal(const std::vector<Token>& tokens, const StatementText& statement, CardGroup& group) {
  std::size_t card = 0;
  for (const Token& token : tokens) {
    if (token.kind == TokenKind::end) {
      break;
    }
    while (card + 1 < group.cards.size() && token.span.begin >= statement.pieces[card + 1].begin) {
      ++card;
    }
    group.cards[card].tokens.push_back(token);
  }
}
}  // namespace

void readCards(std::string_view text, const Options& options, bool tokens, CardList& list) {
  SourceMap sources;
  SilentSink sink;
  Reporter reporter(sink, options.limits);
  const BufferId buffer = sources.add("", std::string(text));
  Vocabulary vocabulary(options.dialect);
  if (tokens) {
    Names names;
    prescan(sources, buffer, options, vocabulary, names);
  }
  Lexer lexer(vocabulary, options, reporter);
  std::uint32_t isn = 1;
  CardReader reader(sources, buffer, options, reporter, isn);
  // Tokens view the text of their statement: the statements must not move.
  list.statements.reserve(tokens ? linesOf(text).size() + 1 : 0);
  std::vector<Token> found;
  StatementText statement;
  while (true) {
    const std::uint32_t begin = reader.offset();
    const std::uint64_t errors = reporter.errors();
    reader.next(statement, false);
    if (statement.kind == StatementText::Kind::end) {
      return;
    }
    const bool fixed = statement.kind == StatementText::Kind::fixed;
    list.essence.push_back({statement.kind, statement.isn,
                            fixed ? statement.fixedText : statement.text,
                            std::string(statement.cardId)});
    if (!tokens) {
      continue;
    }
    CardGroup group;
    group.kind = statement.kind;
    const auto lines = linesOf(text.substr(begin, reader.offset() - begin));
    list.statements.push_back(std::move(statement));
    const StatementText& kept = list.statements.back();
    const bool read = kept.kind != StatementText::Kind::tokens || lexer.run(kept, found);
    // The reader has left out what it complained of.
    group.plain =
        !fixed && read && reporter.errors() == errors && lines.size() == kept.pieces.size();
    bool cut = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::size_t length = group.plain ? kept.pieces[i].length : lines[i].size();
      group.cards.push_back(cardOf(lines[i], length, options.dialect));
      // What stands behind column 80 would be lost.
      cut = cut || (columnOf(lines[i]) > cardColumns && group.cards.back().field != lines[i]);
    }
    group.plain = group.plain && !cut;
    if (group.plain && kept.kind == StatementText::Kind::tokens) {
      deal(found, kept, group);
    }
    list.groups.push_back(std::move(group));
    statement = {};
  }
}

}  // namespace arelem::frontend
