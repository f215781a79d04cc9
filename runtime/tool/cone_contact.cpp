#include "runtime/tool/cone_contact.h"

#include <cmath>

#include "runtime/tool/rounded.h"
#include "runtime/tool/small_turn.h"

namespace arelem::tool {

namespace {
/// Within the cone by more than this share of the corner's radius its axis is near, where normals
/// of all sides meet.
constexpr double deepest = 0.1;
/// Steps of Newton; where they do not do the search that knows no cone does better.
constexpr int limit = 4;
/// What the gap may be off where the last step is not looked at. Part unit.
constexpr double unseenStep = 1e-11;
/// Turns about the axis up to which places near the last contact are looked at. Radians.
constexpr double largestTurn = 0.3;
/// Sine of the lean of the normal towards the tool axis from which on the rim, not the bottom, is
/// nearest, and the least curvature along the circle by which Newton's last step is trusted.
constexpr double leastPull = 1e-6, leastCurvature = 0.02;
/// By which a cutter may reach beyond the plane of its contact, as a share of its corner's radius.
constexpr double slack = 1e-9;
/// Squares of ways up to which a change on them is rounding. Part unit.
constexpr double noWay = 1e-24;

/// The circle of the corner's center about the tool axis, seen from the tip of a cone.
class Circle {
 public:
  struct Place {
    bool good = false;       ///< beside the cone and before its tip, with the normal
                             ///< against the cutter
    double angle = 0.0;      ///< Newton's next turn about the tool axis
    double bent = 0.0;       ///< the curvature of the distance along the circle, by its radius
    double beforeTip = 0.0;  ///< how far from where the tip is nearest
    double distance = 0.0;   ///< from the cone, and its normal, and by that turn
    Vec3 normal = Vec3::UnitZ(), turning = Vec3::Zero();
    Vec3 turns = Vec3::Zero();  ///< how the nearest place turns by the way of the tool
  };

  /// `toolEnd` and the cone's axis `a` in the frame of the tool.
  Circle(const surface::Cone& s, const Profile& cutter, const Vec3& toolEnd, const Vec3& a)
      : cone_(s), a_(a), radius_(cutter.e), least_(cutter.r * s.cosHalf) {
    const Vec3 center(toolEnd.x(), toolEnd.y(), toolEnd.z() + cutter.f);
    along_ = center.dot(a);
    radial_ = center - along_ * a;
  }

  [[nodiscard]] Place at(double c, double t) const {
    Place p;
    // Along the direction (c, t) and the tangent (-t, c).
    const double axisOut = c * a_.x() + t * a_.y();
    const double axisOn = c * a_.y() - t * a_.x();
    const double along = along_ + radius_ * axisOut;
    const double lean = radius_ * axisOut;
    const Vec3 radial(radial_.x() + radius_ * c - lean * a_.x(),
                      radial_.y() + radius_ * t - lean * a_.y(), radial_.z() - lean * a_.z());
    const double squared = radial.squaredNorm();
    const double rho = std::sqrt(squared);
    const double oneOver = 1.0 / squared;
    const double out = c * radial.x() + t * radial.y();
    const double on = c * radial.y() - t * radial.x();
    const Vec3 around = a_.cross(radial);
    const double aroundOn = c * around.y() - t * around.x();
    p.beforeTip = along * cone_.cosHalf + rho * cone_.sinHalf;
    if (!(rho > least_) || p.beforeTip < 0.0) {
      return p;
    }
    const double over = cone_.cosHalf * rho * oneOver;
    const double slope = over * on - cone_.sinHalf * axisOn;
    const double pull = cone_.sinHalf * axisOut - over * out;
    const double bend = over * oneOver * aroundOn;
    p.bent = radius_ * bend * aroundOn;
    const double curvature = p.bent + pull;
    const double distance = rho * cone_.cosHalf - along * cone_.sinHalf;
    p.good = pull > leastPull && curvature > leastCurvature && distance > -deepest * radius_;
    const double flat = 1.0 / curvature;
    p.angle = -slope * flat;
    p.distance = distance + 0.5 * radius_ * p.angle * slope;
    p.normal = over * radial - cone_.sinHalf * a_;
    p.turning = radius_ * bend * around;
    p.turns = -bend * flat * around;
    return p;
  }

