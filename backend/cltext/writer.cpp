#include "backend/cltext/writer.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "backend/cltext/statement.h"
#include "backend/text/clean.h"
#include "ir/cl/post_word.h"
#include "ir/diag/output.h"

namespace arelem::backend {

namespace {
constexpr std::size_t ringValues = 3;  // CUTTER / OPTION on a tape; a cutter has 1, 2 or 7

class TextWriter : public Writer {
 public:
  TextWriter(std::ostream& out, int decimals, DiagnosticSink& sink)
      : buffer_(out), line_(buffer_, decimals), sink_(sink) {}

  void accept(const cl::Record& record) override {
    record_ = &record;
    if (!std::holds_alternative<cl::Motion>(record.body)) {
      flushCircle();
    }
    std::visit(*this, record.body);
  }
  void finish() override {
    flushCircle();
    buffer_.finish();
  }

  void operator()(const cl::Motion& motion) {
    if (!writable(motion.coordinates)) {
      return;
    }
    if (motion.way == cl::Motion::Way::spline) {
      return;  // the last CNTRL has said it
    }
    if (motion.isArc()) {
      arc(motion.way == cl::Motion::Way::clockwise);
    } else {
      flushCircle();
    }
    const std::string_view word = motion.kind == cl::Motion::Kind::from ? "FROM" : "GOTO";
    const std::size_t stride = motion.stride();
    for (std::size_t i = 0; i + stride <= motion.coordinates.size(); i += stride) {
      line_.begin(word);
      for (std::size_t k = 0; k < stride; ++k) {
        line_.length(motion.coordinates[i + k]);
      }
      line_.end();
    }
  }
  void operator()(const cl::Post& post) {
    if (!std::all_of(post.arguments.begin(), post.arguments.end(),
                     [this](const auto& v) { return writable(v); })) {
      return;
    }
    const bool foreign = !post.foreign.empty();
    if (post.foreign == "CATIA0" && frame(post)) {
      return;
    }
    line_.begin(foreign ? statementText(post.foreign) : std::string(spell(post.word)),
                cl::isApplied(post));
    for (const cl::Value& value : post.arguments) {
      argument(value);
    }
    line_.end();
  }
  /// The text as it is, after `WORD / `; a blank less each side where that keeps it within the
  /// columns.
  void operator()(const cl::Text& body) {
    const std::string clean = restOfLine(body.text);
    std::string_view text = trimmed(clean);
    if (body.word != Word::INSERT && text.starts_with('/')) {
      text = trimmed(text.substr(1));  // `PARTNO / PLATE` in the source too: one slash is enough
    }
    buffer_.append(spell(body.word));
    if (!text.empty()) {
      const bool fits = spell(body.word).size() + 3 + text.size() <= StatementWriter::columns;
      buffer_.append(fits ? " / " : "/");
      buffer_.append(text);
    }
    buffer_.append('\n');
  }
  /// Whether it is an arc tells the location behind it.
  void operator()(const cl::Surface& body) { circle_ = body.surface; }
  void operator()(const cl::Switch& body) { bare(spell(body.word), true); }
  void operator()(const cl::Values& body) {
    line_.begin(spell(body.word));
    if (body.word == Word::CUTTER && body.values.size() == ringValues) {
      ring(body.values);
    } else {
      lengths(body.values);
    }
  }
  void operator()(const cl::Multax& body) { switched("MULTAX", body.on, false); }
  void operator()(const cl::Units& body) {
    line_.begin("UNITS");
    line_.text(spell(body.unit));
    line_.end();
  }
  void operator()(const cl::Diagnostic& body) {
    line_.begin("DIAGNOSTIC", true);
    line_.parameter(body.number);
    line_.end();
  }
  void operator()(const cl::Listing& body) { switched("CLPRNT", body.on, true); }
  void operator()(const cl::Fini&) { bare("FINI", false); }
  void operator()(const cl::Card&) {}
  void operator()(const cl::Raw& body) {
    line_.begin("RECORD", true);
    line_.parameter(body.type);
    line_.parameter(body.sub);
    for (const std::uint64_t word : body.words) {
      line_.text(fmt::format("{:016X}", word));
    }
    line_.end();
  }

 private:
  /// The frame of CATIA stands in comments: its name and three rows of four numbers.
  bool frame(const cl::Post& post) {
    constexpr std::size_t columns = 4;
    constexpr std::size_t values = 3 * columns + 1;
    const auto* name = post.arguments.size() == values
                           ? std::get_if<std::string>(&post.arguments.front())
                           : nullptr;
    if (name == nullptr) {
      return false;
    }
    std::string lines = fmt::format("$$*CATIA0\n$$ {}\n", statementText(*name));
    for (std::size_t i = 1; i < values; ++i) {
      const double* number = std::get_if<double>(&post.arguments[i]);
      if (number == nullptr) {
        return false;
      }
      lines += fmt::format("{} {}{}", i % columns == 1 ? "$$" : "", *number,
                           i % columns == 0 ? "\n" : "");
    }
    buffer_.append(lines);
    return true;
  }

