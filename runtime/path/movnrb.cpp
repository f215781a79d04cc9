#include "runtime/path/movnrb.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "ir/diag/curves.h"
#include "ir/space/cl_file_tolerance.h"
#include "ir/space/vector.h"

namespace arelem::path {

namespace {
/// Samples of a span between two knots, among which the nearest place is looked for.
constexpr std::size_t samplesOfSpan = 16;
/// Spans ahead of the last location where the next one is looked for first.
constexpr std::size_t spansAhead = 32;
/// So many locations that are not there are looked for on the whole curve.
constexpr int wholeSearches = 100;
constexpr int halvings = 60;
constexpr std::size_t largestOrder = 16;

/// A B-spline of any order over non-decreasing knots (de Boor's recursion).
class Curve {
 public:
  Curve(std::size_t order, std::vector<double> knots, std::vector<Vec3> control)
      : order_(order), knots_(std::move(knots)), control_(std::move(control)) {
    for (std::size_t i = order_ - 1; i < control_.size(); ++i) {
      if (knots_[i + 1] > knots_[i]) {
        spans_.push_back(i);
      }
    }
  }
  [[nodiscard]] std::size_t samples() const { return spans_.size() * samplesOfSpan; }
  /// At a place counted in samples from the start.
  [[nodiscard]] Vec3 at(double sample) const {
    const double last = static_cast<double>(samples());
    const double place = std::clamp(sample, 0.0, last) / static_cast<double>(samplesOfSpan);
    const std::size_t which = std::min(static_cast<std::size_t>(place), spans_.size() - 1);
    const std::size_t span = spans_[which];
    const double share = place - static_cast<double>(which);
    return inSpan(span, knots_[span] + share * (knots_[span + 1] - knots_[span]));
  }

 private:
  [[nodiscard]] Vec3 inSpan(std::size_t span, double t) const {
    std::vector<Vec3> d(control_.begin() + static_cast<std::ptrdiff_t>(span + 1 - order_),
                        control_.begin() + static_cast<std::ptrdiff_t>(span + 1));
    for (std::size_t r = 1; r < order_; ++r) {
      for (std::size_t j = order_ - 1; j >= r; --j) {
        const std::size_t i = span + 1 - order_ + j;
        const double width = knots_[i + order_ - r] - knots_[i];
        const double share = width > 0.0 ? (t - knots_[i]) / width : 0.0;
        d[j] = (1.0 - share) * d[j - 1] + share * d[j];
      }
    }
    return d[order_ - 1];
  }

  std::size_t order_;
  std::vector<double> knots_;
  std::vector<Vec3> control_;
  std::vector<std::size_t> spans_;  ///< those that are not empty
};

/// Locations come in the order of the curve.
class Distances {
 public:
  explicit Distances(const Curve& curve) : curve_(curve) {}

  double of(const Vec3& point) {
    const std::size_t last = curve_.samples();
    double nearest = search(point, from_, std::min(last, from_ + spansAhead * samplesOfSpan));
    if (nearest > tolerance::printedPlace && whole_ < wholeSearches) {
      ++whole_;
      nearest = search(point, 0, last);
    }
    return nearest;
  }

 private:
  /// The nearest sample, then the nearest place beside it: the distance has one valley there.
  double search(const Vec3& point, std::size_t begin, std::size_t end) {
    std::size_t best = begin;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = begin; i <= end; ++i) {
      const double distance = (curve_.at(static_cast<double>(i)) - point).norm();
      if (distance < least) {
        least = distance;
        best = i;
      }
    }
    double low = static_cast<double>(best) - 1.0;
    double high = static_cast<double>(best) + 1.0;
    for (int i = 0; i < halvings; ++i) {
      const double a = low + (high - low) / 3.0;
      const double b = high - (high - low) / 3.0;
      ((curve_.at(a) - point).norm() < (curve_.at(b) - point).norm() ? high : low) =
          (curve_.at(a) - point).norm() < (curve_.at(b) - point).norm() ? b : a;
    }
    const double found = std::min(least, (curve_.at((low + high) / 2.0) - point).norm());
    if (found <= tolerance::printedPlace) {
      from_ = best > 0 ? best - 1 : 0;
    }
    return found;
  }

