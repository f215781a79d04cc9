#pragma once
#include "ir/cl/record.h"
#include "ir/diag/result.h"
#include "runtime/smooth/smooth.h"

namespace arelem::path {

/// What a SMOOTH statement asks for.
struct SmoothOrder {
  smooth::Options options;
  double tolerance = 0.0;  ///< of the whole change, part unit
  double share = 0.4;      ///< of it for the fit
  static constexpr double chordShare = 0.1;
  bool closed = false;      ///< CLOSED: each sequence ends where it begins
  bool keepSpline = false;  ///< SPLINE: the records say which curve the cut vectors follow
};

[[nodiscard]] bool endsSmoothing(const cl::Post& post);

/// Reads SMOOTH/tol [,SPLINE] [,CLOSED] [,METHOD,n] [,PRECIS,n] [,ACCUR,percent] [,SHARE,percent].
/// Errors: E0390, E0391, E0392.
[[nodiscard]] Result<SmoothOrder> readSmoothOrder(const cl::Post& post);

}  // namespace arelem::path
