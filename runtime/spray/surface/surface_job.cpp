#include "runtime/spray/surface/surface_job.h"

#include <algorithm>
#include <cmath>

#include "ir/diag/spray.h"
#include "ir/space/spray_tolerance.h"
#include "ir/space/tolerance.h"
#include "runtime/spray/surface/laid_lines.h"
#include "runtime/spray/surface/radii.h"
#include "runtime/spray/surface/section_planes.h"
#include "runtime/spray/surface/spacing.h"
#include "runtime/spray/surface/traverses.h"
#include "runtime/spray/surface/walls.h"

namespace arelem::spray {

namespace {
constexpr double alike = 0.999;         // radii that are measured to less are the same
constexpr double alikeOfMesh = 0.95;    // triangles blur them
constexpr double piecesOfRadius = 4.0;  // of the footprint, over which a mesh's bend is measured
constexpr double asFast = 1e-6;         // the rounding of normals makes no nozzle faster
constexpr double bentMost = 0.95;       // of the way: at its sharpest bends the gun slows down

/// The planes of SECTN, or those of RADIAL through the axis and a place.
PlaneNormal planesOf(const SurfaceJob& job) {
  if (const auto* radial = std::get_if<SurfaceJob::Radial>(&job.lines)) {
    return [r = *radial](const Vec3& place) -> Vec3 {
      const Vec3 square = r.axis.cross(place - r.place);
      return square.norm() > tolerance::coincidence ? Vec3(square.normalized())
                                                    : Vec3(Vec3::Zero());
    };
  }
  return
      [normal = std::get<SurfaceJob::Parallel>(job.lines).normal](const Vec3&) { return normal; };
}

class Planner {
 public:
  explicit Planner(const SurfaceJob& job) : job_(job) {}

  Result<Sprayed> run() {
    s_.planar = false;
    s_.gun = job_.gun;
    s_.film = job_.film;
    for (const auto& step : {&Planner::check, &Planner::checkRadius, &Planner::checkHollow,
                             &Planner::layOut, &Planner::chooseSpeed, &Planner::strokes}) {
      if (std::optional<Failure> failure = (this->*step)()) {
        return *std::move(failure);
      }
    }
    return std::move(s_);
  }

 private:
  std::optional<Failure> check() {
    if (!(job_.film > 0.0) || !std::isfinite(job_.film)) {
      return fail(diag::SprayValue, "FILM", job_.film, "above 0 mm");
    }
    if (!(job_.chord >= tolerance::coincidence)) {
      return fail(diag::SprayValue, "CHORD", job_.chord,
                  fmt::format("at least {:.6g} mm", tolerance::coincidence));
    }
    widest_ = job_.step > 0.0 ? job_.step : job_.gun.footprint.across;
    const double farthest = 4.0 * std::max(job_.gun.footprint.along, job_.gun.footprint.across);
    if (!(job_.past >= 0.0 && job_.past <= farthest)) {
      return fail(diag::SprayValue, "PAST", job_.past,
                  fmt::format("0 to {:.6g} mm, two footprints", farthest));
    }
    if (!(job_.clearance() >= 0.0 && job_.clearance() <= tolerance::farthestCorner)) {
      return fail(diag::SprayValue, "CLEARP", job_.clearance(), "at least 0 mm");
    }
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
      const Result<SectionPlanes> sections = sectionPlanes(job_, widest_);
      if (!sections) {
        return sections.failure();
      }
      s_.radiusAlong = job_.mesh->smallestRadius(sections->planes, piece);
      s_.radiusAcross = job_.mesh->smallestRadius(planesAcross(job_), piece);
      hollow_ = std::min(job_.mesh->smallestHollow(sections->planes, piece).value_or(HUGE_VAL),
                         job_.mesh->smallestHollow(planesAcross(job_), piece).value_or(HUGE_VAL));
    } else {
      const Radii radii =
          way != nullptr ? smallestRadii(job_.patch) : smallestRadii(job_.patch, planesOf(job_));
      hollow_ = radii.hollow.value_or(HUGE_VAL);
      const bool swap = way != nullptr && *way == SurfaceJob::Way::alongV;
      s_.radiusAlong = swap ? radii.across : radii.along;
      s_.radiusAcross = swap ? radii.along : radii.across;
    }
    const double along = s_.radiusAlong.value_or(HUGE_VAL);
    const double across = s_.radiusAcross.value_or(HUGE_VAL);
    if (along < (job_.mesh ? alikeOfMesh : alike) * across) {
      s_.advice = fmt::format("{} would run where the surface bends less", otherLines());
    }
    const double smallest = std::min(along, across);
    if (job_.checkRadius && smallest < job_.gun.footprint.across) {
      return fail(diag::SurfaceRadius, smallest, job_.gun.footprint.across)
          .withHelp("a smaller stand-off makes the footprint smaller; MINRAD, OFF sprays anyway");
    }
    return std::nullopt;
  }

