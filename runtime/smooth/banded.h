#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Dense>

namespace arelem::smooth {

/// A symmetric positive definite system in the coordinates of control points, three each, where a
/// point meets the three before and after it, going round at the end when closed. Factored once
/// (L D L'), solved often: both in time proportional to the number of points.
class BandedSystem {
 public:
  BandedSystem(std::size_t points, bool closed);

  void clear();
  /// Adds to the entry (i, j) and, by symmetry, (j, i), where i and j count coordinates. Call it
  /// once for each unordered pair.
  void add(std::size_t i, std::size_t j, double value);
  void factor();
  /// Replaces the right side by the solution.
  void solve(std::vector<double>& x) const;

 private:
  static constexpr std::size_t band = 11;  // coordinates of the three points ahead
  /// Closed systems of fewer points have entries that meet; they are solved as dense ones.
  static constexpr std::size_t densePoints = 10;
  /// Coordinates at the end of a closed system that are eliminated last.
  static constexpr std::size_t border = 9;
  using Border = Eigen::Matrix<double, border, border>;
  using BorderColumn = Eigen::Matrix<double, border, 1>;

  void factorBand();
  void factorBorder();
  template <class Row>
  void solveBand(std::vector<Row>& x) const;

  std::size_t rows_;
  bool closed_;
  bool isDense_;
  std::size_t inner_;                                  // rows of the band proper
  std::vector<std::array<double, band + 1>> entries_;  // (i, i) .. (i, i + band)
  std::vector<std::array<double, band + 1>> factor_;   // D and the columns of L
  std::vector<BorderColumn> borderColumns_;            // inverse of the band times the border
  Border borderInverse_;
  Eigen::MatrixXd dense_;
  Eigen::LDLT<Eigen::MatrixXd> denseFactor_;
};

}  // namespace arelem::smooth
