#pragma once
#include <array>
#include <span>
#include <vector>

#include <Eigen/Dense>

#include "runtime/smooth/banded.h"
#include "runtime/spline/cubic.h"

namespace arelem::smooth {

/// Some successive knot intervals of a path spline: all of them, or a window of a long path.
struct Stretch {
  std::size_t first = 0;   ///< knot interval
  std::size_t count = 0;   ///< intervals; of a closed curve it may go round
  bool isRing = false;     ///< all of a closed curve
  bool holdsStart = true;  ///< the first control points keep their displacements
  bool holdsEnd = true;    ///< the last ones
};

/// Least curvature inside a tube. With d the displacements of the control points, D the difference
/// spline of them and k = (p'' - a p') / |p'|^2 the curvature vector, a = p' p'' / |p'|^2:
///     minimise sum of weight * |k|^2 ds   subject to |D| <= R at the knots and between them.
/// About the curve so far that is a convex problem, with a banded matrix that is the same for x, y
/// and z. The alternating direction method of multipliers takes the place of an exact solution;
/// weights, speeds and k follow the curve from round to round (iteratively reweighted least
/// squares). All work is linear in the number of control points.
class Tube {
 public:
  Tube(const spline::CubicSpline& original, const Stretch& stretch, double radius);

  /// Control points of the stretch: `count` + 3 of them (a ring: `count`).
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Starts from these displacements; the ones at held ends stay as they are.
  void start(std::vector<Vec3> shift);
  [[nodiscard]] const std::vector<Vec3>& shift() const { return shift_; }

  /// Some turns of the method of multipliers with weights (curvature / largest curvature near
  /// it)^exponent. The bounds pull with so many times the stiffness of their control points: little
  /// leaves room to move, much brings the curve into the tube.
  void round(double exponent, double pull, int turns);

 private:
  using Row = std::array<double, 4>;
  /// The difference spline at one place: a mean of four control points, the first one at `from`.
  struct Bound {
    Row weights;
    std::size_t from;
    double allowed = 0.0;  ///< its distance from the origin
    double radius = 0.0;   ///< the same, less what the places beside it are farther out
    double penalty = 0.0;
    Vec3 split = Vec3::Zero();  ///< the copy of the place inside its ball
    Vec3 dual = Vec3::Zero();   ///< scaled multiplier
  };
  /// What a sample has of the given curve.
  struct Station {
    Row first, second;   ///< derivatives by the parameter, by the control points
    double leastSquare;  ///< of the speed |p'|
  };
  struct Sample {
    std::size_t from = 0;
    Row curvature{};            ///< k by the control points, speed and its change as they are
    Row first{};                ///< p' by the control points
    Vec3 now = Vec3::Zero();    ///< k
    Vec3 along = Vec3::Zero();  ///< p' / |p'|^2
    Vec3 lag = Vec3::Zero();    ///< what p' lacks
    double measure = 0.0;       ///< length of path
    double weight = 0.0;        ///< of |k|^2, with the measure
    double hold = 0.0;          ///< weight of the lag
  };

  [[nodiscard]] std::size_t local(std::size_t i) const { return i < size_ ? i : i - size_; }
  [[nodiscard]] std::size_t spanOf(std::size_t i) const;
  [[nodiscard]] const Vec3& given(std::size_t i) const;
  [[nodiscard]] Vec3 combined(const Row& row,
                              std::size_t from,
                              const std::vector<Vec3>& points) const;
  [[nodiscard]] double deviationOf(std::size_t i) const;
  void prepare();
  void tighten();
  void takeSamples();
  void reweigh(double exponent);
  void gather();
  void gather(const Sample& sample, Eigen::Matrix4d& block);
  [[nodiscard]] Vec3 leastVelocity(std::size_t span, const Station& station) const;
  void addSquare(const Row& row, std::size_t from, double factor);
  void penalize(double pull);
  void hold();
  void turn();

  const spline::CubicSpline& original_;
  const Stretch stretch_;
  const double radius_;
  std::size_t size_;
  bool joinsStart_ = false;  // to what was solved before
  bool joinsEnd_ = false;
  BandedSystem system_;
  std::vector<spline::CubicSpline::Weights> weights_;
  std::vector<double> widths_;
  std::vector<Station> stations_;
  std::vector<Bound> bounds_;
  std::vector<Sample> samples_;
  std::vector<double> weightLogs_;  // of the samples
  std::vector<std::size_t> held_;
  std::vector<double> stiff_;  // of the held control points
  std::vector<Vec3> target_;   // of the held control points
  std::vector<Vec3> shift_;
  std::vector<Vec3> gradient_;  // of the energy at d = 0
};

}  // namespace arelem::smooth
