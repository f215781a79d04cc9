// :help, and the list of all commands.
#include <algorithm>
#include <array>

#include "app/language.h"
#include "app/manual_pages.h"
#include "app/messages.h"
#include "app/nearest.h"
#include "app/repl/console.h"

#include "ir/diag/display_text.h"

namespace arelem::app::repl {

namespace {
std::string leave(Console& console, const std::string& /*rest*/) {
  console.leaving = true;
  return "";
}

constexpr std::array commands = {
    ConsoleCommand{":help", "[WORD]", "this list; forms and statements of a word; a diagnostic",
                   'w', help},
    ConsoleCommand{":list", "[TYPE or NAME*]", "what the session has defined", 'w', listNames},
    ConsoleCommand{":show", "NAME, ...", "values, with the statement that defined them", 'n',
                   showEntity},
    ConsoleCommand{":why", "NAME", "how it was solved, and why the other candidates lost", 'n',
                   explainEntity},
    ConsoleCommand{":distance", "A,B", "how far two entities are apart", 'n', measure},
    ConsoleCommand{":plot", "[FILE.svg]", "a picture of geometry and path", 'f', plot},
    ConsoleCommand{":view", "[FILE.html]", "a page to turn, play and measure in a browser", 'f',
                   view},
    ConsoleCommand{":undo", "[N]", "takes back the last statements", ' ', undo},
    ConsoleCommand{":redo", "[N]", "brings them again", ' ', redo},
    ConsoleCommand{":save", "FILE", "the accepted statements as a part program; - shows them", 'f',
                   save},
    ConsoleCommand{":load", "FILE", "a part program in the place of the session", 'f', loadFile},
    ConsoleCommand{":time", "", "how long a machine takes, statement by statement", ' ', tellTime},
    ConsoleCommand{":step", "[N or reset]", "goes through the motion, a statement at a time", ' ',
                   step},
    ConsoleCommand{":set", "[NAME VALUE]", "how things are shown, and the machine of :time", 's',
                   set},
    ConsoleCommand{":quit", "", "ends the session, as Ctrl-D does", ' ', leave},
};

std::string upperCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

void printCommands(Console& console) {
  for (const ConsoleCommand& c : commands) {
    console.out << fmt::format("{:<26}{}\n", fmt::format("{} {}", c.name, c.arguments), c.summary);
  }
  console.out
      << "\nStatements are as in a file; `$` continues one. ANS is the last unnamed result: "
         "try 3*SINF(30), then CIRCLE/0,0,ANS.\n";
}

/// Commands that begin with this text; the exact one alone.
std::vector<const ConsoleCommand*> commandsOf(const std::string& text) {
  std::vector<const ConsoleCommand*> found;
  for (const ConsoleCommand& c : commands) {
    if (c.name == text) {
      return {&c};
    }
    if (c.name.starts_with(text)) {
      found.push_back(&c);
    }
  }
  return found;
}

bool printPage(Console& console, const std::string& code) {
  for (const ManualPage& page : manualPages()) {
    if (page.code == code) {
      console.out << page.text;
      return true;
    }
  }
  return false;
}
}  // namespace

std::span<const ConsoleCommand> consoleCommands() {
  return commands;
}

std::string help(Console& console, const std::string& rest) {
  if (rest.empty()) {
    printCommands(console);
    return "";
  }
  const std::string word = upperCase(rest);
  std::string command = rest;
  std::transform(command.begin(), command.end(), command.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const bool colon = command.front() == ':';
  if (colon) {
    for (const ConsoleCommand* c : commandsOf(command)) {
      console.out << fmt::format("{} {}\n        {}\n", c->name, c->arguments, c->summary);
      return "";
    }
  }
  if (printLanguage(console.out, word) || printPage(console, word)) {
    return "";
  }
  if (const std::optional<Word> known = findWord(word)) {
    console.out << fmt::format(
        "{} is a word of the language; no form of its own is in the tables\n", spell(*known));
    return "";
  }
  std::vector<std::string> known;
  for (std::size_t i = 0; i < static_cast<std::size_t>(Word::count); ++i) {
    known.emplace_back(spell(static_cast<Word>(i)));
  }
  const std::string guess = nearest(word, known);
  return "there is no help on `" + displayText(rest) + "`" +
         (guess.empty() ? "" : "; did you mean `" + guess + "`?");
}

void obey(Console& console, const std::string& line) {
  const std::size_t blank = line.find_first_of(" \t");
  const std::string word = line.substr(0, blank);
  std::string rest = blank == std::string::npos ? "" : line.substr(blank);
  rest.erase(0, std::min(rest.find_first_not_of(" \t"), rest.size()));
  rest.erase(rest.find_last_not_of(" \t") + 1);
  const auto found = commandsOf(word);
  std::string wrong;
  if (found.size() == 1) {
    wrong = found.front()->run(console, rest);
  } else if (found.empty() || word == ":") {
    wrong = "there is no command `" + displayText(word) + "`; :help lists them";
  } else {
    wrong = "`" + displayText(word) + "` may be";
    for (const ConsoleCommand* c : found) {
      wrong += fmt::format(" {}", c->name);
    }
  }
  if (!wrong.empty()) {
    console.out.flush();
    printError(wrong);
    console.worst = worse(console.worst, ExitCode::wrongUse);
  }
}

}  // namespace arelem::app::repl
