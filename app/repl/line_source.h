#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/repl/history.h"

#include "frontend/complete/complete.h"

namespace arelem::app::repl {

/// Where the lines of a session come from.
class LineSource {
 public:
  virtual ~LineSource() = default;
  struct Line {
    std::string text;
    bool cancelled = false;  ///< Ctrl-C: what was typed counts for nothing
  };
  /// Nothing at the end of the input.
  virtual std::optional<Line> read(const std::string& prompt) = 0;
  /// Called on the watching thread when a signal came.
  virtual void wake(int signal) = 0;
  virtual void remember(const std::string& line) = 0;
  [[nodiscard]] virtual bool isTerminal() const = 0;
};

/// Candidates for the line as far as it is typed.
using Completer = std::function<frontend::Completion(const std::string& line)>;

/// The line with color codes, which change nothing of what is seen of it; "" while there are no
/// colors.
using Highlighter = std::function<std::string(const std::string& line)>;

/// A line editor where input and output are terminals, else plain lines without a prompt. Without a
/// highlighter the typed line has no colors.
[[nodiscard]] std::unique_ptr<LineSource> openLines(History& history,
                                                    Completer completer,
                                                    Highlighter highlighter);

}  // namespace arelem::app::repl
