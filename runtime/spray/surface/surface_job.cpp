#include "runtime/spray/surface/surface_job.h"

#include <cmath>
#include <numbers>

#include "ir/diag/spray.h"
#include "runtime/region/region.h"

namespace arelem::spray {

namespace {
constexpr double degree = std::numbers::pi / 180.0;
constexpr int samples = 64;
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
    const Radii radii = smallestRadii(job_.patch);
    const bool alongU = !std::holds_alternative<SurfaceJob::Way>(job_.lines) ||
                        std::get<SurfaceJob::Way>(job_.lines) == SurfaceJob::Way::alongU;
    s_.radiusAlong = alongU ? radii.alongU : radii.alongV;
    s_.radiusAcross = alongU ? radii.alongV : radii.alongU;
    const double along = s_.radiusAlong.value_or(HUGE_VAL);
    const double across = s_.radiusAcross.value_or(HUGE_VAL);
    if (std::holds_alternative<SurfaceJob::Way>(job_.lines) && along < across) {
      s_.advice =
          fmt::format("{} would run where the surface bends less", alongU ? "VLINES" : "ULINES");
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
      sections();
    }
    s_.lines = lines_.size();
    s_.area = areaOf(job_.patch);
    if (lines_.empty()) {
      return fail(diag::SprayValue, "the number of sections", 0.0, "at least 1");
    }
    return std::nullopt;
  }

  /// Range of a field over the patch.
  [[nodiscard]] std::pair<double, double> rangeOf(
      const std::function<double(const Vec3&)>& field) const {
    const Patch& p = job_.patch;
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (int i = 0; i <= samples; ++i) {
      for (int k = 0; k <= samples; ++k) {
        const double value =
            field(p.at(p.u0 + (p.u1 - p.u0) * i / samples, p.v0 + (p.v1 - p.v0) * k / samples));
        low = std::min(low, value);
        high = std::max(high, value);
      }
    }
    return {low, high};
  }

  /// Equal steps between the extremes; the outermost sections lie a hair inside.
  void sections() {
    std::function<double(const Vec3&)> field;
    double lengthOfUnit = 1.0;
    if (const auto* parallel = std::get_if<SurfaceJob::Parallel>(&job_.lines)) {
      field = [n = parallel->normal](const Vec3& p) { return n.dot(p); };
    } else {
      const auto& radial = std::get<SurfaceJob::Radial>(job_.lines);
      const region::Frame frame = region::frameOf(radial.axis, Vec3::Zero());
      field = [frame, place = radial.place](const Vec3& p) {
        const Vec3 arm = p - place;
        const double angle = std::atan2(arm.dot(frame.y), arm.dot(frame.x)) / degree;
        return angle < -1e-9 ? angle + 360.0 : angle;
      };
      const auto arm = rangeOf(
          [&radial](const Vec3& p) { return (p - radial.place).cross(radial.axis).norm(); });
      lengthOfUnit = arm.second * degree;
    }
    const auto [low, high] = rangeOf(field);
    const LineCount count = lineCount((high - low) * lengthOfUnit, widest_);
    const double hair = 1e-6 * (high - low);
    std::vector<double> levels;
    for (int i = 0; i <= count.intervals; ++i) {
      levels.push_back(low + hair + (high - low - 2.0 * hair) * i / count.intervals);
    }
    lines_ = sectionsOf(job_.patch, field, levels, job_.chord);
    s_.step = count.step;
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

  void strokes() {
    Trial& chosen = s_.chosen;
    chosen.across = job_.gun.footprint.across;
    chosen.passes = lines_.size();
    const LinePoint* before = nullptr;
    for (const SurfaceLine& line : lines_) {
      for (std::size_t i = 1; i < line.size(); ++i) {
        const LinePoint& a = line[i - 1];
        const LinePoint& b = line[i];
        const double length = (b.place - a.place).norm();
        if (length == 0.0) {
          continue;
        }
        if (i == 1 && before != nullptr) {
          chosen.lengths.unpainted += (a.place - before->place).norm();
        }
        s_.strokes.push_back(
            {a.place, b.place, a.normal, b.normal, chosen.operation.speed, true, i == 1});
        chosen.lengths.painted += length;
      }
      before = &line.back();
    }
    s_.overlap = 1.0 - s_.step / (2.0 * job_.gun.footprint.across);
    s_.uniformity = uniformity(job_.gun.profile(), s_.overlap);
    const GunLimits limits = {chosen.operation.speed, job_.gun.flow, job_.gun.efficiency};
    chosen.cost = costOf(chosen.lengths, s_.area, job_.film, chosen.operation, limits, {});
    s_.shortestTime = spray::shortestTime(s_.area, job_.film, limits);
    s_.patch = std::make_shared<const Patch>(job_.patch);
  }

  const SurfaceJob& job_;
  Sprayed s_;
  double widest_ = 0.0;
  std::vector<SurfaceLine> lines_;
};
}  // namespace

Result<Sprayed> spraySurface(const SurfaceJob& job) {
  return Planner(job).run();
}

}  // namespace arelem::spray
