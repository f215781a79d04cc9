// Least squares with as few knots as a tolerance allows.
#include <algorithm>
#include <cmath>

#include <Eigen/SparseCholesky>

#include "ir/diag/spline.h"
#include "ir/space/smooth_tolerance.h"
#include "ir/space/tolerance.h"
#include "runtime/spline/fit.h"

namespace arelem::spline {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// The curve of given knots next to the points, and how far the points of each span are from it.
struct Fitted {
  CubicSpline curve;
  std::vector<double> worst;
};

class LeastSquares {
 public:
  LeastSquares(std::span<const Vec3> points, const std::vector<double>& places, bool closed)
      : points_(points), places_(places), closed_(closed) {}

  [[nodiscard]] Result<Fitted> over(const std::vector<double>& knots) const {
    const std::size_t count = closed_ ? knots.size() - 1 : knots.size() + 2;
    auto made = CubicSpline::make(std::vector<Vec3>(count, Vec3::Zero()), knots, closed_);
    if (!made) {
      return made.takeFailure();
    }
    const CubicSpline& frame = *made;
    const auto m = static_cast<Eigen::Index>(frame.control().size());
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(m, 3);
    std::size_t next = 0;
    for (std::size_t span = 0; span < frame.spans(); ++span) {
      Eigen::Matrix4d block = Eigen::Matrix4d::Zero();
      const bool last = span + 1 == frame.spans();
      const auto w = frame.pieceWeights(span);
      for (; next < points_.size() && (last || places_[next] < knots[span + 1]); ++next) {
        const Eigen::Vector4d b = basis(w, knots[span], knots[span + 1], places_[next]);
        // The ends are not to move: they weigh as much as all other points together.
        const bool end = !closed_ && (next == 0 || next + 1 == points_.size());
        const double weight = end ? 1e6 : 1.0;
        block += weight * b * b.transpose();
        for (Eigen::Index i = 0; i < 4; ++i) {
          right.row(column(frame, span, i)) += weight * b(i) * points_[next].transpose();
        }
      }
      for (Eigen::Index i = 0; i < 4; ++i) {
        for (Eigen::Index k = 0; k < 4; ++k) {
          entries.emplace_back(column(frame, span, i), column(frame, span, k),
                               block(i, k) + (i == k ? tolerance::splineFitStiffness : 0.0));
        }
      }
    }
    Sparse matrix(m, m);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::MatrixX3d x = Eigen::SimplicialLDLT<Sparse>(matrix).solve(right);
    std::vector<Vec3> control(frame.control().size());
    for (std::size_t i = 0; i < control.size(); ++i) {
      control[i] = x.row(static_cast<Eigen::Index>(i)).transpose();
    }
    if (!closed_) {
      control.front() = points_.front();
      control.back() = points_.back();
    }
    Fitted fitted{frame.withControl(std::move(control)), std::vector<double>(frame.spans())};
    measure(fitted);
    return fitted;
  }

 private:
  static Eigen::Index column(const CubicSpline& frame, std::size_t span, Eigen::Index i) {
    return static_cast<Eigen::Index>(frame.index(span, static_cast<std::size_t>(i)));
  }
  static Eigen::Vector4d basis(const CubicSpline::Weights& w, double u, double v, double t) {
    const double s = (t - u) / (v - u);
    const double r = 1.0 - s;
    const std::array<double, 4> b{r * r * r, 3.0 * r * r * s, 3.0 * r * s * s, s * s * s};
    Eigen::Vector4d values = Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        values(static_cast<Eigen::Index>(i)) += b[k] * w[k][i];
      }
    }
    return values;
  }

  void measure(Fitted& fitted) const {
    const auto knots = fitted.curve.knots();
    std::size_t next = 0;
    for (std::size_t span = 0; span < fitted.curve.spans(); ++span) {
      const bool last = span + 1 == fitted.curve.spans();
      const Bezier piece = fitted.curve.piece(span);
      for (; next < points_.size() && (last || places_[next] < knots[span + 1]); ++next) {
        const double miss = (piece.at(places_[next]) - points_[next]).norm();
        fitted.worst[span] = std::max(fitted.worst[span], miss);
      }
    }
  }

  std::span<const Vec3> points_;
  const std::vector<double>& places_;
  bool closed_;
};

}  // namespace

Result<CubicSpline> approximate(std::span<const Vec3> points, double tolerance, bool closed) {
  const std::size_t fewest = closed ? 4 : 2;
  if (points.size() < fewest) {
    return fail(diag::SplineTooShort, points.size(), "a path spline through points", fewest);
  }
  std::vector<double> places{0.0};
  for (std::size_t i = 1; i < points.size() + (closed ? 1 : 0); ++i) {
    const double step = (points[i % points.size()] - points[i - 1]).norm();
    if (!(step > tolerance::sameSide)) {
      return fail(diag::SplinePointsCoincide, i, i % points.size() + 1, step);
    }
    places.push_back(places.back() + step);
  }
  const double length = places.back();
  places.resize(points.size());
  const LeastSquares system(points, places, closed);
  std::vector<double> knots{0.0, length};
  if (closed) {  // as few as a ring can have
    knots = {0.0, 0.25 * length, 0.5 * length, 0.75 * length, length};
  }
  for (;;) {
    Result<Fitted> fitted = system.over(knots);
    if (!fitted) {
      return fitted.takeFailure();
    }
    std::vector<double> finer;
    for (std::size_t span = 0; span < fitted->worst.size(); ++span) {
      finer.push_back(knots[span]);
      const auto inside = std::lower_bound(places.begin(), places.end(), knots[span]);
      const auto beyond = std::lower_bound(places.begin(), places.end(), knots[span + 1]);
      if (fitted->worst[span] > tolerance && beyond - inside > 1) {
        finer.push_back(0.5 * (knots[span] + knots[span + 1]));
      }
    }
    finer.push_back(knots.back());
    if (finer.size() == knots.size()) {
      const double most = *std::max_element(fitted->worst.begin(), fitted->worst.end());
      return most <= tolerance ? Result<CubicSpline>(std::move(fitted->curve))
                               : interpolate(points, closed);
    }
    knots = std::move(finer);
  }
}

}  // namespace arelem::spline
