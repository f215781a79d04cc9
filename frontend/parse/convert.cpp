#include "frontend/parse/raw_tree.h"

namespace arelem::frontend {

namespace {
using Kind = Node::Kind;
using Shape = StatementTree::Shape;

Kind binaryKind(TokenKind op) {
  switch (op) {
    case TokenKind::plus:
      return Kind::add;
    case TokenKind::minus:
      return Kind::subtract;
    case TokenKind::star:
      return Kind::multiply;
    case TokenKind::slash:
      return Kind::divide;
    case TokenKind::power:
      return Kind::power;
    case TokenKind::andOp:
      return Kind::conjunction;
    case TokenKind::orOp:
      return Kind::disjunction;
    default:
      return Kind::compare;
  }
}

/// Walks the raw tree by rule. Its depth is bounded by checkShapeLimits.
class Converter {
 public:
  Converter(const RawTree& raw, std::span<const Token> tokens, StatementTree& tree)
      : raw_(raw), tokens_(tokens), tree_(tree) {}

  void statement(const RawNode& n) {
    for (std::uint32_t i = 0; i < n.count; ++i) {
      const RawNode& c = child(n, i);
      if (c.rule == Rule::label) {
        tree_.label = tokens_[c.token].text;
        tree_.labelSpan = tokens_[c.token].span;
      } else if (c.rule == Rule::body) {
        body(c);
      }
    }
  }

 private:
  [[nodiscard]] const RawNode& child(const RawNode& n, std::uint32_t i) const {
    return raw_.nodes[raw_.children[n.child + i]];
  }
  [[nodiscard]] bool isToken(const RawNode& n, TokenKind kind) const {
    return n.rule == Rule::token && tokens_[n.token].kind == kind;
  }
  [[nodiscard]] Span spanOf(const RawNode& n) const {
    const Span& begin = tokens_[n.token].span;
    return n.last < n.token ? Span{begin.buffer, begin.begin, 0}
                            : join(begin, tokens_[n.last].span);
  }
  /// The child at or after `from` of this rule, or nullptr.
  [[nodiscard]] const RawNode* find(const RawNode& n, Rule rule, std::uint32_t from = 0) const {
    for (std::uint32_t i = from; i < n.count; ++i) {
      if (child(n, i).rule == rule) {
        return &child(n, i);
      }
    }
    return nullptr;
  }

  void body(const RawNode& n) {
    const RawNode& first = child(n, 0);
    if (first.rule == Rule::target) {
      assignment(n);
      return;
    }
    if (first.rule == Rule::word) {
      command(n);
      return;
    }
    switch (tokens_[first.token].kind) {
      case TokenKind::ifWord:
        branch(n);
        return;
      case TokenKind::elseIf:
        tree_.shape = Shape::elseIf;
        tree_.value = expression(child(n, 2));
        return;
      case TokenKind::elseWord:
        tree_.shape = Shape::elseWord;
        return;
      case TokenKind::endIf:
        tree_.shape = Shape::endIf;
        return;
      case TokenKind::endDo:
        tree_.shape = Shape::endDo;
        return;
      case TokenKind::doWord:
        doBlock(n);
        return;
      case TokenKind::include:
        tree_.shape = Shape::include;
        tree_.value = tree_.leaf(Kind::string, tokens_[child(n, 2).token]);
        return;
      default:
        call(n);
        return;
    }
  }

  void assignment(const RawNode& n) {
    tree_.target = target(child(n, 0));
    const RawNode& value = child(n, 2);
    if (value.rule == Rule::definition) {
      tree_.shape = Shape::define;
      tree_.value = definition(value);
    } else if (value.rule == Rule::expression) {
      tree_.shape = Shape::assign;
      tree_.value = expression(value);
    } else {
      tree_.shape = Shape::macro;
      tree_.slash = n.count > 3;
      Chain chain(tree_);
      for (std::uint32_t i = 3; i < n.count; ++i) {
        if (child(n, i).rule == Rule::parameter) {
          chain.append(parameter(child(n, i)));
        }
      }
      tree_.arguments = chain.first();
    }
  }

  /// name [= value]
  NodeId parameter(const RawNode& n) {
    const NodeId id = tree_.leaf(Kind::parameter, tokens_[n.token]);
    if (const RawNode* given = find(n, Rule::value)) {
      const NodeId v = argument(*given);
      tree_[id].first = v;
    }
    return id;
  }

  void command(const RawNode& n) {
    tree_.shape = Shape::command;
    Chain heads(tree_);
    for (std::uint32_t i = 0; i < n.count; ++i) {
      const RawNode& c = child(n, i);
      if (c.rule == Rule::word) {
        heads.append(tree_.leaf(Kind::word, tokens_[c.token]));
      } else if (c.rule == Rule::argument) {
        heads.append(argument(c));
      } else if (c.rule == Rule::arguments) {
        tree_.arguments = arguments(c);
      } else if (isToken(c, TokenKind::slash)) {
        tree_.slash = true;
      }
    }
    tree_.head = heads.first();
  }

  void call(const RawNode& n) {
    tree_.shape = Shape::call;
    Chain chain(tree_);
    for (std::uint32_t i = 0; i < n.count; ++i) {
      const RawNode& item = child(n, i);
      if (item.rule == Rule::callItem) {
        const RawNode* plain = find(item, Rule::argument);
        chain.append(plain != nullptr ? argument(*plain) : parameter(item));
      }
    }
    tree_.arguments = chain.first();
  }

