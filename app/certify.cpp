#include "app/certify.h"

#include <iostream>

#include "app/certify_table.h"
#include "app/cl_input.h"
#include "app/pipeline.h"
#include "app/source_file.h"
#include "app/stopwatch.h"

#include "ir/diag/verify.h"
#include "runtime/certify/certificate.h"
#include "runtime/path/chords.h"
#include "runtime/path/swarf.h"

namespace arelem::app {

namespace {
/// Hands the records of a CL file to the certificate, its arcs and splines as cut vectors. False
/// when it cannot be read.
bool readPath(const std::string& file,
              std::string bytes,
              const Settings& settings,
              cl::RecordSink& records,
              const InterruptFlag& interrupted,
              ExitCode& exit) {
  Settings reading = settings;
  reading.dialect = frontend::Dialect::cl;
  Compilation job(reading);
  const auto chords = path::makeChordStage(records, job.log);
  const bool good = readRecords(job, file, std::move(bytes), *chords, interrupted);
  job.log.print(job.sources, job.main, settings);
  exit = worse(exit, job.log.exitCode());
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
    options.slack = request.slack;
    options.limits = settings.limits;
    options.interrupted = &interrupted;
    options.file = displayName(request.path.empty() ? request.program : request.path);
    std::string bytes;
    if (!request.path.empty()) {
      Result<std::string> read = readBytes(request.path, settings.limits);
      if (!read) {
        job.log.accept(read.takeFailure());
        job.log.print(job.sources, job.main, settings);
        return job.log.exitCode();
      }
      bytes = *std::move(read);
      options.numbered = formatOf(bytes) != InputFormat::text;
    }
    double seconds = 0.0;
    const auto certificate = certify::makeCertificate(job.evaluation.actions, options, job.log);
    bool whole = false;
    {
      const Stopwatch watch(seconds);
      const auto swarf = path::firstSwarf(job.evaluation.actions);
      if (request.path.empty()) {
        whole = execute(job, *certificate, interrupted, true);
      } else if (swarf) {
        Diagnostic refusal = diagnose(*swarf, diag::NotCertified,
                                      "a CL file has the tilted tool of the section, whose walls "
                                      "are not surfaces of the program");
        refusal.help =
            "`arelem verify CL --with PROGRAM` compares its locations and axes; without "
            "the file the path is proven as it was before the tool was tilted";
        job.log.accept(std::move(refusal));
      } else {
        whole = readPath(request.path, std::move(bytes), settings, *certificate, interrupted, exit);
      }
      const bool judged = !swarf || request.path.empty();
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
      }
    }
  }
  job.log.print(job.sources, job.main, settings);
  return worse(exit, job.log.exitCode());
}

}  // namespace arelem::app
