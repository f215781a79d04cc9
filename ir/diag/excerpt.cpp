#include "ir/diag/excerpt.h"

#include <algorithm>

#include "ir/diag/display_text.h"

namespace arelem {

namespace {
// Bytes looked at on either side of the place; 16 columns of margin need at most 4 bytes each.
constexpr std::size_t reach = 1024;

struct Columns {
  std::size_t begin = 0, end = 0;
};

const Mark& focusOf(const std::vector<Mark>& marks) {
  const auto primary =
      std::find_if(marks.begin(), marks.end(), [](const Mark& m) { return m.primary; });
  return primary == marks.end() ? marks.front() : *primary;
}

bool continuationByte(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// The bytes of the line worth decoding.
Columns bytesNear(std::string_view line, const Mark& focus) {
  const std::size_t place = std::min<std::size_t>(focus.begin, line.size());
  Columns part{place > reach ? place - reach : 0, std::min(line.size(), place + reach)};
  while (part.begin > 0 && part.begin < line.size() && continuationByte(line[part.begin])) {
    --part.begin;
  }
  while (part.end < line.size() && continuationByte(line[part.end])) {
    ++part.end;
  }
  return part;
}

/// The cells with the column in which each begins; the last entry of `starts` is the total width.
struct Layout {
  std::vector<Cell> cells;
  std::vector<std::size_t> starts;

  explicit Layout(std::string_view text) : cells(displayCells(text)), starts{0} {
    for (const Cell& cell : cells) {
      starts.push_back(starts.back() + cell.width);
    }
  }
  [[nodiscard]] std::size_t columnOfByte(std::size_t byte) const {
    const auto after =
        std::find_if(cells.begin(), cells.end(), [&](const Cell& c) { return c.end > byte; });
    return starts[static_cast<std::size_t>(after - cells.begin())];
  }
  [[nodiscard]] std::size_t width() const { return starts.back(); }
};

Columns columnsOf(const Layout& layout, const Mark& mark, std::size_t firstByte) {
  const auto local = [&](std::uint32_t byte) { return byte > firstByte ? byte - firstByte : 0; };
  Columns c{layout.columnOfByte(local(mark.begin)), 0};
  c.end = mark.end > mark.begin ? layout.columnOfByte(local(mark.end)) : c.begin;
  c.end = std::max(c.end, c.begin + 1);
  return c;
}

Columns windowFor(const Layout& layout, const Columns& focus, std::size_t width) {
  if (layout.width() <= width) {
    return {0, layout.width()};
  }
  const std::size_t lead = width / 3;
  std::size_t begin = focus.begin > lead ? focus.begin - lead : 0;
  begin = std::min(begin, layout.width() - width);
  return {begin, begin + width};
}

std::string sourceInside(const Layout& layout, const Columns& window) {
  std::string text;
  for (std::size_t i = 0; i < layout.cells.size(); ++i) {
    const bool inside = layout.starts[i] >= window.begin && layout.starts[i + 1] <= window.end;
    const bool cutCell =
        !inside && layout.starts[i] < window.end && layout.starts[i + 1] > window.begin;
    if (inside) {
      text += layout.cells[i].text;
    } else if (cutCell) {
      const std::size_t begin = std::max(layout.starts[i], window.begin);
      const std::size_t end = std::min(layout.starts[i + 1], window.end);
      text.append(end - begin, ' ');
    }
  }
  return text;
}

struct Placed {
  Columns columns;
  const Mark* mark;
};

void paint(std::string& row, const Columns& columns, char glyph) {
  row.resize(std::max(row.size(), columns.end), ' ');
  for (std::size_t i = columns.begin; i < columns.end; ++i) {
    row[i] = row[i] == '^' ? '^' : glyph;
  }
}

/// Carets and dashes of all marks in one row that ends with the text of the rightmost; the other
/// texts follow on rows of their own, right to left, below their mark.
std::vector<std::string> underline(std::vector<Placed> placed) {
  std::stable_sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) {
    return a.columns.begin < b.columns.begin;
  });
  std::string row;
  for (const Placed& p : placed) {
    paint(row, p.columns, p.mark->primary ? '^' : '-');
  }
  std::vector<std::string> rows;
  for (auto p = placed.rbegin(); p != placed.rend(); ++p) {
    const std::string text = displayText(p->mark->text);
    if (p == placed.rbegin()) {
      rows.push_back(text.empty() ? row : row + " " + text);
    } else if (!text.empty()) {
      rows.push_back(std::string(p->columns.begin, ' ') + text);
    }
  }
  return rows;
}
}  // namespace

Excerpt excerpt(std::string_view line, const std::vector<Mark>& marks, std::size_t width) {
  const Mark focus = focusOf(marks);
  const Columns bytes = bytesNear(line, focus);
  const Layout layout(line.substr(bytes.begin, bytes.end - bytes.begin));
  const Columns window = windowFor(layout, columnsOf(layout, focus, bytes.begin), width);

  const bool cutLeft = bytes.begin > 0 || window.begin > 0;
  const bool cutRight = bytes.end < line.size() || window.end < layout.width();
  Excerpt result;
  result.source = (cutLeft ? "…" : "") + sourceInside(layout, window) + (cutRight ? "…" : "");
  while (!result.source.empty() && result.source.back() == ' ') {
    result.source.pop_back();
  }

  std::vector<Placed> placed;
  const std::size_t shift = cutLeft ? 1 : 0;
  for (const Mark& mark : marks) {
    Columns c = columnsOf(layout, mark, bytes.begin);
    if (c.end <= window.begin || c.begin > window.end) {
      continue;  // out of view on a long line
    }
    c.begin = std::max(c.begin, window.begin) - window.begin + shift;
    c.end = std::max(c.begin + 1, std::min(c.end, window.end + 1) - window.begin + shift);
    placed.push_back({c, &mark});
  }
  result.underlines = underline(std::move(placed));
  return result;
}

}  // namespace arelem