  /// Those that run across the lines of the job.
  [[nodiscard]] std::string_view otherLines() const {
    if (const auto* way = std::get_if<SurfaceJob::Way>(&job_.lines)) {
      return *way == SurfaceJob::Way::alongU ? "VLINES" : "ULINES";
    }
    return std::holds_alternative<SurfaceJob::Radial>(job_.lines) ? "sections square to the axis"
                                                                  : "sections square to these";
  }

  /// In a hollow the nozzle must not reach the middle: behind it the other wall is near, and the
  /// nozzle goes against its spray.
  std::optional<Failure> checkHollow() {
    if (job_.checkRadius && job_.gun.standOff >= hollow_) {
      return fail(diag::SurfaceHollow, job_.gun.standOff, hollow_)
          .withHelp("a smaller stand-off, or REVERS for the other side; MINRAD, OFF sprays anyway");
    }
    return std::nullopt;
  }

  std::optional<Failure> layOut() {
    const bool mayMeet =
        job_.gun.standOff > 0.0 && job_.checkRadius && (job_.mesh || std::isfinite(hollow_));
    if (mayMeet || job_.clearance() > 0.0) {
      walls_ = job_.mesh ? Walls((job_.wholeMesh ? job_.wholeMesh : job_.mesh)->mesh())
                         : Walls::of(job_.wholePatch.value_or(job_.patch));
    }
    Result<LaidLines> laid = layLines(job_, widest_, mayMeet ? &*walls_ : nullptr);
    if (!laid) {
      return laid.takeFailure();
    }
    laid_ = *std::move(laid);
    s_.step = laid_.step;
    s_.lines = laid_.lines.size();
    s_.leftOut = laid_.leftOut;
    s_.shortest = laid_.shortest;
    s_.past = job_.past;
    s_.area = job_.mesh ? job_.mesh->area() : areaOf(job_.patch);
    if (laid_.lines.empty()) {
      return fail(diag::SprayValue, "the number of sections", 0.0, "at least 1");
    }
    if (speedFollowsSpacing()) {
      spacing_ = laid_.sections.planes.empty()
                     ? std::unique_ptr<Spacing>(new LineSpacing(laid_.whole, laid_.step))
                     : std::unique_ptr<Spacing>(new SectionSpacing(laid_.sections));
    }
    return mayMeet ? objectionToWalls(laid_.lines, job_.gun.standOff, *walls_) : std::nullopt;
  }

  /// How much faster the nozzle goes than its spray, 1 where it goes slower.
  [[nodiscard]] double ahead(const LinePoint& a, const LinePoint& b) const {
    const double d = job_.gun.standOff;
    const double length = (b.place - a.place).norm();
    const double way = (b.place + d * b.normal - a.place - d * a.normal).norm();
    return length > 0.0 && way / length > 1.0 + asFast ? way / length : 1.0;
  }

  /// The same for nearly all of the way.
  [[nodiscard]] double aheadMostly() const {
    std::vector<std::pair<double, double>> pieces;  // how much, and length
    double all = 0.0;
    for (const SurfaceLine& line : laid_.lines) {
      for (std::size_t i = 1; i < line.size(); ++i) {
        pieces.emplace_back(ahead(line[i - 1], line[i]),
                            (line[i].place - line[i - 1].place).norm());
        all += pieces.back().second;
      }
    }
    std::sort(pieces.begin(), pieces.end());
    double sum = 0.0;
    for (const auto& [share, length] : pieces) {
      sum += length;
      if (sum >= bentMost * all) {
        return share;
      }
    }
    return 1.0;
  }

  /// The smallest share of the spacing on the lines, where the speed follows it: else 1.
  [[nodiscard]] double narrowest() const {
    double least = 1.0;
    if (spacing_) {
      for (std::size_t n = 0; n < laid_.lines.size(); ++n) {
        for (const LinePoint& point : laid_.lines[n]) {
          least = std::min(least, spacing_->share(laid_.ranks[n], point));
        }
      }
    }
    return least;
  }

