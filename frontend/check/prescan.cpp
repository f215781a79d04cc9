#include "frontend/check/prescan.h"

#include <algorithm>
#include <set>

#include "frontend/lex/lexer.h"
#include "frontend/read/card_reader.h"

namespace arelem::frontend {

namespace {
using enum TokenKind;

class Prescan {
 public:
  Prescan(Vocabulary& vocabulary, Names& names, std::vector<Token>& tokens)
      : vocabulary_(vocabulary), names_(names), tokens_(tokens) {}

  void statement() {
    const Token& head = tokens_[start()];
    if (head.kind == word && head.word == Word::TERMAC) {
      variables_.clear();
    } else if (head.kind == word && head.word == Word::SYN) {
      synonyms();
    } else if (head.kind == word && head.word == Word::OBTAIN) {
      obtained();
    } else if (head.kind == word && head.word == Word::RESERV) {
      reserved();
    } else if (head.kind != call) {
      assignments();
    }
  }

 private:
  [[nodiscard]] std::size_t start() const {
    const bool label = tokens_.size() > 2 && tokens_[1].kind == rightParen;
    return label ? 2 : 0;
  }
  [[nodiscard]] bool yields(const Token& t) const {
    return t.kind == symbol || (isWordKind(t.kind) && vocabulary_.canYield(t.word));
  }

  void note(const Token& name, NameFacts::Class kind, EntityType type = EntityType::point) {
    if (!yields(name) || variables_.contains(name.text)) {
      return;
    }
    vocabulary_.yieldTo(name.text);
    NameFacts& facts = names_.at(name.text);
    if (facts.kind == NameFacts::Class::unknown) {
      facts.kind = kind;
      facts.type = type;
      facts.definition = name.span;
    }
  }

  /// The name before `=` at `equalsAt`, over a subscript if there is one.
  const Token* nameBefore(std::size_t equalsAt) const {
    std::size_t i = equalsAt;
    if (i > 0 && tokens_[i - 1].kind == rightParen) {
      int depth = 0;
      do {
        --i;
        depth += tokens_[i].kind == rightParen ? 1 : tokens_[i].kind == leftParen ? -1 : 0;
      } while (i > 0 && depth > 0);
    }
    return i > 0 ? &tokens_[i - 1] : nullptr;
  }

  void assignments() {
    for (std::size_t i = 1; i + 1 < tokens_.size(); ++i) {
      if (tokens_[i].kind != equals) {
        continue;
      }
      const Token* name = nameBefore(i);
      const Token& value = tokens_[i + 1];
      if (name == nullptr) {
        continue;
      }
      if (value.kind == macro) {
        note(*name, NameFacts::Class::macro);
        macroVariables(i + 2);
        return;
      }
      if (isOpenType(i + 1)) {
        if (yields(*name)) {
          vocabulary_.yieldTo(name->text);
        }
        continue;
      }
      const auto entity = value.kind == type ? entityType(value.word) : std::nullopt;
      note(*name, entity ? NameFacts::Class::entity : NameFacts::Class::scalar,
           entity.value_or(EntityType::point));
    }
  }

  /// `name = V/ a,b` with a macro variable V: each CALL tells the type. A quotient has no comma and
  /// no word behind the slash.
  [[nodiscard]] bool isOpenType(std::size_t at) const {
    if (tokens_[at].kind != symbol || !variables_.contains(tokens_[at].text) ||
        at + 2 >= tokens_.size() || tokens_[at + 1].kind != slash) {
      return false;
    }
    bool definition = isWordKind(tokens_[at + 2].kind);
    int depth = 0;
    for (std::size_t i = at + 2; i < tokens_.size() && depth >= 0; ++i) {
      depth += tokens_[i].kind == leftParen ? 1 : tokens_[i].kind == rightParen ? -1 : 0;
      definition = definition || (depth == 0 && tokens_[i].kind == comma);
    }
    return definition;
  }

  void macroVariables(std::size_t from) {
    for (std::size_t i = from; i + 1 < tokens_.size(); ++i) {
      const bool item = tokens_[i].kind == comma || tokens_[i].kind == slash;
      if (item && yields(tokens_[i + 1])) {
        vocabulary_.yieldTo(tokens_[i + 1].text);
        variables_.emplace(tokens_[i + 1].text);
      }
    }
  }

  void obtained() {
    int depth = 0;
    int commas = 0;
    bool slashSeen = false;
    for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) {
      const TokenKind k = tokens_[i].kind;
      depth += k == leftParen ? 1 : k == rightParen ? -1 : 0;
      slashSeen = slashSeen || (k == slash && depth == 0);
      commas += (k == comma && depth == 0) ? 1 : 0;
      const int sourceCommas = slashSeen ? 1 : 2;  // commas up to the surface's name
      if (k == comma && depth == 0 && commas > sourceCommas) {
        note(tokens_[i + 1], NameFacts::Class::scalar);
      }
    }
    assignments();
  }

  void reserved() {
    for (const Token& t : tokens_) {
      if (yields(t)) {
        vocabulary_.yieldTo(t.text);
      }
    }
  }

  void synonyms() {
    for (std::size_t i = start() + 2; i + 2 < tokens_.size(); i += 4) {
      const Token& a = tokens_[i];
      const Token& b = tokens_[i + 2];
      if (a.kind == symbol && isWordKind(b.kind)) {
        vocabulary_.addSynonym(a.text, b.word);
      } else if (b.kind == symbol && isWordKind(a.kind)) {
        vocabulary_.addSynonym(b.text, a.word);
      }
    }
  }

  Vocabulary& vocabulary_;
  Names& names_;
  std::vector<Token>& tokens_;
  std::set<std::string, std::less<>> variables_;
};

/// Statements that can make names: those with `=`, and a few words.
bool matters(std::string_view text) {
  if (text.find('=') != std::string_view::npos) {
    return true;
  }
  const std::size_t label = text.find(')');
  constexpr std::size_t longestLabel = 32;
  const std::string_view body = label < longestLabel ? text.substr(label + 1) : text;
  for (const std::string_view head : {"OBTAIN", "RESERV", "SYN/", "TERMAC"}) {
    if (text.starts_with(head) || body.starts_with(head)) {
      return true;
    }
  }
  return text.find("MACRO") != std::string_view::npos;
}
}  // namespace

void prescan(const SourceMap& sources,
             BufferId buffer,
             const Options& options,
             Vocabulary& vocabulary,
             Names& names) {
  if (sources.text(buffer).find('=') == std::string_view::npos) {
    return;
  }
  SilentSink silent;
  Reporter reporter(silent, options.limits);
  std::uint32_t isn = 1;
  CardReader reader(sources, buffer, options, reporter, isn);
  Lexer lexer(vocabulary, options, reporter);
  StatementText statement;
  std::vector<Token> tokens;
  Prescan scan(vocabulary, names, tokens);
  for (reader.next(statement, true); statement.kind != StatementText::Kind::end;
       reader.next(statement, true)) {
    if (statement.kind != StatementText::Kind::tokens) {
      continue;
    }
    if (statement.text == "FINI") {
      break;
    }
    if (matters(statement.text)) {
      lexer.run(statement, tokens);
      scan.statement();
    }
  }
  vocabulary.clearSynonyms();
}

}  // namespace arelem::frontend
