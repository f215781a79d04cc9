#include "runtime/motion/follow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ir/diag/limits.h"
#include "ir/diag/motion.h"
#include "ir/space/tolerance.h"
#include "runtime/motion/arc_route.h"
#include "runtime/motion/arrival.h"
#include "runtime/motion/axis_turn.h"
#include "runtime/motion/corners.h"
#include "runtime/motion/missed.h"
#include "runtime/motion/settle.h"
#include "runtime/motion/stop.h"
#include "runtime/motion/stride.h"
#include "runtime/motion/surface_ends.h"
#include "runtime/motion/told.h"

namespace arelem::motion {

namespace {
/// A path that passes its start within this many bands is closed.
constexpr double roundBands = 4.0;
/// A cap that is no shorter than this share of the one before is the same.
constexpr double sameCap = 0.999;
/// Where paths cross, cut vectors of at most this length are tried. Part unit.
constexpr double longestAcross = 1e4;

class Follower {
 public:
  Follower(const State& state,
           const FollowRequest& request,
           Course& course,
           CutVectorSink& sink,
           const Limits& limits,
           const InterruptFlag* interrupted)
      : state_(state),
        request_(request),
        course_(course),
        sink_(sink),
        limits_(limits),
        interrupted_(interrupted),
        effort_(limits.gaps),
        stride_(course.path, state.longestVector),
        stops_(state, course),
        corners_(course.path) {
    for (CheckWatch& w : course_.watches) {
      w.spend(effort_);
    }
  }

  Result<FollowResult> run() {
    result_.warnings = std::move(course_.warnings);
    last_ = course_.start;
    auto bad = course_.isArc() ? runArc() : runChords();
    trail_.release();
    if (bad) {
      return withHeight(withStart(ends_.causeOf(*std::move(bad)), course_), course_,
                        *state_.cutter);
    }
    result_.toolEnd = last_.toolEnd;
    result_.axis = last_.axis;
    return std::move(result_);
  }

 private:
  /// The next cut vector.
  void put(const PathPoint& p) {
    way_.note(p.toolEnd - last_.toolEnd);
    trail_.put(last_, p);
    last_ = p;
  }

  // ---- what may go wrong ------------------------------------------------------------------------

  [[nodiscard]] Failure lost() { return motion::lost(course_, last_); }

  [[nodiscard]] Failure tooMuch() const {
    return motion::tooMuch(course_, last_, limits_.gaps, result_.cutVectors);
  }

  [[nodiscard]] std::optional<Failure> beyondLimits() const {
    if (interrupted_ != nullptr && interrupted_->load(std::memory_order_relaxed)) {
      return fail(diag::Interrupted);
    }
    if (effort_.isSpent()) {
      return tooMuch();
    }
    const double most = course_.path.flat() || course_.exact
                            ? static_cast<double>(limits_.points)
                            : std::min(state_.vectorLimit, static_cast<double>(limits_.points));
    if (static_cast<double>(result_.cutVectors) >= most) {
      return tooMany(course_, last_, most);
    }
    return std::nullopt;
  }

  // ---- chord by chord ---------------------------------------------------------------------------

  enum class AtStop { there, again, later };

  /// To a stop on a segment from where the tool is. Again: with the cap, shorter now. Later: where
  /// the axis leapt on the way, the segment is the share of the way to a stop behind it.
  AtStop goTo(const Found& found, const Segment& segment, double& cap) {
    const double before = cap;
    if (const auto stop = arrival_.fittingStop(last_, segment, found, cap)) {
      putTurn(*stop);
      if (!arrival_.arrive(last_, *stop, segment, found.met, cap)) {
        return AtStop::again;
      }
      result_.check = found.met.check;
      return AtStop::there;
    }
    stops_.restore();
    if (cap < sameCap * before) {
      return AtStop::again;
    }
    stops_.forgetFree();
    return AtStop::later;
  }

