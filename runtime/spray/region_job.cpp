#include "runtime/spray/region_job.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "ir/diag/spray.h"
#include "ir/space/spray_tolerance.h"

namespace arelem::spray {

namespace {
constexpr double degree = std::numbers::pi / 180.0;

/// Fills in a job step by step; the first failure ends it.
class Planner {
 public:
  Planner(const RegionJob& job, const InterruptFlag* interrupted, const Progress& progress)
      : job_(job), interrupted_(interrupted), progress_(progress), profile_(job.gun.profile()) {}

  Result<RegionResult> run() {
    Sprayed& s = result_.sprayed;
    s.gun = job_.gun;
    s.film = job_.film;
    s.priced = job_.prices.has_value();
    for (const auto& step :
         {&Planner::checkValues, &Planner::layOut, &Planner::chooseOverlap, &Planner::chooseInset,
          &Planner::chooseSpeed, &Planner::chooseSize, &Planner::strokes}) {
      if (std::optional<Failure> failure = (this->*step)()) {
        return *std::move(failure);
      }
    }
    return std::move(result_);
  }

 private:
  std::optional<Failure> checkValues() {
    if (!(job_.film > 0.0) || !std::isfinite(job_.film)) {
      return fail(diag::SprayValue, "FILM", job_.film, "above 0 mm");
    }
    const Prices prices = job_.prices.value_or(Prices{});
    for (const auto& [name, price] : {std::pair{"k1 of MINCST", prices.time},
                                      {"k2 of MINCST", prices.material},
                                      {"k3 of MINCST", prices.overspray},
                                      {"k4 of MINCST", prices.sprayBy}}) {
      if (!(price >= 0.0) || !std::isfinite(price)) {
        return fail(diag::SprayValue, name, price, "at least 0");
      }
    }
    for (const auto& [name, range] : {std::pair{"HEIGHT", &job_.sizes}, {"ANGLE", &job_.angles}}) {
      if (!*range) {
        continue;
      }
      const Range& r = **range;
      if (!(r.step > 0.0) && r.to != r.from) {
        return fail(diag::SprayValue, fmt::format("the step of {}", name), r.step, "above 0");
      }
      if (!(r.to >= r.from)) {
        return fail(diag::SprayValue, fmt::format("the end of {}", name), r.to,
                    "not below its begin");
      }
      if ((r.to - r.from) / std::max(r.step, tolerance::searchStep) >
              static_cast<double>(job_.limits.trials) &&
          r.to != r.from) {
        const double steps = (r.to - r.from) / r.step;
        const bool ofSizes = range == &job_.sizes;
        return tooLarge({ofSizes ? steps : 1.0, ofSizes ? 1.0 : steps}, steps, "trials",
                        job_.limits.trials, "trials");
      }
    }
    if (job_.sizes && !(job_.sizes->from > 0.0)) {
      return fail(diag::SprayValue, "the begin of HEIGHT", job_.sizes->from, "above 0");
    }
    return std::nullopt;
  }

  std::optional<Failure> chooseOverlap() {
    double& overlap = result_.sprayed.overlap;
    if (const auto* measure = std::get_if<Measure>(&job_.overlap)) {
      overlap = optimalOverlap(profile_, *measure);
    } else {
      overlap = std::get<double>(job_.overlap);
    }
    if (!(overlap >= 0.0 && overlap < 1.0)) {
      return fail(diag::SprayValue, "the overlap", overlap, "at least 0 and below 1");
    }
    const double over = 1.0 / (1.0 - overlap);
    if (over > static_cast<double>(job_.limits.passes)) {
      return fail(diag::SprayPasses, std::ceil(over), "passes over each place", job_.limits.passes)
          .withHelp("a smaller OVRLAP needs fewer");
    }
    result_.sprayed.uniformity = spray::uniformity(profile_, overlap);
    return std::nullopt;
  }

