#include "runtime/motion/stride.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"
#include "runtime/motion/chord.h"
#include "runtime/motion/tried.h"

namespace arelem::motion {

namespace {
/// A chord is taken when it could grow by less than this factor.
constexpr double goodFit = 1.01;
constexpr double safety = 0.9994;
/// Share of the change of curvature over a cut vector by which the next one is planned shorter.
constexpr double doubt = 0.1;
constexpr double mostDoubt = 3e-3;
constexpr int tryLimit = 60;
/// A cut vector up to a corner of the path ends this near to it. Part unit.
constexpr double nearCorner = 1e-8;
constexpr int growLimit = 8;
/// Share of the band that a cut vector behind a corner is planned to use.
constexpr double ridgeShare = 0.85;
/// Corners whose tip leaves the band by less than this factor can be cut off by any length.
constexpr double leastOver = 1.05;
/// One that just ends there is taken when it could grow by less than this factor.
constexpr double ridgeFit = 1.5;
/// Trials are shortened to corners that are nearer than this share of them.
constexpr double mostOfCorner = 0.97;
/// Where the curvature changes by more than this share over a cut vector, or its sign, that is
/// planned by the change.
constexpr double swaying = 0.5;
/// Along facets: how much longer than the last one a cut vector is tried first, and how near the
/// longest that fits and the shortest that does not are brought together.
constexpr double hopeful = 1.15;
constexpr double leap = 1.6;
constexpr double closeEnough = 1.08;
/// Length of the first cut vector along facets that is tried, in bands.
constexpr double firstBands = 200.0;
/// How often one cut vector changes the edge of the band that it aims at.
constexpr int mostTurns = 2;
/// A curvature that only tells the side.
constexpr double leastBend = 1e-12;
/// A cut vector that could grow by more than this factor does not bend as its surfaces do.
constexpr double idle = 2.0;
/// Largest turn of the path over one cut vector, as a cosine.
constexpr double turnCosine = 0.2;
}  // namespace

/// Longest chord that the bands allow by the present curvatures and their trends.
double Stride::planned(const PathPoint& a) {
  double length = path_.flat() ? tolerance::farAway : longest_;
  for (std::size_t i = 0; i < path_.guides.size(); ++i) {
    length = std::min(length, plannedBy(path_.guides[i], a.contacts[i].gap));
  }
  return length;
}

double Stride::plannedBy(Guide& g, double from) {
  const double inner = std::max(g.inner, -from);
  const double outer = std::max(g.outer, from);
  const double middle = g.bend + 0.5 * g.spread * g.trend;
  g.aim = 0;
  const double longest = longestChord(middle, from, g.vertexGap(), inner, outer);
  // The less even the curvature, the less certain its trend.
  const double uneven = std::abs(g.trend) * g.spread / std::max(std::abs(g.bend), levelChange);
  const double share = safety - std::min(doubt * uneven, mostDoubt);
  if (uneven <= swaying) {
    return share * longest;
  }
  // Next to an inflection: towards the edge of the band that is farther.
  double best = 0.0;
  for (const int aim : {1, -1}) {
    const double sway = longestSway(g.bend, g.trend, from, g.edge(aim > 0), inner, outer, g.spread);
    if (sway > best) {
      best = sway;
      g.aim = aim;
    }
  }
  return share * (best > 0.0 ? best : longest);
}

/// The gaps at which a cut vector of that length should end. Where MAXDP alone ends it, it keeps
/// the gaps that it has if the bands allow: one that went aside would be longer for nothing, and a
/// straight way would not end in its last one.
std::array<double, 2> Stride::aimedGaps(const PathPoint& a, double length) const {
  std::array<double, 2> gaps = path_.vertexGaps();
  if (length < longest_ || path_.flat()) {
    return gaps;
  }
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const Guide& g = path_.guides[i];
    const double from = a.contacts[i].gap;
    const double held = std::clamp(from, g.edge(false), g.edge(true));
    if (!g.flat() && longestChord(g.bend, from, held, g.inner, g.outer) >= longest_) {
      gaps[i] = held;
    }
  }
  return gaps;
}

double Stride::accepted() const {
  double accept = tolerance::farAway;
  for (const Guide& g : path_.guides) {
    accept = std::min(accept, Guide::aimShare * (g.inner + g.outer));
  }
  return accept;
}

