#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Dense>

#include "ir/space/vector.h"

namespace arelem::smooth {

/// A symmetric positive definite system, the same for x, y and z, where a control point meets the
/// three before and after it, going round at the end when closed. Factored once (L D L'), solved
/// often: both in time proportional to the number of points.
class BandedSystem {
 public:
  static constexpr std::size_t band = 3;

  BandedSystem(std::size_t points, bool closed);

  void clear();
  /// Adds to the entry (i, i + ahead), which counts round at the end when closed, and by symmetry
  /// to its mirror. `ahead` is at most the band.
  void add(std::size_t i, std::size_t ahead, double value);
  [[nodiscard]] double diagonal(std::size_t i) const;
  void factor();
  /// Replaces the right side by the solution.
  void solve(std::vector<Vec3>& x) const;

 private:
  /// Closed systems of fewer points have entries that meet; they are solved as dense ones.
  static constexpr std::size_t densePoints = 2 * band + 1;
  using Border = Eigen::Matrix<double, band, band>;
  using BorderRow = Eigen::Matrix<double, 1, band>;

  void factorBand();
  void factorBorder();
  void solveDense(std::vector<Vec3>& x) const;
  template <class Row>
  void solveBand(std::vector<Row>& x) const;

  std::size_t rows_;
  bool closed_;
  bool isDense_;
  std::size_t inner_;  // rows of the band proper; the last ones of a closed system are its border
  std::vector<std::array<double, band + 1>> entries_;  // (i, i) .. (i, i + band)
  std::vector<std::array<double, band + 1>> factor_;   // 1 / D and the columns of L
  std::vector<BorderRow> borderRows_;                  // inverse of the band times the border
  Border borderInverse_;
  Eigen::MatrixXd dense_;
  Eigen::LDLT<Eigen::MatrixXd> denseFactor_;
};

}  // namespace arelem::smooth
