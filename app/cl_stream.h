#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/cl_texts.h"
#include "app/pipeline.h"

/// CL text piece by piece, so that its size does not matter: text, program, actions and records of
/// a piece are gone before the next. Only for statements whose meaning does not reach back or
/// forward (locations, arcs, post words, texts); the first definition, loop or error refuses, and
/// the file is to be read as any other program. Warnings are told as they would be then.
namespace arelem::app {

/// How a file is read: in pieces where it is worth it.
struct ClStreamRules {
  std::size_t piece = pieceSize;             ///< bytes of one
  std::uintmax_t smallest = 8U * pieceSize;  ///< smaller files are read at once
};

/// The dialect of a file that is to be read in pieces: a regular, large text.
[[nodiscard]] std::optional<frontend::Dialect> streamDialect(const std::string& path,
                                                             const Settings& settings,
                                                             const ClStreamRules& rules = {});

/// A compiled piece, with the actions of its statements.
struct ClPiece {
  BufferId buffer;
  std::string_view text;  ///< valid until two more pieces were opened
  ir::Program program;
  runtime::Evaluation evaluation;
  std::vector<Diagnostic>
      messages;  ///< told of it; of statements without effect the first of a kind
};

/// The pieces of one file up to Section 1. Texts go to `texts`, times to `job.seconds`, steps to
/// `job.evaluation`; at the end messages to `job.log` and, where there are any, the text to
/// `job.sources`.
class ClReading {
 public:
  ClReading(Compilation& job,
            ClTexts& texts,
            const std::string& path,
            frontend::Dialect dialect,
            const InterruptFlag& interrupted,
            const ClStreamRules& rules = {});
  ~ClReading();

  /// Takes the text of the next piece; false behind the last one.
  [[nodiscard]] bool open();
  /// Compiles it. None when the file must be read at once: nothing may be kept of what was read.
  [[nodiscard]] std::unique_ptr<ClPiece> read();
  /// Takes messages of the motion of a piece. False when the file must be read at once.
  [[nodiscard]] bool take(const std::vector<Diagnostic>& messages);
  /// Behind the last piece: hands all messages to the log. False as above.
  [[nodiscard]] bool finish();
  [[nodiscard]] std::size_t statements() const;

 private:
  class Reader;
  std::unique_ptr<Reader> reader_;
};

/// How a piecewise reading ended.
enum class Streamed : std::uint8_t {
  whole,    ///< everything went to the records
  refused,  ///< the text must be read at once: nothing may be kept of what was put out
};

/// What a piecewise reading goes to.
struct ClStreamEnd {
  cl::RecordSink& records;   ///< they may look at `texts`, and at nothing of the job
  CollectingSink& messages;  ///< of the records; those of the motion come in between
  ClTexts& texts;
  std::function<bool()> close = {};  ///< behind the last record; false refuses
  std::size_t statements = 0;
};

/// To the records. Sums go to `job.motion`, messages to `job.log`. The motion of a piece runs
/// beside the reading of the next one.
[[nodiscard]] Streamed streamCl(Compilation& job,
                                const std::string& path,
                                frontend::Dialect dialect,
                                ClStreamEnd& end,
                                const InterruptFlag& interrupted,
                                const ClStreamRules& rules = {});

}  // namespace arelem::app
