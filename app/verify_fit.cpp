#include "app/verify_fit.h"

#include <algorithm>
#include <limits>

#include "ir/diag/render_text.h"
#include "ir/diag/verify.h"

namespace arelem::app {

namespace {

/// Place on a line nearest to p, as a share of it that is at least `from`.
double footOn(const Vec3& p, const Vec3& a, const Vec3& b, double from) {
  const Vec3 along = b - a;
  const double square = along.squaredNorm();
  return square > 0.0 ? std::clamp((p - a).dot(along) / square, from, 1.0) : 1.0;
}

class Walk {
 public:
  Walk(const Path& wanted, const Path& found, const std::string& name, const FitAllowed& allowed)
      : wanted_(wanted.locations), found_(found.locations), name_(name), allowed_(allowed) {}

  std::optional<Diagnostic> run() {
    if (wanted_.empty() || found_.empty()) {
      return lengths();
    }
    if (auto other = difference(wanted_[0], found_[0], 1, name_, allowed_.rounding)) {
      return other;
    }
    for (std::size_t i = 1; i < found_.size(); ++i) {
      if (auto other = step(i)) {
        return other;
      }
    }
    // What is left has to end where the other path does.
    for (; edge_ < wanted_.size(); ++edge_) {
      if ((wanted_[edge_].point - found_.back().point).norm() > allowedOn(edge_)) {
        return lengths();
      }
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] Diagnostic lengths() const {
    return diagnose(nowhere, diag::PathLength, name_, found_.size(), wanted_.size());
  }
  [[nodiscard]] double allowedOn(std::size_t edge) const {
    return allowed_.share * wanted_[edge].band + allowed_.rounding.distance;
  }

  /// Looks for the foot of a location: along the program's path from the last foot on, as long as
  /// that comes nearer and does not leave the tube.
  std::optional<Diagnostic> step(std::size_t i) {
    const Vec3& from = found_[i - 1].point;
    const Vec3& to = found_[i].point;
    double least = std::numeric_limits<double>::infinity();
    std::size_t bestEdge = edge_;
    double best = share_;
    for (std::size_t e = edge_; e < wanted_.size(); ++e) {
      const Vec3& a = wanted_[e - 1].point;
      const Vec3& b = wanted_[e].point;
      const double s = footOn(to, a, b, e == edge_ ? share_ : 0.0);
      const double apart = (a + s * (b - a) - to).norm();
      if (apart <= least) {
        least = apart;
        bestEdge = e;
        best = s;
      } else if (least <= allowedOn(bestEdge)) {
        break;
      }
      const double t = footOn(b, from, to, 0.0);
      if ((from + t * (to - from) - b).norm() > allowedOn(e)) {
        break;
      }
    }
    if (wanted_.size() == 1) {
      least = (to - wanted_[0].point).norm();
      bestEdge = 0;
    }
    const double most = allowedOn(bestEdge);
    if (!(least <= most)) {
      const Location& there = wanted_[bestEdge];
      return diagnose(there.origin, diag::PathDiffers, i + 1, name_, least, most);
    }
    edge_ = bestEdge;
    share_ = best;
    return turned(i);
  }

  /// The axis at a foot is that of one end of its line, or between both.
  [[nodiscard]] std::optional<Diagnostic> turned(std::size_t i) const {
    const Location& there = wanted_[edge_];
    if (!found_[i].axis || !there.axis) {
      return std::nullopt;
    }
    const Vec3 before = wanted_[edge_ - std::min<std::size_t>(edge_, 1)].axis.value_or(*there.axis);
    const Vec3 axis = (1.0 - share_) * before + share_ * *there.axis;
    const double degrees = degreesBetween(axis, *found_[i].axis);
    if (degrees <= allowed_.rounding.degrees) {
      return std::nullopt;
    }
    return diagnose(there.origin, diag::AxisDiffers, i + 1, name_, degrees,
                    allowed_.rounding.degrees);
  }

  const std::vector<Location>& wanted_;
  const std::vector<Location>& found_;
  const std::string& name_;
  const FitAllowed& allowed_;
  std::size_t edge_ = 1;  // the foot lies between the locations before this one and this one
  double share_ = 0.0;
};

}  // namespace

std::optional<Diagnostic> firstDeparture(const Path& wanted,
                                         const Path& found,
                                         const std::string& name,
                                         const FitAllowed& allowed) {
  return Walk(wanted, found, name, allowed).run();
}

}  // namespace arelem::app
