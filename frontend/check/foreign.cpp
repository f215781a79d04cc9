// Dialect cl: statements of CAM systems, whose words and texts need not be in the vocabulary.
#include <algorithm>
#include <charconv>

#include "frontend/check/program_reader.h"
#include "frontend/read/characters.h"
#include "frontend/read/encoding.h"

namespace arelem::frontend {

namespace {
/// The cards of a statement joined as they stand, with the source offset of every byte.
struct RawText {
  std::string text;
  std::vector<std::uint32_t> offsets;
};

RawText joined(const StatementText& statement, const SourceMap& sources) {
  RawText raw;
  for (const Span& piece : statement.pieces) {
    const std::string_view part = sources.text(piece);
    for (std::size_t i = 0; i < part.size(); ++i) {
      raw.text.push_back(part[i]);
      raw.offsets.push_back(piece.begin + static_cast<std::uint32_t>(i));
    }
  }
  return raw;
}

std::string upperCase(std::string_view text, bool blanks) {
  std::string result;
  for (const char c : text) {
    if (!isBlank(c)) {
      result += upper(c);
    } else if (blanks && !result.empty() && result.back() != ' ') {
      result += ' ';
    }
  }
  return result;
}

std::optional<double> wholeNumber(std::string_view text) {
  text.remove_prefix(!text.empty() && text.front() == '+' ? 1 : 0);
  const std::string_view digits = text.substr(!text.empty() && text.front() == '-' ? 1 : 0);
  if (digits.empty() || !(isDigit(digits.front()) || digits.front() == '.')) {
    return std::nullopt;
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() ? std::optional(value)
                                                                  : std::nullopt;
}

ir::Argument rawArgument(
    const RawText& raw, std::size_t begin, std::size_t end, BufferId buffer, Values& values) {
  while (begin < end && isBlank(raw.text[begin])) {
    ++begin;
  }
  while (end > begin && isBlank(raw.text[end - 1])) {
    --end;
  }
  const std::uint32_t from =
      raw.offsets.empty() ? 0 : raw.offsets[std::min(begin, raw.offsets.size() - 1)];
  const Span span{buffer, from, begin == end ? 0 : raw.offsets[end - 1] + 1 - from};
  const std::string_view item = std::string_view(raw.text).substr(begin, end - begin);
  if (item.empty()) {
    return {std::string(), span};  // passed on as it stands
  }
  if (const auto number = wholeNumber(item)) {
    return {values.number(*number, span), span};
  }
  if (const auto word = findWord(upperCase(item, false))) {
    return {*word, span};
  }
  const bool quoted = item.size() > 1 && item.front() == '\'' && item.back() == '\'';
  return {cleanText(quoted ? item.substr(1, item.size() - 2) : item), span};
}

/// Words that pass with their parameters as they stand; a modifier at the head is another system's
/// word of its own.
bool passes(Word word) {
  const WordClass c = row(word).wordClass;
  return c == WordClass::postWithParameters || c == WordClass::postWithoutParameters ||
         c == WordClass::transformation || c == WordClass::modifier;
}

/// CIRCLE/ x, y, z, i, j, k, r and more numbers: the parser takes it. Other CIRCLE statements of
/// CAM systems (without a radius, with a word for the direction) pass as they stand.
bool isArcRecord(const std::vector<ir::Argument>& list) {
  constexpr std::size_t fewest = 7;
  return list.size() >= fewest && std::all_of(list.begin(), list.end(), [](const auto& a) {
           return std::holds_alternative<ir::ExprId>(a.value);
         });
}

/// UNIT/MM of SolidWorks CAM is UNITS/MM.
bool isUnit(Word word, const std::vector<ir::Argument>& list) {
  return word == Word::UNIT && list.size() == 1 && std::holds_alternative<Word>(list[0].value);
}
}  // namespace

/// Post statements and statements with unknown words pass with their parameters as they stand:
/// numbers, words, and everything else as text. False leaves the statement to the parser.
bool ProgramReader::lowerForeign(const StatementText& statement, Frame& frame) {
  const std::size_t headEnd = std::min(statement.text.find_first_of("/,=("), statement.text.size());
  const char after = headEnd < statement.text.size() ? statement.text[headEnd] : '\0';
  const auto word = context_.vocabulary.find(std::string_view(statement.text).substr(0, headEnd));
  const bool raw =
      word ? passes(*word) && after == '/' && statement.text.find('(') == std::string::npos
           : after == '/' || after == '\0' || after == ',';
  const bool arc = word == Word::CIRCLE && after == '/';
  const bool assignment = !word && statement.text.find('=') < statement.text.find('/');
  const bool label = !word && statement.text.find(')') < headEnd;
  if (!(raw || arc) || assignment || label || headEnd == 0) {
    return false;
  }
  const RawText text = joined(statement, context_.sources);
  std::size_t i = std::min(text.text.find_first_of("/,"), text.text.size());
  const std::string head = upperCase(std::string_view(text.text).substr(0, i), true);
  std::vector<ir::Argument> list;
  while (i < text.text.size()) {
    const std::size_t next = std::min(text.text.find(',', i + 1), text.text.size());
    list.push_back(rawArgument(text, i + 1, next, buffer_, frame.values));
    i = next;
  }
  if (arc && isArcRecord(list)) {
    return false;
  }
  if (list.size() == 1 && list[0].span.length == 0) {
    list.clear();  // nothing behind the slash
  }
  const bool slash = after == '/';
  if (word && isUnit(*word, list)) {
    frame.block.emit(ir::Command{Word::UNITS, slash, std::move(list)});
  } else if (word && !arc && row(*word).wordClass != WordClass::modifier) {
    frame.block.emit(ir::Command{*word, slash, std::move(list)});
  } else {
    const std::string name = head.substr(0, head.find_last_not_of(' ') + 1);
    frame.block.emit(ir::ForeignCommand{cleanText(name), slash, std::move(list)});
  }
  return true;
}

}  // namespace arelem::frontend
