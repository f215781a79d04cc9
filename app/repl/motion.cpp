// Commands about the motion of a session: :time, :step.
#include <algorithm>
#include <charconv>

#include "app/repl/console.h"

#include "ir/diag/display_text.h"

namespace arelem::app::repl {

namespace {
/// The locations of the path that a statement left, in order: first, last and how many.
struct Stretch {
  std::optional<Vec3> first, last;
  std::size_t count = 0;
};

/// The stretches of all motion records, one for each run of records of one statement.
std::vector<std::pair<int, Stretch>> stretchesOf(const cl::Recording& path) {
  std::vector<std::pair<int, Stretch>> all;
  for (const cl::Record& record : path.records) {
    const auto* motion = std::get_if<cl::Motion>(&record.body);
    if (motion == nullptr || motion->points() == 0) {
      continue;
    }
    const bool goesOn = !all.empty() && motion->kind == cl::Motion::Kind::continuation &&
                        all.back().first == record.isn;
    if (!goesOn) {
      all.emplace_back(record.isn, Stretch{});
    }
    Stretch& s = all.back().second;
    const auto at = [&](std::size_t i) {
      const double* c = &motion->coordinates[i * motion->stride()];
      return Vec3(c[0], c[1], c[2]);
    };
    s.first = s.first ? s.first : at(0);
    s.last = at(motion->points() - 1);
    s.count += motion->points();
  }
  return all;
}

std::string placeOf(const Vec3& p, const Style& style) {
  return fmt::format("({:.{}g}, {:.{}g}, {:.{}g})", p.x(), style.digits, p.y(), style.digits, p.z(),
                     style.digits);
}

void printStep(Console& console, const runtime::MotionFact& fact, const Stretch* stretch) {
  const SourceMap& sources = console.session.run()->job.sources;
  const LineColumn at = sources.locate(fact.origin.buffer, fact.origin.begin);
  console.out << fmt::format("{}:{}  {}\n", sources.name(fact.origin.buffer), at.line,
                             displayText(sources.line(fact.origin.buffer, at.line)));
  console.out << "   ";
  printMotion(console.out, fact, unitOf(*console.session.run()), console.style);
  if (stretch != nullptr && stretch->last) {
    console.out << "   to " << placeOf(*stretch->last, console.style) << '\n';
  }
}
}  // namespace

std::string tellTime(Console& console, const std::string& rest) {
  if (!rest.empty()) {
    return ":time takes nothing; :set velocity, acceleration, jerk and deviation tell the machine";
  }
  const Run& run = *console.session.run();
  if (run.path->records.empty()) {
    return "the session has no motion";
  }
  DiagnosticLog log;
  timing::CutTimer timer(console.machine, log);
  std::map<int, Span> places;
  for (const cl::Record& record : run.path->records) {
    places.emplace(record.isn, record.origin);
    timer.accept(record);
  }
  const timing::TimeTable table = timer.finish();
  if (log.errors() > 0) {
    printDiagnostics(console, run, log.all());
    return "";
  }
  for (const auto& [isn, seconds] : table.statements) {
    const Span& at = places.at(isn);
    const LineColumn line = run.job.sources.locate(at.buffer, at.begin);
    console.out << fmt::format("{:>10.3f} s  {}: {}\n", seconds, line.line,
                               displayText(run.job.sources.line(at.buffer, line.line)));
  }
  console.out << fmt::format(
      "{:>10.3f} s  in all: cutting {:.3f}, rapid {:.3f}, dwell {:.3f}, "
      "tool changes {:.3f}\n",
      table.total(), table.cutting, table.rapid, table.dwell, table.toolChanges);
  return "";
}

std::string step(Console& console, const std::string& rest) {
  const Run& run = *console.session.run();
  const auto& facts = run.job.motion.facts;
  std::size_t n = 1;
  if (rest == "reset") {
    console.stepped = 0;
    console.out << "before the first motion\n";
    return "";
  }
  if (!rest.empty()) {
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), n);
    if (error != std::errc{} || end != rest.data() + rest.size() || n == 0) {
      return "a number from 1 on is needed, or reset";
    }
  }
  if (facts.empty()) {
    return "the session has no motion";
  }
  if (console.stepped >= facts.size()) {
    console.out << "that was the last motion; :step reset begins again\n";
    return "";
  }
  const auto stretches = stretchesOf(*run.path);
  const std::size_t last = std::min(facts.size(), console.stepped + n);
  for (; console.stepped < last && !console.interrupt.flag(); ++console.stepped) {
    const bool known = stretches.size() == facts.size();
    printStep(console, facts[console.stepped],
              known ? &stretches[console.stepped].second : nullptr);
  }
  return "";
}

}  // namespace arelem::app::repl
