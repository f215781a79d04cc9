#pragma once
#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include "runtime/tool/survey_rows.h"

/// What a survey of the contact finds on its circles. Private to runtime/tool.
namespace arelem::tool {

struct SurveyGrid {
  static constexpr int angles = SurveyRows::angles;
  using Row = std::array<double, SurveyRows::angles>;
  using Values = std::array<Row, SurveyRows::most>;

  SurveyGrid(const SurveyRows& all, bool isDrill) : rows(all), drill(isDrill) {}

  /// The lowest of its neighbors; of equal ones the first. A row on the axis, the same all around,
  /// does not tell where the others are low; nor does the corner of a drill for the cone above it,
  /// on which a hollow may come nearer between its ends.
  [[nodiscard]] bool isLow(std::size_t row, int k) const {
    const bool onCone = drill && rows.list[row].piece == SurveyRow::bottom;
    for (int dr = -1; dr <= 1; ++dr) {
      const auto r = static_cast<std::size_t>(static_cast<int>(row) + dr);
      const bool tells = r == row || (r < rows.count && rows.list[r].q.rho > 0.0 &&
                                      !(onCone && rows.list[r].piece != SurveyRow::bottom));
      for (int dk = -1; dk <= 1 && tells; ++dk) {
        const int neighbor = (k + dk + angles) % angles;
        const bool before = r < row || (r == row && neighbor < k);
        const double value = at(r, neighbor);
        const double here = at(row, k);
        if ((dr != 0 || dk != 0) && (before ? value <= here : value < here)) {
          return false;
        }
      }
    }
    return true;
  }

  struct Between {
    double gap = std::numeric_limits<double>::infinity();
    double share = 0.0;  ///< of the way to the next place
  };
  /// About the low place between a place of a row and the next one where neither of them is low:
  /// where two sides of a hollow come near next to each other, slopes tell of the one that is
  /// farther off at the places of the grid. None where there is no such place, and between the
  /// ends of the side: from there descents go along it, mostly to its rim or its corner.
  [[nodiscard]] Between behind(std::size_t row, int k) const {
    const bool amidst = rows.list[row].piece == SurveyRow::side && row + 1 != rows.count;
    const double from = slopes[row][index(k)];
    const double to = slopes[row][index(k + 1)];
    if (amidst || !(from < 0.0 && to > 0.0) || isLowOfRow(row, k) || isLowOfRow(row, k + 1)) {
      return {};
    }
    constexpr double step = 2.0 * std::numbers::pi / angles;
    // As parabolas of the curvature that the slopes tell go down from both places.
    const double curved = (to - from) / step;
    const double before = at(row, k) - 0.5 * from * from / curved;
    const double after = at(row, k + 1) - 0.5 * to * to / curved;
    return {std::min(before, after), from / (from - to)};
  }

  void sharpen() { std::for_each(values.begin(), values.begin() + rows.count, tool::sharpen); }

  const SurveyRows& rows;
  bool drill;
  Values values;
  Values slopes;  ///< by the angle about the axis

 private:
  [[nodiscard]] static std::size_t index(int k) {
    return static_cast<std::size_t>((k + angles) % angles);
  }
  [[nodiscard]] double at(std::size_t row, int k) const { return values[row][index(k)]; }
  [[nodiscard]] bool isLowOfRow(std::size_t row, int k) const {
    return at(row, k) <= at(row, k - 1) && at(row, k) <= at(row, k + 1);
  }
};

}  // namespace arelem::tool
