#include "backend/json/writer.h"

#include <algorithm>

#include <fmt/format.h>

#include "backend/cltape/encode.h"
#include "backend/cltape/numbering.h"
#include "backend/text/clean.h"
#include "backend/text/number.h"
#include "backend/text/out_buffer.h"

namespace arelem::backend {

namespace {
std::string_view roleName(int role) {
  switch (role) {
    case 1:
      return "PS";
    case 3:
      return "CS";
    case 4:
      return "PSIS";
    case 5:
      return "REGPS";
    default:
      return "DS";
  }
}

std::string_view wayName(cl::Motion::Way way) {
  return way == cl::Motion::Way::spline      ? "SPLINE"
         : way == cl::Motion::Way::clockwise ? "CLW"
                                             : "CCLW";
}

/// Appends the fields that follow `kind`, each with a comma before it.
class FieldWriter {
 public:
  explicit FieldWriter(std::string& line) : line_(line) {}

  void operator()(const cl::Post& post) {
    kind("POST");
    const bool foreign = !post.foreign.empty();
    text("word", foreign ? std::string_view(post.foreign) : spell(post.word));
    if (post.arguments.empty() || copies(post) || transforms(post)) {
      return;
    }
    key("args");
    line_ += '[';
    for (const cl::Value& value : post.arguments) {
      argument(value);
    }
    close(']');
  }
  void operator()(const cl::Text& body) {
    kind("POST");
    text("word", spell(body.word));
    text("text", trimmedRight(body.text));
  }
  void operator()(const cl::Surface& body) {
    kind("SURFACE");
    text("role", roleName(body.role));
    integer("condition", body.condition);
    text("surf", spell(body.surface.type));
    integer("len", static_cast<int>(body.surface.canon.size() + 2));
    named(body.surface.name, "subscript", body.surface.subscript);
    numbers("canon", body.surface.canon);
  }
  void operator()(const cl::Motion& motion) {
    const bool from = motion.kind == cl::Motion::Kind::from;
    kind(from ? "FROM" : motion.kind == cl::Motion::Kind::go ? "GOTO" : "CONT");
    named(motion.name, "subscript", motion.subscript);
    if (motion.way != cl::Motion::Way::straight) {
      text("way", wayName(motion.way));
    }
    key("points");
    line_ += '[';
    const std::size_t stride = motion.stride();
    for (std::size_t i = 0; i + stride <= motion.coordinates.size(); i += stride) {
      list({motion.coordinates.data() + i, stride});
      line_ += ", ";
    }
    close(']');
  }
  void operator()(const cl::Switch& body) { kind(spell(body.word)); }
  void operator()(const cl::Values& body) {
    kind(spell(body.word));
    numbers("values", body.values);
  }
  void operator()(const cl::Multax& body) {
    kind("MULTAX");
    key("on");
    line_ += body.on ? "true" : "false";
  }
  void operator()(const cl::Units& body) {
    kind("UNITS");
    text("unit", spell(body.unit));
  }
  void operator()(const cl::Diagnostic& body) {
    kind("ARELEM-DIAG");
    integer("number", body.number);
    text("severity", body.number < 0 ? "warning" : "failure");
  }
  void operator()(const cl::Listing& body) {
    kind("CLPRNT");
    integer("value", body.on ? 1 : 0);
  }
  void operator()(const cl::Fini&) { kind("FINI"); }
  void operator()(const cl::Card&) { kind("CARD"); }
  void operator()(const cl::Raw& body) {
    kind("RAW");
    key("words");
    line_ += '[';
    for (const std::uint64_t word : body.words) {
      line_ += fmt::format("\"{:016x}\", ", word);
    }
    close(']');
  }

