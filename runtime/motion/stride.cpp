#include "runtime/motion/stride.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ir/space/tolerance.h"

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
constexpr double ridgeShare = 0.9;
/// One that just ends there is taken when it could grow by less than this factor.
constexpr double ridgeFit = 1.5;
/// Trials are shortened to corners that are nearer than this share of them.
constexpr double mostOfCorner = 0.97;
/// Trials after which lengths that do not fit are halved.
constexpr int patience = 5;
/// Lengths grow by at most this factor at first, then by its square and so on.
constexpr double mostLonger = 3.0;
/// A slope that changes by less over a cut vector does not change: a plane seen by a tool that
/// turns.
constexpr double levelChange = 1e-11;
/// Largest change of curvature over a cut vector that is expected of the next, as a share of it.
constexpr double mostTrend = 0.5;
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
/// Largest turn of the path over one cut vector, as a cosine.
constexpr double turnCosine = 0.2;
}  // namespace

/// Longest chord that the bands allow by the present curvature and its trend.
double Stride::planned(const PathPoint& a) const {
  double length = path_.flat() ? tolerance::farAway : longest_;
  for (std::size_t i = 0; i < path_.guides.size(); ++i) {
    const Guide& g = path_.guides[i];
    const double from = a.contacts[i].gap;
    const double middle = g.bend + 0.5 * g.spread * g.trend;
    const double longest = longestChord(middle, from, g.vertexGap(), std::max(g.inner, -from),
                                        std::max(g.outer, from));
    // The less even the curvature, the less certain its trend.
    const double uneven = std::abs(g.trend) * g.spread / std::max(std::abs(g.bend), levelChange);
    length = std::min(length, (safety - std::min(doubt * uneven, mostDoubt)) * longest);
  }
  return length;
}

namespace {
/// Lengths of a cut vector that were tried. The root of what is used of the band is taken for a
/// linear function of the length: over even curvature it grows from zero, behind an even stretch
/// from the length up to there.
class Tried {
 public:
  /// The length to try after one that was too long by `factor`, which is below 1. Where that
  /// converges slowly (the gap does not bend evenly) lengths are halved until one fits.
  [[nodiscard]] double shorter(double length, double factor, int times) {
    note({length, 1.0 / std::max(factor, leastFactor)});
    if (fits_.length > 0.0) {
      return between();
    }
    const double line = isKnown_ ? through(before_, last_) : 0.0;
    const double scaled = length * (times < patience ? std::max(factor * safety, 0.3) : 0.5);
    return line > 0.3 * length ? std::min(line, scaled) : scaled;
  }
  /// The same after one up to which the path cannot be followed.
  [[nodiscard]] double shorter(double length) {
    note({length, unknown});
    return 0.5 * (fits_.length + length);
  }
  /// The length to try after one that could grow by `factor`.
  [[nodiscard]] double longer(double length, double factor) {
    note({length, 1.0 / factor});
    const double line = isKnown_ && before_.length < length ? through(before_, last_) : 0.0;
    const double next = std::min(line > length ? line : length * factor * safety, bold_ * length);
    bold_ *= bold_;  // what hardly binds for long may hardly bind for much longer
    return next < fails_.length ? next : between();
  }
  [[nodiscard]] double fits() const { return fits_.length; }
  [[nodiscard]] double fails() const { return fails_.length; }
  /// Nothing longer that fits is much longer.
  [[nodiscard]] bool isNarrow() const { return fails_.length <= narrow * fits_.length; }

 private:
  /// A length and the root of the share of the band that it uses.
  struct Trial {
    double length, used;
  };
  static constexpr double leastFactor = 1e-3;
  static constexpr double unknown = tolerance::farAway;
  /// Lengths that differ by less than this factor need no more trials.
  static constexpr double narrow = 1.02;
  /// What is aimed at between two trials.
  static constexpr double wanted = 0.997;
  /// What is far too long does not tell by how much.
  static constexpr double mostUsed = 2.0;
  /// Between two trials the next is not nearer to one of them than this share of their distance.
  static constexpr double leastShare = 0.05;