  std::optional<Failure> chooseInset() {
    const double overlap = result_.sprayed.overlap;
    double& ratio = result_.sprayed.insetRatio;
    if (const double* length = std::get_if<double>(&job_.inset)) {
      if (!(*length >= 0.0 && *length <= job_.gun.footprint.across)) {
        return fail(
            diag::SprayValue, "INSET", *length,
            fmt::format("0 to {:.9g} mm, half the footprint's width", job_.gun.footprint.across));
      }
      ratio = *length / job_.gun.footprint.across;
    } else if (std::get<InsetRule>(job_.inset) == InsetRule::program) {
      ratio = programInset;
    } else {
      const bool byEdge = std::get<InsetRule>(job_.inset) == InsetRule::edge;
      Result<double> found =
          byEdge ? insetByEdge(profile_, overlap) : insetByMean(profile_, overlap);
      if (!found && byEdge) {
        return found.takeFailure();
      }
      ratio = found ? *found : 0.0;
      if (!found) {
        result_.warnings.push_back(
            fail(diag::SprayNoInset, overlap, spray::edgeFilm(profile_, overlap, 0.0).atEdge));
      }
    }
    result_.sprayed.edge = spray::edgeFilm(profile_, overlap, ratio);
    return std::nullopt;
  }

  /// The region in its plane, in mm.
  std::optional<Failure> layOut() {
    Sprayed& s = result_.sprayed;
    region::Region region = job_.region;
    if (job_.otherSide) {
      region.normal = -region.normal;
      for (region::Corners& loop : region.loops) {
        std::reverse(loop.begin(), loop.end());
      }
    }
    const region::Flat flat = region::flattened(region, job_.unit);
    s.origin3 = flat.frame.origin * job_.unit;
    s.x = flat.frame.x;
    s.y = flat.frame.y;
    s.normal = flat.frame.normal;
    s.outline = flat.outline;
    s.area = areaOf(s.outline);
    s.boundaries = s.outline.loops.size();
    for (const Loop& loop : s.outline.loops) {
      s.holes += areaOf({{loop}}) < 0.0 ? 1 : 0;
    }
    return std::nullopt;
  }

  /// Largest speed and flow. A calibrated gun has the flow of its setting; the speed follows.
  std::optional<Failure> chooseSpeed() {
    const Gun& gun = job_.gun;
    task_.limits = gun.limits();
    if (job_.speed) {
      task_.limits.speed = *job_.speed;
      if (!(*job_.speed > 0.0)) {
        return fail(diag::SprayValue, "SPEED", *job_.speed, "above 0 mm/s");
      }
      if (gun.speed > 0.0 && *job_.speed > gun.speed) {
        return fail(diag::SprayValue, "SPEED", *job_.speed,
                    fmt::format("at most {:.9g} mm/s, the gun's largest speed", gun.speed));
      }
    }
    const double interval = 2.0 * gun.footprint.across * (1.0 - result_.sprayed.overlap);
    if (!job_.speed && (task_.limits.speed == 0.0 || gun.kind == Gun::Kind::calibrated)) {
      if (task_.limits.flow == 0.0) {
        return fail(diag::SprayGun, "SPEED or FLOW");
      }
      const double byFlow = task_.limits.flow * task_.limits.efficiency / (job_.film * interval);
      if (gun.speed > 0.0 && byFlow > gun.speed) {
        return fail(diag::SprayValue, "the speed that the gun's flow asks for", byFlow,
                    fmt::format("at most {:.9g} mm/s, its largest: lower the valve or the pressure",
                                gun.speed));
      }
      task_.limits.speed = byFlow;
    }
    return std::nullopt;
  }

  std::optional<Failure> chooseSize() {
    Sprayed& s = result_.sprayed;
    const bool program = std::holds_alternative<InsetRule>(job_.inset) &&
                         std::get<InsetRule>(job_.inset) == InsetRule::program;
    task_.outline = s.outline;
    task_.film = job_.film;
    task_.aspect = job_.gun.aspect();
    task_.overlap = s.overlap;
    task_.insetRatio = s.insetRatio;
    task_.stop = program ? StopRule::program : StopRule::strict;
    task_.mostPasses = job_.limits.passes;
    task_.sharpest = program ? HUGE_VAL : PassRules::mitreLimit;
    s.sharpest = task_.sharpest;
    task_.shortestGap = task_.limits.speed * (job_.gun.leadOn + job_.gun.leadOff);
    task_.leadOn = job_.gun.leadOn;
    task_.prices = job_.prices.value_or(Prices{});
    const double own = job_.gun.footprint.across;
    if (job_.sizes || job_.angles) {
      const Range sizes = job_.sizes.value_or(Range{own, own, 0.0});
      const Range angles = job_.angles.value_or(Range{job_.degrees, job_.degrees, 0.0});
      const bool preferredToo = job_.sizes.has_value() && !program;
      if (auto failure = objectionToSearch(sizes, angles, preferredToo)) {
        return failure;
      }
      SearchResult found = search(task_, sizes, angles, preferredToo, interrupted_, progress_);
      if (!found.complete) {
        return fail(diag::SprayInterrupted, found.trials.size());
      }
      s.chosen = found.trials[found.best];
      s.trials = std::move(found.trials);
    } else {
      s.chosen = evaluate(task_, own, job_.degrees);
    }
    s.gun.footprint = rulesFor(task_, s.chosen.across).footprint;
    s.gun.standOff = s.chosen.across == own ? s.gun.standOff : s.gun.standOffFor(s.chosen.across);
    s.shortestTime = spray::shortestTime(s.area, job_.film, task_.limits);
    return checkFlow();
  }

