#include "runtime/path/arc_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "ir/cl/post_word.h"
#include "ir/space/motion_tolerance.h"
#include "ir/space/tolerance.h"
#include "runtime/path/arc_run.h"
#include "runtime/path/cycle_watch.h"
#include "runtime/path/point_records.h"
#include "runtime/timing/feed.h"

namespace arelem::path {

namespace {

/// A run is an arc when it takes the place of at least so many cut vectors.
constexpr std::size_t leastPoints = 4;
/// Each of the two errors of an arc (its points, its chords) may use half of the allowance.
constexpr double halfShare = 0.5;

/// The largest n in [least, most] for which `holds`, found by doubling and halving; 0 for none.
template <class Holds>
std::size_t longest(std::size_t least, std::size_t most, Holds holds) {
  if (most < least || !holds(least)) {
    return 0;
  }
  std::size_t good = least;
  std::size_t step = least;
  while (good < most) {
    const std::size_t next = std::min(most, good + step);
    if (!holds(next)) {
      most = next - 1;
      break;
    }
    good = next;
    step *= 2;
  }
  while (good < most) {
    const std::size_t middle = good + (most - good + 1) / 2;
    if (holds(middle)) {
      good = middle;
    } else {
      most = middle - 1;
    }
  }
  return good;
}

class Stage : public ArcFitter {
 public:
  Stage(cl::RecordSink& next, double share) : next_(next), share_(share) {}

  void accept(const cl::Record& record) override {
    if (const auto* motion = std::get_if<cl::Motion>(&record.body)) {
      return take(record, *motion);
    }
    flush();
    if (const auto* post = std::get_if<cl::Post>(&record.body)) {
      rapid_ = rapid_ || cl::is(*post, Word::RAPID);
      cycle_.take(*post);
      feed_.take(*post);
    } else if (const auto* values = std::get_if<cl::Values>(&record.body)) {
      const double value = values->values.empty() ? 0.0 : std::abs(values->values.back());
      inner_ = values->word == Word::INTOL ? value : inner_;
      outer_ = values->word == Word::OUTTOL ? value : outer_;
    }
    surfaced_ = std::holds_alternative<cl::Surface>(record.body);
    next_.accept(record);
  }
  void finish() override { flush(); }

 private:
  void take(const cl::Record& record, const cl::Motion& motion) {
    const bool continues = motion.kind == cl::Motion::Kind::continuation;
    const bool plain = share_ > 0.0 && motion.kind != cl::Motion::Kind::from && !motion.withSide &&
                       !cycle_.isOn() && !feed_.isInverse() && !rapid_ && at_ &&
                       !(continues ? keptWhole_ : surfaced_) && sameAxes(motion);
    if (!plain) {
      flush();
      keptWhole_ = true;
      next_.accept(record);
      if (motion.points() > 0) {
        at_ = Vec3(&motion.coordinates[motion.coordinates.size() - motion.stride()]);
      }
      if (cycle_.isOn()) {
        at_.reset();  // above the hole, as high as the control comes back
      }
      rapid_ = surfaced_ = false;
      return;
    }
    keptWhole_ = false;
    if (points_.empty()) {
      first_ = record;
    }
    for (std::size_t i = 0; i < motion.coordinates.size(); i += motion.stride()) {
      points_.emplace_back(&motion.coordinates[i]);
    }
    if (motion.withAxis) {
      axis_ = Vec3(&motion.coordinates[3]);
    }
  }

  /// The axes of a record are all the same, and those of what is held.
  bool sameAxes(const cl::Motion& motion) const {
    if (!motion.withAxis) {
      return true;
    }
    const Vec3 axis = points_.empty() ? Vec3(&motion.coordinates[3]) : axis_;
    for (std::size_t i = 3; i < motion.coordinates.size(); i += motion.stride()) {
      if ((Vec3(&motion.coordinates[i]) - axis).norm() > tolerance::rounding) {
        return false;
      }
    }
    return true;
  }

