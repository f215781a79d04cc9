// TABCYL definitions: from the data of the statement to the nodes of a curve.
#include <cmath>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"
#include "runtime/define/choice.h"
#include "runtime/define/resolve.h"
#include "runtime/define/tabcyl_fit.h"
#include "runtime/geometry/angle.h"

namespace arelem::define {

using geometry::Matrix;
using geometry::TabulatedCylinder;
using geometry::Vec2;

namespace {

/// The coordinate axes that a format keeps: u, v and the generatrix w.
struct PlaneAxes {
  int u = 0, v = 1, w = 2;
  std::string_view name = "xy";
};
PlaneAxes axesOf(Word format) {
  if (format == Word::NOX) {
    return {1, 2, 0, "yz"};
  }
  return format == Word::NOY ? PlaneAxes{2, 0, 1, "zx"} : PlaneAxes{};
}

FitMethod methodOf(Word word) {
  if (word == Word::FOURPT) {
    return FitMethod::fourPoint;
  }
  return word == Word::SPLINE ? FitMethod::spline : FitMethod::twoPoint;
}

/// Reads the data of the formats in a plane, in the order of the statement.
class PlaneData {
 public:
  PlaneData(const Arguments& given, std::size_t first) : given_(given), next_(first) {}

  std::vector<CurveNode> read() {
    const bool slopeEverywhere = given_.is(1, Word::PTSLOP) || given_.is(1, Word::PTNORM);
    std::vector<CurveNode> nodes;
    while (next_ < given_.count()) {
      CurveNode node;
      node.place = place();
      if (slopeEverywhere) {
        node.tangent = tangent(given_.is(1, Word::PTNORM));
      } else if (given_.is(next_, Word::SLOPE) || given_.is(next_, Word::NORMAL)) {
        const bool normal = given_.is(next_, Word::NORMAL);
        ++next_;
        node.tangent = tangent(normal);
      }
      nodes.push_back(node);
    }
    return nodes;
  }

 private:
  Vec2 place() {
    if (given_.isEntity(next_)) {
      const PlaneAxes axes = axesOf(given_.word(0));
      const Vec3 point = given_.point(next_++);
      return {point(axes.u), point(axes.v)};
    }
    const Vec2 pair = given_.pair(next_);
    next_ += 2;
    const bool radiusFirst = given_.is(0, Word::RTHETA);
    if (radiusFirst || given_.is(0, Word::THETAR)) {
      const geometry::SinCos angle = geometry::sinCosDegrees(radiusFirst ? pair.y() : pair.x());
      const double radius = radiusFirst ? pair.x() : pair.y();
      return {radius * angle.cos, radius * angle.sin};
    }
    return pair;
  }

  Vec2 tangent(bool normal) {
    const double value = given_.scalar(next_++);
    if (normal) {
      const geometry::SinCos angle = geometry::sinCosDegrees(value);
      return {-angle.sin, angle.cos};
    }
    const geometry::SinCos angle = geometry::sinCosOfTangent(value);
    return {angle.cos, angle.sin};
  }

  const Arguments& given_;
  std::size_t next_;
};

/// Moves nodes of the (u, v) plane by a matrix that must keep the plane.
Result<bool> moveInPlane(const Matrix& matrix,
                         const PlaneAxes& axes,
                         std::vector<CurveNode>& nodes) {
  const double leaves =
      std::max(std::abs(matrix.linear(axes.w, axes.u)), std::abs(matrix.linear(axes.w, axes.v)));
  if (leaves > tolerance::perpendicular) {
    return fail(diag::LeavesPlane, axes.name, leaves);
  }
  Eigen::Matrix2d linear;
  linear << matrix.linear(axes.u, axes.u), matrix.linear(axes.u, axes.v),
      matrix.linear(axes.v, axes.u), matrix.linear(axes.v, axes.v);
  const Vec2 shift(matrix.translation(axes.u), matrix.translation(axes.v));
  for (CurveNode& node : nodes) {
    node.place = linear * node.place + shift;
    if (node.tangent) {
      node.tangent = linear * *node.tangent;
    }
  }
  return true;
}

Result<Resolved> fitted(const Arguments& given,
                        const std::vector<CurveNode>& nodes,
                        FitMethod method,
                        const Eigen::Matrix3d& frame) {
  std::optional<Failure> remark;
  Result<TabulatedCylinder> surface = fitCurve(nodes, method, remark);
  if (!surface) {
    return surface.takeFailure();
  }
  if (remark) {
    given.remark(*std::move(remark));
  }
  surface->frame = frame;
  return Resolved(*surface);
}

/// Rows U, V, W with W along the generatrix. U is the coordinate axis that is most across W, made
/// perpendicular, so that the generatrix z has the frame x, y, z.
Eigen::Matrix3d frameAlong(const Vec3& w) {
  int most = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(w(axis)) < std::abs(w(most))) {
      most = axis;
    }
  }
  const Vec3 u = (Vec3::Unit(most) - w(most) * w).normalized();
  Eigen::Matrix3d frame;
  frame << u.transpose(), w.cross(u).transpose(), w.transpose();
  return frame;
}

}  // namespace

Result<Resolved> tabcylInPlane(const Arguments& given) {
  const bool moved = given.is(2, Word::TRFORM);
  std::vector<CurveNode> nodes = PlaneData(given, moved ? 4 : 2).read();
  const PlaneAxes axes = axesOf(given.word(0));
  if (moved) {
    Result<bool> kept = moveInPlane(given.matrix(3), axes, nodes);
    if (!kept) {
      return kept.takeFailure();
    }
  }
  Eigen::Matrix3d frame;
  frame << Vec3::Unit(axes.u).transpose(), Vec3::Unit(axes.v).transpose(),
      Vec3::Unit(axes.w).transpose();
  return fitted(given, nodes, methodOf(given.word(1)), frame);
}

Result<Resolved> tabcylInSpace(const Arguments& given) {
  const bool moved = given.is(2, Word::TRFORM);
  const Matrix matrix = moved ? given.matrix(3) : Matrix{};
  std::size_t next = moved ? 4 : 2;
  Result<Vec3> generatrix = unit(matrix.linear * given.arrow(next++), "the generatrix");
  if (!generatrix) {
    return generatrix.takeFailure();
  }
  const Eigen::Matrix3d frame = frameAlong(*generatrix);
  std::vector<CurveNode> nodes;
  while (next < given.count()) {
    const bool isPoint = given.isEntity(next);
    const Vec3 place = matrix.apply(isPoint ? given.point(next) : given.triple(next));
    next += isPoint ? 1 : 3;
    nodes.push_back({(frame * place).head<2>(), {}});
  }
  return fitted(given, nodes, methodOf(given.word(1)), frame);
}

}  // namespace arelem::define
