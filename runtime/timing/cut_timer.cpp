#include "runtime/timing/cut_timer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ir/cl/post_word.h"
#include "ir/cl/vendor.h"
#include "ir/diag/spline.h"
#include "ir/hole/cycle_feed.h"
#include "ir/hole/steps.h"
#include "ir/space/smooth_tolerance.h"
#include "ir/space/tolerance.h"
#include "ir/words/units.h"
#include "runtime/path/cl_spline.h"
#include "runtime/timing/feed.h"
#include "runtime/timing/machine_limits.h"
#include "runtime/timing/spline_follower.h"
#include "runtime/timing/spline_limits.h"

namespace arelem::timing {

namespace {

constexpr double secondsOfAMinute = 60.0;
constexpr double unlimited = std::numeric_limits<double>::infinity();
/// Of a CIRCLE or CYLNDR: center, axis, radius.
constexpr std::size_t arcNumbers = 7;
constexpr double fullTurn = 2.0 * std::numbers::pi;

bool stopsTool(Word word) {
  switch (word) {
    case Word::STOP:
    case Word::OPSTOP:
    case Word::SPINDL:
    case Word::LOADTL:
    case Word::DELAY:
    case Word::END:
      return true;
    default:
      return false;
  }
}

}  // namespace

/// The modal state of the records, and the pieces so far.
class CutTimer::Path {
 public:
  Path(const Machine& machine, DiagnosticSink& sink) : machine_(machine), sink_(sink) {}

  void accept(const cl::Record& record) {
    record_ = &record;
    if (const auto* motion = std::get_if<cl::Motion>(&record.body)) {
      move(*motion);
    } else if (const auto* surface = std::get_if<cl::Surface>(&record.body)) {
      surface_ = surface->surface;
    } else if (const auto* units = std::get_if<cl::Units>(&record.body)) {
      unit_ = millimetersOf(units->unit);
      feed_.alter([this](FeedInForce& feed) { feed.setUnit(unit_); });
    } else if (const auto* post = std::get_if<cl::Post>(&record.body);
               post && !clSpline_.take(*post)) {
      if (cl::nameOf(*post) == "MACHLM") {
        limits(*post);
      } else if (post->foreign.empty()) {
        word(*post);
      } else if (const auto apt = cl::inApt(*post)) {
        word(*apt);
      }
    }
  }

  PieceCall pieceCall;

  TimeTable finish() {
    plan();
    return std::move(table_);
  }

 private:
  void word(const cl::Post& post) {
    if (std::optional<Failure> why = objectionToTiming(post)) {
      sink_.accept(at(record_->origin, *std::move(why)));
      return;
    }
    switch (post.word) {
      case Word::RAPID:
        rapid_ = true;
        return;
      case Word::FEDRAT:
      case Word::SPINDL:
        feed_.alter([&](FeedInForce& feed) { feed.take(post); });
        break;
      case Word::DELAY:
        delay(post);
        break;
      case Word::CYCLE:
        return cycle(post);
      case Word::LOADTL:
        ++table_.changes;
        table_.toolChanges += machine_.toolChange;
        table_.statements[record_->isn] += machine_.toolChange;
        break;
      default:
        break;
    }
    if (stopsTool(post.word)) {
      stop();
    }
  }

  void delay(const cl::Post& post) {
    const double value = *cl::firstNumber(post);
    const bool turns = cl::has(post, Word::REV);
    if (turns && !(feed_.now().turns() > 0.0)) {
      sink_.accept(at(record_->origin, fail(diag::UntimedStatement, "DELAY",
                                            std::string("REV, and the spindle has no speed"))));
      return;
    }
    dwell(turns ? value * secondsOfAMinute / feed_.now().turns() : value);
  }

  void cycle(const cl::Post& post) {
    auto change = cycles_.read(post);
    if (!change) {
      sink_.accept(at(record_->origin, change.takeFailure()));
      return;
    }
    if (*change == hole::Cycles::Change::none) {
      return;
    }
    feed_.endCycle();
    const hole::Cycle* begun = cycles_.now();
    if (const auto own = begun != nullptr ? hole::feedOf(*begun) : std::nullopt) {
      FeedInForce feed = feed_.now();
      feed.take(*own);
      feed_.beginCycle(feed);
    }
  }

  /// One location of a cycle: over the hole, down and up again along the tool.
  void drill(const Vec3& end, const Vec3& axis) {
    const hole::Cycle cycle = hole::cycleFrom(*cycles_.now(), (*at_ - end).dot(axis) / unit_);
    run_.reset();
    follower_.reset();
    rapid_ = true;
    for (const Vec3& place : hole::wayOver(*at_, end + unit_ * cycle.clearance * axis, axis)) {
      line(place);
    }
    for (const hole::Step& step : hole::timedStepsOf(cycle)) {
      if (step.kind == hole::Step::Kind::dwell) {
        dwell(step.seconds);
        stop();
        continue;
      }
      rapid_ = step.kind == hole::Step::Kind::rapid;
      line(end + unit_ * step.height * axis);
    }
  }

