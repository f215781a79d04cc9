#include "backend/robot/turned_move.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "ir/diag/ngc.h"
#include "ir/space/tolerance.h"

namespace arelem::robot {

namespace {

constexpr int deepestHalving = 14;
constexpr std::array samples = {0.25, 0.5, 0.75};
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
    const double swing =
        std::max(std::abs(to.angles[0] - from.angles[0]), std::abs(to.angles[1] - from.angles[1]));
    if (depth == 0) {
      return fail(diag::TurningJump, from.pose.end.x(), from.pose.end.y(), from.pose.end.z(),
                  swing);
    }
    TurnedPlace middle{
        {0.5 * (from.pose.end + to.pose.end), turnedAxis(from.pose.axis, to.pose.axis, 0.5)}, {}};
    const Result<Angles> angles = nextAngles(turning_, middle.pose.axis, from.angles);
    if (!angles) {
      return angles.failure();
    }
    middle.angles = *angles;
    if (std::optional<Failure> failure = add(from, middle, depth - 1)) {
      return failure;
    }
    // The second half begins with the angles in which the first one ended.
    TurnedPlace end = to;
    const Result<Angles> last = nextAngles(turning_, to.pose.axis, places_.back().angles);
    if (!last) {
      return last.failure();
    }
    end.angles = *last;
    return add(TurnedPlace(places_.back()), end, depth - 1);
  }

 private:
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

Result<std::vector<TurnedPlace>> turnedMove(const Turning& turning,
                                            const TurnedPlace& from,
                                            const ToolPose& to) {
  std::vector<TurnedPlace> places;
  if ((to.axis - from.pose.axis).norm() <= tolerance::symmetric) {
    places.push_back({to, from.angles});
    return places;
  }
  const Result<Angles> angles = nextAngles(turning, to.axis, from.angles);
  if (!angles) {
    return angles.failure();
  }
  Divider divider(turning, places);
  if (std::optional<Failure> failure = divider.add(from, {to, *angles}, deepestHalving)) {
    return *std::move(failure);
  }
  return places;
}

}  // namespace arelem::robot
