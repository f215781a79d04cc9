#include "backend/listing/records.h"

#include <array>
#include <span>

#include <fmt/format.h>

#include "backend/listing/columns.h"
#include "backend/text/clean.h"
#include "ir/cl/post_word.h"

namespace arelem::backend {

namespace {
constexpr int pointWidth = 15;
constexpr int pointDecimals = 7;
constexpr int valueWidth = 12;
constexpr int toleranceDecimals = 6;
constexpr int parameterDecimals = 4;
constexpr std::size_t valuesOfALine = 6;

class RecordLines {
 public:
  explicit RecordLines(std::string& text) : text_(text) {}

  void operator()(const cl::Post& post) {
    indent(printableAscii(cl::nameOf(post)));
    if (!post.arguments.empty()) {
      text_ += '/';
    }
    for (const cl::Value& value : post.arguments) {
      parameter(value);
    }
    text_ += '\n';
  }
  void operator()(const cl::Text& body) {
    indent(spell(body.word));
    text_ += trimmedRight(printableAscii(body.text));
    text_ += '\n';
  }
  void operator()(const cl::Surface& body) {
    constexpr std::array<std::string_view, 5> roles = {"PS", "DS", "CS", "PSIS", "REGPS"};
    const bool known = body.role >= 1 && body.role <= static_cast<int>(roles.size());
    text_ +=
        fmt::format(" SURFACE DATA - {} ( {} ) ** {} **\n CANON FORM\n", spell(body.surface.type),
                    known ? roles[static_cast<std::size_t>(body.role - 1)] : "?",
                    named(body.surface.name, body.surface.subscript));
    rows(body.surface.canon, valuesOfALine, pointWidth, pointDecimals);
  }
  void operator()(const cl::Motion& motion) {
    text_ += fmt::format(" *** {}/ {}\n", motion.kind == cl::Motion::Kind::from ? "FROM" : "GO---",
                         named(motion.name, motion.subscript));
    rows(motion.coordinates, motion.stride(), pointWidth, pointDecimals);
  }
  void operator()(const cl::Switch& body) { line(spell(body.word)); }
  void operator()(const cl::Values& body) {
    indent(spell(body.word));
    text_ += '/';
    for (const double value : body.values) {
      appendColumn(text_, value, valueWidth, toleranceDecimals);
    }
    text_ += '\n';
  }
  void operator()(const cl::Multax& body) { line(body.on ? "MULTAX/ ON" : "MULTAX/ OFF"); }
  void operator()(const cl::Units& body) { line(fmt::format("UNITS/ {}", spell(body.unit))); }
  void operator()(const cl::Diagnostic& body) {
    text_ += fmt::format(" *** {} {}\n", body.number < 0 ? "WARNING" : "ERROR", body.number);
  }
  void operator()(const cl::Listing& body) { line(body.on ? "CLPRNT/ ON" : "CLPRNT/ OFF"); }
  void operator()(const cl::Fini&) { text_ += " ** FINI **\n"; }
  void operator()(const cl::Card&) {}
  void operator()(const cl::Raw& body) {
    text_ += fmt::format(" CLASS {} / {}\n", body.type, body.sub);
    for (std::size_t i = 0; i < body.words.size(); ++i) {
      text_ += fmt::format("  {:016X}{}", body.words[i],
                           i % 4 == 3 || i + 1 == body.words.size() ? "\n" : "");
    }
  }

 private:
  static std::string named(const std::string& name, int subscript) {
    return fmt::format("{:>6} ({:>4})", printableAscii(name), subscript);
  }
  void indent(std::string_view word) { text_ += fmt::format(" {:<6}", word); }
  void line(std::string_view words) { text_ += fmt::format(" {}\n", words); }
  void rows(std::span<const double> values, std::size_t columns, int width, int decimals) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      appendColumn(text_, values[i], width, decimals);
      if ((i + 1) % columns == 0 || i + 1 == values.size()) {
        text_ += '\n';
      }
    }
  }
  void parameter(const cl::Value& value) {
    if (const auto* number = std::get_if<double>(&value)) {
      appendColumn(text_, *number, valueWidth, parameterDecimals);
    } else if (const auto* word = std::get_if<Word>(&value)) {
      text_ += fmt::format("  {:>6}", spell(*word));
    } else if (const auto* string = std::get_if<std::string>(&value)) {
      text_ += fmt::format("  {:>6}", printableAscii(*string));
    } else {
      surface(std::get<cl::SurfaceValue>(value));
    }
  }
  void surface(const cl::SurfaceValue& value) {
    text_ += fmt::format("  {} {}", spell(value.type), named(value.name, value.subscript));
    for (const double number : value.canon) {
      appendColumn(text_, number, valueWidth, parameterDecimals);
    }
  }

  std::string& text_;
};
}  // namespace

void appendRecordLines(std::string& text, const cl::Body& body) {
  std::visit(RecordLines(text), body);
}

}  // namespace arelem::backend
