#pragma once
#include "runtime/spray/surface/surface_job.h"

namespace arelem::spray {

inline constexpr double mostSections = 20'000.0;

/// The planes of SECTN or RADIAL, at most `widest` apart, between the extremes of the work.
struct SectionPlanes {
  std::vector<CuttingPlane> planes;
  double step = 0.0;  ///< mm, where they are farthest apart
};
/// Error E0375: more than `mostSections`.
[[nodiscard]] Result<SectionPlanes> sectionPlanes(const SurfaceJob& job, double widest);

/// A few planes square to them, for the curvature of a mesh the other way.
[[nodiscard]] std::vector<CuttingPlane> planesAcross(const SurfaceJob& job);

}  // namespace arelem::spray
