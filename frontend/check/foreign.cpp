// Dialect cl: statements of CAM systems, whose words and texts need not be in the vocabulary.
#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "frontend/check/program_reader.h"
#include "frontend/read/characters.h"
#include "frontend/read/encoding.h"
#include "ir/diag/frontend.h"
#include "ir/diag/words.h"

namespace arelem::frontend {

namespace {
/// The cards of a statement joined as they stand, with the source offset of every byte. One card
/// is not copied.
class RawText {
 public:
  RawText(const StatementText& statement, const SourceMap& sources) {
    if (statement.pieces.size() == 1) {
      text_ = sources.text(statement.pieces[0]);
      begin_ = statement.pieces[0].begin;
      return;
    }
    for (const Span& piece : statement.pieces) {
      const std::string_view part = sources.text(piece);
      joined_ += part;
      for (std::size_t i = 0; i < part.size(); ++i) {
        offsets_.push_back(piece.begin + static_cast<std::uint32_t>(i));
      }
    }
    text_ = joined_;
  }
  RawText(const RawText&) = delete;
  RawText& operator=(const RawText&) = delete;

  [[nodiscard]] std::string_view text() const { return text_; }
  /// The last byte of the text stands for all behind it.
  [[nodiscard]] std::uint32_t offset(std::size_t i) const {
    i = text_.empty() ? 0 : std::min(i, text_.size() - 1);
    return offsets_.empty() ? begin_ + static_cast<std::uint32_t>(i) : offsets_[i];
  }

 private:
  std::string joined_;
  std::string_view text_;
  std::vector<std::uint32_t> offsets_;
  std::uint32_t begin_ = 0;
};

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
  while (begin < end && isBlank(raw.text()[begin])) {
    ++begin;
  }
  while (end > begin && isBlank(raw.text()[end - 1])) {
    --end;
  }
  const std::uint32_t from = raw.offset(begin);
  const Span span{buffer, from, begin == end ? 0 : raw.offset(end - 1) + 1 - from};
  const std::string_view item = raw.text().substr(begin, end - begin);
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
  if (word == Word::CUTTER) {
    return true;
  }
  const WordClass c = row(word).wordClass;
  return c == WordClass::postWithParameters || c == WordClass::postWithoutParameters ||
         c == WordClass::transformation || c == WordClass::modifier;
}

bool allNumbers(const std::vector<ir::Argument>& list) {
  return std::all_of(list.begin(), list.end(), [](const ir::Argument& a) {
    return std::holds_alternative<ir::ExprId>(a.value);
  });
}

/// CIRCLE/ x, y, z, i, j, k, r and more numbers: the parser takes it. Other CIRCLE statements of
/// CAM systems (without a radius, with a word for the direction) pass as they stand.
bool isArcRecord(const std::vector<ir::Argument>& list) {
  constexpr std::size_t fewest = 7;
  return list.size() >= fewest && allNumbers(list);
}

/// UNIT/MM of SolidWorks CAM is UNITS/MM.
bool isUnit(Word word, const std::vector<ir::Argument>& list) {
  return word == Word::UNIT && list.size() == 1 && std::holds_alternative<Word>(list[0].value);
}

/// `25.0 25.0 DWELL`: CAMWorks leaves out commas. A blank behind a number separates.
std::vector<std::pair<std::size_t, std::size_t>> itemsOf(std::string_view text,
                                                         std::size_t begin,
                                                         std::size_t end) {
  std::vector<std::pair<std::size_t, std::size_t>> items;
  std::size_t from = begin;
  for (std::size_t i = begin; i < end; ++i) {
    const std::size_t first = text.find_first_not_of(" \t", from);
    const bool splits = isBlank(text[i]) && first < i &&
                        wholeNumber(text.substr(first, i - first)) &&
                        text.find_first_not_of(" \t", i) < end;
    if (splits) {
      items.emplace_back(from, i);
      from = i;
    }
  }
  items.emplace_back(from, end);
  return items;
}

std::vector<ir::Argument> rawArguments(
    const RawText& raw, std::size_t i, bool splits, BufferId buffer, Values& values) {
  std::vector<ir::Argument> list;
  while (i < raw.text().size()) {
    const std::size_t next = std::min(raw.text().find(',', i + 1), raw.text().size());
    if (splits) {
      for (const auto& [begin, end] : itemsOf(raw.text(), i + 1, next)) {
        list.push_back(rawArgument(raw, begin, end, buffer, values));
      }
    } else {
      list.push_back(rawArgument(raw, i + 1, next, buffer, values));
    }
    i = next;
  }
  return list;
}

/// Reads numbers separated by commas, and the text behind them.
bool takeNumbers(std::string_view& text, std::span<double> numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0 && !text.starts_with(',')) {
      return false;
    }
    text.remove_prefix(i > 0 ? 1 : 0);
    const std::size_t end = std::min(text.find_first_of(",)"), text.size());
    const auto number = wholeNumber(text.substr(0, end));
    if (!number) {
      return false;
    }
    numbers[i] = *number;
    text.remove_prefix(end);
  }
  return true;
}

bool takeText(std::string_view& text, std::string_view expected) {
  const bool there = text.starts_with(expected);
  text.remove_prefix(there ? expected.size() : 0);
  return there;
}

