#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "runtime/motion/field.h"
#include "runtime/motion/segment.h"

namespace arelem::motion {

/// One of the two surfaces that guide a motion, with its tolerance band.
struct Guide {
  std::unique_ptr<Field> field;
  bool turning = false;             ///< the tool axis changes along the path
  double inner = 0.0, outer = 0.0;  ///< the gap may lie in [-inner, outer]
  double rest = 0.0;                ///< gap at stops
  double bend = 0.0;                ///< present estimate of the curvature along the path
  double trend = 0.0;               ///< its change per length of path
  double spread = 0.0;              ///< length of the cut vector over which that was seen
  double error = 0.0;               ///< of the places foretold, per length to the third
  /// Where the curvature changes its sign on the next cut vector: 1 where that should end at the
  /// outer edge of the band, -1 at the inner one; else 0.
  int aim = 0;

  /// Nothing is known of what comes but, perhaps, the curvature.
  void startAnew(double curvature) {
    bend = curvature;
    trend = spread = error = 0.0;
    aim = 0;
  }
  /// The gap next to an edge of the band, but for what positions may be off.
  [[nodiscard]] double edge(bool outwards) const {
    const double off = aimShare * (inner + outer);
    return outwards ? outer - off : off - inner;
  }
  /// What the last places foretold were off, for the next one. 0 where that is too much of the band
  /// to go on like this.
  [[nodiscard]] double correction(double along) const {
    const double off = along * along * along * error;
    return std::abs(off) <= mostError * (inner + outer) ? off : 0.0;
  }

  /// True where the gap changes linearly along a cut vector.
  [[nodiscard]] bool flat() const { return field->flat() && !turning; }
  /// Gap at which the next cut vector should end: the edge that leaves the chord most room, but for
  /// what positions may be off.
  [[nodiscard]] double vertexGap() const {
    if (flat()) {
      return rest;
    }
    if (field->flat() && bend == 0.0) {
      return std::clamp(rest, edge(false), edge(true));
    }
    return edge(aim != 0 ? aim > 0 : bend >= 0.0);
  }
  /// Cut vectors end within this share of the band of the gap aimed at.
  static constexpr double aimShare = 2e-4;
  static constexpr double mostError = 0.1;
};

/// A place on the path: tool position, contacts with part (0) and drive (1) surface, and the
/// direction.
struct PathPoint {
  Vec3 toolEnd = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  std::array<tool::Contact, 2> contacts;
  Vec3 tangent = Vec3::UnitX();
  /// 1 where the tangent goes with the product of the normals of part and drive, -1 where against
  /// it; 0 where these have no product. One path has one sense, round corners too: the surfaces
  /// stay on their sides of it.
  double sense = 0.0;

  /// Sets out in a direction of one's own along the path.
  void face(const Vec3& direction) {
    sense = direction.dot(tangent) < 0.0 ? -sense : sense;
    tangent = direction;
  }
};

/// The curve on which both gaps keep given values.
class Path {
 public:
  std::array<Guide, 2> guides;  ///< part, drive
  AxisRule axis;
  /// Slopes of the gaps in the middle of the chord that `fit` looked at last, and its end.
  struct Middle {
    Vec3 end = Vec3::Zero();
    std::array<double, 2> slope{0.0, 0.0};
    std::array<std::array<double, 2>, 2> ends{};  ///< slopes at both ends
    bool straight = false;                        ///< the axis stays
    std::array<bool, 2> smooth{true, true};       ///< the ends foretell the middle
    /// The curvature next to the end, if it was looked at.
    std::array<std::optional<double>, 2> behind;
  };
  Middle middle;
  /// Where the chord that `fit` looked at last leaves its band most because the gap goes from one
  /// contact to another, between which no cubic foretells it.
  struct Ridge {
    std::size_t guide;
    Vec3 place;  ///< tool end
    double gap;
    double drop;                  ///< of the slope
    std::array<Vec3, 2> normals;  ///< of both contacts
  };
  std::optional<Ridge> ridge;
  /// Of facets: -1 where the chord that `fit` looked at last is too near to the surface, 1 where it
  /// is too far off, else 0.
  std::array<int, 2> misses{0, 0};

