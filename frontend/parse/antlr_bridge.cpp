// The only file of the project that includes ANTLR headers: it feeds our tokens to the generated parser
// and turns its parse tree into ours.
#include <antlr4-runtime.h>

#include "AptParser.h"
#include "frontend/parse/parse.h"

namespace arelem::frontend {

namespace {
using Apt = arelem::grammar::AptParser;

std::size_t antlrType(TokenKind kind) {
  switch (kind) {
    case TokenKind::end: return antlr4::Token::EOF;
    case TokenKind::number: return Apt::NUMBER;
    case TokenKind::symbol: return Apt::SYMBOL;
    case TokenKind::word: return Apt::WORD;
    case TokenKind::type: return Apt::TYPE;
    case TokenKind::function: return Apt::FUNCTION;
    case TokenKind::ifWord: return Apt::IF;
    case TokenKind::macro: return Apt::MACRO;
    case TokenKind::call: return Apt::CALL;
    case TokenKind::string: return Apt::STRING;
    case TokenKind::comma: return Apt::COMMA;
    case TokenKind::slash: return Apt::SLASH;
    case TokenKind::leftParen: return Apt::LPAREN;
    case TokenKind::rightParen: return Apt::RPAREN;
    case TokenKind::equals: return Apt::EQUALS;
    case TokenKind::plus: return Apt::PLUS;
    case TokenKind::minus: return Apt::MINUS;
    case TokenKind::star: return Apt::STAR;
    case TokenKind::power: return Apt::POWER;
    case TokenKind::relation: return Apt::RELATION;
    case TokenKind::andOp: return Apt::AND;
    case TokenKind::orOp: return Apt::OR;
    case TokenKind::notOp: return Apt::NOT;
    case TokenKind::then: return Apt::THEN;
    case TokenKind::elseWord: return Apt::ELSE;
    case TokenKind::elseIf: return Apt::ELSEIF;
    case TokenKind::endIf: return Apt::ENDIF;
    case TokenKind::doWord: return Apt::DO;
    case TokenKind::endDo: return Apt::ENDDO;
    case TokenKind::include: return Apt::INCLUDE;
  }
  return antlr4::Token::INVALID_TYPE;
}

/// What the parser expects, in words.
std::string inWords(std::size_t type) {
  switch (type) {
    case antlr4::Token::EOF: return "the end of the statement";
    case Apt::NUMBER: return "a number";
    case Apt::SYMBOL: return "a name";
    case Apt::WORD: return "a word";
    case Apt::TYPE: return "a geometric type";
    case Apt::FUNCTION: return "a function";
    case Apt::STRING: return "a string";
    case Apt::COMMA: return "`,`";
    case Apt::SLASH: return "`/`";
    case Apt::LPAREN: return "`(`";
    case Apt::RPAREN: return "`)`";
    case Apt::EQUALS: return "`=`";
    case Apt::THEN: return "THEN";
    case Apt::PLUS: case Apt::MINUS: case Apt::STAR: case Apt::POWER: return "an operator";
    case Apt::RELATION: case Apt::AND: case Apt::OR: case Apt::NOT: return "a comparison";
    default: return {};
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
  antlr4::Token* recoverInline(antlr4::Parser* parser) override { refuse(parser, parser->getCurrentToken()); }
  void sync(antlr4::Parser* /*parser*/) override {}
  void reportError(antlr4::Parser* /*parser*/, const antlr4::RecognitionException& /*e*/) override {}

 private:
  [[noreturn]] static void refuse(antlr4::Parser* parser, const antlr4::Token* at) {
    // The expected set belongs to the parser's own place, which may lie before the offending token.
    const bool here = at == parser->getCurrentToken();
    throw Refused{at->getStartIndex(), here ? inWords(parser->getExpectedTokens()) : std::string()};
  }
};

/// ANTLR's tree to ours. Depth is bounded by checkShapeLimits.
class Converter {
 public:
  Converter(std::span<const Token> tokens, StatementTree& tree) : tokens_(tokens), tree_(tree) {}
  void statement(Apt::StatementContext* ctx);

 private:
  const Token& token(antlr4::tree::TerminalNode* node) { return tokens_[node->getSymbol()->getStartIndex()]; }
  const Token& startOf(antlr4::ParserRuleContext* ctx) { return tokens_[ctx->getStart()->getStartIndex()]; }
  Span spanOf(antlr4::ParserRuleContext* ctx);
  NodeId leaf(Node::Kind kind, const Token& t);
  void body(Apt::BodyContext* ctx);
  void command(Apt::CommandContext* ctx);
  void macro(Apt::MacroContext* ctx);
  void call(Apt::CallContext* ctx);
  void branch(Apt::IfContext* ctx);
  void doBlock(Apt::DoContext* ctx);
  NodeId target(Apt::TargetContext* ctx);
  NodeId definition(Apt::DefinitionContext* ctx);
  NodeId arguments(Apt::ArgumentsContext* ctx);
  NodeId argument(Apt::ArgumentContext* ctx);
  NodeId value(Apt::ValueContext* ctx);
  NodeId expression(Apt::ExpressionContext* ctx);
  NodeId binary(Node::Kind kind, antlr4::ParserRuleContext* ctx, Apt::ExpressionContext* left,
                Apt::ExpressionContext* right);
  NodeId unary(Node::Kind kind, antlr4::ParserRuleContext* ctx, Apt::ExpressionContext* child);
  NodeId primary(Apt::PrimaryContext* ctx);
  NodeId nested(Apt::NestedContext* ctx, const Span& parens);

  std::span<const Token> tokens_;
  StatementTree& tree_;
};

Span Converter::spanOf(antlr4::ParserRuleContext* ctx) {
  const Span begin = startOf(ctx).span;
  const antlr4::Token* stop = ctx->getStop();
  const bool empty = stop == nullptr || stop->getStartIndex() < ctx->getStart()->getStartIndex();
  if (empty) {
    return {begin.buffer, begin.begin, 0};
  }
  return join(begin, tokens_[stop->getStartIndex()].span);
}

NodeId Converter::leaf(Node::Kind kind, const Token& t) {
  const NodeId id = tree_.add(kind, t.span);
  Node& node = tree_[id];
  node.text = t.text;
  node.number = t.number;
  node.word = t.word;
  return id;
}

void Converter::statement(Apt::StatementContext* ctx) {
  if (auto* label = ctx->label()) {
    tree_.label = startOf(label).text;
    tree_.labelSpan = startOf(label).span;
  }
  if (ctx->body() != nullptr) {
    body(ctx->body());
  }
}

void Converter::body(Apt::BodyContext* ctx) {
  using Shape = StatementTree::Shape;
  if (auto* c = dynamic_cast<Apt::CommandContext*>(ctx)) {
    command(c);
  } else if (auto* d = dynamic_cast<Apt::DefineContext*>(ctx)) {
    tree_.shape = Shape::define;
    tree_.target = target(d->target());
    tree_.value = definition(d->definition());
  } else if (auto* a = dynamic_cast<Apt::AssignContext*>(ctx)) {
    tree_.shape = Shape::assign;
    tree_.target = target(a->target());
    tree_.value = expression(a->expression());
  } else if (auto* m = dynamic_cast<Apt::MacroContext*>(ctx)) {
    macro(m);
  } else if (auto* callCtx = dynamic_cast<Apt::CallContext*>(ctx)) {
    call(callCtx);
  } else if (auto* i = dynamic_cast<Apt::IfContext*>(ctx)) {
    branch(i);
  } else if (auto* e = dynamic_cast<Apt::ElseIfContext*>(ctx)) {
    tree_.shape = Shape::elseIf;
    tree_.value = expression(e->expression());
  } else if (auto* doCtx = dynamic_cast<Apt::DoContext*>(ctx)) {
    doBlock(doCtx);
  } else if (auto* includeCtx = dynamic_cast<Apt::IncludeContext*>(ctx)) {
    tree_.shape = Shape::include;
    tree_.value = leaf(Node::Kind::string, token(includeCtx->STRING()));
  } else if (dynamic_cast<Apt::ElseContext*>(ctx) != nullptr) {
    tree_.shape = Shape::elseWord;
  } else if (dynamic_cast<Apt::EndIfContext*>(ctx) != nullptr) {
    tree_.shape = Shape::endIf;
  } else {
    tree_.shape = Shape::endDo;
  }
}

void Converter::command(Apt::CommandContext* ctx) {
  tree_.shape = StatementTree::Shape::command;
  Chain heads(tree_);
  heads.append(leaf(Node::Kind::word, startOf(ctx->word())));
  for (auto* item : ctx->argument()) {
    heads.append(argument(item));
  }
  tree_.head = heads.first();
  tree_.slash = ctx->SLASH() != nullptr;
  if (ctx->arguments() != nullptr) {
    tree_.arguments = arguments(ctx->arguments());
  }
}

void Converter::macro(Apt::MacroContext* ctx) {
  tree_.shape = StatementTree::Shape::macro;
  tree_.target = target(ctx->target());
  tree_.slash = ctx->SLASH() != nullptr;
  Chain chain(tree_);
  for (auto* p : ctx->parameter()) {
    const NodeId id = leaf(Node::Kind::parameter, startOf(p));
    if (p->value() != nullptr) {
      const NodeId v = value(p->value());
      tree_[id].first = v;
    }
    chain.append(id);
  }
  tree_.arguments = chain.first();
}

void Converter::call(Apt::CallContext* ctx) {
  tree_.shape = StatementTree::Shape::call;
  Chain chain(tree_);
  for (auto* item : ctx->callItem()) {
    if (item->argument() != nullptr) {
      chain.append(argument(item->argument()));
      continue;
    }
    const NodeId id = leaf(Node::Kind::parameter, startOf(item));
    const NodeId v = value(item->value());
    tree_[id].first = v;
    chain.append(id);
  }
  tree_.arguments = chain.first();
}

void Converter::branch(Apt::IfContext* ctx) {
  tree_.value = expression(ctx->expression());
  if (ctx->branch()->THEN() != nullptr) {
    tree_.shape = StatementTree::Shape::ifBlock;
    return;
  }
  tree_.shape = StatementTree::Shape::branch;
  Chain chain(tree_);
  for (auto* label : ctx->branch()->labelName()) {
    chain.append(leaf(Node::Kind::label, startOf(label)));
  }
  tree_.arguments = chain.first();
}

void Converter::doBlock(Apt::DoContext* ctx) {
  tree_.shape = StatementTree::Shape::doBlock;
  tree_.target = target(ctx->target());
  Chain chain(tree_);
  for (auto* e : ctx->expression()) {
    chain.append(expression(e));
  }
  tree_.arguments = chain.first();
}

NodeId Converter::target(Apt::TargetContext* ctx) {
  const Token& t = startOf(ctx);
  const NodeId id = leaf(isWordKind(t.kind) ? Node::Kind::word : Node::Kind::name, t);
  if (ctx->expression() != nullptr) {
    const NodeId subscript = expression(ctx->expression());
    tree_[id].first = subscript;
    tree_[id].hasList = true;
    tree_[id].span = spanOf(ctx);
  }
  return id;
}

NodeId Converter::definition(Apt::DefinitionContext* ctx) {
  const Token& typeToken = startOf(ctx);
  const NodeId id = leaf(Node::Kind::definition, typeToken);
  tree_[id].text = {};
  tree_[id].wordSpan = typeToken.span;
  const NodeId first = arguments(ctx->arguments());
  tree_[id].first = first;
  tree_[id].span = spanOf(ctx);
  return id;
}

NodeId Converter::arguments(Apt::ArgumentsContext* ctx) {
  Chain chain(tree_);
  for (antlr4::tree::ParseTree* child : ctx->children) {
    if (auto* a = dynamic_cast<Apt::ArgumentContext*>(child)) {
      chain.append(argument(a));
    } else if (auto* w = dynamic_cast<Apt::WordContext*>(child)) {
      chain.append(leaf(Node::Kind::word, startOf(w)));
    }
  }
  const bool nothing = chain.size() == 1 && tree_[chain.first()].kind == Node::Kind::omitted;
  return nothing ? noNode : chain.first();
}

NodeId Converter::argument(Apt::ArgumentContext* ctx) {
  if (ctx->expression() != nullptr) {
    return expression(ctx->expression());
  }
  if (ctx->word() != nullptr) {
    return leaf(Node::Kind::word, startOf(ctx->word()));
  }
  if (ctx->STRING() != nullptr) {
    return leaf(Node::Kind::string, token(ctx->STRING()));
  }
  const Span at = startOf(ctx).span;
  return tree_.add(Node::Kind::omitted, {at.buffer, at.begin, 0});
}

NodeId Converter::value(Apt::ValueContext* ctx) {
  if (ctx->expression() != nullptr) {
    return expression(ctx->expression());
  }
  return ctx->word() != nullptr ? leaf(Node::Kind::word, startOf(ctx->word()))
                                : leaf(Node::Kind::string, token(ctx->STRING()));
}

NodeId Converter::binary(Node::Kind kind, antlr4::ParserRuleContext* ctx, Apt::ExpressionContext* left,
                         Apt::ExpressionContext* right) {
  const NodeId l = expression(left);
  const NodeId r = expression(right);
  const NodeId id = tree_.add(kind, spanOf(ctx));
  tree_[id].first = l;
  tree_[l].next = r;
  return id;
}

NodeId Converter::unary(Node::Kind kind, antlr4::ParserRuleContext* ctx, Apt::ExpressionContext* child) {
  const NodeId c = expression(child);
  const NodeId id = tree_.add(kind, spanOf(ctx));
  tree_[id].first = c;
  return id;
}

NodeId Converter::expression(Apt::ExpressionContext* ctx) {
  using Kind = Node::Kind;
  if (auto* a = dynamic_cast<Apt::AtomContext*>(ctx)) {
    return primary(a->primary());
  }
  if (auto* p = dynamic_cast<Apt::PowerContext*>(ctx)) {
    return binary(Kind::power, p, p->expression(0), p->expression(1));
  }
  if (auto* s = dynamic_cast<Apt::SignContext*>(ctx)) {
    return unary(s->MINUS() != nullptr ? Kind::negate : Kind::plus, s, s->expression());
  }
  if (auto* m = dynamic_cast<Apt::MultiplyContext*>(ctx)) {
    return binary(m->STAR() != nullptr ? Kind::multiply : Kind::divide, m, m->expression(0), m->expression(1));
  }
  if (auto* a = dynamic_cast<Apt::AddContext*>(ctx)) {
    return binary(a->PLUS() != nullptr ? Kind::add : Kind::subtract, a, a->expression(0), a->expression(1));
  }
  if (auto* c = dynamic_cast<Apt::CompareContext*>(ctx)) {
    const NodeId id = binary(Kind::compare, c, c->expression(0), c->expression(1));
    tree_[id].relation = token(c->RELATION()).relation;
    return id;
  }
  if (auto* a = dynamic_cast<Apt::AndContext*>(ctx)) {
    return binary(Kind::conjunction, a, a->expression(0), a->expression(1));
  }
  if (auto* o = dynamic_cast<Apt::OrContext*>(ctx)) {
    return binary(Kind::disjunction, o, o->expression(0), o->expression(1));
  }
  auto* n = dynamic_cast<Apt::NotContext*>(ctx);
  return unary(Kind::negation, n, n->expression());
}

NodeId Converter::primary(Apt::PrimaryContext* ctx) {
  if (ctx->nested() != nullptr) {
    return nested(ctx->nested(), spanOf(ctx));
  }
  const Token& t = startOf(ctx);
  if (t.kind == TokenKind::number) {
    return leaf(Node::Kind::number, t);
  }
  const bool function = t.kind == TokenKind::function;
  const NodeId id = leaf(function ? Node::Kind::call : Node::Kind::name, t);
  tree_[id].wordSpan = t.span;
  if (ctx->arguments() != nullptr) {
    const NodeId first = arguments(ctx->arguments());
    tree_[id].first = first;
    tree_[id].hasList = true;
    tree_[id].span = spanOf(ctx);
  }
  return id;
}

NodeId Converter::nested(Apt::NestedContext* ctx, const Span& parens) {
  if (ctx->definition() != nullptr) {
    const NodeId id = definition(ctx->definition());
    if (ctx->target() != nullptr) {
      const NodeId name = target(ctx->target());
      tree_[id].target = name;
    }
    tree_[id].span = parens;
    return id;
  }
  if (ctx->target() != nullptr) {
    const NodeId name = target(ctx->target());
    const NodeId v = expression(ctx->expression(0));
    const NodeId id = tree_.add(Node::Kind::nestedAssign, parens);
    tree_[id].first = name;
    tree_[id].target = v;
    return id;
  }
  if (ctx->expression().size() == 1) {
    const NodeId id = expression(ctx->expression(0));
    tree_[id].parenthesized = true;
    tree_[id].span = parens;
    return id;
  }
  Chain chain(tree_);
  for (auto* e : ctx->expression()) {
    chain.append(expression(e));
  }
  const NodeId id = tree_.add(Node::Kind::list, parens);
  tree_[id].first = chain.first();
  return id;
}
}  // namespace

/// ANTLR's objects, made once and reused for every statement.
class StatementParser::Grammar {
 public:
  Grammar() : stream_(&source_), parser_(&stream_) {
    parser_.removeErrorListeners();
    parser_.setErrorHandler(std::make_shared<Strategy>());
    parser_.getInterpreter<antlr4::atn::ParserATNSimulator>()->setPredictionMode(antlr4::atn::PredictionMode::SLL);
  }

  std::optional<Diagnostic> parse(std::span<const Token> tokens, StatementTree& tree) {
    source_.reset(tokens);
    stream_.setTokenSource(&source_);
    parser_.setTokenStream(&stream_);
    try {
      Converter(tokens, tree).statement(parser_.statement());
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
};

StatementParser::StatementParser(const Limits& limits) : limits_(limits), grammar_(std::make_unique<Grammar>()) {}
StatementParser::~StatementParser() = default;

std::optional<Diagnostic> StatementParser::parse(std::span<const Token> tokens, StatementTree& tree) {
  if (parsePlain(tokens, tree)) {
    return std::nullopt;
  }
  return parseWithGrammar(tokens, tree);
}

std::optional<Diagnostic> StatementParser::parseWithGrammar(std::span<const Token> tokens, StatementTree& tree) {
  tree.clear();
  if (auto tooDeep = checkShapeLimits(tokens, limits_)) {
    return tooDeep;
  }
  return grammar_->parse(tokens, tree);
}

}  // namespace arelem::frontend
