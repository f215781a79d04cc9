#pragma once
#include <cstdint>
#include <vector>

#include "ir/cl/record.h"
#include "ir/diag/result.h"
#include "runtime/path/affine.h"

namespace arelem::path {

/// The matrices of one COPY statement.
struct CopyPlan {
  double index = 0.0;
  std::uint64_t times = 0;
  Word mode = Word::SAME;
  Vec3 shift = Vec3::Zero();
  double angle = 0.0;
  Affine matrix;

  /// The matrix of the k-th copy. Shifts and angles are multiplied, not added up, so that no error
  /// grows.
  [[nodiscard]] Affine step(std::uint64_t k, const Affine& previous) const {
    switch (mode) {
      case Word::TRANSL:
        return Affine::translation(static_cast<double>(k) * shift);
      case Word::XYROT:
        return Affine::rotation(static_cast<double>(k) * angle);
      case Word::MODIFY:
        return matrix.after(previous);
      default:
        return {};
    }
  }
};

/// Reads COPY/i,SAME,n | i,TRANSL,x,y,z,n | i,XYROT,degrees,n | i,MODIFY,matrix,n.
[[nodiscard]] Result<CopyPlan> readCopy(const std::vector<cl::Value>& values);

}  // namespace arelem::path