  /// CUTTER / OPTION: the surface (1 part, 2 drive), radius and height of a ring, or 3: back to the
  /// cutter. Three values are always that.
  void ring(const std::vector<double>& values) {
    constexpr double back = 3.0;
    const bool off = values[0] == back;
    ringSurface_ = off ? ringSurface_ : values[0];
    line_.text(spell(Word::OPTION));
    line_.parameter(ringSurface_);
    if (off) {
      line_.text(spell(Word::OFF));
      line_.end();
    } else {
      lengths({values[1], values[2]});
    }
  }

  /// The surface that cut vectors run along is a comment.
  void flushCircle() {
    if (circle_) {
      line_.begin(spell(circle_->type), true);
      lengths(circle_->canon);
      circle_.reset();
    }
  }
  /// CIRCLE / x, y, z, i, j, k, r and the GOTO of the end: counter-clockwise about the axis.
  void arc(bool clockwise) {
    if (!circle_) {
      return;
    }
    std::vector<double> numbers = circle_->canon;
    for (std::size_t i = 3; clockwise && i < 6 && i < numbers.size(); ++i) {
      numbers[i] = numbers[i] == 0.0 ? 0.0 : -numbers[i];
    }
    line_.begin("CIRCLE");
    lengths(numbers);
    circle_.reset();
  }
  void bare(std::string_view word, bool comment) {
    line_.begin(word, comment);
    line_.end();
  }
  void switched(std::string_view word, bool on, bool comment) {
    line_.begin(word, comment);
    line_.text(on ? "ON" : "OFF");
    line_.end();
  }
  void lengths(const std::vector<double>& values) {
    for (const double value : values) {
      line_.length(isWritable(value) ? value : refuse(value));
    }
    line_.end();
  }
  void argument(const cl::Value& value) {
    if (const auto* number = std::get_if<double>(&value)) {
      line_.parameter(*number);
    } else if (const auto* word = std::get_if<Word>(&value)) {
      line_.text(spell(*word));
    } else if (const auto* text = std::get_if<std::string>(&value)) {
      line_.text(parameterText(*text));
    } else {
      surface(std::get<cl::SurfaceValue>(value));
    }
  }
  /// A nested definition, `(PLANE / 0, 0, 1, 0.1)`; a matrix as its twelve numbers.
  void surface(const cl::SurfaceValue& value) {
    if (value.type == EntityType::matrix) {
      for (const double number : value.canon) {
        line_.length(number);
      }
      return;
    }
    const bool plane = value.type == EntityType::plane;
    for (std::size_t i = 0; i < value.canon.size(); ++i) {
      std::array<char, numberRoom> digits{};
      const char* end = writeFixed(digits.data(), value.canon[i], shortest);
      std::string item(digits.data(), static_cast<std::size_t>(end - digits.data()));
      if (i == 0) {
        item = fmt::format("({} / {}{}", spell(value.type), plane ? "" : "CANON, ", item);
      }
      line_.text(i + 1 == value.canon.size() ? item + ")" : item);
    }
  }
  /// A word that the vocabulary does not know: what could end the parameter is taken out.
  static std::string parameterText(const std::string& text) {
    std::string clean = statementText(text);
    std::replace_if(
        clean.begin(), clean.end(), [](char c) { return c == ',' || c == '/'; }, ' ');
    return clean;
  }

  bool writable(const std::vector<double>& values) {
    for (const double value : values) {
      if (!isWritable(value)) {
        refuse(value);
        return false;
      }
    }
    return true;
  }
  bool writable(const cl::Value& value) {
    if (const auto* number = std::get_if<double>(&value)) {
      return isWritable(*number) || refuse(*number) != 0.0;
    }
    const auto* surface = std::get_if<cl::SurfaceValue>(&value);
    return surface == nullptr || writable(surface->canon);
  }
  /// Reports the first number that no text can hold; the statement it stands in is left out.
  double refuse(double value) {
    if (!refused_) {
      sink_.accept(diagnose(record_->origin, diag::OutputNumber, value, record_->isn));
      refused_ = true;
    }
    return 0.0;
  }

  OutBuffer buffer_;
  StatementWriter line_;
  DiagnosticSink& sink_;
  const cl::Record* record_ = nullptr;
  std::optional<cl::SurfaceValue> circle_;  ///< read and not written yet
  double ringSurface_ = 2.0;                ///< of the last CUTTER / OPTION
  bool refused_ = false;
};
}  // namespace

std::unique_ptr<Writer> makeTextWriter(std::ostream& out,
                                       const Context& context,
                                       DiagnosticSink& sink) {
  return std::make_unique<TextWriter>(out, context.decimals, sink);
}

}  // namespace arelem::backend
