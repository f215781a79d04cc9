#include "runtime/spray/surface/surface_job.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ir/diag/spray.h"
#include "ir/space/tolerance.h"
#include "runtime/region/region.h"
#include "runtime/spray/surface/gap.h"
#include "runtime/spray/surface/spacing.h"

namespace arelem::spray {

namespace {
constexpr double degree = std::numbers::pi / 180.0;
constexpr int samples = 64;
constexpr double piecesOfRadius = 4.0;  // of the footprint, over which a mesh's bend is measured
constexpr double mostLines = 20'000.0;

class Planner {
 public:
  explicit Planner(const SurfaceJob& job) : job_(job) {}

  Result<Sprayed> run() {
    s_.planar = false;
    s_.gun = job_.gun;
    s_.film = job_.film;
    for (const auto& step :
         {&Planner::check, &Planner::checkRadius, &Planner::layOut, &Planner::chooseSpeed}) {
      if (std::optional<Failure> failure = (this->*step)()) {
        return *std::move(failure);
      }
    }
    strokes();
    return std::move(s_);
  }

 private:
  std::optional<Failure> check() {
    if (!(job_.film > 0.0) || !std::isfinite(job_.film)) {
      return fail(diag::SprayValue, "FILM", job_.film, "above 0 mm");
    }
    if (!(job_.chord > 0.0)) {
      return fail(diag::SprayValue, "CHORD", job_.chord, "above 0");
    }
    widest_ = job_.step > 0.0 ? job_.step : job_.gun.footprint.across;
    if (job_.step < 0.0 || widest_ > 2.0 * job_.gun.footprint.across) {
      return fail(diag::SprayValue, "STEP", job_.step,
                  fmt::format("above 0 and at most {:.6g} mm, the width of the footprint",
                              2.0 * job_.gun.footprint.across));
    }
    return std::nullopt;
  }

  /// Both directions, as the source's dialog shows them, and which one suits better.
  std::optional<Failure> checkRadius() {
    const auto* way = std::get_if<SurfaceJob::Way>(&job_.lines);
    if (job_.mesh) {
      const double piece = job_.gun.footprint.across / piecesOfRadius;
      s_.radiusAlong = job_.mesh->smallestRadius(planes(), piece);
      s_.radiusAcross = job_.mesh->smallestRadius(planesAcross(), piece);
    } else {
      const Radii radii = smallestRadii(job_.patch);
      const bool alongU = way == nullptr || *way == SurfaceJob::Way::alongU;
      s_.radiusAlong = alongU ? radii.alongU : radii.alongV;
      s_.radiusAcross = alongU ? radii.alongV : radii.alongU;
    }
    const double along = s_.radiusAlong.value_or(HUGE_VAL);
    const double across = s_.radiusAcross.value_or(HUGE_VAL);
    if (way != nullptr && along < across) {
      s_.advice = fmt::format("{} would run where the surface bends less",
                              *way == SurfaceJob::Way::alongU ? "VLINES" : "ULINES");
    } else if (job_.mesh && along < across) {
      s_.advice = "sections square to these would run where the surface bends less";
    }
    const double smallest = std::min(along, across);
    if (job_.checkRadius && smallest < job_.gun.footprint.across) {
      return fail(diag::SurfaceRadius, smallest, job_.gun.footprint.across)
          .withHelp("a smaller stand-off makes the footprint smaller; MINRAD, OFF sprays anyway");
    }
    return std::nullopt;
  }

  std::optional<Failure> layOut() {
    if (const auto* way = std::get_if<SurfaceJob::Way>(&job_.lines)) {
      const bool alongU = *way == SurfaceJob::Way::alongU;
      if (longestWay(job_.patch, !alongU) / widest_ > mostLines) {
        return fail(diag::SprayPasses, static_cast<std::size_t>(mostLines),
                    job_.gun.footprint.across);
      }
      LineSet set = linesOn(job_.patch, {alongU, widest_, job_.chord});
      lines_ = std::move(set.lines);
      s_.step = set.count.step;
    } else {
      s_.step = levelsOf().step;
      lines_ = job_.mesh ? job_.mesh->sections(planes(), job_.chord) : sectionsOfPatch();
    }
    s_.lines = lines_.size();
    s_.area = job_.mesh ? job_.mesh->area() : areaOf(job_.patch);
    if (lines_.empty()) {
      return fail(diag::SprayValue, "the number of sections", 0.0, "at least 1");
    }
    return std::nullopt;
  }

  [[nodiscard]] std::vector<SurfaceLine> sectionsOfPatch() const {
    std::vector<SurfaceLine> all;
    for (const CuttingPlane& plane : planes()) {
      const auto height = [&plane](const Vec3& p) { return plane.normal.dot(p); };
      for (const SurfaceLine& line : sectionsOf(job_.patch, height, {plane.level}, job_.chord)) {
        for (SurfaceLine& piece : onItsSide(line, plane)) {
          if (piece.size() >= 2) {
            appendToAndFro(all, std::move(piece));
          }
        }
      }
    }
    return all;
  }

