#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <iostream>

#include "app/command.h"
#include "app/manual_pages.h"
#include "app/options.h"
#include "app/repl/completion.h"
#include "app/repl/console.h"
#include "app/repl/highlight.h"
#include "app/repl/line_source.h"
#include <sys/ioctl.h>
#include <unistd.h>

#include "ir/diag/display_text.h"

namespace arelem::app {

namespace {
/// A terminal that knows no colors and no cursor.
bool isDumbTerminal() {
  const char* const terminal = std::getenv("TERM");  // NOLINT(concurrency-mt-unsafe)
  return terminal == nullptr || std::string_view(terminal) == "dumb";
}

using namespace repl;

constexpr int narrow = 24;  // columns below which the prompt is one character

int columnsOfTerminal() {
  winsize size{};
  return ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

std::string promptOf(const Console& console, bool goesOn) {
  const bool brief = columnsOfTerminal() < narrow;
  const std::string text = goesOn  ? (brief ? "." : "   ... ")
                           : brief ? ">"
                                   : fmt::format("apt({})> ", unitOf(*console.session.run()));
  // The line editor must not count the colors.
  return console.style.color ? "\001\033[1;32m\002" + text + "\001\033[0m\002" : text;
}

class Loop {
 public:
  Loop(Console& console, LineSource& lines, std::string& pending)
      : console_(console), lines_(lines), pending_(pending) {}

  void run() {
    while (!console_.leaving && !stopped()) {
      console_.out.flush();
      std::cerr.flush();
      const auto line = lines_.read(promptOf(console_, !pending_.empty()));
      console_.interrupt.forget();
      if (!line && lines_.isTerminal() && !pending_.empty() && !stopped()) {
        dropPending();
        continue;
      }
      if (!line) {
        break;
      }
      if (line->cancelled) {
        pending_.clear();
        continue;
      }
      take(line->text);
    }
    if (!pending_.empty() && !stopped()) {
      printError("the input ended within an open statement, loop, macro or block");
      console_.blame(ExitCode::programHasErrors);
    }
  }

 private:
  [[nodiscard]] bool stopped() const { return console_.interrupt.result() == ExitCode::terminated; }

  void dropPending() {
    console_.out << "the open statements are dropped"
                 << (lines_.isTerminal() ? "; the history has them\n" : "\n");
    pending_.clear();
  }

  void take(const std::string& line) {
    if (!line.empty() && line.find_first_not_of(" \t") != std::string::npos) {
      lines_.remember(line);
    }
    const std::size_t first = line.find_first_not_of(" \t");
    if (first != std::string::npos && line[first] == ':') {
      obey(console_, line.substr(first));
      return;
    }
    if (first == std::string::npos && pending_.empty()) {
      return;
    }
    answer(pending_ + line + "\n", line);
  }

  void answer(const std::string& entry, const std::string& line) {
    const Session::Answer answer = console_.session.submit(entry, console_.interrupt.flag());
    using State = Verdict::State;
    if (!answer.objection.empty()) {
      printError(answer.objection);
      console_.blame(ExitCode::programHasErrors);
      return;
    }
    if (answer.verdict.state == State::interrupted) {
      printError("interrupted; the statement is not taken");
      pending_.clear();
    } else if (answer.verdict.state == State::open) {
      pending_ = entry;
    } else if (answer.verdict.state == State::refused) {
      printDiagnostics(console_, *answer.run, answer.verdict.found, answer.inserted);
      refuse(answer);
      if (pending_.empty()) {
        return;
      }
      if (answer.verdict.unreadable) {
        console_.out << "this line is not taken: `" << displayText(line) << "`\n";
        return;
      }
      dropPending();
    } else {
      accept(answer);
      pending_.clear();
    }
  }

  void refuse(const Session::Answer& answer) {
    for (const Diagnostic& d : answer.verdict.found) {
      if (d.severity() == Severity::error) {
        console_.blame(exitCodeFor(d.kind()));
      }
    }
  }

  void accept(const Session::Answer& answer) {
    if (answer.ended) {
      console_.out << "FINI is added by :save; :quit leaves\n";
    } else if (!answer.shown.empty()) {
      static_cast<void>(showEntity(console_, answer.shown));
    } else if (answer.run) {
      printDiagnostics(console_, *answer.run, answer.verdict.found, answer.inserted);
      printNews(console_.out, *answer.run, *answer.before, console_.style);
    }
  }

  Console& console_;
  LineSource& lines_;
  std::string& pending_;
};

void greet(const LineSource& lines, History& history, bool quiet) {
  if (const auto complaint = history.complaint()) {
    std::cerr << "arelem: " << *complaint << '\n';
  }
  if (lines.isTerminal() && !quiet) {
    std::cout << "arelem: statements are computed as you type them; :help tells more, Ctrl-D "
                 "leaves\n";
  }
}

ExitCode converse(Console& console, const std::string& file, bool quiet) {
  History history(::isatty(STDIN_FILENO) == 1 ? History::usualPath() : "");
  std::string pending;
  const auto complete = [&](const std::string& line) {
    if (auto found = completeCommandOrFile(console.session, line)) {
      return *std::move(found);
    }
    frontend::Completion found = frontend::complete(pending + line, console.session.names());
    found.begin -= std::min(found.begin, pending.size());
    return found;
  };
  // Names are asked for once an entry, not at every key.
  std::shared_ptr<const Run> seen;
  std::vector<frontend::KnownName> names;
  const auto color = [&](const std::string& line) {
    if (seen != console.session.run()) {
      seen = console.session.run();
      names = console.session.names();
    }
    return console.style.color ? highlighted(line, names) : std::string();
  };
  const bool dumb = isDumbTerminal();
  const auto lines = openLines(history, complete, dumb ? Highlighter() : Highlighter(color));
  greet(*lines, history, quiet);
  console.interrupt.converse([&](int signal) { lines->wake(signal); });
  if (!file.empty()) {
    if (const std::string wrong = loadFile(console, file); !wrong.empty()) {
      printError(wrong);
      console.blame(ExitCode::interrupted);
    }
  }
  Loop(console, *lines, pending).run();
  console.interrupt.converse({});
  if (const auto complaint = history.complaint()) {
    std::cerr << "arelem: " << *complaint << '\n';
  }
  return lines->isTerminal() ? ExitCode::ok : console.worst;
}
}  // namespace

int runRepl(const Invocation& invocation) {
  CLI::App app(
      "Computes statements as they are typed. Definitions show their canonical form, motions what "
      "they did; :help lists\nthe commands. Without a terminal it reads plain lines, and the exit "
      "code tells the worst error.",
      "repl");
  Settings settings;
  std::string file;
  app.add_option("FILE", file, "a part program to begin with");
  addSourceOptions(app, settings);
  addMessageOptions(app, settings);
  if (const auto code = parse(app, invocation.words)) {
    return *code;
  }
  if (settings.dialect == frontend::Dialect::automatic) {
    settings.dialect = frontend::Dialect::native;
  }
  Session session(settings);
  Console console{settings, session, invocation.interrupt, std::cout, {}, {}};
  console.style.color = settings.color == ColorChoice::always ||
                        (settings.color == ColorChoice::automatic && !isDumbTerminal() &&
                         useColor(settings.color) && ::isatty(STDOUT_FILENO) == 1);
  return static_cast<int>(converse(console, file, settings.quiet));
}

}  // namespace arelem::app
