#include "runtime/motion/missed.h"

#include <cmath>

#include "ir/diag/motion.h"
#include "ir/space/tolerance.h"
#include "runtime/certify/motion_check.h"

namespace arelem::motion {

Failure missed(const Course& course) {
  const CheckWatch& w = course.watches.front();
  const Vec3& p = w.nearestPlace();
  if (w.isTangent()) {
    const std::string& partner = w.usesPart() ? course.part.name : course.drive.name;
    const double gap = w.parallel() ? w.parallel()->gap : w.nearest();
    const Vec3& where = w.parallel() ? w.parallel()->place : p;
    return fail(diag::NoTangency, partner, w.surface().name, w.band(),
                gap < 0.0 ? "overlap" : "miss each other", std::abs(gap), where.x(), where.y(),
                where.z());
  }
  const std::string_view condition = certify::spell(w.condition());
  if (!w.wasClear() && w.nearest() <= w.band()) {
    return fail(diag::CheckNeverLeft, w.surface().name, condition, w.band());
  }
  if (w.touchedAny()) {
    const Vec3& last = w.lastContact();
    return fail(diag::CheckMetTooSeldom, w.met(), w.nth(), condition, w.surface().name, last.x(),
                last.y(), last.z());
  }
  Failure never =
      fail(diag::CheckNotReached, w.surface().name, condition, w.nearest(), p.x(), p.y(), p.z());
  if ((p - course.start.toolEnd).norm() <= tolerance::coincidence) {
    return std::move(never).withHelp("the tool moves away from it from the start on");
  }
  return never;
}

}  // namespace arelem::motion
