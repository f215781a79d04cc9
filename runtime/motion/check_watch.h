#pragma once
#include <cmath>
#include <limits>
#include <optional>

#include "ir/space/tolerance.h"
#include "runtime/motion/axis.h"
#include "runtime/motion/state.h"

namespace arelem::motion {

/// A piece of path between two cut vectors, straight from `from` along the unit `direction`.
struct Segment {
  Vec3 from, direction;
  double length = 0.0;
  Vec3 tangentFrom, tangentTo;  ///< true path tangents at both ends
};

/// Watches one check surface along a path and finds the position asked for, without stepping over
/// one.
///
/// All measures are 1-Lipschitz in the tool end, so a measure of m proves m of free path. Positions
/// are counted as spec 4.8 says: TO and PAST are the zeros of max(gap on one side, gap on the
/// other), which are where the cutter begins and ends to violate the surface; ON are the zeros of
/// the tool end's distance.
class CheckWatch {
 public:
  struct Hit {
    double low = 0.0, high = 0.0;  ///< the position lies between these lengths along the segment
    Field* field = nullptr;        ///< the gap that is zero there
  };

  /// `cutter` null watches the tool end (ON, or a check of a tool without size). `drive` is the
  /// field whose normal must agree at a tangency. Cut vectors stray by up to `pathBand` from the
  /// path proper, so a tangency is looked for that much beyond the band; whoever gets the hit
  /// checks the gap there (`touches`).
  CheckWatch(const NamedSurface& surface,
             ir::Condition condition,
             int nth,
             Tool tool,
             double band,
             double pathBand);

  /// Where the motion begins.
  void begin(const Vec3& toolEnd, const AxisRule& axis);
  /// `guide` is the field that a tangent check surface touches: the drive (TANTO) or part surface
  /// (PSTAN).
  [[nodiscard]] std::optional<Hit> scan(const Segment& segment, const AxisRule& axis, Field& guide);

  /// True where a gap found at a tangency is contact within the tolerance.
  [[nodiscard]] bool touches(double gap) const {
    return std::abs(gap) <= band_ * (1.0 + tolerance::wholeExponent);
  }
  [[nodiscard]] bool isTangent() const { return tangent_; }
  [[nodiscard]] bool usesPart() const { return condition_ == ir::Condition::pstan; }
  [[nodiscard]] const NamedSurface& surface() const { return surface_; }
  [[nodiscard]] ir::Condition condition() const { return condition_; }
  [[nodiscard]] double band() const { return band_; }
  /// No position can be met before this much more path.
  [[nodiscard]] double freePath() const { return now_.free; }
  [[nodiscard]] double nearest() const { return nearest_; }
  [[nodiscard]] const Vec3& nearestPlace() const { return nearestPlace_; }

  /// What changes from segment to segment; can be put back to try a segment again.
  struct Progress {
    bool armed = false;
    bool positive = false;  ///< sign of the measure at the last sample
    bool startedRemote = true;
    Field* outside = nullptr;    ///< the gap that was open (positive) last
    int seen = 0;                ///< positions met so far
    double free = 0.0;           ///< proven free path ahead
    double lastTurn = 0.0;       ///< tangent check: last component of the normal along the path
    Field* bandField = nullptr;  ///< tangent check: the gap that is within its band, or null
  };
  [[nodiscard]] const Progress& progress() const { return now_; }
  void restore(const Progress& progress) { now_ = progress; }

 private:
  struct Measure {
    double value = 0.0;  ///< signed measure whose zeros are the positions
    double rate = 1.0;   ///< bound of its change per length of path
    Field* field = nullptr;
  };
  Measure measure(const Vec3& at, const AxisRule& axis, const Vec3& direction);
  std::optional<Hit> scanCrossing(const Segment& segment, const AxisRule& axis);
  std::optional<Hit> scanTangent(const Segment& segment, const AxisRule& axis, Field& guide);
  void note(double distance, const Vec3& place);

  NamedSurface surface_;
  ir::Condition condition_;
  int nth_;
  double band_;
  double pathBand_;
  bool tangent_;
  bool pointTool_;
  std::unique_ptr<Field> plus_, minus_;
  Progress now_;
  double nearest_ = std::numeric_limits<double>::infinity();
  Vec3 nearestPlace_ = Vec3::Zero();
};

}  // namespace arelem::motion
