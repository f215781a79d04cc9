#include "runtime/smooth/tube.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ir/space/smooth_tolerance.h"

namespace arelem::smooth {

namespace {

using spline::CubicSpline;

/// Where each knot interval is sampled.
constexpr std::array samplePlaces = {1.0 / 6.0, 0.5, 5.0 / 6.0};
/// Samples on each side that the weight of a sample is relative to.
constexpr std::size_t reach = 48;
/// A curve that turns by more than this within a knot interval, in radians, has a cusp: it has to
/// be bent open, not to be passed faster.
constexpr double mostTurn = 1.5;
/// A cusp can hide between samples: where the speed |p'| falls below this share of that of the
/// given curve it is held up, with so many times the weight of the curvature nearby.
constexpr double leastSpeedShare = 0.7;
constexpr double speedWeight = 10.0;
constexpr double overRelaxation = 1.6;
/// Held control points are stiffer than the others by this.
constexpr double stiffness = 1e6;
constexpr std::size_t heldPoints = 3;
/// No control point is moved by more than this, in radii of the tube.
constexpr double farthest = 3.0;
/// Halvings of a piece of the difference spline where its hull is measured.
constexpr int halvings = 1;

std::array<double, 4> rowOf(const CubicSpline::Weights& w, const std::array<double, 4>& factors) {
  std::array<double, 4> row{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      row[i] += factors[k] * w[k][i];
    }
  }
  return row;
}

/// First and second derivative by the Bezier points of a span of width h, at the share s of it.
std::array<double, 4> firstDerivative(double s, double h) {
  const double r = 1.0 - s;
  const double f = 3.0 / h;
  return {-f * r * r, f * (r * r - 2.0 * r * s), f * (2.0 * r * s - s * s), f * s * s};
}
std::array<double, 4> secondDerivative(double s, double h) {
  const double f = 6.0 / (h * h);
  return {f * (1.0 - s), f * (3.0 * s - 2.0), f * (1.0 - 3.0 * s), f * s};
}

/// The largest of the values at most `reach` places away, for each place; linear in their number.
std::vector<double> neighborhoodMaxima(const std::vector<double>& values) {
  const std::size_t n = values.size();
  std::vector<double> forward(n);
  std::vector<double> backward(n);
  // Runs of reach + 1 values: every window is the end of one run and the begin of the next.
  const std::size_t run = 2 * reach + 1;
  for (std::size_t i = 0; i < n; ++i) {
    forward[i] = i % run == 0 ? values[i] : std::max(forward[i - 1], values[i]);
  }
  for (std::size_t i = n; i-- > 0;) {
    const bool isLast = i + 1 == n || (i + 1) % run == 0;
    backward[i] = isLast ? values[i] : std::max(backward[i + 1], values[i]);
  }
  std::vector<double> most(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t from = i < reach ? 0 : i - reach;
    const std::size_t to = std::min(i + reach, n - 1);
    most[i] = std::max(backward[from], forward[to]);
  }
  return most;
}

}  // namespace

Tube::Tube(const CubicSpline& original, const Stretch& stretch, double radius)
    : original_(original),
      stretch_(stretch),
      radius_(radius),
      size_(stretch.isRing ? stretch.count : stretch.count + 3),
      system_(size_, stretch.isRing) {
  prepare();
}

std::size_t Tube::spanOf(std::size_t i) const {
  return (stretch_.first + i) % original_.spans();
}

const Vec3& Tube::given(std::size_t i) const {
  return original_.control()[(stretch_.first + i) % original_.control().size()];
}

void Tube::prepare() {
  const auto knots = original_.knots();
  for (std::size_t i = 0; i < stretch_.count; ++i) {
    const std::size_t span = spanOf(i);
    const CubicSpline::Weights w = original_.pieceWeights(span);
    weights_.push_back(w);
    widths_.push_back(knots[span + 1] - knots[span]);
    bounds_.push_back({w[0], i});
    bounds_.push_back({rowOf(w, {0.125, 0.375, 0.375, 0.125}), i});
    for (const double s : samplePlaces) {
      Station& one = stations_.emplace_back();
      one.first = rowOf(w, firstDerivative(s, widths_.back()));
      one.second = rowOf(w, secondDerivative(s, widths_.back()));
      one.leastSquare = leastVelocity(i, one).squaredNorm();
    }
  }
  if (stretch_.isRing) {
    return;
  }
  bounds_.push_back({weights_.back()[3], stretch_.count - 1});
  // At the end of the whole curve the first control point is its end; elsewhere three meet.
  const bool beginsThere = stretch_.first == 0 && !original_.closed();
  const bool endsThere =
      stretch_.first + stretch_.count == original_.spans() && !original_.closed();
  joinsStart_ = stretch_.holdsStart && !beginsThere;
  joinsEnd_ = stretch_.holdsEnd && !endsThere;
  for (std::size_t i = 0; stretch_.holdsStart && i < (beginsThere ? 1 : heldPoints); ++i) {
    held_.push_back(i);
  }
  for (std::size_t i = 0; stretch_.holdsEnd && i < (endsThere ? 1 : heldPoints); ++i) {
    held_.push_back(size_ - 1 - i);
  }
  stiff_.assign(held_.size(), 0.0);
  target_.assign(held_.size(), Vec3::Zero());
}

