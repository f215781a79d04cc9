#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "ir/space/tolerance.h"
#include "runtime/motion/check_pace.h"
#include "runtime/motion/effort.h"
#include "runtime/motion/segment.h"
#include "runtime/motion/state.h"

namespace arelem::motion {

/// How far a position at a check surface may be off: the gap there lies in [-inner, outer].
struct StopBand {
  double inner = 0.0, outer = 0.0;
};

/// Watches one check surface along a path and finds the position asked for, without stepping over
/// one.
///
/// All measures are 1-Lipschitz in the tool end, and change with the axis by at most the tool's
/// length times the angle, so a measure of m proves free path. Positions
/// are counted as spec 4.8 says: TO and PAST are the zeros of max(gap on one side, gap on the
/// other), which are where the cutter begins and ends to violate the surface; ON are the zeros of
/// the tool end's distance. A gap that comes within the tolerance and turns round without changing
/// its sign is a contact too: TO and PAST at one place. A start within the tolerance does not
/// count, nor what follows before it is left; but on a straight line or a circle that meets nothing
/// else the place where the surface is met exactly does (the next of two lines that hardly turn).
class CheckWatch {
 public:
  struct Hit {
    double low = 0.0, high = 0.0;  ///< the position lies between these lengths along the segment
    Field* field = nullptr;        ///< the gap that is zero, or least, there
    bool touch = false;            ///< the slope of the gap changes sign there, not the gap
    double level = 0.0;            ///< of a touch: the slope there
  };

  /// `cutter` null watches the tool end (ON). `drive` is the
  /// field whose normal must agree at a tangency. Cut vectors stray by up to `pathBand` from the
  /// path proper, so a tangency is looked for that much beyond the band; whoever gets the hit
  /// checks the gap there (`touches`).
  CheckWatch(const NamedSurface& surface,
             ir::Condition condition,
             int nth,
             Tool tool,
             const StopBand& allowed,
             double pathBand);

  /// From now on the nearest approach is found to rounding, for messages: scans take longer. The
  /// same motion was watched before, and found what is near.
  void lookClosely(const CheckWatch& before) {
    close_ = true;
    nearest_ = before.nearest_;
    nearestFacing_ = before.nearestFacing_;
  }
  /// From now on scans end, without a result, once the effort is spent.
  void spend(const Effort& effort) { effort_ = &effort; }
  /// Where the motion begins.
  void begin(const Vec3& toolEnd, const Vec3& axis);
  /// Begins again where a circle meets nothing else: then the place that noteFirstZero found does.
  void beginForFirstZero(const Vec3& toolEnd, const Vec3& axis) {
    forFirstZero_ = true;
    firstZero_.reset();
    now_ = {};
    begin(toolEnd, axis);
  }
  [[nodiscard]] bool hasFirstZero() const { return firstZero_ && !forFirstZero_; }
  /// `guide` is the field that a tangent check surface touches: the drive (TANTO) or part surface
  /// (PSTAN).
  [[nodiscard]] std::optional<Hit> scan(const Segment& segment, Field& guide);
  /// True where the segment is free by what is known already; then `pass` takes the place of
  /// `scan`.
  [[nodiscard]] bool isFree(const Segment& segment) {
    ahead_ = steepest(segment) * segment.length;
    return now_.free > ahead_ && (!close_ || now_.farther > ahead_);
  }
  /// The same, with an end that is not within the tolerance for sure.
  [[nodiscard]] bool isFarFrom(const Segment& segment) {
    return isFree(segment) && now_.free - ahead_ > band_;
  }
  [[nodiscard]] bool mayBeWithin() const { return now_.free <= band_; }
  /// Of the segment that was asked for last.
  void pass() {
    now_.free -= ahead_;
    now_.farther -= ahead_;
  }

