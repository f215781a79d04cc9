// :help, and the list of all commands.
#include <algorithm>
#include <array>
#include <cctype>

#include "app/command.h"
#include "app/language.h"
#include "app/manual_pages.h"
#include "app/messages.h"
#include "app/nearest.h"
#include "app/repl/console.h"

#include "frontend/complete/complete.h"
#include "ir/define/matcher.h"
#include "ir/diag/display_text.h"

namespace arelem::app::repl {

namespace {
std::string leave(Console& console, const std::string& /*rest*/) {
  console.leaving = true;
  return "";
}

constexpr std::array commands = {
    ConsoleCommand{
        ":help", "[WORD]",
        "this list; a word of the language; a diagnostic; a page of the manual; a command",
        Completes::help, help},
    ConsoleCommand{":list", "[TYPE or NAME*]", "what the session has defined",
                   Completes::typeOrName, listNames},
    ConsoleCommand{":show", "NAME, ...", "values, with the statement that defined them",
                   Completes::name, showEntity},
    ConsoleCommand{":why", "NAME", "how it was solved, and why the other candidates lost",
                   Completes::name, explainEntity},
    ConsoleCommand{":distance", "A,B", "how far two entities are apart", Completes::name, measure},
    ConsoleCommand{":curve", "NAME[,t or POINT]",
                   "pieces of a path spline; its derivatives and curvature at a place",
                   Completes::name, tellCurve},
    ConsoleCommand{":plot", "[FILE.svg]", "a picture of geometry and path", Completes::picture,
                   plot},
    ConsoleCommand{":view", "[FILE.html]", "a page to turn, play and measure in a browser",
                   Completes::page, view},
    ConsoleCommand{":undo", "[N]", "takes back the last statements", Completes::nothing, undo},
    ConsoleCommand{":redo", "[N]", "brings them again", Completes::nothing, redo},
    ConsoleCommand{":save", "FILE", "the accepted statements as a part program; - shows them",
                   Completes::program, save},
    ConsoleCommand{":load", "FILE", "a part program in the place of the session",
                   Completes::program, loadFile},
    ConsoleCommand{":time", "", "how long a machine takes, statement by statement",
                   Completes::nothing, tellTime},
    ConsoleCommand{":step", "[N or reset]", "goes through the motion, a statement at a time",
                   Completes::nothing, step},
    ConsoleCommand{":set", "[NAME VALUE]", "how things are shown, and the machine of :time",
                   Completes::setting, set},
    ConsoleCommand{":quit", "", "ends the session, as Ctrl-D does", Completes::nothing, leave},
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
         "try 3*SINF(30), then CIRCLE/0,0,ANS.\n:help CIRCLE shows the forms of circles, :help "
         "E0310 a "
         "diagnostic, :help smoothing a page of the manual, :help topics all pages.\n";
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

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The page of this name, or nothing.
const ManualPage* pageOf(std::span<const ManualPage> pages, const std::string& code) {
  const auto found = std::find_if(pages.begin(), pages.end(),
                                  [&](const ManualPage& page) { return page.code == code; });
  return found == pages.end() ? nullptr : &*found;
}

/// A page without the comment in front of a page that is made by a program.
std::string_view shownText(const ManualPage& page) {
  constexpr std::string_view end = "-->";
  std::string_view text = page.text;
  if (text.starts_with("<!--")) {
    text.remove_prefix(std::min(text.size(), text.find(end) + end.size()));
    text.remove_prefix(std::min(text.size(), text.find_first_not_of('\n')));
  }
  return text;
}

void printTopics(Console& console) {
  for (const ManualPage& page : manualTopics()) {
    const std::string_view text = shownText(page), title = text.substr(0, text.find('\n'));
    console.out << fmt::format("{:<18}{}\n", page.code,
                               title.substr(std::min(title.find_first_not_of("# "), title.size())));
  }
}

/// Whether a syntax line has the word as a whole one.
bool hasWord(std::string_view syntax, std::string_view word) {
  const auto isPart = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t i = syntax.find(word); i != syntax.npos; i = syntax.find(word, i + 1)) {
    const std::size_t end = i + word.size();
    if ((i == 0 || !isPart(syntax[i - 1])) && (end == syntax.size() || !isPart(syntax[end]))) {
      return true;
    }
  }
  return false;
}

/// Where a modifier may stand, or what else the tables know of a word.
void printUses(Console& console, Word word) {
  const std::string_view text = spell(word);
  bool any = false;
  for (const define::FormRow& form : define::formTable()) {
    const std::string line = form.anyNoun ? "" : define::syntaxLine(form.noun, form.id);
    if (hasWord(line, text)) {
      console.out << line << "\n        " << form.meaning << '\n';
      any = true;
    }
  }
  for (const frontend::StatementForm& form : frontend::statementForms()) {
    if (hasWord(form.pattern, text)) {
      console.out << spell(form.word) << "/ " << form.pattern << "\n        " << form.meaning
                  << '\n';
      any = true;
    }
  }
  const WordRow& known = row(word);
  if (known.type == 2000) {
    console.out << fmt::format(
        "{}{}\n        post-processor word {}: it goes to the CL records as it is\n", text,
        known.wordClass == WordClass::postWithoutParameters ? "" : "/ [parameters]", known.code);
  } else if (!any) {
    console.out << fmt::format("{} is a word of the language; the tables have no form of its own\n",
                               text);
  }
}

/// The page of a subject, or what `arelem COMMAND` is for.
bool printTopic(Console& console, const std::string& subject) {
  const std::string name =
      subject.ends_with(".md") ? subject.substr(0, subject.size() - 3) : subject;
  if (const ManualPage* page = pageOf(manualTopics(), name)) {
    console.out << shownText(*page);
    return true;
  }
  for (const Command& command : app::commands()) {
    if (command.name == name) {
      console.out << fmt::format("arelem {}: {}; arelem {} --help tells its options\n", name,
                                 command.summary, name);
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
  const std::string command = lowerCase(rest);
  if (command.front() == ':') {
    for (const ConsoleCommand* c : commandsOf(command)) {
      console.out << fmt::format("{} {}\n        {}\n", c->name, c->arguments, c->summary);
      return "";
    }
  }
  if (command == "topics") {
    printTopics(console);
    return "";
  }
  if (const ManualPage* page = pageOf(manualPages(), word)) {
    console.out << shownText(*page);
    return "";
  }
  const std::optional<Word> known = findWord(word);
  const bool own = printLanguage(console.out, word);
  if (known && !own) {
    printUses(console, *known);
  }
  if (known || own) {
    if (pageOf(manualTopics(), command) != nullptr) {
      console.out << fmt::format("there is a page about it: :help {}.md\n", command);
    }
    return "";
  }
  if (printTopic(console, command)) {
    return "";
  }
  std::vector<std::string> all;
  for (std::size_t i = 0; i < static_cast<std::size_t>(Word::count); ++i) {
    all.emplace_back(spell(static_cast<Word>(i)));
  }
  const std::string guess = nearest(word, all);
  return "there is no help on `" + displayText(rest) + "`" +
         (guess.empty() ? "" : "; did you mean `" + guess + "`?");
}

void Console::blame(ExitCode code) {
  if (worst == ExitCode::ok || worst == ExitCode::wrongUse) {
    worst = code == ExitCode::ok ? worst : code;
  } else if (code != ExitCode::wrongUse) {
    worst = worse(worst, code);
  }
}

void Console::report(Failure failure) {
  DiagnosticLog log;
  log.accept(std::move(failure));
  blame(log.exitCode());
  out.flush();
  log.print(SourceMap(), {}, settings);
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
    console.blame(ExitCode::wrongUse);
  }
}

}  // namespace arelem::app::repl