 private:
  const surface::Cone& cone_;
  const Vec3& a_;
  double radius_;
  double least_;  ///< distance from the cone's axis at which the corner's ball reaches it
  double along_ = 0.0;
  Vec3 radial_ = Vec3::Zero();
};
}  // namespace

/// The direction of the contact, about the axis; false where that is too far.
bool ConeSearch::turnBy(double angle) {
  if (!(std::abs(angle) <= largestTurn)) {
    return false;
  }
  const Turn t(angle);
  const double cosine = t.cosine * cosine_ - t.sine * sine_;
  sine_ = t.cosine * sine_ + t.sine * cosine_;
  cosine_ = cosine;
  return true;
}

/// How the contact turns as the tool goes on, and how that changes on the way.
void ConeSearch::noteTurns(const Vec3& here, const Vec3& way, const Vec3& turns) {
  const double squared = way.squaredNorm();
  if (squared > noWay) {
    along_ = way;
    change_ = turnsKnown_ ? Vec3(1.0 / squared * (turns - turns_)) : Vec3(Vec3::Zero());
  }
  at_ = here;
  turns_ = turns;
  turnsKnown_ = true;
}

void ConeSearch::goOn(const surface::Cone& s,
                      const Profile& cutter,
                      const Vec3& te,
                      const Vec3& axis,
                      const Contact& found) {
  known_ = false;
  if (!isRounded(cutter) || cutter.e <= 0.0) {
    return;
  }
  const Vec3 center = found.point + cutter.r * found.normal - te - cutter.f * axis;
  const double aside = center.dot(axis);
  const Vec3 toward = center - aside * axis;
  const double radius = toward.norm();
  const double near = slack * (1.0 + cutter.e);
  if (std::abs(aside) > near || std::abs(radius - cutter.e) > near) {
    return;
  }
  axis_ = axis;
  first_ = toward / radius;
  second_ = axis.cross(first_);
  cosine_ = 1.0;
  sine_ = 0.0;
  const auto inFrame = [&](const Vec3& v) {
    return Vec3(first_.dot(v), second_.dot(v), axis_.dot(v));
  };
  coneAxis_ = inFrame(s.axis);
  at_ = inFrame(te - s.vertex);
  turns_ = along_ = change_ = Vec3::Zero();
  turnsKnown_ = false;
  known_ = true;
}

/// In one piece: two of them are asked for by each cut vector.
[[gnu::flatten]] std::optional<Contact> ConeSearch::contact(const surface::Cone& s,
                                                            const Profile& cutter,
                                                            const Vec3& te,
                                                            const Vec3& axis) {
  if (!known_ || axis != axis_) {
    return std::nullopt;
  }
  const Vec3 fromTip = te - s.vertex;
  const Vec3 here(first_.dot(fromTip), second_.dot(fromTip), axis_.dot(fromTip));
  const Vec3 way = here - at_;
  double angle = turns_.dot(way) + 0.5 * way.dot(along_) * change_.dot(way);
  const Circle circle(s, cutter, here, coneAxis_);
  for (int i = 0; i < limit && turnBy(angle); ++i) {
    const Circle::Place p = circle.at(cosine_, sine_);
    if (!p.good) {
      break;
    }
    angle = p.angle;
    const double steps = std::abs(angle) * (1.0 + p.bent);
    if (cutter.e * steps * steps * std::abs(angle) > unseenStep ||
        cutter.e * std::abs(angle) > p.beforeTip) {
      continue;
    }
    // So small a turn is its tangent; lengths of the direction drift by rounding too.
    const double c = cosine_ - angle * sine_;
    const double t = sine_ + angle * cosine_;
    const double length = 1.5 - 0.5 * (c * c + t * t);
    cosine_ = length * c;
    sine_ = length * t;
    const Vec3 n = unitOf(p.normal + angle * p.turning);
    const double against = slack - (cosine_ * n.x() + sine_ * n.y());
    if (n.z() < cutter.sinBeta || n.z() > cutter.cosAlpha ||
        against * against < n.x() * n.x() + n.y() * n.y()) {
      break;
    }
    noteTurns(here, way, p.turns);
    const Vec3 inSpace = n.x() * first_ + n.y() * second_ + n.z() * axis_;
    return Contact{p.distance - cutter.r, inSpace,
                   te + cutter.e * toward() + cutter.f * axis_ - cutter.r * inSpace};
  }
  return std::nullopt;
}

}  // namespace arelem::tool