  /// True where a gap that turns round is contact within the tolerance. ON and tangent stops have
  /// two sides, and one tolerance for both, as the proof of them has.
  [[nodiscard]] bool touches(double gap) const {
    const double slack = band_ * tolerance::wholeExponent;
    const double most = tangent_ ? band_ : std::max(allowed_.inner, allowed_.outer);
    return tangent_ || pointTool_ ? std::abs(gap) <= most + slack
                                  : gap >= -allowed_.inner - slack && gap <= allowed_.outer + slack;
  }
  [[nodiscard]] bool isTangent() const { return tangent_; }
  [[nodiscard]] bool usesPart() const { return condition_ == ir::Condition::pstan; }
  [[nodiscard]] const NamedSurface& surface() const { return surface_; }
  [[nodiscard]] ir::Condition condition() const { return condition_; }
  [[nodiscard]] double band() const { return band_; }
  /// The nearest approach; of tangencies that where check surface and guide face one way, if they
  /// do so anywhere.
  [[nodiscard]] double nearest() const { return approach().distance; }
  [[nodiscard]] const Vec3& nearestPlace() const { return approach().place; }
  /// Of a tangency: true where the tool is inside the check surface there.
  [[nodiscard]] bool nearestOverlaps() const { return approach().overlaps; }
  /// Looking closely for a tangency: the gap, negative for an overlap, and place where the surfaces
  /// are parallel and touch least badly; none where they are parallel nowhere.
  struct Parallel {
    double gap = 0.0;
    Vec3 place = Vec3::Zero();
  };
  [[nodiscard]] const std::optional<Parallel>& parallel() const { return parallel_; }
  /// Of the positions asked for, how many were asked for and how many met; where the last contact
  /// of any kind was. False where the tool never was clear of the surface.
  [[nodiscard]] int nth() const { return nth_; }
  [[nodiscard]] int met() const { return pointTool_ ? now_.seen : (now_.seen + before()) / 2; }
  [[nodiscard]] bool touchedAny() const { return now_.seen > 0; }
  [[nodiscard]] const Vec3& lastContact() const { return now_.last; }
  [[nodiscard]] bool wasClear() const { return now_.armed; }
  /// True where the tool is within the tolerance from the start on.
  [[nodiscard]] bool neverLeft() const { return !wasClear() && nearest() <= band_; }
  /// True where the tool was at the surface, within its tolerance, when the motion began.
  [[nodiscard]] bool startedAt() const { return startedAt_; }
  /// True where a negative THICK is deeper than the tool is wide: then it is never clear of both
  /// sides of the surface, and has no position TO or PAST it.
  [[nodiscard]] bool thickPassesTool() const { return thickPassesTool_; }
  /// The largest radius of the tool with THICK; 0 where its end counts alone.
  [[nodiscard]] double toolRadius() const { return toolRadius_; }

  /// What changes from segment to segment; can be put back to try a segment again.
  struct Progress {
    bool armed = false;
    bool positive = false;  ///< sign of the measure at the last sample
    bool startedRemote = true;
    Field* outside = nullptr;    ///< the gap that was open (positive) last
    int seen = 0;                ///< positions met so far
    Vec3 last = Vec3::Zero();    ///< the last of them
    double free = 0.0;           ///< change of the measure that meets nothing for sure
    double farther = 0.0;        ///< looking closely: change that comes no nearer for sure
    double nearFor = 0.0;        ///< length of the way within the band, up to here
    double lastTurn = 0.0;       ///< within the band: last component of the normal along the path
    Field* bandField = nullptr;  ///< the gap that is within its band, or null
  };
  /// Touches on the present segment up to this length are known to be near misses.
  void ignoreTouches(double until) { ignoredUntil_ = until; }
  [[nodiscard]] const Progress& progress() const { return now_; }
  void restore(const Progress& progress) { now_ = progress; }
  /// Looks at the next segment from its start on.
  void forgetFree() { now_.free = now_.farther = 0.0; }

 private:
  /// Cosine of the angle within which contact normals count as agreeing at a tangency.
  static constexpr double agreeing = 0.5;
  /// Looking closely, no step is longer than this share of a cut vector; but where a tangency is
  /// looked for none need be shorter than this many times the root of the band.
  static constexpr double closeShare = 0.0625;
  static constexpr double closeRoots = 2.0;