  void flush() {
    if (points_.empty()) {
      return;
    }
    std::vector<Vec3> all{*at_};
    all.insert(all.end(), points_.begin(), points_.end());
    const double allowed = share_ * (inner_ + outer_);
    std::vector<Vec3> lines;
    std::size_t i = 0;
    while (i + 1 < all.size()) {
      const std::span<const Vec3> rest = std::span<const Vec3>(all).subspan(i);
      const std::size_t straight = straightPoints(rest, allowed);
      int axis = 2;
      const std::size_t round = roundPoints(rest, allowed, axis);
      if (round >= leastPoints && round > straight) {
        put(lines);
        lines.clear();
        putArc(rest.first(round + 1), axis, allowed);
        i += round;
      } else {
        lines.push_back(all[i + straight]);
        i += straight;
      }
    }
    put(lines);
    at_ = all.back();
    points_.clear();
  }

  static std::size_t straightPoints(std::span<const Vec3> rest, double allowed) {
    const auto holds = [&](std::size_t n) { return isStraight(rest.first(n + 1), allowed); };
    return std::max<std::size_t>(longest(2, rest.size() - 1, holds), 1);
  }
  std::size_t roundPoints(std::span<const Vec3> rest, double allowed, int& axis) {
    std::size_t most = 0;
    for (const int k : {2, 1, 0}) {
      const auto holds = [&](std::size_t n) {
        return arcThrough(rest.first(n + 1), k, halfShare * allowed, sweeps_).has_value();
      };
      const std::size_t n = longest(leastPoints, rest.size() - 1, holds);
      if (n > most) {
        most = n;
        axis = k;
      }
    }
    return most;
  }

  void putArc(std::span<const Vec3> points, int axis, double allowed) {
    const auto run = arcThrough(points, axis, halfShare * allowed, sweeps_);
    cl::Record record = first_;
    cl::Surface circle;
    const bool upright = axis == 2;
    circle.surface.type = upright ? EntityType::circle : EntityType::cylinder;
    const Vec3 direction = Vec3::Unit(axis);
    circle.surface.canon = {run->center.x(), run->center.y(), run->center.z(), direction.x(),
                            direction.y(),   direction.z(),   run->radius};
    record.body = std::move(circle);
    next_.accept(record);
    put(chordsOf(*run, sweeps_.back(), halfShare * allowed, points.back()));
  }

  /// As few places on the arc as leave all chords near to it.
  static std::vector<Vec3> chordsOf(const ArcRun& run, double sweep, double off, const Vec3& end) {
    const double most = 2.0 * std::acos(1.0 - std::min(1.0, off / run.radius));
    const auto count =
        static_cast<std::size_t>(std::ceil(std::abs(sweep) / std::min(most, ArcRun::mostStep)));
    std::vector<Vec3> on;
    for (std::size_t i = 1; i < count; ++i) {
      on.push_back(run.at(sweep * static_cast<double>(i) / static_cast<double>(count)));
    }
    on.push_back(end);
    return on;
  }

  void put(const std::vector<Vec3>& points) { putPoints(next_, first_, points, axis_); }

  cl::RecordSink& next_;
  double share_;
  double inner_ = 0.0, outer_ = tolerance::defaultOutside;
  CycleWatch cycle_;
  // Under an inverse time the moves that a fit makes one would take the time of one.
  timing::FeedInForce feed_;
  bool rapid_ = false;
  bool surfaced_ = false;   // the record before told a surface
  bool keptWhole_ = false;  // the sequence so far is passed on as it is
  std::optional<Vec3> at_;
  cl::Record first_;  // of what is held
  std::vector<Vec3> points_;
  Vec3 axis_ = Vec3::UnitZ();
  std::vector<double> sweeps_;
};

}  // namespace

std::unique_ptr<ArcFitter> makeArcFitter(cl::RecordSink& next, double share) {
  return std::make_unique<Stage>(next, share);
}

}  // namespace arelem::path
