#include "runtime/motion/kept_share.h"

#include <algorithm>

#include "runtime/certify/prove.h"

namespace arelem::motion {

namespace {
/// Places that are looked at, and of those up to the first that leaves its band by how many the cut
/// vector is made shorter.
constexpr int places = 32;
constexpr double before = 0.5;
}  // namespace

double keptShare(Path& path, const PathPoint& a, const PathPoint& b) {
  const certify::Chord chord(a.toolEnd, b.toolEnd, a.axis, b.axis);
  for (int k = 1; k < places; ++k) {
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
