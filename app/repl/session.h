#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/repl/run.h"

#include "frontend/complete/complete.h"

namespace arelem::app::repl {

/// The accepted statements of a session and what they amount to. Every entry is compiled together
/// with all before it, exactly as a file of them would be, so a saved session means the same.
class Session {
 public:
  explicit Session(const Settings& settings);

  struct Answer {
    Verdict verdict;
    std::shared_ptr<const Run> run;     ///< with the sources of the diagnostics; null: nothing done
    std::shared_ptr<const Run> before;  ///< what was there before
    std::string shown;                  ///< name that was only asked for
    std::string objection;              ///< why nothing was tried
    bool ended = false;                 ///< the entry is FINI, which :save adds
    std::optional<Span> inserted;       ///< the name that an unnamed statement was given, with `=`
  };

  /// Statements as they were typed, with their line ends. `ANS` in them is the last unnamed result;
  /// TYPE/ ... and expressions without a name get one, ANS1, ANS2, ...
  [[nodiscard]] Answer submit(const std::string& text, const InterruptFlag& interrupted);
  /// A whole program in the place of the session. Statements with errors are left out; their
  /// diagnostics are in the answer.
  [[nodiscard]] Answer load(const std::string& name,
                            const std::string& text,
                            const InterruptFlag& interrupted);
  /// Takes back the last `n` entries, or brings them again; how many.
  std::size_t undo(std::size_t n, const InterruptFlag& interrupted);
  std::size_t redo(std::size_t n, const InterruptFlag& interrupted);

  [[nodiscard]] const std::shared_ptr<const Run>& run() const { return run_; }
  /// The accepted statements with FINI. Left out: unnamed results that nothing uses, and the motion
  /// that waits for the next one, with which the program would have an error.
  [[nodiscard]] std::string program() const;
  /// The statement that waits; "" of none.
  [[nodiscard]] std::string waiting() const;
  [[nodiscard]] std::string text() const;
  [[nodiscard]] const std::string& answerName() const { return answer_; }
  [[nodiscard]] std::vector<frontend::KnownName> names() const;
  [[nodiscard]] bool empty() const { return entries_.empty(); }

 private:
  struct Entry {
    std::string text;
    std::string answer;  ///< what ANS is behind it
    bool unnamed = false;
  };
  void rebuild(const InterruptFlag& interrupted);
  [[nodiscard]] std::string withAnswer(const std::string& text) const;
  [[nodiscard]] bool isOwnAnswer(const std::string& entry) const;
  [[nodiscard]] bool isName(const std::string& text) const;

  const Settings& settings_;
  std::string name_ = "session";
  std::vector<Entry> entries_, undone_;
  std::shared_ptr<const Run> run_;
  std::string answer_;
  std::size_t unnamed_ = 0;
};

/// The text without the statements in which these diagnostics found errors.
[[nodiscard]] std::string withoutErrors(const std::string& text,
                                        const std::vector<Diagnostic>& found,
                                        BufferId buffer,
                                        const Settings& settings);

}  // namespace arelem::app::repl
