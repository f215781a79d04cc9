// The only file of the project that includes ANTLR headers: it feeds our tokens to the generated
// parser and copies what it found into a raw tree without ANTLR types.
#include "AptParser.h"
#include <antlr4-runtime.h>

#include "frontend/parse/parse.h"
#include "frontend/parse/raw_tree.h"

namespace arelem::frontend {

namespace {
using Apt = arelem::grammar::AptParser;

std::size_t antlrType(TokenKind kind) {
  switch (kind) {
    case TokenKind::end:
      return antlr4::Token::EOF;
    case TokenKind::number:
      return Apt::NUMBER;
    case TokenKind::symbol:
      return Apt::SYMBOL;
    case TokenKind::word:
      return Apt::WORD;
    case TokenKind::type:
      return Apt::TYPE;
    case TokenKind::function:
      return Apt::FUNCTION;
    case TokenKind::ifWord:
      return Apt::IF;
    case TokenKind::macro:
      return Apt::MACRO;
    case TokenKind::call:
      return Apt::CALL;
    case TokenKind::string:
      return Apt::STRING;
    case TokenKind::comma:
      return Apt::COMMA;
    case TokenKind::slash:
      return Apt::SLASH;
    case TokenKind::leftParen:
      return Apt::LPAREN;
    case TokenKind::rightParen:
      return Apt::RPAREN;
    case TokenKind::equals:
      return Apt::EQUALS;
    case TokenKind::plus:
      return Apt::PLUS;
    case TokenKind::minus:
      return Apt::MINUS;
    case TokenKind::star:
      return Apt::STAR;
    case TokenKind::power:
      return Apt::POWER;
    case TokenKind::relation:
      return Apt::RELATION;
    case TokenKind::andOp:
      return Apt::AND;
    case TokenKind::orOp:
      return Apt::OR;
    case TokenKind::notOp:
      return Apt::NOT;
    case TokenKind::then:
      return Apt::THEN;
    case TokenKind::elseWord:
      return Apt::ELSE;
    case TokenKind::elseIf:
      return Apt::ELSEIF;
    case TokenKind::endIf:
      return Apt::ENDIF;
    case TokenKind::doWord:
      return Apt::DO;
    case TokenKind::endDo:
      return Apt::ENDDO;
    case TokenKind::include:
      return Apt::INCLUDE;
  }
  return antlr4::Token::INVALID_TYPE;
}

/// What the parser expects, in words.
std::string inWords(std::size_t type) {
  switch (type) {
    case antlr4::Token::EOF:
      return "the end of the statement";
    case Apt::NUMBER:
      return "a number";
    case Apt::SYMBOL:
      return "a name";
    case Apt::WORD:
      return "a word";
    case Apt::TYPE:
      return "a geometric type";
    case Apt::FUNCTION:
      return "a function";
    case Apt::STRING:
      return "a string";
    case Apt::COMMA:
      return "`,`";
    case Apt::SLASH:
      return "`/`";
    case Apt::LPAREN:
      return "`(`";
    case Apt::RPAREN:
      return "`)`";
    case Apt::EQUALS:
      return "`=`";
    case Apt::THEN:
      return "THEN";
    case Apt::PLUS:
    case Apt::MINUS:
    case Apt::STAR:
    case Apt::POWER:
      return "an operator";
    case Apt::RELATION:
    case Apt::AND:
    case Apt::OR:
    case Apt::NOT:
      return "a comparison";
    default:
      return {};
  }
}

std::string inWords(const antlr4::misc::IntervalSet& expected) {
  std::vector<std::string> parts;
  for (const ssize_t type : expected.toList()) {
    std::string part = inWords(static_cast<std::size_t>(type));
    if (!part.empty() && std::find(parts.begin(), parts.end(), part) == parts.end()) {
      parts.push_back(std::move(part));
    }
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// Hands our tokens over one by one; the token index is kept in the start index.
class Source : public antlr4::TokenSource {
 public:
  void reset(std::span<const Token> tokens) {
    tokens_ = tokens;
    next_ = 0;
  }
  std::unique_ptr<antlr4::Token> nextToken() override {
    const std::size_t i = std::min(next_++, tokens_.size() - 1);
    auto token = std::make_unique<antlr4::CommonToken>(antlrType(tokens_[i].kind));
    token->setStartIndex(i);
    return token;
  }
  std::size_t getLine() const override { return 1; }
  std::size_t getCharPositionInLine() override { return 0; }
  antlr4::CharStream* getInputStream() override { return nullptr; }
  std::string getSourceName() override { return {}; }
  antlr4::TokenFactory<antlr4::CommonToken>* getTokenFactory() override {
    return antlr4::CommonTokenFactory::DEFAULT.get();
  }

 private:
  std::span<const Token> tokens_;
  std::size_t next_ = 0;
};

struct Refused {
  std::size_t token;
  std::string expected;
};

/// No recovery: the first error ends the statement.
class Strategy : public antlr4::DefaultErrorStrategy {
 public:
  void recover(antlr4::Parser* parser, std::exception_ptr error) override {
    try {
      std::rethrow_exception(error);
    } catch (const antlr4::RecognitionException& e) {
      refuse(parser, e.getOffendingToken());
    }
  }
  antlr4::Token* recoverInline(antlr4::Parser* parser) override {
    refuse(parser, parser->getCurrentToken());
  }
  void sync(antlr4::Parser* /*parser*/) override {}
  void reportError(antlr4::Parser* /*parser*/, const antlr4::RecognitionException& /*e*/) override {
  }

 private:
  [[noreturn]] static void refuse(antlr4::Parser* parser, const antlr4::Token* at) {
    // The expected set belongs to the parser's own place, which may lie before the offending token.
    const bool here = at == parser->getCurrentToken();
    throw Refused{at->getStartIndex(), here ? inWords(parser->getExpectedTokens()) : std::string()};
  }
};

static_assert(static_cast<std::size_t>(Rule::statement) == Apt::RuleStatement &&
              static_cast<std::size_t>(Rule::target) == Apt::RuleTarget &&
              static_cast<std::size_t>(Rule::arguments) == Apt::RuleArguments &&
              static_cast<std::size_t>(Rule::nested) == Apt::RuleNested);

/// Copies ANTLR's tree; returns the index of the copy. Depth is bounded by checkShapeLimits.
std::uint32_t copy(antlr4::ParserRuleContext* context, RawTree& raw) {
  RawNode node;
  node.rule = static_cast<Rule>(context->getRuleIndex());
  node.token = static_cast<std::uint32_t>(context->getStart()->getStartIndex());
  const antlr4::Token* stop = context->getStop();
  node.last = stop == nullptr ? 0 : static_cast<std::uint32_t>(stop->getStartIndex());
  node.count = static_cast<std::uint32_t>(context->children.size());
  std::vector<std::uint32_t> mine;
  mine.reserve(node.count);
  for (antlr4::tree::ParseTree* child : context->children) {
    if (auto* inner = dynamic_cast<antlr4::ParserRuleContext*>(child)) {
      mine.push_back(copy(inner, raw));
      continue;
    }
    RawNode leaf;
    leaf.token = static_cast<std::uint32_t>(
        static_cast<antlr4::tree::TerminalNode*>(child)->getSymbol()->getStartIndex());
    leaf.last = leaf.token;
    raw.nodes.push_back(leaf);
    mine.push_back(static_cast<std::uint32_t>(raw.nodes.size() - 1));
  }
  node.child = static_cast<std::uint32_t>(raw.children.size());
  raw.children.insert(raw.children.end(), mine.begin(), mine.end());
  raw.nodes.push_back(node);
  return static_cast<std::uint32_t>(raw.nodes.size() - 1);
}
}  // namespace

/// ANTLR's objects, made once and reused for every statement.
class StatementParser::Grammar {
 public:
  Grammar() : stream_(&source_), parser_(&stream_) {
    parser_.removeErrorListeners();
    parser_.setErrorHandler(std::make_shared<Strategy>());
    parser_.getInterpreter<antlr4::atn::ParserATNSimulator>()->setPredictionMode(
        antlr4::atn::PredictionMode::SLL);
  }

  std::optional<Diagnostic> parse(std::span<const Token> tokens, StatementTree& tree) {
    source_.reset(tokens);
    stream_.setTokenSource(&source_);
    parser_.setTokenStream(&stream_);
    try {
      raw_.clear();
      copy(parser_.statement(), raw_);
      convert(raw_, tokens, tree);
      return std::nullopt;
    } catch (const Refused& refused) {
      tree.clear();
      return explainSyntaxError(tokens, refused.token, refused.expected);
    }
  }

 private:
  Source source_;
  antlr4::CommonTokenStream stream_;
  Apt parser_;
  RawTree raw_;
};

StatementParser::StatementParser(const Limits& limits)
    : limits_(limits), grammar_(std::make_unique<Grammar>()) {}
StatementParser::~StatementParser() = default;

std::optional<Diagnostic> StatementParser::parse(std::span<const Token> tokens,
                                                 StatementTree& tree) {
  if (parsePlain(tokens, tree)) {
    return std::nullopt;
  }
  return parseWithGrammar(tokens, tree);
}

std::optional<Diagnostic> StatementParser::parseWithGrammar(std::span<const Token> tokens,
                                                            StatementTree& tree) {
  tree.clear();
  if (auto tooDeep = checkShapeLimits(tokens, limits_)) {
    return tooDeep;
  }
  return grammar_->parse(tokens, tree);
}

}  // namespace arelem::frontend
