#include "app/report.h"

#include <algorithm>
#include <array>
#include <map>

#include "app/output_file.h"
#include "app/spray_report.h"
#include "app/statement_word.h"
#include "app/version.h"

#include "backend/report/report.h"

namespace arelem::app {

namespace {
bool followsSurfaces(const std::string& statement) {
  return statement.starts_with("GO") && statement != "GOTO" && statement != "GODLTA";
}

void widen(std::optional<backend::ReportedMotion::Deviation>& deviation,
           double inner,
           double outer) {
  if (!deviation) {
    deviation = {inner, outer};
  }
  deviation->inner = std::min(deviation->inner, inner);
  deviation->outer = std::max(deviation->outer, outer);
}

void add(backend::ReportedMotion& entry, const runtime::MotionFact& fact) {
  entry.executions += 1;
  entry.cutVectors += fact.cutVectors;
  entry.pathLength += fact.length;
  entry.seconds += fact.seconds;
  if (followsSurfaces(fact.statement)) {
    widen(entry.drive, fact.driveInner, fact.driveOuter);
    widen(entry.part, fact.partInner, fact.partOuter);
  }
}

backend::SourcePlace placeOf(const Compilation& job, const Span& span) {
  return {std::string(job.sources.name(span.buffer)),
          job.sources.locate(span.buffer, span.begin).line};
}

/// "PT-04" of PT_04; a letter behind the number tells rows of one printed form and is left out.
std::string publicId(std::string_view id) {
  std::string text(id.substr(0, id.find('_', id.find('_') + 1)));
  std::replace(text.begin(), text.end(), '_', '-');
  return text;
}

/// Definition forms and other features of the language that the program uses.
std::map<std::string, std::uint64_t> featuresOf(const Compilation& job) {
  std::map<std::string, std::uint64_t> used;
  for (const define::FormRow& form : define::formTable()) {
    if (const auto times = job.evaluation.forms[static_cast<std::size_t>(form.id)]; times != 0) {
      used[publicId(form.idText)] += times;
    }
  }
  ir::FeatureCounts counts = job.program.features;
  ir::survey(job.program, counts);
  std::size_t index = 0;
  for (const ir::FeatureRow& feature : ir::featureTable()) {
    if (const auto times = counts[static_cast<ir::Feature>(index++)]; times != 0) {
      used[publicId(feature.idText)] += times;
    }
  }
  return used;
}

/// In order of first execution.
std::vector<backend::ReportedMotion> motionsOf(const Compilation& job) {
  std::vector<backend::ReportedMotion> entries;
  std::map<Span, std::size_t> places;
  for (const runtime::MotionFact& fact : job.motion.facts) {
    const auto [place, isNew] = places.emplace(fact.origin, entries.size());
    if (isNew) {
      backend::ReportedMotion entry;
      entry.place = placeOf(job, fact.origin);
      entry.isn = fact.isn;
      entry.statement = fact.statement;
      entry.executions = 0;
      entries.push_back(std::move(entry));
    }
    add(entries[place->second], fact);
  }
  return entries;
}

backend::Report reportOf(const Compilation& job, bool timing) {
  backend::Report report;
  report.toolVersion = releaseText();
  for (std::uint32_t i = 0; i < job.sources.size(); ++i) {
    report.sources.emplace_back(job.sources.name({i}));
  }
  report.motions = motionsOf(job);
  for (const auto& sprayed : job.evaluation.sprayed) {
    const film::Map map = film::mapOf(*sprayed, 0.0);
    report.sprays.push_back(reported(job, *sprayed, &map));
  }
  for (const ir::Block& block : job.program.blocks) {
    for (const ir::Statement& statement : block.statements) {
      ++report.statements[statementWord(statement.body)];
    }
  }
  report.features = featuresOf(job);
  report.dialect = job.program.dialect;
  for (const runtime::Ignored& ignored : job.evaluation.ignored) {
    report.wordsWithoutEffect.push_back(
        {placeOf(job, ignored.first), ignored.what, ignored.why, ignored.times});
  }
  report.errors = job.log.errors();
  report.warnings = job.log.warnings();
  report.complete = job.evaluation.complete && job.motion.complete && job.log.errors() == 0;
  if (timing) {
    report.timing = {job.seconds.parse, job.seconds.evaluate, job.seconds.execute,
                     job.seconds.write};
  }
  return report;
}
}  // namespace

void writeRunReport(Compilation& job, const std::string& path, bool timing) {
  Result<std::unique_ptr<OutputFile>> file = openOutput(path);
  if (!file) {
    job.log.accept(file.takeFailure());
    return;
  }
  writeReport((*file)->stream(), reportOf(job, timing));
  Result<std::string> name = (*file)->commit(false);
  if (!name) {
    job.log.accept(name.takeFailure());
  }
}

}  // namespace arelem::app
