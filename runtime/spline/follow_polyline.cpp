// A curve along a polyline that cuts its corners by no more than a tolerance.
#include <algorithm>
#include <cmath>
#include <limits>

#include "ir/diag/spline.h"
#include "ir/space/tolerance.h"
#include "runtime/spline/fit.h"

namespace arelem::spline {

namespace {

constexpr int mostRounds = 40;
/// Pieces are halved at most this often until their hulls lie near single legs.
constexpr int halvings = 24;
/// Share of the tolerance that corners are cut by at first.
constexpr double inside = 0.98;
/// Control points of one distance beside a corner, and how much wider each next one is.
constexpr std::size_t evenPlaces = 3;
constexpr double growth = 1.6;

/// A control point and the leg of the polyline that it lies on.
struct Placed {
  Vec3 at;
  std::size_t leg;
  double arc;
};

class Follower {
 public:
  Follower(std::span<const Vec3> points, double tolerance, bool closed)
      : points_(points), tolerance_(tolerance), closed_(closed), reach_(points.size()) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      reach_[i] = firstReach(i);
    }
  }

  Result<CubicSpline> run() {
    for (int round = 0;; ++round) {
      place();
      Result<CubicSpline> curve = make();
      if (!curve || round == mostRounds || !tighten(*curve)) {
        return curve;
      }
    }
  }

 private:
  [[nodiscard]] std::size_t legs() const { return closed_ ? points_.size() : points_.size() - 1; }
  [[nodiscard]] const Vec3& corner(std::size_t i) const { return points_[i % points_.size()]; }
  [[nodiscard]] bool isEnd(std::size_t i) const {
    return !closed_ && (i == 0 || i + 1 == points_.size());
  }

  /// A cubic with control points at the distance h on both sides of a corner that turns by `turn`
  /// has its knot point h/3 sin(turn/2) off the corner.
  [[nodiscard]] double firstReach(std::size_t i) const {
    if (isEnd(i)) {
      return std::numeric_limits<double>::infinity();
    }
    const std::size_t n = points_.size();
    const Vec3 in = (points_[i] - points_[(i + n - 1) % n]).normalized();
    const Vec3 out = (points_[(i + 1) % n] - points_[i]).normalized();
    const double half = 0.5 * (out - in).norm();
    return half > 0.0 ? inside * 3.0 * tolerance_ / half : std::numeric_limits<double>::infinity();
  }

  /// Distances from a corner along a leg up to `most`: the reach h, 2 h, 3 h, then wider and wider.
  /// That leaves room to begin a bend before the corner, and few points on long legs.
  static std::vector<double> graded(double reach, double most) {
    std::vector<double> places;
    double step = reach;
    for (double s = reach; s < most && std::isfinite(reach); s += step) {
      places.push_back(s);
      step *= places.size() < evenPlaces ? 1.0 : growth;
    }
    return places;
  }

  /// Control points at every corner and on the legs beside it.
  void place() {
    placed_.clear();
    double arc = 0.0;
    for (std::size_t leg = 0; leg < legs(); ++leg) {
      const Vec3 from = corner(leg);
      const Vec3 along = corner(leg + 1) - from;
      const double length = along.norm();
      const double before = reach_[leg];
      const double after = reach_[(leg + 1) % points_.size()];
      // Each corner has its half of the leg, or all of it where the other one needs nothing.
      const double half = std::isfinite(before) && std::isfinite(after) ? 0.5 : 0.8;
      std::vector<double> places{0.0};
      for (const double s : graded(before, half * length)) {
        places.push_back(s);
      }
      std::vector<double> back = graded(after, half * length);
      for (std::size_t i = back.size(); i-- > 0;) {
        const double gap = length - back[i] - places.back();
        if (gap > 0.3 * (back[i] - (i > 0 ? back[i - 1] : 0.0))) {
          places.push_back(length - back[i]);
        }
      }
      for (const double s : places) {
        placed_.push_back({from + s / length * along, leg, arc + s});
      }
      arc += length;
    }
    total_ = arc;
    if (!closed_) {
      placed_.push_back({points_.back(), legs() - 1, arc});
      thicken();
    }
  }

  /// An open curve has at least four control points.
  void thicken() {
    while (placed_.size() < 4) {
      std::vector<Placed> more;
      for (std::size_t i = 0; i + 1 < placed_.size(); ++i) {
        more.push_back(placed_[i]);
        const std::size_t leg = placed_[i].leg;
        more.push_back({0.5 * (placed_[i].at + placed_[i + 1].at), leg,
                        0.5 * (placed_[i].arc + placed_[i + 1].arc)});
      }
      more.push_back(placed_.back());
      placed_ = std::move(more);
    }
  }

