#include "runtime/motion/axis_turn.h"

#include "ir/space/tolerance.h"

namespace arelem::motion {

namespace {
/// Smallest share of the turn that is tried, and how near the longest one is looked for.
constexpr double shortest = 1e-3;
constexpr double refined = 0.02;

class Turn {
 public:
  Turn(Path& path, const PathPoint& from, const Vec3& tangent)
      : path_(path), from_(from), tangent_(tangent) {}

  std::vector<PathPoint> run() {
    const auto goal = path_.standing(from_.toolEnd, tangent_, path_.rests(), nullptr);
    if (!goal) {
      return {};
    }
    goal_ = goal->axis;
    const auto [rests, inner, outer] = gapsOf(path_);
    gaps_ = {rests, inner, outer};
    auto ends = turn();
    if (ends.empty()) {
      // A top edge on a plane runs in an arc about the tool end: without INTOL only cut vectors
      // that end off the plane have room for its sagitta, while the other surface may ask for the
      // other edge.
      gaps_.clear();
      const auto edges = edgesOf(path_);
      for (const double part : edges[0]) {
        for (const double drive : edges[1]) {
          gaps_.push_back({part, drive});
        }
      }
      ends = turn();
    }
    return ends;
  }

 private:
  using Gaps = std::array<double, 2>;
  struct Three {
    Gaps rests, inner, outer;
  };
  /// The gaps of stops, and the edges of the bands that give cut vectors room along curved
  /// surfaces.
  static Three gapsOf(const Path& path) {
    Three three{path.rests(), path.rests(), path.rests()};
    for (std::size_t i = 0; i < path.guides.size(); ++i) {
      const Guide& g = path.guides[i];
      if (!g.field->flat()) {
        three.inner[i] = -g.inner;
        three.outer[i] = g.outer;
      }
    }
    return three;
  }
  static std::array<std::array<double, 3>, 2> edgesOf(const Path& path) {
    std::array<std::array<double, 3>, 2> edges{};
    for (std::size_t i = 0; i < path.guides.size(); ++i) {
      const Guide& g = path.guides[i];
      edges[i] = {g.rest, -g.inner, g.outer};
    }
    return edges;
  }

  std::vector<PathPoint> turn() {
    std::vector<PathPoint> ends;
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

  /// The turned tool at a share of the way, if one cut vector leads there.
  std::optional<PathPoint> reach(const PathPoint& last, double share) {
    const Vec3 axis = (from_.axis + share * (goal_ - from_.axis)).normalized();
    for (const Gaps& gaps : gaps_) {
      const auto p = path_.standing(from_.toolEnd, tangent_, gaps, share < 1.0 ? &axis : nullptr);
      if (p && path_.fit(last, *p) >= 1.0 - tolerance::wholeExponent) {
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

  Path& path_;
  const PathPoint& from_;
  Vec3 tangent_;
  Vec3 goal_ = Vec3::UnitZ();
  std::vector<Gaps> gaps_;  ///< at which cut vectors may end, those to be tried first first
};
}  // namespace

std::vector<PathPoint> turnOntoPath(Path& path, const PathPoint& from, const Vec3& tangent) {
  return Turn(path, from, tangent).run();
}

}  // namespace arelem::motion