  const Curve& curve_;
  std::size_t from_ = 0;
  int whole_ = 0;
};

class MovnrbCheck : public cl::RecordSink {
 public:
  MovnrbCheck(cl::RecordSink& next, DiagnosticSink& sink) : next_(next), sink_(sink) {}

  void accept(const cl::Record& record) override {
    if (const auto* post = std::get_if<cl::Post>(&record.body);
        post != nullptr && post->foreign == "MOVNRB") {
      take(record, *post);
    } else if (const auto* motion = std::get_if<cl::Motion>(&record.body);
               motion != nullptr && follows_) {
      const std::vector<double>& c = motion->coordinates;
      for (std::size_t i = 0; i + motion->stride() <= c.size(); i += motion->stride()) {
        locations_.emplace_back(&c[i]);
      }
    }
    next_.accept(record);
  }

 private:
  void take(const cl::Record& record, const cl::Post& post) {
    if (post.arguments.empty()) {
      return;
    }
    const cl::Value& first = post.arguments.front();
    std::vector<double> numbers;
    for (std::size_t i = 1; i < post.arguments.size(); ++i) {
      if (const double* number = std::get_if<double>(&post.arguments[i])) {
        numbers.push_back(*number);
      }
    }
    if (const double* list = std::get_if<double>(&first)) {
      if (*list == 1.0) {
        knots_.insert(knots_.end(), numbers.begin(), numbers.end());
      } else if (*list == 2.0) {
        coordinates_.insert(coordinates_.end(), numbers.begin(), numbers.end());
      }
    } else if (const Word* word = std::get_if<Word>(&first)) {
      if (*word == Word::ON) {
        begin(record, numbers);
      } else if (*word == Word::NEXT) {
        follows_ = true;
      } else if (*word == Word::OFF) {
        check();
      }
    }
  }

  void begin(const cl::Record& record, const std::vector<double>& numbers) {
    constexpr std::size_t upToControl = 4;
    origin_ = record.origin;
    said_ = numbers.size() >= upToControl ? Said{numbers[0], numbers[1], numbers[3]} : Said{};
    knots_.clear();
    coordinates_.clear();
    locations_.clear();
    follows_ = false;
  }

  void check() {
    follows_ = false;
    const std::size_t points = coordinates_.size() / 3;
    const auto order = static_cast<std::size_t>(std::clamp(said_.order, 0.0, 1e3));
    const bool fits = coordinates_.size() % 3 == 0 && said_.knots == double(knots_.size()) &&
                      said_.points == double(points) && order >= 2 && order <= largestOrder &&
                      points >= order && knots_.size() == points + order &&
                      std::is_sorted(knots_.begin(), knots_.end()) &&
                      knots_[points] > knots_[order - 1];
    if (!fits) {
      sink_.accept(at(origin_, fail(diag::MovnrbCounts, said_.order, said_.knots, said_.points,
                                    knots_.size(), points)));
      return;
    }
    std::vector<Vec3> control;
    for (std::size_t i = 0; i < points; ++i) {
      control.emplace_back(&coordinates_[3 * i]);
    }
    const Curve curve(order, knots_, std::move(control));
    Distances distances(curve);
    double most = 0.0;
    std::size_t off = 0;
    for (const Vec3& location : locations_) {
      const double distance = distances.of(location);
      most = std::max(most, distance);
      off += distance > tolerance::printedPlace ? 1 : 0;
    }
    if (off > 0) {
      sink_.accept(at(origin_, fail(diag::MovnrbOff, off, locations_.size(), most)));
    }
  }

  struct Said {
    double order = 0.0, knots = 0.0, points = 0.0;
  };
  cl::RecordSink& next_;
  DiagnosticSink& sink_;
  Span origin_;
  Said said_;
  std::vector<double> knots_, coordinates_;
  std::vector<Vec3> locations_;
  bool follows_ = false;  ///< behind NEXT
};
}  // namespace

std::unique_ptr<cl::RecordSink> makeMovnrbCheck(cl::RecordSink& next, DiagnosticSink& sink) {
  return std::make_unique<MovnrbCheck>(next, sink);
}

}  // namespace arelem::path