  void dwell(double seconds) {
    if (seconds < 0.0) {
      sink_.accept(at(record_->origin, fail(diag::NegativeDwell, seconds)));
      return;
    }
    table_.dwell += seconds;
    table_.statements[record_->isn] += seconds;
  }

  /// Wrong ones were reported where the statement came in.
  void limits(const cl::Post& post) {
    if (const Result<Limits> read = machineLimits(post)) {
      plan();
      machine_.limits = *read;
    }
  }

  /// mm/s of a cutting move; 0 with a report when there is none.
  double cuttingSpeed(double length, const Vec3& to) {
    const double perMinute = feed_.now().perMinute(length);
    if (!(perMinute > 0.0) && !feedReported_) {
      sink_.accept(
          at(record_->origin,
             feed_.now().lacksSpindle()
                 ? fail(diag::UntimedStatement, "FEDRAT",
                        std::string("a feed for each turn, and the spindle has no speed"))
                 : fail(diag::FeedMissing, to.x() / unit_, to.y() / unit_, to.z() / unit_)));
      feedReported_ = true;
    }
    return std::min(perMinute / secondsOfAMinute, machine_.limits.velocity);
  }

  void move(const cl::Motion& motion) {
    const std::size_t stride = motion.stride();
    if (motion.kind == cl::Motion::Kind::from || !at_) {
      stop();
      setPlace(motion);
      rapid_ = false;  // RAPID was for this location
      return;
    }
    const bool continues = motion.kind == cl::Motion::Kind::continuation;
    if (!continues) {
      run_ = std::exchange(surface_, std::nullopt);
      follower_.reset();
      if (run_ && run_->type == EntityType::pathSpline) {
        follower_ = SplineFollower::of(run_->canon);
      }
    }
    for (std::size_t i = 0; i + stride <= motion.coordinates.size(); i += stride) {
      const Vec3 end = unit_ * Vec3(&motion.coordinates[i]);
      ++table_.moves;
      if (cycles_.now() != nullptr) {
        drill(end, motion.withAxis ? Vec3(&motion.coordinates[i + 3]) : Vec3(Vec3::UnitZ()));
      } else if (motion.isArc() && run_ && run_->canon.size() == arcNumbers) {
        arc(end, motion.way == cl::Motion::Way::counterclockwise);
      } else if (motion.way == cl::Motion::Way::spline) {
        alongClSpline(end);
      } else {
        line(end);
      }
    }
    clSpline_.clear();
    rapid_ = false;
  }

  /// CIRCLE of a CL file and the GOTO of its end: one piece, as long as the arc or helix.
  void arc(const Vec3& to, bool counterclockwise) {
    const Vec3 axis = (counterclockwise ? 1.0 : -1.0) * Vec3(&run_->canon[3]).normalized();
    const Vec3 center = unit_ * Vec3(run_->canon.data());
    const auto across = [&](const Vec3& p) {
      const Vec3 from = p - center;
      return Vec3(from - axis.dot(from) * axis);
    };
    const Vec3 a = across(*at_);
    const Vec3 b = across(to);
    const double radius = 0.5 * (a.norm() + b.norm());
    const double rise = axis.dot(to - *at_);
    double sweep = std::atan2(axis.dot(a.cross(b)), a.dot(b));
    const bool whole = (b - a).norm() <= tolerance::symmetric * (1.0 + radius);
    sweep = whole ? fullTurn : sweep <= 0.0 ? sweep + fullTurn : sweep;
    const double length = std::hypot(radius * sweep, rise);
    const double speed = rapid_ ? machine_.limits.velocity : cuttingSpeed(length, to);
    if (!(length > tolerance::sameSide) || !(speed > 0.0)) {
      at_ = to;
      return;
    }
    const double level = radius * sweep / length;  // share of the way square to the axis
    const double curvature = level * level / std::max(radius, tolerance::coincidence);
    const auto tangent = [&](const Vec3& from) {
      return Vec3(level * axis.cross(from).normalized() + rise / length * axis);
    };
    add(length, std::min(speed, curveSpeed(curvature, machine_.limits.acceleration)),
        corner(tangent(a), length));
    direction_ = tangent(b);
    lengthBefore_ = length;
    arcBefore_ = false;
    at_ = to;
  }

