#include "app/spray_report.h"

#include <algorithm>
#include <numbers>

#include "app/film_file.h"
#include "runtime/film/surface_map.h"
#include "runtime/spray/offset_curve.h"

namespace arelem::app {

namespace {
constexpr double liter = 1.0 / spray::cubicMillimetersPerLiter;

std::array<double, 3> three(const spray::Uniformity& u) {
  return {u.average, u.rms, u.largest};
}

backend::ReportedSpray::Trial trialOf(const spray::Trial& t) {
  return {t.across,
          t.degrees,
          t.preferred,
          t.passes,
          t.lengths.painted,
          t.lengths.unpainted,
          t.cost.paintingTime,
          t.cost.travelingTime,
          t.operation.speed,
          t.operation.flow / spray::literPerMinute,
          {t.cost.total, t.cost.parts}};
}

backend::ReportedSpray::Simulated simulatedOf(const film::Map& map) {
  const film::Statistics& s = map.statistics;
  return {map.cell,        s.mean,     s.smallest,          s.largest,
          three(s.spread), s.within10, s.deposited * liter, s.outside * liter};
}

void addPath(backend::ReportedSpray& report, const spray::Sprayed& s) {
  const spray::Trial& chosen = s.chosen;
  report.passes = chosen.passes;
  report.interval = s.step;
  report.painted = chosen.lengths.painted;
  report.unpainted = chosen.lengths.unpainted;
  report.paintingTime = chosen.cost.paintingTime;
  report.travelTime = chosen.cost.travelingTime;
  report.speed = chosen.operation.speed;
  report.flow = chosen.operation.flow / spray::literPerMinute;
  report.used = chosen.cost.used * liter;
  report.deposited = chosen.cost.deposited * liter;
  report.overspray = chosen.cost.overspray * liter;
  report.sprayBy = chosen.cost.sprayBy * liter;
  report.missing = chosen.cost.missing * liter;
  if (s.priced) {
    report.cost = {chosen.cost.total, chosen.cost.parts};
    for (const spray::Trial& trial : s.trials) {
      report.trials.push_back(trialOf(trial));
    }
  }
}
std::vector<backend::FilmPicture::Line> linesOf(const spray::Outline& outline) {
  std::vector<backend::FilmPicture::Line> lines;
  for (const spray::Loop& loop : outline.loops) {
    auto& line = lines.emplace_back();
    for (const spray::Vec2& p : loop) {
      line.emplace_back(p.x(), p.y());
    }
  }
  return lines;
}

/// Where the gun is switched, in the plane of the region: the ellipse lies along the passes.
spray::Outline offsetOf(const spray::Sprayed& s) {
  const double angle = s.chosen.degrees * std::numbers::pi / 180.0;
  return turned(offsetCurve(turned(s.outline, -angle), s.gun.footprint, s.sharpest), angle);
}
}  // namespace

backend::ReportedSpray reported(const Compilation& job,
                                const spray::Sprayed& s,
                                const film::Map* map) {
  backend::ReportedSpray report;
  report.place = {std::string(job.sources.name(s.origin.buffer)),
                  job.sources.locate(s.origin.buffer, s.origin.begin).line};
  report.isn = s.isn;
  report.work = s.work;
  report.planar = s.planar;
  report.boundaries = s.boundaries;
  report.holes = s.holes;
  report.area = s.area;
  report.film = s.film;
  report.along = s.gun.footprint.along;
  report.across = s.gun.footprint.across;
  report.standOff = s.gun.standOff;
  report.overlap = s.overlap;
  report.inset = s.insetRatio * s.gun.footprint.across;
  report.degrees = s.chosen.degrees;
  report.shortestTime = s.shortestTime;
  report.uniformity = three(s.uniformity);
  report.edgeFilm = s.edge.atEdge;
  report.edgeMean = s.edge.mean;
  report.radiusAlong = s.radiusAlong;
  report.past = s.past;
  report.traverses = s.traverses;
  report.waysRound = static_cast<std::size_t>(
      std::count_if(s.ways.begin(), s.ways.end(), [](const auto& w) { return w.stroke > 0; }));
  report.clearance = s.clearance;
  report.radiusAcross = s.radiusAcross;
  report.advice = s.advice;
  addPath(report, s);
  if (map != nullptr) {
    report.simulated = simulatedOf(*map);
  }
  return report;
}

backend::FilmPicture pictureOf(const spray::Sprayed& s, const film::Map& map) {
  backend::FilmPicture picture = pictureOf(map, s.film);
  picture.areas = map.areas.empty() ? nullptr : &map.areas;
  const film::Statistics& f = map.statistics;
  picture.title =
      fmt::format("{}: film of {:.4g} um", s.work.empty() ? "SPRAY" : s.work, 1e3 * s.film);
  picture.details = fmt::format(
      "simulated: mean {:.4g}, {:.4g} to {:.4g} um; {:.1f} % of the work within 10 %; R1 {:.3f}, "
      "R2 {:.3f}, "
      "R3 {:.3f}",
      1e3 * f.mean, 1e3 * f.smallest, 1e3 * f.largest, 100.0 * f.within10, f.spread.average,
      f.spread.rms, f.spread.largest);
  if (!s.planar) {
    picture.xName = s.mesh ? "across the mean normal, mm" : "along u where longest, mm";
    picture.yName = s.mesh ? "up, mm" : "along v where longest, mm";
  }
  const auto place = [&](const Vec3& p, const spray::Vec2& uv) -> spray::Vec2 {
    return s.planar ? spray::Vec2((p - s.origin3).dot(s.x), (p - s.origin3).dot(s.y))
                    : film::placeInMap(s, map, p, uv);
  };
  for (const spray::Stroke& stroke : s.strokes) {
    const spray::Vec2 from = place(stroke.from, stroke.uvFrom);
    const spray::Vec2 to = place(stroke.to, stroke.uvTo);
    picture.path.push_back({from.x(), from.y(), to.x(), to.y(), stroke.painting});
  }
  if (!s.planar) {
    return picture;
  }
  picture.outlines = linesOf(s.outline);
  picture.offsets = linesOf(offsetOf(s));
  return picture;
}

}  // namespace arelem::app