  /// Of a chord that leaves its band far: the curvature of one that leaves it as much. That at its
  /// ends may be of the other sign where two places of the cutter touch there, and the one that
  /// comes nearer on the way is not the one that is seen.
  std::array<std::optional<double>, 2> swerves;

  /// The wider one of both bands: the measure for lengths next to corners.
  [[nodiscard]] double band() const {
    return std::max(guides[0].inner + guides[0].outer, guides[1].inner + guides[1].outer);
  }
  /// Contacts and tangent at a tool position; the tangent goes with `towards`.
  [[nodiscard]] PathPoint look(const Vec3& toolEnd, const Vec3& towards);
  /// The same with an axis of one's own.
  [[nodiscard]] PathPoint lookWith(const Vec3& toolEnd, const Vec3& toolAxis, const Vec3& towards);
  /// The place in the plane through `near` square to `towards` with the given gaps; `toolAxis` null
  /// for the path's own rule.
  [[nodiscard]] std::optional<PathPoint> standing(const Vec3& near,
                                                  const Vec3& towards,
                                                  const std::array<double, 2>& gaps,
                                                  const Vec3* toolAxis);
  /// Turn of the axis per length of path.
  [[nodiscard]] Vec3 spinAt(const PathPoint& p);
  /// The place `to` at distance `along` from `from`, measured on its tangent, with the given gaps.
  /// False where the path cannot be followed so far.
  [[nodiscard]] bool step(const PathPoint& from,
                          double along,
                          const std::array<double, 2>& gaps,
                          double accept,
                          PathPoint& to);
  /// The same place seen round a corner of the path: behind it another place of the cutter touches
  /// one of the surfaces. None where the path goes straight on, or nowhere.
  [[nodiscard]] std::optional<PathPoint> roundCorner(const PathPoint& at);
  [[nodiscard]] std::array<double, 2> vertexGaps() const {
    return {guides[0].vertexGap(), guides[1].vertexGap()};
  }
  [[nodiscard]] std::array<double, 2> rests() const { return {guides[0].rest, guides[1].rest}; }
  [[nodiscard]] bool flat() const { return guides[0].flat() && guides[1].flat(); }
  /// Sets tangent and sense of a place whose contacts are known, so that the tangent goes with
  /// `towards`; false where the surfaces have no common one.
  [[nodiscard]] bool aim(PathPoint& point, const Vec3& towards);
  /// The same for a place that follows `from` on the path, which may turn back between them.
  [[nodiscard]] bool aimBehind(PathPoint& point, const PathPoint& from);
  /// Factor by which the chord may grow, or must shrink, to fit both bands.
  [[nodiscard]] double fit(const PathPoint& a, const PathPoint& b);
  /// The same, and to fit the largest turn of an axis that follows the path.
  [[nodiscard]] double fitWithTurn(const PathPoint& a, const PathPoint& b);
  /// How far along the tangent at `a` the path has the corner below the ridge, with gap `to`.
  [[nodiscard]] double alongRidge(const PathPoint& a, double to) const;

 private:
  [[nodiscard]] bool settleStep(const PathPoint& from,
                                double along,
                                const std::array<double, 2>& gaps,
                                double accept,
                                PathPoint& at);
  /// `turning`: the cut vector, where the axis turns on it.
  [[nodiscard]] double fitAlong(const PathPoint& a,
                                const PathPoint& b,
                                const certify::Chord* turning);
  /// Chords from one place that bulged.
  struct Bulges {
    Vec3 from = Vec3::Zero();
    int count = 0;
  };
  Bulges bulges_;
  /// Factor for a chord on which the gap does not bend evenly, and may bulge out of its band.
  [[nodiscard]] double fitBulge(
      std::size_t guide, const PathPoint& a, const PathPoint& b, double inner, double outer);
  [[nodiscard]] double fitFacets(std::size_t guide, const PathPoint& a, const PathPoint& b);
};

/// The cut vector from one place to the next.
[[nodiscard]] Segment segmentBetween(const PathPoint& a, const PathPoint& b);

}  // namespace arelem::motion
