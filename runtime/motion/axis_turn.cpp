#include "runtime/motion/axis_turn.h"

#include <algorithm>

#include "ir/space/tolerance.h"
#include "runtime/motion/settle.h"

namespace arelem::motion {

namespace {
/// Smallest share of the turn that is tried (over a place where the contact jumps the bands leave
/// room for little), and how near the longest one is looked for.
constexpr double shortest = 1e-5;
constexpr double refined = 0.02;
/// Following the axis to the rule's: shares of the turn from one place to the next.
constexpr double firstStep = 0.0625, longestStep = 0.125, leastStep = 1e-4;

/// The axis at a share of the turn from one axis to that of a rule.
class PartlyTurned final : public AxisSource {
 public:
  PartlyTurned(const Vec3& from, AxisRule& to) : from_(from), to_(to) {}

  void setShare(double share) { share_ = share; }
  Vec3 at(const Vec3& toolEnd) override {
    return (from_ + share_ * (to_.at(toolEnd) - from_)).normalized();
  }
  [[nodiscard]] bool settles() const override { return to_.settles(); }

 private:
  Vec3 from_;
  AxisRule& to_;
  double share_ = 0.0;
};

/// The turn from the axis with which the tool comes to the one of the path's rule, which itself
/// depends on where the tool ends: followed from where the tool stands, so that of several axes
/// that hold the rule it is the one to which the tool can turn.
class WayToRule {
 public:
  struct Place {
    double share = 0.0;
    Vec3 toolEnd, axis;
  };

  WayToRule(Path& path, const PathPoint& from, const Vec3& tangent)
      : path_(path), from_(from), across_{tangent, from.toolEnd} {
    auto source = std::make_unique<PartlyTurned>(from.axis, path.axis);
    turned_ = source.get();
    rule_ = AxisRule(std::move(source));
  }

  /// Places on the way, from the share 0 to 1; empty where it ends before.
  std::vector<Place> find() {
    auto first = to(0.0, from_.toolEnd);
    std::vector<Place> way;
    if (!first) {
      return way;
    }
    way.push_back(*first);
    for (double step = firstStep; way.back().share < 1.0;) {
      const double share = std::min(1.0, way.back().share + step);
      const auto next = follow(way.back(), share);
      if (!next) {
        step *= 0.5;
        if (step < leastStep) {
          return {};
        }
        continue;
      }
      way.push_back(*next);
      step = std::min(2.0 * step, longestStep);
    }
    return way;
  }

 private:
  std::optional<Place> to(double share, const Vec3& near) {
    turned_->setShare(share);
    const auto rests = path_.rests();
    const std::array wanted{Wanted{path_.guides[0].field.get(), rests[0]},
                            Wanted{path_.guides[1].field.get(), rests[1]}};
    const Settled there = settle(near, rule_, wanted, std::array{across_});
    return there.ok ? std::optional(Place{share, there.toolEnd, there.axis}) : std::nullopt;
  }

  /// The whole step and both of its halves lead to the same place.
  std::optional<Place> follow(const Place& last, double share) {
    const auto middle = to(0.5 * (last.share + share), last.toolEnd);
    const auto end = middle ? to(share, middle->toolEnd) : std::nullopt;
    const auto whole = end ? to(share, last.toolEnd) : std::nullopt;
    return whole && (whole->toolEnd - end->toolEnd).norm() <= tolerance::coincidence ? end
                                                                                     : std::nullopt;
  }

  Path& path_;
  const PathPoint& from_;
  Constraint across_;
  AxisRule rule_;
  PartlyTurned* turned_;
};

/// Axes that are nearer to each other than this are at different gaps of one band. Radians.
constexpr double sameAxis = 0.05;

class Turn {
 public:
  Turn(Path& path, const PathPoint& from, const Vec3& tangent)
      : path_(path), from_(from), tangent_(tangent) {}

  std::vector<PathPoint> run() {
    std::vector<PathPoint> ends;
    way_ = WayToRule(path_, from_, tangent_).find();
    followed_ = !way_.empty();
    if (!followed_) {
      const auto goal = path_.standing(from_.toolEnd, tangent_, path_.rests(), nullptr);
      if (!goal) {
        return ends;
      }
      way_ = {{0.0, from_.toolEnd, from_.axis}, {1.0, goal->toolEnd, goal->axis}};
    }
    PathPoint last = from_;
    for (double done = 0.0; done < 1.0;) {
      auto next = reach(last, 1.0);
      double share = 1.0;
      if (!next) {
        share = longest(last, done);
        next = reach(last, share);
      }
      if (!next) {
        return {};
      }
      last = *next;
      done = share;
      ends.push_back(last);
    }
    return ends;
  }

 private:
  /// The turned tool at a share of the way, if one cut vector leads there: at the gaps of stops, or
  /// at edges of the bands that give the vector room. Planes keep the gap of stops if they can; but
  /// where that is an edge of the band, a turn leaves it at once. Looked for from the last one: the
  /// tool that turned far where it stood may be deep inside, and from there steps lead anywhere.
  std::optional<PathPoint> reach(const PathPoint& last, double share) {
    const auto [ignored, near, axis] = onWay(last, share);
    const auto gap = [&](std::size_t i, bool outwards, bool planesToo) {
      const Guide& g = path_.guides[i];
      return g.field->flat() && !planesToo ? g.rest : g.edge(outwards);
    };
    std::vector<std::array<double, 2>> choices{path_.rests()};
    for (const bool planesToo : {false, true}) {
      for (const bool part : {false, true}) {
        for (const bool drive : {part, !part}) {
          const std::array gaps{gap(0, part, planesToo), gap(1, drive, planesToo)};
          // Planes that keep their gap leave fewer choices.
          if (std::find(choices.begin(), choices.end(), gaps) == choices.end()) {
            choices.push_back(gaps);
          }
        }
      }
    }
    for (const auto& gaps : choices) {
      const auto p = path_.standing(near, tangent_, gaps, share < 1.0 ? &axis : nullptr);
      if (p && (p->axis - axis).norm() <= sameAxis &&
          path_.fit(last, *p) >= 1.0 - tolerance::wholeExponent) {
        return p;
      }
    }
    return std::nullopt;
  }

  /// The longest share beyond `done` that one cut vector reaches.
  double longest(const PathPoint& last, double done) {
    double low = done;
    double high = 1.0;
    while (high - low > (low > done ? refined * (high - done) : shortest)) {
      const double middle = 0.5 * (low + high);
      (reach(last, middle) ? low : high) = middle;
    }
    return low > done ? low : high;
  }

  /// Where the turned tool is looked for.
  WayToRule::Place onWay(const PathPoint& last, double share) {
    const auto above = std::find_if(way_.begin() + 1, way_.end() - 1,
                                    [&](const auto& place) { return place.share >= share; });
    const WayToRule::Place& a = *(above - 1);
    const WayToRule::Place& b = *above;
    const double part = (share - a.share) / (b.share - a.share);
    return {share, followed_ ? Vec3(a.toolEnd + part * (b.toolEnd - a.toolEnd)) : last.toolEnd,
            (a.axis + part * (b.axis - a.axis)).normalized()};
  }

  Path& path_;
  const PathPoint& from_;
  Vec3 tangent_;
  std::vector<WayToRule::Place> way_;
  bool followed_ = true;
};
}  // namespace

std::vector<PathPoint> turnOntoPath(Path& path, const PathPoint& from, const Vec3& tangent) {
  return Turn(path, from, tangent).run();
}

}  // namespace arelem::motion