  [[nodiscard]] static Failure tooLarge(const SearchSize& size,
                                        double count,
                                        std::string_view what,
                                        std::uint64_t most,
                                        std::string_view flag) {
    return fail(diag::SearchSize, size.sizes, size.angles, std::ceil(count), what, most, flag)
        .withHelp("larger steps of HEIGHT and ANGLE make fewer");
  }

  std::optional<Failure> objectionToSearch(const Range& sizes,
                                           const Range& angles,
                                           bool preferredToo) const {
    const SearchSize size = sizeOfSearch(task_, sizes, angles, preferredToo);
    if (size.trials > static_cast<double>(job_.limits.trials)) {
      return tooLarge(size, size.trials, "trials", job_.limits.trials, "trials");
    }
    if (size.passes > static_cast<double>(job_.limits.searched)) {
      return tooLarge(size, size.passes, "passes", job_.limits.searched, "searched");
    }
    return std::nullopt;
  }

  std::optional<Failure> checkFlow() {
    const Operation& operation = result_.sprayed.chosen.operation;
    if (!operation.limited) {
      return std::nullopt;
    }
    const double interval = 2.0 * result_.sprayed.chosen.across * (1.0 - result_.sprayed.overlap);
    const double wanted = job_.film * task_.limits.speed * interval / task_.limits.efficiency;
    const double largest = task_.limits.flow;
    if (job_.speed) {
      return tooMuchFlow(task_.limits.speed, wanted, largest, operation.speed);
    }
    if (job_.gun.kind != Gun::Kind::calibrated && job_.gun.speed > 0.0) {
      result_.warnings.push_back(fail(diag::SpraySlowed, task_.limits.speed,
                                      wanted / literPerMinute, largest / literPerMinute,
                                      operation.speed));
    }
    return std::nullopt;
  }

  std::optional<Failure> strokes() {
    Sprayed& s = result_.sprayed;
    const double angle = s.chosen.degrees * degree;
    const PassPlan plan = planPasses(turned(s.outline, -angle), rulesFor(task_, s.chosen.across));
    if (!plan.complete) {
      const Extent extent = extentOf(turned(s.outline, -angle));
      return fail(diag::SprayPasses,
                  std::ceil(passesFor(extent.high.y() - extent.low.y(), s.overlap, s.insetRatio,
                                      s.chosen.across)),
                  "passes", job_.limits.passes)
          .withHelp(fmt::format("a larger footprint than {:.6g} mm to each side, or a smaller "
                                "overlap, needs fewer",
                                s.chosen.across));
    }
    const Eigen::Rotation2Dd back(angle);
    const auto inSpace = [&](double x, double y) -> Vec3 {
      const Vec2 p = back * Vec2(x, y);
      return s.origin3 + p.x() * s.x + p.y() * s.y;
    };
    for (const Pass& pass : plan.passes) {
      for (std::size_t i = 1; i < pass.hits.size(); ++i) {
        Stroke& stroke = s.strokes.emplace_back();
        stroke.from = inSpace(pass.hits[i - 1], pass.height);
        stroke.to = inSpace(pass.hits[i], pass.height);
        stroke.normalFrom = stroke.normalTo = s.normal;
        stroke.painting = i % 2 == 1;
        stroke.speed = stroke.painting ? s.chosen.operation.speed : task_.limits.speed;
        stroke.newPass = i == 1;
      }
    }
    s.lines = plan.passes.size();
    s.step = plan.interval;
    return std::nullopt;
  }

  const RegionJob& job_;
  const InterruptFlag* interrupted_;
  const Progress& progress_;
  Profile profile_;
  Task task_;
  RegionResult result_;
};
}  // namespace

Result<RegionResult> sprayRegion(const RegionJob& job,
                                 const InterruptFlag* interrupted,
                                 const Progress& progress) {
  return Planner(job, interrupted, progress).run();
}

}  // namespace arelem::spray
