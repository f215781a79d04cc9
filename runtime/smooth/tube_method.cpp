// Least curvature inside the tube. With d the displacements of the control points, A the Bezier
// points of the difference spline (each knot interval halved) and k the curvature vector
// p' x p'' / |p'|^3 linearised about the curve so far:
//     minimise sum of weight * |k|^2 ds   subject to |(A d)_r| <= R for every r.
// Each such problem is convex; the balls bound the deviation of the whole curve by the hull of the
// difference. The alternating direction method of multipliers solves it with one banded
// factorisation a round; the weights grow with the curvature from round to round, so that the
// largest curvature falls most (iteratively reweighted Gauss-Newton). All work is linear in the
// number of control points.
#include <algorithm>
#include <cmath>
#include <functional>

#include "runtime/smooth/banded.h"
#include "runtime/smooth/smooth.h"

namespace arelem::smooth {

namespace {

using spline::CubicSpline;
using Row = std::array<double, 4>;

constexpr int rounds = 8;
constexpr int turnsOfARound = 8;
/// Samples of each knot interval when curves are compared.
constexpr int samplesOfASpan = 6;
/// Exponent of the weights: 0 is least squares, larger ones approach the least maximum.
constexpr double leastMaximum = 2.0;
/// What the search for the least time tries: exponents, with one and with two halvings of the knot
/// intervals. Found by trial on the source's cases.
constexpr std::array exponentsForTime = {2.0, 1.0, 0.0};
constexpr std::array finerExponents = {2.0, 1.0};
/// Weights are at least this share of the largest: straight parts stay straight.
constexpr double leastWeight = 1e-3;
constexpr std::array samplePlaces = {1.0 / 6.0, 0.5, 5.0 / 6.0};
/// Rows of the halved difference in each span, and the last point of all.
constexpr std::size_t rowsOfASpan = 6;

Row combined(const CubicSpline::Weights& w, const Row& factors) {
  Row row{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      row[i] += factors[k] * w[k][i];
    }
  }
  return row;
}

/// Second derivative by the control points of a span, at the share s of it.
Row secondDerivative(const CubicSpline::Weights& w, double s, double h) {
  const double f = 6.0 / (h * h);
  return combined(w, {f * (1.0 - s), f * (3.0 * s - 2.0), f * (1.0 - 3.0 * s), f * s});
}
Row firstDerivative(const CubicSpline::Weights& w, double s, double h) {
  const double r = 1.0 - s;
  const double f = 3.0 / h;
  return combined(w, {-f * r * r, f * (r * r - 2.0 * r * s), f * (2.0 * r * s - s * s), f * s * s});
}

using Cost = std::function<double(const CubicSpline&)>;

class Tube {
 public:
  /// `cost` tells which of two curves is the better one.
  Tube(CubicSpline curve, const Options& options, double exponent, Cost cost)
      : original_(std::move(curve)),
        options_(options),
        exponent_(exponent),
        cost_(std::move(cost)),
        size_(original_.control().size()),
        system_(size_, original_.closed()),
        shift_(size_, Vec3::Zero()),
        split_(original_.spans() * rowsOfASpan + 1, Vec3::Zero()),
        dual_(split_) {
    prepare();
  }

  Smoothed run() {
    Smoothed best{original_, 0.0, 0};
    double least = cost_(original_);
    int turns = 0;
    for (int round = 0; round < rounds && turns < mostTurns() && !interrupted(); ++round) {
      weigh();
      for (int turn = 0; turn < turnsOfARound; ++turn, ++turns) {
        step();
      }
      Smoothed now = guarded(original_, moved(), options_.tolerance);
      const double cost = cost_(now.curve);
      if (cost < least) {
        least = cost;
        best = std::move(now);
      }
    }
    best.iterations = turns;
    return best;
  }

 private:
  [[nodiscard]] int mostTurns() const { return options_.mostIterations * turnsOfARound; }
  [[nodiscard]] bool interrupted() const {
    return options_.interrupted != nullptr && options_.interrupted->load(std::memory_order_relaxed);
  }

  void prepare() {
    const auto knots = original_.knots();
    for (std::size_t span = 0; span < original_.spans(); ++span) {
      const CubicSpline::Weights w = original_.pieceWeights(span);
      weights_.push_back(w);
      for (const Row& factors : halved) {
        rows_.push_back(combined(w, factors));
      }
      widths_.push_back(knots[span + 1] - knots[span]);
    }
    rows_.push_back(weights_.back()[3]);
  }

