#include "runtime/interpret/spray_work.h"

#include "ir/diag/spray.h"
#include "runtime/define/choice.h"
#include "runtime/geometry/triangle_mesh.h"

namespace arelem::runtime::interpret {

namespace {
using Sides = std::vector<spray::HalfSpace>;
using MeshPtr = std::shared_ptr<const spray::MeshSurface>;

/// The planes of LIMITS with the side that is kept, mm.
Result<Sides> sidesOf(const SprayWords& words, double unit) {
  Sides sides;
  for (const SprayWords::Side& side : words.sides) {
    const geometry::Plane plane = geometry::Plane::of(side.plane->canon);
    Result<Vec3> normal = define::orient(side.modifier, plane.normal);
    if (!normal) {
      return normal.takeFailure();
    }
    const double sign = normal->dot(plane.normal) > 0.0 ? 1.0 : -1.0;
    sides.push_back({*normal, sign * plane.distance * unit});
  }
  return sides;
}

std::optional<Failure> setMesh(spray::SurfaceJob& job,
                               const SprayWords& words,
                               const Sides& keep,
                               double unit) {
  using Lines = SprayWords::Lines;
  if (words.lines == Lines::alongU || words.lines == Lines::alongV) {
    return fail(diag::MeshLines, words.lines == Lines::alongU ? "ULINES" : "VLINES");
  }
  if (words.limits) {
    return fail(diag::MeshLines, "parameters for LIMITS");
  }
  geometry::TriangleMesh mesh = geometry::TriangleMesh::of(words.work->canon);
  for (Vec3& corner : mesh.vertices) {
    corner *= unit;
  }
  const auto whole = std::make_shared<const spray::MeshSurface>(std::move(mesh), words.otherSide);
  const auto cut = [&whole](const Sides& sides) {
    return sides.empty() ? whole : std::make_shared<const spray::MeshSurface>(whole->cutBy(sides));
  };
  job.wholeMesh = whole;
  job.mesh = cut(keep);
  job.wideMesh = cut(job.ends);
  if (job.mesh->mesh().triangles.empty()) {
    return fail(diag::SurfaceLimits, "MESH", "nothing left",
                "the planes of LIMITS must keep a part of it");
  }
  return std::nullopt;
}
}  // namespace

std::optional<Failure> setWork(spray::SurfaceJob& job, const SprayWords& words, double unit) {
  Result<Sides> keep = sidesOf(words, unit);
  if (!keep) {
    return keep.takeFailure();
  }
  job.past = words.past * unit;
  job.ends = *keep;
  for (spray::HalfSpace& side : job.ends) {
    side.level -= job.past;
  }
  if (words.work->type == EntityType::mesh) {
    return setMesh(job, words, *keep, unit);
  }
  // What has ends of its own is there beyond LIMITS too.
  if (Result<spray::Patch> whole = spray::patchOf(*words.work, {}, unit)) {
    whole->flipped = words.otherSide;
    job.wholePatch = *std::move(whole);
  }
  for (const bool wide : {false, true}) {
    if (wide && (job.past <= 0.0 || keep->empty())) {
      return std::nullopt;
    }
    Result<spray::Patch> patch =
        spray::patchOf(*words.work, {words.limits, wide ? job.ends : *keep}, unit);
    if (!patch) {
      return patch.takeFailure();
    }
    patch->flipped = words.otherSide;
    (wide ? job.widePatch.emplace() : job.patch) = *std::move(patch);
  }
  return std::nullopt;
}

}  // namespace arelem::runtime::interpret
