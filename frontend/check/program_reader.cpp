#include "frontend/check/program_reader.h"

#include <algorithm>
#include <utility>

#include "frontend/check/prescan.h"
#include "frontend/read/encoding.h"
#include "ir/diag/frontend.h"

namespace arelem::frontend {

ProgramReader::ProgramReader(SourceMap& sources, const Options& options, Reporter& reporter)
    : context_(sources, options, reporter),
      lexer_(context_.vocabulary, context_.options, reporter),
      parser_(context_.options.limits),
      library_(context_) {}

bool ProgramReader::checkBuffer(BufferId buffer) {
  constexpr std::uint64_t addressable = 4'000'000'000;  // offsets have 32 bits
  const std::string_view text = context_.sources.text(buffer);
  const std::uint64_t most = std::min(context_.options.limits.bytes, addressable);
  if (text.size() > most) {
    context_.reporter.limit({buffer, 0, 0}, "bytes", most, "bytes of one source file");
    return false;
  }
  checkEncoding(text, buffer, context_.reporter);
  prescan(context_.sources, buffer, context_.options, context_.vocabulary, context_.names);
  return true;
}

ir::Program ProgramReader::run(BufferId buffer) {
  context_.program.blocks.emplace_back();
  Frame frame(context_, {0}, BlockWriter::Area::program);
  if (checkBuffer(buffer)) {
    const std::string_view text = context_.sources.text(buffer);
    constexpr std::size_t shortStatement = 24;  // bytes; a guess only costs memory or a move
    context_.program.blocks[0].statements.reserve(text.size() / shortStatement + 16);
    applyDefines(frame);
    readBuffer(buffer, frame);
    finish(frame);
  }
  context_.reporter.finish(
      {buffer, static_cast<std::uint32_t>(context_.sources.text(buffer).size()), 0});
  context_.program.features = context_.reporter.features();
  context_.program.dialect = spell(context_.options.dialect);
  return std::move(context_.program);
}

void ProgramReader::readBuffer(BufferId buffer, Frame& frame) {
  CardReader reader(context_.sources, buffer, context_.options, context_.reporter, isn_);
  CardReader* const outerReader = std::exchange(reader_, &reader);
  const BufferId outerBuffer = std::exchange(buffer_, buffer);
  library_.enter(buffer);
  StatementText statement;
  constexpr std::uint32_t between = 1024;  // statements between two looks at the interrupt flag
  for (std::uint32_t count = 0; !finished_; ++count) {
    const bool interrupted = context_.options.interrupted != nullptr && count % between == 0 &&
                             context_.options.interrupted->load();
    reader.next(statement, recording_ == nullptr);
    if (interrupted || statement.kind == StatementText::Kind::end) {
      break;
    }
    readStatement(reader, statement, frame);
  }
  library_.leave();
  reader_ = outerReader;
  buffer_ = outerBuffer;
}

void ProgramReader::readStatement(CardReader& reader,
                                  const StatementText& statement,
                                  Frame& frame) {
  frame.block.setOrigin({statement.span, statement.isn, statement.cardId});
  anyStatement_ = anyStatement_ || statement.kind != StatementText::Kind::empty;
  switch (statement.kind) {
    case StatementText::Kind::end:
      return;
    case StatementText::Kind::empty:
      context_.reporter.used(ir::Feature::LX_04);
      return;
    case StatementText::Kind::numbers:
      frame.block.emit(statement.numbers);
      return;
    case StatementText::Kind::frame:
      emitFrame(statement, frame);
      return;
    case StatementText::Kind::fixed:
      if (recording_ != nullptr) {
        recording_->body.push_back(store(statement, {}));
      } else {
        emitText(statement, frame);
      }
      return;
    case StatementText::Kind::tokens:
      break;
  }
  if (context_.options.takes(&DialectRules::unknownWords) && recording_ == nullptr &&
      lowerForeign(statement, frame)) {
    return;
  }
  if (!lexer_.run(statement, tokens_)) {
    poison(tokens_);
    return;
  }
  if (recording_ != nullptr && record(statement, tokens_)) {
    return;
  }
  const std::uint32_t before = frame.block.next();
  lower(tokens_, frame);
  const auto& statements = context_.program.blocks[0].statements;
  if (frame.block.next() > before && std::holds_alternative<ir::Fini>(statements.back().body)) {
    finished_ = true;
    afterFini(reader);
  }
}

void ProgramReader::emitText(const StatementText& statement, Frame& frame) {
  if (statement.fixedWord == Word::REMARK) {
    context_.reporter.used(ir::Feature::LX_08);
  } else {
    frame.block.emit(ir::Text{statement.fixedWord, statement.fixedText});
  }
}

void ProgramReader::afterFini(CardReader& reader) {
  StatementText statement;
  do {
    reader.next(statement, true);
    if (statement.kind != StatementText::Kind::empty &&
        statement.kind != StatementText::Kind::end) {
      context_.report(diagnose(statement.span, diag::TextAfterFini));
      return;
    }
  } while (statement.kind != StatementText::Kind::end);
}

void ProgramReader::finish(Frame& frame) {
  const auto size =
      static_cast<std::uint32_t>(context_.sources.text(frame.block.origin().span.buffer).size());
  const Span end{frame.block.origin().span.buffer, size, 0};
  if (recording_ != nullptr) {
    context_.report(diagnose(recording_->definition, diag::MacroNotEnded, recording_->name));
  }
  if (!finished_) {
    if (!context_.options.takes(&DialectRules::missingFini)) {
      Diagnostic missing = diagnose(end, diag::FiniMissing);
      if (!anyStatement_) {
        missing.help =
            "there is no statement at all; the smallest program with a motion has three lines: "
            "FROM/0,0,0 then GOTO/10,0,0 then FINI";
      }
      context_.report(std::move(missing));
    }
    frame.block.setOrigin({end, isn_, {}});
    frame.block.emit(ir::Fini{});
  }
  frame.control.finish();
  frame.block.finish();
  checkUncalled();
}

/// --define NAME=VALUE: a scalar at the start of the program, whose first assignment in
/// straight-line code (not in a loop, macro or DO block) is replaced by VALUE.
void ProgramReader::applyDefines(Frame& frame) {
  for (const auto& [given, value] : context_.options.defines) {
    std::string name = given;
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return std::toupper(c); });
    const bool letters =
        std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c); });
    const bool number =
        std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c); });
    const bool word = context_.vocabulary.find(name).has_value();
    NameFacts* known = context_.names.find(name);
    const bool other = known != nullptr && known->kind != NameFacts::Class::scalar;
    if (!letters || number || word || other) {
      context_.report(diagnose({}, diag::BadDefine, given));
      continue;
    }
    NameFacts& facts = context_.names.at(name);
    facts.kind = NameFacts::Class::scalar;
    pendingDefines_[name] = value;
    ir::Target target;
    target.symbol = frame.values.symbol(name, facts);
    facts.defined = true;
    frame.block.emit(ir::Assign{target, frame.values.number(value, {})});
  }
}

bool ProgramReader::replaceByDefine(Frame& frame) {
  const Node& name = frame.tree[frame.tree.target];
  const bool straight = frame.block.area() == BlockWriter::Area::program && !context_.lenient;
  const auto found = pendingDefines_.find(std::string(name.text));
  if (!straight || name.hasList || found == pendingDefines_.end()) {
    return false;
  }
  const auto target = frame.values.target(frame.tree.target, NameFacts::Class::scalar, {});
  if (target) {
    frame.block.emit(ir::Assign{*target, frame.values.number(found->second, name.span)});
  }
  pendingDefines_.erase(found);
  return true;
}

}  // namespace arelem::frontend
