#include "app/spray_report.h"

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
  if (s.priced) {
    report.cost = {chosen.cost.total, chosen.cost.parts};
    for (const spray::Trial& trial : s.trials) {
      report.trials.push_back(trialOf(trial));
    }
  }
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
  report.radiusAcross = s.radiusAcross;
  report.advice = s.advice;
  addPath(report, s);
  if (map != nullptr) {
    report.simulated = simulatedOf(*map);
  }
  return report;
}

backend::FilmPicture pictureOf(const spray::Sprayed& s, const film::Map& map) {
  backend::FilmPicture picture;
  picture.lowX = map.low.x();
  picture.lowY = map.low.y();
  picture.cell = map.cell;
  picture.columns = map.columns;
  picture.rows = map.rows;
  picture.film = &map.film;
  picture.onWork = &map.onWork;
  picture.wanted = s.film;
  picture.title =
      fmt::format("{}: {:.4g} um wanted, {:.4g} on average, {:.4g} to {:.4g}",
                  s.work.empty() ? "SPRAY" : s.work, 1e3 * s.film, 1e3 * map.statistics.mean,
                  1e3 * map.statistics.smallest, 1e3 * map.statistics.largest);
  const auto place = [&s](const Vec3& p) {
    return std::pair{(p - s.origin3).dot(s.x), (p - s.origin3).dot(s.y)};
  };
  for (const spray::Stroke& stroke : s.strokes) {
    if (!s.planar) {
      break;  // the picture is over the parameters of the surface
    }
    const auto [x1, y1] = place(stroke.from);
    const auto [x2, y2] = place(stroke.to);
    picture.path.push_back({x1, y1, x2, y2, stroke.painting});
  }
  for (const spray::Loop& loop : s.outline.loops) {
    auto& outline = picture.outlines.emplace_back();
    for (const spray::Vec2& p : loop) {
      outline.emplace_back(p.x(), p.y());
    }
  }
  return picture;
}

}  // namespace arelem::app
