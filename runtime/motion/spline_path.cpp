#include "runtime/motion/spline_path.h"

#include "ir/diag/motion.h"
#include "runtime/spline/cubic.h"

namespace arelem::motion {

Result<std::vector<Vec3>> alongSpline(const Entity& curve, double band) {
  if (!(band > 0.0)) {
    return fail(diag::NoBand,
                curve.name.empty() ? std::string_view("(SPLINE)") : std::string_view(curve.name));
  }
  auto spline = spline::CubicSpline::of(curve.canon);
  if (!spline) {
    return spline.takeFailure();
  }
  return spline::chordPoints(*spline, band);
}

void putSpline(RecordWriter& writer,
               const Entity& curve,
               const std::vector<Vec3>& path,
               const Vec3& axis,
               bool withAxis) {
  cl::Surface record;
  record.surface = {curve.type, curve.name, curve.subscript, curve.canon};
  writer.put(std::move(record));
  writer.startPoints(cl::Motion::Kind::go, curve.name, curve.subscript, withAxis);
  for (std::size_t i = 1; i < path.size(); ++i) {
    writer.add(path[i], axis);
  }
  writer.finishPoints();
}

double lengthOf(const std::vector<Vec3>& path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    length += (path[i] - path[i - 1]).norm();
  }
  return length;
}

}  // namespace arelem::motion