  /// Walks the path until a check surface is met.
  std::optional<Failure> runChords() {
    if (course_.turnsFirst && !turnAxis()) {
      return lost();
    }
    if (stops_.isEndless()) {
      return effort_.isSpent() ? tooMuch() : missed(course_);
    }
    double cap = tolerance::farAway;
    for (;;) {
      if (auto bad = beyondLimits()) {
        return bad;
      }
      const PathPoint& a = last_;
      course_.path.axis.stand(a.toolEnd, a.axis);
      const PathPoint* b = next(cap);
      // Close to a corner cut vectors may get ever shorter.
      const bool stuck =
          b == nullptr || (cap > tolerance::coincidence &&
                           (b->toolEnd - a.toolEnd).norm() <= tolerance::coincidence);
      // Where the axis ends the path turns back, which looks like a corner.
      if (auto bad = stuck ? axisEnds(course_, last_) : std::nullopt) {
        return bad;
      }
      if (stuck && turnCorner(b)) {
        continue;
      }
      if (b == nullptr && (across_ = straightAcross(cap))) {
        b = &*across_;
      }
      if (b == nullptr) {
        return lost();
      }
      auto bad = course_.path.axis.faultAt(b->toolEnd, b->axis);
      if (bad || (bad = parallelBetween(course_, a, *b))) {
        return bad;
      }
      const Segment segment = segmentBetween(a, *b);
      const auto found = stops_.find(a, segment);
      if (effort_.isSpent()) {
        return tooMuch();
      }
      if (found) {
        if (!found->end) {
          return lost();
        }
        const AtStop at = goTo(*found, segment, cap);
        if (at == AtStop::there) {
          return std::nullopt;
        }
        if (at == AtStop::again) {
          continue;
        }
      }
      if (auto bad = goOn(*b, segment.length)) {
        return bad;
      }
    }
  }

  /// The end of the next cut vector. The first one takes in a turn that was put off: the turn may
  /// bend its way so that it reaches farther than one from where the tool has turned.
  const PathPoint* next(double cap) {
    const PathPoint* const b = stride_.next(last_, cap);
    if (b == nullptr || !beforeTurn_) {
      return b;
    }
    across_ = *b;
    const PathPoint* const direct = stride_.next(*beforeTurn_, cap);
    if (direct != nullptr && (direct->toolEnd - across_->toolEnd).dot(last_.tangent) > 0.0 &&
        takesTurn(*direct)) {
      across_ = *direct;
    }
    return &*across_;
  }

  /// The whole cut vector, on which no check surface is met.
  std::optional<Failure> goOn(const PathPoint& to, double length) {
    if (course_.path.flat() || isRoundAgain(last_, to)) {
      return missed(course_);
    }
    if (length > tolerance::coincidence) {
      stride_.learn(last_, to);  // what is shorter tells more rounding than curvature
    }
    putTurn(to);
    way_.note(to.toolEnd - last_.toolEnd);
    arrival_.put(last_, to);
    return ends_.passedAt(last_);
  }

  /// Goes on behind a corner, `tip` if that was reached; false where there is no direction.
  bool turnCorner(const PathPoint* tip) {
    const auto way = corners_.from(last_, tip);
    if (!way) {
      return false;
    }
    for (const PathPoint& p : way->through) {
      putTurn(p);
      put(p);
    }
    last_ = way->on;
    return true;
  }

  /// The next cut vector where the path crosses another one.
  std::optional<PathPoint> straightAcross(double cap) {
    const double longest = std::min({cap, state_.longestVector, longestAcross});
    // Surfaces that are parallel where the motion begins leave it no one way.
    const auto direction = way_.general();
    return direction ? corners_.across(last_, *direction, longest) : std::nullopt;
  }

  /// True where the path has come back to its start as often as positions are counted, and a cut
  /// vector more: it is closed and never meets what was not met by then.
  bool isRoundAgain(const PathPoint& a, const PathPoint& b) {
    if (rounds_ >= turnsAllowed()) {
      return true;
    }
    turned_ += (b.tangent - a.tangent).norm();  // at most the angle
    if (turned_ <= std::numbers::pi) {
      return false;
    }
    const Vec3 chord = b.toolEnd - a.toolEnd;
    const Vec3 back = course_.start.toolEnd - a.toolEnd;
    const double share = std::clamp(back.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    double near = tolerance::sameSide;
    for (const Guide& g : course_.path.guides) {
      near += roundBands * (g.inner + g.outer);
    }
    if ((back - share * chord).norm() <= near && chord.dot(course_.start.tangent) > 0.0) {
      turned_ = 0.0;
      ++rounds_;
    }
    return false;
  }

  /// A circle that met nothing in this many turns never will.
  [[nodiscard]] double turnsAllowed() const {
    int most = 1;
    for (const CheckGoal& c : request_.checks) {
      most = std::max(most, c.nth);
    }
    return most;
  }

  /// Turns the tool to the axis of the rule. The last turn is put off: the first cut vector along
  /// the path may take it in.
  bool turnAxis() {
    const Vec3 tangent = course_.start.tangent;
    last_ = course_.path.lookWith(state_.toolEnd, state_.axis, tangent);
    const std::vector<PathPoint> ends = turnOntoPath(course_.path, last_, tangent);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      put(ends[i]);
    }
    if (!ends.empty()) {
      beforeTurn_ = last_;
      last_ = ends.back();
      for (CheckWatch& w : course_.watches) {
        w.begin(last_.toolEnd, last_.axis);  // the turn may have led past it
      }
    }
    return !ends.empty();
  }

