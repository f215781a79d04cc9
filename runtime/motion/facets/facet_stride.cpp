#include "runtime/motion/facets/facet_stride.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ir/space/tolerance.h"

namespace arelem::motion {

namespace {
/// A start may be outside of the tunnel by this share of the band; its cut vector is proven by
/// itself.
constexpr double outsideShare = 0.3;
constexpr double insideShare = 1e-4;
/// Bands narrower than this share of the coordinates' size are left to the general search.
constexpr double finestBand = 1e-10;
/// Heights are measured along the tool axis where it is within these cosines of the section and of
/// the contact normal, else along that normal.
constexpr double axisInSection = 0.5;
constexpr double axisAlongNormal = 0.6;
/// Where on the ray a path may bend best is seen at this many places.
constexpr int places = 4;
/// The tunnel is looked at this far beyond a cut vector of usual length, as a share of it.
constexpr double further = 0.3;
/// Steps of a tunnel before one cut vector must end.
constexpr int extensionLimit = 20000;
/// Cut vectors shorter than this share of the usual end at a wall.
constexpr double shortShare = 0.02;
constexpr double leastBend = 1e-12;
}  // namespace

bool FacetStride::applies() {
  if (!looked_) {
    looked_ = true;
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
      if (path_.guides[i].field->isFaceted() && path_.guides[1 - i].flat()) {
        facets_ = path_.guides[i].field->facets();
        mesh_ = i;
        plane_ = 1 - i;
      }
    }
  }
  return facets_.has_value() && path_.axis.isFixed();
}

/// A section through `a`, and its tunnel.
bool FacetStride::begin(const PathPoint& a) {
  builder_.reset();
  const Guide& g = path_.guides[mesh_];
  const Guide& flat = path_.guides[plane_];
  const double band = g.inner + g.outer;
  const double size = 1.0 + a.toolEnd.cwiseAbs().maxCoeff();
  const double off = std::abs(a.contacts[plane_].gap - flat.vertexGap());
  if (band < finestBand * size || off > Guide::aimShare * (flat.inner + flat.outer)) {
    return false;
  }
  const Vec3& across = a.contacts[plane_].normal;
  const auto inSection = [&](const Vec3& v) { return Vec3(v - v.dot(across) * across); };
  const Vec3 normal = inSection(a.contacts[mesh_].normal);
  const Vec3 axis = inSection(a.axis);
  if (normal.norm() <= tolerance::nullDirection) {
    return false;
  }
  const bool upright = axis.norm() >= axisInSection &&
                       axis.dot(normal) >= axisAlongNormal * axis.norm() * normal.norm();
  FacetTask task{facets_->mesh, facets_->cutter, a.axis, {}, 0.0, 0.0};
  task.low = facets_->thick - g.inner;
  task.high = facets_->thick + g.outer;
  task.section.origin = a.toolEnd;
  task.section.up = (upright ? axis : normal).normalized();
  task.section.along = across.cross(task.section.up);
  if (task.section.along.dot(a.tangent) < 0.0) {
    task.section.along = -task.section.along;
  }
  const double radius = std::max(facets_->cutter->maxRadius(), band);
  usual_ = usual_ > 0.0 ? usual_ : std::sqrt(8.0 * radius * band);
  builder_ = std::make_unique<TunnelBuilder>(task, usual_);
  if (!builder_->begin({})) {
    builder_.reset();
  }
  return builder_ != nullptr;
}

bool FacetStride::isInside(const PathPoint& a) const {
  if (!builder_) {
    return false;
  }
  const Section& section = builder_->task().section;
  const SectionPoint p = section.pointOf(a.toolEnd);
  const Tunnel& t = builder_->tunnel();
  const double slack = outsideShare * (builder_->task().high - builder_->task().low);
  return (section.at(p) - a.toolEnd).norm() <= tolerance::sameSide &&
         a.tangent.dot(section.along) > 0.0 && p.s >= t.begin() && p.s < t.end() &&
         p.z >= t.bottomAt(p.s) - slack && p.z <= t.topAt(p.s) + slack;
}

Tunnel::Reach FacetStride::reachFrom(const SectionPoint& eye) {
  double ahead = eye.s + (1.0 + further) * usual_;
  for (int i = 0;; ++i) {
    while (i < extensionLimit && builder_->tunnel().end() < ahead && builder_->extend()) {
      ++i;
    }
    const Tunnel::Reach reach = builder_->tunnel().farthest(eye);
    if (reach.edge != 0 || i >= extensionLimit || !builder_->extend()) {
      return reach;
    }
    ahead = eye.s + 1.5 * (ahead - eye.s);
  }
}

/// The place on the ray from which the next cut vector reaches farthest.
SectionPoint FacetStride::bestEnd(const SectionPoint& eye, const Tunnel::Reach& reach) {
  SectionPoint best = reach.end;
  if (reach.edge == 0 || !(reach.from > eye.s)) {
    return best;
  }
  double farthest = reachFrom(best).end.s;
  for (int i = 1; i < places; ++i) {
    const double s = reach.end.s + static_cast<double>(i) / places * (reach.from - reach.end.s);
    const SectionPoint place{s, heightOn(eye, reach.end, s)};
    const double seen = reachFrom(place).end.s;
    if (seen > farthest) {
      farthest = seen;
      best = place;
    }
  }
  return best;
}

std::optional<PathPoint> FacetStride::pointAt(const SectionPoint& p, const PathPoint& a) {
  PathPoint b;
  b.toolEnd = builder_->task().section.at(p);
  b.axis = a.axis;
  const tool::TriangleGap touch = builder_->touchAt(p);
  b.contacts[mesh_] = {touch.gap - facets_->thick, touch.normal, touch.onCutter};
  b.contacts[plane_] = path_.guides[plane_].field->at(b.toolEnd, b.axis);
  if (!path_.aim(b, builder_->task().section.along)) {
    return std::nullopt;
  }
  return b;
}

std::optional<PathPoint> FacetStride::next(const PathPoint& a, double cap) {
  cutShort_ = false;
  if (!applies()) {
    return std::nullopt;
  }
  for (int attempt = 0; attempt < 2; ++attempt) {
    if (!isInside(a) || attempt > 0) {
      if (!begin(a) || !isInside(a)) {
        return std::nullopt;
      }
      attempt = 1;
    }
    const Tunnel& tunnel = builder_->tunnel();
    SectionPoint eye = builder_->task().section.pointOf(a.toolEnd);
    const double height = eye.z;
    eye.z = std::clamp(eye.z, tunnel.bottomAt(eye.s), tunnel.topAt(eye.s));
    const Tunnel::Reach reach = reachFrom(eye);
    if (reach.end.s - eye.s <= shortShare * usual_) {
      continue;
    }
    SectionPoint end = reach.end;
    const double length = std::hypot(end.s - eye.s, end.z - eye.z);
    if (length > cap) {
      end.s = eye.s + cap / length * (end.s - eye.s);
      end.z = heightOn(eye, reach.end, end.s);
    } else {
      cutShort_ = reach.edge == 0;
      end = bestEnd(eye, reach);
      usual_ = end.s - eye.s;
    }
    auto b = pointAt(end, a);
    const double band = builder_->task().high - builder_->task().low;
    if (b && std::abs(eye.z - height) > insideShare * band &&
        path_.fit(a, *b) < 1.0 - tolerance::coincidence) {
      return std::nullopt;
    }
    path_.guides[mesh_].startAnew(reach.edge < 0 ? -leastBend : leastBend);
    builder_->forget(eye.s);
    return b;
  }
  return std::nullopt;
}

}  // namespace arelem::motion
