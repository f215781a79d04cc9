#include "runtime/spray/surface/traverses.h"

#include "ir/diag/spray.h"
#include "runtime/spray/surface/clear_ways.h"

namespace arelem::spray {

namespace {
std::string textOf(const Vec3& p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
}

double lengthOf(const GunPose& from, const std::vector<GunPose>& poses, const GunPose& to) {
  double length = 0.0;
  Vec3 before = from.place;
  for (const GunPose& pose : poses) {
    length += (pose.place - before).norm();
    before = pose.place;
  }
  return length + (to.place - before).norm();
}

/// The side of the work from which it is sprayed, up where that is from all sides.
Vec3 upperOf(const std::vector<Stroke>& strokes) {
  constexpr double mostly = 0.2;  // of the way
  Vec3 sum = Vec3::Zero();
  double way = 0.0;
  for (const Stroke& stroke : strokes) {
    const double length = (stroke.to - stroke.from).norm();
    sum += length * stroke.normalFrom;
    way += length;
  }
  return sum.norm() > mostly * way ? Vec3(sum.normalized()) : Vec3(Vec3::UnitZ());
}

/// Leads the gun from the place of the program to the first line, and from line to line.
class Leader {
 public:
  Leader(Sprayed& sprayed, const SurfaceJob& job, const Walls* walls)
      : sprayed_(sprayed), job_(job) {
    if (walls != nullptr && job.clearance() > 0.0) {
      sprayed.clearance = job.clearance();
      ways_.emplace(*walls, sprayed.clearance, job.clear.has_value(), upperOf(sprayed.strokes));
    }
  }

  void approach() {
    if (!ways_ || !job_.stands || sprayed_.strokes.empty()) {
      return;
    }
    GunPose from = *job_.stands;
    from = from.axis.isZero() ? ways_->facing(from.place) : from;
    const auto poses = ways_->between(from, sprayed_.beginOf(sprayed_.strokes.front()));
    take(0, poses);
  }

  std::optional<Failure> traverse(std::size_t stroke) {
    ++sprayed_.traverses;
    const GunPose from = sprayed_.endOf(sprayed_.strokes[stroke - 1]);
    const GunPose to = sprayed_.beginOf(sprayed_.strokes[stroke]);
    std::optional<std::vector<GunPose>> poses = std::vector<GunPose>();
    if (ways_) {
      poses = ways_->between(from, to);
    }
    if (!poses && job_.checkRadius) {
      return fail(diag::SprayNoWay, textOf(from.place), textOf(to.place), sprayed_.clearance,
                  ways_->nearestOn(from.place, to.place))
          .withHelp(
              "a smaller CLEARP or stand-off, or several SPRAY with LIMITS and GOTO between "
              "them; CLEARP, 0 goes straight on");
    }
    take(stroke, poses);
    sprayed_.chosen.lengths.unpainted += lengthOf(from, poses.value_or(std::vector<GunPose>()), to);
    return std::nullopt;
  }

 private:
  void take(std::size_t stroke, const std::optional<std::vector<GunPose>>& poses) {
    sprayed_.unclear += poses ? 0 : 1;
    if (poses && !poses->empty()) {
      sprayed_.ways.push_back({stroke, *poses});
    }
  }

  Sprayed& sprayed_;
  const SurfaceJob& job_;
  std::optional<ClearWays> ways_;
};
}  // namespace

std::optional<Failure> goRound(Sprayed& sprayed, const SurfaceJob& job, const Walls* walls) {
  Leader leader(sprayed, job, walls);
  leader.approach();
  for (std::size_t i = 1; i < sprayed.strokes.size(); ++i) {
    if (sprayed.strokes[i].newPass) {
      if (auto failure = leader.traverse(i)) {
        return failure;
      }
    }
  }
  return std::nullopt;
}

}  // namespace arelem::spray
