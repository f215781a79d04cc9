#include "runtime/certify/path_end.h"

#include <algorithm>

#include "ir/space/tolerance.h"

namespace arelem::certify {

namespace {
/// Locations that a path's end remembers: it is looked there for where the tool came from.
constexpr std::size_t remembered = 16;
}  // namespace

void PathEnd::moveTo(const Location& next) {
  const Chord stretch(from_.toolEnd, next.toolEnd, from_.axis, next.axis);
  const bool tells = stretch.length() > band_;
  if (tells || !known_) {
    stretch_ = stretch;
  }
  if (tells) {
    from_ = next;
    known_ = true;
  }
  place_ = next;
  if (recent_.size() == remembered) {
    recent_.erase(recent_.begin());
  }
  recent_.push_back(next);
}

Vec3 PathEnd::directionOf(const Vec3& velocity) {
  const double length = velocity.norm();
  return length > tolerance::sameSide ? Vec3(velocity / length) : Vec3(Vec3::Zero());
}

/// Along the normals the tool end goes as far back as the turn takes the contacts forward.
Vec3 PathEnd::velocity(const Touch& drive, const Touch& part) const {
  const Vec3& step = stretch_.step();
  const Vec3 line = drive.normal.cross(part.normal);
  const double squared = line.squaredNorm();
  if (squared == 0.0) {
    return step;
  }
  const auto backwards = [&](const Touch& t) {
    return -t.normal.dot(stretch_.velocity(t.offset) - step);
  };
  return (line.dot(step) * line + backwards(drive) * part.normal.cross(line) +
          backwards(part) * line.cross(drive.normal)) /
         squared;
}

Location PathEnd::ahead(double way, const Touch& drive, const Touch& part) const {
  const Vec3 v = velocity(drive, part);
  const double time = v.norm() > tolerance::sameSide ? way / v.norm() : 0.0;
  return {place_.toolEnd + time * v, stretch_.axis(1.0 + time)};
}

}  // namespace arelem::certify
