#include "app/view/faults.h"

#include <algorithm>
#include <map>
#include <set>

#include "frontend/outline.h"

namespace arelem::app {

namespace {
/// Whether a statement without blanks moves the tool, or calls what may.
bool moves(const frontend::OutlinedStatement& statement) {
  static const std::set<Word> others = {Word::FROM,  Word::CALL,  Word::SPRAY, Word::POCKET,
                                        Word::TLLFT, Word::TLRGT, Word::TLON};
  return others.contains(statement.head) ||
         (statement.head != Word::count && spell(statement.head).starts_with("GO"));
}

/// First bytes of the motion statements at fault, with their lines.
std::map<std::uint32_t, std::uint32_t> wrongMotions(const Compilation& job) {
  std::set<std::uint32_t> places;
  for (const Diagnostic& d : job.log.all()) {
    const Span at = d.calledFrom.empty() ? d.at : d.calledFrom.back();
    if (d.severity() == Severity::error && at.buffer == job.main) {
      places.insert(at.begin);
    }
  }
  std::map<std::uint32_t, std::uint32_t> wrong;
  if (places.empty()) {
    return wrong;
  }
  const auto statements =
      frontend::outline(job.sources.text(job.main), job.settings.dialect, job.settings.limits);
  for (const frontend::OutlinedStatement& s : statements) {
    const auto first = places.lower_bound(s.begin);
    if (first != places.end() && *first < s.end && moves(s)) {
      wrong.emplace(s.begin, job.sources.locate(job.main, *first).line);
    }
  }
  return wrong;
}
}  // namespace

std::vector<backend::FaultMark> faultsOf(const Compilation& job, const cl::Recording& records) {
  std::vector<backend::FaultMark> marks;
  std::map<std::uint32_t, std::uint32_t> wrong = wrongMotions(job);
  std::optional<Vec3> last;
  for (const cl::Record& record : records.records) {
    const auto* motion = std::get_if<cl::Motion>(&record.body);
    if (motion == nullptr || motion->points() == 0) {
      continue;
    }
    const auto place = [&](std::size_t i) {
      return Vec3(&motion->coordinates[i * motion->stride()]);
    };
    const bool here = record.origin.buffer == job.main;
    while (here && !wrong.empty() && wrong.begin()->first < record.origin.begin) {
      if (last && marks.size() < mostFaults) {
        marks.push_back({wrong.begin()->second, *last, place(0)});
      }
      wrong.erase(wrong.begin());
    }
    last = place(motion->points() - 1);
  }
  for (const auto& [begin, line] : wrong) {
    if (last && marks.size() < mostFaults) {
      marks.push_back({line, *last, std::nullopt});
    }
  }
  return marks;
}

}  // namespace arelem::app
