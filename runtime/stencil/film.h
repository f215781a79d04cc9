#pragma once
#include <span>

#include "runtime/film/map.h"
#include "runtime/stencil/plan.h"

namespace arelem::stencil {

/// What the gun paints between two poses.
struct PaintedCell {
  const Track* track = nullptr;
  std::size_t pose = 0;  ///< the first of the two
  double tilt = 0.0;     ///< mean of both, degrees
  double area = 0.0;     ///< mm2
  double seconds = 0.0;
  double share =
      50.0;  ///< percent of the area that half of the paint falls on, from the first edge

  /// The fan lines at its ends.
  [[nodiscard]] std::pair<Line, Line> lines() const {
    return {track->poses[pose].line, track->poses[pose + 1].line};
  }
};
[[nodiscard]] std::vector<PaintedCell> cellsOf(std::span<const Track> tracks, const FanGun& gun);
/// Seconds of spraying for one mm2, over all cells.
[[nodiscard]] double meanRate(std::span<const PaintedCell> cells);

/// A strip of a cell with the film over the mean film of all cells at its corners: continuous
/// between the cells of a track.
struct FilmPatch {
  std::size_t cell = 0;  ///< index in `cellsOf`
  std::array<Vec2, 4> corner{Vec2::Zero(), Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
  std::array<double, 4> film{1.0, 1.0, 1.0, 1.0};
};
[[nodiscard]] std::vector<FilmPatch> filmPatches(std::span<const Track> tracks, const FanGun& gun);

/// The film in square cells of this size (mm; 0: `filmCells` in the longer direction). Where
/// strokes cover each other it adds up. `meanFilm` is what 1 of the patches means, mm.
inline constexpr double filmCells = 1500.0;
[[nodiscard]] film::Map filmMap(const std::vector<FilmPatch>& patches,
                                double cell,
                                double meanFilm);

}  // namespace arelem::stencil
