#pragma once
#include <functional>
#include <istream>
#include <memory>
#include <string>

#include "app/cl_texts.h"
#include "app/pipeline.h"

/// Files of CL data in any format that can be read: text, CL tape, json.
namespace arelem::app {

enum class InputFormat : std::uint8_t { text, tape, json };

/// By the bytes: the header of a tape's first record holds small 32-bit numbers, so its first bytes
/// have zeros, and a text has none; JSON begins with a brace.
[[nodiscard]] InputFormat formatOf(std::string_view bytes);

/// An input that was opened and whose format is known. Tapes and JSON are read bit by bit.
class ClFile {
 public:
  [[nodiscard]] static Result<ClFile> open(const std::string& path, const Limits& limits);
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] InputFormat format() const { return format_; }
  [[nodiscard]] std::istream& stream() { return *in_; }
  /// All of it, where nothing was read yet.
  [[nodiscard]] Result<std::string> text();

 private:
  ClFile(std::string path, std::unique_ptr<std::istream> in, const Limits& limits)
      : path_(std::move(path)), limits_(limits), in_(std::move(in)) {}
  std::string path_;
  Limits limits_;
  std::unique_ptr<std::istream> in_;
  InputFormat format_ = InputFormat::text;
};

/// Hands the records of a file to `records`: those of CL text and part programs are computed, those
/// of a tape or JSON stand there. False after a fault, which is in the log of `job`.
[[nodiscard]] bool readRecords(Compilation& job,
                               ClFile& file,
                               cl::RecordSink& records,
                               const InterruptFlag& interrupted);

/// Makes a sink for the records of a reading that begins. It is called again where large CL text is
/// read at once after all: what went to the first sink is void then, and null ends the reading.
/// `texts` has the places of a reading in pieces, `job.sources` those of another one.
using BeginRecords = std::function<cl::RecordSink*(Compilation& job, const ClTexts* texts)>;

/// A file that was read: its job, with all messages in the log, and whether all went well.
struct ReadFile {
  std::unique_ptr<Compilation> job;
  bool whole = false;
};

/// Reads a file of any format in little memory: tapes, JSON by lines and, `inPieces`, large CL text
/// piece by piece.
[[nodiscard]] ReadFile readFile(const Settings& settings,
                                const std::string& path,
                                const BeginRecords& begin,
                                const InterruptFlag& interrupted,
                                bool inPieces = true);

}  // namespace arelem::app
