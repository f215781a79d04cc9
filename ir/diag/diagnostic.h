#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "ir/diag/kind.h"
#include "ir/text/span.h"

namespace arelem {

/// All rows of all rooms, in the order of the rooms.
[[nodiscard]] std::span<const DiagRow> diagnosticTable();
/// The row with this code ("E0312", any case) or name, or nullptr.
[[nodiscard]] const DiagRow* findDiagnostic(std::string_view codeOrName);

/// A second place that matters, with what is to be said there.
struct Label {
  Span span;
  std::string text;
};

/// An error that knows no source text: what geometry and motion return. The interpreter gives it a
/// place.
struct Failure {
  const DiagRow* row = nullptr;
  std::string message;
  std::vector<std::string> notes;
  std::string help;

  Failure&& note(std::string text) && {
    notes.push_back(std::move(text));
    return std::move(*this);
  }
  Failure&& withHelp(std::string text) && {
    help = std::move(text);
    return std::move(*this);
  }
};

/// A failure with its place: what the user sees.
struct Diagnostic {
  const DiagRow* row = nullptr;
  Span at;
  std::string message;
  std::vector<Label> labels;
  std::vector<std::string> notes;
  std::string help;
  std::vector<Span> calledFrom;  ///< innermost CALL first

  [[nodiscard]] const DiagRow& kind() const { return *row; }
  [[nodiscard]] Severity severity() const { return kind().severity; }

  Diagnostic&& label(Span span, std::string text) && {
    labels.push_back({span, std::move(text)});
    return std::move(*this);
  }
  Diagnostic&& note(std::string text) && {
    notes.push_back(std::move(text));
    return std::move(*this);
  }
  Diagnostic&& withHelp(std::string text) && {
    help = std::move(text);
    return std::move(*this);
  }
};

template <class... Args>
[[nodiscard]] Failure fail(const DiagKind<Args...>& kind,
                           const std::type_identity_t<Args>&... args) {
  return {kind.row, fmt::format(fmt::runtime(kind.row->text), args...), {}, {}};
}

template <class... Args>
[[nodiscard]] Diagnostic diagnose(Span at,
                                  const DiagKind<Args...>& kind,
                                  const std::type_identity_t<Args>&... args) {
  Diagnostic d;
  d.row = kind.row;
  d.at = at;
  d.message = fmt::format(fmt::runtime(kind.row->text), args...);
  return d;
}

[[nodiscard]] Diagnostic at(Span span, Failure failure);

/// Receives diagnostics. Readers are an open set (terminal, JSON, REPL, tests), hence an interface.
class DiagnosticSink {
 public:
  virtual ~DiagnosticSink() = default;
  virtual void accept(Diagnostic diagnostic) = 0;
};

/// Keeps everything and counts errors.
class CollectingSink : public DiagnosticSink {
 public:
  void accept(Diagnostic diagnostic) override;
  [[nodiscard]] const std::vector<Diagnostic>& all() const { return all_; }
  [[nodiscard]] std::size_t errors() const { return errors_; }
  [[nodiscard]] std::size_t warnings() const { return all_.size() - errors_; }
  void clear();

 private:
  std::vector<Diagnostic> all_;
  std::size_t errors_ = 0;
};

}  // namespace arelem
