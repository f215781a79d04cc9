#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "ir/space/tolerance.h"
#include "runtime/geometry/least.h"
#include "runtime/motion/check_watch.h"

/// Where a path comes nearest to a check surface that it does not meet: for messages.
namespace arelem::motion {

namespace {
/// Normals with this cosine or a greater one are those of surfaces that are parallel.
constexpr double parallelCosine = 0.99;
}  // namespace

/// Between the neighbors of each look that is nearer than they are.
void CheckWatch::findNearest(const Segment& s, Field& guide) {
  looks_.push_back(s.length);
  const std::vector<double> looks = std::exchange(looks_, {});
  if (tangent_) {
    findParallel(s, looks, guide);
  }
  const auto away = [&](double u) {
    return tangent_ ? missOfTangency(s, u, guide) : std::abs(measure(s, u).value);
  };
  std::vector<double> at;
  for (const double u : looks) {
    at.push_back(away(u));
  }
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const std::size_t before = i > 0 ? i - 1 : 0;
    const std::size_t behind = std::min(i + 1, looks.size() - 1);
    const bool least = at[i] <= at[before] && at[i] <= at[behind] && at[i] < tolerance::farAway;
    if (least && at[i] <= nearest() + looks[behind] - looks[before]) {
      geometry::narrowLeast(away, looks[before], looks[behind], [&](double value, double width) {
        return width > tolerance::sameSide && value <= nearest() + steepest(s) * width;
      });
    }
  }
  looks_.clear();
}

/// Where the gap along the path neither opens nor closes check surface and guide are parallel.
void CheckWatch::findParallel(const Segment& s, const std::vector<double>& looks, Field& guide) {
  for (Field* field : {plus_.get(), minus_.get()}) {
    const auto slope = [&](double u) {
      const tool::Contact c = field->at(s.at(u), s.axisAt(u));
      return slopeAlong(c, s.at(u), wayAt(s, u, guide), s.spin());
    };
    const auto opens = [&](double u) -> bool { return slope(u) > 0.0; };
    bool second = opens(looks.front());
    for (std::size_t i = 0; i + 1 < looks.size(); ++i) {
      double low = looks[i];
      double high = looks[i + 1];
      const bool first = std::exchange(second, opens(high));
      if (first == second) {
        continue;
      }
      while (high - low > tolerance::sameSide) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) {
          break;
        }
        (opens(middle) == first ? low : high) = middle;
      }
      // Where the slope jumps the contact does: they are not parallel.
      if (std::min(std::abs(slope(low)), std::abs(slope(high))) > tolerance::nullDirection) {
        continue;
      }
      const Vec3 place = s.at(low);
      const tool::Contact c = field->at(place, s.axisAt(low));
      const tool::Contact g = guide.at(place, s.axisAt(low));
      if (c.normal.dot(g.normal) <= agreeing) {
        continue;
      }
      // A tool between two surfaces that face each other is not what touches: these are as far
      // apart as the place on the guide is from the check surface, which is parallel there. Where
      // they do touch the tool does not fit, and its own gap tells.
      const Vec3 on =
          guide.flat() ? Vec3(place - (place - g.point).dot(g.normal) * g.normal) : g.point;
      const surface::Foot foot = footOn(surface_.surface, on);
      const double apart =
          foot.normal.dot(g.normal) < 0.0 ? std::abs(foot.distance) : foot.distance;
      const bool counts = std::abs(foot.normal.dot(g.normal)) > parallelCosine &&
                          std::abs(apart) > band_ && std::abs(apart) < std::abs(c.gap);
      const double gap = counts ? apart : c.gap;
      if (!parallel_ || std::abs(gap) < std::abs(parallel_->gap)) {
        parallel_ = {gap, place};
      }
    }
  }
}

/// The smaller gap of those whose contact agrees with that of the guide; of all where none ever
/// did.
double CheckWatch::missOfTangency(const Segment& s, double u, Field& guide) {
  const Vec3 at = s.at(u);
  const Vec3 axis = s.axisAt(u);
  const Vec3 guideNormal = guide.at(at, axis).normal;
  double miss = tolerance::farAway;
  double other = tolerance::farAway;
  for (Field* field : {plus_.get(), minus_.get()}) {
    const tool::Contact c = field->at(at, axis);
    const bool agrees = c.normal.dot(guideNormal) > agreeing;
    double& least = agrees ? miss : other;
    least = std::min(least, std::abs(c.gap));
    (agrees ? nearestFacing_ : nearest_).take(c.gap, at);
  }
  return nearestFacing_.distance < tolerance::farAway ? miss : other;
}

}  // namespace arelem::motion
