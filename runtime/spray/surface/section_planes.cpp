#include "runtime/spray/surface/section_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "ir/diag/spray.h"
#include "ir/space/spray_tolerance.h"
#include "ir/space/tolerance.h"
#include "runtime/region/region.h"
#include "runtime/spray/surface/gap.h"
#include "runtime/spray/surface/ground.h"
#include "runtime/spray/surface/kept.h"
#include "runtime/spray/surface/patch_mesh.h"

namespace arelem::spray {

namespace {
constexpr double degree = std::numbers::pi / 180.0;
constexpr double turn = 2.0 * std::numbers::pi;
constexpr int samples = 64;
constexpr std::uint32_t leanSteps = 128;

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

/// The work in triangles.
geometry::TriangleMesh trianglesOf(const SurfaceJob& job) {
  if (job.mesh) {
    return job.mesh->mesh();
  }
  ShadedMesh whole;
  whole.mesh = meshOf(job.patch, leanSteps).mesh;
  whole.normals.resize(whole.mesh.triangles.size(), {Vec3::UnitZ(), Vec3::UnitZ(), Vec3::UnitZ()});
  return clipped(std::move(whole), job.patch.keep).mesh;
}

/// Angle about the axis of radial sections, radians from the frame's x.
double angleOf(const SurfaceJob::Radial& radial, const Vec3& place) {
  const region::Frame frame = region::frameOf(radial.axis, Vec3::Zero());
  const Vec3 arm = place - radial.place;
  return std::atan2(arm.dot(frame.y), arm.dot(frame.x));
}

double intoTurn(double angle) {
  return angle - turn * std::floor(angle / turn);
}

/// How far it is over a surface across sections, in a unit of their level: planes with this normal,
/// and as far apart at the place as `unit` tells.
double apartOver(const Vec3& surface, const Vec3& planes, double unit) {
  return unit / std::max(surface.cross(planes).norm(), tolerance::leastLean);
}

/// What the sections are levels of: the height over a plane, or the angle about an axis from
/// `start` on.
class Field {
 public:
  explicit Field(const SurfaceJob& job) : job_(job) {
    const KeptGrid grid = gridOf(job);
    if (const auto* radial = std::get_if<SurfaceJob::Radial>(&job.lines)) {
      std::vector<std::pair<double, double>> arcs;
      for (const auto& [a, b] : grid.neighbors) {
        arcs.emplace_back(angleOf(*radial, grid.places[a]) / degree,
                          angleOf(*radial, grid.places[b]) / degree);
      }
      const std::optional<double> gap = middleOfGap(arcs);
      closed_ = !gap;
      start_ = gap.value_or(0.0) * degree;
    }
    low_ = closed_ ? 0.0 : HUGE_VAL;
    high_ = closed_ ? turn : -HUGE_VAL;
    for (const Vec3& place : grid.places) {
      low_ = std::min(low_, level(place));
      high_ = std::max(high_, level(place));
    }
  }

  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }
  [[nodiscard]] bool closed() const { return closed_; }

  [[nodiscard]] CuttingPlane plane(double level) const {
    CuttingPlane plane;
    if (const auto* parallel = std::get_if<SurfaceJob::Parallel>(&job_.lines)) {
      plane.normal = parallel->normal;
      plane.level = level;
      return plane;
    }
    const auto& radial = std::get<SurfaceJob::Radial>(job_.lines);
    const region::Frame frame = region::frameOf(radial.axis, Vec3::Zero());
    plane.half = std::cos(start_ + level) * frame.x + std::sin(start_ + level) * frame.y;
    plane.place = radial.place;
    plane.normal = radial.axis.cross(*plane.half);
    plane.level = plane.normal.dot(radial.place);
    return plane;
  }

