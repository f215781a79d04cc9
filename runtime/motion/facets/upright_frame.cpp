#include "runtime/motion/facets/upright_frame.h"

#include <algorithm>
#include <cmath>

namespace arelem::motion {

UprightFrame::UprightFrame(const FacetTask& task, const tool::UprightProfile& profile)
    : task_(task),
      bounds_(profile, task.cutter->maxRadius() + std::max(task.low, 0.0)),
      across_(task.section.up.cross(task.section.along)),
      share_(task.section.along.cwiseAbs()),
      upright_(task.section.up == Vec3::UnitZ()) {}

Vec3 UprightFrame::turned(const Vec3& d) const {
  if (upright_) {
    return {task_.section.along.x() * d.x() + task_.section.along.y() * d.y(),
            across_.x() * d.x() + across_.y() * d.y(), d.z()};
  }
  return {task_.section.along.dot(d), across_.dot(d), task_.section.up.dot(d)};
}

Vec3 UprightFrame::local(const Vec3& place) const {
  return turned(place - task_.section.origin);
}

UprightFrame::Box UprightFrame::boxOf(const Vec3& center,
                                      const Vec3& half,
                                      const Cover& cover) const {
  Box box;
  box.middle = local(center);
  box.half = upright_ ? Vec3(share_.x() * half.x() + share_.y() * half.y(),
                             share_.y() * half.x() + share_.x() * half.y(), half.z())
                      : Vec3(share_.dot(half), across_.cwiseAbs().dot(half),
                             task_.section.up.cwiseAbs().dot(half));
  const Vec3 normal(cover.normal[0], cover.normal[1], cover.normal[2]);
  box.plane = turned(normal);
  box.beyond = cover.most - normal.dot(center);
  if (box.plane.z() < UprightBounds::usefulRise) {
    // Where the other side looks up nothing is known of it.
    box.plane = Vec3::Zero();
  }
  const double lean = std::sqrt(box.plane.x() * box.plane.x() + box.plane.y() * box.plane.y());
  box.out = lean > 0.0 ? bounds_.profile().r + bounds_.profile().e / lean : 0.0;
  return box;
}

/// Leaves of the way where the cutter comes to a box; false where it does not.
bool UprightFrame::meets(const Box& box, UprightBounds::Doubt& doubt) const {
  const double radius = bounds_.radius();
  if (std::abs(box.middle.y()) - box.half.y() > radius) {
    return false;
  }
  doubt.from = std::max(doubt.from, box.middle.x() - box.half.x() - radius);
  doubt.to = std::min(doubt.to, box.middle.x() + box.half.x() + radius);
  if (doubt.from > doubt.to) {
    return false;
  }
  const double out = box.middle.x() - std::clamp(box.middle.x(), doubt.from, doubt.to);
  const double distance = std::sqrt(out * out + box.middle.y() * box.middle.y());
  return distance * (distance - radius) <=
         std::abs(out) * box.half.x() + std::abs(box.middle.y()) * box.half.y();
}

/// The normal with which the cutter would touch the plane of a box, or what of the box is near to
/// that place.
UprightBounds::Normal UprightFrame::normalFor(const Box& box, double s) const {
  const auto nearest = [&](double place, Eigen::Index k) {
    return std::clamp(place, box.middle[k] - box.half[k], box.middle[k] + box.half[k]);
  };
  double x = nearest(s - box.out * box.plane.x(), 0) - s;
  double y = nearest(-box.out * box.plane.y(), 1);
  const double rho = std::sqrt(x * x + y * y);
  if (box.plane.z() <= 0.0 || bounds_.isSharp() || bounds_.profile().e <= 0.0 || rho <= 0.0) {
    return bounds_.normalTowards(x, y);
  }
  // On the same ray the plane is touched where the arc rises as the plane does.
  const double fall = (box.plane.x() * x + box.plane.y() * y) / rho;
  const double rise = std::max(0.0, -fall / box.plane.z());
  const double best =
      bounds_.profile().e + bounds_.profile().r * rise / std::sqrt(1.0 + rise * rise);
  const double share = (fall >= 0.0 ? std::min(rho, best) : best) / rho;
  x = nearest(share * x + s, 0) - s;
  y = nearest(share * y, 1);
  return bounds_.normalTowards(x, y);
}

/// Above what may be touched of a box, best near s: where the cutter would touch its plane, or near
/// to that. How far places reach along a normal is how far
/// they reach along that of the plane that covers them, and along the rest.
UprightBounds::Line UprightFrame::lineOf(const Box& box, double s) const {
  const UprightBounds::Normal n = normalFor(box, s);
  double most = n.n.cwiseAbs().dot(box.half);
  if (box.plane.z() > 0.0) {
    const double share = n.n.z() / box.plane.z();
    const Vec3 rest = n.n - share * box.plane;
    most = std::min(most, share * box.beyond + rest.cwiseAbs().dot(box.half));
  }
  return bounds_.lineOf(most + n.n.dot(box.middle), n);
}

tool::UprightFacet UprightFrame::facetOf(std::size_t i) const {
  const surface::MeshShape& shape = task_.mesh->shape();
  const Vec3 up = turned(shape.normals[i]);
  return {{local(shape.mesh.corner(i, 0)), local(shape.mesh.corner(i, 1)),
           local(shape.mesh.corner(i, 2))},
          up.z() < 0.0 ? Vec3(-up) : up};
}

}  // namespace arelem::motion
