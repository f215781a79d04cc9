#include "app/repl/highlight.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "ir/words/words.h"

namespace arelem::app::repl {

namespace {
constexpr std::string_view majorWord = "1;34", modifier = "34", knownName = "36", number = "33",
                           quoted = "32", comment = "2";

bool isPart(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0;
}
bool isDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

std::string_view colorOf(const std::string& word, std::span<const frontend::KnownName> names) {
  const auto known = std::any_of(names.begin(), names.end(),
                                 [&](const frontend::KnownName& n) { return n.name == word; });
  if (known) {
    return knownName;
  }
  if (const std::optional<Word> found = findWord(word)) {
    return row(*found).wordClass == WordClass::modifier ? modifier : majorWord;
  }
  return std::all_of(word.begin(), word.end(), isDigit) ? number : std::string_view();
}
}  // namespace

std::string highlighted(std::string_view line, std::span<const frontend::KnownName> names) {
  std::string shown;
  const auto put = [&](std::string_view text, std::string_view color) {
    if (color.empty()) {
      shown += text;
    } else {
      shown.append("\033[").append(color).append("m").append(text).append("\033[0m");
    }
  };
  const std::size_t first = line.find_first_not_of(" \t");
  if (first != line.npos && line[first] == ':') {
    const std::size_t end = std::min(line.find_first_of(" \t", first), line.size());
    put(line.substr(0, end), majorWord);
    shown += line.substr(end);
    return shown;
  }
  for (std::size_t i = 0; i < line.size();) {
    std::size_t end = i + 1;
    std::string_view color;
    if (line.substr(i).starts_with("$$")) {
      end = line.size();
      color = comment;
    } else if (line[i] == '\'') {
      end = std::min(line.find('\'', i + 1), line.size() - 1) + 1;
      color = quoted;
    } else if (isPart(line[i])) {
      while (end < line.size() && isPart(line[end])) {
        ++end;
      }
      std::string word(line.substr(i, end - i));
      std::transform(word.begin(), word.end(), word.begin(),
                     [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
      color = colorOf(word, names);
    }
    put(line.substr(i, end - i), color);
    i = end;
  }
  return shown;
}

}  // namespace arelem::app::repl
