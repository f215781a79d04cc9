#include "runtime/path/smoother.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "ir/cl/post_word.h"
#include "ir/diag/spline.h"
#include "ir/space/tolerance.h"
#include "ir/words/units.h"
#include "runtime/path/point_records.h"
#include "runtime/path/smooth_order.h"
#include "runtime/spline/fit.h"
#include "runtime/timing/machine_limits.h"

namespace arelem::path {

namespace {

constexpr int samplesOfASpan = 5;
/// Locations of a path that can be smoothed.
constexpr std::size_t fewest = 3;

class Stage : public Smoother {
 public:
  Stage(cl::RecordSink& next, DiagnosticSink& sink, const InterruptFlag* interrupted)
      : next_(next), sink_(sink), interrupted_(interrupted) {}

  void accept(const cl::Record& record) override {
    if (const auto* motion = std::get_if<cl::Motion>(&record.body)) {
      return take(record, *motion);
    }
    const auto* post = std::get_if<cl::Post>(&record.body);
    const std::string_view name = post != nullptr ? cl::nameOf(*post) : std::string_view();
    if (order_ && std::holds_alternative<cl::Card>(record.body)) {
      next_.accept(record);
      return;
    }
    if (order_ && std::holds_alternative<cl::Surface>(record.body)) {
      if (held_.empty()) {
        surface_ = record;
      }
      return;  // the smoothed points no longer run along it
    }
    flush();
    if (const auto* units = std::get_if<cl::Units>(&record.body)) {
      unit_ = millimetersOf(units->unit);
    }
    if (name == "SMOOTH") {
      return command(record, *post);  // no output has to know of it
    }
    if (name == "MACHLM") {
      Result<timing::Limits> limits = timing::machineLimits(*post);
      if (limits) {
        limits_ = *limits;
      } else {
        sink_.accept(at(record.origin, limits.takeFailure()));
      }
    }
    rapid_ = rapid_ || name == "RAPID";
    next_.accept(record);
  }

  void finish() override {
    flush();
    if (order_) {
      sink_.accept(diagnose(commandOrigin_, diag::SmoothOpen));
    }
    endOrder();
  }
  [[nodiscard]] const std::vector<SmoothFact>& facts() const override { return facts_; }

 private:
  /// What came of the statement that ends.
  void endOrder() {
    if (order_ && twins_ > 0) {
      sink_.accept(diagnose(commandOrigin_, diag::SmoothTwins, twins_));
    }
    if (order_ && longest_ > 0 && longest_ < fewest) {
      sink_.accept(at(commandOrigin_, fail(diag::SmoothNothing, longest_)));
    }
    order_.reset();
    twins_ = 0;
    longest_ = 0;
  }

  void command(const cl::Record& record, const cl::Post& post) {
    endOrder();
    if (endsSmoothing(post)) {
      return;
    }
    Result<SmoothOrder> order = readSmoothOrder(post);
    if (!order) {
      sink_.accept(at(record.origin, order.takeFailure()));
      return;
    }
    order_ = *std::move(order);
    order_->options.interrupted = interrupted_;
    commandOrigin_ = record.origin;
  }

  void take(const cl::Record& record, const cl::Motion& motion) {
    const bool startsAnew = motion.kind == cl::Motion::Kind::from || rapid_;
    if (!order_ || startsAnew || !at_) {
      flush();
      next_.accept(record);
      rapid_ = false;
    } else {
      held_.push_back(record);
    }
    if (motion.points() > 0) {
      const double* last = &motion.coordinates[motion.coordinates.size() - motion.stride()];
      if (held_.empty()) {
        at_ = Vec3(last[0], last[1], last[2]);
      }
    }
  }

  /// Puts out what was held back, smoothed where that is possible.
  void flush() {
    if (!held_.empty() && !smoothHeld()) {
      if (surface_) {
        next_.accept(*surface_);
      }
      for (const cl::Record& record : held_) {
        next_.accept(record);
      }
      const auto& motion = std::get<cl::Motion>(held_.back().body);
      const double* last = &motion.coordinates[motion.coordinates.size() - motion.stride()];
      at_ = Vec3(last[0], last[1], last[2]);
    }
    held_.clear();
    surface_.reset();
  }

