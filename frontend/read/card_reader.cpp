#include "frontend/read/card_reader.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <utility>

#include "frontend/read/characters.h"
#include "frontend/read/columns.h"
#include "frontend/read/encoding.h"
#include "frontend/read/structured_comment.h"
#include "ir/diag/diagnostic.h"
#include "ir/diag/frontend.h"

namespace arelem::frontend {

namespace {
constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
constexpr std::size_t wordLength = 6;   // of every fixed-field word
constexpr std::size_t rightShift = 66;  // print positions of TITLES RIGHT

std::optional<Word> fixedWord(std::string_view six) {
  std::array<char, wordLength> name{};
  for (std::size_t i = 0; i < wordLength; ++i) {
    name[i] = upper(six[i]);
  }
  const std::string_view text(name.data(), name.size());
  if (text == "PARTNO")
    return Word::PARTNO;
  if (text == "PPRINT")
    return Word::PPRINT;
  if (text == "INSERT")
    return Word::INSERT;
  if (text == "REMARK")
    return Word::REMARK;
  if (text == "TITLES")
    return Word::TITLES;
  return std::nullopt;
}

/// What stands behind the slash of `INSERT / M08`, as CL text writes it.
std::string_view behindSlash(std::string_view text) {
  const std::size_t slash = text.find_first_not_of(" \t");
  if (slash == std::string_view::npos || text[slash] != '/') {
    return text;
  }
  text.remove_prefix(slash + 1);
  return text.starts_with(' ') ? text.substr(1) : text;
}

/// A number of `field` that begins at `i` behind a blank, where the text before it ends in one.
bool separates(std::string_view before, std::string_view field, std::size_t i) {
  const auto ofNumber = [](char c) { return isDigit(c) || c == '.'; };
  return i > 0 && isBlank(field[i - 1]) && ofNumber(field[i]) && !before.empty() &&
         ofNumber(before.back());
}

/// True where a list goes on: whatever follows a `$` there is comment.
bool endsInSeparator(std::string_view text) {
  return !text.empty() && (text.back() == ',' || text.back() == '/');
}

std::string_view withoutTrailingBlanks(std::string_view text) {
  while (!text.empty() && (isBlank(text.back()) || text.back() == '\x1A' || text.back() == '\f')) {
    text.remove_suffix(1);
  }
  return text;
}
}  // namespace

CardReader::CardReader(const SourceMap& sources,
                       BufferId buffer,
                       const Options& options,
                       Reporter& reporter,
                       std::uint32_t& isn)
    : text_(sources.text(buffer)),
      buffer_(buffer),
      options_(options),
      reporter_(reporter),
      isn_(isn) {
  if (text_.starts_with(byteOrderMark)) {
    position_ = byteOrderMark.size();
  }
}

bool CardReader::takeLine(Line& line) {
  if (position_ >= text_.size()) {
    return false;
  }
  const char* const begin = text_.data() + position_;
  std::size_t length = text_.size() - position_;
  if (const void* feed = std::memchr(begin, '\n', length)) {
    length = static_cast<std::size_t>(static_cast<const char*>(feed) - begin);
  }
  std::size_t taken = length + 1;
  if (const void* back = std::memchr(begin, '\r', length)) {
    const auto at = static_cast<std::size_t>(static_cast<const char*>(back) - begin);
    taken = at + 1 == length && position_ + length < text_.size() ? length + 1 : at + 1;
    length = at;
  }
  line = {text_.substr(position_, length), position_};
  position_ += std::min(taken, text_.size() - position_);
  return true;
}

bool CardReader::readLine(Line& line) {
  while (takeLine(line)) {
    if (line.text.size() <= options_.limits.line) {
      return true;
    }
    const Span at{buffer_, static_cast<std::uint32_t>(line.offset), 0};
    reporter_.limit(at, "line", options_.limits.line, "bytes of one line");
    ++isn_;
  }
  return false;
}

bool CardReader::nextLine(std::string_view& line) {
  Line l;
  if (!readLine(l)) {
    return false;
  }
  line = l.text;
  return true;
}

void CardReader::next(StatementText& statement, bool fastLane) {
  Line line;
  if (!readLine(line)) {
    statement.kind = StatementText::Kind::end;
    statement.span = {buffer_, static_cast<std::uint32_t>(text_.size()), 0};
    return;
  }
  statement.isn = isn_++;
  statement.cardId = {};
  const auto offset = static_cast<std::uint32_t>(line.offset);
  if (fastLane && readNumbers(line, statement)) {
    return;
  }
  statement.text.clear();
  statement.offsets.clear();
  statement.pieces.clear();
  reportedOther_ = false;
  if (options_.takes(&DialectRules::freeWidth) && openComment(line, statement)) {
    return;
  }
  if (readFixed(line, statement)) {
    return;
  }
  while (appendCard(line, statement) == CardEnd::continued) {
    if (!readLine(line)) {
      reporter_.report(diagnose({buffer_, static_cast<std::uint32_t>(text_.size()), 0},
                                diag::NothingToContinue));
      break;
    }
  }
  statement.kind =
      statement.text.empty() ? StatementText::Kind::empty : StatementText::Kind::tokens;
  statement.span = statement.text.empty() ? Span{buffer_, offset, 0}
                                          : statement.spanOf(0, statement.text.size());
}

/// Structured comments. One that holds a statement is cut down to it, and the result is false; so
/// it is for other lines. Otherwise the comment is the whole statement: a text that PPRINT keeps, a
/// frame, or nothing, all its lines passed over.
bool CardReader::openComment(Line& line, StatementText& statement) {
  const auto comment = structuredComment(line.text);
  if (!comment) {
    return false;
  }
  if (comment->statement) {
    line = {line.text.substr(*comment->statement), line.offset + *comment->statement};
    return false;
  }
  const auto whole = [&](const Line& last, StatementText::Kind kind) {
    const auto begin = static_cast<std::uint32_t>(line.offset);
    const auto end = static_cast<std::uint32_t>(last.offset + last.text.size());
    statement.kind = kind;
    statement.span = {buffer_, begin, kind == StatementText::Kind::empty ? 0 : end - begin};
  };
  if (comment->text) {
    statement.fixedWord = Word::PPRINT;
    statement.fixedText = " " + cleanText(withoutTrailingBlanks(line.text.substr(*comment->text)));
    whole(line, StatementText::Kind::fixed);
    return true;
  }
  Line last = line;
  if (comment->frame && readFrame(last, statement)) {
    whole(last, StatementText::Kind::frame);
    return true;
  }
  for (bool more = comment->continues; more && readLine(last);) {
    more = endsInDollar(last.text);
  }
  whole(line, StatementText::Kind::empty);
  return true;
}

/// The name and the three rows behind `$$*CATIA0`. Where they are not there, nothing is read.
bool CardReader::readFrame(Line& last, StatementText& statement) {
  const std::size_t before = position_;
  Line line;
  bool good = readLine(line);
  const auto name = good ? commentText(line.text) : std::nullopt;
  good = name.has_value();
  statement.fixedText = cleanText(name.value_or(""));
  for (std::size_t row = 0; row < 3 && good; ++row) {
    const auto numbers = readLine(line) ? matrixRow(line.text) : std::nullopt;
    good = numbers.has_value();
    if (good) {
      std::copy(numbers->begin(), numbers->end(), statement.frame.begin() + 4 * row);
    }
  }
  if (!good) {
    position_ = before;
    return false;
  }
  isn_ += 4;  // every line has its number
  last = line;
  return true;
}

bool CardReader::readFixed(const Line& line, StatementText& statement) {
  std::size_t begin = 0;
  while (begin < line.text.size() && isBlank(line.text[begin])) {
    ++begin;
  }
  if (line.text.size() < begin + wordLength) {
    return false;
  }
  const auto word = fixedWord(line.text.substr(begin, wordLength));
  if (!word) {
    return false;
  }
  if (begin != 0 && !options_.takes(&DialectRules::indentedTexts)) {
    const std::size_t after = line.text.find_first_not_of(" \t", begin + wordLength);
    if (after != std::string_view::npos && line.text[after] == '=') {
      return false;  // left to the statement checker
    }
    reporter_.report(
        diagnose({buffer_, static_cast<std::uint32_t>(line.offset + begin), wordLength},
                 diag::FixedFieldPlace, spell(*word)));
  }
  keepFixed(line, begin, *word, statement);
  return true;
}

void CardReader::keepFixed(const Line& line,
                           std::size_t wordBegin,
                           Word word,
                           StatementText& statement) {
  const CardFields fields = splitCard(line.text, options_.dialect);
  std::string_view text = line.text.substr(0, fields.fieldEnd).substr(wordBegin + wordLength);
  const std::string_view kept = withoutTrailingBlanks(text);
  statement.kind = StatementText::Kind::fixed;
  statement.cardId = fields.cardId;
  statement.fixedWord = word;
  statement.span = {buffer_, static_cast<std::uint32_t>(line.offset + wordBegin),
                    static_cast<std::uint32_t>(wordLength + kept.size())};
  statement.fixedText =
      cleanText(options_.takes(&DialectRules::freeWidth) ? behindSlash(kept) : kept);
  if (!options_.takes(&DialectRules::lowerCaseTexts)) {
    for (char& c : statement.fixedText) {
      c = upper(c);
    }
  }
  std::string right = statement.fixedText.substr(0, wordLength);
  for (char& c : right) {
    c = upper(c);
  }
  if (word == Word::TITLES && right == " RIGHT") {
    reporter_.used(ir::Feature::LX_13);
    statement.fixedText = std::string(rightShift, ' ') + statement.fixedText.substr(wordLength);
  }
}

void CardReader::append(StatementText& statement, char c, std::size_t offset) {
  statement.text.push_back(c);
  statement.offsets.push_back(static_cast<std::uint32_t>(offset));
}

std::size_t CardReader::appendQuoted(std::string_view field,
                                     std::size_t i,
                                     std::size_t base,
                                     StatementText& statement) {
  const std::size_t close = field.find('\'', i + 1);
  if (close == std::string_view::npos) {
    reporter_.report(
        diagnose({buffer_, static_cast<std::uint32_t>(base + i), 1}, diag::UnclosedString));
    return field.size();
  }
  for (; i <= close; ++i) {
    append(statement, field[i], base + i);
  }
  return close + 1;
}

void CardReader::reportOther(const Line& line, std::size_t i, StatementText& statement) {
  if (std::exchange(reportedOther_, true)) {
    return;
  }
  const std::size_t length = std::max<std::size_t>(1, utf8Length(line.text, i));
  const auto byte = static_cast<unsigned char>(line.text[i]);
  const bool printable = byte >= 0x20U && byte != 0x7FU && utf8Length(line.text, i) > 0;
  const std::string shown =
      printable ? std::string(line.text.substr(i, length)) : fmt::format("0x{:02X}", byte);
  reporter_.report(diagnose({statement.span.buffer, static_cast<std::uint32_t>(line.offset + i),
                             static_cast<std::uint32_t>(length)},
                            diag::IllegalCharacter, shown, line.offset + i));
}

CardReader::CardEnd CardReader::appendCard(const Line& line, StatementText& statement) {
  const CardFields fields = splitCard(line.text, options_.dialect);
  if (statement.cardId.empty()) {
    statement.cardId = fields.cardId;
  }
  const std::string_view field = line.text.substr(0, fields.fieldEnd);
  statement.span.buffer = buffer_;
  CardEnd ending = CardEnd::done;
  bool lowerCase = false;
  const bool free = options_.takes(&DialectRules::freeWidth);
  std::size_t i = 0;
  while (i < field.size()) {
    const CharRow& c = classify(field[i]);
    if (c.kind == CharClass::letter || c.kind == CharClass::digit ||
        c.kind == CharClass::punctuation) {
      if (free && separates(statement.text, field, i)) {
        append(statement, ',', line.offset + i);  // `1.0 2.0`: blanks separate numbers of CL text
      }
      append(statement, c.upper, line.offset + i);
      lowerCase = lowerCase || c.upper != field[i];
    } else if (c.kind == CharClass::dollar) {
      const std::size_t second = field.find_first_not_of(" \t", i + 1);
      const bool adjacent = second == i + 1;
      const bool dollars = second != std::string_view::npos && field[second] == '$';
      const bool comment = dollars && (adjacent || !free);
      if (free && second != std::string_view::npos && !dollars &&
          !endsInSeparator(statement.text)) {
        append(statement, field[i], line.offset + i);  // `TPRINT/Tool 5$ cheap` is one statement
        ++i;
        continue;
      }
      ending = comment ? CardEnd::done : CardEnd::continued;
      reporter_.used(comment ? ir::Feature::LX_03 : ir::Feature::LX_02);
      break;
    } else if (c.kind == CharClass::quote && options_.takes(&DialectRules::blocks)) {
      i = appendQuoted(field, i, line.offset, statement);
      continue;
    } else if (options_.takes(&DialectRules::anyCharacter) && c.kind != CharClass::blank) {
      append(statement, field[i], line.offset + i);
    } else if (c.kind != CharClass::blank && field[i] != '\x1A' && field[i] != '\f') {
      reportOther(line, i, statement);
    }
    ++i;
  }
  if (lowerCase) {
    reporter_.used(ir::Feature::LX_15);
  }
  statement.pieces.push_back(
      {buffer_, static_cast<std::uint32_t>(line.offset), static_cast<std::uint32_t>(i)});
  return ending;
}

}  // namespace arelem::frontend
