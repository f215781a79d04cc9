#pragma once
#include <map>
#include <tuple>
#include <vector>

#include "runtime/spray/sprayed.h"

namespace arelem::film {

/// The strokes of a job on a surface in short pieces, and the film that they leave anywhere. The
/// paint flies straight from the nozzle; paint that flies on for more than three footprints past
/// its place is not followed.
class Bursts {
 public:
  explicit Bursts(const spray::Sprayed& sprayed);

  /// mm, at a place of the work with this unit normal.
  [[nodiscard]] double filmAt(const Vec3& place, const Vec3& normal) const;
  /// How many bursts the fullest cell has: what a place costs, but for a factor.
  [[nodiscard]] std::size_t mostNear() const;

 private:
  /// The gun for a short while: where it stands, where it points, how long.
  struct Burst {
    Vec3 nozzle, axis, along;
    double halfWay = 0.0;  ///< that the spray goes before and behind the middle, mm
    double seconds = 0.0;
  };
  using Cell = std::tuple<long, long, long>;

  void divide(const spray::Stroke& stroke, double piece);
  [[nodiscard]] double one(const Burst& burst, const Vec3& place, const Vec3& normal) const;
  [[nodiscard]] Cell cellOf(const Vec3& place) const;

  spray::Profile profile_;
  double a_, b_, d_, flow_;
  double reach_;
  std::map<Cell, std::vector<Burst>> cells_;  // by the place that they point to
};

}  // namespace arelem::film