  void branch(const RawNode& n) {
    tree_.value = expression(child(n, 2));
    const RawNode& to = child(n, n.count - 1);
    tree_.shape = isToken(child(to, 0), TokenKind::then) ? Shape::ifBlock : Shape::branch;
    Chain chain(tree_);
    for (std::uint32_t i = 0; i < to.count; ++i) {
      if (child(to, i).rule == Rule::labelName) {
        chain.append(tree_.leaf(Kind::label, tokens_[child(to, i).token]));
      }
    }
    tree_.arguments = chain.first();
  }

  void doBlock(const RawNode& n) {
    tree_.shape = Shape::doBlock;
    tree_.target = target(child(n, 2));
    Chain chain(tree_);
    for (std::uint32_t i = 3; i < n.count; ++i) {
      if (child(n, i).rule == Rule::expression) {
        chain.append(expression(child(n, i)));
      }
    }
    tree_.arguments = chain.first();
  }

  NodeId target(const RawNode& n) {
    const Token& t = tokens_[n.token];
    const NodeId id = tree_.leaf(isWordKind(t.kind) ? Kind::word : Kind::name, t);
    if (n.count > 1) {
      const NodeId subscript = expression(child(n, 2));
      tree_[id].first = subscript;
      tree_[id].hasList = true;
      tree_[id].span = spanOf(n);
    }
    return id;
  }

  NodeId definition(const RawNode& n) {
    const Token& type = tokens_[n.token];
    const NodeId id = tree_.leaf(Kind::definition, type);
    tree_[id].text = {};
    tree_[id].wordSpan = type.span;
    const NodeId first = arguments(child(n, 2));
    tree_[id].first = first;
    tree_[id].span = spanOf(n);
    return id;
  }

  NodeId arguments(const RawNode& n) {
    Chain chain(tree_);
    for (std::uint32_t i = 0; i < n.count; ++i) {
      if (child(n, i).rule != Rule::token) {
        chain.append(argument(child(n, i)));
      }
    }
    const bool nothing = chain.size() == 1 && tree_[chain.first()].kind == Kind::omitted;
    return nothing ? noNode : chain.first();
  }

  /// Of an argument or value: an expression, a word, a string, or nothing. Also of a word alone.
  NodeId argument(const RawNode& n) {
    if (n.rule == Rule::word) {
      return tree_.leaf(Kind::word, tokens_[n.token]);
    }
    if (n.count == 0) {
      return tree_.add(Kind::omitted, spanOf(n));
    }
    const RawNode& inner = child(n, 0);
    if (inner.rule == Rule::expression) {
      return expression(inner);
    }
    return tree_.leaf(inner.rule == Rule::word ? Kind::word : Kind::string, tokens_[inner.token]);
  }

  NodeId expression(const RawNode& n) {
    if (n.count == 1) {
      return primary(child(n, 0));
    }
    if (n.count == 2) {
      const TokenKind sign = tokens_[n.token].kind;
      const NodeId operand = expression(child(n, 1));
      const Kind kind = sign == TokenKind::minus  ? Kind::negate
                        : sign == TokenKind::plus ? Kind::plus
                                                  : Kind::negation;
      const NodeId id = tree_.add(kind, spanOf(n));
      tree_[id].first = operand;
      return id;
    }
    const Token& op = tokens_[child(n, 1).token];
    const NodeId left = expression(child(n, 0));
    const NodeId right = expression(child(n, 2));
    const NodeId id = tree_.add(binaryKind(op.kind), spanOf(n));
    tree_[id].relation = op.relation;
    tree_[id].first = left;
    tree_[left].next = right;
    return id;
  }

  NodeId primary(const RawNode& n) {
    if (const RawNode* inner = find(n, Rule::nested)) {
      return nested(*inner, spanOf(n));
    }
    const Token& t = tokens_[n.token];
    if (t.kind == TokenKind::number) {
      return tree_.leaf(Kind::number, t);
    }
    const NodeId id = tree_.leaf(t.kind == TokenKind::function ? Kind::call : Kind::name, t);
    tree_[id].wordSpan = t.span;
    if (const RawNode* list = find(n, Rule::arguments)) {
      const NodeId first = arguments(*list);
      tree_[id].first = first;
      tree_[id].hasList = true;
      tree_[id].span = spanOf(n);
    }
    return id;
  }

  NodeId nested(const RawNode& n, const Span& parens) {
    const RawNode* name = find(n, Rule::target);
    if (const RawNode* inner = find(n, Rule::definition)) {
      const NodeId id = definition(*inner);
      if (name != nullptr) {
        const NodeId to = target(*name);
        tree_[id].target = to;
      }
      tree_[id].span = parens;
      return id;
    }
    if (name != nullptr) {
      const NodeId to = target(*name);
      const NodeId value = expression(child(n, 2));
      const NodeId id = tree_.add(Kind::nestedAssign, parens);
      tree_[id].first = to;
      tree_[id].target = value;
      return id;
    }
    if (n.count == 1) {
      const NodeId id = expression(child(n, 0));
      tree_[id].parenthesized = true;
      tree_[id].span = parens;
      return id;
    }
    Chain chain(tree_);
    for (std::uint32_t i = 0; i < n.count; i += 2) {
      chain.append(expression(child(n, i)));
    }
    const NodeId id = tree_.add(Kind::list, parens);
    tree_[id].first = chain.first();
    return id;
  }

  const RawTree& raw_;
  std::span<const Token> tokens_;
  StatementTree& tree_;
};
}  // namespace

void convert(const RawTree& raw, std::span<const Token> tokens, StatementTree& tree) {
  Converter(raw, tokens, tree).statement(raw.nodes.back());
}

}  // namespace arelem::frontend
