#include "app/cl_pieces.h"

#include <algorithm>
#include <array>

namespace arelem::app {

namespace {
/// Whether the line at this offset begins with GOTO or GODLTA.
bool movesAt(std::string_view text, std::size_t at) {
  at = std::min(text.find_first_not_of(" \t", at), text.size());
  const auto begins = [&](std::string_view word) {
    const std::string_view there = text.substr(at, word.size());
    return there.size() == word.size() &&
           std::equal(there.begin(), there.end(), word.begin(),
                      [](char c, char upper) { return c == upper || c == upper - 'A' + 'a'; });
  };
  return begins("GOTO") || begins("GODLTA");
}

/// Whether a line may run into the next one. Behind `$$` is a comment, which goes on only where
/// it holds a statement of Creo and ends in `$`.
bool goesOn(std::string_view line) {
  const std::size_t dollar = line.find('$');
  if (dollar == std::string_view::npos) {
    return false;
  }
  const std::size_t last = line.find_last_not_of(" \t\r");
  return line.substr(dollar, 2) != "$$" || (last > dollar + 1 && line[last] == '$');
}

std::uint32_t linesOf(std::string_view text) {
  auto lines = static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n'));
  for (std::size_t at = text.find('\r'); at != std::string_view::npos;
       at = text.find('\r', at + 1)) {
    lines += at + 1 == text.size() || text[at + 1] != '\n' ? 1 : 0;
  }
  return lines;
}
}  // namespace

std::size_t lastCut(std::string_view text) {
  std::size_t feed = text.rfind('\n');
  while (feed != std::string_view::npos && feed > 0) {
    const std::size_t before = text.rfind('\n', feed - 1);
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
    if (movesAt(text, feed + 1) && !goesOn(text.substr(begin, feed - begin))) {
      return feed + 1;
    }
    feed = before;
  }
  return 0;
}

std::optional<ClPieces::Piece> ClPieces::next() {
  if (ended_ || !good()) {
    return std::nullopt;
  }
  Piece piece{std::move(rest_), start_, false};
  rest_.clear();
  for (std::size_t wanted = size_; piece.text.size() < wanted || in_; wanted *= 2) {
    while (piece.text.size() < wanted && in_) {
      const std::size_t before = piece.text.size();
      piece.text.resize(wanted);
      in_.read(piece.text.data() + before, static_cast<std::streamsize>(wanted - before));
      piece.text.resize(before + static_cast<std::size_t>(in_.gcount()));
    }
    if (!in_) {
      break;
    }
    if (const std::size_t end = lastCut(piece.text); end != 0) {
      rest_ = piece.text.substr(end);
      piece.text.resize(end);
      start_.lines += linesOf(piece.text);
      start_.bytes += piece.text.size();
      return piece;
    }
  }
  ended_ = piece.last = true;
  return piece;
}

}  // namespace arelem::app
