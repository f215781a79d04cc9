#include "runtime/path/point_records.h"

namespace arelem::path {

void putPoints(cl::RecordSink& next,
               const cl::Record& like,
               std::span<const Vec3> points,
               const Vec3& axis) {
  if (points.empty()) {
    return;
  }
  cl::Record record = like;
  auto& motion = std::get<cl::Motion>(record.body);
  motion.kind = cl::Motion::Kind::go;
  motion.coordinates.clear();
  for (const Vec3& p : points) {
    if (motion.coordinates.size() + motion.stride() > numbersPerRecord) {
      next.accept(record);
      motion.coordinates.clear();
      motion.kind = cl::Motion::Kind::continuation;
    }
    motion.coordinates.insert(motion.coordinates.end(), {p.x(), p.y(), p.z()});
    if (motion.withAxis) {
      motion.coordinates.insert(motion.coordinates.end(), {axis.x(), axis.y(), axis.z()});
    }
  }
  next.accept(record);
}

}  // namespace arelem::path