  bool smoothHeld() {
    std::vector<Vec3> points{*at_};
    std::optional<Vec3> axis;
    for (const cl::Record& record : held_) {
      const auto& motion = std::get<cl::Motion>(record.body);
      if (motion.withSide) {
        sink_.accept(at(record.origin, fail(diag::SmoothSide)));
        return false;
      }
      for (std::size_t i = 0; i + motion.stride() <= motion.coordinates.size();
           i += motion.stride()) {
        const Vec3 p(&motion.coordinates[i]);
        if ((p - points.back()).norm() > tolerance::coincidence) {
          points.push_back(p);
        } else {
          ++twins_;
        }
        if (motion.withAxis && !sameAxis(record, axis, Vec3(&motion.coordinates[i + 3]))) {
          return false;
        }
      }
    }
    longest_ = std::max(longest_, points.size());
    if (points.size() < fewest) {
      return false;
    }
    return replace(points, axis);
  }

  bool sameAxis(const cl::Record& record, std::optional<Vec3>& axis, const Vec3& now) {
    axis = axis.value_or(now);
    const double off = axis->cross(now).norm();
    if (off > tolerance::nullDirection) {
      sink_.accept(at(record.origin, fail(diag::SmoothAxis, std::asin(std::min(off, 1.0)) * 180.0 /
                                                                std::numbers::pi)));
      return false;
    }
    return true;
  }

  /// The points of a closed path, the first one not repeated.
  static Result<std::vector<Vec3>> ring(const std::vector<Vec3>& points) {
    const double apart = (points.back() - points.front()).norm();
    if (apart > tolerance::coincidence || points.size() < 4) {
      return fail(diag::SmoothNotClosed, apart, points.size());
    }
    return std::vector<Vec3>(points.begin(), points.end() - 1);
  }

  bool replace(const std::vector<Vec3>& all, const std::optional<Vec3>& axis) {
    const cl::Record first = held_.front();
    const double share = order_->share * order_->tolerance;
    const Result<std::vector<Vec3>> points = order_->closed ? ring(all) : Result(all);
    if (!points) {
      sink_.accept(at(first.origin, points.failure()));
      return false;
    }
    const auto fitted = spline::followPolyline(*points, share, order_->closed);
    if (!fitted) {
      sink_.accept(at(first.origin, fitted.failure()));
      return false;
    }
    smooth::Options options = order_->options;
    options.limits = {limits_.velocity / unit_, limits_.acceleration / unit_, limits_.jerk / unit_};
    const Result<smooth::Smoothed> result = smooth::smooth(*fitted, options);
    if (!result) {
      sink_.accept(at(first.origin, result.failure()));
      return false;
    }
    const double chord = SmoothOrder::chordShare * order_->tolerance;
    note(first, *fitted, *result, share + chord);
    const std::vector<Vec3> chords = spline::chordPoints(result->curve, chord);
    if ((chords.front() - *at_).norm() > tolerance::coincidence) {
      put(first, std::span(chords).first(1), axis);
    }
    if (order_->keepSpline) {
      cl::Record curve = first;
      cl::Surface surface;
      surface.surface = {EntityType::pathSpline, "", 0, result->curve.canon()};
      curve.body = std::move(surface);
      next_.accept(curve);
    }
    put(first, std::span(chords).subspan(1), axis);
    at_ = chords.back();
    return true;
  }

  void note(const cl::Record& record,
            const spline::CubicSpline& before,
            const smooth::Smoothed& after,
            double spent) {
    const auto old = curvatureFigures(before, samplesOfASpan);
    const auto now = curvatureFigures(after.curve, samplesOfASpan);
    facts_.push_back({record.origin, old.most, now.most, old.mean, now.mean, before.length(),
                      after.curve.length(), after.deviation + spent});
  }

  void put(const cl::Record& like, std::span<const Vec3> points, const std::optional<Vec3>& axis) {
    putPoints(next_, like, points, axis.value_or(Vec3::UnitZ()));
  }

  cl::RecordSink& next_;
  DiagnosticSink& sink_;
  const InterruptFlag* interrupted_;
  std::optional<SmoothOrder> order_;
  Span commandOrigin_;
  timing::Limits limits_ = smooth::Options{}.limits;  // mm
  double unit_ = 1.0;                                 // mm
  bool rapid_ = false;
  std::optional<Vec3> at_;  // the location before what is held
  std::vector<cl::Record> held_;
  std::optional<cl::Record> surface_;
  std::size_t twins_ = 0;    ///< locations of the order in force that repeat the one before
  std::size_t longest_ = 0;  ///< locations of its longest sequence
  std::vector<SmoothFact> facts_;
};

}  // namespace

std::unique_ptr<Smoother> makeSmoother(cl::RecordSink& next,
                                       DiagnosticSink& sink,
                                       const InterruptFlag* interrupted) {
  return std::make_unique<Stage>(next, sink, interrupted);
}

}  // namespace arelem::path
