#include "runtime/region/drawing_pairs.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "ir/diag/spray.h"

namespace arelem::region {

namespace {
std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && blank(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

std::string_view takeLine(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return trimmed(line);
}
}  // namespace

std::string_view DrawingObject::text(int code, std::string_view otherwise) const {
  for (const Group& group : groups) {
    if (group.code == code) {
      return group.value;
    }
  }
  return otherwise;
}

Result<std::vector<Group>> groupsOf(std::string_view text, std::string_view name) {
  if (text.starts_with("AutoCAD Binary DXF")) {
    return fail(diag::DrawingSyntax, name, std::size_t{1},
                "a binary DXF file; write it as ASCII DXF");
  }
  std::vector<Group> groups;
  std::size_t line = 1;
  while (!trimmed(text).empty()) {
    const std::string_view codeText = takeLine(text);
    int code = 0;
    const auto [end, error] =
        std::from_chars(codeText.data(), codeText.data() + codeText.size(), code);
    if (error != std::errc() || end != codeText.data() + codeText.size()) {
      return fail(diag::DrawingSyntax, name, line,
                  fmt::format("`{}` where a group code belongs", codeText.substr(0, 40)));
    }
    if (text.empty()) {
      return fail(diag::DrawingSyntax, name, line, "the group code has no value behind it");
    }
    groups.push_back({code, takeLine(text), line});
    line += 2;
    if (code == 0 && groups.back().value == "EOF") {
      return groups;
    }
  }
  return fail(diag::DrawingSyntax, name, line, "the file ends without EOF: it is cut off");
}

Result<double> numberOf(const Group& group, std::string_view name) {
  std::string_view text = group.value;
  if (text.starts_with('+')) {
    text.remove_prefix(1);
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    return fail(
        diag::DrawingSyntax, name, group.line + 1,
        fmt::format("`{}` where a number belongs (group {})", text.substr(0, 40), group.code));
  }
  return value;
}

long wholeOf(double value) {
  constexpr double most = 1e9;
  return static_cast<long>(std::clamp(value, -most, most));
}

}  // namespace arelem::region
