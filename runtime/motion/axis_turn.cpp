#include "runtime/motion/axis_turn.h"

#include <algorithm>

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
    std::vector<PathPoint> ends;
    const auto goal = path_.standing(from_.toolEnd, tangent_, path_.rests(), nullptr);
    if (!goal) {
      return ends;
    }
    goal_ = goal->axis;
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
    const Vec3 axis = (from_.axis + share * (goal_ - from_.axis)).normalized();
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
      const auto p = path_.standing(last.toolEnd, tangent_, gaps, share < 1.0 ? &axis : nullptr);
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
};
}  // namespace

std::vector<PathPoint> turnOntoPath(Path& path, const PathPoint& from, const Vec3& tangent) {
  return Turn(path, from, tangent).run();
}

}  // namespace arelem::motion
