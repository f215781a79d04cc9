#include "ir/diag/verify.h"

#include <iostream>
#include <sstream>

#include "app/certify.h"
#include "app/code_file.h"
#include "app/command.h"
#include "app/in_part_unit.h"
#include "app/machine.h"
#include "app/number_check.h"
#include "app/options.h"
#include "app/pipeline.h"
#include "app/rewritten.h"
#include "app/source_file.h"
#include "app/verify_fit.h"
#include "app/verify_g97.h"
#include "app/verify_vplus.h"

#include "backend/cltape/reader.h"
#include "ir/diag/render_text.h"
#include "runtime/path/chords.h"

namespace arelem::app {

namespace {
/// Compiles a text to its path, with arcs and splines as the target of an output takes them. The
/// path of CL text is that of the program it is.
bool pathOfText(Compilation& job,
                const std::string& file,
                std::string text,
                cl::RecordSink& path,
                const backend::Target* target,
                const InterruptFlag& interrupted) {
  const bool straight = target != nullptr && !target->takesCurves;
  const auto chords = path::makeChordStage(path, job.log);
  cl::RecordSink& records = straight ? static_cast<cl::RecordSink&>(*chords) : path;
  return load(job, file, std::move(text), interrupted) && evaluate(job, interrupted) &&
         execute(job, records, interrupted);
}

bool pathOfOutput(const std::string& file,
                  std::string bytes,
                  const Settings& settings,
                  const PartFacts& part,
                  Path& path,
                  const InterruptFlag& interrupted,
                  ExitCode& result) {
  Settings reading = settings;
  reading.dialect = frontend::Dialect::cl;
  Compilation job(reading);
  bool good = false;
  InPartUnit lengths(part, displayName(file), path, job.log);
  if (objectionToText(file, bytes)) {
    job.main = job.sources.add(displayName(file), "");
    std::istringstream in(std::move(bytes));
    good = readCodes(job) &&
           backend::readTape(in, lengths, job.log, settings.limits, job.codes).complete &&
           job.log.errors() == 0;
  } else {
    good = pathOfText(job, file, std::move(bytes), lengths, nullptr, interrupted);
  }
  job.log.print(job.sources, job.main, settings);
  result = worse(result, job.log.exitCode());
  return good;
}

bool isRobotProgram(const std::string& file) {
  const backend::Target* target = backend::targetForFile(file);
  return target != nullptr && (target->name == "g97" || target->name == "vplus");
}

struct WithRequest {
  std::string output, program;
  MachineChoice machine;
  Allowed allowed;
  double fitShare = 0.0;  ///< that the output was made with; 0: location by location
};

/// Compares an output with the path of its program; the number of locations, none after an error.
std::optional<std::size_t> compared(const WithRequest& request,
                                    std::string bytes,
                                    const Path& wanted,
                                    const Rewritten& rewritten,
                                    const std::optional<robot::Machine>& machine,
                                    Compilation& job,
                                    const InterruptFlag& interrupted,
                                    ExitCode& result) {
  const backend::Target* target = backend::targetForFile(request.output);
  const std::string name = displayName(request.output);
  if (target != nullptr && target->name == "g97") {
    return verifyG97(bytes, name, machine.value_or(robot::Machine{}), wanted, rewritten,
                     request.allowed, job.log);
  }
  if (target != nullptr && target->name == "vplus") {
    return verifyVplus(bytes, name, machine.value_or(robot::Machine{}), wanted, rewritten,
                       request.allowed, job.log);
  }
  Path found;
  if (!pathOfOutput(request.output, std::move(bytes), job.settings,
                    partFactsOf(job.evaluation.actions), found, interrupted, result)) {
    return std::nullopt;
  }
  std::optional<Diagnostic> difference =
      request.fitShare > 0.0
          ? firstDeparture(wanted, found, name, {request.fitShare, request.allowed})
          : firstDifference(wanted, found, name, request.allowed);
  if (difference) {
    job.log.accept(*std::move(difference));
    return std::nullopt;
  }
  return found.locations.size();
}

ExitCode verify(const WithRequest& request,
                const Settings& settings,
                const InterruptFlag& interrupted) {
  Compilation job(settings);
  auto machine = loadMachine(request.machine, settings);
  Result<std::string> text = readBytes(request.program, settings.limits);
  Result<std::string> bytes = readBytes(request.output, settings.limits);
  if (!machine) {
    job.log.accept(machine.takeFailure());
  }
  for (Result<std::string>* input : {&text, &bytes}) {
    if (!*input) {
      job.log.accept(input->takeFailure());
    }
  }
  const backend::Target* target = backend::targetForFile(request.output);
  const bool again = isRobotProgram(request.output);
  Rewritten wanted(again && machine ? target : nullptr, machine ? *machine : std::nullopt);
  ExitCode result = ExitCode::ok;
  if (machine && text && bytes &&
      pathOfText(job, request.program, *std::move(text), wanted, target, interrupted)) {
    wanted.finish();
    const auto count = compared(request, *std::move(bytes), wanted.path(), wanted, *machine, job,
                                interrupted, result);
    if (count && !settings.quiet) {
      const std::string output = displayName(request.output);
      const std::string program = displayName(request.program);
      std::cerr << (request.fitShare > 0.0
                        ? fmt::format("arelem: the path of `{}`, {} locations, keeps to that of "
                                      "`{}`, {} locations\n",
                                      output, *count, program, wanted.path().locations.size())
                        : fmt::format("arelem: `{}` has the {} locations of `{}`\n", output, *count,
                                      program));
    }
  }
  job.log.print(job.sources, job.main, settings);
  return worse(result, job.log.exitCode());
}
/// The files of a command in which a robot program stands where a part program or CL file belongs.
std::optional<std::string> inWrongPlaces(const CertifyRequest& request,
                                         const WithRequest& comparison) {
  const std::string& program = comparison.program.empty() ? request.path : comparison.program;
  if (!isRobotProgram(program)) {
    return std::nullopt;
  }
  return fmt::format("`{0}` is a robot program; it is compared by `arelem verify {0} --with {1}`",
                     program, request.program);
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
  CertifyRequest request;
  WithRequest comparison;
  app.add_option("FILE", request.program, "a part program; with --with, an output")->required();
  app.add_option("CL", request.path, "the CL file of the program; without it, arelem's own path");
  app.add_option("--with", comparison.program,
                 "the part program that the output FILE was made from")
      ->type_name("FILE");
  addMachineOptions(app, comparison.machine);
  app.add_option("--tolerance", comparison.allowed.distance,
                 "with --with: largest distance of a location, part unit (1e-6)")
      ->check(numberFromZero());
  app.add_option("--fit", comparison.fitShare,
                 "with --with: the share of INTOL + OUTTOL that the output was made with; its path "
                 "may be so far from the program's")
      ->check(shareOfOne())
      ->type_name("SHARE");
  app.add_option("--slack", request.slack,
                 "what rounding may add to each tolerance, part unit (1e-6, but at most a hundredth of "
                 "INTOL + OUTTOL)")
      ->check(numberFromZero());
  app.add_flag("--json", request.json, "one object a statement instead of a table");
  addSourceOptions(app, settings);
  addMessageOptions(app, settings);
  if (const auto code = parse(app, invocation.words)) {
    return *code;
  }
  if (const auto objection = inWrongPlaces(request, comparison)) {
    printUsageError("verify", *objection);
    return static_cast<int>(ExitCode::wrongUse);
  }
  const InterruptFlag& interrupted = invocation.interrupt.flag();
  if (comparison.program.empty()) {
    return static_cast<int>(certify(request, settings, interrupted));
  }
  comparison.output = request.program;
  const std::string& output = comparison.output;
  if (const backend::Target* target = backend::targetForFile(output);
      target != nullptr && !target->readsBack) {
    printUsageError(
        "verify",
        "`" + output + "` is " + std::string(target->name) +
            ", which is not read back; verify reads CL text, CL tapes, G97 and V+ programs");
    return static_cast<int>(ExitCode::wrongUse);
  }
  if (comparison.fitShare > 0.0 && isRobotProgram(output)) {
    printUsageError("verify", "--fit compares CL files; robot programs are compared move by move");
    return static_cast<int>(ExitCode::wrongUse);
  }
  return static_cast<int>(verify(comparison, settings, interrupted));
}

}  // namespace arelem::app
