#include "backend/cltape/codes.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include "backend/cltape/encode.h"
#include "ir/diag/output.h"

namespace arelem::backend::tape {

namespace {
constexpr std::int64_t largestCode = 32767;
constexpr std::size_t longestWord = 60;

bool isSpelling(std::string_view word) {
  return !word.empty() && word.size() <= longestWord &&
         word.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") == std::string_view::npos;
}

Failure wrong(std::string_view file, const toml::node& node, const std::string& why) {
  return fail(diag::CodesFile, file, node.source().begin.line, why);
}

bool isPost(Word word) {
  constexpr int postClass = 2000;
  return row(word).type == postClass;
}
}  // namespace

std::optional<int> Codes::Table::find(std::string_view word) const {
  const auto found = codes.find(word);
  return found == codes.end() ? std::nullopt : std::optional(found->second);
}

const std::string* Codes::Table::find(int code) const {
  const auto found = words.find(code);
  return found == words.end() ? nullptr : &found->second;
}

Result<Codes> Codes::read(std::string_view text, std::string_view file) {
  toml::table root;
  try {
    root = toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    return fail(diag::CodesFile, file, error.source().begin.line, error.description());
  }
  Codes result;
  for (const auto& [key, node] : root) {
    const bool isMajor = key == "major";
    const toml::table* table = node.as_table();
    if (table == nullptr || (!isMajor && key != "minor")) {
      return wrong(file, node,
                   fmt::format("`{}`: a code file has the tables [major] and [minor]", key.str()));
    }
    Table& codes = isMajor ? result.majors_ : result.minors_;
    for (const auto& [name, value] : *table) {
      const auto code = value.value_exact<std::int64_t>();
      if (!isSpelling(name.str())) {
        return wrong(file, value,
                     fmt::format("`{}` is no word: capitals, digits and _, at most {}", name.str(),
                                 longestWord));
      }
      if (!code || *code < 1 || *code > largestCode) {
        return wrong(file, value,
                     fmt::format("the code of {} must be a whole number from 1 to {}", name.str(),
                                 largestCode));
      }
      const auto [other, fresh] = codes.words.emplace(static_cast<int>(*code), name.str());
      if (!fresh) {
        return wrong(file, value,
                     fmt::format("{} and {} have the same code, {}", other->second, name.str(),
                                 *code));
      }
      codes.codes.emplace(name.str(), static_cast<int>(*code));
    }
  }
  for (const auto& [code, name] : result.majors_.words) {
    const auto holder = findPostWord(code);
    if (holder && !result.majors_.find(spell(*holder))) {
      return wrong(file, *root.get("major"),
                   fmt::format("{0} takes the code {1} of {2}, which then needs another one", name,
                               code, spell(*holder)));
    }
  }
  return result;
}

std::optional<int> Codes::minor(Word word) const {
  if (const auto given = minors_.find(spell(word))) {
    return given;
  }
  const auto code = modifierCode(word);
  return code && minors_.find(*code) == nullptr ? code : std::nullopt;
}

std::optional<int> Codes::minor(std::string_view text) const {
  return minors_.find(text);
}

std::optional<cl::Value> Codes::minorOf(int code) const {
  if (const std::string* given = minors_.find(code)) {
    const auto word = findWord(*given);
    return word ? cl::Value(*word) : cl::Value(*given);
  }
  const auto word = modifierOf(code);
  const bool moved = word && minors_.find(spell(*word));
  return word && !moved ? std::optional<cl::Value>(*word) : std::nullopt;
}

int Codes::major(Word word) const {
  return majors_.find(spell(word)).value_or(row(word).code);
}

int Codes::major(std::string_view foreign) const {
  return majors_.find(foreign).value_or(0);
}

std::optional<cl::Post> Codes::majorOf(int code) const {
  if (const std::string* given = majors_.find(code)) {
    const auto word = findWord(*given);
    cl::Post post;
    if (word && isPost(*word)) {
      post.word = *word;
    } else {
      post.foreign = *given;
    }
    return post;
  }
  const auto word = findPostWord(code);
  const bool moved = word && majors_.find(spell(*word));
  return word && !moved ? std::optional<cl::Post>(cl::Post{*word, "", {}}) : std::nullopt;
}

}  // namespace arelem::backend::tape
