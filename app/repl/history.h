#pragma once
#include <optional>
#include <string>
#include <vector>

namespace arelem::app::repl {

/// The lines of earlier sessions, in $XDG_STATE_HOME/arelem/history or
/// ~/.local/state/arelem/history. Each line is added to the file at once; whatever goes wrong is
/// said once, and the session goes on without the file.
class History {
 public:
  /// "" keeps no history.
  explicit History(std::string path);
  /// Where the environment says; "" without a home.
  [[nodiscard]] static std::string usualPath();

  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }
  /// What went wrong, the first time that it is asked for.
  [[nodiscard]] std::optional<std::string> complaint();
  void add(const std::string& line);

 private:
  void read();
  void complain(const std::string& what);

  std::string path_;
  std::vector<std::string> lines_;
  std::optional<std::string> complaint_;
};

}  // namespace arelem::app::repl
