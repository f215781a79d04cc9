#include "runtime/spray/offset.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ir/space/tolerance.h"

namespace arelem::spray {

namespace {
/// One side of the outline with the normal that points away from the paint.
struct Side {
  Vec2 from, to, normal, contact;
  double distance = 0.0;
};

std::vector<Side> sidesOf(const Loop& loop, const Footprint& footprint) {
  std::vector<Side> sides;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2& p = loop[i];
    const Vec2& q = loop[(i + 1) % loop.size()];
    const Vec2 step = q - p;
    const double length = step.norm();
    if (length > 0.0) {
      const Vec2 normal(step.y() / length, -step.x() / length);
      sides.push_back({p, q, normal, touch(footprint, normal), support(footprint, normal)});
    }
  }
  return sides;
}

/// From the vertex between two sides to the corner of their offset lines, none at an inner corner.
std::optional<Vec2> mitre(const Side& before, const Side& after) {
  const double sine = before.normal.x() * after.normal.y() - before.normal.y() * after.normal.x();
  if (sine <= tolerance::singular) {
    return std::nullopt;
  }
  return Vec2((before.distance * after.normal.y() - after.distance * before.normal.y()) / sine,
              (after.distance * before.normal.x() - before.distance * after.normal.x()) / sine);
}

bool tooSharp(const Vec2& corner, const Footprint& footprint, double sharpest) {
  const double reach = std::hypot(footprint.along > 0.0 ? corner.x() / footprint.along : 0.0,
                                  corner.y() / footprint.across);
  return reach > sharpest;
}

void widen(Interval& interval, double x) {
  interval.from = std::min(interval.from, x);
  interval.to = std::max(interval.to, x);
}

constexpr Interval nothing = {std::numeric_limits<double>::infinity(),
                              -std::numeric_limits<double>::infinity()};

std::vector<Interval> joined(std::vector<Interval> parts) {
  std::sort(parts.begin(), parts.end(),
            [](const Interval& a, const Interval& b) { return a.from < b.from; });
  std::vector<Interval> result;
  for (const Interval& part : parts) {
    if (!result.empty() && part.from <= result.back().to + tolerance::passGap) {
      result.back().to = std::max(result.back().to, part.to);
    } else {
      result.push_back(part);
    }
  }
  return result;
}
}  // namespace

double support(const Footprint& footprint, const Vec2& normal) {
  return std::hypot(footprint.along * normal.x(), footprint.across * normal.y());
}

Vec2 touch(const Footprint& footprint, const Vec2& normal) {
  const double distance = support(footprint, normal);
  if (distance == 0.0) {
    return Vec2::Zero();
  }
  return {footprint.along * footprint.along * normal.x() / distance,
          footprint.across * footprint.across * normal.y() / distance};
}

SprayedArea::SprayedArea(const Outline& outline, const Footprint& footprint, double sharpest) {
  for (const Loop& loop : outline.loops) {
    addLoop(loop, footprint, sharpest);
  }
  std::sort(bands_.begin(), bands_.end(),
            [](const Band& a, const Band& b) { return a.low < b.low; });
  std::sort(edges_.begin(), edges_.end(),
            [](const Edge& a, const Edge& b) { return a.from.y() < b.from.y(); });
}

void SprayedArea::addLoop(const Loop& loop, const Footprint& footprint, double sharpest) {
  const std::vector<Side> sides = sidesOf(loop, footprint);
  const std::size_t n = sides.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Side& side = sides[i];
    const bool rises = side.from.y() <= side.to.y();
    edges_.push_back(rises ? Edge{side.from, side.to} : Edge{side.to, side.from});
    tallestEdge_ = std::max(tallestEdge_, edges_.back().to.y() - edges_.back().from.y());
    const auto cornerAt = [&](const Side& before, const Side& after) {
      const std::optional<Vec2> corner = mitre(before, after);
      return corner && !tooSharp(*corner, footprint, sharpest) ? *corner : side.contact;
    };
    Band band;
    band.corners = {side.from, side.to, side.to + cornerAt(side, sides[(i + 1) % n]),
                    side.from + cornerAt(sides[(i + n - 1) % n], side)};
    band.low = std::numeric_limits<double>::infinity();
    band.high = -band.low;
    for (const Vec2& corner : band.corners) {
      band.low = std::min(band.low, corner.y());
      band.high = std::max(band.high, corner.y());
    }
    tallestBand_ = std::max(tallestBand_, band.high - band.low);
    bands_.push_back(band);
    const std::optional<Vec2> corner = mitre(side, sides[(i + 1) % n]);
    if (corner && tooSharp(*corner, footprint, sharpest)) {
      // A blunt end: the triangle between the two contacts.
      Band blunt;
      const Vec2& at = side.to;
      blunt.corners = {at, at + side.contact, at + sides[(i + 1) % n].contact, at};
      blunt.low = std::min({blunt.corners[0].y(), blunt.corners[1].y(), blunt.corners[2].y()});
      blunt.high = std::max({blunt.corners[0].y(), blunt.corners[1].y(), blunt.corners[2].y()});
      tallestBand_ = std::max(tallestBand_, blunt.high - blunt.low);
      bands_.push_back(blunt);
    }
  }
}

std::vector<Interval> SprayedArea::at(double height) const {
  std::vector<Interval> parts;
  std::vector<double> crossings;
  const auto firstEdge =
      std::lower_bound(edges_.begin(), edges_.end(), height - tallestEdge_,
                       [](const Edge& edge, double y) { return edge.from.y() < y; });
  for (auto edge = firstEdge; edge != edges_.end() && edge->from.y() <= height; ++edge) {
    if (edge->to.y() > height) {
      const Vec2 step = edge->to - edge->from;
      crossings.push_back(edge->from.x() + (height - edge->from.y()) * step.x() / step.y());
    }
  }
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t i = 1; i < crossings.size(); i += 2) {
    parts.push_back({crossings[i - 1], crossings[i]});
  }
  const auto firstBand = std::lower_bound(bands_.begin(), bands_.end(), height - tallestBand_,
                                          [](const Band& band, double y) { return band.low < y; });
  for (auto band = firstBand; band != bands_.end() && band->low <= height; ++band) {
    if (band->high < height) {
      continue;
    }
    Interval part = nothing;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec2& p = band->corners[i];
      const Vec2& q = band->corners[(i + 1) % 4];
      if (p.y() == height) {
        widen(part, p.x());
      }
      if ((p.y() < height) != (q.y() < height)) {
        widen(part, p.x() + (height - p.y()) * (q.x() - p.x()) / (q.y() - p.y()));
      }
    }
    if (part.from <= part.to) {
      parts.push_back(part);
    }
  }
  return joined(std::move(parts));
}

}  // namespace arelem::spray
