#pragma once
#include "runtime/spray/surface/surface_job.h"

namespace arelem::spray {

/// The planes of SECTN or RADIAL, at most `widest` apart, between the extremes of the work.
struct SectionPlanes {
  std::vector<CuttingPlane> planes;
  double step = 0.0;    ///< mm, where they are farthest apart
  bool closed = false;  ///< of a whole turn: there is no first and no last
};
/// Errors: E0375 more than the job's limit of lines, E0358 more points of a mesh than the job's
/// limit.
[[nodiscard]] Result<SectionPlanes> sectionPlanes(const SurfaceJob& job, double widest);

/// A few planes square to them, for the curvature of a mesh the other way.
[[nodiscard]] std::vector<CuttingPlane> planesAcross(const SurfaceJob& job);

}  // namespace arelem::spray
