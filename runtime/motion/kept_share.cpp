#include "runtime/motion/kept_share.h"

#include <algorithm>

#include "runtime/certify/prove.h"

namespace arelem::motion {

namespace {
/// Places that are looked at, and of those up to the first that leaves its band by how many the cut
/// vector is made shorter.
constexpr int places = 32;
constexpr double before = 0.5;
/// Where it is like the last one, every fourth of them, for so many cut vectors in a row; the
/// cosine of contact normals that are alike.
constexpr int fewer = 4, mostInARow = 8;
constexpr double alike = 1.0 - 2e-6;
}  // namespace

bool KeptShare::isLikeLast(const PathPoint& a, const PathPoint& b) const {
  for (std::size_t i = 0; i < last_.size(); ++i) {
    if (last_[i].dot(a.contacts[i].normal) < alike ||
        a.contacts[i].normal.dot(b.contacts[i].normal) < alike) {
      return false;
    }
  }
  return true;
}

double KeptShare::of(Path& path, const PathPoint& a, const PathPoint& b) {
  const bool looksLess = fewer_ < mostInARow && isLikeLast(a, b);
  double kept = looksLess ? firstOff(path, a, b, fewer) : 0.0;
  fewer_ = kept < 1.0 ? 0 : fewer_ + 1;
  if (kept < 1.0) {
    kept = firstOff(path, a, b, 1);
  }
  last_ = {Vec3::Zero(), Vec3::Zero()};
  if (kept == 1.0) {
    last_ = {a.contacts[0].normal, a.contacts[1].normal};
  }
  return kept;
}

double KeptShare::firstOff(Path& path, const PathPoint& a, const PathPoint& b, int by) {
  const certify::Chord chord(a.toolEnd, b.toolEnd, a.axis, b.axis);
  for (int k = by; k < places; k += by) {
    const double share = static_cast<double>(k) / places;
    const Vec3 axis = chord.axis(share);
    for (std::size_t i = 0; i < path.guides.size(); ++i) {
      const Guide& g = path.guides[i];
      if (g.field->isFaceted() || (g.field->isEven() && !g.turning)) {
        continue;
      }
      // A start outside its band by the slack allowed there must not stop the motion.
      const double inner = std::max({g.inner, -a.contacts[i].gap, -b.contacts[i].gap});
      const double outer = std::max({g.outer, a.contacts[i].gap, b.contacts[i].gap});
      const double slack = certify::slackOf(inner + outer);
      const double gap = g.field->at(chord.toolEnd(share), axis).gap;
      if (gap < -inner - slack || gap > outer + slack) {
        return (k - before) / places;
      }
    }
  }
  return 1.0;
}

}  // namespace arelem::motion
