#include "app/certify.h"

#include <algorithm>
#include <cmath>
#include <iostream>

#include "app/certify_table.h"
#include "app/cl_input.h"
#include "app/decimals_seen.h"
#include "app/in_part_unit.h"
#include "app/pipeline.h"
#include "app/source_file.h"
#include "app/stopwatch.h"

#include "ir/cl/post_word.h"
#include "ir/diag/verify.h"
#include "runtime/certify/certificate.h"
#include "runtime/interpret/passed_post.h"
#include "runtime/path/chords.h"
#include "runtime/path/swarf.h"

namespace arelem::app {

namespace {
/// Arcs and splines are judged as cut vectors that leave them by half the slack, or by this where
/// there is none. Part unit.
constexpr double leastSag = 1e-7;

/// WCORN, whose locations the program gives and no upright tool.
std::optional<Span> firstCorner(const std::vector<runtime::Action>& actions) {
  for (const runtime::Action& action : actions) {
    const cl::Post* post = runtime::passedPost(action);
    if (post != nullptr && cl::is(*post, Word::WCORN)) {
      return action.origin;
    }
  }
  return std::nullopt;
}

/// Hands the records of a CL file to the certificate, in the unit of the program, its arcs and
/// splines as cut vectors and its swarf sections upright. False when it cannot be read.
/// `decimals` becomes the number of them that its places have.
bool readPath(ClFile& file,
              const PartFacts& part,
              double slack,
              const Settings& settings,
              cl::RecordSink& records,
              const InterruptFlag& interrupted,
              ExitCode& exit,
              int& decimals) {
  Settings reading = settings;
  reading.dialect = frontend::Dialect::cl;
  Compilation job(reading);
  const auto upright = path::makeUprightStage(records, slack, job.log);
  const auto chords = path::makeChordStage(*upright, job.log, std::max(0.5 * slack, leastSag));
  DecimalsSeen rounded(*chords);
  InPartUnit lengths(part, displayName(file.path()), rounded, job.log);
  bool good = readRecords(job, file, lengths, interrupted);
  upright->finish();
  good = good && job.log.errors() == 0;
  job.log.print(job.sources, job.main, settings);
  exit = worse(exit, job.log.exitCode());
  decimals = rounded.decimals();
  return good;
}
}  // namespace

ExitCode certify(const CertifyRequest& request,
                 const Settings& settings,
                 const InterruptFlag& interrupted) {
  Compilation job(settings);
  ExitCode exit = ExitCode::ok;
  if (load(job, request.program, interrupted) && evaluate(job, interrupted)) {
    certify::Options options;
    options.slack = request.slack.value_or(options.slack);
    options.beyondBand = request.slack;
    options.limits = settings.limits;
    options.interrupted = &interrupted;
    options.own = request.path.empty();
    options.file = displayName(request.path.empty() ? request.program : request.path);
    std::optional<ClFile> file;
    if (!request.path.empty()) {
      Result<ClFile> opened = ClFile::open(request.path, settings.limits);
      if (!opened) {
        job.log.accept(opened.takeFailure());
        job.log.print(job.sources, job.main, settings);
        return job.log.exitCode();
      }
      file = *std::move(opened);
      options.numbered = file->format() != InputFormat::text;
    }
    double seconds = 0.0;
    int decimals = 0;
    const auto certificate = certify::makeCertificate(job.evaluation.actions, options, job.log);
    bool whole = false;
    {
      const Stopwatch watch(seconds);
      const auto corner = firstCorner(job.evaluation.actions);
      if (request.path.empty()) {
        whole = execute(job, *certificate, interrupted, true);
      } else if (corner) {
        Diagnostic refusal =
            diagnose(*corner, diag::NotCertified,
                     "a CL file has the tool as WCORN turned it in the corner, where its locations "
                     "no longer follow from those of the upright tool");
        refusal.help =
            "`arelem verify CL --with PROGRAM` compares its locations and axes; without "
            "the file the path is proven as it was before the tool was tilted";
        job.log.accept(std::move(refusal));
      } else {
        whole = readPath(*file, partFactsOf(job.evaluation.actions), options.slack, settings,
                         *certificate, interrupted, exit, decimals);
      }
      const bool judged = !corner || request.path.empty();
      if (judged && (whole || job.log.errors() > 0)) {
        certificate->finish();
      }
    }
    if (whole && !interrupted) {
      (request.json ? printCertificateJson : printCertificate)(std::cout, *certificate,
                                                               job.sources);
      if (!settings.quiet) {
        const certify::Summary& s = certificate->summary();
        std::cerr << fmt::format(
            "arelem: {} statements, {} cut vectors along surfaces, {} places measured, {:.3f} s: "
            "{}\n",
            s.statements, s.cutVectors, s.places, seconds,
            s.faults == 0 ? "all tolerances are proven" : fmt::format("{} faults", s.faults));
        const double last = std::pow(10.0, -decimals);
        if (s.faults != 0 && !request.slack && decimals != 0 && last > options.slack) {
          std::cerr << fmt::format(
              "   places of {} have {} decimals at most: `--slack {}` allows for their rounding\n",
              options.file, decimals, last);
        }
      }
    }
  }
  job.log.print(job.sources, job.main, settings);
  return worse(exit, job.log.exitCode());
}

}  // namespace arelem::app
