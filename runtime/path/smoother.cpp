#include "runtime/path/smoother.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "ir/diag/spline.h"
#include "ir/space/tolerance.h"
#include "runtime/smooth/smooth.h"
#include "runtime/spline/fit.h"

namespace arelem::path {

namespace {

constexpr double defaultShare = 0.2;
constexpr std::size_t numbersPerRecord = 240;
constexpr int samplesOfASpan = 5;

constexpr double mostPrecision = 1000.0;

/// A word of the vocabulary or of none, as it is written; "" for a number.
std::string_view spelling(const cl::Value& value) {
  if (const Word* word = std::get_if<Word>(&value)) {
    return spell(*word);
  }
  const std::string* text = std::get_if<std::string>(&value);
  return text == nullptr ? std::string_view() : std::string_view(*text);
}
std::string_view nameOf(const cl::Post& post) {
  return post.foreign.empty() ? spell(post.word) : std::string_view(post.foreign);
}

struct Order {
  smooth::Options options;
  double tolerance = 0.0;
  double share = defaultShare;
};

/// Reads SMOOTH/tol [,METHOD,n] [,PRECIS,n] [,ACCUR,percent] [,SHARE,percent].
class OrderReader {
 public:
  explicit OrderReader(const std::vector<cl::Value>& values) : values_(values) {}

  Result<Order> read() {
    const double* tolerance = number(0);
    if (tolerance == nullptr) {
      return fail(diag::SmoothForm, std::string("no tolerance first"));
    }
    Order order;
    order.tolerance = *tolerance;
    if (!(*tolerance > 0.0) || !std::isfinite(*tolerance)) {
      return fail(diag::SmoothTolerance, *tolerance);
    }
    for (std::size_t i = 1; i < values_.size(); ++i) {
      if (auto failure = modifier(order, i)) {
        return *std::move(failure);
      }
    }
    order.options.tolerance = (1.0 - 2.0 * order.share) * order.tolerance;
    return order;
  }

 private:
  [[nodiscard]] const double* number(std::size_t i) const {
    return i < values_.size() ? std::get_if<double>(&values_[i]) : nullptr;
  }

  std::optional<Failure> modifier(Order& order, std::size_t& i) {
    const std::string_view word = spelling(values_[i]);
    const double* value = number(i + 1);
    if (word.empty() || value == nullptr) {
      return fail(diag::SmoothForm, fmt::format("parameter {} that fits no form", i + 1));
    }
    ++i;
    if (word == "METHOD") {
      if (*value != 1.0 && *value != 2.0) {
        return fail(diag::SmoothForm, fmt::format("METHOD {}; there are 1 (the source's) and 2 "
                                                  "(least curvature in the tube)",
                                                  *value));
      }
      order.options.method = *value == 1.0 ? smooth::Method::source : smooth::Method::tube;
    } else if (word == "PRECIS") {
      order.options.precision = static_cast<int>(std::clamp(*value, 0.0, mostPrecision));
    } else if (word == "ACCUR") {
      order.options.accuracy = *value / 100.0;
    } else if (word == "SHARE") {
      order.share = *value / 100.0;
      if (!(order.share > 0.0 && order.share < 0.5)) {
        return fail(diag::SmoothForm,
                    fmt::format("SHARE {}; it lies between 0 and 50 percent", *value));
      }
    } else {
      return fail(diag::SmoothForm, fmt::format("`{}`", word));
    }
    if (order.options.precision < 1 ||
        !(order.options.accuracy > 0.0 && order.options.accuracy < 1.0)) {
      return fail(diag::SmoothSettings, order.options.precision, 100.0 * order.options.accuracy);
    }
    return std::nullopt;
  }

  const std::vector<cl::Value>& values_;
};

class Stage : public Smoother {
 public:
  Stage(cl::RecordSink& next, DiagnosticSink& sink, const InterruptFlag* interrupted)
      : next_(next), sink_(sink), interrupted_(interrupted) {}

