#include "runtime/certify/spline_guide.h"

#include <algorithm>

namespace arelem::certify {

namespace {

using spline::Bezier;
using spline::CubicSpline;

constexpr int deepestHalving = 30;
/// Bounds are as close to what occurs as this share of what is allowed.
constexpr double closeness = 0.01;

/// The distance of a part of the curve from one cut vector.
class CutVector {
 public:
  CutVector(const Vec3& from, const Vec3& to, double limit)
      : from_(from), to_(to), limit_(limit), close_(closeness * limit) {}

  void take(const Bezier& piece, int depth) {
    for (const Vec3& end : {piece.control[0], piece.control[3]}) {
      const double away = spline::distanceToSegment(end, from_, to_);
      if (away > measured) {
        measured = away;
        place = end;
      }
    }
    ++nodes;
    double bound = 0.0;
    for (const Vec3& p : piece.control) {
      bound = std::max(bound, spline::distanceToSegment(p, from_, to_));
    }
    if (bound <= measured + close_ || measured > limit_ || depth == 0) {
      proven = std::max(proven, bound);
      return;
    }
    const auto [left, right] = piece.halves();
    take(left, depth - 1);
    take(right, depth - 1);
  }

  double measured = 0.0;
  double proven = 0.0;
  Vec3 place = Vec3::Zero();
  std::uint64_t nodes = 0;

 private:
  const Vec3 from_, to_;
  double limit_;
  double close_;
};

CutVector along(const CubicSpline& curve,
                const Vec3& from,
                const Vec3& to,
                double begin,
                double end,
                double limit) {
  CutVector chord(from, to, limit);
  for (std::size_t span = curve.spanOf(begin); span < curve.spans(); ++span) {
    const Bezier piece = curve.piece(span);
    const double a = std::max(begin, piece.begin);
    const double b = std::min(end, piece.end);
    chord.take(piece.part(a, std::max(a, b)), deepestHalving);
    if (piece.end >= end) {
      break;
    }
  }
  return chord;
}

}  // namespace

SplineWalk::SplineWalk(const CubicSpline& curve, double slack)
    : curve_(curve), end_(curve.at(curve.end())), slack_(slack), t_(curve.begin()) {}

bool SplineWalk::arrives(const Vec3& place) {
  t_ = curve_.footAhead(place, t_);
  const bool isAhead = t_ > 0.5 * (curve_.begin() + curve_.end());
  return isAhead && (place - end_).norm() <= slack_;
}

GuideResult proveAlongSpline(const CubicSpline& curve,
                             std::span<const Location> path,
                             const Allowed& allowed) {
  GuideResult result;
  const double limit = allowed.outer + allowed.slack;
  double t = curve.begin();
  for (std::size_t i = 1; i < path.size(); ++i) {
    // The last cut vector answers for the rest of the curve.
    const double next = i + 1 == path.size() ? curve.end() : curve.footAhead(path[i].toolEnd, t);
    const CutVector chord = along(curve, path[i - 1].toolEnd, path[i].toolEnd, t, next, limit);
    t = next;
    result.verdict.nodes += chord.nodes;
    Extreme& greatest = result.verdict.greatest;
    greatest.proven = std::max(greatest.proven, chord.proven);
    if (chord.measured > greatest.measured) {
      greatest.measured = chord.measured;
      result.greatestVector = i - 1;
      result.greatestPlace = chord.place;
    }
  }
  const Extreme& greatest = result.verdict.greatest;
  result.verdict.outer = greatest.measured > limit ? Verdict::State::refuted
                         : greatest.proven > limit ? Verdict::State::undecided
                                                   : Verdict::State::proven;
  return result;
}

}  // namespace arelem::certify
