#pragma once
// The source's test cases 5 and 6 (Naseath, chapter 4), rebuilt: his points are only in figures, so
// the two distances that he does not tell are chosen so that the control points, the length and the
// machining time before smoothing are those of his tables 4-3, 4-4 and 4-5, both cases with knots
// of one kind.
#include <cmath>
#include <string>
#include <vector>

#include "bench/smoothing/source_time.h"
#include <Eigen/Dense>

#include "runtime/spline/cubic.h"

namespace arelem::smooth::source {

/// The spline through points with natural ends and knots at sums of |chord|^exponent.
inline spline::CubicSpline through(const std::vector<Vec3>& points, double exponent) {
  std::vector<double> knots{0.0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    knots.push_back(knots.back() + std::pow((points[i] - points[i - 1]).norm(), exponent));
  }
  const std::size_t m = points.size() + 2;
  const auto size = static_cast<Eigen::Index>(m);
  Eigen::MatrixXd matrix(size, size);
  for (std::size_t k = 0; k < m; ++k) {
    std::vector<Vec3> one(m, Vec3::Zero());
    one[k].x() = 1.0;
    const auto basis = *spline::CubicSpline::make(std::move(one), knots, false);
    const auto column = static_cast<Eigen::Index>(k);
    for (std::size_t i = 0; i < points.size(); ++i) {
      matrix(static_cast<Eigen::Index>(i), column) = basis.at(knots[i]).x();
    }
    matrix(size - 2, column) = basis.derivatives(knots.front()).second.x();
    matrix(size - 1, column) = basis.derivatives(knots.back()).second.x();
  }
  Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(size, 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    right.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  }
  const Eigen::MatrixX3d solution = matrix.partialPivLu().solve(right);
  std::vector<Vec3> control;
  for (Eigen::Index i = 0; i < size; ++i) {
    control.emplace_back(solution.row(i).transpose());
  }
  return *spline::CubicSpline::make(std::move(control), knots, false);
}

struct PublishedGain {
  double radius, time, computing;  ///< mm, share of the time, seconds
};
struct PublishedCase {
  std::string name;
  spline::CubicSpline curve;
  std::size_t controlPoints;
  double length, time;  ///< before, mm and s
  std::vector<PublishedGain> gains;
  std::vector<Vec3> corners;  ///< points of the curve that its way round is made of
};

/// The exponent of the knots for which both cases take their published times.
inline constexpr double knotExponent = 0.64;

/// 100 mm of a straight line, and two points 0.2 mm off it, each so close behind a point of the
/// line.
inline spline::CubicSpline noisyLine() {
  constexpr double behind = 0.11;
  std::vector<Vec3> points;
  for (int i = 0; i < 28; ++i) {
    const double x = 100.0 / 27.0 * i;
    points.emplace_back(x, 0.0, 0.0);
    if (i == 9 || i == 18) {
      points.emplace_back(x + behind, 0.2, 0.0);
    }
  }
  return through(points, knotExponent);
}

inline constexpr double squareLeg = 24.582;

inline std::vector<Vec3> corners(double leg) {
  return {{0, 0, 0},         {leg, 0, 0},     {leg, leg, 0},
          {2 * leg, leg, 0}, {2 * leg, 0, 0}, {3 * leg, 0, 0}};
}

/// Five legs at right angles, with a point so close to each corner and two between.
inline spline::CubicSpline square() {
  constexpr double leg = squareLeg;
  constexpr double beside = 1.7;
  const std::vector<double> along{beside, beside + (leg - 2.0 * beside) / 3.0,
                                  leg - beside - (leg - 2.0 * beside) / 3.0, leg - beside, leg};
  std::vector<Vec3> points{Vec3::Zero()};
  for (int i = 0; i < 5; ++i) {
    const Vec3 corner = points.back();
    const Vec3 direction = i == 1 ? Vec3::UnitY() : i == 3 ? Vec3(-Vec3::UnitY()) : Vec3::UnitX();
    for (const double x : along) {
      points.emplace_back(corner + x * direction);
    }
  }
  return through(points, knotExponent);
}

inline std::vector<PublishedCase> publishedCases() {
  return {{"line of his figures",
           noisyLine(),
           32,
           100.444,
           1.341,
           {{0.025, 0.0276, 0.231}, {0.125, 0.2058, 0.339}, {0.25, 0.7509, 0.851}},
           {{0, 0, 0}, {100, 0, 0}}},
          {"square of his figures",
           square(),
           28,
           123.277,
           1.970,
           {{0.025, 0.0245, 0.237}, {0.125, 0.1083, 0.160}, {0.25, 0.1643, 0.741}},
           corners(squareLeg)}};
}

/// No path within the tolerance takes less: at full speed from corner to corner, or as much nearer
/// as the tolerance lets it pass them.
inline double leastTime(const std::vector<Vec3>& corners, double radius) {
  double length = 0.0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    length += (corners[i] - corners[i - 1]).norm();
  }
  return (length - 2.0 * radius * static_cast<double>(corners.size() - 2)) / machine.velocity;
}

}  // namespace arelem::smooth::source