void Tube::start(std::vector<Vec3> shift) {
  shift_ = std::move(shift);
  for (std::size_t k = 0; k < held_.size(); ++k) {
    target_[k] = shift_[held_[k]];
  }
  for (Bound& bound : bounds_) {
    bound.split = combined(bound.weights, bound.from, shift_);
    bound.allowed = radius_;
  }
  // Held control points hold the curve between them, whatever the next one does; and beside them it
  // may stay where it is.
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  const std::size_t last = bounds_.size() - 1;
  for (std::size_t b = 0; joinsStart_ && b < 3; ++b) {
    bounds_[b].allowed = b < 2 ? unbounded : std::max(radius_, bounds_[b].split.norm());
  }
  for (std::size_t b = 0; joinsEnd_ && b < 3; ++b) {
    Bound& bound = bounds_[last - b];
    bound.allowed = b < 2 ? unbounded : std::max(radius_, bound.split.norm());
  }
}

Vec3 Tube::combined(const Row& row, std::size_t from, const std::vector<Vec3>& points) const {
  if (from + 3 < size_) {
    return row[0] * points[from] + row[1] * points[from + 1] + row[2] * points[from + 2] +
           row[3] * points[from + 3];
  }
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    sum += row[i] * points[local(from + i)];
  }
  return sum;
}

double Tube::deviationOf(std::size_t i) const {
  spline::Bezier piece;
  for (std::size_t k = 0; k < 4; ++k) {
    piece.control[k] = combined(weights_[i][k], i, shift_);
  }
  return spline::hullOfHalves(piece, halvings);
}

/// Where the difference spline is farther out between two bounds than at them, these are tighter.
void Tube::tighten() {
  for (Bound& bound : bounds_) {
    bound.radius = bound.allowed;
  }
  const std::size_t end = stretch_.count - (joinsEnd_ ? 1 : 0);
  for (std::size_t i = joinsStart_ ? 1 : 0; i < end; ++i) {
    const std::size_t last = std::min(2 * i + 2, bounds_.size() - 1);
    double at = 0.0;
    for (std::size_t b = 2 * i; b <= last; ++b) {
      at = std::max(at, combined(bounds_[b].weights, bounds_[b].from, shift_).norm());
    }
    const double most = deviationOf(i);
    if (most > radius_) {
      for (std::size_t b = 2 * i; b <= last; ++b) {
        bounds_[b].radius = std::min(bounds_[b].radius, radius_ * at / most);
      }
    }
  }
}

void Tube::takeSamples() {
  samples_.clear();
  std::array<Vec3, 4> points;
  for (std::size_t i = 0; i < stretch_.count; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      points[k] = given(i + k) + shift_[local(i + k)];
    }
    for (std::size_t j = 0; j < samplePlaces.size(); ++j) {
      const Station& station = stations_[i * samplePlaces.size() + j];
      Vec3 velocity = Vec3::Zero();
      Vec3 bend = Vec3::Zero();
      for (std::size_t k = 1; k < 4; ++k) {
        velocity += station.first[k] * (points[k] - points[0]);
        bend += station.second[k] * (points[k] - points[0]);
      }
      const double square = std::max(velocity.squaredNorm(),
                                     tolerance::smoothLeastSpeed * tolerance::smoothLeastSpeed);
      const double along = velocity.dot(bend) / square;
      Sample& one = samples_.emplace_back();
      one.from = i;
      one.first = station.first;
      for (std::size_t k = 0; k < 4; ++k) {
        one.curvature[k] = (station.second[k] - along * station.first[k]) / square;
      }
      one.now = (bend - along * velocity) / square;
      one.along = velocity / square;
      one.measure = widths_[i] * std::sqrt(square) / static_cast<double>(samplePlaces.size());
      if (velocity.squaredNorm() < station.leastSquare) {
        one.lag = leastVelocity(i, station) - velocity;
        one.hold = speedWeight * one.measure / station.leastSquare;
      }
    }
  }
}

/// The velocity that a sample must not fall short of; the rows sum to 0.
Vec3 Tube::leastVelocity(std::size_t span, const Station& station) const {
  Vec3 velocity = Vec3::Zero();
  for (std::size_t k = 1; k < 4; ++k) {
    velocity += station.first[k] * (given(span + k) - given(span));
  }
  return leastSpeedShare * velocity;
}

void Tube::addSquare(const Row& row, std::size_t from, double factor) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = i; k < 4; ++k) {
      system_.add(local(from + i), k - i, factor * row[i] * row[k]);
    }
  }
}

