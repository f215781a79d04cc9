#include "frontend/read/columns.h"

#include <algorithm>

#include "frontend/read/characters.h"

namespace arelem::frontend {

namespace {
constexpr std::size_t fieldColumns = 72;
constexpr std::size_t cardColumns = 80;
constexpr std::size_t tabStop = 8;

/// Byte offset of the first character beyond `columns` columns, and the columns counted so far.
struct Place {
  std::size_t byte = 0;
  std::size_t columns = 0;
};

Place advance(std::string_view line, Place from, std::size_t columns) {
  Place p = from;
  while (p.byte < line.size() && p.columns < columns) {
    const bool continuation = (static_cast<unsigned char>(line[p.byte]) & 0xC0U) == 0x80U;
    if (line[p.byte] == '\t') {
      p.columns = (p.columns / tabStop + 1) * tabStop;
    } else if (!continuation) {
      ++p.columns;
    }
    ++p.byte;
  }
  while (p.byte < line.size() && (static_cast<unsigned char>(line[p.byte]) & 0xC0U) == 0x80U) {
    ++p.byte;
  }
  return p;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && isBlank(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

bool isSetApart(std::string_view field, std::string_view rest, bool exactlyEighty) {
  const bool plain =
      std::all_of(rest.begin(), rest.end(), [](char c) { return isAlphanumeric(c) || isBlank(c); });
  const char last = field.back();
  if (!plain || isAlphanumeric(last) || last == '.') {
    return false;
  }
  if (exactlyEighty || last == '$') {
    return true;
  }
  const std::string_view before = trimmed(field);
  const bool blanks = isBlank(last) && field.size() > 1 && isBlank(field[field.size() - 2]);
  return blanks && !before.empty() && before.back() != ',' && before.back() != '/';
}
}  // namespace

CardFields splitCard(std::string_view line, Dialect dialect) {
  const bool short72 = line.size() <= fieldColumns && line.find('\t') == std::string_view::npos;
  if (short72 || rulesOf(dialect).freeWidth != Leave::refused) {
    return {line.size(), {}};
  }
  const Place field = advance(line, {}, fieldColumns);
  if (field.byte == line.size()) {
    return {line.size(), {}};
  }
  const Place card = advance(line, field, cardColumns);
  const std::string_view rest = line.substr(field.byte, card.byte - field.byte);
  // How wide a tab was is a guess, so a line with tabs is never cut without a look.
  const bool tabs = line.find('\t') != std::string_view::npos;
  const bool strict = rulesOf(dialect).guessedColumns == Leave::refused && !tabs;
  const bool withinCard = trimmed(line.substr(card.byte)).empty();
  if (!strict && trimmed(rest).empty() && withinCard) {
    return {field.byte, {}};
  }
  if (strict ||
      (withinCard && isSetApart(line.substr(0, field.byte), rest, card.columns == cardColumns))) {
    return {field.byte, trimmed(rest)};
  }
  return {line.size(), {}};
}

}  // namespace arelem::frontend
