#pragma once
#include <optional>
#include <vector>

#include "runtime/spray/gun_pose.h"
#include "runtime/spray/surface/walls.h"

namespace arelem::spray {

/// Ways of a gun that is switched off, from the end of one line to the begin of the next, which
/// keep off the work. A way between two places is known to be clear, not looked at in places: the
/// distance of the work changes by no more than the gun moves, so that each distance clears a whole
/// stretch of the way.
class ClearWays {
 public:
  /// The nozzle comes no nearer to the work than `clearance`, mm, but where it leaves a line and
  /// comes to the next: along its axis. Not `strict`: where a line lies nearer, a way may too, but
  /// for a tenth of the clearance. Ways
  /// that lead to the other side than `upper`, below both of their ends, are taken where others are
  /// much longer: a table may stand there. `walls` must outlive it.
  ClearWays(const Walls& walls,
            double clearance,
            bool strict = true,
            const Vec3& upper = Vec3::UnitZ());

  /// The poses on the way, none where it is clear straight on: off along the axis, round the work
  /// or over it, and to the next line along its axis; the shortest way over the places that are
  /// tried. Nothing where there is no way.
  [[nodiscard]] std::optional<std::vector<GunPose>> between(const GunPose& from,
                                                            const GunPose& to) const;
  /// At a place off the work, facing what is nearest of it.
  [[nodiscard]] GunPose facing(const Vec3& place) const;
  /// How near the work is on the straight way: 0 where it goes through.
  [[nodiscard]] double nearestOn(const Vec3& from, const Vec3& to) const;

 private:
  struct Node {
    GunPose pose;
    int end = 0;        ///< 1 of the first end, 2 of the second, 0 of neither
    double lift = 0.0;  ///< of nodes over an end, along its axis
  };
  [[nodiscard]] bool isClear(const Vec3& from, const Vec3& to, double keep) const;
  [[nodiscard]] bool isFree(const Vec3& place, double keep) const;
  [[nodiscard]] double keptOff(const Vec3& from, const Vec3& to) const;
  void addOver(const GunPose& end, int number, double keep, std::vector<Node>& nodes) const;
  void addAround(std::vector<Node>& nodes) const;
  [[nodiscard]] bool mayGo(const Node& from, const Node& to, double keep) const;

  const Walls& walls_;
  double clearance_;
  bool strict_;
  Vec3 upper_;
  Vec3 low_ = Vec3::Zero(), high_ = Vec3::Zero();  // corners of the box about the work
};

}  // namespace arelem::spray
