#include "runtime/path/cl_spline.h"

#include "ir/cl/post_word.h"
#include "ir/diag/curves.h"
#include "runtime/spline/cubic.h"

namespace arelem::path {

bool ClSpline::isPart(const cl::Post& post) {
  return post.foreign == "NURBS" || post.foreign == "KNOT" || post.foreign == "CNTRL";
}

bool ClSpline::take(const cl::Post& post) {
  if (!isPart(post)) {
    return false;
  }
  const std::vector<double> numbers = cl::numbersOf(post);
  if (post.foreign == "NURBS") {
    clear();
  } else if (post.foreign == "KNOT") {
    knots_.insert(knots_.end(), numbers.begin(), numbers.end());
  } else if (numbers.size() >= 3) {
    control_.emplace_back(numbers.data());
  }
  open_ = true;
  return true;
}

std::optional<Vec3> ClSpline::end() const {
  return control_.empty() ? std::nullopt : std::optional(control_.back());
}

Result<std::vector<Vec3>> ClSpline::points(const Vec3& start, double tolerance) const {
  if (control_.size() != knots_.size() + 2) {
    return fail(diag::SplineForm, knots_.size(), control_.size());
  }
  std::vector<double> knots{0.0};
  for (std::size_t i = 0; i < knots_.size(); ++i) {
    if (!(knots_[i] > knots.back())) {
      return fail(diag::SplineKnots, i + 1, knots_[i], knots.back());
    }
    knots.push_back(knots_[i]);
  }
  std::vector<Vec3> control{start};
  control.insert(control.end(), control_.begin(), control_.end());
  Result<spline::CubicSpline> curve =
      spline::CubicSpline::make(std::move(control), std::move(knots), false);
  if (!curve) {
    return curve.takeFailure();
  }
  std::vector<Vec3> points = spline::chordPoints(*curve, tolerance);
  points.erase(points.begin());
  return points;
}

}  // namespace arelem::path
