#pragma once
#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "runtime/tool/profile.h"

/// The circles of a cutter that a survey of the contact looks at. Private to runtime/tool.
namespace arelem::tool {

struct SurveyRow {
  enum Piece { corner, bottom, side };
  ProfilePoint q;
  double ball = 0.0;
  Piece piece = corner;
  double along = 0.0;       ///< share of the length of the bottom or the side
  double halfHeight = 0.0;  ///< half the distance to the next row
};

/// The corner stands for its whole arc; pieces without length are left out.
struct SurveyRows {
  static constexpr std::size_t most = 8;
  static constexpr std::size_t angles = 16;  ///< places around a row
  std::array<SurveyRow, most> list;
  std::size_t count = 0;

  explicit SurveyRows(const Profile& cutter) {
    const ProfilePoint& from = cutter.sideStart;
    const ProfilePoint& to = cutter.sideEnd;
    if (!cutter.ring && cutter.bottomEnd.rho > 0.0) {
      add({{0.0, 0.0}, 0.0, SurveyRow::bottom, 0.0});
      add({{0.5 * cutter.bottomEnd.rho, 0.5 * cutter.bottomEnd.z}, 0.0, SurveyRow::bottom, 0.5});
    }
    add({{cutter.e, cutter.f}, cutter.r, SurveyRow::corner});
    if (to.z > from.z) {
      for (const double s : {0.25, 0.5, 0.75, 1.0}) {
        add({{from.rho + s * (to.rho - from.rho), from.z + s * (to.z - from.z)},
             0.0,
             SurveyRow::side,
             s,
             0.125 * (to.z - from.z)});
      }
    } else if (!cutter.ring && cutter.r > 0.0) {
      // The rim at which the arc ends: the angle about the axis counts there even for a ball.
      add({to, 0.0, SurveyRow::side, 1.0});
    }
  }

 private:
  void add(const SurveyRow& row) { list[count++] = row; }
};

/// Lowers what is low in a row of distances, places evenly around the axis, to where it would be
/// between them: along a twisted surface rows are touched in different directions, and the places
/// go with that of one of them.
inline void sharpen(std::span<double, SurveyRows::angles> row) {
  constexpr std::size_t count = SurveyRows::angles;
  std::array<double, count> lowered;
  for (std::size_t k = 0; k < count; ++k) {
    const double before = row[(k + count - 1) % count], behind = row[(k + 1) % count];
    const double bend = before + behind - 2.0 * row[k];
    const bool low = row[k] <= before && row[k] <= behind && bend > 0.0 &&
                     bend < std::numeric_limits<double>::infinity();
    lowered[k] = row[k] - (low ? 0.125 * (behind - before) * (behind - before) / bend : 0.0);
  }
  std::copy(lowered.begin(), lowered.end(), row.begin());
}

}  // namespace arelem::tool
