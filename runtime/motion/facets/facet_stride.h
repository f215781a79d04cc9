#pragma once
#include <memory>

#include "runtime/motion/facets/tunnel_builder.h"
#include "runtime/motion/path.h"

namespace arelem::motion {

/// Chooses cut vectors along a mesh where the other surface is a plane and the axis is fixed: the
/// tool end then stays in a plane, and the tolerance is a tunnel in it.
class FacetStride {
 public:
  explicit FacetStride(Path& path) : path_(path) {}

  /// The end of the longest cut vector from `a`, not longer than `cap`; none where this way of
  /// looking at it does not do.
  [[nodiscard]] std::optional<PathPoint> next(const PathPoint& a, double cap);
  /// True where the last cut vector ended because the tunnel does, not the tolerance.
  [[nodiscard]] bool isCutShort() const { return cutShort_; }

 private:
  [[nodiscard]] bool applies();
  [[nodiscard]] bool begin(const PathPoint& a);
  [[nodiscard]] bool isInside(const PathPoint& a) const;
  [[nodiscard]] Tunnel::Reach reachFrom(const SectionPoint& eye);
  [[nodiscard]] SectionPoint bestEnd(const SectionPoint& eye, const Tunnel::Reach& reach);
  [[nodiscard]] std::optional<PathPoint> pointAt(const SectionPoint& p, const PathPoint& a);

  Path& path_;
  std::optional<Facets> facets_;
  std::size_t mesh_ = 0, plane_ = 1;  ///< which of the path's guides is which
  bool looked_ = false;               ///< at what the guides are
  std::unique_ptr<TunnelBuilder> builder_;
  double usual_ = 0.0;  ///< length of the last cut vector, along the section
  bool cutShort_ = false;
};

}  // namespace arelem::motion