const PathPoint* Stride::next(const PathPoint& a, double cap) {
  if (!path_.guides[0].field->isFaceted() && !path_.guides[1].field->isFaceted()) {
    return nextAlongCurves(a, cap) ? best_ : nullptr;
  }
  const auto found = nextAlongMesh(a, cap);
  if (!found) {
    return nullptr;
  }
  *best_ = *found;
  return best_;
}

/// In a plane the whole tolerance is seen at once; else, and where that ends, lengths are tried.
std::optional<PathPoint> Stride::nextAlongMesh(const PathPoint& a, double cap) {
  auto seen = facets_.next(a, std::min(cap, longest_));
  if (seen && !facets_.isCutShort()) {
    return seen;
  }
  auto tried = nextAlongFacets(a, cap);
  const bool farther = tried && (!seen || (tried->toolEnd - a.toolEnd).squaredNorm() >
                                              (seen->toolEnd - a.toolEnd).squaredNorm());
  return farther ? tried : seen;
}

/// Which edge of the band the cut vector that failed should have aimed at: where the surface comes
/// too near to its middle the outer one. True where that is not the one it did.
bool Stride::turnAims() {
  bool turned = false;
  for (std::size_t i = 0; i < path_.guides.size(); ++i) {
    Guide& g = path_.guides[i];
    if (path_.misses[i] != 0 && (path_.misses[i] < 0) != (g.bend >= 0.0)) {
      g.startAnew(path_.misses[i] < 0 ? leastBend : -leastBend);
      turned = true;
    }
  }
  return turned;
}

/// Facets bend the path at their borders only, so that the curvature tells little: lengths are
/// tried from that of the last cut vector on, and halved between what fits and what does not.
std::optional<PathPoint> Stride::nextAlongFacets(const PathPoint& a, double cap) {
  const double most = std::min(cap, longest_);
  const double accept = accepted();
  for (Guide& g : path_.guides) {
    if (g.field->isFaceted() && std::abs(g.bend) > leastBend) {
      g.startAnew(std::copysign(leastBend, g.bend));
    }
  }
  double length =
      std::min(most, usual_ > 0.0 ? hopeful * usual_ : firstBands * accept / Guide::aimShare);
  std::optional<PathPoint> best;
  struct {
    double fits = 0.0, fails = tolerance::farAway;
  } tried;
  int turned = 0;       // how often the other edge of the band was aimed at
  bool corner = false;  // the shortest that fails cannot be followed
  for (int i = 0; i < tryLimit && length > tolerance::sameSide; ++i) {
    const PathPoint& b = *trial_;
    const bool followed = path_.step(a, length, path_.vertexGaps(), accept, *trial_) &&
                          b.tangent.dot(a.tangent) >= turnCosine;
    const double factor = followed ? path_.fitWithTurn(a, b) : 0.0;
    if (factor >= 1.0 - tolerance::coincidence) {
      tried.fits = length;
      best = b;
    } else if (followed && !best && turned < mostTurns && (turnAims() | learnTurn(a, b))) {
      ++turned;
      continue;
    } else {
      tried.fails = length;
      corner = !followed;
    }
    if (tried.fits >= most * safety ||
        (best && tried.fails <= (corner ? tried.fits + nearCorner : closeEnough * tried.fits))) {
      break;
    }
    const bool bounded = tried.fails < tolerance::farAway;
    length = !best     ? length * std::clamp(factor * safety, 0.3, 0.85)
             : bounded ? 0.5 * (tried.fits + tried.fails)
                       : std::min(leap * length, most);
  }
  if (tried.fits <= 2.0 * nearCorner) {
    return std::nullopt;
  }
  usual_ = tried.fits;
  return best;
}

/// Length of a cut vector that ends behind the corner which the last trial was seen to cut off, and
/// cuts off as much of it as the band allows; 0 where the trial was too long for another reason.
double Stride::behindRidge(const PathPoint& a) const {
  if (!path_.ridge) {
    return 0.0;
  }
  const auto& ridge = *path_.ridge;
  const Guide& g = path_.guides[ridge.guide];
  const double from = a.contacts[ridge.guide].gap;
  const double to = g.vertexGap();
  const double along = path_.alongRidge(a, to);
  const double over = along * ridge.drop + from - to;
  const double room = ridgeShare * (std::max(g.outer, from) - to);
  return room > 0.0 && over > leastOver * room ? along * over / (over - room) : 0.0;
}

