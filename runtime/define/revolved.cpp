// REVOLV: a curve turned about an axis.
#include <cmath>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"
#include "runtime/define/resolve.h"

namespace arelem::define {

Result<Resolved> revolvedSurface(const Arguments& given) {
  const Vec3 axis = given.arrow(2);
  if (!(axis.norm() > tolerance::nullDirection)) {
    return fail(diag::NullDirection, "the axis", axis.cwiseAbs().maxCoeff(),
                tolerance::nullDirection);
  }
  const double start = given.count() > 3 ? given.scalar(3) : 0.0;
  const double stop = given.count() > 3 ? given.scalar(4) : 360.0;
  if (!(stop > start) || stop - start > 360.0) {
    return fail(diag::BadRange, "the last angle", stop,
                fmt::format("above {:.9g} and at most {:.9g}", start, start + 360.0));
  }
  const Vec3 place = given.point(1);
  const Vec3 unit = axis.normalized();
  geometry::Canon canon = {place.x(), place.y(), place.z(), unit.x(),
                           unit.y(),  unit.z(),  start,     stop};
  const geometry::Canon& curve = given.entity(0).canon;
  canon.insert(canon.end(), curve.begin(), curve.end());
  return Resolved(std::move(canon));
}

}  // namespace arelem::define
