#include "runtime/path/curve_needs.h"

#include <cmath>

#include <Eigen/LU>

#include "ir/space/tolerance.h"
#include "runtime/interpret/passed_post.h"
#include "runtime/path/affine.h"

namespace arelem::path {

namespace {
/// Columns of one length, square to each other.
bool isSimilarity(const Affine& a) {
  const Eigen::Matrix3d square = a.linear.transpose() * a.linear;
  const double scale = square.trace() / 3.0;
  return (square - scale * Eigen::Matrix3d::Identity()).norm() <= tolerance::similarity * scale;
}

bool distorts(const cl::Post& post) {
  for (const cl::Value& value : post.arguments) {
    const auto* matrix = std::get_if<cl::SurfaceValue>(&value);
    if (matrix != nullptr && matrix->canon.size() == 12 &&
        !isSimilarity(Affine::fromRows(matrix->canon))) {
      return true;
    }
  }
  return false;
}
}  // namespace

bool needsChords(const std::vector<runtime::Action>& actions) {
  for (const runtime::Action& action : actions) {
    const cl::Post* post = runtime::passedPost(action);
    if (post == nullptr) {
      continue;
    }
    if (cl::nameOf(*post) == "SMOOTH") {
      return true;
    }
    const bool moves = cl::is(*post, Word::TRACUT) || cl::is(*post, Word::COPY);
    if (moves && distorts(*post)) {
      return true;
    }
  }
  return false;
}

}  // namespace arelem::path
