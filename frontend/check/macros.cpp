// MACRO, TERMAC, CALL: recording of bodies and their instances.
#include <utility>

#include "frontend/check/program_reader.h"
#include "ir/diag/frontend.h"

namespace arelem::frontend {

namespace {
using Kind = Node::Kind;
constexpr std::size_t maxVariables = 50;
constexpr std::size_t maxInstances = 100'000;

bool isForbiddenValue(Word word) {
  return row(word).wordClass == WordClass::fixedField || word == Word::CALL ||
         word == Word::MACRO || word == Word::TERMAC;
}
}  // namespace

void ProgramReader::recordForbidden(const Token& head, const Token& next) {
  if (next.kind == TokenKind::rightParen || head.kind != TokenKind::word) {
    return;
  }
  if (head.word == Word::SYN) {
    context_.report(diagnose(head.span, diag::SynonymPlace));
  } else if (head.word == Word::RESERV) {
    context_.report(diagnose(head.span, diag::ReservPlace));
  } else if (head.word == Word::LOOPST || head.word == Word::LOOPND) {
    context_.report(diagnose(head.span, diag::ForbiddenInMacro, spell(head.word)));
  }
}

/// Keeps a statement of a macro body. False when it is FINI, which ends the macro and the program.
bool ProgramReader::record(const StatementText& statement, const std::vector<Token>& tokens) {
  const std::size_t first = tokens.size() > 2 && tokens[1].kind == TokenKind::rightParen ? 2 : 0;
  const Token& head = tokens[first];
  const bool nested = first + 2 < tokens.size() && tokens[first + 1].kind == TokenKind::equals &&
                      tokens[first + 2].kind == TokenKind::macro;
  if (nested) {
    context_.report(diagnose(head.span, diag::MacroInArea, "macro"));
    ++nestedMacros_;
    return true;
  }
  if (head.kind == TokenKind::word && head.word == Word::FINI) {
    context_.report(diagnose(recording_->definition, diag::MacroNotEnded, recording_->name));
    recording_ = nullptr;
    return false;
  }
  const bool termac = head.kind == TokenKind::word && head.word == Word::TERMAC;
  if (nestedMacros_ > 0) {
    nestedMacros_ -= termac ? 1 : 0;
    return true;
  }
  const bool forbidden =
      head.kind == TokenKind::word && (head.word == Word::SYN || head.word == Word::RESERV ||
                                       head.word == Word::LOOPST || head.word == Word::LOOPND);
  if (forbidden) {
    recordForbidden(head, tokens[first + 1]);
    return true;
  }
  recording_->body.push_back(store(statement, tokens));
  if (termac) {
    recording_ = nullptr;
  }
  return true;
}

void ProgramReader::addVariable(Macro& macro, const Node& node, const StatementTree& tree) {
  if (node.word != Word::END || findWord(node.text) == Word::END) {
    context_.report(
        diagnose(node.span, diag::MacroVariable, node.text, "it is a word of the language"));
    return;
  }
  for (const MacroVariable& other : macro.variables) {
    if (other.name == node.text) {
      context_.report(diagnose(node.span, diag::MacroVariable, node.text, "it is given twice"));
      return;
    }
  }
  MacroVariable variable;
  variable.name = node.text;
  if (node.first != noNode) {
    Token token;
    if (valueToken(tree[node.first], tree, token)) {
      variable.text = std::make_unique<const std::string>(token.text);
      token.text = *variable.text;
      variable.value.push_back(token);
    } else {
      variable.refused = true;
    }
  }
  macro.variables.push_back(std::move(variable));
}

void ProgramReader::beginMacro(Frame& frame) {
  const StatementTree& tree = frame.tree;
  const Node& name = tree[tree.target];
  Macro macro;
  macro.name = name.text;
  macro.definition = frame.block.origin().span;
  if (frame.block.inArea()) {
    context_.report(diagnose(name.span, diag::MacroInArea, frame.block.areaName()));
  }
  if (!tree.slash || name.hasList) {
    context_.report(diagnose(frame.block.origin().span, diag::MacroFormat));
  }
  for (NodeId id = tree.arguments; id != noNode; id = tree[id].next) {
    addVariable(macro, tree[id], tree);
  }
  if (!context_.options.takes(&DialectRules::largeSizes) && macro.variables.size() > maxVariables) {
    context_.report(diagnose(name.span, diag::TooManyVariables, macro.variables.size()));
  }
  NameFacts& facts = context_.names.at(name.text);
  const bool taken =
      facts.defined ||
      (facts.kind != NameFacts::Class::macro && facts.kind != NameFacts::Class::unknown) ||
      name.kind != Kind::name;
  if (taken) {
    context_.report(diagnose(name.span, diag::MacroNameTaken, name.text));
    macro.name += " (again)";  // its body is still read
  } else {
    facts.kind = NameFacts::Class::macro;
    facts.defined = true;
    facts.definition = name.span;
  }
  context_.reporter.used(ir::Feature::CT_04);
  const std::string key = macro.name;
  recording_ = &(macros_[key] = std::move(macro));
  nestedMacros_ = 0;
}

/// A macro value: a name, a number with its sign, or a word.
bool ProgramReader::valueToken(const Node& node, const StatementTree& tree, Token& token) {
  const bool sign = node.kind == Kind::negate || node.kind == Kind::plus;
  const Node& inner = sign ? tree[node.first] : node;
  token.text = inner.text;
  token.span = node.span;
  const bool number = inner.kind == Kind::number;
  const bool name = inner.kind == Kind::name && !inner.hasList && !sign;
  const bool word = inner.kind == Kind::word && !sign && !isForbiddenValue(inner.word);
  if ((!number && !name && !word) || inner.parenthesized) {
    context_.report(diagnose(node.span, diag::BadMacroValue));
    return false;
  }
  token.kind = number ? TokenKind::number : name ? TokenKind::symbol : kindOf(inner.word);
  token.word = inner.word;
  token.number = node.kind == Kind::negate ? -inner.number : inner.number;
  return true;
}

bool ProgramReader::loadMacro(const std::string& name, const Span& at) {
  const auto buffer = library_.loadNamed(name, at);
  libraryNames_.erase(name);
  if (!buffer || !checkBuffer(*buffer)) {
    return false;
  }
  Frame frame(context_, {0}, BlockWriter::Area::program);
  readBuffer(*buffer, frame);
  if (recording_ != nullptr) {
    context_.report(diagnose(recording_->definition, diag::MacroNotEnded, recording_->name));
    recording_ = nullptr;
  }
  if (!macros_.contains(name)) {
    context_.report(diagnose(at, diag::LibraryWithoutMacro, context_.sources.name(*buffer), name));
    return false;
  }
  return true;
}

Macro* ProgramReader::findMacro(const Node& name) {
  const std::string key(name.text);
  if (!macros_.contains(key)) {
    if (libraryNames_.contains(key)) {
      if (!loadMacro(key, name.span)) {
        return nullptr;
      }
    } else {
      Diagnostic d = diagnose(name.span, diag::NotAMacro, name.text);
      const NameFacts* facts = context_.names.find(name.text);
      if (facts != nullptr && facts->kind == NameFacts::Class::macro) {
        d.labels.push_back({facts->definition, "it is defined here, after this CALL"});
      }
      context_.report(std::move(d));
      return nullptr;
    }
  }
  return &macros_.find(key)->second;
}

bool ProgramReader::bindValues(const StatementTree& tree,
                               const Macro& macro,
                               std::map<std::string_view, Token>& values) {
  bool ok = true;
  for (NodeId id = tree[tree.arguments].next; id != noNode; id = tree[id].next) {
    const Node& item = tree[id];
    if (item.kind != Kind::parameter) {
      context_.report(diagnose(item.span, diag::CallNeedsEquals));
      ok = false;
      continue;
    }
    const MacroVariable* variable = nullptr;
    for (const MacroVariable& v : macro.variables) {
      variable = v.name == item.text ? &v : variable;
    }
    Token token;
    if (variable == nullptr) {
      context_.report(diagnose(item.span, diag::UnknownVariable, item.text, macro.name));
      ok = false;
    } else if (!valueToken(tree[item.first], tree, token)) {
      ok = false;
    } else if (!values.emplace(variable->name, token).second) {
      context_.report(diagnose(item.span, diag::VariableTwice, item.text));
      ok = false;
    }
  }
  for (const MacroVariable& v : macro.variables) {
    if (!values.contains(v.name) && !v.value.empty()) {
      values.emplace(v.name, v.value.front());
    } else if (ok && !values.contains(v.name)) {
      if (!v.refused) {
        context_.report(
            diagnose(tree[tree.arguments].span, diag::VariableWithoutValue, v.name, macro.name));
      }
      ok = false;
    }
  }
  return ok;
}

void ProgramReader::call(Frame& frame) {
  const StatementTree& tree = frame.tree;
  const Span at = frame.block.origin().span;
  if (tree.arguments == noNode || tree[tree.arguments].kind != Kind::name ||
      tree[tree.arguments].hasList) {
    context_.report(diagnose(at, diag::CallFormat));
    return;
  }
  const Node& name = tree[tree.arguments];
  const Node* second = name.next == noNode ? nullptr : &tree[name.next];
  if (second != nullptr && second->kind == Kind::word &&
      row(second->word).wordClass == WordClass::phase) {
    const NodeId value = second->next;
    const bool named =
        value != noNode && tree[value].kind == Kind::parameter && tree[value].first != noNode;
    context_.reporter.used(named ? ir::Feature::CT_09 : ir::Feature::CT_08);
    context_.report(diagnose(name.span, diag::UserProgram, name.text));
    return;
  }
  Macro* macro = findMacro(name);
  std::map<std::string_view, Token> values;
  if (macro == nullptr || !bindValues(tree, *macro, values)) {
    return;
  }
  macro->called = true;
  const ir::BlockId block = instantiate(*macro, values, at);
  if (block.valid()) {
    frame.block.emit(ir::Call{block, macro->name});
  }
}

ir::BlockId ProgramReader::instantiate(Macro& macro,
                                       const std::map<std::string_view, Token>& values,
                                       const Span& at) {
  std::string key = macro.name;
  for (const auto& [variable, token] : values) {
    key += fmt::format(",{}{}{}", static_cast<int>(token.kind), token.number < 0.0 ? '-' : '=',
                       token.text);
  }
  if (const auto found = instances_.find(key); found != instances_.end()) {
    return found->second;
  }
  if (context_.reporter.callDepth() >= context_.options.limits.depth) {
    context_.report(diagnose(at, diag::CallTooDeep, context_.options.limits.depth));
    return {};
  }
  if (instances_.size() >= maxInstances) {
    context_.report(diagnose(at, diag::TooManyInstances, maxInstances));
    return {};
  }
  const ir::BlockId id{static_cast<std::uint32_t>(context_.program.blocks.size())};
  context_.program.blocks.emplace_back();
  context_.program.blocks.back().name = macro.name;
  instances_.emplace(std::move(key), id);
  const bool lenient = std::exchange(context_.lenient, true);
  context_.reporter.enterCall(at);
  const auto frame = std::make_unique<Frame>(context_, id, BlockWriter::Area::macro);
  std::vector<Token> tokens;
  for (const StoredStatement& s : macro.body) {
    frame->block.setOrigin({s.span, s.isn, s.cardId});
    if (s.kind == StatementText::Kind::fixed) {
      if (s.fixedWord != Word::REMARK) {
        frame->block.emit(ir::Text{s.fixedWord, s.fixedText});
      }
      continue;
    }
    substitute(s.tokens, values, tokens);
    lower(tokens, *frame);
  }
  frame->control.finish();
  frame->block.finish();
  context_.reporter.leaveCall();
  context_.lenient = lenient;
  return id;
}

/// Macros that no CALL instantiates: the syntax of their statements is checked, as far as no
/// variable may stand for a word.
void ProgramReader::checkUncalled() {
  StatementTree tree;
  for (const auto& [name, macro] : macros_) {
    for (const StoredStatement& s : macro.body) {
      bool open = macro.called || s.kind != StatementText::Kind::tokens;
      for (const MacroVariable& v : macro.variables) {
        for (const Token& t : s.tokens) {
          open = open || t.text == v.name;
        }
      }
      const std::span<const Token> tokens(s.tokens);
      const bool label = tokens.size() > 2 && tokens[1].kind == TokenKind::rightParen;
      if (open || (label && tokens.size() == 3)) {
        continue;
      }
      if (auto error = parser_.parse(tokens.subspan(label ? 2 : 0), tree)) {
        context_.report(*std::move(error));
      }
    }
  }
}

}  // namespace arelem::frontend
