#include "ir/diag/verify.h"

#include <cmath>
#include <iostream>
#include <numbers>
#include <sstream>

#include "app/certify.h"
#include "app/command.h"
#include "app/machine.h"
#include "app/options.h"
#include "app/pipeline.h"
#include "app/source_file.h"

#include "backend/cltape/reader.h"
#include "backend/vplus/reader.h"
#include "ir/diag/render_text.h"
#include "ir/diag/robot.h"

namespace arelem::app {

namespace {
/// One cutter location: where the tool end stands, and the axis where it was written.
struct Location {
  Vec3 point;
  std::optional<Vec3> axis;
  std::optional<Vec3> side;
  Span origin;
};

/// Keeps the locations of a stream of records and forgets the rest.
class Path : public cl::RecordSink {
 public:
  void accept(const cl::Record& record) override {
    if (const auto* units = std::get_if<cl::Units>(&record.body)) {
      millimeters = units->unit == Word::CM       ? 10.0
                    : units->unit == Word::INCHES ? 25.4
                    : units->unit == Word::FEET   ? 304.8
                                                  : 1.0;
    }
    const auto* motion = std::get_if<cl::Motion>(&record.body);
    if (motion == nullptr) {
      return;
    }
    for (std::size_t i = 0; i + motion->stride() <= motion->coordinates.size();
         i += motion->stride()) {
      const double* c = motion->coordinates.data() + i;
      Location location{{c[0], c[1], c[2]}, std::nullopt, std::nullopt, record.origin};
      if (motion->withAxis) {
        location.axis = Vec3(c[3], c[4], c[5]);
      }
      if (motion->withSide) {
        location.side = Vec3(c[6], c[7], c[8]);
      }
      locations.push_back(location);
    }
  }
  std::vector<Location> locations;
  double millimeters = 1.0;  ///< of the part unit
};

struct Allowed {
  double distance = 1e-6;  ///< part unit
  double degrees = 1e-4;
};

/// What the three decimals of a V+ program, and the steps of a tilt axis, take away.
Allowed vplusRounding(const Allowed& given,
                      double millimeters,
                      const std::optional<robot::Machine>& machine) {
  constexpr double digit = 1.0e-3;  // mm and degrees: half of it for each coordinate and angle
  const double step = machine && machine->tilt ? 0.5 * machine->tilt->step : 0.0;
  return {std::max(given.distance, digit / millimeters),
          std::max(given.degrees, 2.0 * digit + 1.001 * step)};
}

double degreesBetween(const Vec3& a, const Vec3& b) {
  constexpr double degreesOfARadian = 180.0 / std::numbers::pi;
  return degreesOfARadian * std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The first difference ends the comparison: what follows a wrong location is seldom of use.
std::optional<Diagnostic> firstDifference(const Path& wanted,
                                          const Path& found,
                                          const std::string& name,
                                          const Allowed& allowed) {
  const std::size_t count = std::min(wanted.locations.size(), found.locations.size());
  for (std::size_t i = 0; i < count; ++i) {
    const Location& w = wanted.locations[i];
    const Location& f = found.locations[i];
    const double distance = (w.point - f.point).norm();
    if (!(distance <= allowed.distance)) {
      return diagnose(w.origin, diag::PathDiffers, i + 1, name, distance, allowed.distance);
    }
    const double turned = w.axis && f.axis ? degreesBetween(*w.axis, *f.axis) : 0.0;
    if (!(turned <= allowed.degrees)) {
      return diagnose(w.origin, diag::AxisDiffers, i + 1, name, turned, allowed.degrees);
    }
    const double about = w.side && f.side ? degreesBetween(*w.side, *f.side) : 0.0;
    if (!(about <= allowed.degrees)) {
      return diagnose(w.origin, diag::SideDiffers, i + 1, name, about, allowed.degrees);
    }
  }
  if (wanted.locations.size() != found.locations.size()) {
    return diagnose(nowhere, diag::PathLength, name, found.locations.size(),
                    wanted.locations.size());
  }
  return std::nullopt;
}

/// Compiles a text to its path. The path of CL text is that of the program it is.
bool pathOfText(Compilation& job,
                const std::string& file,
                std::string text,
                Path& path,
                const InterruptFlag& interrupted) {
  return load(job, file, std::move(text), interrupted) && evaluate(job, interrupted) &&
         execute(job, path, interrupted);
}

bool pathOfOutput(const std::string& file,
                  std::string bytes,
                  const Settings& settings,
                  Path& path,
                  const InterruptFlag& interrupted,
                  ExitCode& result) {
  Settings reading = settings;
  reading.dialect = frontend::Dialect::cl;
  Compilation job(reading);
  bool good = false;
  if (objectionToText(file, bytes)) {
    job.main = job.sources.add(displayName(file), "");
    std::istringstream in(std::move(bytes));
    good = backend::readTape(in, path, job.log, settings.limits).complete && job.log.errors() == 0;
  } else {
    good = pathOfText(job, file, std::move(bytes), path, interrupted);
  }
  job.log.print(job.sources, job.main, settings);
  result = worse(result, job.log.exitCode());
  return good;
}

/// The moves of a V+ program, in the part unit. Its coordinates are mm with three decimals.
bool pathOfVplus(const std::string& file,
                 const std::string& text,
                 const std::optional<robot::Machine>& machine,
                 double millimeters,
                 DiagnosticLog& log,
                 Path& path) {
  const robot::TiltAxis* tilt = machine && machine->tilt ? &*machine->tilt : nullptr;
  auto program = vplus::readProgram(text, displayName(file), tilt);
  if (!program) {
    log.accept(program.takeFailure());
    return false;
  }
  for (Failure& warning : program->warnings) {
    log.accept(std::move(warning));
  }
  if (!program->straightLine) {
    log.accept(fail(diag::VplusBranches, displayName(file)));
    return false;
  }
  for (const vplus::Move& move : program->moves) {
    path.locations.push_back(
        {move.pose.point / millimeters, move.pose.axis, move.pose.side, nowhere});
  }
  return true;
}

ExitCode verify(const std::string& output,
                const std::string& program,
                const Settings& settings,
                Allowed allowed,
                const std::string& machineFile,
                const InterruptFlag& interrupted) {
  Compilation job(settings);
  std::optional<robot::Machine> machine;
  if (!machineFile.empty()) {
    Result<robot::Machine> read = loadMachine(machineFile, settings);
    if (!read) {
      job.log.accept(read.takeFailure());
      job.log.print(job.sources, job.main, settings);
      return job.log.exitCode();
    }
    machine = *std::move(read);
  }
  const backend::Target* target = backend::targetForFile(output);
  const bool isVplus = target != nullptr && target->name == "vplus";
  Result<std::string> text = readBytes(program, settings.limits);
  Result<std::string> bytes = readBytes(output, settings.limits);
  for (Result<std::string>* input : {&text, &bytes}) {
    if (!*input) {
      job.log.accept(input->takeFailure());
    }
  }
  Path wanted;
  Path found;
  ExitCode result = ExitCode::ok;
  if (text && bytes && pathOfText(job, program, *std::move(text), wanted, interrupted) &&
      (isVplus ? pathOfVplus(output, *bytes, machine, wanted.millimeters, job.log, found)
               : pathOfOutput(output, *std::move(bytes), settings, found, interrupted, result))) {
    if (isVplus) {
      allowed = vplusRounding(allowed, wanted.millimeters, machine);
    }
    if (std::optional<Diagnostic> difference =
            firstDifference(wanted, found, displayName(output), allowed)) {
      job.log.accept(*std::move(difference));
    } else if (!settings.quiet) {
      std::cerr << fmt::format("arelem: `{}` has the {} locations of `{}`\n", displayName(output),
                               found.locations.size(), displayName(program));
    }
  }
  job.log.print(job.sources, job.main, settings);
  return worse(result, job.log.exitCode());
}
}  // namespace

int runVerify(const Invocation& invocation) {
  CLI::App app(
      "Proves that every cut vector keeps the tolerances of its part program: of the path that "
      "arelem computes,\n"
      "or of a CL file of any origin (CL text, CL tape, json). With --with, compares the locations "
      "of an output\n"
      "with those that the program gives.",
      "verify");
  Settings settings;
  Allowed allowed;
  CertifyRequest request;
  std::string with;
  std::string machine;
  app.add_option("FILE", request.program, "a part program; with --with, an output")->required();
  app.add_option("CL", request.path, "the CL file of the program; without it, arelem's own path");
  app.add_option("--with", with, "the part program that the output FILE was made from")
      ->type_name("FILE");
  app.add_option("--machine", machine, "the machine file it was made for")->type_name("FILE");
  app.add_option("--tolerance", allowed.distance,
                 "with --with: largest distance of a location, part unit (1e-6)")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--slack", request.slack,
                 "what rounding may add to each tolerance, part unit (1e-6)")
      ->check(CLI::NonNegativeNumber);
  app.add_flag("--json", request.json, "one object a statement instead of a table");
  addSourceOptions(app, settings);
  addMessageOptions(app, settings);
  if (const auto code = parse(app, invocation.words)) {
    return *code;
  }
  const InterruptFlag& interrupted = invocation.interrupt.flag();
  if (with.empty()) {
    return static_cast<int>(certify(request, settings, interrupted));
  }
  const std::string& output = request.program;
  if (const backend::Target* target = backend::targetForFile(output);
      target != nullptr && !target->readsBack) {
    printUsageError("verify",
                    "`" + output + "` is " + std::string(target->name) +
                        ", which is not read back; verify reads CL text, CL tapes and V+ programs");
    return static_cast<int>(ExitCode::wrongUse);
  }
  return static_cast<int>(verify(output, with, settings, allowed, machine, interrupted));
}

}  // namespace arelem::app
