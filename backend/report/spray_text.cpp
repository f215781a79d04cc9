#include <ostream>

#include <fmt/format.h>

#include "backend/report/spray.h"

namespace arelem::backend {

namespace {
constexpr double micrometers = 1e3;
constexpr double shareOfRounding = 1e-3;  // of the paint: lengths of lines on curved work

std::string head(const ReportedSpray& s) {
  const std::string what =
      s.planar ? fmt::format("region of {} {}{}", s.boundaries,
                             s.boundaries == 1 ? "boundary" : "boundaries",
                             s.holes == 0 ? "" : fmt::format(", {} of them holes", s.holes))
               : "surface";
  return fmt::format("{}:{}: SPRAY/ {} ({})", s.place.file, s.place.line,
                     s.work.empty() ? "..." : s.work, what);
}

void row(std::ostream& out, std::string_view name, const std::string& text) {
  out << fmt::format("  {:<12}{}\n", name, text);
}

void costRow(std::ostream& out, const ReportedSpray& s) {
  if (s.cost) {
    const auto& p = s.cost->parts;
    row(out, "cost",
        fmt::format("${:.4f}: painting time {:.4f}, other time {:.4f}, overspray {:.4f}, "
                    "spray-by {:.4f}, film {:.4f}",
                    s.cost->total, p[0], p[1], p[2], p[3], p[4]));
  }
}

void filmRow(std::ostream& out, const ReportedSpray& s) {
  if (s.simulated) {
    const ReportedSpray::Simulated& f = *s.simulated;
    row(out, "simulated",
        fmt::format("film {:.4g} um on average, {:.4g} to {:.4g}; {:.1f} % of the area within "
                    "10 % of {:.4g}; R1 {:.4f}, R2 {:.4f}, R3 {:.4f}",
                    micrometers * f.mean, micrometers * f.smallest, micrometers * f.largest,
                    100.0 * f.within10, micrometers * s.film, f.uniformity[0], f.uniformity[1],
                    f.uniformity[2]));
  }
}

/// A line of the table; `mark`: * the least cost, + a preferred size. Without prices the costs are
/// dashes.
void trialRow(std::ostream& out, const ReportedSpray::Trial& t, char mark, bool priced) {
  out << fmt::format("{}{:8.3f} {:7.2f} {:6} {:8.1f} {:8.1f} {:7.2f} {:7.2f} {:7.1f} {:7.4f}", mark,
                     t.across, t.degrees, t.passes, t.painted, t.unpainted, t.paintingTime,
                     t.travelTime, t.speed, t.flow);
  if (priced) {
    const auto& p = t.cost.parts;
    out << fmt::format(" {:9.4f} {:7.4f} {:7.4f} {:7.4f} {:7.4f} {:7.4f}{}\n", t.cost.total, p[0],
                       p[1], p[2], p[3], p[4], mark == '*' ? "  least" : "");
  } else {
    out << fmt::format(" {:>9} {:>7} {:>7} {:>7} {:>7} {:>7}\n", "-", "-", "-", "-", "-", "-");
  }
}

/// The one row of a statement that searches nothing.
ReportedSpray::Trial chosenOf(const ReportedSpray& s) {
  return {s.across,
          s.degrees,
          false,
          s.passes,
          s.painted,
          s.unpainted,
          s.paintingTime,
          s.travelTime,
          s.speed,
          s.flow,
          s.cost.value_or(ReportedSpray::Cost{})};
}
}  // namespace

void writeSprayText(std::ostream& out, const ReportedSpray& s) {
  out << head(s) << '\n';
  row(out, "work", fmt::format("{:.8g} mm2, film {:.4g} um", s.area, micrometers * s.film));
  row(out, "gun",
      fmt::format("footprint {:.5g} along, {:.5g} across (half axes), {:.5g} from the work (mm); "
                  "{:.5g} mm/s, {:.4g} l/min",
                  s.along, s.across, s.standOff, s.speed, s.flow));
  row(out, "passes",
      s.planar
          ? fmt::format("{}, {:.5g} mm apart, at {:.5g} degrees; overlap {:.5g}, inset {:.5g} mm",
                        s.passes, s.interval, s.degrees, s.overlap, s.inset)
          : fmt::format("{}, {:.5g} mm apart; overlap {:.5g}; {}", s.passes, s.interval, s.overlap,
                        s.past > 0.0
                            ? fmt::format("{:.5g} mm past the edges", s.past)
                            : std::string("as far as its edges, if any, which get less film: "
                                          "PAST, d goes beyond")));
  row(out, "path",
      fmt::format(
          "{:.7g} mm painted in {:.5g} s, {:.6g} mm besides in {:.4g} s{}{}", s.painted,
          s.paintingTime, s.unpainted, s.travelTime,
          s.waysRound > 0 ? fmt::format("; {} of {} traverses go round the work, {:.4g} mm off it",
                                        s.waysRound, s.traverses, s.clearance)
                          : "",
          s.shortestTime > 0.0 ? fmt::format("; painting takes {:.4g} s at least", s.shortestTime)
                               : ""));
  row(out, "paint",
      fmt::format("{:.4g} l used: {:.4g} on the work, {:.4g} overspray, {:.4g} beside the work{}",
                  s.used, s.deposited, s.overspray, s.sprayBy,
                  s.missing > shareOfRounding * s.used
                      ? fmt::format("; {:.4g} less than the film on all the work takes", s.missing)
                      : ""));
  row(out, "uniformity",
      fmt::format(
          "between passes R1 {:.5f}, R2 {:.5f}, R3 {:.5f}{}", s.uniformity[0], s.uniformity[1],
          s.uniformity[2],
          s.planar ? fmt::format("; the edge gets {:.3f} of the film, the strip inside it {:.3f}",
                                 s.edgeFilm, s.edgeMean)
                   : ""));
  costRow(out, s);
  filmRow(out, s);
  if (s.radiusAlong || s.radiusAcross) {
    const auto radius = [](const std::optional<double>& r) {
      return r ? fmt::format("{:.5g} mm", *r) : std::string("flat");
    };
    row(out, "curvature",
        fmt::format("smallest radius {} along the lines, {} across{}", radius(s.radiusAlong),
                    radius(s.radiusAcross), s.advice.empty() ? "" : "; " + s.advice));
  }
}

void writeSprayTable(std::ostream& out, const ReportedSpray& s) {
  out << head(s) << '\n'
      << "       b   angle passes       Xi       Xo      Ti      To       v       q      cost    "
         "time   other  oversp sprayby    film\n";
  for (const ReportedSpray::Trial& t : s.trials) {
    const bool best = t.across == s.across && t.degrees == s.degrees;
    trialRow(out, t, best ? '*' : t.preferred ? '+' : ' ', true);
  }
  if (s.trials.empty()) {
    trialRow(out, chosenOf(s), ' ', s.cost.has_value());
  }
}

}  // namespace arelem::backend
