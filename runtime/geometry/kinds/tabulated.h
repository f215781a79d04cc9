#pragma once
#include <memory>
#include <vector>

#include "runtime/geometry/surface.h"

namespace arelem::surface {

/// A cylinder over a plane curve of cubic pieces (TABCYL). The generatrix is the w axis of the
/// frame. In the local frame of piece i, x runs along the chord and the curve is y = a x^3 + b x^2
/// + c x. The first and last piece are straight and run to infinity, unless the curve is closed.
/// Positive on the left of the curve, seen against w.
class TabulatedCylinder {
 public:
  struct Piece {
    double u, v;        ///< start of the chord
    double dirU, dirV;  ///< unit chord direction
    double length;      ///< of the chord
    double a, b, c;     ///< offset polynomial; zero for the straight extensions
    bool openStart = false, openEnd = false;  ///< an extension without end
    double lowY = 0.0, highY = 0.0;           ///< range of the offset over the piece
  };
  struct Hint {
    int piece = -1;  ///< of the last foot, -1: none
    double x = 0.0;  ///< its local parameter
    /// Seen from this place of the plane, the other pieces were at least so far away.
    double others = -1.0, u = 0.0, v = 0.0;
  };
  struct Curve {
    Vec3 u = Vec3::UnitX(), v = Vec3::UnitY(), w = Vec3::UnitZ();
    std::vector<Piece> pieces;

    [[nodiscard]] bool isClosed() const { return !pieces.front().openStart; }
  };

  explicit TabulatedCylinder(std::shared_ptr<const Curve> curve) : curve_(std::move(curve)) {}

  /// A foot seen along the generatrix: the normal is (u, v) in the plane of the curve.
  struct PlaneFoot {
    double distance = 0.0, normalU = 0.0, normalV = 0.0;
  };

  [[nodiscard]] Foot foot(const Vec3& p, Hint& hint) const;
  /// The foot of all places that are seen at (u, v) along the generatrix.
  [[nodiscard]] PlaneFoot footInPlane(double u, double v, Hint& hint) const;
  [[nodiscard]] double bend(const Vec3& p, const Foot& foot, const Vec3& t, Hint& hint) const;
  [[nodiscard]] Bends bends(const Vec3& p, const Foot& foot, double radius) const;
  [[nodiscard]] const Vec3& generatrix() const { return curve_->w; }
  [[nodiscard]] const Curve& curve() const { return *curve_; }

 private:
  std::shared_ptr<const Curve> curve_;
};

}  // namespace arelem::surface
