#include "app/chord_run.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "ir/space/tolerance.h"

namespace arelem::app {

namespace {
constexpr double wholeTurn = 2.0 * std::numbers::pi;
}

ChordRun::ChordRun(const ClMove& arc, double scale, const ChordAllowed& allowed)
    : allowed_(allowed),
      center_(scale * *arc.center),
      end_(scale * arc.end),
      normal_(arc.normal.normalized()),
      axis_(arc.axis),
      feed_(arc.feed * scale) {
  const Vec3 from = scale * arc.start - center_;
  const Vec3 across = from - from.dot(normal_) * normal_;
  radius_ = across.norm();
  u_ = radius_ > 0.0 ? Vec3(across / radius_) : Vec3(normal_.unitOrthogonal());
  v_ = normal_.cross(u_);
  startHeight_ = from.dot(normal_);
  rise_ = (end_ - center_).dot(normal_) - startHeight_;
  const Vec3 to = end_ - center_;
  sweep_ = std::atan2(to.dot(v_), to.dot(u_));
  if (sweep_ <= allowed.ends / std::max(radius_, allowed.ends)) {
    sweep_ += wholeTurn;  // an end where the arc begins is a whole turn
  }
}

double ChordRun::angleOf(const Vec3& place) const {
  const Vec3 to = place - center_;
  double angle = std::atan2(to.dot(v_), to.dot(u_));
  const double play = allowed_.chords / std::max(radius_, allowed_.chords);
  while (angle < last_ - play) {
    angle += wholeTurn;
  }
  return angle;
}

bool ChordRun::take(const ClMove& line, double scale) {
  const Vec3 place = scale * line.end;
  const bool alike = line.way == cl::Motion::Way::straight && !line.rapid &&
                     (line.axis - axis_).norm() <= tolerance::similarity &&
                     std::abs(line.feed * scale - feed_) <= tolerance::similarity * (1.0 + feed_);
  if (!alike || !(radius_ > 0.0)) {
    return false;
  }
  arrived_ = (place - end_).norm() <= allowed_.ends;
  const double angle = arrived_ ? std::max(sweep_, last_) : angleOf(place);
  const Vec3 to = place - center_;
  const double height = to.dot(normal_);
  const double outward = (to - height * normal_).norm() - radius_;
  const double above = height - startHeight_ - rise_ * angle / sweep_;
  const double sagitta = radius_ * (1.0 - std::cos(std::min(angle - last_, wholeTurn) / 2.0));
  last_ = angle;
  const double play = allowed_.chords / radius_;
  return angle <= sweep_ + play && std::hypot(outward, above) + sagitta <= allowed_.chords;
}

}  // namespace arelem::app
