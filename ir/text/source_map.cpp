#include "ir/text/source_map.h"

#include <algorithm>

namespace arelem {

BufferId SourceMap::add(std::string name, std::string text) {
  buffers_.push_back({std::move(name), std::move(text), {}});
  return {static_cast<std::uint32_t>(buffers_.size() - 1)};
}

std::string_view SourceMap::name(BufferId buffer) const {
  return buffers_.at(buffer.index).name;
}

std::string_view SourceMap::text(BufferId buffer) const {
  return buffers_.at(buffer.index).text;
}

std::string_view SourceMap::text(const Span& span) const {
  const std::string_view whole = text(span.buffer);
  if (span.begin > whole.size()) {
    return {};
  }
  return whole.substr(span.begin, span.length);
}

const std::vector<std::uint32_t>& SourceMap::lineStarts(const Buffer& buffer) const {
  if (buffer.lineStarts.empty()) {
    buffer.lineStarts.push_back(0);
    const std::string_view text = buffer.text;
    for (std::size_t i = 0; i < text.size(); ++i) {
      const bool loneReturn = text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n');
      if (text[i] == '\n' || loneReturn) {
        buffer.lineStarts.push_back(static_cast<std::uint32_t>(i + 1));
      }
    }
  }
  return buffer.lineStarts;
}

LineColumn SourceMap::locate(BufferId id, std::uint32_t offset) const {
  const Buffer& buffer = buffers_.at(id.index);
  const auto& starts = lineStarts(buffer);
  const auto next = std::upper_bound(starts.begin(), starts.end(), offset);
  const auto line = static_cast<std::uint32_t>(next - starts.begin());
  const std::uint32_t start = *(next - 1);
  std::uint32_t column = 1;
  const std::size_t end = std::min<std::size_t>(offset, buffer.text.size());
  for (std::size_t i = start; i < end; ++i) {
    const bool continuationByte = (static_cast<unsigned char>(buffer.text[i]) & 0xC0U) == 0x80U;
    column += continuationByte ? 0U : 1U;
  }
  return {line, column};
}

std::string_view SourceMap::line(BufferId id, std::uint32_t line) const {
  const Buffer& buffer = buffers_.at(id.index);
  const auto& starts = lineStarts(buffer);
  if (line == 0 || line > starts.size()) {
    return {};
  }
  const std::size_t begin = starts[line - 1];
  std::size_t end = line < starts.size() ? starts[line] : buffer.text.size();
  while (end > begin && (buffer.text[end - 1] == '\n' || buffer.text[end - 1] == '\r')) {
    --end;
  }
  return std::string_view(buffer.text).substr(begin, end - begin);
}

}  // namespace arelem