/// The arc of CATIA, TLON,GOFWD/(CIRCLE/x,y,z,r),ON,[n,INTOF,](LINE/x,y,z,ex,ey,ez): the line ends
/// where the arc does, and the plane follows from INDIRV.
struct CatiaArc {
  std::array<double, 4> circle{};
  std::array<double, 6> line{};
};
std::optional<CatiaArc> catiaArc(std::string_view text) {
  CatiaArc arc;
  takeText(text, "TLON,");
  if (!takeText(text, "GOFWD/(CIRCLE/") || !takeNumbers(text, arc.circle) ||
      !takeText(text, "),ON,")) {
    return std::nullopt;
  }
  std::array<double, 1> nth{};
  if (!text.starts_with('(') && !(takeNumbers(text, nth) && takeText(text, ",INTOF,"))) {
    return std::nullopt;
  }
  const bool whole = takeText(text, "(LINE/") && takeNumbers(text, arc.line) && text == ")";
  return whole ? std::optional(arc) : std::nullopt;
}

/// A motion word behind a blank or a comma, or before a number without a slash, as in `RAPID
/// GOTO/1,2,3` and `GOTO 1,2,3`: a move that would be lost.
std::optional<std::string_view> hiddenMotion(std::string_view text) {
  constexpr std::array words = {"GOTO", "FROM", "GODLTA", "CIRCLE", "MOVARC"};
  for (const std::string_view word : words) {
    for (std::size_t at = text.find(word); at != std::string_view::npos;
         at = text.find(word, at + 1)) {
      const std::size_t end = at + word.size();
      const bool begins = at == 0 || text[at - 1] == ' ' || text[at - 1] == ',';
      const std::size_t behind = std::min(text.find_first_not_of(' ', end), text.size());
      const bool alone = end == text.size() || text[end] == ' ' || text[end] == '/';
      const bool isTheStatement = at == 0 && (behind == text.size() || text[behind] == '/');
      if (begins && alone && !isTheStatement) {
        return word;
      }
    }
  }
  return std::nullopt;
}

/// GOTO/ with five numbers: two of an axis are no axis.
std::optional<ir::LocateNumbers> fiveNumbers(std::string_view text) {
  std::array<double, 5> numbers{};
  if (!takeText(text, "GOTO/") || !takeNumbers(text, numbers) || !text.empty()) {
    return std::nullopt;
  }
  ir::LocateNumbers locate{Word::GOTO, 3, {}};
  std::copy_n(numbers.begin(), 3, locate.numbers.begin());
  return locate;
}

void addNumber(std::vector<ir::Argument>& list, ir::ExprId number, const Span& at) {
  ir::Argument& argument = list.emplace_back();
  argument.value = number;
  argument.span = at;
}
}  // namespace

/// Statements of CAM systems that are APT in another sense; false for all others.
bool ProgramReader::lowerClMotion(const StatementText& statement, Frame& frame) {
  const Span& at = statement.span;
  if (const auto arc = catiaArc(statement.text)) {
    std::vector<ir::Argument> circle;
    for (const double number : arc->circle) {
      addNumber(circle, frame.values.number(number, at), at);
    }
    frame.block.emit(ir::Command{Word::CIRCLE, true, std::move(circle)});
    ir::LocateNumbers end{Word::GOTO, 3, {}};
    std::copy_n(arc->line.begin() + 3, 3, end.numbers.begin());
    frame.block.emit(end);
    return true;
  }
  if (const auto locate = fiveNumbers(statement.text)) {
    context_.report(diagnose(at, diag::HalfAnAxis));
    frame.block.emit(*locate);
    return true;
  }
  return false;
}

/// CATIA0/ name, three rows of four numbers.
void ProgramReader::emitFrame(const StatementText& statement, Frame& frame) {
  std::vector<ir::Argument> list{{statement.fixedText, statement.span}};
  for (const double number : statement.frame) {
    addNumber(list, frame.values.number(number, statement.span), statement.span);
  }
  frame.block.emit(ir::ForeignCommand{"CATIA0", true, std::move(list)});
}

/// Post statements and statements with unknown words pass with their parameters as they stand:
/// numbers, words, and everything else as text. False leaves the statement to the parser.
bool ProgramReader::lowerForeign(const StatementText& statement, Frame& frame) {
  if (lowerClMotion(statement, frame)) {
    return true;
  }
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
  const RawText text(statement, context_.sources);
  const std::size_t i = std::min(text.text().find_first_of("/,"), text.text().size());
  const std::string head = upperCase(std::string_view(text.text()).substr(0, i), true);
  if (const auto motion = hiddenMotion(word ? upperCase(text.text(), true) : head)) {
    context_.report(diagnose(statement.span, diag::HiddenMotion, *motion));
    return true;
  }
  std::vector<ir::Argument> list = rawArguments(text, i, word.has_value(), buffer_, frame.values);
  while (word == Word::CUTTER && !list.empty() && list.back().span.length == 0) {
    list.pop_back();  // CAMWorks ends CUTTER with a comma
  }
  if ((arc && isArcRecord(list)) || (word == Word::CUTTER && !allNumbers(list))) {
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
