#include "runtime/motion/arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace arelem::motion {

Vec3 ArcPlan::vertex(std::uint64_t k) const {
  const double angle = startAngle + static_cast<double>(k) * halfStep;
  return {centerX + radius * std::cos(angle), centerY + radius * std::sin(angle), z};
}

Vec3 ArcPlan::tangent(std::uint64_t k) const {
  const double angle = startAngle + static_cast<double>(k) * halfStep;
  const double sense = halfStep < 0.0 ? -1.0 : 1.0;
  return {-sense * std::sin(angle), sense * std::cos(angle), 0.0};
}

ArcPlan planArc(const surface::Cylinder& circle,
                const std::vector<Vec3>& walked,
                const tool::Contact& start,
                double inner,
                double outer) {
  ArcPlan plan;
  plan.centerX = circle.point.x();
  plan.centerY = circle.point.y();
  plan.z = walked.front().z();
  double total = 0.0;
  for (std::size_t i = 1; i < walked.size(); ++i) {
    const double ax = walked[i - 1].x() - plan.centerX;
    const double ay = walked[i - 1].y() - plan.centerY;
    const double bx = walked[i].x() - plan.centerX;
    const double by = walked[i].y() - plan.centerY;
    total += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
  }
  const double x = walked.front().x() - plan.centerX;
  const double y = walked.front().y() - plan.centerY;
  const double rho = std::hypot(x, y);
  plan.startAngle = std::atan2(y, x);
  // Share of the band, counted from its small radius, that lies below the start.
  const bool outside = start.normal.x() * x + start.normal.y() * y > 0.0;
  const double band = inner + outer;
  const double share =
      std::clamp(outside ? (start.gap + inner) / band : (outer - start.gap) / band, 0.0, 1.0);
  plan.radius = rho + band * (1.0 - share);
  const double small = std::max(rho - band * share, 0.0);
  const double limit = std::acos(std::min(small / plan.radius, 1.0));
  double steps = limit > 0.0 ? std::floor(std::abs(total) / limit) + 1.0 : 2.0;
  steps = std::max(2.0, 2.0 * std::ceil(steps / 2.0));
  plan.halfSteps = static_cast<std::uint64_t>(steps);
  plan.halfStep = total / steps;
  return plan;
}

}  // namespace arelem::motion
