#include "backend/cltape/reader.h"

#include "backend/cltape/decode.h"
#include "ir/diag/output.h"

namespace arelem::backend {

namespace {
/// Folds the 1000 records into the records behind them, as cl::Record wants it.
class Folder {
 public:
  explicit Folder(cl::RecordSink& next) : next_(next) {}

  void card(int isn, const tape::TapeRecord& raw) {
    flush();
    pending_ = true;
    card_.isn = isn;
    card_.cardId = raw.words.size() >= 2 ? tape::eightCharacters(raw.words[1]) : "";
  }
  void body(cl::Body body) {
    const bool again = any_ && card_.isn == record_.isn && card_.cardId == record_.cardId;
    if (pending_ && again) {
      flush();
    }
    pending_ = false;
    any_ = true;
    record_.isn = card_.isn;
    record_.cardId = card_.cardId;
    record_.body = std::move(body);
    next_.accept(record_);
  }
  /// Hands on a 1000 record that has no records of its own.
  void flush() {
    if (pending_) {
      pending_ = false;
      any_ = true;
      record_.isn = card_.isn;
      record_.cardId = card_.cardId;
      record_.body = cl::Card{};
      next_.accept(record_);
    }
  }

 private:
  cl::RecordSink& next_;
  cl::Record record_;  ///< the last one handed on
  cl::Record card_;    ///< isn and card of the last 1000 record
  bool pending_ = false;
  bool any_ = false;
};
}  // namespace

TapeSummary readTape(std::istream& in,
                     cl::RecordSink& records,
                     DiagnosticSink& sink,
                     const Limits& limits,
                     const tape::Codes& codes) {
  tape::Scanner scanner(in, sink, limits);
  tape::DecodeState state;
  state.codes = codes;
  Folder folder(records);
  while (const tape::TapeRecord* raw = scanner.next()) {
    if (raw->type == 1000) {
      folder.card(raw->sub, *raw);
      continue;
    }
    tape::Decoded decoded = tape::decode(raw->type, raw->sub, raw->words, state);
    if (!decoded.fault.empty()) {
      scanner.report(diag::TapeRecordKept, raw->number, raw->offset, raw->type, raw->sub,
                     decoded.fault);
    } else if (std::holds_alternative<cl::Raw>(decoded.body)) {
      scanner.report(diag::TapeClass, raw->number, raw->offset, raw->type, raw->sub);
    }
    folder.body(std::move(decoded.body));
  }
  folder.flush();
  scanner.summary();
  return {scanner.records(), scanner.complete()};
}

}  // namespace arelem::backend
