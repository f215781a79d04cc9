#pragma once
#include <vector>

#include "runtime/certify/body_search.h"
#include "runtime/tool/body.h"

namespace arelem::certify {

/// Proof that no point of a cutter whose axis keeps its direction comes nearer to a tabulated
/// cylinder than some gap: branch and bound over time and the curve, in the plane square to the
/// generatrix.
///
/// A part of the curve keeps clear of the cutter during a part of the time if a line parts them:
/// the cutter reaches towards the unit direction n as far as its support function says, the part of
/// the curve lies within the polygon of its four Bezier points. Any n is a proof if the polygon is
/// beyond; good ones point from the cutter to the curve. For a gap below zero the curve is first
/// set back by it.
class CurveSearch {
 public:
  CurveSearch(const surface::TabulatedCylinder& surface,
              const tool::Profile& cutter,
              const Relation& relation);

  /// Whether the gap of the cutter, without its top face, is at least `aim` for s in [from, to] of
  /// a chord without turn. Ends at the first gap below it, or when `budget` parts were looked at.
  BodyResult run(const Chord& chord, double from, double to, double aim, int budget);

 private:
  using Vec2 = Eigen::Vector2d;
  using Piece = surface::TabulatedCylinder::Piece;

  /// A part of a piece and of the time; a corner of the curve has no length, and its normals are
  /// those between two.
  struct Part {
    std::size_t piece = 0;
    double x0 = 0.0, x1 = 0.0, s0 = 0.0, s1 = 0.0;
    bool corner = false;
  };

  void place(const Chord& chord, double aim);
  void begin(double from, double to);
  [[nodiscard]] Vec2 toolEnd(double s) const { return start_ + s * step_; }
  /// How far the part is beyond the set back line, at least; `direction` is one from the cutter to
  /// the middle of the part.
  [[nodiscard]] double clearance(const Part& part, const Vec2& direction) const;
  [[nodiscard]] double setBack(const Part& part, const Vec2& direction) const;
  [[nodiscard]] Vec2 towards(const Vec2& place) const;
  [[nodiscard]] double support(const Vec2& direction) const;
  [[nodiscard]] Vec3 supportPoint(const Vec2& direction) const;
  void split(const Part& part);

  const surface::TabulatedCylinder& surface_;
  const tool::Profile& cutter_;
  tool::Body body_;
  double side_, thick_;
  double reach_ = 0.0;  ///< of the farthest point of the cutter from its tool end
  surface::TabulatedCylinder::Hint hint_;
  std::vector<Part> parts_;
  Vec3 axis_ = Vec3::UnitZ();
  Vec2 axisInPlane_ = Vec2::Zero(), across_ = Vec2::UnitX();
  Vec2 start_ = Vec2::Zero(), step_ = Vec2::Zero();
  double oblique_ = 0.0;  ///< cosine of the axis and the generatrix
  double gap_ = 0.0;      ///< of the whole cutter to the curve, with the stock
};

}  // namespace arelem::certify
