#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "ir/cl/record.h"
#include "ir/diag/result.h"
#include "ir/space/vector.h"

namespace arelem::path {

/// NURBS, KNOT and CNTRL of a CL file: a cubic B-spline from where the tool stands to the last
/// control point. KNOT lists the knots behind 0, CNTRL the control points behind the first, so that
/// there are two control points more than knots.
class ClSpline {
 public:
  [[nodiscard]] static bool isPart(const cl::Post& post);
  /// False when the post is none of the three.
  bool take(const cl::Post& post);
  [[nodiscard]] bool empty() const { return !open_; }
  void clear() { *this = {}; }
  /// Where the curve ends; none without control points.
  [[nodiscard]] std::optional<Vec3> end() const;
  /// Points whose chords leave the curve by at most `tolerance`, behind the start. Errors: counts
  /// that do not fit, knots that do not rise.
  [[nodiscard]] Result<std::vector<Vec3>> points(const Vec3& start, double tolerance) const;

 private:
  bool open_ = false;
  std::vector<double> knots_;
  std::vector<Vec3> control_;
};

}  // namespace arelem::path
