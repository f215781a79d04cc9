#include "runtime/path/curve_needs.h"

#include <cmath>

#include <Eigen/LU>

#include "ir/space/tolerance.h"
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
    const auto* pass = std::get_if<runtime::Pass>(&action.body);
    const auto* post = pass != nullptr ? std::get_if<cl::Post>(&pass->body) : nullptr;
    if (post == nullptr) {
      continue;
    }
    if (post->foreign == "SMOOTH" || (post->foreign.empty() && post->word == Word::SMOOTH)) {
      return true;
    }
    const bool moves =
        post->foreign.empty() && (post->word == Word::TRACUT || post->word == Word::COPY);
    if (moves && distorts(*post)) {
      return true;
    }
  }
  return false;
}

}  // namespace arelem::path
