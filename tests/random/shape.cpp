#include "tests/random/shape.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace arelem::scenes {

namespace {
/// One definition for each kind of shape.
struct Definition {
  const Similarity& to;
  const std::string& file;

  std::string operator()(const PlaneShape& s) const {
    const double length = s.normal.norm();
    const Vec3 unit = to.direction(s.normal / length);
    return "PLANE/" + written(unit) + "," +
           written(to.length(s.offset / length) + unit.dot(to.shift));
  }
  std::string operator()(const SphereShape& s) const {
    return "SPHERE/" + written(to.point(s.center)) + "," + written(to.length(s.radius));
  }
  std::string operator()(const CylinderShape& s) const {
    return "CYLNDR/" + written(to.point(s.point)) + "," + written(to.direction(s.axis)) + "," +
           written(to.length(s.radius));
  }
  std::string operator()(const ConeShape& s) const {
    return "CONE/(POINT/" + written(to.point(s.apex)) + "),(VECTOR/" +
           written(to.direction(s.axis)) + ")," + written(s.degrees);
  }
  std::string operator()(const TorusShape& s) const {
    return "TORUS/" + written(to.point(s.center)) + "," + written(to.direction(s.axis)) + "," +
           written(to.length(s.major)) + "," + written(to.length(s.minor));
  }
  std::string operator()(const QuadricShape& s) const {
    Eigen::Matrix4d back = Eigen::Matrix4d::Identity();
    back.topLeftCorner<3, 3>() = to.turn.transpose() / to.scale;
    back.topRightCorner<3, 1>() = -back.topLeftCorner<3, 3>() * to.shift;
    const Eigen::Matrix4d m = back.transpose() * s.form * back;
    std::string text = "QADRIC/";
    for (const double c : {m(0, 0), m(1, 1), m(2, 2), 2 * m(1, 2), 2 * m(0, 2), 2 * m(0, 1),
                           2 * m(0, 3), 2 * m(1, 3), 2 * m(2, 3)}) {
      text += written(c) + ",";
    }
    return text + written(m(3, 3));
  }
  // The own normals of tabulated cylinders and ruled surfaces are products of two directions, which
  // a mirror turns round: there the points, or the curves, come in the other order. To an angle
  // towards a surface that the tool end is on it matters.
  std::string operator()(const TabulatedShape& s) const {
    std::string text = "TABCYL/XYZ,SPLINE,(VECTOR/" + written(to.direction(s.direction)) + ")";
    std::vector<Vec3> points = s.points;
    if (to.mirrors()) {
      std::ranges::reverse(points);
    }
    for (const Vec3& p : points) {
      text += "," + written(to.point(p));
    }
    return text;
  }
  std::string operator()(const RuledShape& s) const {
    std::string text = "RLDSRF/";
    for (const std::size_t i :
         to.mirrors() ? std::array<std::size_t, 2>{1, 0} : std::array<std::size_t, 2>{0, 1}) {
      text += (text.back() == '/' ? "(" : ",(") + (*this)(s.carriers[i]) + ")";
      for (const Vec3& p : s.points[i]) {
        text += ",(POINT/" + written(to.point(p)) + ")";
      }
    }
    return text;
  }
  std::string operator()(const PolyconicShape& s) const {
    constexpr std::size_t powers = 8, shoulder = 6;
    std::string text = "POLCON/CANON,1";
    for (const Vec3& e : s.frame) {
      const Vec3 moved = to.direction(e);
      text += "," + written(moved) + "," + written(-moved.dot(to.point(s.origin)));
    }
    for (const double length : {s.thick, s.cb, s.pb}) {
      text += "," + written(to.length(length));
    }
    for (std::size_t i = 0; i < s.rows.size(); ++i) {
      for (std::size_t k = 0; k < powers; ++k) {
        const double c = k < s.rows[i].size() ? s.rows[i][k] : 0.0;
        text += "," + written(i == shoulder ? c : to.length(c));
      }
    }
    return text + ",0,0,0,0,0,0,0";
  }
  std::string operator()(const MeshShape&) const { return "MESH/STL,'" + file + "'"; }
};
}  // namespace

std::string written(double value) {
  return fmt::format("{}", value + 0.0);
}

std::string written(const Vec3& v) {
  return written(v.x()) + "," + written(v.y()) + "," + written(v.z());
}

std::string definition(const Shape& shape, const Similarity& move, const std::string& file) {
  return std::visit(Definition{move, file}, shape);
}

std::string stl(const MeshShape& mesh, const Similarity& move) {
  std::string text = "solid mesh\n";
  for (std::array<Vec3, 3> corners : mesh.triangles) {
    if (move.mirrors()) {
      std::swap(corners[0], corners[2]);
    }
    text += "facet normal 0 0 0\nouter loop\n";
    for (const Vec3& corner : corners) {
      const Vec3 p = move.point(corner);
      text += fmt::format("vertex {} {} {}\n", p.x(), p.y(), p.z());
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid mesh\n";
}

}  // namespace arelem::scenes