  /// The gun's largest speed is that of the nozzle, which is ahead of its spray on a bent surface.
  std::optional<Failure> chooseSpeed() {
    const Gun& gun = job_.gun;
    const double fastest = gun.speed / aheadMostly();
    Operation& o = s_.chosen.operation;
    const double flow = gun.flow * gun.efficiency;
    if (job_.speed || gun.flow == 0.0) {
      o.speed = job_.speed.value_or(fastest * narrowest());
      if (!(o.speed > 0.0)) {
        return fail(diag::SprayGun, "SPEED or FLOW");
      }
      o.flow = job_.film * s_.step * o.speed / gun.efficiency;
      if (gun.flow > 0.0 && o.flow > gun.flow) {
        return tooMuchFlow(o.speed, o.flow, gun.flow,
                           speedFor(gun.flow, gun.efficiency, job_.film, s_.step));
      }
    } else {
      o.flow = gun.flow;
      o.speed = flow / (job_.film * s_.step);
      if (gun.kind != Gun::Kind::calibrated && gun.speed > 0.0 && o.speed > fastest * narrowest()) {
        o.speed = fastest * narrowest();  // with less flow; room to follow the spacing
        o.flow = job_.film * s_.step * o.speed / gun.efficiency;
      }
    }
    if (gun.speed > 0.0 && o.speed > fastest) {
      return fail(
          diag::SprayValue, job_.speed ? "SPEED" : "the speed that the gun's flow asks for",
          o.speed,
          fmt::format("at most {:.9g} mm/s, at which the nozzle goes {:.9g}, its largest{}",
                      fastest, gun.speed, job_.speed ? "" : ": lower the valve or the pressure"));
    }
    return std::nullopt;
  }

  /// Where lines lie closer the gun moves faster: a film like elsewhere, but for what its
  /// largest speed forbids. Not with SPEED.
  [[nodiscard]] bool speedFollowsSpacing() const {
    return !job_.speed && std::max(laid_.whole.size(), laid_.sections.planes.size()) > 1;
  }

  std::optional<Failure> strokes() {
    Trial& chosen = s_.chosen;
    chosen.across = job_.gun.footprint.across;
    chosen.passes = laid_.lines.size();
    double seconds = 0.0;
    for (std::size_t n = 0; n < laid_.lines.size(); ++n) {
      const SurfaceLine& line = laid_.lines[n];
      bool begins = true;
      for (std::size_t i = 1; i < line.size(); ++i) {
        const SurfaceLine pieces = spacing_
                                       ? divided(*spacing_, laid_.ranks[n], line[i - 1], line[i])
                                       : SurfaceLine{line[i - 1], line[i]};
        for (std::size_t k = 1; k < pieces.size(); ++k) {
          const LinePoint& a = pieces[k - 1];
          const LinePoint& b = pieces[k];
          const double length = (b.place - a.place).norm();
          if (length == 0.0) {
            continue;
          }
          const double share = spacing_ ? spacing_->share(laid_.ranks[n], middleOf(a, b)) : 1.0;
          const double fastest = job_.gun.speed > 0.0 ? job_.gun.speed / ahead(a, b) : HUGE_VAL;
          const double speed = std::min(chosen.operation.speed / share, fastest);
          s_.strokes.push_back(
              {a.place, b.place, a.normal, b.normal, speed, true, begins, a.uv, b.uv});
          begins = false;
          chosen.lengths.painted += length;
          seconds += length / speed;
        }
      }
    }
    for (const Stroke& stroke : s_.strokes) {
      if (stroke.newPass) {
        chosen.lengths.runUp += s_.nozzleSpeed(stroke) * job_.gun.leadOn;
        chosen.lengths.runUpTime += job_.gun.leadOn;
      }
    }
    chosen.lengths.unpainted += chosen.lengths.runUp;
    if (auto failure = goRound(s_, job_, walls_ ? &*walls_ : nullptr)) {
      return failure;
    }
    s_.overlap = 1.0 - s_.step / (2.0 * job_.gun.footprint.across);
    s_.uniformity = uniformity(job_.gun.profile(), s_.overlap);
    // Between lines nothing holds the gun back.
    const GunLimits limits = {std::max(job_.gun.speed, chosen.operation.speed), job_.gun.flow,
                              job_.gun.efficiency};
    Operation mean = chosen.operation;
    mean.speed = seconds > 0.0 ? chosen.lengths.painted / seconds : mean.speed;
    chosen.cost = costOf(chosen.lengths, s_.area, job_.film, mean, limits, {});
    s_.shortestTime = spray::shortestTime(s_.area, job_.film, limits);
    s_.mesh = job_.mesh;
    s_.patch = job_.mesh ? nullptr : std::make_shared<const Patch>(job_.patch);
    return std::nullopt;
  }

  const SurfaceJob& job_;
  Sprayed s_;
  double widest_ = 0.0;
  double hollow_ = HUGE_VAL;  // smallest radius where the surface bends towards the gun
  LaidLines laid_;
  std::optional<Walls> walls_;
  std::unique_ptr<Spacing> spacing_;  // where the speed follows it
};
}  // namespace

std::optional<Failure> objectionToLines(double lines, std::uint64_t most) {
  if (lines <= static_cast<double>(most)) {
    return std::nullopt;
  }
  return fail(diag::SprayPasses, std::ceil(lines), "lines", most)
      .withHelp("a larger STEP or footprint needs fewer");
}

Result<Sprayed> spraySurface(const SurfaceJob& job) {
  return Planner(job).run();
}

}  // namespace arelem::spray
