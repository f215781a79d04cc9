#include "backend/cltape/dump.h"

#include <array>
#include <ostream>

#include <fmt/format.h>

#include "backend/cltape/decode.h"
#include "backend/text/clean.h"
#include "backend/text/number.h"
#include "ir/cl/post_word.h"

namespace arelem::backend {

namespace {
/// Appends the meaning of a record to a line.
class Describer {
 public:
  explicit Describer(std::string& line) : line_(line) {}

  void operator()(const cl::Post& post) {
    line_ += printableAscii(cl::nameOf(post));
    for (const cl::Value& value : post.arguments) {
      line_ += &value == post.arguments.data() ? " / " : ", ";
      argument(value);
    }
  }
  void operator()(const cl::Text& body) {
    line_ += fmt::format("{} \"{}\"", spell(body.word), printableAscii(body.text));
  }
  void operator()(const cl::Surface& body) {
    constexpr std::array<std::string_view, 4> roles = {"part", "drive", "check", "PSIS"};
    const bool known = body.role >= 1 && body.role <= static_cast<int>(roles.size());
    line_ += fmt::format("{} surface ",
                         known ? roles[static_cast<std::size_t>(body.role - 1)] : "other");
    surface(body.surface);
  }
  void operator()(const cl::Motion& motion) {
    constexpr std::array<std::string_view, 4> words = {"FROM", "", "GOTO", "CONT"};
    line_ += motion.way == cl::Motion::Way::spline      ? "SPLINE"
             : motion.way == cl::Motion::Way::clockwise ? "ARC CLW"
             : motion.isArc()                           ? "ARC CCLW"
                              : words[static_cast<std::size_t>(motion.kind) - 3];
    name(motion.name, motion.subscript);
    for (std::size_t i = 0; i < motion.coordinates.size(); ++i) {
      line_ += i % motion.stride() == 0 ? (i == 0 ? "  " : "; ") : " ";
      number(motion.coordinates[i]);
    }
  }
  void operator()(const cl::Switch& body) { line_ += spell(body.word); }
  void operator()(const cl::Values& body) {
    line_ += spell(body.word);
    line_ += " /";
    numbers(body.values);
  }
  void operator()(const cl::Multax& body) { line_ += body.on ? "MULTAX / ON" : "MULTAX / OFF"; }
  void operator()(const cl::Units& body) { line_ += fmt::format("UNITS / {}", spell(body.unit)); }
  void operator()(const cl::Diagnostic& body) {
    line_ += fmt::format("motion diagnostic {}", body.number);
  }
  void operator()(const cl::Listing& body) { line_ += body.on ? "CLPRNT / ON" : "CLPRNT / OFF"; }
  void operator()(const cl::Fini&) { line_ += "FINI"; }
  void operator()(const cl::Card&) {}
  void operator()(const cl::Raw& body) {
    line_ += "raw";
    for (const std::uint64_t word : body.words) {
      line_ += fmt::format(" {:016x}", word);
    }
  }

 private:
  void name(const std::string& text, int subscript) {
    if (!text.empty()) {
      line_ += ' ';
      line_ += printableAscii(text);
    }
    if (subscript != 0) {
      line_ += fmt::format("({})", subscript);
    }
  }
  void number(double value) { appendJsonNumber(line_, value); }
  void numbers(const std::vector<double>& values) {
    for (const double value : values) {
      line_ += ' ';
      number(value);
    }
  }
  void surface(const cl::SurfaceValue& value) {
    line_ += spell(value.type);
    name(value.name, value.subscript);
    numbers(value.canon);
  }
  void argument(const cl::Value& value) {
    if (const auto* real = std::get_if<double>(&value)) {
      number(*real);
    } else if (const auto* word = std::get_if<Word>(&value)) {
      line_ += spell(*word);
    } else if (const auto* text = std::get_if<std::string>(&value)) {
      line_ += fmt::format("\"{}\"", printableAscii(*text));
    } else {
      surface(std::get<cl::SurfaceValue>(value));
    }
  }

  std::string& line_;
};
}  // namespace

TapeSummary dump(std::istream& in,
                 std::ostream& out,
                 DiagnosticSink& sink,
                 const Limits& limits,
                 const tape::Codes& codes) {
  tape::Scanner scanner(in, sink, limits);
  tape::DecodeState state;
  state.codes = codes;
  std::string line = "  record     offset  class        words  meaning\n";
  while (const tape::TapeRecord* raw = scanner.next()) {
    line += fmt::format("{:>8} {:>10}  {:>5}/{:<6} {:>5}  ", raw->number, raw->offset, raw->type,
                        raw->sub, raw->words.size());
    if (raw->type == 1000) {
      const std::string card =
          raw->words.size() > 1 ? printableAscii(tape::eightCharacters(raw->words[1])) : "";
      line += fmt::format("statement {}{}{}", raw->sub, card.empty() ? "" : ", card ", card);
    } else {
      const tape::Decoded decoded = tape::decode(raw->type, raw->sub, raw->words, state);
      std::visit(Describer(line), decoded.body);
      line += decoded.fault.empty() ? "" : fmt::format("  ({})", decoded.fault);
    }
    line += '\n';
    out << line;
    line.clear();
  }
  out << line;
  scanner.summary();
  return {scanner.records(), scanner.complete()};
}

}  // namespace arelem::backend
