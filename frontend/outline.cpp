#include "frontend/outline.h"

#include <algorithm>

#include "frontend/check/reporter.h"
#include "frontend/lex/lexer.h"
#include "frontend/read/card_reader.h"
#include "ir/text/source_map.h"

namespace arelem::frontend {

namespace {
void classify(const std::vector<Token>& tokens, OutlinedStatement& statement) {
  using enum TokenKind;
  const std::size_t head = tokens.size() > 2 && tokens[1].kind == rightParen ? 2 : 0;
  const Token& first = tokens[head];
  if (isWordKind(first.kind)) {
    statement.head = first.word;
  }
  const bool slashed = tokens.size() > head + 1 && tokens[head + 1].kind == slash;
  statement.definition = first.kind == type && slashed;
  const bool value = first.kind == number || first.kind == symbol || first.kind == function ||
                     first.kind == leftParen || first.kind == minus || first.kind == plus;
  int depth = 0;
  statement.expression =
      value && head == 0 && std::none_of(tokens.begin(), tokens.end(), [&](const Token& t) {
        depth += t.kind == leftParen ? 1 : t.kind == rightParen ? -1 : 0;
        return depth == 0 && (t.kind == equals || t.kind == comma);
      });
}
}  // namespace

std::vector<OutlinedStatement> outline(std::string_view text,
                                       Dialect dialect,
                                       const Limits& limits) {
  Options options;
  options.dialect = dialect;
  options.limits = limits;
  SourceMap sources;
  SilentSink sink;
  Reporter reporter(sink, options.limits);
  std::uint32_t isn = 1;
  CardReader reader(sources, sources.add("", std::string(text)), options, reporter, isn);
  const Vocabulary vocabulary(dialect);
  Lexer lexer(vocabulary, options, reporter);
  std::vector<OutlinedStatement> all;
  std::vector<Token> tokens;
  while (true) {
    OutlinedStatement one;
    one.begin = reader.offset();
    StatementText statement;
    reader.next(statement, false);
    if (statement.kind == StatementText::Kind::end) {
      return all;
    }
    one.end = reader.offset();
    if (statement.kind == StatementText::Kind::fixed) {
      one.text = spell(statement.fixedWord);
      one.head = statement.fixedWord;
    } else if (statement.kind == StatementText::Kind::tokens) {
      one.text = statement.text;
      if (lexer.run(statement, tokens)) {
        classify(tokens, one);
      }
    }
    all.push_back(std::move(one));
  }
}

}  // namespace arelem::frontend
