#include "runtime/motion/arc_route.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace arelem::motion {

namespace {
constexpr double quarterTurn = std::numbers::pi / 2.0;
}

ArcRoute::ArcRoute(Course& course) : course_(course) {
  const auto& circle = std::get<surface::Cylinder>(course.drive.surface);
  const PathPoint& start = course.start;
  center_ = circle.point.head<2>();
  const Eigen::Vector2d from = start.toolEnd.head<2>() - center_;
  startRadius_ = from.norm();
  startAngle_ = std::atan2(from.y(), from.x());
  outward_ = start.contacts[1].normal.head<2>().dot(from) < 0.0 ? -1.0 : 1.0;
  radius_ = startRadius_ + outward_ * (course.driveGuide().rest - start.contacts[1].gap);
  sense_ = from.x() * start.tangent.y() - from.y() * start.tangent.x() < 0.0 ? -1.0 : 1.0;
  // Height of the tool end on the part plane: slope . (x, y) + height.
  const tool::Contact& part = start.contacts[0];
  partSlope_ = -part.normal.head<2>() / part.normal.z();
  partHeight_ = start.toolEnd.z() - part.gap / part.normal.z() -
                partSlope_.dot(Eigen::Vector2d(start.toolEnd.head<2>()));
}

Segment ArcRoute::piece(double along, double length) const {
  const double angle = startAngle_ + sense_ * along / radius_;
  const Eigen::Vector2d out(std::cos(angle), std::sin(angle));
  Segment s;
  s.from = onPart(center_ + radius_ * out);
  s.direction = sense_ * alongPart({-out.y(), out.x()});
  s.length = length;
  s.curvature = sense_ / radius_;
  s.toCenter = -radius_ * alongPart(out);
  s.tangentFrom = s.direction;
  s.tangentTo = s.tangentAt(length);
  s.axisFrom = s.axisTo = course_.start.axis;
  return s;
}

std::optional<Found> ArcRoute::findStop(StopFinder& stops, double turns) {
  const double length = quarterTurn * radius_;
  PathPoint at = course_.start;
  for (int i = 0; i < static_cast<int>(4.0 * turns); ++i) {
    const Segment segment = piece(i * length, length);
    at.toolEnd = segment.from;
    at.tangent = segment.direction;
    if (auto found = stops.find(at, segment)) {
      found_ = i * length + 0.5 * (found->met.hit.low + found->met.hit.high);
      return found;
    }
  }
  return stops.beginForFirstZero() ? findStop(stops, turns) : std::nullopt;
}

ArcPlan ArcRoute::plan(const PathPoint& end) const {
  const double roughly = sense_ * found_ / radius_;
  const Eigen::Vector2d to = end.toolEnd.head<2>() - center_;
  const double angle = std::atan2(to.y(), to.x()) - startAngle_;
  const double turn = 2.0 * std::numbers::pi;
  const double total = angle + turn * std::round((roughly - angle) / turn);
  // How much of the band, counted from its small radius, lies below the start: less than nothing,
  // or more than all of it, where the start is outside, as it may be a little.
  const Guide& drive = course_.driveGuide();
  const double gap = course_.start.contacts[1].gap;
  const double band = drive.inner + drive.outer;
  const double below = outward_ > 0.0 ? gap + drive.inner : drive.outer - gap;
  ArcPlan plan;
  plan.radius = startRadius_ + band - below;
  plan.driveGap = gap + outward_ * (plan.radius - startRadius_);
  const double small = std::max(startRadius_ - below, 0.0);
  const double limit = std::acos(std::min(small / plan.radius, 1.0));
  double steps = limit > 0.0 ? std::floor(std::abs(total) / limit) + 1.0 : 2.0;
  steps = std::max(2.0, 2.0 * std::ceil(steps / 2.0));
  plan.halfSteps = static_cast<std::uint64_t>(steps);
  plan.halfStep = total / steps;
  return plan;
}

}  // namespace arelem::motion
