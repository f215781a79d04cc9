#include "runtime/spline/fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

#include "ir/diag/spline.h"
#include "ir/space/tolerance.h"

namespace arelem::spline {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

Result<std::vector<double>> chordLengths(std::span<const Vec3> points, bool closed, int least) {
  if (points.size() < static_cast<std::size_t>(least)) {
    return fail(diag::SplineTooShort, points.size(), "a path spline through points", least);
  }
  std::vector<double> places{0.0};
  places.reserve(points.size() + 1);
  const std::size_t count = points.size() + (closed ? 1 : 0);
  for (std::size_t i = 1; i < count; ++i) {
    const double step = (points[i % points.size()] - points[i - 1]).norm();
    if (!(step > tolerance::sameSide)) {
      return fail(diag::SplinePointsCoincide, i, i % points.size() + 1, step);
    }
    places.push_back(places.back() + step);
  }
  return places;
}

/// A curve over the knots whose control points are not known yet.
Result<CubicSpline> frameOf(const std::vector<double>& knots, bool closed) {
  const std::size_t m = closed ? knots.size() - 1 : knots.size() + 2;
  return CubicSpline::make(std::vector<Vec3>(m, Vec3::Zero()), knots, closed);
}

/// Weights of the four control points at the parameter t of a span.
std::array<double, 4> basis(const CubicSpline& frame, std::size_t span, double t) {
  const CubicSpline::Weights w = frame.pieceWeights(span);
  const auto knots = frame.knots();
  const double s = (t - knots[span]) / (knots[span + 1] - knots[span]);
  const double r = 1.0 - s;
  const std::array<double, 4> b{r * r * r, 3.0 * r * r * s, 3.0 * r * s * s, s * s * s};
  std::array<double, 4> values{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      values[i] += b[k] * w[k][i];
    }
  }
  return values;
}

CubicSpline solved(const CubicSpline& frame, const Eigen::MatrixX3d& x) {
  std::vector<Vec3> control(frame.control().size());
  for (std::size_t i = 0; i < control.size(); ++i) {
    control[i] = x.row(static_cast<Eigen::Index>(i)).transpose();
  }
  return frame.withControl(std::move(control));
}

Eigen::Index column(const CubicSpline& frame, std::size_t span, std::size_t i) {
  return static_cast<Eigen::Index>(frame.index(span, i));
}

/// Rows of "no second derivative" at the ends of an open curve.
void addNaturalEnds(const CubicSpline& frame, Eigen::Index row, Triplets& entries) {
  const std::size_t last = frame.spans() - 1;
  const auto first = frame.pieceWeights(0);
  const auto end = frame.pieceWeights(last);
  for (std::size_t i = 0; i < 4; ++i) {
    entries.emplace_back(row, column(frame, 0, i), first[0][i] - 2.0 * first[1][i] + first[2][i]);
    entries.emplace_back(row + 1, column(frame, last, i), end[1][i] - 2.0 * end[2][i] + end[3][i]);
  }
}

}  // namespace

Result<CubicSpline> interpolate(std::span<const Vec3> points, bool closed) {
  const auto knots = chordLengths(points, closed, closed ? 4 : 2);
  if (!knots) {
    return knots.failure();
  }
  const auto frame = frameOf(*knots, closed);
  if (!frame) {
    return frame.failure();
  }
  const auto m = static_cast<Eigen::Index>(frame->control().size());
  Triplets entries;
  Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(m, 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t span = std::min(i, frame->spans() - 1);
    const auto values = basis(*frame, span, (*knots)[i]);
    for (std::size_t k = 0; k < 4; ++k) {
      entries.emplace_back(static_cast<Eigen::Index>(i), column(*frame, span, k), values[k]);
    }
    right.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  }
  if (!closed) {
    addNaturalEnds(*frame, static_cast<Eigen::Index>(points.size()), entries);
  }
  Sparse matrix(m, m);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Sparse> solver(matrix);
  return solved(*frame, solver.solve(right));
}

}  // namespace arelem::spline
