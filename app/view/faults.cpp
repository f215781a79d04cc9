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

void FaultTrace::accept(const cl::Record& record) {
  const auto* motion = std::get_if<cl::Motion>(&record.body);
  if (motion == nullptr || motion->points() == 0) {
    return;
  }
  const auto place = [&](std::size_t i) {
    return Vec3(&motion->coordinates[i * motion->stride()]);
  };
  if (job_.log.errors() == 0) {
    ways_.clear();
  }
  ways_.push_back({record.origin.buffer == job_.main, record.origin.begin, place(0),
                   place(motion->points() - 1)});
}

std::vector<backend::FaultMark> FaultTrace::marks() const {
  std::vector<backend::FaultMark> marks;
  std::map<std::uint32_t, std::uint32_t> wrong = wrongMotions(job_);
  std::optional<Vec3> last;
  for (const Way& way : ways_) {
    while (way.here && !wrong.empty() && wrong.begin()->first < way.begin) {
      if (last && marks.size() < mostFaults) {
        marks.push_back({wrong.begin()->second, *last, way.first});
      }
      wrong.erase(wrong.begin());
    }
    last = way.last;
  }
  for (const auto& [begin, line] : wrong) {
    if (last && marks.size() < mostFaults) {
      marks.push_back({line, *last, std::nullopt});
    }
  }
  return marks;
}

}  // namespace arelem::app
