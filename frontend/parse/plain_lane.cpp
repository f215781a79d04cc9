#include "frontend/parse/parse.h"

namespace arelem::frontend {

namespace {
using enum TokenKind;

/// Reads what needs no recursion. Every function returns false as soon as the statement is not
/// plain.
class PlainLane {
 public:
  PlainLane(std::span<const Token> tokens, StatementTree& tree) : tokens_(tokens), tree_(tree) {}

  bool run() {
    if (tokens_.size() > 2 && (at(0) == number || at(0) == symbol) && at(1) == rightParen) {
      tree_.label = tokens_[0].text;
      tree_.labelSpan = tokens_[0].span;
      i_ = 2;
    }
    if (at(i_) == end) {
      return i_ != 0;
    }
    if (at(i_) == symbol && at(i_ + 1) == equals) {
      return assignment();
    }
    return at(i_) == word && command();
  }

 private:
  [[nodiscard]] TokenKind at(std::size_t i) const {
    return i < tokens_.size() ? tokens_[i].kind : end;
  }

  bool assignment() {
    tree_.target = tree_.leaf(Node::Kind::name, tokens_[i_]);
    i_ += 2;
    if (at(i_) == type && at(i_ + 1) == slash) {
      const Token& typeToken = tokens_[i_];
      tree_.shape = StatementTree::Shape::define;
      tree_.value = tree_.leaf(Node::Kind::definition, typeToken);
      tree_[tree_.value].text = {};
      tree_[tree_.value].wordSpan = typeToken.span;
      i_ += 2;
      NodeId first = noNode;
      if (!items(first)) {
        return false;
      }
      tree_[tree_.value].first = first;
      tree_[tree_.value].span = join(typeToken.span, tokens_[i_ - 1].span);
      return true;
    }
    tree_.shape = StatementTree::Shape::assign;
    return scalar(tree_.value) && at(i_) == end;
  }

  bool command() {
    tree_.shape = StatementTree::Shape::command;
    Chain heads(tree_);
    heads.append(tree_.leaf(Node::Kind::word, tokens_[i_++]));
    while (at(i_) == comma) {
      if (at(i_ + 1) != word && at(i_ + 1) != type) {
        return false;
      }
      heads.append(tree_.leaf(Node::Kind::word, tokens_[i_ + 1]));
      i_ += 2;
    }
    tree_.head = heads.first();
    if (at(i_) == slash) {
      ++i_;
      tree_.slash = true;
      return items(tree_.arguments);
    }
    return at(i_) == end;
  }

  /// item , item , ... up to the end of the statement.
  bool items(NodeId& first) {
    Chain chain(tree_);
    while (true) {
      NodeId id = noNode;
      if (at(i_) == word || at(i_) == type) {
        id = tree_.leaf(Node::Kind::word, tokens_[i_++]);
      } else if (!scalar(id)) {
        return false;
      }
      chain.append(id);
      if (at(i_) != comma) {
        break;
      }
      ++i_;
    }
    first = chain.first();
    return at(i_) == end;
  }

  /// [sign] number | [sign] name, without a subscript.
  bool scalar(NodeId& id) {
    const std::size_t begin = i_;
    const bool signedOne = at(i_) == minus || at(i_) == plus;
    i_ += signedOne ? 1 : 0;
    if (at(i_) != number && at(i_) != symbol) {
      return false;
    }
    id = tree_.leaf(at(i_) == number ? Node::Kind::number : Node::Kind::name, tokens_[i_]);
    ++i_;
    if (signedOne) {
      const bool negative = tokens_[begin].kind == minus;
      const NodeId sign = tree_.add(negative ? Node::Kind::negate : Node::Kind::plus,
                                    join(tokens_[begin].span, tokens_[i_ - 1].span));
      tree_[sign].first = id;
      id = sign;
    }
    return true;
  }

  std::span<const Token> tokens_;
  StatementTree& tree_;
  std::size_t i_ = 0;
};
}  // namespace

bool parsePlain(std::span<const Token> tokens, StatementTree& tree) {
  tree.clear();
  if (PlainLane(tokens, tree).run()) {
    return true;
  }
  tree.clear();
  return false;
}

}  // namespace arelem::frontend