  /// Bezier points of both halves of a piece but the last one, by the points of the whole.
  static constexpr std::array<Row, rowsOfASpan> halved = {
      Row{1.0, 0.0, 0.0, 0.0},         Row{0.5, 0.5, 0.0, 0.0},   Row{0.25, 0.5, 0.25, 0.0},
      Row{0.125, 0.375, 0.375, 0.125}, Row{0.0, 0.25, 0.5, 0.25}, Row{0.0, 0.0, 0.5, 0.5}};

  [[nodiscard]] std::size_t spanOfRow(std::size_t row) const {
    return std::min(row / rowsOfASpan, original_.spans() - 1);
  }

  [[nodiscard]] CubicSpline moved() const {
    std::vector<Vec3> control = original_.control();
    for (std::size_t i = 0; i < size_; ++i) {
      control[i] += shift_[i];
    }
    return original_.withControl(std::move(control));
  }

  [[nodiscard]] Vec3 combination(std::size_t span,
                                 const Row& row,
                                 const std::vector<Vec3>& points) const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      sum += row[i] * points[original_.index(span, i)];
    }
    return sum;
  }

  struct Sample {
    std::size_t span;
    Row first, second;
    Vec3 velocity, bend, curvature;
    double speed, measure;
  };

  [[nodiscard]] std::vector<Sample> samples(const CubicSpline& now) const {
    std::vector<Sample> all;
    all.reserve(now.spans() * samplePlaces.size());
    for (std::size_t span = 0; span < now.spans(); ++span) {
      const double h = widths_[span];
      for (const double s : samplePlaces) {
        Sample one;
        one.span = span;
        one.first = firstDerivative(weights_[span], s, h);
        one.second = secondDerivative(weights_[span], s, h);
        one.velocity = combination(span, one.first, now.control());
        one.bend = combination(span, one.second, now.control());
        one.speed = std::max(one.velocity.norm(), leastSpeed);
        one.curvature = one.velocity.cross(one.bend) / std::pow(one.speed, 3);
        one.measure = h * one.speed / static_cast<double>(samplePlaces.size());
        all.push_back(one);
      }
    }
    return all;
  }

  /// The derivative of the curvature vector by control point i of its span.
  static Eigen::Matrix3d slope(const Sample& s, std::size_t i) {
    const double cube = s.speed * s.speed * s.speed;
    return (s.second[i] * crossMatrix(s.velocity) - s.first[i] * crossMatrix(s.bend)) / cube -
           3.0 * s.first[i] / (s.speed * s.speed) * s.curvature * s.velocity.transpose();
  }
  static Eigen::Matrix3d crossMatrix(const Vec3& v) {
    Eigen::Matrix3d m;
    m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    return m;
  }

  /// The energy about the curve so far, and the system of the next turns.
  void weigh() {
    const std::vector<Sample> all = samples(moved());
    double most = 0.0;
    for (const Sample& sample : all) {
      most = std::max(most, sample.curvature.norm());
    }
    system_.clear();
    gradient_.assign(size_, Vec3::Zero());
    double trace = 0.0;
    for (const Sample& sample : all) {
      const double share = most > 0.0 ? sample.curvature.norm() / most : 1.0;
      const double weight = std::max(std::pow(share, exponent_), leastWeight);
      trace += addSample(sample, weight * sample.measure);
    }
    balance(trace);
  }

  /// Adds factor |k + J (d - d now)|^2 and returns the trace of its matrix.
  double addSample(const Sample& sample, double factor) {
    std::array<Eigen::Matrix3d, 4> slopes;
    Vec3 rest = sample.curvature;
    for (std::size_t i = 0; i < 4; ++i) {
      slopes[i] = slope(sample, i);
      rest -= slopes[i] * shift_[original_.index(sample.span, i)];
    }
    double trace = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      gradient_[original_.index(sample.span, i)] += factor * slopes[i].transpose() * rest;
      for (std::size_t k = i; k < 4; ++k) {
        addBlock(sample.span, i, k, factor * slopes[i].transpose() * slopes[k]);
      }
      trace += factor * slopes[i].squaredNorm();
    }
    return trace;
  }

  /// Adds a block of the control points i <= k of a span.
  void addBlock(std::size_t span, std::size_t i, std::size_t k, const Eigen::Matrix3d& block) {
    const std::size_t row = 3 * original_.index(span, i);
    const std::size_t column = 3 * original_.index(span, k);
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = i == k ? r : 0; c < 3; ++c) {
        system_.add(row + r, column + c,
                    block(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)));
      }
    }
  }

  /// The same with a multiple of the unit block.
  void addDiagonal(std::size_t span, std::size_t i, std::size_t k, double value) {
    for (std::size_t r = 0; r < 3; ++r) {
      system_.add(3 * original_.index(span, i) + r, 3 * original_.index(span, k) + r, value);
    }
  }

  /// The penalty is a fixed share of the mean stiffness.
  void balance(double trace) {
    double rowTrace = 0.0;
    for (const Row& row : rows_) {
      for (const double v : row) {
        rowTrace += 3.0 * v * v;
      }
    }
    const double before = penalty_;
    penalty_ = std::max(penaltyShare * trace / rowTrace, leastPenalty);
    for (Vec3& u : dual_) {
      u *= before / penalty_;  // the multipliers themselves stay
    }
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = i; k < 4; ++k) {
          addDiagonal(spanOfRow(r), i, k, penalty_ * rows_[r][i] * rows_[r][k]);
        }
      }
    }
    if (options_.fixedEnds && !original_.closed()) {
      const double stiff = 1e6 * (penalty_ + trace / static_cast<double>(size_));
      for (const std::size_t end : {std::size_t{0}, size_ - 1}) {
        for (std::size_t r = 0; r < 3; ++r) {
          system_.add(3 * end + r, 3 * end + r, stiff);
        }
      }
    }
    system_.factor();
  }

  void step() {
    for (std::size_t i = 0; i < size_; ++i) {
      shift_[i] = -gradient_[i];
    }
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const Vec3 pull = penalty_ * (split_[r] - dual_[r]);
      for (std::size_t i = 0; i < 4; ++i) {
        shift_[original_.index(spanOfRow(r), i)] += rows_[r][i] * pull;
      }
    }
    flat_.resize(3 * size_);
    for (std::size_t i = 0; i < size_; ++i) {
      std::copy(shift_[i].begin(), shift_[i].end(), &flat_[3 * i]);
    }
    system_.solve(flat_);
    for (std::size_t i = 0; i < size_; ++i) {
      shift_[i] = Vec3(flat_[3 * i], flat_[3 * i + 1], flat_[3 * i + 2]);
    }
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const Vec3 at = overRelaxation * combination(spanOfRow(r), rows_[r], shift_) +
                      (1.0 - overRelaxation) * split_[r] + dual_[r];
      const double length = at.norm();
      split_[r] = length > options_.tolerance ? Vec3(options_.tolerance / length * at) : at;
      dual_[r] = at - split_[r];
    }
  }

  static constexpr double leastSpeed = 1e-9;
  static constexpr double penaltyShare = 0.1;
  static constexpr double leastPenalty = 1e-12;
  static constexpr double overRelaxation = 1.6;

  const CubicSpline original_;
  const Options& options_;
  const double exponent_;
  const Cost cost_;
  std::size_t size_;
  BandedSystem system_;
  std::vector<CubicSpline::Weights> weights_;
  std::vector<double> widths_;
  std::vector<Row> rows_;
  std::vector<Vec3> shift_;     // d
  std::vector<Vec3> split_;     // the copy of A d inside the balls
  std::vector<Vec3> dual_;      // scaled multipliers
  std::vector<Vec3> gradient_;  // of the energy at d = 0
  std::vector<double> flat_;    // d by coordinates
  double penalty_ = 1.0;
};

}  // namespace

Smoothed tubeMethod(const spline::CubicSpline& curve, const Options& options) {
  // Twice the control points: room to bend later and less.
  return Tube(curve.refined(), options, leastMaximum,
              [](const CubicSpline& one) { return curvatureFigures(one, samplesOfASpan).most; })
      .run();
}

Smoothed timeMethod(const spline::CubicSpline& curve, const Options& options) {
  const Cost time = [&](const CubicSpline& one) { return machiningTime(one, options.limits); };
  Smoothed best{curve.refined(), 0.0, 0};
  double least = time(best.curve);
  const auto attempt = [&](const CubicSpline& start, double exponent) {
    Smoothed now = Tube(start, options, exponent, time).run();
    const double seconds = time(now.curve);
    if (seconds < least) {
      least = seconds;
      best = std::move(now);
    }
  };
  const CubicSpline once = best.curve;
  for (const double exponent : exponentsForTime) {
    attempt(once, exponent);
  }
  const CubicSpline twice = once.refined();
  for (const double exponent : finerExponents) {
    attempt(twice, exponent);
  }
  return best;
}

}  // namespace arelem::smooth