  void note(Trial trial) {
    isKnown_ = last_.length > 0.0 && last_.used < unknown && trial.used < unknown;
    before_ = std::exchange(last_, trial);
    isSameSide_ = (before_.used > 1.0) == (trial.used > 1.0);
    if (trial.used > 1.0) {
      fails_ = trial.length < fails_.length ? trial : fails_;
    } else {
      fits_ = trial.length > fits_.length ? trial : fits_;
    }
  }
  /// Where the line through two trials reaches what is aimed at; 0 where it never does.
  static double through(const Trial& a, const Trial& b) {
    const double steepness = (b.used - a.used) / (b.length - a.length);
    return steepness > 0.0 ? std::max(0.0, b.length + (wanted - b.used) / steepness) : 0.0;
  }
  /// By the line between the two; the end that has stayed counts less from time to time.
  [[nodiscard]] double between() {
    const double width = fails_.length - fits_.length;
    if (fails_.used == unknown) {
      return fits_.length + 0.5 * width;
    }
    stays_ = isBetween_ && isSameSide_ ? 0.5 * stays_ : 1.0;
    isBetween_ = true;
    const bool fitted = last_.used <= 1.0;
    const double below = (wanted - fits_.used) * (fitted ? 1.0 : stays_);
    const double above = (std::min(fails_.used, mostUsed) - wanted) * (fitted ? stays_ : 1.0);
    const double share = below / (below + above);
    return fits_.length + std::clamp(share, leastShare, 1.0 - leastShare) * width;
  }

  Trial fits_{0.0, 0.0}, fails_{tolerance::farAway, unknown};
  Trial before_{0.0, 0.0}, last_{0.0, 0.0};
  bool isKnown_ = false;     ///< what the last two trials used
  bool isSameSide_ = false;  ///< both fitted, or neither did
  bool isBetween_ = false;   ///< the last trial was chosen between two
  double stays_ = 1.0;
  double bold_ = mostLonger;
};
}  // namespace

double Stride::accepted() const {
  double accept = tolerance::farAway;
  for (const Guide& g : path_.guides) {
    accept = std::min(accept, Guide::aimShare * (g.inner + g.outer));
  }
  return accept;
}

