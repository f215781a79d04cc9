#include "runtime/motion/surface_ends.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "ir/diag/motion.h"
#include "ir/space/tolerance.h"
#include "runtime/geometry/ends.h"
#include "runtime/motion/missed.h"
#include "runtime/motion/told.h"

namespace arelem::motion {

namespace {
/// Cosine of the angle to the normal of a mesh from which on a tool at its border is beside it.
constexpr double beside = 0.01;
/// Cosine to the normal on the side of the tool up to which on one that was beside it has come round
/// to the back.
constexpr double behind = -0.5;

/// How the border of a mesh faces: normals of contacts that are near to its own are not beside it.
class Border final : public surface::KeptWithMesh {
 public:
  explicit Border(const surface::MeshShape& shape) {
    const auto& triangles = shape.mesh.triangles;
    const auto forEach = [&](auto use) {
      for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto& t = triangles[i];
        if (shape.atBorder[t[0]] || shape.atBorder[t[1]] || shape.atBorder[t[2]]) {
          use(shape.normals[i]);
        }
      }
    };
    Vec3 sum = Vec3::Zero();
    forEach([&](const Vec3& normal) {
      sum += normal;
      open_ = true;
    });
    mean_ = sum.isZero(0.0) ? sum : Vec3(sum.normalized());
    double least = 1.0;
    forEach([&](const Vec3& normal) { least = std::min(least, normal.dot(mean_)); });
    // What is beside one of them is so far from their mean, less the angle between the two.
    far_ = least > beside ? beside * least + std::sqrt((1.0 - beside * beside) *
                                                       (1.0 - std::min(1.0, least * least)))
                          : 1.0;
  }
  [[nodiscard]] bool isOpen() const { return open_; }
  [[nodiscard]] bool mayBeOver(const Vec3& normal, double side) const {
    return side * normal.dot(mean_) <= far_;
  }

  /// That of a mesh.
  static std::shared_ptr<const Border> of(const surface::MeshShape& shape) {
    const auto kept = shape.kept(
        [](const surface::KeptWithMesh& one) {
          return dynamic_cast<const Border*>(&one) != nullptr;
        },
        [&] { return std::make_shared<const Border>(shape); });
    return std::dynamic_pointer_cast<const Border>(kept);
  }

 private:
  bool open_ = false;
  Vec3 mean_ = Vec3::Zero();
  double far_ = 1.0;
};
}  // namespace

SurfaceEnds::SurfaceEnds(const Course& course) : course_(course) {
  for (const auto& [surface, guide] :
       {std::pair{&course.part, partRole}, std::pair{&course.drive, driveRole}}) {
    const auto* mesh = std::get_if<surface::Mesh>(&surface->surface);
    const auto border = mesh != nullptr ? Border::of(mesh->shape()) : nullptr;
    if (border == nullptr || !border->isOpen()) {
      continue;
    }
    Open open{surface, guide, 1.0, [border](const Vec3& normal, double side) {
                return border->mayBeOver(normal, side);
              }};
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

std::optional<Failure> SurfaceEnds::overBorder(const PathPoint& last) {
  for (Open& open : open_) {
    const tool::Contact& contact = last.contacts[open.guide];
    if (!open.mayBeOver(contact.normal, open.side)) {
      continue;
    }
    const Lean lean = leanOf(contact, open);
    if (!lean.mayBeOver || open.side * lean.cosine > beside) {
      continue;
    }
    if (!over_) {
      const Vec3 p = told(last.toolEnd);
      over_ = fail(diag::ContactLost, course_.drive.name, course_.part.name, p.x(), p.y(), p.z())
                  .withHelp("the tool goes over the border of the mesh `" + open.surface->name +
                            "` there and is beside it");
    }
    if (open.side * lean.cosine <= behind) {
      return over_;
    }
  }
  return std::nullopt;
}

std::optional<Failure> SurfaceEnds::passedAt(const PathPoint& last) {
  const Vec3 p = told(last.toolEnd);
  if (auto round = overBorder(last)) {
    return round;
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

Failure SurfaceEnds::causeOf(Failure failure) {
  const DiagRow* row = failure.row;
  const bool ofPath = row == diag::ContactLost.row || row == diag::SurfacesParallel.row ||
                      row == diag::CheckNotReached.row || row == diag::NoTangency.row ||
                      row == diag::CutterDoesNotFit.row || row == diag::CutVectorLimit.row;
  return ofPath && over_ ? *std::move(over_) : std::move(failure);
}

}  // namespace arelem::motion