 private:
  /// Every field but the first of an object has a comma before it.
  void key(std::string_view name) {
    line_ += line_.ends_with('{') ? "\"" : ", \"";
    line_ += name;
    line_ += "\": ";
  }
  void kind(std::string_view name) { text("kind", name); }
  void text(std::string_view name, std::string_view value) {
    key(name);
    appendJsonString(line_, value);
  }
  void integer(std::string_view name, int value) {
    key(name);
    line_ += fmt::format_int(value).c_str();
  }
  void named(const std::string& name, std::string_view subscriptKey, int subscript) {
    if (name.empty()) {
      key("name");
      line_ += "null";
    } else {
      text("name", name);
    }
    integer(subscriptKey, subscript);
  }
  void list(std::span<const double> values) {
    line_ += '[';
    for (const double value : values) {
      appendJsonNumber(line_, value);
      line_ += ", ";
    }
    close(']');
  }
  void numbers(std::string_view name, const std::vector<double>& values) {
    key(name);
    list(values);
  }
  /// Ends a list whose every element was followed by ", ".
  void close(char bracket) {
    if (line_.ends_with(", ")) {
      line_.resize(line_.size() - 2);
    }
    line_ += bracket;
  }
  void argument(const cl::Value& value) {
    if (const auto* number = std::get_if<double>(&value)) {
      appendJsonNumber(line_, *number);
    } else if (const auto* word = std::get_if<Word>(&value)) {
      appendJsonString(line_, spell(*word));
    } else if (const auto* string = std::get_if<std::string>(&value)) {
      appendJsonString(line_, *string);
    } else {
      surface(std::get<cl::SurfaceValue>(value));
    }
    line_ += ", ";
  }
  /// A surface among parameters: name (0 when unnamed), subscript, canonical numbers, as on the
  /// tape.
  void surface(const cl::SurfaceValue& value) {
    if (value.name.empty()) {
      line_ += "0.0";
    } else {
      appendJsonString(line_, value.name);
    }
    line_ += ", ";
    appendJsonNumber(line_, value.subscript);
    for (const double number : value.canon) {
      line_ += ", ";
      appendJsonNumber(line_, number);
    }
  }
  /// TRACUT/matrix and TRANS/matrix.
  bool transforms(const cl::Post& post) {
    const auto* matrix = std::get_if<cl::SurfaceValue>(&post.arguments.front());
    if (post.arguments.size() != 1 || matrix == nullptr || matrix->type != EntityType::matrix) {
      return false;
    }
    key("matrix");
    line_ += '{';
    named(matrix->name, "sub", matrix->subscript);
    numbers("m", matrix->canon);
    line_ += '}';
    return true;
  }
  /// COPY/n,MODIFY,matrix,count.
  bool copies(const cl::Post& post) {
    if (post.arguments.size() != 4) {
      return false;
    }
    const auto* number = std::get_if<double>(&post.arguments[0]);
    const auto* mode = std::get_if<Word>(&post.arguments[1]);
    const auto* matrix = std::get_if<cl::SurfaceValue>(&post.arguments[2]);
    const auto* count = std::get_if<double>(&post.arguments[3]);
    if (number == nullptr || mode == nullptr || matrix == nullptr || count == nullptr) {
      return false;
    }
    key("copy");
    line_ += '{';
    numberField("n", *number);
    text("mode", spell(*mode));
    named(matrix->name, "sub", matrix->subscript);
    numbers("m", matrix->canon);
    numberField("count", *count);
    line_ += '}';
    return true;
  }
  void numberField(std::string_view name, double value) {
    key(name);
    appendJsonNumber(line_, value);
  }

  std::string& line_;
};

class JsonWriter : public Writer {
 public:
  explicit JsonWriter(std::ostream& out) : out_(out) {}

  void accept(const cl::Record& record) override {
    numbering_.opensStatement(record);
    if (std::holds_alternative<cl::Card>(record.body)) {
      return;
    }
    const auto [type, sub] = cl::typeCode(record.body);
    line_.clear();
    fmt::format_to(std::back_inserter(line_), R"({{"rec": {}, "type": {}, "sub": {}, "isn": {})",
                   numbering_.next(), type, sub, record.isn);
    std::visit(FieldWriter(line_), record.body);
    line_ += "}\n";
    out_.append(line_);
  }

  void finish() override { out_.finish(); }

 private:
  OutBuffer out_;
  Numbering numbering_;
  std::string line_;
};
}  // namespace

std::unique_ptr<Writer> makeJsonWriter(std::ostream& out, const Context&, DiagnosticSink&) {
  return std::make_unique<JsonWriter>(out);
}

}  // namespace arelem::backend