  /// Range of a field over the work.
  [[nodiscard]] std::pair<double, double> rangeOf(
      const std::function<double(const Vec3&)>& field) const {
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    const auto look = [&](const Vec3& place) {
      low = std::min(low, field(place));
      high = std::max(high, field(place));
    };
    if (job_.mesh) {
      std::for_each(job_.mesh->mesh().vertices.begin(), job_.mesh->mesh().vertices.end(), look);
      return {low, high};
    }
    const Patch& p = job_.patch;
    for (int i = 0; i <= samples; ++i) {
      for (int k = 0; k <= samples; ++k) {
        look(p.at(p.u0 + (p.u1 - p.u0) * i / samples, p.v0 + (p.v1 - p.v0) * k / samples));
      }
    }
    return {low, high};
  }

  /// What the sections are levels of: the height over a plane in mm, or the angle about an axis in
  /// degrees.
  struct Levels {
    std::function<double(const Vec3&)> field;
    std::vector<double> values;
    double start = 0.0;  ///< of angles, degrees
    double step = 0.0;   ///< mm, where they are farthest apart
  };

  /// Angle about the axis of radial sections, degrees from the frame's x.
  [[nodiscard]] static double angleOf(const SurfaceJob::Radial& radial, const Vec3& place) {
    const region::Frame frame = region::frameOf(radial.axis, Vec3::Zero());
    const Vec3 arm = place - radial.place;
    return std::atan2(arm.dot(frame.y), arm.dot(frame.x)) / degree;
  }

  /// Angles between neighboring places of the work.
  [[nodiscard]] std::vector<std::pair<double, double>> arcs(
      const SurfaceJob::Radial& radial) const {
    std::vector<std::pair<double, double>> result;
    if (job_.mesh) {
      const geometry::TriangleMesh& mesh = job_.mesh->mesh();
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
          result.emplace_back(angleOf(radial, mesh.corner(t, k)),
                              angleOf(radial, mesh.corner(t, (k + 1) % 3)));
        }
      }
      return result;
    }
    const Patch& p = job_.patch;
    const auto angle = [&](int i, int k) {
      return angleOf(radial,
                     p.at(p.u0 + (p.u1 - p.u0) * i / samples, p.v0 + (p.v1 - p.v0) * k / samples));
    };
    for (int i = 0; i < samples; ++i) {
      for (int k = 0; k < samples; ++k) {
        result.emplace_back(angle(i, k), angle(i + 1, k));
        result.emplace_back(angle(i, k), angle(i, k + 1));
      }
    }
    return result;
  }

  /// Equal steps between the extremes; the outermost sections lie a hair inside. Radial sections of
  /// a whole turn have no double one; those of less begin behind the empty side.
  [[nodiscard]] Levels levelsOf() const {
    Levels levels;
    double lengthOfUnit = 1.0;
    bool wholeTurn = false;
    if (const auto* parallel = std::get_if<SurfaceJob::Parallel>(&job_.lines)) {
      levels.field = [n = parallel->normal](const Vec3& p) { return n.dot(p); };
    } else {
      const auto& radial = std::get<SurfaceJob::Radial>(job_.lines);
      const std::optional<double> gap = middleOfGap(arcs(radial));
      wholeTurn = !gap;
      levels.start = gap.value_or(0.0);
      levels.field = [radial, start = levels.start](const Vec3& p) {
        const double turn = angleOf(radial, p) - start;
        return turn - 360.0 * std::floor(turn / 360.0);
      };
      const auto arm = rangeOf(
          [&radial](const Vec3& p) { return (p - radial.place).cross(radial.axis).norm(); });
      lengthOfUnit = arm.second * degree;
    }
    const auto [low, high] = wholeTurn ? std::pair{0.0, 360.0} : rangeOf(levels.field);
    const LineCount count =
        lineCount(std::min((high - low) * lengthOfUnit, mostLines * widest_), widest_);
    const double hair = 1e-6 * (high - low);
    const int last = count.intervals - (wholeTurn ? 1 : 0);
    for (int i = 0; i <= last; ++i) {
      levels.values.push_back(low + hair + (high - low - 2.0 * hair) * i / count.intervals);
    }
    levels.step = count.step;
    return levels;
  }

  /// The sections as planes.
  [[nodiscard]] std::vector<CuttingPlane> planes() const {
    std::vector<CuttingPlane> result;
    const Levels levels = levelsOf();
    for (const double level : levels.values) {
      CuttingPlane& plane = result.emplace_back();
      if (const auto* parallel = std::get_if<SurfaceJob::Parallel>(&job_.lines)) {
        plane.normal = parallel->normal;
        plane.level = level;
        continue;
      }
      const auto& radial = std::get<SurfaceJob::Radial>(job_.lines);
      const region::Frame frame = region::frameOf(radial.axis, Vec3::Zero());
      const double angle = (levels.start + level) * degree;
      plane.half = std::cos(angle) * frame.x + std::sin(angle) * frame.y;
      plane.place = radial.place;
      plane.normal = radial.axis.cross(*plane.half);
      plane.level = plane.normal.dot(radial.place);
    }
    return result;
  }

