#pragma once
#include <optional>

#include "frontend/check/context.h"
#include "frontend/parse/tree.h"

namespace arelem::frontend {

/// What a parameter list admits beside numbers, words and entities.
struct ArgumentRules {
  std::string_view owner;      ///< for messages: "POINT", "SPINDL", ...
  bool omitted = false;        ///< empty parameters
  bool ranges = false;         ///< A(a,THRU,b)
  bool shortPoints = false;    ///< (x,y)
  bool unknownAsText = false;  ///< undefined names become text, with a warning
  bool silentText = false;     ///< ... without one
  bool strings = false;        ///< texts in quotes
  bool bare = false;           ///< expressions need no parentheses (function arguments)
};

/// Syntax trees to the program's expressions, arguments and definitions. Every function reports
/// what is wrong and then returns nothing.
class Values {
 public:
  explicit Values(Context& context) : context_(context) {}
  void setTree(const StatementTree& tree) { tree_ = &tree; }
  [[nodiscard]] const StatementTree& tree() const { return *tree_; }

  std::optional<ir::ExprId> expression(NodeId id);
  std::optional<ir::Argument> argument(NodeId id, const ArgumentRules& rules);
  /// The whole chain that starts at `first`; all its errors are reported.
  std::optional<std::vector<ir::Argument>> arguments(NodeId first, const ArgumentRules& rules);
  /// TYPE/ parameters. The target, if any, becomes defined even when the definition has an error.
  std::optional<ir::DefinitionId> definition(NodeId id, NodeId target);
  /// The left side of `=`: fixes or checks the class of the name.
  std::optional<ir::Target> target(NodeId id, NameFacts::Class kind, EntityType type);
  void markDefined(NodeId target);
  /// The type of an argument that is an entity.
  [[nodiscard]] std::optional<EntityType> entityOf(const ir::Argument& argument) const;
  /// A literal number (with sign), if the argument is one.
  [[nodiscard]] std::optional<double> literal(const ir::Argument& argument) const;
  [[nodiscard]] std::optional<double> literal(ir::ExprId id) const;
  [[nodiscard]] bool isScalar(const ir::Argument& argument) const;
  [[nodiscard]] std::string_view describe(const ir::Argument& argument) const;

  ir::ExprId add(ir::Expr expr);
  ir::ExprId number(double value, const Span& span);
  ir::ExprId binary(ir::Expr::Kind kind, ir::ExprId left, ir::ExprId right, const Span& span);
  ir::SymbolId symbol(std::string_view name, NameFacts& facts);
  /// Reports an undefined name, with near names, and poisons it.
  void undefined(const Node& node);

 private:
  std::optional<ir::ExprId> nameValue(const Node& node);
  std::optional<ir::ExprId> call(const Node& node);
  std::optional<ir::ExprId> nestedAssign(const Node& node);
  std::optional<ir::ExprId> unary(const Node& node, ir::Expr::Kind kind);
  std::optional<ir::ExprId> binaryNode(const Node& node, ir::Expr::Kind kind);
  std::optional<ir::Argument> nameArgument(const Node& node, const ArgumentRules& rules);
  std::optional<ir::Argument> shortPoint(const Node& node, const ArgumentRules& rules);
  std::optional<ir::Argument> range(const Node& node, NameFacts& facts, const ArgumentRules& rules);
  std::optional<ir::Target> use(const Node& node, NameFacts& facts);
  std::optional<ir::ExprId> subscript(const Node& node, const NameFacts& facts);
  bool usable(const Node& node, NameFacts* facts);
  bool checkFunction(const Node& node, const std::vector<ir::Argument>& arguments);
  bool checkBare(const Node& node, const ArgumentRules& rules);
  [[nodiscard]] bool isRange(const Node& node) const;

  Context& context_;
  const StatementTree* tree_ = nullptr;
};

}  // namespace arelem::frontend
