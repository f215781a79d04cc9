// Figures of a curve: chords, nearest points, deviation, curvature.
#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "ir/space/smooth_tolerance.h"
#include "runtime/spline/cubic.h"

namespace arelem::spline {

namespace {

constexpr int deepestHalving = 40;
constexpr int mostPolishing = 8;
constexpr int mostSteps = 30;

void addChords(const Bezier& piece, double tolerance, int depth, std::vector<Vec3>& points) {
  if (depth == 0 || piece.chordBound() <= tolerance) {
    points.push_back(piece.control[3]);
    return;
  }
  const auto [left, right] = piece.halves();
  addChords(left, tolerance, depth - 1, points);
  addChords(right, tolerance, depth - 1, points);
}

/// A piece can come no nearer to p than this: the distance of p from the box of its control points.
double distanceToBox(const Bezier& piece, const Vec3& p) {
  Vec3 low = piece.control[0];
  Vec3 high = low;
  for (const Vec3& c : piece.control) {
    low = low.cwiseMin(c);
    high = high.cwiseMax(c);
  }
  return (low - p).cwiseMax(p - high).cwiseMax(0.0).norm();
}

struct Candidate {
  double bound = 0.0;
  Bezier piece;
  bool operator<(const Candidate& other) const { return bound > other.bound; }
};

}  // namespace

std::vector<Vec3> chordPoints(const CubicSpline& curve, double tolerance) {
  std::vector<Vec3> points{curve.at(curve.begin())};
  for (std::size_t span = 0; span < curve.spans(); ++span) {
    addChords(curve.piece(span), tolerance, deepestHalving, points);
  }
  return points;
}

CubicSpline::Nearest CubicSpline::nearest(const Vec3& p) const {
  Nearest best{begin(), at(begin()), (at(begin()) - p).norm()};
  std::priority_queue<Candidate> open;
  double size = 0.0;
  for (std::size_t span = 0; span < spans(); ++span) {
    const Bezier one = piece(span);
    size = std::max(size, (one.control[3] - control_[0]).norm());
    open.push({distanceToBox(one, p), one});
  }
  const double enough = tolerance::splineNearest * (size + best.distance);
  while (!open.empty() && open.top().bound < best.distance - enough) {
    const Bezier one = open.top().piece;
    open.pop();
    for (const Bezier& half : {one.halves().first, one.halves().second}) {
      const double distance = (half.control[3] - p).norm();
      if (distance < best.distance) {
        best = {half.end, half.control[3], distance};
      }
      const double start = (half.control[0] - p).norm();
      if (start < best.distance) {
        best = {half.begin, half.control[0], start};
      }
      const double bound = distanceToBox(half, p);
      if (bound < best.distance - enough) {
        open.push({bound, half});
      }
    }
  }
  return polished(best, p);
}

/// Steps of the length that the curve has there, so that it does not run past.
double CubicSpline::footAhead(const Vec3& p, double from) const {
  double t = from;
  for (int i = 0; i < mostSteps; ++i) {
    const Derivatives d = derivatives(t);
    const double square = d.first.squaredNorm();
    if (!(square > 0.0)) {
      break;
    }
    const double next = std::clamp(t + (p - d.point).dot(d.first) / square, from, end());
    const double moved = std::abs(next - t);
    t = next;
    if (moved <= tolerance::splineNoStep * (end() - begin())) {
      break;
    }
  }
  return t;
}

/// Newton's method on the foot of the perpendicular: the search above leaves the parameter known to
/// the root of its accuracy only.
CubicSpline::Nearest CubicSpline::polished(Nearest best, const Vec3& p) const {
  for (int i = 0; i < mostPolishing; ++i) {
    const Derivatives d = derivatives(best.t);
    const Vec3 off = d.point - p;
    const double slope = d.first.squaredNorm() + off.dot(d.second);
    if (!(slope > 0.0)) {
      break;
    }
    const double t = inside(best.t - off.dot(d.first) / slope);
    const Vec3 point = at(t);
    const double distance = (point - p).norm();
    if (!(distance < best.distance)) {
      break;
    }
    best = {t, point, distance};
  }
  return best;
}

double deviationBound(const CubicSpline& a, const CubicSpline& b, int halvings) {
  std::vector<Vec3> difference(a.control().size());
  for (std::size_t i = 0; i < difference.size(); ++i) {
    difference[i] = b.control()[i] - a.control()[i];
  }
  const CubicSpline gap = a.withControl(std::move(difference));
  double most = 0.0;
  for (std::size_t span = 0; span < gap.spans(); ++span) {
    most = std::max(most, hullOfHalves(gap.piece(span), halvings));
  }
  return most;
}

CurvatureFigures curvatureFigures(const CubicSpline& curve, int perSpan) {
  CurvatureFigures figures;
  double turned = 0.0;
  double length = 0.0;
  double before = 0.0;
  for (std::size_t span = 0; span < curve.spans(); ++span) {
    const Bezier piece = curve.piece(span);
    Vec3 last = piece.control[0];
    for (int i = 0; i <= perSpan; ++i) {
      const double t = piece.begin + (piece.end - piece.begin) * i / perSpan;
      const double k = piece.curvature(t);
      figures.most = std::max(figures.most, k);
      if (i > 0) {
        const Vec3 at = piece.at(t);
        const double step = (at - last).norm();
        length += step;
        turned += 0.5 * step * (before + k);
        last = at;
      }
      before = k;
    }
  }
  figures.mean = length > 0.0 ? turned / length : 0.0;
  return figures;
}

}  // namespace arelem::spline
