#include "ir/diag/render_json.h"

#include <ostream>

#include "ir/diag/display_text.h"
#include "ir/diag/render_text.h"

namespace arelem {

namespace {
std::size_t utf16Units(std::string_view text) {
  std::size_t units = 0;
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint c = decodeUtf8(text, at);
    units += c.value > 0xFFFF ? 2 : 1;
    at += c.length == 0 ? 1 : c.length;
  }
  return units;
}

std::string position(BufferId buffer, std::uint32_t offset, const SourceMap& sources) {
  const LineColumn place = sources.locate(buffer, offset);
  const std::string_view line = sources.line(buffer, place.line);
  const auto start = static_cast<std::size_t>(line.data() - sources.text(buffer).data());
  return fmt::format(R"({{"line":{},"column":{},"byte":{},"utf16":{}}})", place.line, place.column,
                     offset, utf16Units(line.substr(0, offset - start)));
}

/// `"file":...,"range":...` of a span; both null where there is no place.
std::string place(const Span& span, const SourceMap& sources) {
  if (span.buffer.index >= sources.size()) {
    return R"("file":null,"range":null)";
  }
  return fmt::format(
      R"("file":{},"range":{{"start":{},"end":{}}})", jsonString(sources.name(span.buffer)),
      position(span.buffer, span.begin, sources), position(span.buffer, span.end(), sources));
}

std::string_view word(Severity severity) {
  return severity == Severity::error ? "error" : severity == Severity::warning ? "warning" : "note";
}

template <class Range, class Print>
std::string jsonArray(const Range& range, const Print& print) {
  std::string out = "[";
  for (const auto& item : range) {
    out += (out.size() > 1 ? "," : "") + print(item);
  }
  return out + "]";
}
}  // namespace

std::string jsonString(std::string_view text) {
  std::string out = "\"";
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint c = decodeUtf8(text, at);
    if (c.length == 0) {
      out += "\\ufffd";
    } else if (c.value == '"' || c.value == '\\') {
      out += '\\';
      out += static_cast<char>(c.value);
    } else if (c.value < 0x20 || c.value == 0x7F) {
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c.value));
    } else {
      out += text.substr(at, c.length);
    }
    at += c.length == 0 ? 1 : c.length;
  }
  return out + "\"";
}

void renderJson(std::ostream& out, const Diagnostic& d, const SourceMap& sources) {
  const auto related = [&](const Label& label) {
    return fmt::format(R"({{{},"message":{}}})", place(label.span, sources),
                       jsonString(label.text));
  };
  const auto call = [&](const Span& span) { return "{" + place(span, sources) + "}"; };
  const DiagRow& row = d.kind();
  out << fmt::format(R"({{"severity":"{}","code":"{}","legacy":{},{},"message":{},)",
                     word(row.severity), row.code,
                     row.legacy.empty() ? "null" : jsonString(row.legacy), place(d.at, sources),
                     jsonString(d.message))
      << fmt::format(R"("related":{},"calledFrom":{},"notes":{},"help":{},"fixes":[]}})",
                     jsonArray(d.labels, related), jsonArray(d.calledFrom, call),
                     jsonArray(d.notes, jsonString), d.help.empty() ? "null" : jsonString(d.help))
      << '\n';
}

}  // namespace arelem
