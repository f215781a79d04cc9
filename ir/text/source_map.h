#pragma once
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "ir/text/span.h"

namespace arelem {

/// Line and column, both counted from 1; a column is a Unicode code point, tabs count as one.
struct LineColumn {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
};

/// Owns every source text of a run and turns offsets into places.
/// Texts never move once added, so string_views into them stay valid.
class SourceMap {
 public:
  BufferId add(std::string name, std::string text);

  [[nodiscard]] std::string_view name(BufferId buffer) const;
  [[nodiscard]] std::string_view text(BufferId buffer) const;
  [[nodiscard]] std::string_view text(const Span& span) const;
  [[nodiscard]] LineColumn locate(BufferId buffer, std::uint32_t offset) const;
  /// The text of one line (counted from 1) without its line end.
  [[nodiscard]] std::string_view line(BufferId buffer, std::uint32_t line) const;
  [[nodiscard]] std::size_t size() const { return buffers_.size(); }

 private:
  struct Buffer {
    std::string name;
    std::string text;
    mutable std::vector<std::uint32_t> lineStarts;  // filled on first use
  };
  [[nodiscard]] const std::vector<std::uint32_t>& lineStarts(const Buffer& buffer) const;
  std::deque<Buffer> buffers_;
};

}  // namespace arelem
