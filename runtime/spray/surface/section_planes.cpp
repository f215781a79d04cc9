#include "runtime/spray/surface/section_planes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "ir/diag/spray.h"
#include "ir/space/spray_tolerance.h"
#include "ir/space/tolerance.h"
#include "runtime/region/region.h"
#include "runtime/spray/surface/gap.h"
#include "runtime/spray/surface/kept.h"

namespace arelem::spray {

namespace {
constexpr double degree = std::numbers::pi / 180.0;
constexpr int samples = 64;

/// Places that span the work, and which of them are neighbors.
KeptGrid gridOf(const SurfaceJob& job) {
  if (!job.mesh) {
    return keptGrid(job.patch, samples);
  }
  const geometry::TriangleMesh& mesh = job.mesh->mesh();
  KeptGrid grid;
  grid.places = mesh.vertices;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      grid.neighbors.emplace_back(triangle[k], triangle[(k + 1) % 3]);
    }
  }
  return grid;
}

std::pair<double, double> rangeOf(const KeptGrid& grid,
                                  const std::function<double(const Vec3&)>& field) {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (const Vec3& place : grid.places) {
    low = std::min(low, field(place));
    high = std::max(high, field(place));
  }
  return {low, high};
}

/// Angle about the axis of radial sections, degrees from the frame's x.
double angleOf(const SurfaceJob::Radial& radial, const Vec3& place) {
  const region::Frame frame = region::frameOf(radial.axis, Vec3::Zero());
  const Vec3 arm = place - radial.place;
  return std::atan2(arm.dot(frame.y), arm.dot(frame.x)) / degree;
}

/// What the sections are levels of: the height over a plane in mm, or the angle about an axis in
/// degrees.
struct Levels {
  std::function<double(const Vec3&)> field;
  std::vector<double> values;
  double start = 0.0;  ///< of angles, degrees
  double step = 0.0;   ///< mm, where they are farthest apart
  bool closed = false;
};

/// Equal steps between the extremes; the outermost sections lie a little inside. Radial sections of
/// a whole turn have no double one; those of less begin behind the empty side.
Result<Levels> levelsOf(const SurfaceJob& job, double widest) {
  const KeptGrid grid = gridOf(job);
  Levels levels;
  double lengthOfUnit = 1.0;
  bool wholeTurn = false;
  if (const auto* parallel = std::get_if<SurfaceJob::Parallel>(&job.lines)) {
    levels.field = [n = parallel->normal](const Vec3& p) { return n.dot(p); };
  } else {
    const auto& radial = std::get<SurfaceJob::Radial>(job.lines);
    std::vector<std::pair<double, double>> arcs;
    for (const auto& [a, b] : grid.neighbors) {
      arcs.emplace_back(angleOf(radial, grid.places[a]), angleOf(radial, grid.places[b]));
    }
    const std::optional<double> gap = middleOfGap(arcs);
    wholeTurn = !gap;
    levels.start = gap.value_or(0.0);
    levels.field = [radial, start = levels.start](const Vec3& p) {
      const double turn = angleOf(radial, p) - start;
      return turn - 360.0 * std::floor(turn / 360.0);
    };
    const auto arm = rangeOf(
        grid, [&radial](const Vec3& p) { return (p - radial.place).cross(radial.axis).norm(); });
    lengthOfUnit = arm.second * degree;
  }
  const auto [low, high] = wholeTurn ? std::pair{0.0, 360.0} : rangeOf(grid, levels.field);
  const double length = (high - low) * lengthOfUnit;
  if (auto failure = objectionToLines(length / widest, job.mostLines)) {
    return *std::move(failure);
  }
  const LineCount count = lineCount(length, widest);
  const double margin = tolerance::sectionMargin * (high - low);
  const int last = count.intervals - (wholeTurn ? 1 : 0);
  for (int i = 0; i <= last; ++i) {
    levels.values.push_back(low + margin + (high - low - 2.0 * margin) * i / count.intervals);
  }
  levels.step = count.step;
  levels.closed = wholeTurn;
  return levels;
}

/// How often planes so far apart cross the triangles of a mesh, about.
double crossings(const geometry::TriangleMesh& mesh, const Vec3& normal, double step) {
  double height = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [low, high] =
        std::minmax({normal.dot(mesh.corner(t, 0)), normal.dot(mesh.corner(t, 1)),
                     normal.dot(mesh.corner(t, 2))});
    height += high - low;
  }
  return height / step;
}
}  // namespace

Result<SectionPlanes> sectionPlanes(const SurfaceJob& job, double widest) {
  SectionPlanes result;
  const Result<Levels> levels = levelsOf(job, widest);
  if (!levels) {
    return levels.failure();
  }
  result.step = levels->step;
  result.closed = levels->closed;
  for (const double level : levels->values) {
    CuttingPlane& plane = result.planes.emplace_back();
    if (const auto* parallel = std::get_if<SurfaceJob::Parallel>(&job.lines)) {
      plane.normal = parallel->normal;
      plane.level = level;
      continue;
    }
    const auto& radial = std::get<SurfaceJob::Radial>(job.lines);
    const region::Frame frame = region::frameOf(radial.axis, Vec3::Zero());
    const double angle = (levels->start + level) * degree;
    plane.half = std::cos(angle) * frame.x + std::sin(angle) * frame.y;
    plane.place = radial.place;
    plane.normal = radial.axis.cross(*plane.half);
    plane.level = plane.normal.dot(radial.place);
  }
  if (job.mesh) {
    // Radial planes are as many as parallel ones where they lie farthest apart.
    const double points = crossings(job.mesh->mesh(), result.planes.front().normal, result.step);
    if (points > static_cast<double>(job.mostPoints)) {
      return fail(diag::SprayPoints, points, job.chord, job.mostPoints)
          .withHelp("a larger STEP needs fewer");
    }
  }
  return result;
}

std::vector<CuttingPlane> planesAcross(const SurfaceJob& job) {
  constexpr int count = 9;
  Vec3 normal = Vec3::Zero();
  if (const auto* parallel = std::get_if<SurfaceJob::Parallel>(&job.lines)) {
    normal = job.mesh->meanNormal().cross(parallel->normal);
    normal = normal.norm() > tolerance::nullDirection
                 ? normal.normalized()
                 : region::frameOf(parallel->normal, Vec3::Zero()).x;
  } else {
    normal = std::get<SurfaceJob::Radial>(job.lines).axis;
  }
  const auto [low, high] = job.mesh->range(normal);
  std::vector<CuttingPlane> result;
  for (int i = 0; i < count; ++i) {
    CuttingPlane& plane = result.emplace_back();
    plane.normal = normal;
    plane.level = low + (high - low) * (i + 0.5) / count;
  }
  return result;
}

}  // namespace arelem::spray
