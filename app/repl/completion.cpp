#include "app/repl/completion.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>

#include "app/command.h"
#include "app/manual_pages.h"
#include "app/repl/console.h"

namespace arelem::app::repl {

namespace {
bool isFile(Completes kind) {
  return kind == Completes::program || kind == Completes::picture || kind == Completes::page;
}

/// Whether a file may be a part program: a text that is neither a page, a picture nor JSON.
bool mayBeProgram(const std::filesystem::path& path) {
  constexpr std::size_t enough = 512;
  std::array<char, enough> begin{};
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {  // a pipe would wait
    return false;
  }
  std::ifstream in(path, std::ios::binary);
  in.read(begin.data(), begin.size());
  const std::string_view text(begin.data(), static_cast<std::size_t>(in.gcount()));
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return in.good() || in.eof()
             ? text.find('\0') == text.npos &&
                   (first == text.npos || std::string_view("<{[%").find(text[first]) == text.npos)
             : false;
}

/// Whether a command that takes files of this kind is to be offered this one.
bool isOffered(const std::filesystem::path& path, Completes kind) {
  const std::string suffix = path.extension().string();
  return kind == Completes::picture ? suffix == ".svg"
         : kind == Completes::page  ? suffix == ".html"
                                    : mayBeProgram(path);
}

std::vector<std::string> filesBeside(const std::string& begin, Completes kind) {
  std::vector<std::string> found;
  const std::size_t slash = begin.find_last_of('/');
  const std::string folder = slash == std::string::npos ? "" : begin.substr(0, slash + 1);
  std::error_code error;
  const std::filesystem::directory_iterator end;
  for (std::filesystem::directory_iterator i(folder.empty() ? "." : folder, error);
       !error && i != end && found.size() < 500; i.increment(error)) {
    const std::string name = folder + i->path().filename().string();
    if (!name.starts_with(begin)) {
      continue;
    }
    if (i->is_directory(error)) {
      found.push_back(name + "/");
    } else if (isOffered(i->path(), kind)) {
      found.push_back(name);
    }
    error.clear();
  }
  return found;
}

std::vector<std::string> wordsOfCommand(const Session& session,
                                        Completes kind,
                                        const std::string& begin) {
  std::vector<std::string> all;
  if (isFile(kind)) {
    all = filesBeside(begin, kind);
  } else if (kind == Completes::setting) {
    all = settingNames();
  } else if (kind == Completes::name || kind == Completes::typeOrName) {
    for (const auto& name : session.names()) {
      all.push_back(name.name);
    }
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(Word::count); ++i) {
    const Word word = static_cast<Word>(i);
    if (kind == Completes::help ||
        (kind == Completes::typeOrName && row(word).wordClass == WordClass::geometry)) {
      all.emplace_back(spell(word));
    }
  }
  if (kind == Completes::help) {
    all.emplace_back("topics");
    for (const ManualPage& page : manualTopics()) {
      all.emplace_back(page.code);
    }
    for (const Command& command : app::commands()) {
      all.emplace_back(command.name);
    }
  }
  return all;
}

bool beginsWith(std::string_view word, std::string_view begin) {
  return word.size() >= begin.size() &&
         std::equal(begin.begin(), begin.end(), word.begin(), [](unsigned char a, unsigned char b) {
           return std::toupper(a) == std::toupper(b);
         });
}

frontend::Completion completeCommand(const Session& session, const std::string& line) {
  frontend::Completion found;
  const std::size_t blank = line.find(' ');
  std::vector<std::string> all;
  Completes kind = Completes::nothing;
  if (blank == std::string::npos) {
    for (const ConsoleCommand& c : consoleCommands()) {
      all.emplace_back(c.name);
    }
  } else {
    for (const ConsoleCommand& c : consoleCommands()) {
      kind = line.substr(0, blank) == c.name ? c.completes : kind;
    }
    found.begin = line.find_last_of(isFile(kind) ? " " : " ,") + 1;
    all = wordsOfCommand(session, kind, line.substr(found.begin));
  }
  const std::string begin = line.substr(found.begin);
  const bool exact = isFile(kind);
  for (const std::string& word : all) {
    if (exact ? word.starts_with(begin) : beginsWith(word, begin)) {
      found.candidates.push_back(word);
    }
  }
  std::sort(found.candidates.begin(), found.candidates.end());
  found.candidates.erase(std::unique(found.candidates.begin(), found.candidates.end()),
                         found.candidates.end());
  return found;
}

/// INCLUDE/'file: the quote was opened and not closed.
std::optional<frontend::Completion> completeQuoted(const std::string& line) {
  if (std::count(line.begin(), line.end(), '\'') % 2 == 0) {
    return std::nullopt;
  }
  frontend::Completion found;
  found.begin = line.rfind('\'') + 1;
  for (const std::string& file : filesBeside(line.substr(found.begin), Completes::program)) {
    found.candidates.push_back(file);
  }
  return found;
}

}  // namespace

std::optional<frontend::Completion> completeCommandOrFile(const Session& session,
                                                          const std::string& line) {
  return !line.empty() && line.front() == ':' ? completeCommand(session, line)
                                              : completeQuoted(line);
}

}  // namespace arelem::app::repl