  /// Knots at the arc lengths of the control points that act there.
  [[nodiscard]] Result<CubicSpline> make() const {
    const std::size_t m = placed_.size();
    std::vector<Vec3> control(m);
    std::vector<double> knots;
    for (std::size_t i = 0; i < m; ++i) {
      control[i] = placed_[i].at;
    }
    if (closed_) {
      // Control point 1 acts at the first knot.
      for (std::size_t i = 0; i <= m; ++i) {
        knots.push_back(i + 1 < m ? placed_[i + 1].arc : placed_[(i + 1) % m].arc + total_);
      }
    } else {
      knots.push_back(placed_.front().arc);
      for (std::size_t i = 2; i + 2 < m; ++i) {
        knots.push_back(placed_[i].arc);
      }
      knots.push_back(placed_.back().arc);
    }
    return CubicSpline::make(std::move(control), std::move(knots), closed_);
  }

  /// The distance of a small piece from the polyline between two legs, from above.
  [[nodiscard]] double bound(const Bezier& piece, std::size_t first, std::size_t last) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t leg = first; leg <= last; ++leg) {
      double most = 0.0;
      for (const Vec3& p : piece.control) {
        most = std::max(most, distanceToSegment(p, corner(leg), corner(leg + 1)));
      }
      least = std::min(least, most);
    }
    return least;
  }

  /// The distance of a point from the polyline between two legs.
  [[nodiscard]] double apart(const Vec3& p, std::size_t first, std::size_t last) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t leg = first; leg <= last; ++leg) {
      least = std::min(least, distanceToSegment(p, corner(leg), corner(leg + 1)));
    }
    return least;
  }

  /// A piece that passes a joint of two legs is near neither of them as a whole: it is halved until
  /// its parts are, or one of them begins too far away.
  [[nodiscard]] bool within(const Bezier& piece,
                            std::size_t first,
                            std::size_t last,
                            int depth) const {
    if (bound(piece, first, last) <= tolerance_) {
      return true;
    }
    const auto [left, right] = piece.halves();
    if (depth == 0 || apart(right.control[0], first, last) > tolerance_) {
      return false;
    }
    return within(left, first, last, depth - 1) && within(right, first, last, depth - 1);
  }

  /// Brings control points nearer to the corners that are cut too much. False when there are none.
  bool tighten(const CubicSpline& curve) {
    std::vector<bool> bad(points_.size());
    const std::size_t m = placed_.size();
    for (std::size_t span = 0; span < curve.spans(); ++span) {
      const std::size_t first = placed_[curve.index(span, 0)].leg;
      std::size_t last = placed_[curve.index(span, 3)].leg;
      last += last < first ? legs() : 0;
      if (!within(curve.piece(span), first, last, halvings)) {
        for (std::size_t leg = first; leg <= last + 1; ++leg) {
          bad[leg % points_.size()] = true;
        }
      }
    }
    for (std::size_t i = 0; i < m; ++i) {
      const std::size_t leg = placed_[i].leg;
      const bool isCorner = placed_[i].at == corner(leg);
      if (isCorner && (curve.at(curve.place(i)) - placed_[i].at).norm() > tolerance_) {
        bad[leg] = true;
      }
    }
    bool any = false;
    for (std::size_t i = 0; i < bad.size(); ++i) {
      if (bad[i] && std::isfinite(reach_[i])) {
        const double leg = std::max((corner(i + 1) - points_[i]).norm(),
                                    (points_[i] - corner(i + points_.size() - 1)).norm());
        reach_[i] = 0.6 * std::min(reach_[i], 0.5 * leg);
        any = true;
      }
    }
    return any;
  }

  std::span<const Vec3> points_;
  double tolerance_;
  bool closed_;
  std::vector<double> reach_;
  std::vector<Placed> placed_;
  double total_ = 0.0;
};

}  // namespace

Result<CubicSpline> followPolyline(std::span<const Vec3> points, double tolerance, bool closed) {
  const std::size_t least = closed ? 4 : 2;
  if (points.size() < least) {
    return fail(diag::SplineTooShort, points.size(), "a path spline along a polyline",
                static_cast<int>(least));
  }
  for (std::size_t i = closed ? 0 : 1; i < points.size(); ++i) {
    const std::size_t before = (i + points.size() - 1) % points.size();
    const double step = (points[i] - points[before]).norm();
    if (!(step > tolerance::sameSide)) {
      return fail(diag::SplinePointsCoincide, before + 1, i + 1, step);
    }
  }
  return Follower(points, tolerance, closed).run();
}

}  // namespace arelem::spline
