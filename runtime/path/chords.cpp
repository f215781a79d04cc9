#include "runtime/path/chords.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "ir/space/motion_tolerance.h"
#include "ir/space/tolerance.h"
#include "runtime/path/cl_spline.h"
#include "runtime/path/cycle_watch.h"
#include "runtime/path/point_records.h"

namespace arelem::path {

namespace {
constexpr double fullTurn = 2.0 * std::numbers::pi;
/// Largest turn over one cut vector, however coarse the tolerance is.
constexpr double mostStep = std::numbers::pi / 6.0;
/// Bounds the vectors of one arc of any radius and tolerance.
constexpr double mostSteps = 1e6;

class Stage : public ChordStage {
 public:
  Stage(cl::RecordSink& next, DiagnosticSink& sink, std::optional<double> sag)
      : next_(next), sink_(sink), sag_(sag) {}

  void accept(const cl::Record& record) override {
    if (const auto* motion = std::get_if<cl::Motion>(&record.body)) {
      return move(record, *motion);
    }
    if (const auto* post = std::get_if<cl::Post>(&record.body)) {
      cycle_.take(*post);
      if (spline_.take(*post)) {
        return;
      }
    }
    if (const auto* surface = std::get_if<cl::Surface>(&record.body)) {
      circle_ = surface->surface;
    } else if (const auto* values = std::get_if<cl::Values>(&record.body)) {
      const double value = values->values.empty() ? 0.0 : std::abs(values->values.back());
      inner_ = values->word == Word::INTOL ? value : inner_;
      outer_ = values->word == Word::OUTTOL ? value : outer_;
    }
    next_.accept(record);
  }

 private:
  [[nodiscard]] double band() const {
    if (sag_) {
      return *sag_;
    }
    const double both = inner_ + outer_;
    return both > 0.0 ? both : tolerance::defaultOutside;
  }

  void move(const cl::Record& record, const cl::Motion& motion) {
    if (motion.points() > 0 && motion.way != cl::Motion::Way::straight && at_) {
      const Vec3 end(motion.coordinates.data());
      std::vector<Vec3> points;
      if (cycle_.isOn()) {
        points = {end};  // one hole
      } else if (motion.isArc()) {
        points = arc(end, motion.way == cl::Motion::Way::counterclockwise);
      } else if (auto found = spline_.points(*at_, band())) {
        points = *std::move(found);
      } else {
        sink_.accept(at(record.origin, found.takeFailure()));
        points = {end};
      }
      put(record, motion, points);
    } else {
      next_.accept(record);
    }
    spline_.clear();
    remember(motion);
  }

  void remember(const cl::Motion& motion) {
    if (motion.points() > 0) {
      const double* last = &motion.coordinates[motion.coordinates.size() - motion.stride()];
      at_ = Vec3(last);
      axis_ = motion.withAxis ? Vec3(last + 3) : Vec3(Vec3::UnitZ());
    }
  }

  /// Turns the start about the axis; radius and height change evenly, so that the last point is the
  /// end whatever the digits of the file took away.
  [[nodiscard]] std::vector<Vec3> arc(const Vec3& end, bool counterclockwise) const {
    if (!circle_ || circle_->canon.size() != 7) {
      return {end};
    }
    const Vec3 center(circle_->canon.data());
    const Vec3 axis = (counterclockwise ? 1.0 : -1.0) * Vec3(&circle_->canon[3]).normalized();
    const auto height = [&](const Vec3& p) { return (p - center).dot(axis); };
    const Vec3 a = *at_ - center - height(*at_) * axis;
    const Vec3 b = end - center - height(end) * axis;
    double sweep = std::atan2(axis.dot(a.cross(b)), a.dot(b));
    const bool whole = (b - a).norm() <= tolerance::symmetric * (1.0 + a.norm());
    sweep = whole ? fullTurn : sweep <= 0.0 ? sweep + fullTurn : sweep;
    const double radius = std::max(a.norm(), b.norm());
    const double ratio = std::max(-1.0, 1.0 - band() / radius);
    const double step = std::min(mostStep, 2.0 * std::acos(ratio));
    const double wanted = std::ceil(sweep / step - tolerance::symmetric);
    const auto count = static_cast<std::size_t>(std::clamp(wanted, 2.0, mostSteps));
    std::vector<Vec3> points;
    for (std::size_t k = 1; k < count; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(count);
      const Vec3 turned = Eigen::AngleAxisd(t * sweep, axis) * a;
      const double scale = 1.0 + t * (b.norm() / a.norm() - 1.0);
      const double rise = height(*at_) + t * (height(end) - height(*at_));
      points.push_back(center + scale * turned + rise * axis);
    }
    points.push_back(end);
    return points;
  }

  /// The axis turns evenly from where it was to that of the record.
  void put(const cl::Record& record, const cl::Motion& motion, const std::vector<Vec3>& points) {
    cl::Record out = record;
    auto& chords = std::get<cl::Motion>(out.body);
    chords.way = cl::Motion::Way::straight;
    chords.withSide = false;
    chords.coordinates.clear();
    const Vec3 axis = motion.withAxis ? Vec3(&motion.coordinates[3]) : Vec3(Vec3::UnitZ());
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (!sag_ && chords.coordinates.size() + chords.stride() > numbersPerRecord) {
        next_.accept(out);
        chords.coordinates.clear();
        chords.kind = cl::Motion::Kind::continuation;
      }
      const double t = static_cast<double>(k + 1) / static_cast<double>(points.size());
      chords.coordinates.insert(chords.coordinates.end(), points[k].data(), points[k].data() + 3);
      if (motion.withAxis) {
        const Vec3 between = k + 1 == points.size() ? axis : Vec3((1.0 - t) * axis_ + t * axis);
        const Vec3 unit = between.normalized();
        chords.coordinates.insert(chords.coordinates.end(), unit.data(), unit.data() + 3);
      }
    }
    next_.accept(out);
  }

  cl::RecordSink& next_;
  DiagnosticSink& sink_;
  std::optional<double> sag_;
  ClSpline spline_;
  CycleWatch cycle_;
  std::optional<cl::SurfaceValue> circle_;
  std::optional<Vec3> at_;
  Vec3 axis_ = Vec3::UnitZ();
  double inner_ = 0.0;
  double outer_ = tolerance::defaultOutside;
};
}  // namespace

std::unique_ptr<ChordStage> makeChordStage(cl::RecordSink& next,
                                           DiagnosticSink& sink,
                                           std::optional<double> sag) {
  return std::make_unique<Stage>(next, sink, sag);
}

}  // namespace arelem::path