  /// Whether the cut vector to `next` can take in the turn that was put off, and does not lead so
  /// far off the path that a stop there does not tell from which side the tool came.
  bool takesTurn(const PathPoint& next) {
    const Vec3 way = next.toolEnd - beforeTurn_->toolEnd;
    return way.dot(last_.tangent) >= 0.5 * way.norm() &&
           course_.path.fit(*beforeTurn_, next) >= 1.0 - fitShare;
  }

  /// The turn that was put off, where the cut vector to `next` does not take it in.
  void putTurn(const PathPoint& next) {
    const bool apart = beforeTurn_ && !takesTurn(next);
    const PathPoint turned = last_;
    last_ = beforeTurn_ ? *std::exchange(beforeTurn_, std::nullopt) : turned;
    if (apart) {
      put(turned);
    }
  }

  // ---- circles ----------------------------------------------------------------------------------

  /// A circle on a plane: the arc is divided evenly.
  std::optional<Failure> runArc() {
    ArcRoute route(course_);
    const auto found = route.findStop(stops_, turnsAllowed() + 1.5);
    if (effort_.isSpent()) {
      return tooMuch();
    }
    if (!found) {
      return missed(course_);
    }
    if (!found->end) {
      return lost();
    }
    const ArcPlan plan = route.plan(*found->end);
    std::optional<Failure> bad;
    const Vec3 axis = last_.axis;
    route.forVertices(plan, [&](const Vec3& vertex) {
      if (auto beyond = beyondLimits()) {
        bad = std::move(beyond);
        return false;
      }
      result_.length += (vertex - last_.toolEnd).norm();
      ++result_.cutVectors;
      sink_.put(vertex, axis);
      last_.toolEnd = vertex;
      return true;
    });
    if (bad) {
      return bad;
    }
    result_.driveInner = std::min(result_.driveInner, plan.driveGap);
    result_.driveOuter = std::max(result_.driveOuter, plan.driveGap);
    put(*found->end);
    result_.forward = last_.tangent;
    result_.check = found->met.check;
    return std::nullopt;
  }

  const State& state_;
  const FollowRequest& request_;
  Course& course_;
  CutVectorSink& sink_;
  const Limits& limits_;
  const InterruptFlag* interrupted_;
  Effort effort_;
  FollowResult result_;
  Trail trail_{course_.path, result_, sink_, effort_};
  Stride stride_;
  StopFinder stops_;
  Arrival arrival_{course_, stops_, trail_, limits_, state_.longestVector};
  PathPoint last_;
  double turned_ = 0.0;  ///< by the path since it last passed its start. Radians
  double rounds_ = 0.0;
  Corners corners_;
  SurfaceEnds ends_{course_};
  LastWay way_;
  std::optional<PathPoint>
      across_;  ///< the end of a cut vector over a crossing of paths, or that takes in a turn
  std::optional<PathPoint> beforeTurn_;  ///< where a turn of the axis, put off, began
};

}  // namespace

Result<FollowResult> follow(const State& state,
                            const FollowRequest& request,
                            CutVectorSink& sink,
                            const Limits& limits,
                            const InterruptFlag* interrupted) {
  if (!state.cutter) {
    return fail(diag::CutterUndefined);
  }
  auto course = planCourse(state, request);
  if (!course) {
    return course.takeFailure();
  }
  auto result = Follower(state, request, *course, sink, limits, interrupted).run();
  if (result || !tellsNearest(result.failure())) {
    return result;
  }
  // Once more, for the nearest approach that the message tells: no longer than the motion took.
  auto again = planCourse(state, request);
  if (!again) {
    return result;
  }
  for (std::size_t i = 0; i < again->watches.size(); ++i) {
    again->watches[i].lookClosely(course->watches[i]);
  }
  NoSink none;
  auto closer = Follower(state, request, *again, none, limits, interrupted).run();
  return closer || !tellsNearest(closer.failure()) ? std::move(result) : std::move(closer);
}

}  // namespace arelem::motion