/// Lengths that were tried for one cut vector, and the next one.
struct Stride::Trials {
  Tried tried;
  double length = 0.0;
  int count = 0;
  bool looked = false;   ///< at the curvature of a trial
  bool toRidge = false;  ///< the trial ends behind a corner that it cuts off
};

/// The length to try after one that leaves its band at `b`. Past an inflection the surface bends
/// the other way than it did: aims at the other edge of the band before shortening the chord.
void Stride::shorten(Trials& t, double factor, double cap, const PathPoint& a, const PathPoint& b) {
  const bool turns = !t.looked && (learnTurn(a, b) | learnSwerve());
  const double behind = behindRidge(a);
  const double shorter = t.tried.shorter(t.length, factor, t.count);
  t.toRidge = behind > t.tried.fits() && behind < mostOfCorner * t.length;
  if (t.toRidge) {
    t.length = behind;
  } else if (turns) {
    t.length = std::min({planned(a), cap, t.length});
    t.tried = {};
  } else {
    t.length = shorter;
  }
}

bool Stride::nextAlongCurves(const PathPoint& a, double cap) {
  if (longestAlongCurves(a, cap)) {
    return true;
  }
  bool turned = false;
  // Behind a corner the path may not lead from one edge of the band to the other: it keeps to that
  // which it is at.
  for (std::size_t i = 0; i < path_.guides.size(); ++i) {
    Guide& g = path_.guides[i];
    const bool outwards = 2.0 * a.contacts[i].gap > g.outer - g.inner;
    if (!g.flat() && !g.field->isFaceted() && (g.bend >= 0.0) != outwards) {
      g.startAnew(outwards ? leastBend : -leastBend);
      turned = true;
    }
  }
  return turned && longestAlongCurves(a, cap);
}

bool Stride::longestAlongCurves(const PathPoint& a, double cap) {
  Trials t;
  t.length = std::min(planned(a), cap);
  const double accept = accepted();
  double best = 0.0;       // how far a cut vector reaches that fits, if any
  bool triedMore = false;  // longer ones than that
  int grown = 0;
  bool corner = false;  // lengths fail because the path cannot be followed so far
  for (; t.count < tryLimit && t.length > tolerance::sameSide; ++t.count) {
    const PathPoint& b = *trial_;
    if (!path_.step(a, t.length, aimedGaps(a, t.length), accept, *trial_) ||
        b.tangent.dot(a.tangent) < turnCosine) {
      t.length = t.tried.shorter(t.length);
      corner = true;
      if (best > 0.0 && t.tried.fails() - t.tried.fits() <= nearCorner) {
        break;
      }
      continue;
    }
    const double factor = path_.fitWithTurn(a, b);
    if (factor < 1.0 - tolerance::coincidence) {
      shorten(t, factor, cap, a, b);
      t.looked = true;
      corner = false;
      if (best > 0.0 && (++grown > growLimit || t.tried.isNarrow())) {
        break;
      }
      continue;
    }
    t.looked = true;
    const double reached = (b.toolEnd - a.toolEnd).norm();
    if (reached > longest_ * (1.0 + tolerance::coincidence) && !path_.flat()) {
      t.length *= longest_ / reached;  // the surfaces led aside
      continue;
    }
    // What ends by MAXDP and not by the band.
    const double kept = factor > idle && t.length >= longest_ ? keptShare_.of(path_, a, b) : 1.0;
    if (kept < 1.0) {
      t.length = t.tried.shorter(t.length, kept, t.count);
      continue;
    }
    const bool better = reached > best;
    if (better) {
      std::swap(trial_, best_);
      best = reached;
    }
    if (!better || factor < (t.toRidge ? ridgeFit : goodFit) || t.length >= cap * safety ||
        t.length >= longest_ || (++grown > growLimit && !corner)) {
      break;
    }
    middle_ = path_.middle;
    triedMore = true;
    t.length = std::min({t.tried.longer(t.length, factor), cap, longest_});
  }
  return best > 0.0 && takeBest(a, triedMore);
}

/// Beside a corner a cut vector may change its gap, but does not get on: false there.
bool Stride::takeBest(const PathPoint& a, bool triedMore) {
  if ((best_->toolEnd - a.toolEnd).dot(a.tangent) <= 2.0 * nearCorner) {
    return false;
  }
  if (triedMore && middle_.end == best_->toolEnd) {
    path_.middle = middle_;
  }
  return true;
}

}  // namespace arelem::motion
