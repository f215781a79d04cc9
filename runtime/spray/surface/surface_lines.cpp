#include "runtime/spray/surface/surface_lines.h"

#include <algorithm>
#include <cmath>

#include "ir/space/spray_tolerance.h"
#include "ir/space/tolerance.h"

namespace arelem::spray {

namespace {
constexpr int samples = 64;  // of a parameter, for lengths and areas
constexpr int deepest = 20;  // halvings of a line

double between(double from, double to, double share) {
  return from + share * (to - from);
}

/// The line of parameter t = 0 ... 1 at a fixed other parameter.
class Tracer {
 public:
  Tracer(const Patch& patch, const Layout& layout, double other)
      : patch_(patch),
        alongU_(layout.alongU),
        other_(other),
        chord_(layout.chord),
        mostPoints_(layout.mostPoints) {}

  SurfaceLine trace() {
    constexpr int begin = 4;  // pieces to begin with, so that a whole turn does not look straight
    add(0.0);
    for (int i = 0; i < begin; ++i) {
      refine(static_cast<double>(i) / begin, static_cast<double>(i + 1) / begin, deepest);
    }
    return std::move(line_);
  }

 private:
  [[nodiscard]] Vec3 at(double t) const {
    return alongU_ ? patch_.at(between(patch_.u0, patch_.u1, t), other_)
                   : patch_.at(other_, between(patch_.v0, patch_.v1, t));
  }
  void add(double t) {
    const double s = between(alongU_ ? patch_.u0 : patch_.v0, alongU_ ? patch_.u1 : patch_.v1, t);
    const Vec2 uv = alongU_ ? Vec2(s, other_) : Vec2(other_, s);
    line_.push_back({at(t), patch_.normal(uv.x(), uv.y()), uv});
  }
  void refine(double from, double to, int depth) {
    const Vec3 a = at(from);
    const Vec3 step = at(to) - a;
    double off = 0.0;
    const int looks = std::max(fewestLooks, mostLooks >> (deepest - depth));
    for (int i = 1; i < looks; ++i) {
      const Vec3 p = at(between(from, to, i / double(looks))) - a;
      const double length = step.norm();
      off = std::max(off, length > 0.0 ? p.cross(step).norm() / length : p.norm());
    }
    if (off <= chord_ || depth == 0 || line_.size() > mostPoints_) {
      add(to);
      return;
    }
    const double middle = (from + to) / 2.0;
    refine(from, middle, depth - 1);
    refine(middle, to, depth - 1);
  }

