#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "frontend/parse/tree.h"

namespace arelem::frontend {

/// The rules of grammar/AptParser.g4, in their order there.
enum class Rule : std::uint8_t {
  statement,
  label,
  body,
  branch,
  labelName,
  target,
  definition,
  parameter,
  callItem,
  value,
  arguments,
  argument,
  word,
  expression,
  primary,
  nested,
  token
};

/// What the generated parser found, without its types: rules with their children, tokens by index.
struct RawNode {
  Rule rule = Rule::token;
  std::uint32_t token = 0;  ///< of a token; for rules the first token
  std::uint32_t last = 0;   ///< last token of a rule; below `token` when the rule matched nothing
  std::uint32_t child = 0;  ///< index of the first child in RawTree::children
  std::uint32_t count = 0;  ///< number of children
};

struct RawTree {
  std::vector<RawNode> nodes;
  std::vector<std::uint32_t> children;  ///< indices into nodes, the children of a node side by side
  void clear() {
    nodes.clear();
    children.clear();
  }
};

/// Builds our tree from the raw one, whose root (a statement) is the last node.
void convert(const RawTree& raw, std::span<const Token> tokens, StatementTree& tree);

}  // namespace arelem::frontend
