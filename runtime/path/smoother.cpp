#include "runtime/path/smoother.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "ir/cl/post_word.h"
#include "ir/diag/curves.h"
#include "ir/diag/spline.h"
#include "ir/space/tolerance.h"
#include "ir/words/units.h"
#include "runtime/path/cycle_watch.h"
#include "runtime/path/smooth_sequence.h"
#include "runtime/timing/feed.h"
#include "runtime/timing/machine_limits.h"

namespace arelem::path {

namespace {

/// A curvature or time that is this many times that of before is told.
constexpr double toldFrom = 1.01;
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
      feed_.setUnit(unit_);
    }
    if (name == "SMOOTH") {
      return command(record, *post);  // no output has to know of it
    }
    if (post != nullptr) {
      takeFeed(record, *post);
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
    if (order_ && !told_ && longest_ < fewest) {
      sink_.accept(at(commandOrigin_, fail(diag::SmoothNothing, longest_)));
    }
    order_.reset();
    twins_ = 0;
    longest_ = 0;
    told_ = false;
  }

  /// Under an inverse time each cut vector would take the time of the whole move that it is of.
  void takeFeed(const cl::Record& record, const cl::Post& post) {
    cycle_.take(post);
    feed_.take(post);
    if (order_ && feed_.isInverse() && cl::is(post, Word::FEDRAT)) {
      sink_.accept(diagnose(record.origin, diag::SmoothInverse));
    }
  }

  void command(const cl::Record& record, const cl::Post& post) {
    const bool ends = endsSmoothing(post);
    if (ends && std::exchange(refused_, false)) {
      return;  // told where it was to begin
    }
    if (ends != order_.has_value()) {
      sink_.accept(ends ? diagnose(record.origin, diag::SmoothNotOn)
                        : diagnose(record.origin, diag::SmoothNested)
                              .label(commandOrigin_, "it is on from here"));
      return;
    }
    endOrder();
    if (ends) {
      return;
    }
    if (feed_.isInverse()) {
      sink_.accept(diagnose(record.origin, diag::SmoothInverse));
    }
    Result<SmoothOrder> order = readSmoothOrder(post);
    refused_ = !order;
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
    if (!order_ || startsAnew || !at_ || cycle_.isOn()) {
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
      if (cycle_.isOn()) {
        at_.reset();  // above the hole, as high as the control comes back
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
        told_ = true;
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
    return replace(std::move(points), axis);
  }

  bool sameAxis(const cl::Record& record, std::optional<Vec3>& axis, const Vec3& now) {
    axis = axis.value_or(now);
    const double off = axis->cross(now).norm();
    if (off > tolerance::nullDirection) {
      told_ = true;
      sink_.accept(at(record.origin, fail(diag::SmoothAxis, std::asin(std::min(off, 1.0)) * 180.0 /
                                                                std::numbers::pi)));
      return false;
    }
    return true;
  }

  /// The methods that look at the curvature alone may cost time, and the source's even curvature.
  void tellWorse(const cl::Record& first, const SmoothedSequence& now) {
    const SmoothFact& fact = now.fact;
    if (order_->options.method == smooth::Method::time) {
      return;  // its figure is the time
    }
    if (fact.mostAfter > toldFrom * fact.mostBefore ||
        now.secondsAfter > toldFrom * now.secondsBefore) {
      sink_.accept(diagnose(first.origin, diag::SmoothWorse,
                            static_cast<int>(order_->options.method) + 1, fact.mostBefore,
                            fact.mostAfter, now.secondsBefore, now.secondsAfter));
    }
  }

  /// Puts out the smoothed path; false where the given one stays.
  bool replace(std::vector<Vec3> points, const std::optional<Vec3>& axis) {
    const cl::Record& first = held_.front();
    SmoothSequence sequence{first, std::move(points), axis, unit_, 0.0, limits_};
    constexpr double secondsOfAMinute = 60.0;
    sequence.speed = feed_.perMinute(0.0) / secondsOfAMinute;
    Result<SmoothedSequence> smoothed = smoothSequence(sequence, *order_);
    if (!smoothed) {
      sink_.accept(at(first.origin, smoothed.takeFailure()));
      return false;
    }
    if (order_->options.method == smooth::Method::time &&
        smoothed->secondsAfter > smoothed->secondsBefore) {
      sink_.accept(diagnose(first.origin, diag::SmoothSlower, smoothed->secondsAfter,
                            smoothed->secondsBefore));
      return false;
    }
    tellWorse(first, *smoothed);
    for (const cl::Record& record : smoothed->records) {
      next_.accept(record);
    }
    at_ = smoothed->end;
    SmoothFact& fact = facts_.emplace_back(smoothed->fact);
    fact.secondsBefore = smoothed->secondsBefore;
    fact.secondsAfter = smoothed->secondsAfter;
    return true;
  }

  cl::RecordSink& next_;
  DiagnosticSink& sink_;
  const InterruptFlag* interrupted_;
  std::optional<SmoothOrder> order_;
  bool refused_ = false;  ///< the last order was wrong
  Span commandOrigin_;
  timing::Limits limits_ = smooth::Options{}.limits;  // mm
  double unit_ = 1.0;                                 // mm
  timing::FeedInForce feed_;
  CycleWatch cycle_;
  bool rapid_ = false;
  std::optional<Vec3> at_;  // the location before what is held
  std::vector<cl::Record> held_;
  std::optional<cl::Record> surface_;
  std::size_t twins_ = 0;    ///< locations of the order in force that repeat the one before
  std::size_t longest_ = 0;  ///< locations of its longest sequence
  bool told_ = false;        ///< a sequence of the order in force was refused with its reason
  std::vector<SmoothFact> facts_;
};

}  // namespace

std::unique_ptr<Smoother> makeSmoother(cl::RecordSink& next,
                                       DiagnosticSink& sink,
                                       const InterruptFlag* interrupted) {
  return std::make_unique<Stage>(next, sink, interrupted);
}

}  // namespace arelem::path
