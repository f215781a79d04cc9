#include "runtime/motion/surface_ends.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ir/diag/motion.h"
#include "ir/space/tolerance.h"
#include "runtime/geometry/ends.h"
#include "runtime/motion/missed.h"
#include "runtime/motion/told.h"

namespace arelem::motion {

namespace {
/// Cosine of the angle to the normal of a mesh from which on a tool at its border is beside it.
constexpr double beside = 0.01;

bool isOpen(const surface::Mesh& mesh) {
  const std::vector<bool>& border = mesh.shape().atBorder;
  return std::find(border.begin(), border.end(), true) != border.end();
}
}  // namespace

SurfaceEnds::SurfaceEnds(const Course& course) : course_(course) {
  for (const auto& [surface, guide] :
       {std::pair{&course.part, partRole}, std::pair{&course.drive, driveRole}}) {
    const auto* mesh = std::get_if<surface::Mesh>(&surface->surface);
    if (mesh == nullptr || !isOpen(*mesh)) {
      continue;
    }
    Open open{surface, guide, 1.0};
    const double cosine = leanOf(course.start.contacts[guide], open).cosine;
    if (std::abs(cosine) > beside) {
      open.side = std::copysign(1.0, cosine);
      open_.push_back(open);
    }
  }
}

SurfaceEnds::Lean SurfaceEnds::leanOf(const tool::Contact& contact, Open& open) {
  const auto& mesh = std::get<surface::Mesh>(open.surface->surface);
  const surface::MeshShape& shape = mesh.shape();
  // Next to the contact, towards the tool: nearest is what touches.
  const Vec3 next = contact.point - (contact.gap - tolerance::coincidence) * contact.normal;
  (void)mesh.foot(next, open.hint);
  const auto triangle = static_cast<std::size_t>(open.hint.triangle);
  const Lean lean{contact.normal.dot(shape.normalAt(triangle, open.hint.feature).normalized())};
  const auto place = static_cast<std::size_t>(open.hint.feature);
  if (open.hint.feature == geometry::Feature::face) {
    return {lean.cosine, true};  // behind it the tool has come round a border
  }
  const auto& corners = shape.mesh.triangles[triangle];
  const std::size_t first = (place - 1) % 3;
  const std::size_t second = place <= 3 ? place % 3 : first;
  return {lean.cosine, shape.atBorder[corners[first]] && shape.atBorder[corners[second]]};
}

std::optional<Failure> SurfaceEnds::passedAt(const PathPoint& last) {
  const Vec3 p = told(last.toolEnd);
  for (Open& open : open_) {
    const Lean lean = leanOf(last.contacts[open.guide], open);
    if (lean.mayBeOver && open.side * lean.cosine <= beside) {
      return fail(diag::ContactLost, course_.drive.name, course_.part.name, p.x(), p.y(), p.z())
          .withHelp("the tool has gone over the border of the mesh `" + open.surface->name +
                    "` and is beside it there");
    }
  }
  for (const auto& [surface, contact] : {std::pair{&course_.part, &last.contacts[partRole]},
                                         std::pair{&course_.drive, &last.contacts[driveRole]}}) {
    if (!surface::mayEnd(surface->surface)) {
      continue;
    }
    const double length = surface::endBefore(surface->surface, contact->point);
    if (length > 0.0) {
      const CheckWatch& w = course_.watches.front();
      if (w.neverLeft()) {
        return missed(course_);
      }
      const Vec3 q = told(w.nearestPlace());
      return fail(diag::RunsOffEnd, surface->name, p.x(), p.y(), p.z(), length, told(w.nearest()),
                  w.surface().name, q.x(), q.y(), q.z());
    }
  }
  return std::nullopt;
}

}  // namespace arelem::motion
