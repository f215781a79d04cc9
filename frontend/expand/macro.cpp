#include "frontend/expand/macro.h"

namespace arelem::frontend {

StoredStatement store(const StatementText& statement, const std::vector<Token>& tokens) {
  StoredStatement s;
  s.kind = statement.kind;
  s.span = statement.span;
  s.isn = statement.isn;
  s.cardId = statement.cardId;
  s.fixedWord = statement.fixedWord;
  s.fixedText = statement.fixedText;
  if (statement.kind == StatementText::Kind::tokens) {
    s.text = std::make_unique<const std::string>(statement.text);
    s.tokens = tokens;
    for (Token& t : s.tokens) {
      if (!t.text.empty()) {
        const auto at = static_cast<std::size_t>(t.text.data() - statement.text.data());
        t.text = std::string_view(*s.text).substr(at, t.text.size());
      }
    }
  }
  return s;
}

void substitute(const std::vector<Token>& tokens,
                const std::map<std::string_view, Token>& values,
                std::vector<Token>& result) {
  result.clear();
  const bool label = tokens.size() > 2 && tokens[1].kind == TokenKind::rightParen;
  const std::size_t head = label ? 2 : 0;
  const bool call = head < tokens.size() && tokens[head].kind == TokenKind::call;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    result.push_back(tokens[i]);
    // The name before `=` of a CALL is a variable of the macro that is called.
    const bool keyword = call && i + 1 < tokens.size() && tokens[i + 1].kind == TokenKind::equals;
    if (tokens[i].kind != TokenKind::symbol || (label && i == 0) || keyword) {
      continue;
    }
    if (const auto found = values.find(tokens[i].text); found != values.end()) {
      result.back() = found->second;
      result.back().span = tokens[i].span;
    }
  }
}

}  // namespace arelem::frontend
