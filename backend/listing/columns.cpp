#include "backend/listing/columns.h"

#include <array>

#include <fmt/format.h>

#include "backend/text/number.h"

namespace arelem::backend {

void appendColumn(std::string& line, double value, int width, int decimals) {
  std::string text;
  if (isWritable(value)) {
    std::array<char, numberRoom> digits{};
    text.assign(digits.data(), writeFixed(digits.data(), value, decimals));
  } else {
    text = fmt::format("{:.{}e}", value, decimals);
  }
  const auto columns = static_cast<std::size_t>(width);
  line.append(text.size() < columns ? columns - text.size() : 1, ' ');
  line += text;
}

}  // namespace arelem::backend
