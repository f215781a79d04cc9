#pragma once
#include <array>
#include <span>

#include "runtime/motion/axis.h"

/// Positioning: the tool end that satisfies up to three conditions (CENTR and CENTR2 of the old
/// system).
namespace arelem::motion {

/// field(tool end) = target.
struct Wanted {
  Field* field = nullptr;
  double target = 0.0;
};

/// normal . (tool end - through) = 0: a pseudo surface, met exactly.
struct Constraint {
  Vec3 normal = Vec3::Zero();
  Vec3 through = Vec3::Zero();

  [[nodiscard]] double missedAt(const Vec3& place) const { return -normal.dot(place - through); }
};

/// Residuals at a place up to this are rounding.
[[nodiscard]] inline double roundingAt(const Vec3& place) {
  constexpr double relative = 4e-16, absolute = 2e-15;
  return absolute + relative * place.cwiseAbs().maxCoeff();
}

struct Settled {
  bool ok = false;
  Vec3 toolEnd = Vec3::Zero();
  int iterations = 0;
  double worst = 0.0;                     ///< largest remaining residual, part unit
  std::size_t worstAt = 0;                ///< index into the wanted fields
  Vec3 axis = Vec3::UnitZ();              ///< tool axis at toolEnd
  std::array<tool::Contact, 3> contacts;  ///< of the wanted fields at toolEnd
};

/// Newton from `start`. Where fewer than three equations are given each step is the shortest one,
/// so that the tool moves in the span of the contact normals. Ends when no residual is above
/// `accept` (0: rounding).
[[nodiscard]] Settled settle(const Vec3& start,
                             AxisRule& axis,
                             std::span<const Wanted> wanted,
                             std::span<const Constraint> constraints,
                             double accept = 0.0);

/// The same from a place that is measured.
void settleOn(Settled& at,
              AxisRule& axis,
              std::span<const Wanted> wanted,
              std::span<const Constraint> constraints,
              double accept);

/// The conditions at a place, measured.
[[nodiscard]] Settled measured(const Vec3& place, AxisRule& axis, std::span<const Wanted> wanted);

/// Directions that go with the surfaces wherever these lie: along the first contact normal, square
/// to it towards the second, and square to both.
[[nodiscard]] Eigen::Matrix3d frameOf(const Settled& at, std::size_t count);

/// The place near `start` at which the conditions are missed least, in the sense of least squares,
/// with the constraints met: where no position is to be found, and a better start for `settle`.
[[nodiscard]] Settled closest(const Vec3& start,
                              AxisRule& axis,
                              std::span<const Wanted> wanted,
                              std::span<const Constraint> constraints);

/// From a place that is measured: the first step of Newton, the shortest way for which the gaps
/// there, as they rise, are the ones wanted; and how far the tool must go at least, as gaps change
/// by no more than the way.
struct FirstStep {
  Vec3 step;
  double least;
};
[[nodiscard]] FirstStep firstStep(const Settled& from,
                                  std::span<const Wanted> wanted,
                                  std::span<const Constraint> constraints);

/// The same from far away, where that is measured: all that is missed shrinks evenly, so that the
/// tool comes to the place to which it can be led, and not to one behind a surface. Not ok where no
/// such way is found.
[[nodiscard]] Settled settleEvenly(const Settled& start,
                                   AxisRule& axis,
                                   std::span<const Wanted> wanted,
                                   std::span<const Constraint> constraints);

/// The same for an axis that follows the tool position: positions with the axis held, from `held`
/// on, and the axis there, in turn until they agree, then both at once. From far away contacts jump
/// as the tool turns, so that both at once lead anywhere; with the axis held they do not. Where the
/// rule gives no axis at a place on the way, that is where it ends.
[[nodiscard]] Settled settleInTurn(const Vec3& start,
                                   const Vec3& held,
                                   AxisRule& axis,
                                   std::span<const Wanted> wanted,
                                   std::span<const Constraint> constraints);

/// The position nearest to `from` of those that are found from places around `near`, where the
/// conditions are missed least; `near` itself where none is found. In a plane of symmetry, or where
/// a surface bends away and comes back, steps from one place do not lead there.
[[nodiscard]] Settled nearestAround(const Settled& near,
                                    const Vec3& from,
                                    AxisRule& axis,
                                    std::span<const Wanted> wanted,
                                    std::span<const Constraint> constraints);

}  // namespace arelem::motion