  void accept(const cl::Record& record) override {
    if (const auto* motion = std::get_if<cl::Motion>(&record.body)) {
      return take(record, *motion);
    }
    const auto* post = std::get_if<cl::Post>(&record.body);
    const std::string_view name = post != nullptr ? nameOf(*post) : std::string_view();
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
    if (name == "SMOOTH") {
      command(record, *post);
    }
    rapid_ = rapid_ || name == "RAPID";
    next_.accept(record);
  }

  void finish() override {
    flush();
    if (order_) {
      sink_.accept(diagnose(commandOrigin_, diag::SmoothOpen));
    }
  }
  [[nodiscard]] const std::vector<SmoothFact>& facts() const override { return facts_; }

 private:
  void command(const cl::Record& record, const cl::Post& post) {
    order_.reset();
    if (post.arguments.size() == 1 && spelling(post.arguments[0]) == "NOMORE") {
      return;
    }
    Result<Order> order = OrderReader(post.arguments).read();
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
      for (std::size_t i = 0; i + motion.stride() <= motion.coordinates.size();
           i += motion.stride()) {
        const Vec3 p(&motion.coordinates[i]);
        if ((p - points.back()).norm() > tolerance::coincidence) {
          points.push_back(p);
        }
        if (motion.withAxis && !sameAxis(record, axis, Vec3(&motion.coordinates[i + 3]))) {
          return false;
        }
      }
    }
    if (points.size() < 3) {
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

  bool replace(const std::vector<Vec3>& points, const std::optional<Vec3>& axis) {
    const cl::Record first = held_.front();
    const double share = order_->share * order_->tolerance;
    const auto fitted = spline::followPolyline(points, share, false);
    if (!fitted) {
      sink_.accept(at(first.origin, fitted.failure()));
      return false;
    }
    const Result<smooth::Smoothed> result = smooth::smooth(*fitted, order_->options);
    if (!result) {
      sink_.accept(at(first.origin, result.failure()));
      return false;
    }
    note(first, *fitted, *result, share);
    const std::vector<Vec3> chords = spline::chordPoints(result->curve, share);
    const bool shifted = (chords.front() - *at_).norm() > tolerance::coincidence;
    put(first, std::span(chords).subspan(shifted ? 0 : 1), axis);
    at_ = chords.back();
    return true;
  }

  void note(const cl::Record& record,
            const spline::CubicSpline& before,
            const smooth::Smoothed& after,
            double share) {
    const auto old = curvatureFigures(before, samplesOfASpan);
    const auto now = curvatureFigures(after.curve, samplesOfASpan);
    facts_.push_back({record.isn, old.most, now.most, old.mean, now.mean, before.length(),
                      after.curve.length(), after.deviation + 2.0 * share});
  }

  void put(const cl::Record& like, std::span<const Vec3> points, const std::optional<Vec3>& axis) {
    cl::Record record = like;
    auto& motion = std::get<cl::Motion>(record.body);
    motion.kind = cl::Motion::Kind::go;
    motion.coordinates.clear();
    for (const Vec3& p : points) {
      if (motion.coordinates.size() + motion.stride() > numbersPerRecord) {
        next_.accept(record);
        motion.coordinates.clear();
        motion.kind = cl::Motion::Kind::continuation;
      }
      motion.coordinates.insert(motion.coordinates.end(), {p.x(), p.y(), p.z()});
      if (motion.withAxis) {
        motion.coordinates.insert(motion.coordinates.end(), {axis->x(), axis->y(), axis->z()});
      }
    }
    if (!motion.coordinates.empty()) {
      next_.accept(record);
    }
  }

  cl::RecordSink& next_;
  DiagnosticSink& sink_;
  const InterruptFlag* interrupted_;
  std::optional<Order> order_;
  Span commandOrigin_;
  bool rapid_ = false;
  std::optional<Vec3> at_;  // the location before what is held
  std::vector<cl::Record> held_;
  std::optional<cl::Record> surface_;
  std::vector<SmoothFact> facts_;
};

}  // namespace

std::unique_ptr<Smoother> makeSmoother(cl::RecordSink& next,
                                       DiagnosticSink& sink,
                                       const InterruptFlag* interrupted) {
  return std::make_unique<Stage>(next, sink, interrupted);
}

}  // namespace arelem::path
