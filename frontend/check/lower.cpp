// From the tokens of one statement to the program: label, head, parse, and which checker takes it.
#include <algorithm>
#include <array>

#include "frontend/check/old_number.h"
#include "frontend/check/prescan.h"
#include "frontend/check/program_reader.h"
#include "ir/diag/frontend.h"

namespace arelem::frontend {

namespace {
constexpr std::size_t maxSynonyms = 50;
constexpr std::size_t maxName360 = 6;

bool hasLabel(const std::vector<Token>& tokens) {
  return tokens.size() > 2 && tokens[1].kind == TokenKind::rightParen &&
         (tokens[0].kind == TokenKind::number || tokens[0].kind == TokenKind::symbol ||
          isWordKind(tokens[0].kind));
}

/// Index of the `=` that follows the name at `first`, over a subscript; 0 when there is none.
std::size_t equalsAfter(const std::vector<Token>& tokens, std::size_t first) {
  std::size_t i = first + 1;
  int depth = 0;
  for (; i < tokens.size(); ++i) {
    depth += tokens[i].kind == TokenKind::leftParen    ? 1
             : tokens[i].kind == TokenKind::rightParen ? -1
                                                       : 0;
    if (depth == 0) {
      break;
    }
  }
  i += i < tokens.size() && tokens[i].kind == TokenKind::rightParen ? 1 : 0;
  return i < tokens.size() && tokens[i].kind == TokenKind::equals ? i : 0;
}
}  // namespace

void ProgramReader::lowerLabel(const std::vector<Token>& tokens, std::size_t& first, Frame& frame) {
  if (!hasLabel(tokens)) {
    return;
  }
  first = 2;
  if (isWordKind(tokens[0].kind)) {
    context_.report(diagnose(tokens[0].span, diag::LabelIsWord, tokens[0].text));
    return;
  }
  if (!context_.options.takes(&DialectRules::largeSizes) && tokens[0].text.size() > maxName360) {
    context_.report(
        diagnose(tokens[0].span, diag::NameTooLong, tokens[0].text, tokens[0].text.size()));
    return;
  }
  frame.block.setLabel(tokens[0].text, tokens[0].span);
}

void ProgramReader::unknownHead(const Token& head) {
  Diagnostic d = diagnose(head.span, diag::UnknownWord, head.text);
  for (const std::string& near : context_.names.similar(head.text, true)) {
    d.help += (d.help.empty() ? "did you mean `" : ", `") + near + "`";
  }
  if (d.help.empty() && context_.options.takes(&DialectRules::extensionWords)) {
    d.help = "words of CAM systems pass with `--dialect cl`";
  }
  context_.report(std::move(d));
}

/// `name = NOUN/ ...` where NOUN is neither a type nor a name: a misspelled type, or a sculptured
/// surface of APT IV. A quotient of an undefined name, `A = B/2`, is left to the parser.
std::optional<Diagnostic> ProgramReader::unknownType(const std::vector<Token>& tokens,
                                                     std::size_t first,
                                                     bool mayDivide) {
  constexpr std::array<std::string_view, 3> sculptured{"SCURV", "SSURF", "SMESH"};
  const std::size_t equals =
      tokens[first].kind == TokenKind::symbol ? equalsAfter(tokens, first) : 0;
  if (equals == 0 || equals + 2 >= tokens.size() || tokens[equals + 1].kind != TokenKind::symbol ||
      tokens[equals + 2].kind != TokenKind::slash) {
    return std::nullopt;
  }
  const Token& noun = tokens[equals + 1];
  const NameFacts* known = context_.names.find(noun.text);
  if (known != nullptr && known->kind != NameFacts::Class::unknown) {
    return std::nullopt;
  }
  Diagnostic d = diagnose(noun.span, diag::UnknownType, noun.text);
  if (std::ranges::find(sculptured, noun.text) != sculptured.end()) {
    return std::move(d).note(fmt::format(
        "sculptured curves and surfaces of APT IV are not supported; `{}` counts as defined",
        tokens[first].text));
  }
  if (mayDivide) {
    return std::nullopt;
  }
  for (const std::string& near : context_.names.similar(noun.text, true)) {
    const auto word = context_.vocabulary.find(near);
    if (word && entityType(*word)) {
      d.help += (d.help.empty() ? "did you mean `" : ", `") + near + "`";
    }
  }
  if (d.help.empty()) {
    d.help = "`arelem language` lists the types";
  }
  return d;
}

/// What can be told from the first tokens better than by the grammar.
bool ProgramReader::checkHead(const std::vector<Token>& tokens, std::size_t first) {
  const Token& head = tokens[first];
  if (head.kind == TokenKind::symbol && equalsAfter(tokens, first) == 0) {
    if (head.kind == TokenKind::symbol && tokens[first + 1].kind == TokenKind::rightParen) {
      context_.report(diagnose(tokens[first + 1].span, diag::UnmatchedClose));
    } else {
      unknownHead(head);
    }
    return false;
  }
  const bool block = head.kind >= TokenKind::then;
  if (isWordKind(head.kind) && !block && tokens[first + 1].kind == TokenKind::equals) {
    context_.report(diagnose(head.span, diag::WordAsName, head.text));
    return false;
  }
  if (auto noun = unknownType(tokens, first, true)) {
    context_.report(*std::move(noun));
    poison(tokens, true);
    return false;
  }
  return true;
}

/// The name that a broken statement would have defined is known from here on, so that its uses are
/// silent. `noType`: the text takes it for a scalar that is divided, which it is not.
void ProgramReader::poison(const std::vector<Token>& tokens, bool noType) {
  if (tokens.empty()) {
    return;
  }
  const std::size_t first = hasLabel(tokens) ? 2 : 0;
  if (first >= tokens.size() || tokens[first].kind != TokenKind::symbol ||
      equalsAfter(tokens, first) == 0) {
    return;
  }
  NameFacts& facts = context_.names.at(tokens[first].text);
  facts.defined = true;
  facts.poisoned = facts.poisoned || noType || facts.kind == NameFacts::Class::unknown;
}

void ProgramReader::lower(const std::vector<Token>& tokens, Frame& frame) {
  std::size_t first = 0;
  lowerLabel(tokens, first, frame);
  const Token& head = tokens[first];
  if (head.kind == TokenKind::end && first > 0) {
    return;
  }
  if (!checkHead(tokens, first)) {
    poison(tokens);
    return;
  }
  if (head.kind == TokenKind::word && head.word == Word::SYN) {
    synonyms(tokens, first, frame);
    return;
  }
  const std::span<const Token> all(tokens);
  if (auto error = parser_.parse(all.subspan(first), frame.tree)) {
    const bool shape =
        error->row == diag::Misplaced.row || error->row == diag::WordInExpression.row;
    auto noun = shape ? unknownType(tokens, first, false) : std::nullopt;
    const bool noType = noun.has_value();
    context_.report(noun ? *std::move(noun) : *std::move(error));
    poison(tokens, noType);
    return;
  }
  lowerShape(frame);
}

void ProgramReader::lowerShape(Frame& frame) {
  using Shape = StatementTree::Shape;
  switch (frame.tree.shape) {
    case Shape::empty:
      return;
    case Shape::command: {
      const Word word = frame.tree[frame.tree.head].word;
      if (word == Word::LIBRY) {
        library(frame);
      } else if (word != Word::READ || !readSegment(frame)) {
        frame.statements.command();
      }
      return;
    }
    case Shape::assign:
      if (pendingDefines_.empty() || !replaceByDefine(frame)) {
        frame.statements.assign();
      }
      return;
    case Shape::define:
      frame.statements.define();
      return;
    case Shape::macro:
      beginMacro(frame);
      return;
    case Shape::call:
      call(frame);
      return;
    case Shape::branch:
      frame.control.branch();
      return;
    case Shape::ifBlock:
      frame.control.ifBlock();
      return;
    case Shape::elseIf:
      frame.control.elseIf();
      return;
    case Shape::elseWord:
      frame.control.elseWord();
      return;
    case Shape::endIf:
      frame.control.endIf();
      return;
    case Shape::doBlock:
      frame.control.doBlock();
      return;
    case Shape::endDo:
      frame.control.endDo();
      return;
    case Shape::include:
      include(frame);
      return;
  }
}

/// Neither name of a pair of SYN is a word; the second one should be.
void ProgramReader::unknownSynonym(const Token& name, const Token& word) {
  Diagnostic d = old_number::as(old_number::synonymOfNoWord,
                                diagnose(join(name.span, word.span), diag::SynonymFormat))
                     .note(fmt::format("neither `{}` nor `{}` is a word", name.text, word.text));
  for (const Token* t : {&word, &name}) {
    for (const std::string& near : context_.names.similar(t->text, true)) {
      if (d.help.empty() && context_.vocabulary.find(near)) {
        d.help = "did you mean `" + near + "`";
      }
    }
  }
  context_.report(std::move(d));
}

/// SYN/ new,WORD,... or SYN/ WORD,new,...
void ProgramReader::synonyms(const std::vector<Token>& tokens, std::size_t first, Frame& frame) {
  if (frame.block.inArea()) {
    context_.report(diagnose(tokens[first].span, diag::SynonymPlace));
    return;
  }
  std::size_t i = first + 1;
  bool wordFirst = false;
  do {
    if (i + 3 >= tokens.size()) {
      context_.report(old_number::as(old_number::synonymAlone,
                                     diagnose(tokens[first].span, diag::SynonymFormat)));
      return;
    }
    const Token& a = tokens[i + 1];
    const Token& b = tokens[i + 3];
    const bool separated =
        tokens[i].kind == (i == first + 1 ? TokenKind::slash : TokenKind::comma) &&
        tokens[i + 2].kind == TokenKind::comma;
    wordFirst = i == first + 1 ? isWordKind(a.kind) : wordFirst;
    const Token& name = wordFirst ? b : a;
    const Token& word = wordFirst ? a : b;
    NameFacts* known = context_.names.find(name.text);
    const bool taken = known != nullptr && known->defined;
    if (separated && name.kind == TokenKind::symbol && word.kind == TokenKind::symbol) {
      unknownSynonym(name, word);
      return;
    }
    if (!separated || name.kind != TokenKind::symbol || !isWordKind(word.kind) ||
        word.word == Word::SYN || taken) {
      const DiagRow& cause =
          isWordKind(word.kind) ? diag::SynonymFormatRow : old_number::synonymOfNoWord;
      context_.report(old_number::as(cause, diagnose(join(a.span, b.span), diag::SynonymFormat)));
      return;
    }
    context_.vocabulary.addSynonym(name.text, word.word);
    context_.reporter.used(ir::Feature::LX_14);
    i += 4;
  } while (tokens[i].kind != TokenKind::end);
  if (!context_.options.takes(&DialectRules::largeSizes) &&
      context_.vocabulary.synonyms() > maxSynonyms) {
    context_.report(
        diagnose(tokens[first].span, diag::SynonymCount, context_.vocabulary.synonyms()));
  }
}

void ProgramReader::library(Frame& frame) {
  const StatementTree& tree = frame.tree;
  for (NodeId id = tree.arguments; id != noNode; id = tree[id].next) {
    if (tree[id].kind == Node::Kind::name && !tree[id].hasList) {
      libraryNames_.emplace(tree[id].text);
      context_.reporter.used(ir::Feature::CT_07);
    } else {
      context_.report(diagnose(tree[id].span, diag::ParameterExpected, "LIBRY", "names of macros"));
    }
  }
}

void ProgramReader::include(Frame& frame) {
  const Node& name = frame.tree[frame.tree.value];
  const Span at = name.span;
  if (frame.block.inArea()) {
    context_.report(diagnose(at, diag::ReadInArea, "INCLUDE", frame.block.areaName()));
    return;
  }
  if (const auto buffer = library_.loadFile(name.text, buffer_, at);
      buffer && checkBuffer(*buffer)) {
    readBuffer(*buffer, frame);
  }
}

/// READ/2,name and READ/1: true when the statement was one of them.
bool ProgramReader::readSegment(Frame& frame) {
  const StatementTree& tree = frame.tree;
  const NodeId first = tree.arguments;
  if (first == noNode || tree[first].kind != Node::Kind::number) {
    return false;
  }
  const Span at = frame.block.origin().span;
  const double mode = tree[first].number;
  if (mode != 1.0 && mode != 2.0) {
    return false;
  }
  if (frame.block.inArea()) {
    context_.report(
        diagnose(at, diag::ReadInArea, mode == 1.0 ? "READ/1" : "READ/2", frame.block.areaName()));
    return true;
  }
  context_.reporter.used(mode == 1.0 ? ir::Feature::IO_08 : ir::Feature::CT_10);
  if (mode == 1.0) {
    readDeck(frame);
    return true;
  }
  const NodeId name = tree[first].next;
  if (name == noNode || tree[name].kind != Node::Kind::name || tree[name].hasList) {
    context_.report(old_number::as(old_number::readFormat, diagnose(at, diag::PrintFormat, "READ/2",
                                                                    "the name of a segment")));
    return true;
  }
  const std::string segment(tree[name].text);
  if (const auto buffer = library_.loadNamed(segment, at); buffer && checkBuffer(*buffer)) {
    readBuffer(*buffer, frame);
  }
  return true;
}

}  // namespace arelem::frontend