  /// NURBS of a CL file: chords, whose corners cost what the curve costs.
  void alongClSpline(const Vec3& to) {
    auto points = clSpline_.points(Vec3(*at_ / unit_), tolerance::timeSplineChord / unit_);
    if (!points) {
      return line(to);  // told where the file was read
    }
    for (const Vec3& p : *points) {
      line(unit_ * p);
    }
  }

  void setPlace(const cl::Motion& motion) {
    at_ = unit_ * Vec3(&motion.coordinates[motion.coordinates.size() - motion.stride()]);
  }

  void line(const Vec3& to) {
    const Vec3 step = to - *at_;
    const double length = step.norm();
    if (!(length > tolerance::sameSide)) {
      return;
    }
    const double speed = rapid_ ? machine_.limits.velocity : cuttingSpeed(length, to);
    if (!(speed > 0.0)) {
      at_ = to;
      return;
    }
    double limit = speed;
    bool inArc = false;
    const bool round = run_ && (follower_ || run_->canon.size() == arcNumbers);
    if (round && !rapid_) {
      const double curvature =
          follower_ ? follower_->curvatureTo(to / unit_) / unit_ : 1.0 / distanceFromAxis(to);
      limit = std::min(limit, curveSpeed(curvature, machine_.limits.acceleration));
      inArc = arcBefore_;
      arcBefore_ = true;
    } else {
      arcBefore_ = false;
    }
    const Vec3 direction = step / length;
    add(length, limit, inArc ? unlimited : corner(direction, length));
    direction_ = direction;
    lengthBefore_ = length;
    at_ = to;
  }

  [[nodiscard]] double distanceFromAxis(const Vec3& p) const {
    const std::vector<double>& c = run_->canon;
    const Vec3 axis(&c[3]);
    const Vec3 from = p - unit_ * Vec3(c.data());
    return std::max((from - axis.dot(from) * axis).norm(), tolerance::coincidence);
  }

  [[nodiscard]] double corner(const Vec3& next, double length) const {
    return direction_ ? cornerSpeed(direction_->dot(next), machine_.deviation,
                                    machine_.limits.acceleration, std::min(lengthBefore_, length))
                      : 0.0;
  }

  void add(double length, double speed, double before) {
    const bool changes = rapid_ != rapidBefore_;
    path_.lengths.push_back(length);
    path_.speeds.push_back(speed);
    path_.corners.push_back(path_.lengths.size() == 1 || changes ? 0.0 : before);
    kinds_.push_back({record_->isn, rapid_, table_.moves - 1});
    rapidBefore_ = rapid_;
  }

  void stop() {
    direction_.reset();
    arcBefore_ = false;
  }

  /// Times what there is so far; the tool stands at its end.
  void plan() {
    if (!path_.lengths.empty()) {
      path_.corners.push_back(0.0);
      std::vector<double> lengths = path_.lengths;
      const Plan plan(std::move(path_), machine_.limits);
      const std::vector<double> times = plan.pieceTimes();
      for (std::size_t i = 0; i < times.size(); ++i) {
        (kinds_[i].rapid ? table_.rapid : table_.cutting) += times[i];
        (kinds_[i].rapid ? table_.rapidLength : table_.cuttingLength) += lengths[i];
        table_.statements[kinds_[i].isn] += times[i];
        if (pieceCall) {
          pieceCall(kinds_[i].move, times[i]);
        }
      }
    }
    path_ = {};
    kinds_.clear();
    stop();
  }

  struct Kind {
    int isn;
    bool rapid;
    std::uint64_t move;
  };
  Machine machine_;
  DiagnosticSink& sink_;
  const cl::Record* record_ = nullptr;
  SpeedLimits path_;
  std::vector<Kind> kinds_;
  TimeTable table_;
  double unit_ = 1.0;  // mm
  hole::CycleFeed<FeedInForce> feed_;
  hole::Cycles cycles_;
  bool rapid_ = false;
  bool rapidBefore_ = false;
  bool feedReported_ = false;
  bool arcBefore_ = false;
  std::optional<Vec3> at_;
  std::optional<Vec3> direction_;  // of the last move; none: the tool stands
  double lengthBefore_ = 0.0;      // its length
  std::optional<cl::SurfaceValue> surface_;
  std::optional<cl::SurfaceValue> run_;
  std::optional<SplineFollower> follower_;
  path::ClSpline clSpline_;
};

CutTimer::CutTimer(const Machine& machine, DiagnosticSink& sink)
    : path_(std::make_unique<Path>(machine, sink)) {}
CutTimer::~CutTimer() = default;
CutTimer::CutTimer(CutTimer&&) noexcept = default;

void CutTimer::accept(const cl::Record& record) {
  path_->accept(record);
}

void CutTimer::tellPieces(PieceCall call) {
  path_->pieceCall = std::move(call);
}

TimeTable CutTimer::finish() {
  return path_->finish();
}

}  // namespace arelem::timing
