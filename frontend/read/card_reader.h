#pragma once
#include <string_view>

#include "frontend/check/reporter.h"
#include "frontend/compile.h"
#include "frontend/read/statement_text.h"

namespace arelem::frontend {

/// Turns the lines of one buffer into logical statements and numbers them as the old listing does:
/// every card that is not a continuation takes a number, blank and comment cards too.
class CardReader {
 public:
  /// `isn` is the number of the next statement; included texts count on in the same series.
  CardReader(const SourceMap& sources,
             BufferId buffer,
             const Options& options,
             Reporter& reporter,
             std::uint32_t& isn);

  /// Reads the next statement into `statement`. `fastLane` allows Kind::numbers.
  void next(StatementText& statement, bool fastLane);
  /// The next physical line as it stands, for decks inside the program; false at the end of the
  /// text.
  bool nextLine(std::string_view& line);
  [[nodiscard]] std::uint32_t offset() const { return static_cast<std::uint32_t>(position_); }

 private:
  struct Line {
    std::string_view text;
    std::size_t offset = 0;
  };
  /// How a card ended: with the statement, or with `$`, to be continued.
  enum class CardEnd : std::uint8_t { done, continued };

  /// The next line, however long; false at the end of the text.
  bool takeLine(Line& line);
  /// The same without lines beyond the limit, which are told.
  bool readLine(Line& line);
  bool readNumbers(const Line& first, StatementText& statement);
  bool openComment(Line& line, StatementText& statement);
  bool readFrame(Line& last, StatementText& statement);
  bool readFixed(const Line& line, StatementText& statement);
  void keepFixed(const Line& line, std::size_t wordBegin, Word word, StatementText& statement);
  CardEnd appendCard(const Line& line, StatementText& statement);
  std::size_t appendQuoted(std::string_view field,
                           std::size_t i,
                           std::size_t base,
                           StatementText& statement);
  void append(StatementText& statement, char c, std::size_t offset);
  void reportOther(const Line& line, std::size_t i, StatementText& statement);

  std::string_view text_;
  BufferId buffer_;
  const Options& options_;
  Reporter& reporter_;
  std::size_t position_ = 0;
  std::uint32_t& isn_;
  bool reportedOther_ = false;
};

}  // namespace arelem::frontend
