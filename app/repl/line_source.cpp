#include "app/repl/line_source.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <iostream>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

// The line editor's headers want FILE to be known.
#include <cstdio>

#include <readline/history.h>
#include <readline/readline.h>

namespace arelem::app::repl {

namespace {
class PlainLines : public LineSource {
 public:
  std::optional<Line> read(const std::string& /*prompt*/) override {
    Line line;
    if (!std::getline(std::cin, line.text)) {
      return std::nullopt;
    }
    if (!line.text.empty() && line.text.back() == '\r') {
      line.text.pop_back();
    }
    return line;
  }
  void wake(int /*signal*/) override {}
  void remember(const std::string& /*line*/) override {}
  [[nodiscard]] bool isTerminal() const override { return false; }
};

/// GNU readline works with global functions: this is what they look at. One editor at a time.
struct EditorState {
  int pipe[2] = {-1, -1};
  bool cancelled = false;
  bool terminated = false;
  Completer completer;
  Highlighter highlighter;
  bool plain = false;  ///< this line is drawn by the editor itself
  std::vector<std::string> candidates;
};
EditorState& state() {
  static EditorState s;
  return s;
}

/// Waits for a key or for word of a signal: signals are blocked for this thread.
int getKey(FILE* in) {
  while (true) {
    pollfd waits[2] = {{fileno(in), POLLIN, 0}, {state().pipe[0], POLLIN, 0}};
    const int n = ::poll(waits, 2, -1);
    if (n < 0 && errno == EINTR) {
      rl_check_signals();  // a window that changed its size
      continue;
    }
    if ((waits[1].revents & POLLIN) != 0) {
      unsigned char signal = 0;
      if (::read(state().pipe[0], &signal, 1) == 1) {
        state().terminated = signal == SIGTERM;
        state().cancelled = true;
        if (state().terminated) {
          return EOF;
        }
        rl_replace_line("", 1);
        return '\n';
      }
    }
    unsigned char key = 0;
    const ssize_t got = ::read(fileno(in), &key, 1);
    if (got == 1) {
      return key;
    }
    if (got == 0 || errno != EINTR) {
      return EOF;
    }
  }
}

char* nextCandidate(const char* /*text*/, int index) {
  const auto i = static_cast<std::size_t>(index);
  return i < state().candidates.size() ? ::strdup(state().candidates[i].c_str()) : nullptr;
}

char** completeLine(const char* text, int start, int end) {
  rl_attempted_completion_over = 1;  // never the editor's own list of files
  const std::string line(rl_line_buffer, static_cast<std::size_t>(end));
  const bool command = !line.empty() && line.front() == ':' && line.find(' ') == line.npos;
  rl_completion_append_character = command ? ' ' : '\0';  // the editor sets it anew each time
  const frontend::Completion found = state().completer(line);
  // The editor replaces from `start`; candidates that begin earlier lose what stands there.
  const auto from = static_cast<std::size_t>(start);
  state().candidates.clear();
  for (const std::string& candidate : found.candidates) {
    if (found.begin == from) {
      state().candidates.push_back(candidate);
    } else if (found.begin < from && candidate.size() > from - found.begin) {
      state().candidates.push_back(candidate.substr(from - found.begin));
    }
  }
  return state().candidates.empty() ? nullptr : rl_completion_matches(text, nextCandidate);
}

/// The prompt without the marks round its colors, and how wide it is.
std::string shownPrompt(std::size_t& width) {
  std::string prompt;
  width = 0;
  bool hidden = false;
  for (const char* c = rl_display_prompt; c != nullptr && *c != '\0'; ++c) {
    if (*c == RL_PROMPT_START_IGNORE || *c == RL_PROMPT_END_IGNORE) {
      hidden = *c == RL_PROMPT_START_IGNORE;
    } else {
      prompt += *c;
      width += hidden ? 0 : 1;
    }
  }
  return prompt;
}

/// Draws a line that fits the row, in colors. Longer lines, and those with other than plain
/// characters, are left to the editor, which has no colors.
void drawLine() {
  EditorState& s = state();
  int rows = 0;
  int columns = 0;
  rl_get_screen_size(&rows, &columns);
  std::size_t promptWidth = 0;
  const std::string prompt = shownPrompt(promptWidth);
  const std::string line(rl_line_buffer, static_cast<std::size_t>(rl_end));
  const bool printable =
      std::all_of(line.begin(), line.end(), [](unsigned char c) { return c >= 0x20 && c < 0x7f; });
  const bool fits =
      columns > 0 && promptWidth + line.size() + 1 < static_cast<std::size_t>(columns);
  if (!s.plain && !(fits && printable)) {
    s.plain = true;
    std::fputs("\r\033[K", rl_outstream);
    rl_on_new_line();
  }
  if (s.plain) {
    rl_redisplay();
    return;
  }
  std::string shown = "\r" + prompt + s.highlighter(line) + "\033[K\r";
  if (const std::size_t at = promptWidth + static_cast<std::size_t>(rl_point); at > 0) {
    shown += "\033[" + std::to_string(at) + "C";
  }
  std::fputs(shown.c_str(), rl_outstream);
  std::fflush(rl_outstream);
  rl_on_new_line();  // the editor has drawn nothing, and moves nothing when the line ends
}

/// No question before many candidates and no pages of them: their keys would not know Ctrl-C. The
/// editor calls it behind the user's own settings.
int listWithoutQuestions() {
  rl_completion_query_items = -1;
  rl_variable_bind("page-completions", "off");
  return 0;
}

class Editor : public LineSource {
 public:
  Editor(History& history, Completer completer, Highlighter highlighter) : history_(history) {
    if (::pipe2(state().pipe, O_CLOEXEC | O_NONBLOCK) != 0) {
      state().pipe[0] = state().pipe[1] = -1;
    }
    state().completer = std::move(completer);
    state().highlighter = std::move(highlighter);
    if (state().highlighter) {
      rl_redisplay_function = drawLine;
    }
    rl_readline_name = "arelem";
    rl_startup_hook = listWithoutQuestions;
    rl_catch_signals = 0;  // they come through the pipe
    rl_getc_function = getKey;
    rl_attempted_completion_function = completeLine;
    rl_basic_word_break_characters = const_cast<char*>(" \t,/()=+-*'");  // NOLINT: its interface
    rl_completer_quote_characters = "";
    rl_variable_bind("enable-bracketed-paste", "on");
    rl_variable_bind("completion-ignore-case", "on");
    rl_variable_bind("show-all-if-ambiguous", "on");
    using_history();
    for (const std::string& line : history.lines()) {
      add_history(line.c_str());
    }
  }
  ~Editor() override {
    clear_history();
    rl_redisplay_function = rl_redisplay;
    state() = EditorState();
  }
  Editor(const Editor&) = delete;
  Editor& operator=(const Editor&) = delete;

