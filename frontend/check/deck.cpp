// READ/1: a deck of canonical forms between the statement and ENDPCH, a line an item:
//   name, subscript, type, count, values ...     (type SCALAR for a number)
#include <cmath>

#include "frontend/check/program_reader.h"
#include "frontend/read/characters.h"
#include "ir/diag/frontend.h"

namespace arelem::frontend {

namespace {
std::vector<std::string> fields(std::string_view line) {
  std::vector<std::string> result(1);
  for (const char c : line) {
    if (c == ',') {
      result.emplace_back();
    } else if (!isBlank(c) && c != '\r') {
      result.back() += upper(c);
    }
  }
  return result;
}

std::optional<double> number(const std::string& text) {
  if (text.empty()) {
    return std::nullopt;
  }
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool plain = text.find_first_not_of("0123456789+-.E") == std::string::npos;
  return plain && end == text.c_str() + text.size() && std::isfinite(value) ? std::optional(value)
                                                                            : std::nullopt;
}
}  // namespace

bool ProgramReader::deckLine(std::string_view line, const Span& at, Frame& frame) {
  const std::vector<std::string> f = fields(line);
  constexpr std::size_t lead = 4;  // name, subscript, type, count
  const auto word = f.size() > lead ? findWord(f[2]) : std::nullopt;
  const auto type = word ? entityType(*word) : std::nullopt;
  const bool scalar = f.size() == lead + 1 && f[2] == "SCALAR";
  const auto subscript = f.size() > lead ? number(f[1]) : std::nullopt;
  const auto count = f.size() > lead ? number(f[3]) : std::nullopt;
  if ((!type && !scalar) || !subscript || !count ||
      *count != static_cast<double>(f.size() - lead) || f[0].empty() ||
      context_.vocabulary.find(f[0])) {
    return false;
  }
  std::vector<ir::Argument> values(1 + f.size() - lead);
  values.front().value = Word::CANON;
  values.front().span = at;
  for (std::size_t i = lead; i < f.size(); ++i) {
    const auto value = number(f[i]);
    if (!value) {
      return false;
    }
    values[1 + i - lead].value = frame.values.number(*value, at);
    values[1 + i - lead].span = at;
  }
  StatementTree tree;
  const NodeId name = tree.add(Node::Kind::name, at);
  tree[name].text = f[0];
  if (*subscript != 0.0) {
    const NodeId index = tree.add(Node::Kind::number, at);
    tree[index].number = *subscript;
    tree[name].hasList = true;
    tree[name].first = index;
  }
  frame.values.setTree(tree);
  const auto kind = scalar ? NameFacts::Class::scalar : NameFacts::Class::entity;
  const EntityType entity = scalar ? EntityType::point : *type;
  const auto target = frame.values.target(name, kind, entity);
  frame.values.markDefined(name);
  frame.values.setTree(frame.tree);
  if (!target) {
    return true;
  }
  if (scalar) {
    frame.block.emit(ir::Assign{*target, std::get<ir::ExprId>(values.back().value)});
    return true;
  }
  ir::Definition d;
  d.type = entity;
  d.typeSpan = at;
  d.target = *target;
  d.arguments = std::move(values);
  d.span = at;
  context_.program.definitions.push_back(std::move(d));
  frame.block.emit(
      ir::Define{{static_cast<std::uint32_t>(context_.program.definitions.size() - 1)}});
  return true;
}

void ProgramReader::readDeck(Frame& frame) {
  std::string_view line;
  const Origin origin = frame.block.origin();
  while (reader_->nextLine(line)) {
    const auto begin =
        static_cast<std::uint32_t>(line.data() - context_.sources.text(buffer_).data());
    const Span at{buffer_, begin, static_cast<std::uint32_t>(line.size())};
    ++isn_;
    const std::vector<std::string> f = fields(line);
    if (f.front() == "ENDPCH") {
      return;
    }
    frame.block.setOrigin({at, origin.isn, {}});
    if (!deckLine(line, at, frame)) {
      context_.report(diagnose(at, diag::ReadDeck));
      return;
    }
  }
  context_.report(diagnose(origin.span, diag::ReadDeck).note("the deck has no ENDPCH"));
}

}  // namespace arelem::frontend
