#include "app/certify_table.h"

#include <ostream>

#include <fmt/format.h>

#include "ir/diag/render_json.h"

namespace arelem::app {

namespace {
using certify::GuideFigures;
using certify::StatementResult;
using certify::Verdict;

std::string_view spell(Verdict::State state) {
  switch (state) {
    case Verdict::State::proven:
      return "proven";
    case Verdict::State::refuted:
      return "violated";
    default:
      return "undecided";
  }
}

std::string_view worst(const Verdict& v) {
  const bool refuted = v.inner == Verdict::State::refuted || v.outer == Verdict::State::refuted;
  return refuted ? "violated" : v.good() ? "proven" : "undecided";
}

/// "-0.000999 .. +0.001 of -0.001 .. +0.001".
std::string figures(const std::optional<GuideFigures>& g) {
  if (!g) {
    return "";
  }
  const Verdict& v = g->result.verdict;
  return fmt::format("{:<8} {:>+11.3e} {:>+11.3e}  {:>+9.2g} {:>+9.2g}  {:<9}", g->surface,
                     v.least.proven, v.greatest.proven, -g->allowed.inner, g->allowed.outer,
                     worst(v));
}

std::string stops(const StatementResult& r) {
  std::string text;
  for (const certify::StopFigures& s : r.stops) {
    text += fmt::format("{}{} {} {:+.3e}{}", text.empty() ? "" : ", ", s.condition, s.surface,
                        s.gap, s.good ? "" : " missed");
  }
  return text;
}

std::string json(const GuideFigures& g) {
  const Verdict& v = g.result.verdict;
  return fmt::format(
      R"({{"surface": {}, "inner": {}, "outer": {}, "allowedInner": {}, "allowedOuter": {}, )"
      R"("measuredInner": {}, "measuredOuter": {}, "innerIs": "{}", "outerIs": "{}"}})",
      jsonString(g.surface), v.least.proven, v.greatest.proven, -g.allowed.inner, g.allowed.outer,
      v.least.measured, v.greatest.measured, spell(v.inner), spell(v.outer));
}

std::uint32_t lineOf(const StatementResult& r, const SourceMap& sources) {
  return sources.locate(r.origin.buffer, r.origin.begin).line;
}
}  // namespace

void printCertificate(std::ostream& out, const certify::Certificate& c, const SourceMap& sources) {
  out << fmt::format("{:>5} {:<7} {:>7}  {:<65} {:<65} {}\n", "line", "motion", "vectors",
                     "drive: proven least, greatest, allowed", "part", "stop");
  for (const StatementResult& r : c.results()) {
    std::string line =
        fmt::format("{:>5} {:<7} {:>7}  {:<65} {:<65} {}", lineOf(r, sources), r.statement,
                    r.cutVectors, figures(r.drive), figures(r.part), stops(r));
    line.resize(line.find_last_not_of(' ') + 1);
    out << line << '\n';
  }
}

void printCertificateJson(std::ostream& out,
                          const certify::Certificate& c,
                          const SourceMap& sources) {
  for (const StatementResult& r : c.results()) {
    std::string line = fmt::format(
        R"({{"file": {}, "line": {}, "isn": {}, "statement": "{}", "cutVectors": {}, "good": {})",
        jsonString(sources.name(r.origin.buffer)), lineOf(r, sources), r.isn, r.statement,
        r.cutVectors, r.good);
    if (r.drive) {
      line += fmt::format(R"(, "drive": {})", json(*r.drive));
    }
    if (r.part) {
      line += fmt::format(R"(, "part": {})", json(*r.part));
    }
    std::string list;
    for (const certify::StopFigures& s : r.stops) {
      list +=
          fmt::format(R"({}{{"surface": {}, "condition": "{}", "gap": {}, "good": {}}})",
                      list.empty() ? "" : ", ", jsonString(s.surface), s.condition, s.gap, s.good);
    }
    out << line << R"(, "stops": [)" << list << "]}\n";
  }
}

}  // namespace arelem::app
