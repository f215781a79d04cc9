#pragma once
#include "runtime/spray/surface/surface_job.h"

namespace arelem::spray {

/// The planes of SECTN or RADIAL between the extremes of the work.
struct SectionPlanes {
  std::vector<CuttingPlane> planes;
  std::vector<double> levels;  ///< of each: its height, mm, or its angle, radians
  double step = 0.0;           ///< on the surface, where they are farthest apart; mm
  bool closed = false;         ///< of a whole turn: there is no first and no last

  /// How far the sections on both sides of one lie apart on the surface at a place with this
  /// normal, halved; mm. A surface that leans too much counts as one that leans as much as is
  /// followed.
  [[nodiscard]] double apartAt(std::size_t plane, const Vec3& place, const Vec3& normal) const;
};

/// Where the outermost sections would shrink to dots: they lie half a step inside then.
struct Tips {
  bool low = false, high = false;
};

/// Planes whose sections are at most `widest` apart on the surface: closer where it leans against
/// them. Errors: E0375 more than the job's limit of lines, E0358 more points of a mesh than the
/// job's limit.
[[nodiscard]] Result<SectionPlanes> sectionPlanes(const SurfaceJob& job,
                                                  double widest,
                                                  const Tips& tips = {});

/// A few planes square to them, for the curvature of a mesh the other way.
[[nodiscard]] std::vector<CuttingPlane> planesAcross(const SurfaceJob& job);

}  // namespace arelem::spray