  std::optional<Line> read(const std::string& prompt) override {
    forgetSignals();  // those that ended a computation
    state().plain = !state().highlighter || state().highlighter("0").empty();
    char* const typed = ::readline(prompt.c_str());
    if (!state().plain) {
      std::fputs("\n", rl_outstream);
      std::fflush(rl_outstream);
    }
    if (typed == nullptr) {
      std::cout << (state().plain ? "\n" : "");
      return std::nullopt;
    }
    Line line{typed, state().cancelled};
    std::free(typed);  // NOLINT(cppcoreguidelines-no-malloc): the editor's memory
    return line;
  }
  void wake(int signal) override {
    const auto byte = static_cast<unsigned char>(signal);
    static_cast<void>(::write(state().pipe[1], &byte, 1) == 1);
  }
  void remember(const std::string& line) override {
    add_history(line.c_str());
    history_.add(line);
  }
  [[nodiscard]] bool isTerminal() const override { return true; }

 private:
  static void forgetSignals() {
    unsigned char byte = 0;
    while (::read(state().pipe[0], &byte, 1) == 1) {
    }
    state().cancelled = false;
  }
  History& history_;
};
}  // namespace

std::unique_ptr<LineSource> openLines(History& history,
                                      Completer completer,
                                      Highlighter highlighter) {
  if (::isatty(STDIN_FILENO) == 1 && ::isatty(STDOUT_FILENO) == 1) {
    return std::make_unique<Editor>(history, std::move(completer), std::move(highlighter));
  }
  return std::make_unique<PlainLines>();
}

}  // namespace arelem::app::repl
