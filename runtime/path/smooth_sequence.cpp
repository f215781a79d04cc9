#include "runtime/path/smooth_sequence.h"

#include <algorithm>
#include <span>

#include "ir/diag/curves.h"
#include "ir/diag/spline.h"
#include "ir/space/smooth_tolerance.h"
#include "ir/space/tolerance.h"
#include "runtime/path/point_records.h"
#include "runtime/spline/fit.h"
#include "runtime/timing/cut_timer.h"

namespace arelem::path {

namespace {

constexpr int samplesOfASpan = 5;
constexpr double secondsOfAMinute = 60.0;

/// The points of a closed path, the first one not repeated.
Result<std::vector<Vec3>> ring(const std::vector<Vec3>& points) {
  const double apart = (points.back() - points.front()).norm();
  if (apart > tolerance::coincidence || points.size() < 4) {
    return fail(diag::SmoothNotClosed, apart, points.size());
  }
  return std::vector<Vec3>(points.begin(), points.end() - 1);
}

/// Where a path leads straight back there is no side to turn to.
std::optional<Failure> cusp(const std::vector<Vec3>& points, bool closed) {
  const std::size_t n = points.size();
  for (std::size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < n; ++i) {
    const Vec3& p = points[i];
    const Vec3 in = (p - points[(i + n - 1) % n]).normalized();
    const Vec3 out = (points[(i + 1) % n] - p).normalized();
    if ((in + out).norm() <= tolerance::cusp) {
      return fail(diag::SmoothCusp, p.x(), p.y(), p.z());
    }
  }
  return std::nullopt;
}

/// Collects what putPoints makes.
class Kept : public cl::RecordSink {
 public:
  explicit Kept(std::vector<cl::Record>& records) : records_(records) {}
  void accept(const cl::Record& record) override { records_.push_back(record); }

 private:
  std::vector<cl::Record>& records_;
};

/// Seconds of the machine along records that begin at a place, from rest to rest.
class Stopwatch {
 public:
  explicit Stopwatch(const SmoothSequence& sequence) {
    const double unit = sequence.unit;
    machine_.limits = {sequence.limits.velocity / unit, sequence.limits.acceleration / unit,
                       sequence.limits.jerk / unit};
    machine_.deviation /= unit;
    speed_ = sequence.speed > 0.0 ? sequence.speed / unit : machine_.limits.velocity;
  }
  [[nodiscard]] double seconds(const Vec3& from, const std::vector<cl::Record>& records) const {
    CollectingSink ignored;  // of what was said when the records came in
    timing::CutTimer timer(machine_, ignored);
    cl::Record record;
    record.body = cl::Post{Word::FEDRAT, "", {speed_ * secondsOfAMinute, Word::MMPM}};
    timer.accept(record);
    cl::Motion start;
    start.kind = cl::Motion::Kind::from;
    start.coordinates = {from.x(), from.y(), from.z()};
    record.body = std::move(start);
    timer.accept(record);
    for (const cl::Record& one : records) {
      timer.accept(one);
    }
    return timer.finish().total();
  }
  /// In the part unit.
  [[nodiscard]] timing::Limits limits() const {
    return {std::min(machine_.limits.velocity, speed_), machine_.limits.acceleration,
            machine_.limits.jerk};
  }

 private:
  timing::Machine machine_;
  double speed_ = 0.0;
};

std::vector<cl::Record> cutVectors(const SmoothSequence& sequence, std::span<const Vec3> points) {
  std::vector<cl::Record> records;
  Kept kept(records);
  putPoints(kept, sequence.first, points, sequence.axis.value_or(Vec3::UnitZ()));
  return records;
}

/// A chorded curve as records: its start where the tool is not there, the curve, its places.
std::vector<cl::Record> asRecords(const SmoothSequence& sequence,
                                  const spline::CubicSpline& curve,
                                  const std::vector<Vec3>& chords,
                                  bool keepSpline) {
  std::vector<cl::Record> records;
  if ((chords.front() - sequence.points.front()).norm() > tolerance::coincidence) {
    records = cutVectors(sequence, std::span(chords).first(1));
  }
  if (keepSpline) {
    cl::Record& record = records.emplace_back(sequence.first);
    cl::Surface surface;
    surface.surface = {EntityType::pathSpline, "", 0, curve.canon()};
    record.body = std::move(surface);
  }
  const std::vector<cl::Record> rest = cutVectors(sequence, std::span(chords).subspan(1));
  records.insert(records.end(), rest.begin(), rest.end());
  return records;
}

/// The curve by one method, and its cut vectors.
Result<SmoothedSequence> smoothedBy(smooth::Method method,
                                    const spline::CubicSpline& fitted,
                                    const SmoothSequence& sequence,
                                    const SmoothOrder& order,
                                    const Stopwatch& watch) {
  smooth::Options options = order.options;
  options.method = method;
  options.limits = watch.limits();
  const Result<smooth::Smoothed> result = smooth::smooth(fitted, options);
  if (!result) {
    return result.failure();
  }
  const double chord = SmoothOrder::chordShare * order.tolerance;
  const double fit = order.share * order.tolerance;
  const std::vector<Vec3> chords = spline::chordPoints(result->curve, chord);
  SmoothedSequence smoothed;
  smoothed.records = asRecords(sequence, result->curve, chords, order.keepSpline);
  smoothed.end = chords.back();
  const auto old = curvatureFigures(fitted, samplesOfASpan);
  const auto now = curvatureFigures(result->curve, samplesOfASpan);
  smoothed.fact = {sequence.first.origin,
                   old.most,
                   now.most,
                   old.mean,
                   now.mean,
                   fitted.length(),
                   result->curve.length(),
                   result->deviation + fit + chord};
  smoothed.secondsAfter = watch.seconds(sequence.points.front(), smoothed.records);
  return smoothed;
}

}  // namespace

Result<SmoothedSequence> smoothSequence(const SmoothSequence& sequence, const SmoothOrder& order) {
  const Result<std::vector<Vec3>> points =
      order.closed ? ring(sequence.points) : Result(sequence.points);
  if (!points) {
    return points.failure();
  }
  if (auto failure = cusp(*points, order.closed)) {
    return *std::move(failure);
  }
  const auto fitted = spline::followPolyline(*points, order.share * order.tolerance, order.closed);
  if (!fitted) {
    return fitted.failure();
  }
  const Stopwatch watch(sequence);
  const smooth::Method method = order.options.method;
  Result<SmoothedSequence> best = smoothedBy(method, *fitted, sequence, order, watch);
  if (best && method == smooth::Method::time) {
    // The curve of least time passes its ends at speed; the cut vectors have the last word.
    auto other = smoothedBy(smooth::Method::tube, *fitted, sequence, order, watch);
    if (other && other->secondsAfter < best->secondsAfter) {
      best = std::move(other);
    }
  }
  if (best) {
    const std::vector<cl::Record> given =
        cutVectors(sequence, std::span(sequence.points).subspan(1));
    best->secondsBefore = watch.seconds(sequence.points.front(), given);
  }
  return best;
}

}  // namespace arelem::path
