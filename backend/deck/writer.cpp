#include "backend/deck/writer.h"

#include <ostream>

namespace arelem::backend {

namespace {
class DeckWriter : public Writer {
 public:
  DeckWriter(std::ostream& out, const Context& context) : out_(out), context_(context) {}

  void accept(const cl::Record& /*record*/) override {}
  void finish() override {
    out_ << context_.deck;
    out_.flush();
  }

 private:
  std::ostream& out_;
  const Context& context_;
};
}  // namespace

std::unique_ptr<Writer> makeDeckWriter(std::ostream& out,
                                       const Context& context,
                                       DiagnosticSink& /*sink*/) {
  return std::make_unique<DeckWriter>(out, context);
}

}  // namespace arelem::backend
