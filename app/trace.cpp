#include "app/trace.h"

#include <fmt/format.h>

namespace arelem::app {

namespace {
std::string placeOf(const Compilation& job, const Span& at) {
  const auto place = job.sources.locate(at.buffer, at.begin);
  return fmt::format("{}:{}", job.sources.name(at.buffer), place.line);
}

std::string describe(const runtime::MotionFact& fact) {
  std::string text =
      fmt::format("{}: {} cut vectors, length {:.9g}, to {:.9g}, {:.9g}, {:.9g}", fact.statement,
                  fact.cutVectors, fact.length, fact.end.x(), fact.end.y(), fact.end.z());
  if (fact.axis != Vec3::UnitZ()) {
    text +=
        fmt::format(", axis {:.9g}, {:.9g}, {:.9g}", fact.axis.x(), fact.axis.y(), fact.axis.z());
  }
  const auto deviation = [&text](std::string_view surface, double inner, double outer) {
    if (inner != 0.0 || outer != 0.0) {
      text += fmt::format(", off the {} surface by {:.3g} to {:.3g}", surface, inner, outer);
    }
  };
  deviation("drive", fact.driveInner, fact.driveOuter);
  deviation("part", fact.partInner, fact.partOuter);
  return text;
}
}  // namespace

void printTrace(std::ostream& out, const Compilation& job) {
  for (const runtime::Traced& row : job.evaluation.trace) {
    out << fmt::format("{}: section 1: {:>{}}{}\n", placeOf(job, row.at), "", 2 * row.depth,
                       row.text);
  }
  for (const runtime::MotionFact& fact : job.motion.facts) {
    if (fact.traced) {
      out << fmt::format("{}: section 2: {}\n", placeOf(job, fact.origin), describe(fact));
    }
  }
}

}  // namespace arelem::app
