#pragma once
#include <array>
#include <vector>

#include "runtime/certify/body_search.h"
#include "runtime/tool/body.h"

namespace arelem::certify {

/// Proof that no point of a cutter comes nearer to a tabulated cylinder than some gap: branch and
/// bound over time and the curve, in the plane square to the generatrix.
///
/// A part of the curve keeps clear of the cutter during a part of the time if a line parts them:
/// the cutter reaches towards the unit direction n as far as its support function says, the part of
/// the curve lies within the polygon of its four Bezier points. Any n is a proof if the polygon is
/// beyond; good ones point from the cutter to the curve. For a gap below zero the curve is first
/// set back by it. Where the axis turns, the line turns with it: at both ends of the time the tool
/// reaches as far, and between them places of the curve come nearer by the squares of turn and way.
class CurveSearch {
 public:
  CurveSearch(const surface::TabulatedCylinder& surface,
              const tool::Profile& cutter,
              const Relation& relation);

  /// Whether the gap of the cutter, without its top face, is at least `aim` for s in [from, to] of
  /// a chord. Ends at the first gap below it, or when `budget` parts were looked at.
  BodyResult run(const Chord& chord, double from, double to, double aim, int budget);

 private:
  using Vec2 = Eigen::Vector2d;
  using Piece = surface::TabulatedCylinder::Piece;
  using Polygon = std::array<Vec2, 4>;

  /// A part of a piece and of the time; a corner of the curve has no length, and its normals are
  /// those between two.
  struct Part {
    std::size_t piece = 0;
    double x0 = 0.0, x1 = 0.0, s0 = 0.0, s1 = 0.0;
    bool corner = false;
  };

  /// The tool at one time, as seen along the generatrix.
  struct Pose {
    Vec3 axis = Vec3::UnitZ();
    Vec2 axisInPlane = Vec2::Zero(), across = Vec2::UnitX();
    double oblique = 0.0;  ///< cosine of the axis and the generatrix
    Vec2 toolEnd = Vec2::Zero();
  };

  void place(const Chord& chord, double aim);
  void begin(double from, double to);
  [[nodiscard]] Pose poseOf(const Vec3& axis, const Vec2& toolEnd) const;
  [[nodiscard]] Pose poseAt(double s) const;
  [[nodiscard]] Vec2 inPlane(const Vec3& v) const;
  [[nodiscard]] double wayOf(const Part& part) const;
  /// How far the part is beyond the set back line, at least; `direction` is one from the cutter to
  /// the middle of the part.
  [[nodiscard]] double clearance(const Part& part, const Vec2& direction) const;
  [[nodiscard]] double bulge(double time) const;
  [[nodiscard]] Polygon polygonOf(const Part& part) const;
  [[nodiscard]] double beyond(const Pose& pose,
                              const Vec2& direction,
                              const Polygon& polygon) const;
  [[nodiscard]] double setBack(const Part& part, const Vec2& direction) const;
  [[nodiscard]] Vec2 towards(const Pose& pose, const Vec2& place) const;
  [[nodiscard]] Vec2 sharpened(const Pose& pose, const Vec2& place, const Vec2& direction) const;
  [[nodiscard]] double support(const Pose& pose, const Vec2& direction) const;
  [[nodiscard]] Vec3 supportPoint(const Pose& pose, const Vec2& direction) const;
  void split(const Part& part);

  const surface::TabulatedCylinder& surface_;
  const tool::Profile& cutter_;
  tool::Body body_;
  double side_, thick_;
  double reach_ = 0.0;  ///< of the farthest point of the cutter from its tool end
  surface::TabulatedCylinder::Hint hint_;
  std::vector<Part> parts_;
  const Chord* chord_ = nullptr;
  Pose first_;  ///< at the beginning of the chord
  Vec2 step_ = Vec2::Zero();
  double inPlaneTurn_ = 0.0;  ///< of the axis about the generatrix
  double far_ = 0.0;          ///< of the corners of what is looked at from the tool end
  double gap_ = 0.0;          ///< of the whole cutter to the curve, with the stock
};

}  // namespace arelem::certify
