#include "backend/robot/turned_move.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <Eigen/Geometry>

#include "ir/diag/ngc.h"
#include "ir/space/tolerance.h"

namespace arelem::robot {

namespace {

constexpr int deepestHalving = 14;
constexpr std::array samples = {0.25, 0.5, 0.75};
/// Of the tolerance of the axis, for places next to a pole: the rest is for the way between them.
constexpr double evenShare = 0.5;
/// How far the axis of a move that leaves a pole has turned where it is looked at, as a share of
/// its tolerance, and the degrees of a turn of the axes there that are made before the move.
constexpr double leavingShare = 0.2;
constexpr double leastPoleTurn = 1.0;
constexpr double degrees = 180.0 / std::numbers::pi;

double angleBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * degrees;
}

Vec3 turnedAxis(const Vec3& a, const Vec3& b, double share) {
  const Vec3 normal = a.cross(b);
  const double length = normal.norm();
  if (length <= tolerance::nullDirection) {
    return a;
  }
  const double angle = std::atan2(length, a.dot(b));
  return Eigen::AngleAxisd(share * angle, normal / length) * a;
}

/// Whether the axis of a place is within tolerance with its angles.
bool holdsAxis(const Turning& turning, const TurnedPlace& place) {
  const Vec3 axis = toolPose(turning, Vec3::Zero(), place.angles).axis;
  return angleBetween(axis, place.pose.axis) <= evenShare * turning.angleTolerance;
}

class Divider {
 public:
  Divider(const Turning& turning, std::vector<TurnedPlace>& places)
      : turning_(turning), places_(places) {}

  /// Adds the places behind `from` up to `to`.
  std::optional<Failure> add(const TurnedPlace& from, const TurnedPlace& to, int depth) {
    if (isEven(from, to)) {
      places_.push_back(to);
      return std::nullopt;
    }
    if (depth == 0) {
      return fail(diag::TurningJump, from.pose.end.x(), from.pose.end.y(), from.pose.end.z(),
                  turnBetween(from.angles, to.angles));
    }
    TurnedPlace middle{
        {0.5 * (from.pose.end + to.pose.end), turnedAxis(from.pose.axis, to.pose.axis, 0.5)}, {}};
    const Result<Angles> angles = middleAngles(from, to, middle.pose.axis);
    if (!angles) {
      return angles.failure();
    }
    middle.angles = *angles;
    if (std::optional<Failure> failure = add(from, middle, depth - 1)) {
      return failure;
    }
    // The second half begins with the angles in which the first one ended. A turn about the tool
    // has its goal, which the axis does not tell.
    TurnedPlace end = to;
    if ((to.pose.axis - from.pose.axis).norm() > tolerance::symmetric) {
      const Result<Angles> last = nextAngles(turning_, to.pose.axis, places_.back().angles);
      if (!last) {
        return last.failure();
      }
      const Angles& now = places_.back().angles;
      end.angles = turnBetween(now, to.angles) <= turnBetween(now, *last) ? to.angles : *last;
    }
    return add(TurnedPlace(places_.back()), end, depth - 1);
  }

 private:
  /// Those of the axis; but next to a pole, where a small tilt to the side asks for a half turn,
  /// the even ones, as long as the axis keeps its tolerance with them.
  [[nodiscard]] Result<Angles> middleAngles(const TurnedPlace& from,
                                            const TurnedPlace& to,
                                            const Vec3& axis) const {
    const Angles even{std::midpoint(from.angles[0], to.angles[0]),
                      std::midpoint(from.angles[1], to.angles[1])};
    Result<Angles> exact = nextAngles(turning_, axis, from.angles);
    const bool swings = !exact || turnBetween(*exact, even) > turning_.angleTolerance;
    const bool isNear = holdsAxis(turning_, {{Vec3::Zero(), axis}, even});
    return swings && isNear ? Result<Angles>(even) : std::move(exact);
  }

  [[nodiscard]] bool isEven(const TurnedPlace& from, const TurnedPlace& to) const {
    const Vec3 start = linearAxes(turning_, from.pose.end, from.angles);
    const Vec3 end = linearAxes(turning_, to.pose.end, to.angles);
    for (const double s : samples) {
      const Angles angles{std::lerp(from.angles[0], to.angles[0], s),
                          std::lerp(from.angles[1], to.angles[1], s)};
      const ToolPose pose = toolPose(turning_, start + s * (end - start), angles);
      const Vec3 wanted = from.pose.end + s * (to.pose.end - from.pose.end);
      const bool isNear = turning_.toolPoint || (pose.end - wanted).norm() <= turning_.tolerance;
      const Vec3 axis = turnedAxis(from.pose.axis, to.pose.axis, s);
      if (!isNear || angleBetween(pose.axis, axis) > turning_.angleTolerance) {
        return false;
      }
    }
    return true;
  }

  const Turning& turning_;
  std::vector<TurnedPlace>& places_;
};

}  // namespace

double turnBetween(const Angles& a, const Angles& b) {
  return std::max(std::abs(b[0] - a[0]), std::abs(b[1] - a[1]));
}

Result<std::vector<TurnedPlace>> turnedMove(const Turning& turning,
                                            const TurnedPlace& from,
                                            const ToolPose& to) {
  std::vector<TurnedPlace> places;
  if ((to.axis - from.pose.axis).norm() <= tolerance::symmetric) {
    places.push_back({to, from.angles});
    return places;
  }
  Divider divider(turning, places);
  TurnedPlace start = from;
  // At a pole any turn holds the axis; the one that is left for a side has to be there before.
  const double share =
      std::min(1.0, leavingShare * turning.angleTolerance / angleBetween(from.pose.axis, to.axis));
  const Result<Angles> leaving =
      nextAngles(turning, turnedAxis(from.pose.axis, to.axis, share), from.angles);
  const double cut = turnBetween(from.angles, leaving ? *leaving : from.angles);
  const TurnedPlace turned{from.pose, leaving ? *leaving : from.angles};
  if (cut > leastPoleTurn && holdsAxis(turning, turned)) {
    if (std::optional<Failure> failure = divider.add(from, turned, deepestHalving)) {
      return *std::move(failure);
    }
    start = places.back();
  }
  const Result<Angles> angles = nextAngles(turning, to.axis, start.angles);
  if (!angles) {
    return angles.failure();
  }
  if (std::optional<Failure> failure = divider.add(start, {to, *angles}, deepestHalving)) {
    return *std::move(failure);
  }
  return places;
}

}  // namespace arelem::robot
