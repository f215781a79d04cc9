#include "frontend/format/formatter.h"

#include <algorithm>
#include <vector>

#include "frontend/format/card_list.h"
#include "frontend/format/layout.h"

namespace arelem::frontend {

namespace {
constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

Word headWord(const CardGroup& group) {
  for (const Card& card : group.cards) {
    if (!card.tokens.empty()) {
      return card.tokens.front().kind == TokenKind::word ? card.tokens.front().word : Word::count;
    }
  }
  return Word::count;
}

/// Statements from which the layout must keep off: texts, decks of READ/1, what follows FINI, and
/// what is not tokens.
std::vector<bool> untouchable(const CardList& list) {
  std::vector<bool> keep(list.groups.size(), false);
  bool afterFini = false;
  std::size_t deck = list.groups.size();  // where the data of a READ/1 may begin
  bool reads = false;
  for (std::size_t i = 0; i < list.groups.size(); ++i) {
    const CardGroup& group = list.groups[i];
    keep[i] = !group.plain || afterFini;
    const Word word = headWord(group);
    afterFini = afterFini || word == Word::FINI;
    reads = reads || word == Word::READ;
    const bool call = !group.cards.front().tokens.empty() &&
                      group.cards.front().tokens.front().kind == TokenKind::call;
    if (reads && (word == Word::READ || word == Word::LOOPND || call)) {
      deck = i + 1;
    }
    if (list.essence[i].text == "ENDPCH") {
      for (std::size_t k = deck; k <= i; ++k) {
        keep[k] = true;
      }
      deck = list.groups.size();
    }
  }
  return keep;
}

std::string write(const CardList& list,
                  const std::vector<bool>& keep,
                  CardIds ids,
                  std::string_view lineEnd,
                  std::vector<std::size_t>& refused) {
  std::string text;
  Indent indent;
  for (std::size_t i = 0; i < list.groups.size(); ++i) {
    const CardGroup& group = list.groups[i];
    const std::size_t levels = indent.next(group);
    std::vector<std::string> lines;
    if (!keep[i]) {
      lines = layOut(group, levels, ids);
      if (lines.empty()) {
        refused.push_back(i);
      }
    }
    if (lines.empty()) {
      lines = asItStands(group, ids);
    }
    for (const std::string& line : lines) {
      text += line;
      text += lineEnd;
    }
  }
  return text;
}

/// Numbers of the statements that came out as something else.
std::vector<std::size_t> changed(const CardList& before, const CardList& after, CardIds ids) {
  std::vector<std::size_t> found;
  const bool aligned = before.essence.size() == after.essence.size();
  for (std::size_t i = 0; i < before.essence.size(); ++i) {
    Essence was = before.essence[i];
    if (ids == CardIds::drop) {
      was.cardId.clear();
    }
    if (i >= after.essence.size() || was != after.essence[i]) {
      found.push_back(i);
      if (!aligned) {
        break;  // all that follows is read from another place
      }
    }
  }
  return found;
}

/// Marks the statements to be left alone; false when all of them were already.
bool leaveAlone(const std::vector<std::size_t>& statements, std::vector<bool>& keep) {
  bool more = false;
  for (const std::size_t i : statements) {
    more = more || !keep[i];
    keep[i] = true;
  }
  return more;
}

void lay(std::string_view text, const Options& reading, CardIds ids, Formatted& result) {
  const bool marked = text.starts_with(byteOrderMark);
  CardList before;
  readCards(text, reading, true, before);
  result.statements = before.groups.size();
  const std::string_view lineEnd = text.find("\r\n") != std::string_view::npos ? "\r\n" : "\n";
  std::vector<bool> keep = untouchable(before);
  while (true) {  // each round leaves at least one more statement alone, so this ends
    std::vector<std::size_t> refused;
    result.text = (marked ? std::string(byteOrderMark) : std::string()) +
                  write(before, keep, ids, lineEnd, refused);
    CardList after;
    readCards(result.text, reading, false, after);
    const std::vector<std::size_t> wrong = changed(before, after, ids);
    const bool more = leaveAlone(refused, keep);
    if (wrong.empty()) {
      break;
    }
    if (!leaveAlone(wrong, keep) && !more) {  // not to be had without a change of meaning
      result.text = text;
      keep.assign(keep.size(), true);
      break;
    }
  }
  result.untouched = static_cast<std::size_t>(std::count(keep.begin(), keep.end(), true));
}
}  // namespace

Formatted format(std::string_view text, const FormatOptions& options) {
  Options reading;
  reading.dialect = options.dialect;
  reading.limits = options.limits;
  Formatted result;
  result.clText = options.dialect == Dialect::cl ||
                  (options.dialect == Dialect::automatic && looksLikeCl(text));
  if (result.clText) {
    result.text = text;
  } else {
    lay(text, reading, options.ids, result);
  }
  return result;
}

}  // namespace arelem::frontend
