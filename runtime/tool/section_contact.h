#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/geometry/kinds/tabulated.h"
#include "runtime/tool/profile.h"

/// Contact of a cutter with a tabulated cylinder whose generatrix is square to the tool axis.
///
/// Seen along the generatrix the cutter is a plane figure of straight edges and balls: balls about
/// the centers of its corner, the bottom, the sides and their upper ends. The surface is a plane
/// curve. Where the figure is nearest to the curve it is so with one of its balls, by the curve's
/// place nearest to the ball's center, or with an edge, by a place where the curve runs along that
/// edge. The upper rim is seen as an edge too. Those places do not move with the tool: they are
/// solved for once per direction of the axis. So the least of all is found without search.
namespace arelem::tool {

/// What a contact says.
struct Contact {
  double gap = 0.0;
  Vec3 normal = Vec3::UnitZ();  ///< unit, from the surface to the cutter; the gradient of the gap
  Vec3 point = Vec3::Zero();    ///< on the cutter
};

/// What is kept from one contact to the next.
class SectionSearch {
 public:
  /// None where the section does not tell: an axis that is not square to the generatrix, a profile
  /// with corners beside its arc, a tool deep within the surface.
  [[nodiscard]] std::optional<Contact> contact(const surface::TabulatedCylinder& s,
                                               double side,
                                               const Profile& cutter,
                                               const Vec3& te,
                                               const Vec3& axis);
  /// Where it does not tell: a place of the cutter that was found to be low, if any.
  [[nodiscard]] const std::optional<Contact>& low() const { return low_; }

 private:
  using Vec2 = Eigen::Vector2d;
  using Hint = surface::TabulatedCylinder::Hint;

  /// A ball of the figure: places in the section are (across, up) from the tool end.
  struct Ball {
    Vec2 center = Vec2::Zero();
    double radius = 0.0;
    bool cut = false;  ///< it looks out at the top of the cutter
    Hint hint;
    bool known = false;
    double gap = 0.0;             ///< when it was measured
    Vec2 inPlane = Vec2::Zero();  ///< the center in the plane of the curve, from the tool end
    Vec2 at{0.0, 0.0};            ///< where the tool end was then, in that plane
    Vec2 normal{0.0, 1.0};        ///< of the surface's own side, in that plane
  };
  /// A place of the curve that runs along an edge, by what it says with the tool end at zero.
  struct Level {
    double along, gap;
    Hint hint{};
  };
  struct Edge {
    Vec2 start = Vec2::Zero(), direction = Vec2::UnitX(), outward = -Vec2::UnitY();
    double length = 0.0, ball = 0.0;
    Vec2 inPlane = Vec2::UnitX(), outInPlane = -Vec2::UnitY();  ///< both, in the plane of the curve
    std::vector<Level> levels;
  };
  static constexpr std::size_t mostBalls = 5;
  static constexpr std::size_t mostEdges = 5;

  enum class State : std::uint8_t { unknown, useful, useless };

  void prepare(const surface::TabulatedCylinder& s,
               double side,
               const Profile& cutter,
               const Vec3& axis);
  void addBall(double across, double up, double radius, bool cut);
  void addEdges(ProfilePoint from, ProfilePoint to);
  void addEdge(const Vec2& start, const Vec2& direction, double length, double ball);
  void findLevels(const surface::TabulatedCylinder::Curve& curve, double side, Edge& edge) const;
  double measure(const surface::TabulatedCylinder& s, Ball& ball, const Vec2& at);
  [[nodiscard]] const Ball& nearestBall(const surface::TabulatedCylinder& s, const Vec2& at);
  [[nodiscard]] std::optional<Contact> onEdge(const surface::TabulatedCylinder& s,
                                              const Vec3& te,
                                              const Edge& edge,
                                              const Level& level,
                                              const Level& here);
  [[nodiscard]] Vec3 inSpace(const Vec2& section) const {
    return section.x() * across_ + section.y() * axis_;
  }

  State state_ = State::unknown;
  double side_ = 1.0;
  Vec3 axis_ = Vec3::Zero(), across_ = Vec3::Zero();
  double deepest_ = 0.0;  ///< gaps below this have no single contact
  double lowestNormal_ = 0.0;
  std::array<Ball, mostBalls> balls_;
  std::array<Edge, mostEdges> edges_;
  std::optional<Contact> low_;
  std::size_t ballCount_ = 0, edgeCount_ = 0, last_ = 0;
};

}  // namespace arelem::tool