  /// Long pieces are looked at in more places: a wave must not look straight.
  static constexpr int fewestLooks = 4;
  static constexpr int mostLooks = 64;
  const Patch& patch_;
  bool alongU_;
  double other_;
  double chord_;
  std::uint64_t mostPoints_;
  SurfaceLine line_;
};

/// Points inside a straight stretch add nothing.
SurfaceLine withoutStraight(const SurfaceLine& line) {
  SurfaceLine result;
  for (const LinePoint& p : line) {
    while (result.size() >= 2) {
      const LinePoint& a = result[result.size() - 2];
      const LinePoint& b = result.back();
      const Vec3 whole = p.place - a.place;
      const bool straight =
          whole.cross(b.place - a.place).norm() <= tolerance::coincidence * whole.norm() &&
          (p.normal - a.normal).norm() <= tolerance::similarity;
      if (!straight) {
        break;
      }
      result.pop_back();
    }
    result.push_back(p);
  }
  return result;
}

/// The share of a cell that the planes keep: by parts where they cut it.
double keptShare(const Patch& patch, const Vec2& low, const Vec2& high) {
  constexpr int parts = 8;
  int corners = patch.keep.empty() ? 4 : 0;
  for (int i = 0; i < 4 && !patch.keep.empty(); ++i) {
    corners += patch.keeps(i % 2 == 0 ? low.x() : high.x(), i < 2 ? low.y() : high.y()) ? 1 : 0;
  }
  if (corners == 0 || corners == 4) {
    return corners / 4.0;
  }
  int kept = 0;
  for (int i = 0; i < parts * parts; ++i) {
    const double u = between(low.x(), high.x(), (i / parts + 0.5) / parts);
    const double v = between(low.y(), high.y(), (i % parts + 0.5) / parts);
    kept += patch.keeps(u, v) ? 1 : 0;
  }
  return kept / double{parts * parts};
}
}  // namespace

bool closesAlong(const Patch& patch, bool alongU) {
  const Vec3 a = alongU ? patch.at(patch.u0, between(patch.v0, patch.v1, 0.37))
                        : patch.at(between(patch.u0, patch.u1, 0.37), patch.v0);
  const Vec3 b = alongU ? patch.at(patch.u1, between(patch.v0, patch.v1, 0.37))
                        : patch.at(between(patch.u0, patch.u1, 0.37), patch.v1);
  return (a - b).norm() <= tolerance::coincidence;
}

double longestWay(const Patch& patch, bool alongU) {
  double longest = 0.0;
  for (int i = 0; i <= samples; ++i) {
    const double other = alongU ? between(patch.v0, patch.v1, i / double{samples})
                                : between(patch.u0, patch.u1, i / double{samples});
    // Chords are short of their arcs by the square of the step: two step sizes cancel that.
    const auto length = [&](int n) {
      double sum = 0.0;
      Vec3 before = alongU ? patch.at(patch.u0, other) : patch.at(other, patch.v0);
      for (int k = 1; k <= n; ++k) {
        const Vec3 now = alongU ? patch.at(between(patch.u0, patch.u1, k / double(n)), other)
                                : patch.at(other, between(patch.v0, patch.v1, k / double(n)));
        sum += (now - before).norm();
        before = now;
      }
      return sum;
    };
    const double coarse = length(2 * samples);
    const double fine = length(4 * samples);
    longest = std::max(longest, fine + (fine - coarse) / 3.0);
  }
  return longest;
}

double areaOf(const Patch& patch) {
  double area = 0.0;
  constexpr int n = 2 * samples;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const double ua = between(patch.u0, patch.u1, i / double{n});
      const double ub = between(patch.u0, patch.u1, (i + 1) / double{n});
      const double va = between(patch.v0, patch.v1, k / double{n});
      const double vb = between(patch.v0, patch.v1, (k + 1) / double{n});
      const Vec3 diagonal = patch.at(ub, vb) - patch.at(ua, va);
      const Vec3 other = patch.at(ua, vb) - patch.at(ub, va);
      area += diagonal.cross(other).norm() / 2.0 * keptShare(patch, {ua, va}, {ub, vb});
    }
  }
  return area;
}

double pointsNeeded(const Patch& patch, const Layout& layout) {
  const LineCount count = lineCount(longestWay(patch, !layout.alongU), layout.widest);
  constexpr int looks = 16;  // lines
  double chords = 0.0;
  for (int k = 0; k <= looks; ++k) {
    const double other = layout.alongU ? between(patch.v0, patch.v1, k / double{looks})
                                       : between(patch.u0, patch.u1, k / double{looks});
    const auto at = [&](double t) {
      return layout.alongU ? patch.at(between(patch.u0, patch.u1, t), other)
                           : patch.at(other, between(patch.v0, patch.v1, t));
    };
    constexpr double h = 1.0 / samples;
    for (int i = 0; i < samples; ++i) {
      // An arc of the length s and the bend k has chords of the length sqrt(8 chord / k).
      const Vec3 step = (at((i + 1) * h) - at(i * h)) / h;
      const Vec3 bend = (at((i + 1) * h) - 2.0 * at((i + 0.5) * h) + at(i * h)) * (4.0 / (h * h));
      const double speed = step.norm();
      const double across = speed > 0.0 ? step.cross(bend).norm() / speed : 0.0;
      chords += std::sqrt(across / (8.0 * layout.chord)) * h;
    }
  }
  return (chords / (looks + 1) + 1.0) * count.lines();
}

LineSet linesOn(const Patch& patch, const Layout& layout) {
  LineSet set;
  set.count = lineCount(longestWay(patch, !layout.alongU), layout.widest);
  std::uint64_t points = 0;
  const int last = set.count.intervals - (closesAlong(patch, !layout.alongU) ? 1 : 0);
  for (int i = 0; i <= last; ++i) {
    const double share = i / static_cast<double>(set.count.intervals);
    const double other =
        layout.alongU ? between(patch.v0, patch.v1, share) : between(patch.u0, patch.u1, share);
    SurfaceLine line = withoutStraight(Tracer(patch, layout, other).trace());
    points += line.size();
    if (points > layout.mostPoints) {
      set.complete = false;
      return set;
    }
    if (i % 2 == 1) {
      std::reverse(line.begin(), line.end());
    }
    set.lines.push_back(std::move(line));
  }
  return set;
}

}  // namespace arelem::spray
