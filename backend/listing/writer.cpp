#include "backend/listing/writer.h"

#include <ostream>

#include <fmt/format.h>

#include "backend/cltape/numbering.h"
#include "backend/listing/records.h"
#include "backend/listing/source.h"
#include "backend/listing/values.h"
#include "backend/text/clean.h"

namespace arelem::backend {

namespace {
class ListingWriter : public Writer {
 public:
  ListingWriter(std::ostream& out, const Context& context) : out_(out), context_(context) {}

  void accept(const cl::Record& record) override {
    begin();
    if (numbering_.opensStatement(record)) {
      text_ = fmt::format("\n RECNO {:>6}   CARD {:<8}   ISN {:>5}\n", numbering_.last(),
                          printableAscii(record.cardId), record.isn);
    } else {
      text_.clear();
    }
    if (!std::holds_alternative<cl::Card>(record.body)) {
      numbering_.next();
    }
    appendRecordLines(text_, record.body);
    out_ << text_;
  }
  void finish() override {
    begin();
    out_.flush();
  }

 private:
  /// The parts before the records; the context is complete by the first of them.
  void begin() {
    if (begun_) {
      return;
    }
    begun_ = true;
    if (context_.sources != nullptr && context_.program != nullptr) {
      heading("PART PROGRAM");
      printSource(out_, *context_.sources, *context_.program);
    }
    if (!context_.printed.empty()) {
      heading("SECTION 1 RESULTS");
      printed();
    }
    heading("CL RECORDS");
  }
  void heading(std::string_view words) {
    out_ << (first_ ? "" : "\n") << " * * * " << words << " * * *\n";
    first_ = false;
  }
  void printed() {
    int isn = -1;
    for (const ListingItem& item : context_.printed) {
      text_.clear();
      if (item.isn != isn) {
        text_ = fmt::format("\n ISN {:>5}\n", item.isn);
        isn = item.isn;
      }
      appendPrinted(text_, item);
      out_ << text_;
    }
  }

  std::ostream& out_;
  const Context& context_;
  Numbering numbering_;
  std::string text_;
  bool begun_ = false;
  bool first_ = true;
};
}  // namespace

std::unique_ptr<Writer> makeListingWriter(std::ostream& out,
                                          const Context& context,
                                          DiagnosticSink&) {
  return std::make_unique<ListingWriter>(out, context);
}

}  // namespace arelem::backend