/// Weights go to their new values by a share of the way, in logarithms: the whole way overshoots
/// where the exponent is above 1.
void Tube::reweigh(double exponent) {
  std::vector<double> curvatures;
  curvatures.reserve(samples_.size());
  for (const Sample& sample : samples_) {
    curvatures.push_back(sample.now.norm());
  }
  const std::vector<double> most = neighborhoodMaxima(curvatures);
  const bool isFirst = weightLogs_.empty();
  weightLogs_.resize(samples_.size());
  const double way = isFirst ? 1.0 : 1.0 / (1.0 + exponent);
  const double least = std::log(tolerance::smoothLeastWeight);
  for (std::size_t s = 0; s < samples_.size(); ++s) {
    const double share = most[s] > 0.0 ? curvatures[s] / most[s] : 1.0;
    const double wanted = share > 0.0 ? std::max(exponent * std::log(share), least) : least;
    weightLogs_[s] += way * (wanted - weightLogs_[s]);
    samples_[s].hold *= most[s] * most[s];
    samples_[s].weight = std::exp(weightLogs_[s]) * samples_[s].measure;
  }
}

/// The energy about the curve so far: its exact gradient, and a matrix without the terms that would
/// tie x, y and z together. For the change of the speed, which is one of them, a bound is in it.
void Tube::gather() {
  system_.clear();
  gradient_.assign(size_, Vec3::Zero());
  for (std::size_t i = 0; i < stretch_.count; ++i) {
    Eigen::Matrix4d block = Eigen::Matrix4d::Zero();
    for (std::size_t j = 0; j < samplePlaces.size(); ++j) {
      gather(samples_[i * samplePlaces.size() + j], block);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t m = k; m < 4; ++m) {
        system_.add(local(i + k), m - k,
                    block(static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(k)));
      }
    }
  }
}

void Tube::gather(const Sample& sample, Eigen::Matrix4d& block) {
  using Column = Eigen::Map<const Eigen::Vector4d>;
  const double turns = mostTurn / (sample.measure * samplePlaces.size());
  const double square = std::min(sample.now.squaredNorm(), turns * turns);
  const double stretch = 4.0 * square * sample.along.squaredNorm();
  Vec3 bend = sample.now;
  Vec3 back = 2.0 * square * sample.along;
  Vec3 up = sample.lag;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3& shift = shift_[local(sample.from + i)];
    bend -= sample.curvature[i] * shift;
    back += stretch * sample.first[i] * shift;
    up += sample.first[i] * shift;
  }
  const Vec3 push = sample.weight * back + sample.hold * up;
  for (std::size_t i = 0; i < 4; ++i) {
    gradient_[local(sample.from + i)] +=
        sample.weight * sample.curvature[i] * bend - sample.first[i] * push;
  }
  const Column curvature(sample.curvature.data());
  const Column first(sample.first.data());
  block += sample.weight * curvature * curvature.transpose() +
           (sample.weight * stretch + sample.hold) * first * first.transpose();
}

/// Each bound pulls with a share of the stiffness of its control points.
void Tube::penalize(double pull) {
  std::vector<double> diagonal(size_);
  for (std::size_t i = 0; i < size_; ++i) {
    diagonal[i] = system_.diagonal(i);
  }
  for (Bound& bound : bounds_) {
    double mean = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      mean += bound.weights[i] * diagonal[local(bound.from + i)];
    }
    const double before = std::exchange(bound.penalty, pull * mean);
    bound.dual *= before / bound.penalty;  // the multiplier itself stays
    addSquare(bound.weights, bound.from, bound.penalty);
  }
}

void Tube::hold() {
  for (std::size_t k = 0; k < held_.size(); ++k) {
    stiff_[k] = stiffness * system_.diagonal(held_[k]);
    system_.add(held_[k], 0, stiff_[k]);
  }
}

void Tube::turn() {
  for (std::size_t i = 0; i < size_; ++i) {
    shift_[i] = -gradient_[i];
  }
  for (const Bound& bound : bounds_) {
    const Vec3 pull = bound.penalty * (bound.split - bound.dual);
    for (std::size_t i = 0; i < 4; ++i) {
      shift_[local(bound.from + i)] += bound.weights[i] * pull;
    }
  }
  for (std::size_t k = 0; k < held_.size(); ++k) {
    shift_[held_[k]] += stiff_[k] * target_[k];
  }
  system_.solve(shift_);
  for (Bound& bound : bounds_) {
    const Vec3 at = overRelaxation * combined(bound.weights, bound.from, shift_) +
                    (1.0 - overRelaxation) * bound.split + bound.dual;
    const double square = at.squaredNorm();
    const bool isInside = square <= bound.radius * bound.radius;
    bound.split = isInside ? at : Vec3(bound.radius / std::sqrt(square) * at);
    bound.dual = at - bound.split;
  }
}

void Tube::round(double exponent, double pull, int turns) {
  tighten();
  takeSamples();
  reweigh(exponent);
  gather();
  penalize(pull);
  hold();
  system_.factor();
  for (int i = 0; i < turns; ++i) {
    turn();
  }
  // Where the curve has loops the problem about it may lead far away: that is no way to go.
  const double most = farthest * radius_;
  for (Vec3& shift : shift_) {
    const double length = shift.norm();
    if (!(length <= most)) {
      shift = std::isfinite(length) ? Vec3(most / length * shift) : Vec3(Vec3::Zero());
    }
  }
  for (std::size_t k = 0; k < held_.size(); ++k) {
    shift_[held_[k]] = target_[k];
  }
}

}  // namespace arelem::smooth
