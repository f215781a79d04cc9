#pragma once
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "ir/text/span.h"

namespace arelem::app {

/// What stands before a piece of a text.
struct PieceStart {
  std::uint32_t lines = 0;
  std::uint64_t bytes = 0;
};

/// Bytes of a piece: some ten thousand statements.
inline constexpr std::size_t pieceSize = 1U << 19U;

/// Cuts a CL file before lines that begin with GOTO or GODLTA and that no line before them runs
/// into, so that no statement and no structured comment is cut. A text without such lines is one
/// piece.
class ClPieces {
 public:
  explicit ClPieces(const std::string& path, std::size_t size = pieceSize)
      : in_(path, std::ios::binary), size_(size) {}

  struct Piece {
    std::string text;
    PieceStart start;
    bool last = false;
  };
  /// The next piece; nothing behind the last one or after a fault of the file.
  std::optional<Piece> next();
  /// False after a fault of the file.
  [[nodiscard]] bool good() const { return !in_.bad(); }

 private:
  std::ifstream in_;
  std::size_t size_;
  std::string rest_;
  PieceStart start_;
  bool ended_ = false;
};

/// Where the last cut of a text can be; 0 when there is none.
[[nodiscard]] std::size_t lastCut(std::string_view text);

}  // namespace arelem::app
