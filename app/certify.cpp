#include "app/certify.h"

#include <iostream>
#include <sstream>

#include "app/certify_table.h"
#include "app/pipeline.h"
#include "app/source_file.h"
#include "app/stopwatch.h"

#include "backend/cltape/reader.h"
#include "backend/json/reader.h"
#include "runtime/certify/certificate.h"

namespace arelem::app {

namespace {
enum class Format : std::uint8_t { text, tape, json };

Format formatOf(const std::string& file, const std::string& bytes) {
  if (objectionToText(file, bytes)) {
    return Format::tape;
  }
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string::npos && bytes[first] == '{' ? Format::json : Format::text;
}

/// Hands the records of a CL file to the certificate. False when it cannot be read.
bool readPath(const std::string& file,
              std::string bytes,
              Format format,
              const Settings& settings,
              cl::RecordSink& records,
              const InterruptFlag& interrupted,
              ExitCode& exit) {
  Settings reading = settings;
  reading.dialect = frontend::Dialect::cl;
  Compilation job(reading);
  bool good = false;
  if (format == Format::text) {
    good = load(job, file, std::move(bytes), interrupted) && evaluate(job, interrupted) &&
           execute(job, records, interrupted);
  } else {
    job.main = job.sources.add(displayName(file), "");
    if (format == Format::json) {
      good = backend::readJsonRecords(bytes, displayName(file), records, job.log);
    } else {
      std::istringstream in(std::move(bytes));
      good = backend::readTape(in, records, job.log, settings.limits).complete;
    }
  }
  good = good && job.log.errors() == 0;
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
    Format format = Format::tape;
    if (!request.path.empty()) {
      Result<std::string> read = readBytes(request.path, settings.limits);
      if (!read) {
        job.log.accept(read.takeFailure());
        job.log.print(job.sources, job.main, settings);
        return job.log.exitCode();
      }
      bytes = *std::move(read);
      format = formatOf(request.path, bytes);
      options.numbered = format != Format::text;
    }
    double seconds = 0.0;
    const auto certificate = certify::makeCertificate(job.evaluation.actions, options, job.log);
    bool whole = false;
    {
      const Stopwatch watch(seconds);
      whole = request.path.empty() ? execute(job, *certificate, interrupted)
                                   : readPath(request.path, std::move(bytes), format, settings,
                                              *certificate, interrupted, exit);
      if (whole || job.log.errors() > 0) {
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
