#pragma once
#include <cstdint>
#include <iosfwd>
#include <map>
#include <optional>
#include <type_traits>
#include <vector>

#include "backend/cltape/codes.h"
#include "backend/cltape/word.h"
#include "ir/cl/record.h"
#include "ir/diag/diagnostic.h"
#include "ir/limits.h"

namespace arelem::backend {

namespace tape {

/// One record as its bytes say.
struct TapeRecord {
  std::uint64_t offset = 0;  ///< of its header, in bytes
  int number = 0;
  int type = 0;
  int sub = 0;
  std::vector<TapeWord> words;
};

/// Cuts a tape into records. It trusts no count: words are taken as far as they are there, a header
/// that no tape can hold ends the reading. Stops behind FINI (14000).
class Scanner {
 public:
  Scanner(std::istream& in, DiagnosticSink& sink, const Limits& limits);

  /// The next record, valid until the next call; nullptr at the end.
  [[nodiscard]] const TapeRecord* next();
  /// True after FINI, false after a fault or a tape that just ends.
  [[nodiscard]] bool complete() const { return complete_; }
  [[nodiscard]] std::uint64_t records() const { return records_; }

  /// Reports at most twenty of a kind; `summary` tells how many more there were.
  template <class... Args>
  void report(const DiagKind<Args...>& kind, const std::type_identity_t<Args>&... args) {
    if (++reported_[kind.row->code] <= reportsOfAKind) {
      sink_.accept(diagnose(Span{}, kind, args...));
    }
  }
  void summary();

 private:
  static constexpr std::uint64_t reportsOfAKind = 20;
  bool readHeader();
  bool readWords(std::uint32_t count);
  std::size_t readBytes(char* place, std::size_t count);
  /// Behind FINI stands the byte that ends a tape; what else is there is told and not read.
  void checkEnd();
  void stop();

  std::istream& in_;
  DiagnosticSink& sink_;
  Limits limits_;
  TapeRecord record_;
  std::map<std::string_view, std::uint64_t> reported_;
  std::uint64_t offset_ = 0;
  std::uint64_t records_ = 0;
  bool ended_ = false;
  bool complete_ = false;
};

/// Most words of one record: far more than any writer uses, and small enough to allocate.
inline constexpr std::uint32_t wordsOfARecord = 1U << 20U;

}  // namespace tape

struct TapeSummary {
  std::uint64_t records = 0;  ///< 1000 records too
  bool complete = false;      ///< FINI was reached
};

/// Reads a CLTAPE into records. Faults are diagnosed with record number and byte offset; records of
/// unknown classes, and known ones whose words do not fit, are handed on as cl::Raw. Writing the
/// records again gives the same bytes for every tape that numbers its records 1, 2, 3, ... and pads
/// text with blanks.
TapeSummary readTape(std::istream& in,
                     cl::RecordSink& records,
                     DiagnosticSink& sink,
                     const Limits& limits = {},
                 const tape::Codes& codes = {});

}  // namespace arelem::backend
