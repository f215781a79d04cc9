#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "ir/cl/record.h"

namespace arelem::cl {

/// A feed as FEDRAT gives it.
struct Feed {
  enum class Per : std::uint8_t { minute, turn, move };
  double value = 0.0;  ///< mm a minute or a turn of the spindle; moves a minute (inverse time)
  Per per = Per::minute;

  /// mm a minute along a move of `length` mm while the spindle turns `turns` a minute.
  [[nodiscard]] double perMinute(double length, double turns) const {
    return value * (per == Per::turn ? turns : per == Per::move ? length : 1.0);
  }
};

/// A feed, or why the statement gives none.
struct FeedReading {
  std::optional<Feed> feed;
  std::string why;
};

/// Reads FEDRAT: one number and at most one unit of IPM, IPR, MMPM, MMPR, MMPS, PERMIN, PERREV and
/// INVERS. Without a unit, and with PERMIN or PERREV, the number counts lengths of `millimeters`.
[[nodiscard]] FeedReading readFeed(const Post& feedRate, double millimeters);

/// Turns a minute behind a SPINDL: `before` where it has no number; 0 where it stands, or where its
/// number is a speed of the cutter's edge or a limit.
[[nodiscard]] double turnsBehind(const Post& spindle, double before);

}  // namespace arelem::cl
