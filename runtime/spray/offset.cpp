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

Side sideOf(const Vec2& from, const Vec2& to, const Vec2& normal, const Footprint& footprint) {
  return {from, to, normal, touch(footprint, normal), support(footprint, normal)};
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
  if (footprint.along == 0.0) {  // a line reaches nowhere beside itself
    return std::abs(corner.x()) > tolerance::coincidence && std::isfinite(sharpest);
  }
  return std::hypot(corner.x() / footprint.along, corner.y() / footprint.across) > sharpest;
}

/// The side of no length that cuts off a sharp corner: the tangent of the footprint half way
/// between the two sides, seen where the footprint is a circle. The whole footprint stays inside.
Side bluntEnd(const Side& before, const Side& after, const Footprint& footprint) {
  const double flat = footprint.along / footprint.across;
  const auto direction = [&](const Side& side) {
    const Vec2 step = side.to - side.from;
    return Vec2(step.x(), flat * step.y()).normalized();
  };
  const Vec2 middle = direction(before) - direction(after);
  const Vec2 normal = Vec2(middle.x(), flat * middle.y()).normalized();
  return sideOf(before.to, before.to, normal, footprint);
}

/// The sides of a loop in order, sharp corners cut off.
std::vector<Side> sidesOf(const Loop& loop, const Footprint& footprint, double sharpest) {
  std::vector<Side> plain;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2& p = loop[i];
    const Vec2& q = loop[(i + 1) % loop.size()];
    const Vec2 step = q - p;
    const double length = step.norm();
    if (length > 0.0) {
      plain.push_back(sideOf(p, q, {step.y() / length, -step.x() / length}, footprint));
    }
  }
  std::vector<Side> sides;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const Side& next = plain[(i + 1) % plain.size()];
    sides.push_back(plain[i]);
    const std::optional<Vec2> corner = mitre(plain[i], next);
    if (corner && tooSharp(*corner, footprint, sharpest)) {
      sides.push_back(bluntEnd(plain[i], next, footprint));
    }
  }
  return sides;
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
  const std::vector<Side> sides = sidesOf(loop, footprint, sharpest);
  const std::size_t n = sides.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Side& side = sides[i];
    if (side.from != side.to) {
      const bool rises = side.from.y() <= side.to.y();
      edges_.push_back(rises ? Edge{side.from, side.to} : Edge{side.to, side.from});
      tallestEdge_ = std::max(tallestEdge_, edges_.back().to.y() - edges_.back().from.y());
    }
    Band band;
    band.corners = {side.from, side.to,
                    side.to + mitre(side, sides[(i + 1) % n]).value_or(side.contact),
                    side.from + mitre(sides[(i + n - 1) % n], side).value_or(side.contact)};
    const auto [low, high] =
        std::minmax_element(band.corners.begin(), band.corners.end(),
                            [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); });
    band.low = low->y();
    band.high = high->y();
    tallestBand_ = std::max(tallestBand_, band.high - band.low);
    bands_.push_back(band);
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
