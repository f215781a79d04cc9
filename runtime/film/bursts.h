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
  /// The same at many places, on all processors; the result does not depend on their number.
  struct Place {
    Vec3 at = Vec3::Zero(), normal = Vec3::UnitZ();
  };
  [[nodiscard]] std::vector<double> filmsAt(const std::vector<Place>& places) const;
  /// About how many bursts lie near the place with the most of them: what a place costs, but for a
  /// factor.
  [[nodiscard]] std::size_t mostNear() const;

 private:
  /// The gun for a short while: where it stands, where it points, how long.
  struct Burst {
    Vec3 nozzle, axis, along;
    double halfWay = 0.0;  ///< that the spray goes before and behind the middle, mm
    double seconds = 0.0;
  };
  using Cell = std::tuple<long, long, long>;
  /// The bursts that point to one cell, and what bounds them: a ball about the places that they
  /// point to, a cone about their axes, the farthest way of one.
  struct Group {
    std::vector<Burst> bursts;
    Vec3 center = Vec3::Zero(), axis = Vec3::UnitZ();
    double radius = 0.0, sine = 0.0, halfWay = 0.0;
  };
  /// The groups about the cell of the last place: the next one lies in the same, most often.
  struct Near {
    Cell cell;
    bool known = false;
    std::vector<const Group*> groups;
  };

  void divide(const spray::Stroke& stroke, double piece);
  void bound(Group& group) const;
  [[nodiscard]] bool mayReach(const Group& group, const Vec3& place) const;
  [[nodiscard]] double filmAt(const Vec3& place, const Vec3& normal, Near& near) const;
  [[nodiscard]] double one(const Burst& burst, const Vec3& place, const Vec3& normal) const;
  [[nodiscard]] Cell cellOf(const Vec3& place) const;

  spray::Profile profile_;
  double a_, b_, d_, flow_;
  double reach_;
  std::map<Cell, Group> cells_;  // by the place that they point to
};

}  // namespace arelem::film