  struct Measure {
    double value = 0.0;  ///< signed measure whose zeros are the positions
    double rate = 1.0;   ///< bound of how fast it comes to zero, per length of path
    double turn = 0.0;   ///< its change along the true path
    Field* field = nullptr;
  };
  Measure measure(const Segment& segment, double along);
  /// The largest change of any gap per length of the segment.
  [[nodiscard]] double steepest(const Segment& s) const {
    if (s.isArc()) {
      return 1.0;
    }
    return s.turning && arm_ > 0.0 ? steepestTurning(s) : pace_.most(s.direction);
  }
  /// How fast a gap may come to zero from here on.
  [[nodiscard]] double closing(const Segment& s, const Field* field, const tool::Contact& c) const {
    return s.isArc() || s.turning ? steepest(s)
                                  : pace_.closing(field == plus_.get() ? 1.0 : -1.0, c.gap,
                                                  c.normal.dot(s.direction), s.direction);
  }
  [[nodiscard]] double nearStep(const Segment& s, double finest) const;
  /// A tangency passes through its band in a length of the order of the root of the band.
  [[nodiscard]] double tangentStep() const;
  /// Where there may be something for the first time.
  [[nodiscard]] double firstLook(const Segment& s) const {
    const double most = steepest(s);
    return now_.free > 0.0 && most > 0.0 ? now_.free / most : 0.0;
  }
  /// Gaps up to this may be contact, as cut vectors stray from the path.
  [[nodiscard]] double reach() const { return band_ + pathBand_; }
  [[nodiscard]] double steepestTurning(const Segment& s) const;
  [[nodiscard]] std::optional<Hit> scanCrossing(const Segment& segment);
  void noteFirstZero(const Segment& segment, double before, double along, const Measure& measure);
  [[nodiscard]] bool crosses(const Measure& measure);
  [[nodiscard]] double crossing(const Segment& segment, double low, double high);
  [[nodiscard]] bool near(const Measure& measure) const {
    return std::abs(measure.value) <= reach();
  }
  [[nodiscard]] bool touchesHere(const Measure& measure);
  [[nodiscard]] std::optional<Hit> levelStretch(
      const Segment& segment, double before, double along, double ahead, const Measure& measure);
  [[nodiscard]] bool slipsThrough(const Measure& measure, const Field* outsideBefore) const;
  [[nodiscard]] Field* vanishing(const Measure& measure, Field* outsideBefore);
  [[nodiscard]] int wanted() const;
  /// 1 where the positions asked for come before the others, TO and PAST in turn.
  [[nodiscard]] int before() const {
    return (condition_ == ir::Condition::past) == now_.startedRemote ? 0 : 1;
  }
  /// Both gaps at one place, where a tangency is looked for.
  struct TangentLook {
    Field* inside = nullptr;  ///< the gap within its band whose contact agrees with the guide's
    double turn = 0.0;        ///< its change along the true path
    bool near = false;        ///< a gap is within its band
    double open = tolerance::farAway;  ///< no gap comes to its band before this length,
    double free = tolerance::farAway;  ///< and at the segment's end is so far from it
  };
  TangentLook lookForTangency(const Segment& segment, double along, Field& guide);
  [[nodiscard]] static Vec3 wayAt(const Segment& segment, double along, Field& guide);
  [[nodiscard]] static bool agrees(const Segment& segment,
                                   double along,
                                   Field& field,
                                   Field& guide);
  static std::optional<double> slopeBefore(const Segment& segment,
                                           double along,
                                           Field& field,
                                           Field& guide);
  std::optional<Hit> tangency(
      const Segment& segment, const TangentLook& look, double before, double along, Field& guide);
  std::optional<Hit> scanTangent(const Segment& segment, Field& guide);
  /// A distance from the surface, and where it was.
  struct Approach {
    double distance = std::numeric_limits<double>::infinity();
    bool overlaps = false;
    Vec3 place = Vec3::Zero();
    void take(double gap, const Vec3& where) {
      if (std::abs(gap) < distance) {
        *this = {std::abs(gap), gap < 0.0, where};
      }
    }
  };
  [[nodiscard]] const Approach& approach() const {
    return nearestFacing_.distance < tolerance::farAway ? nearestFacing_ : nearest_;
  }
  [[nodiscard]] bool isSpent() const { return effort_ != nullptr && effort_->isSpent(); }
  void findNearest(const Segment& segment, Field& guide);
  void findParallel(const Segment& segment, const std::vector<double>& looks, Field& guide);
  double missOfTangency(const Segment& segment, double along, Field& guide);

  NamedSurface surface_;
  ir::Condition condition_;
  int nth_;
  StopBand allowed_;
  double band_;
  double pathBand_;
  bool tangent_;
  bool pointTool_;
  CheckPace pace_;
  bool thickPassesTool_;
  double toolRadius_;
  double arm_;  ///< from the tool end to the farthest point of the tool
  std::unique_ptr<Field> plus_, minus_;
  Progress now_;
  double ahead_ = 0.0;  ///< the most that a measure changes over the segment asked for last
  double ignoredUntil_ = -1.0;
  const Effort* effort_ = nullptr;
  bool close_ = false;
  bool startedAt_ = false;
  bool startedOff_ = false;  ///< within its tolerance, but not on it
  bool forFirstZero_ = false;
  std::optional<Hit> firstZero_;  ///< the position asked for, if it is met before that is left
  std::vector<double> looks_;     ///< lengths along the segment, where looked at closely
  Approach nearest_, nearestFacing_;
  std::optional<Parallel> parallel_;
};

}  // namespace arelem::motion