  /// The levels that each triangle lies between.
  [[nodiscard]] std::vector<LevelSpan> spans() const {
    const geometry::TriangleMesh mesh = trianglesOf(job_);
    std::vector<LevelSpan> spans;
    spans.reserve(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const std::array<Vec3, 3> corners = {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
      std::holds_alternative<SurfaceJob::Parallel>(job_.lines) ? addParallel(corners, spans)
                                                               : addRadial(corners, spans);
    }
    return spans;
  }

 private:
  using Corners = std::array<Vec3, 3>;

  [[nodiscard]] double level(const Vec3& place) const {
    if (const auto* parallel = std::get_if<SurfaceJob::Parallel>(&job_.lines)) {
      return parallel->normal.dot(place);
    }
    return intoTurn(angleOf(std::get<SurfaceJob::Radial>(job_.lines), place) - start_);
  }
  static Vec3 normalOf(const Corners& c) { return (c[1] - c[0]).cross(c[2] - c[0]).normalized(); }

  void addParallel(const Corners& corners, std::vector<LevelSpan>& spans) const {
    const Vec3& planes = std::get<SurfaceJob::Parallel>(job_.lines).normal;
    const auto [low, high] = std::minmax({level(corners[0]), level(corners[1]), level(corners[2])});
    spans.push_back({low, high, apartOver(normalOf(corners), planes, 1.0)});
  }

  void addRadial(const Corners& corners, std::vector<LevelSpan>& spans) const {
    const auto& radial = std::get<SurfaceJob::Radial>(job_.lines);
    LevelSpan span = {0.0, 0.0, 0.0};
    double angle = 0.0;  // from the first corner on
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 arm = corners[k] - radial.place;
      const Vec3 planes = radial.axis.cross(arm);
      if (planes.norm() > tolerance::coincidence) {
        span.apart =
            std::max(span.apart, apartOver(normalOf(corners), planes.normalized(), planes.norm()));
      }
      angle +=
          std::remainder(angleOf(radial, corners[(k + 1) % 3]) - angleOf(radial, corners[k]), turn);
      span.low = std::min(span.low, angle);
      span.high = std::max(span.high, angle);
    }
    if (std::abs(angle) > turn / 2.0) {
      spans.push_back({0.0, turn, span.apart});  // the axis goes through it
      return;
    }
    const double first = level(corners[0]);
    const double shift = intoTurn(first + span.low);
    span = {shift, shift + span.high - span.low, span.apart};
    spans.push_back(span);
    if (span.high > turn) {
      spans.push_back({0.0, span.high - turn, span.apart});
    }
  }

  const SurfaceJob& job_;
  double start_ = 0.0;  // radians
  double low_ = 0.0, high_ = 0.0;
  bool closed_ = false;
};

/// Equal steps over the ground, from tip to tip or from edge to edge: the outermost sections lie a
/// little inside an edge. Those of a whole turn have no double one.
void layLevels(const Ground& ground,
               const Field& field,
               double widest,
               const Tips& tips,
               SectionPlanes& result) {
  const double halves = (tips.low ? 0.5 : 0.0) + (tips.high ? 0.5 : 0.0);
  const double length = ground.length() * (1.0 - tolerance::sectionMargin);
  const double steps = std::ceil(length / widest - halves);
  const int intervals = std::max(static_cast<int>(steps), halves > 0.5 ? 0 : 1);
  result.step = ground.length() / (intervals + halves);
  const double margin = tolerance::sectionMargin * (field.high() - field.low());
  const int last = intervals - (field.closed() ? 1 : 0);
  for (int i = 0; i <= last; ++i) {
    const double level = ground.levelAt((i + (tips.low ? 0.5 : 0.0)) * result.step);
    result.levels.push_back(field.closed()
                                ? level + margin
                                : std::clamp(level, field.low() + margin, field.high() - margin));
  }
}

/// How often planes cross the triangles of a mesh.
double crossings(const std::vector<LevelSpan>& spans, const std::vector<double>& levels) {
  double count = 0.0;
  for (const LevelSpan& span : spans) {
    count += static_cast<double>(std::lower_bound(levels.begin(), levels.end(), span.high) -
                                 std::lower_bound(levels.begin(), levels.end(), span.low));
  }
  return count;
}
}  // namespace

double SectionPlanes::apartAt(std::size_t plane, const Vec3& place, const Vec3& normal) const {
  const std::size_t n = levels.size();
  if (n < 2) {
    return step;
  }
  const CuttingPlane& own = planes[plane];
  const double unit = own.half ? own.half->dot(place - own.place) : 1.0;
  double between = 0.0;
  if (closed) {
    between = (intoTurn(levels[(plane + 1) % n] - levels[plane]) +
               intoTurn(levels[plane] - levels[(plane + n - 1) % n])) /
              2.0;
  } else {
    const std::size_t from = plane > 0 ? plane - 1 : 0;
    const std::size_t to = std::min(plane + 1, n - 1);
    between = (levels[to] - levels[from]) / static_cast<double>(to - from);
  }
  return apartOver(normal, own.normal, unit) * between;
}

Result<SectionPlanes> sectionPlanes(const SurfaceJob& job, double widest, const Tips& tips) {
  const Field field(job);
  const std::vector<LevelSpan> spans = field.spans();
  const Ground ground(spans, field.low(), field.high());
  if (auto failure = objectionToLines(ground.length() / widest, job.mostLines)) {
    return *std::move(failure);
  }
  SectionPlanes result;
  result.closed = field.closed();
  layLevels(ground, field, widest, tips, result);
  for (const double level : result.levels) {
    result.planes.push_back(field.plane(level));
  }
  if (job.mesh) {
    const double points = crossings(spans, result.levels);
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