std::optional<PathPoint> Stride::next(const PathPoint& a, double cap) {
  const bool faceted = path_.guides[0].field->isFaceted() || path_.guides[1].field->isFaceted();
  return faceted ? nextAlongMesh(a, cap) : nextAlongCurves(a, cap);
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
    auto b = path_.step(a, length, path_.vertexGaps(), accept);
    const bool followed = b && b->tangent.dot(a.tangent) >= turnCosine;
    const double factor = followed ? path_.fitWithTurn(a, *b) : 0.0;
    if (factor >= 1.0 - tolerance::coincidence) {
      tried.fits = length;
      best = std::move(b);
    } else if (followed && !best && turned < mostTurns && (turnAims() | learnTurn(a, *b))) {
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
  return room > 0.0 && over > 2.0 * room ? along * over / (over - room) : 0.0;
}

std::optional<PathPoint> Stride::nextAlongCurves(const PathPoint& a, double cap) {
  double length = std::min(planned(a), cap);
  const double accept = accepted();
  std::optional<PathPoint> best;
  double bestLength = 0.0;
  Path::Middle middle;
  Tried tried;
  int grown = 0;
  bool looked = false;   // at the curvature of a trial
  bool corner = false;   // lengths fail because the path cannot be followed so far
  bool toRidge = false;  // this trial ends behind a corner that it cuts off
  for (int i = 0; i < tryLimit && length > tolerance::sameSide; ++i) {
    auto b = path_.step(a, length, path_.vertexGaps(), accept);
    if (!b || b->tangent.dot(a.tangent) < turnCosine) {
      length = tried.shorter(length);
      corner = true;
      if (best && tried.fails() - tried.fits() <= nearCorner) {
        break;
      }
      continue;
    }
    const double factor = path_.fitWithTurn(a, *b);
    if (factor < 1.0 - tolerance::coincidence) {
      // Past an inflection the surface bends the other way than it did: aim at the other edge of
      // the band before shortening the chord.
      const bool turns = !looked && learnTurn(a, *b);
      const double toCorner = behindRidge(a);
      toRidge = toCorner > tried.fits() && toCorner < mostOfCorner * length;
      if (toRidge) {
        (void)tried.shorter(length, factor, i);
        length = toCorner;
      } else if (turns) {
        length = std::min({planned(a), cap, length});
        tried = {};
      } else {
        length = tried.shorter(length, factor, i);
      }
      looked = true;
      corner = false;
      if (best && (++grown > growLimit || tried.isNarrow())) {
        break;
      }
      continue;
    }
    looked = true;
    const double reached = (b->toolEnd - a.toolEnd).norm();
    if (reached > longest_ * (1.0 + tolerance::coincidence) && !path_.flat()) {
      length *= longest_ / reached;  // the surfaces led aside
      continue;
    }
    const bool better = !best || reached > bestLength;
    if (better) {
      best = std::move(b);
      bestLength = reached;
      middle = path_.middle;
    }
    if (!better || factor < (toRidge ? ridgeFit : goodFit) || length >= cap * safety ||
        length >= longest_ || (++grown > growLimit && !corner)) {
      break;
    }
    length = std::min({tried.longer(length, factor), cap, longest_});
  }
  if (bestLength <= 2.0 * nearCorner) {
    return std::nullopt;
  }
  path_.middle = middle;
  return best;
}

/// Slopes of a gap at both ends of a cut vector; none where it is straight.
std::optional<std::array<double, 2>> Stride::slopes(std::size_t role,
                                                    const PathPoint& a,
                                                    const PathPoint& b) const {
  const Vec3 chord = b.toolEnd - a.toolEnd;
  const double length = chord.norm();
  if (path_.guides[role].flat() || length <= 0.0) {
    return std::nullopt;
  }
  const Vec3 turn = a.axis != b.axis ? spin(a.axis, b.axis, length) : Vec3(Vec3::Zero());
  return std::array{slopeAlong(a.contacts[role], a.toolEnd, chord / length, turn),
                    slopeAlong(b.contacts[role], b.toolEnd, chord / length, turn)};
}

namespace {
/// Mean curvature between two places.
double curvature(double before, double behind, double length) {
  const double change = behind - before;
  return std::abs(change) <= levelChange ? 0.0 : change / length;
}
}  // namespace

/// Takes over the curvatures of a trial chord where their sign differs; true where one does. Those
/// of facets tell nothing.
bool Stride::learnTurn(const PathPoint& a, const PathPoint& b) {
  bool turns = false;
  for (std::size_t i = 0; i < path_.guides.size(); ++i) {
    Guide& g = path_.guides[i];
    if (g.field->isFaceted()) {
      continue;
    }
    if (const auto slope = slopes(i, a, b)) {
      const double bend = curvature(slope->front(), slope->back(), (b.toolEnd - a.toolEnd).norm());
      turns = turns || (bend >= 0.0) != (g.bend >= 0.0);
      g.startAnew(bend);
    }
  }
  return turns;
}

void Stride::learn(const PathPoint& a, const PathPoint& b) {
  const double length = (b.toolEnd - a.toolEnd).norm();
  for (std::size_t i = 0; i < path_.guides.size(); ++i) {
    Guide& g = path_.guides[i];
    if (g.field->isFaceted()) {
      continue;
    }
    if (const auto slope = slopes(i, a, b)) {
      const double bend = curvature(slope->front(), slope->back(), length);
      g.bend = bend;
      g.trend = g.spread = 0.0;
      if (path_.middle.end == b.toolEnd && path_.middle.behind[i]) {
        g.startAnew(*path_.middle.behind[i]);
      } else if (path_.middle.end == b.toolEnd && bend != 0.0) {
        // The curvatures of both halves are those of their middles.
        const double change =
            2.0 * (slope->back() + slope->front() - 2.0 * path_.middle.slope[i]) / length;
        const double most = mostTrend * std::abs(bend);
        g.trend = std::clamp(2.0 * change, -most, most) / length;
        g.spread = length;
        g.bend = bend + 0.5 * length * g.trend;
      }
    }
  }
}

}  // namespace arelem::motion
