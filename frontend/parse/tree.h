#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "frontend/lex/token.h"

namespace arelem::frontend {

using NodeId = std::uint32_t;
inline constexpr NodeId noNode = 0xFFFFFFFF;

/// One node of a statement's syntax tree. Children hang on `first` and follow `next`.
struct Node {
  enum class Kind : std::uint8_t {
    omitted,  // empty parameter
    number,   // number
    name,     // text; children: the subscript list of name(...), if hasList
    word,     // word
    string,   // text
    call,     // word: function; children: arguments
    plus,
    negate,  // 1 child
    add,
    subtract,
    multiply,
    divide,
    power,  // 2 children
    compare,
    conjunction,
    disjunction,   // 2 children; compare has `relation`
    negation,      // 1 child: .NOT.
    list,          // (x,y) or (x,y,z): 2 or more children
    nestedAssign,  // (name = expression): children name, value
    definition,    // TYPE/ arguments; `target` when nested with a name
    parameter,     // macro variable or CALL item: text, child value if present
    label          // text: a jump target
  };
  Kind kind = Kind::omitted;
  Word word = Word::END;
  Relation relation = Relation::equal;
  bool hasList = false;        ///< name: parentheses follow
  bool parenthesized = false;  ///< an expression that stood in parentheses
  NodeId first = noNode;
  NodeId next = noNode;
  NodeId target = noNode;  ///< definition: node of its name
  double number = 0.0;
  std::string_view text;
  Span span;
  Span wordSpan;  ///< definition, call: of the word alone
};

/// One statement. Which fields are set depends on the shape.
struct StatementTree {
  enum class Shape : std::uint8_t {
    empty,    // nothing, perhaps a label
    command,  // head [, item ...] [/ arguments]
    assign,   // target = value
    define,   // target = TYPE/ ...: value is the definition node
    macro,    // target = MACRO/ parameters in `arguments`
    call,     // CALL/ items in `arguments`
    branch,   // IF (value) labels in `arguments`
    ifBlock,
    elseIf,
    elseWord,
    endIf,    // value: condition
    doBlock,  // target, then from, to, step in `arguments`
    endDo,
    include  // value: the string
  };
  Shape shape = Shape::empty;
  std::string_view label;
  Span labelSpan;
  NodeId head = noNode;  ///< command: first word; further items follow `next`
  bool slash = false;
  NodeId arguments = noNode;  ///< first of a chain
  NodeId target = noNode;
  NodeId value = noNode;
  std::vector<Node> nodes;

  /// Empties the tree but keeps its memory.
  void clear() {
    std::vector<Node> memory = std::move(nodes);
    memory.clear();
    *this = {};
    nodes = std::move(memory);
  }
  [[nodiscard]] const Node& operator[](NodeId id) const { return nodes[id]; }
  [[nodiscard]] Node& operator[](NodeId id) { return nodes[id]; }
  NodeId add(Node::Kind kind, const Span& span) {
    nodes.emplace_back();
    nodes.back().kind = kind;
    nodes.back().span = span;
    return static_cast<NodeId>(nodes.size() - 1);
  }
  /// A node of one token: its text, number and word.
  NodeId leaf(Node::Kind kind, const Token& token) {
    const NodeId id = add(kind, token.span);
    nodes[id].text = token.text;
    nodes[id].number = token.number;
    nodes[id].word = token.word;
    return id;
  }
};

/// Collects a chain of nodes.
class Chain {
 public:
  explicit Chain(StatementTree& tree) : tree_(tree) {}
  void append(NodeId id) {
    if (first_ == noNode) {
      first_ = id;
    } else {
      tree_[last_].next = id;
    }
    last_ = id;
    ++size_;
  }
  [[nodiscard]] NodeId first() const { return first_; }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  StatementTree& tree_;
  NodeId first_ = noNode;
  NodeId last_ = noNode;
  std::size_t size_ = 0;
};

}  // namespace arelem::frontend
