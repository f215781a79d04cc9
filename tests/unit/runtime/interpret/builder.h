#pragma once
#include <string>
#include <vector>

#include "ir/program/program.h"
#include "runtime/run.h"

/// Builds programs by hand, so that Section 1 is tested without the reader of texts.
namespace arelem::test {

class Builder {
 public:
  Builder() { program.blocks.emplace_back(); }

  // Names.
  ir::SymbolId scalar(std::string name, std::uint32_t size = 0) {
    return symbol({std::move(name), ir::Symbol::Kind::scalar, EntityType::point, size, {}});
  }
  ir::SymbolId entity(std::string name, EntityType type, std::uint32_t size = 0) {
    return symbol({std::move(name), ir::Symbol::Kind::entity, type, size, {}});
  }
  ir::Target at(ir::SymbolId symbol) { return {symbol, {}, place()}; }
  ir::Target at(ir::SymbolId symbol, ir::ExprId subscript) { return {symbol, subscript, place()}; }

  // Expressions.
  ir::ExprId num(double value) {
    ir::Expr e;
    e.number = value;
    return add(std::move(e));
  }
  ir::ExprId use(ir::Target target) {
    ir::Expr e;
    e.kind = ir::Expr::Kind::symbol;
    e.target = target;
    return add(std::move(e));
  }
  ir::ExprId use(ir::SymbolId symbol) { return use(at(symbol)); }
  ir::ExprId op(ir::Expr::Kind kind, ir::ExprId left, ir::ExprId right = {}) {
    ir::Expr e;
    e.kind = kind;
    e.left = left;
    e.right = right;
    return add(std::move(e));
  }
  ir::ExprId nestedAssign(ir::SymbolId symbol, ir::ExprId value) {
    ir::Expr e;
    e.kind = ir::Expr::Kind::assign;
    e.target = at(symbol);
    e.left = value;
    return add(std::move(e));
  }
  ir::ExprId call(Word function, std::vector<ir::Argument::Value> arguments) {
    ir::Expr e;
    e.kind = ir::Expr::Kind::call;
    e.function = function;
    e.arguments = args(std::move(arguments));
    return add(std::move(e));
  }

  // Arguments. A double stands for a number, a symbol for an entity.
  std::vector<ir::Argument> args(std::vector<ir::Argument::Value> values) {
    std::vector<ir::Argument> result;
    for (ir::Argument::Value& value : values) {
      result.push_back({std::move(value), place()});
    }
    return result;
  }
  ir::Argument arg(ir::Argument::Value value) { return {std::move(value), place()}; }
  std::vector<ir::Argument::Value> numbers(const std::vector<double>& values) {
    std::vector<ir::Argument::Value> result;
    for (const double value : values) {
      result.emplace_back(num(value));
    }
    return result;
  }
  ir::DefinitionId definition(EntityType type,
                              ir::Target target,
                              std::vector<ir::Argument::Value> arguments) {
    program.definitions.push_back({type, place(), target, args(std::move(arguments)), place()});
    return {static_cast<std::uint32_t>(program.definitions.size() - 1)};
  }

  // Statements of the block being built.
  std::uint32_t put(ir::Body body, std::string label = "") {
    ir::Statement s;
    s.span = place();
    s.isn = ++isn_;
    s.label = std::move(label);
    s.body = std::move(body);
    program.blocks[block].statements.push_back(std::move(s));
    return static_cast<std::uint32_t>(program.blocks[block].statements.size() - 1);
  }
  std::uint32_t assign(ir::SymbolId symbol, ir::ExprId value, std::string label = "") {
    return put(ir::Assign{at(symbol), value}, std::move(label));
  }
  std::uint32_t define(ir::SymbolId symbol, std::vector<ir::Argument::Value> arguments) {
    return put(ir::Define{definition(program[symbol].type, at(symbol), std::move(arguments))});
  }
  std::uint32_t command(Word word, std::vector<ir::Argument::Value> arguments = {}) {
    return put(ir::Command{word, !arguments.empty(), args(std::move(arguments))});
  }
  std::uint32_t locate(Word word, std::vector<ir::Argument::Value> arguments) {
    return put(ir::Locate{word, args(std::move(arguments))});
  }
  ir::LabelRef to(std::uint32_t statement) { return {statement, "", place()}; }
  /// Statements after this go into a new block.
  ir::BlockId newBlock(std::string name) {
    program.blocks.push_back({std::move(name), {}});
    block = program.blocks.size() - 1;
    return {static_cast<std::uint32_t>(block)};
  }

  runtime::Evaluation run() { return runtime::evaluate(program, options, sink); }
  /// The old numbers of what was reported, or the codes where there is none.
  std::vector<std::string> reported() const {
    std::vector<std::string> result;
    for (const Diagnostic& d : sink.all()) {
      const DiagRow& row = d.kind();
      result.emplace_back(row.legacy.empty() ? row.code : row.legacy);
    }
    return result;
  }

  ir::Program program;
  runtime::Options options;
  CollectingSink sink;
  std::size_t block = 0;

 private:
  ir::SymbolId symbol(ir::Symbol s) {
    program.symbols.push_back(std::move(s));
    return {static_cast<std::uint32_t>(program.symbols.size() - 1)};
  }
  ir::ExprId add(ir::Expr e) {
    e.span = place();
    program.exprs.push_back(std::move(e));
    return {static_cast<std::uint32_t>(program.exprs.size() - 1)};
  }
  /// A place of its own for everything, as in a text.
  Span place() { return {{0}, ++place_, 1}; }

  std::uint32_t place_ = 0;
  std::uint32_t isn_ = 0;
};

}  // namespace arelem::test
