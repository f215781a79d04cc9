// Statements of the fast lane, as the card reader takes them.
#include "frontend/read/card_reader.h"
#include "frontend/read/fast_lane.h"

namespace arelem::frontend {

/// A statement of the fast lane with the lines that it goes on in. False leaves the reader behind
/// its first line.
bool CardReader::readNumbers(const Line& first, StatementText& statement) {
  // Longer lines may have columns that are not read.
  constexpr std::size_t fieldColumns = 72;
  const auto fits = [&](const Line& line) {
    return line.text.size() <= fieldColumns || options_.takes(&DialectRules::freeWidth);
  };
  FastLine fast;
  FastLane lane = fits(first) ? readFastLine(first.text, fast) : FastLane::none;
  const std::size_t behindFirst = position_;
  std::size_t end = first.offset + fast.end;
  std::uint64_t continued = 0;
  for (; lane == FastLane::open; ++continued) {
    Line line;
    const auto count = fast.numbers.count;
    lane = takeLine(line) && fits(line) ? appendFastLine(line.text, fast) : FastLane::none;
    end = fast.numbers.count > count ? line.offset + fast.end : end;
  }
  if (lane == FastLane::none) {
    position_ = behindFirst;
    return false;
  }
  for (std::uint64_t i = 0; i < continued; ++i) {
    reporter_.used(ir::Feature::LX_02);
  }
  if (fast.comment) {
    reporter_.used(ir::Feature::LX_03);
  }
  statement.kind = StatementText::Kind::numbers;
  statement.numbers = fast.numbers;
  const auto begin = static_cast<std::uint32_t>(first.offset + fast.begin);
  statement.span = {buffer_, begin, static_cast<std::uint32_t>(end) - begin};
  return true;
}

}  // namespace arelem::frontend
