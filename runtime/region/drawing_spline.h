#pragma once
#include <algorithm>
#include <vector>

#include "runtime/region/drawing.h"

namespace arelem::region {

/// A rational B-spline: de Boor's scheme on (w x, w y, w).
class DrawingSpline {
 public:
  DrawingSpline(int degree, std::vector<double> knots, std::vector<Eigen::Vector3d> poles)
      : degree_(degree), knots_(std::move(knots)), poles_(std::move(poles)) {}

  [[nodiscard]] Vec2 at(double t) const {
    const auto p = static_cast<std::size_t>(degree_);
    std::size_t k = p;
    while (k + 1 < poles_.size() && t >= knots_[k + 1]) {
      ++k;
    }
    std::vector<Eigen::Vector3d> d(poles_.begin() + static_cast<long>(k - p),
                                   poles_.begin() + static_cast<long>(k + 1));
    for (std::size_t r = 1; r <= p; ++r) {
      for (std::size_t j = p; j >= r; --j) {
        const double low = knots_[j + k - p];
        const double width = knots_[j + 1 + k - r] - low;
        const double share = width > 0.0 ? (t - low) / width : 0.0;
        d[j] = (1.0 - share) * d[j - 1] + share * d[j];
      }
    }
    return d[p].head<2>() / d[p].z();
  }
  /// The different knots that bound its pieces.
  [[nodiscard]] std::vector<double> spans() const {
    std::vector<double> list(knots_.begin() + degree_,
                             knots_.begin() + static_cast<long>(poles_.size()) + 1);
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
  }

 private:
  int degree_;
  std::vector<double> knots_;
  std::vector<Eigen::Vector3d> poles_;
};

}  // namespace arelem::region