  /// A few planes square to them, for the curvature the other way.
  [[nodiscard]] std::vector<CuttingPlane> planesAcross() const {
    constexpr int count = 9;
    Vec3 normal = Vec3::Zero();
    if (const auto* parallel = std::get_if<SurfaceJob::Parallel>(&job_.lines)) {
      normal = job_.mesh->meanNormal().cross(parallel->normal);
      normal = normal.norm() > tolerance::nullDirection
                   ? normal.normalized()
                   : region::frameOf(parallel->normal, Vec3::Zero()).x;
    } else {
      normal = std::get<SurfaceJob::Radial>(job_.lines).axis;
    }
    const auto [low, high] = job_.mesh->range(normal);
    std::vector<CuttingPlane> result;
    for (int i = 0; i < count; ++i) {
      result.push_back({normal, low + (high - low) * (i + 0.5) / count, std::nullopt, {}});
    }
    return result;
  }

  std::optional<Failure> chooseSpeed() {
    const Gun& gun = job_.gun;
    Operation& o = s_.chosen.operation;
    const double flow = gun.flow * gun.efficiency;
    if (job_.speed || gun.flow == 0.0) {
      o.speed = job_.speed.value_or(gun.speed);
      if (!(o.speed > 0.0)) {
        return fail(diag::SprayGun, "SPEED or FLOW");
      }
      o.flow = job_.film * s_.step * o.speed / gun.efficiency;
      if (gun.flow > 0.0 && o.flow > gun.flow) {
        return fail(diag::SprayFlow, o.speed, o.flow / literPerMinute, gun.flow / literPerMinute)
            .withHelp(fmt::format("SPEED, {:.6g} would give the film",
                                  speedFor(gun.flow, gun.efficiency, job_.film, s_.step)));
      }
    } else {
      o.flow = gun.flow;
      o.speed = flow / (job_.film * s_.step);
    }
    if (gun.speed > 0.0 && o.speed > gun.speed) {
      return fail(diag::SprayValue, "the speed for this film", o.speed,
                  fmt::format("at most {:.9g} mm/s, the gun's largest", gun.speed));
    }
    return std::nullopt;
  }

  /// Where lines of u or v lie closer the gun moves faster: a film like elsewhere, but for what its
  /// largest speed forbids. Not with SPEED.
  [[nodiscard]] bool speedFollowsSpacing() const {
    return std::holds_alternative<SurfaceJob::Way>(job_.lines) && !job_.speed &&
           job_.gun.flow > 0.0 && lines_.size() > 1;
  }

  void strokes() {
    Trial& chosen = s_.chosen;
    chosen.across = job_.gun.footprint.across;
    chosen.passes = lines_.size();
    const bool follows = speedFollowsSpacing();
    const Spacing spacing(follows ? lines_ : none_);
    const double fastest = job_.gun.speed > 0.0 ? job_.gun.speed : HUGE_VAL;
    double seconds = 0.0;
    for (std::size_t n = 0; n < lines_.size(); ++n) {
      const SurfaceLine& line = lines_[n];
      if (n > 0) {
        chosen.lengths.unpainted += (line.front().place - lines_[n - 1].back().place).norm();
      }
      bool begins = true;
      for (std::size_t i = 1; i < line.size(); ++i) {
        const SurfaceLine pieces =
            follows ? divided(spacing, n, line[i - 1], line[i]) : SurfaceLine{line[i - 1], line[i]};
        for (std::size_t k = 1; k < pieces.size(); ++k) {
          const LinePoint& a = pieces[k - 1];
          const LinePoint& b = pieces[k];
          const double length = (b.place - a.place).norm();
          if (length == 0.0) {
            continue;
          }
          const double share = follows ? spacing.share(n, (a.place + b.place) / 2.0) : 1.0;
          const double speed = std::min(chosen.operation.speed / share, fastest);
          s_.strokes.push_back({a.place, b.place, a.normal, b.normal, speed, true, begins});
          begins = false;
          chosen.lengths.painted += length;
          seconds += length / speed;
        }
      }
    }
    s_.overlap = 1.0 - s_.step / (2.0 * job_.gun.footprint.across);
    s_.uniformity = uniformity(job_.gun.profile(), s_.overlap);
    const GunLimits limits = {chosen.operation.speed, job_.gun.flow, job_.gun.efficiency};
    Operation mean = chosen.operation;
    mean.speed = seconds > 0.0 ? chosen.lengths.painted / seconds : mean.speed;
    chosen.cost = costOf(chosen.lengths, s_.area, job_.film, mean, limits, {});
    s_.shortestTime = spray::shortestTime(s_.area, job_.film, limits);
    s_.mesh = job_.mesh;
    s_.patch = job_.mesh ? nullptr : std::make_shared<const Patch>(job_.patch);
  }

  const SurfaceJob& job_;
  Sprayed s_;
  double widest_ = 0.0;
  std::vector<SurfaceLine> lines_;
  const std::vector<SurfaceLine> none_;
};
}  // namespace

Result<Sprayed> spraySurface(const SurfaceJob& job) {
  return Planner(job).run();
}

}  // namespace arelem::spray
