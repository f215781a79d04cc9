#include "runtime/motion/facets/tunnel.h"

#include <algorithm>
#include <limits>

namespace arelem::motion {

namespace {
using Corners = std::vector<SectionPoint>;

/// Corners left behind are dropped when there are this many.
constexpr std::size_t dropped = 512;

std::size_t firstBehind(const Corners& corners, double s) {
  const auto found = std::upper_bound(corners.begin(), corners.end(), s,
                                      [](double at, const SectionPoint& c) { return at < c.s; });
  return static_cast<std::size_t>(found - corners.begin());
}

double heightAt(const Corners& corners, double s) {
  const std::size_t i = std::clamp<std::size_t>(firstBehind(corners, s), 1, corners.size() - 1);
  return heightOn(corners[i - 1], corners[i], s);
}

void drop(Corners& corners, double s) {
  const std::size_t behind = firstBehind(corners, s);
  if (behind > dropped) {
    corners.erase(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(behind) - 1);
  }
}

/// Rays from one place between two slopes.
class Wedge {
 public:
  explicit Wedge(const SectionPoint& eye) : eye_(eye) {}

  [[nodiscard]] double slopeTo(const SectionPoint& p) const {
    return (p.z - eye_.z) / (p.s - eye_.s);
  }
  /// False where no ray is left.
  bool raise(const SectionPoint& corner) {
    const double slope = slopeTo(corner);
    if (slope > high_) {
      return false;
    }
    if (slope > low_) {
      low_ = slope;
      lowAt_ = corner.s;
    }
    return true;
  }
  bool lower(const SectionPoint& corner) {
    const double slope = slopeTo(corner);
    if (slope < low_) {
      return false;
    }
    if (slope < high_) {
      high_ = slope;
      highAt_ = corner.s;
    }
    return true;
  }
  /// Where the ray with the given slope meets the line from a corner (or the eye) to the next.
  [[nodiscard]] SectionPoint meet(double slope,
                                  const SectionPoint& from,
                                  const SectionPoint& to) const {
    const double d0 = from.s > eye_.s ? from.z - eye_.z - slope * (from.s - eye_.s) : 0.0;
    const double d1 = to.z - eye_.z - slope * (to.s - eye_.s);
    const double start = std::max(from.s, eye_.s);
    const double share = d1 == d0 ? 0.0 : std::clamp(d0 / (d0 - d1), 0.0, 1.0);
    const double s = start + share * (to.s - start);
    return {s, eye_.z + slope * (s - eye_.s)};
  }
  [[nodiscard]] Tunnel::Reach atBottom(const SectionPoint& from, const SectionPoint& to) const {
    return {meet(high_, from, to), highAt_, -1};
  }
  [[nodiscard]] Tunnel::Reach atTop(const SectionPoint& from, const SectionPoint& to) const {
    return {meet(low_, from, to), lowAt_, 1};
  }
  [[nodiscard]] Tunnel::Reach atEnd(double s) const {
    constexpr double none = std::numeric_limits<double>::infinity();
    const double slope = low_ == -none ? high_ : high_ == none ? low_ : 0.5 * (low_ + high_);
    return {{s, eye_.z + slope * (s - eye_.s)}, std::max(lowAt_, highAt_), 0};
  }

 private:
  SectionPoint eye_;
  double low_ = -std::numeric_limits<double>::infinity();
  double high_ = std::numeric_limits<double>::infinity();
  double lowAt_ = -std::numeric_limits<double>::infinity();
  double highAt_ = -std::numeric_limits<double>::infinity();
};
}  // namespace

void Tunnel::clear() {
  bottom_.clear();
  top_.clear();
}

void Tunnel::lowerTop(double z) {
  top_.back().z = std::min(top_.back().z, z);
}

Tunnel::Reach Tunnel::farthest(const SectionPoint& eye) const {
  Wedge wedge(eye);
  std::size_t b = firstBehind(bottom_, eye.s);
  std::size_t t = firstBehind(top_, eye.s);
  // A straight way above the bottom and below the top at all corners is so between them.
  while (b < bottom_.size() || t < top_.size()) {
    if (t == top_.size() || (b < bottom_.size() && bottom_[b].s <= top_[t].s)) {
      if (!wedge.raise(bottom_[b])) {
        return wedge.atBottom(b > 0 ? bottom_[b - 1] : eye, bottom_[b]);
      }
      ++b;
    } else {
      if (!wedge.lower(top_[t])) {
        return wedge.atTop(t > 0 ? top_[t - 1] : eye, top_[t]);
      }
      ++t;
    }
  }
  return wedge.atEnd(std::max(end(), eye.s));
}

double Tunnel::bottomAt(double s) const {
  return heightAt(bottom_, s);
}

double Tunnel::topAt(double s) const {
  return heightAt(top_, s);
}

void Tunnel::forget(double s) {
  drop(bottom_, s);
  drop(top_, s);
}

}  // namespace arelem::motion
