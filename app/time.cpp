#include "app/time.h"

#include <iostream>

#include "app/cl_input.h"
#include "app/machine.h"
#include "app/number_check.h"
#include "app/options.h"
#include "app/path_options.h"
#include "app/pipeline.h"
#include <nlohmann/json.hpp>

#include "runtime/path/arc_fit.h"

namespace arelem::app {

namespace {
struct TimeOptions {
  Settings settings;
  std::string input;
  MachineChoice machine;
  std::optional<double> velocity, acceleration, jerk, deviation, toolChange;
  double fitShare = 0.0;
  bool json = false;
  bool statements = false;
};

void addOptions(CLI::App& app, TimeOptions& options) {
  app.add_option("FILE", options.input,
                 "part program, CL text, CL tape or json; - is standard input")
      ->required();
  addMachineOptions(app, options.machine);
  const auto limit = [&](const char* name, std::optional<double>& value, const char* help,
                         const CLI::Validator& check) {
    app.add_option(name, value, help)->check(check)->type_name("NUMBER");
  };
  const CLI::Validator positive = positiveNumber();
  limit("--velocity", options.velocity, "largest speed, also of rapid moves, mm/s (400)", positive);
  limit("--acceleration", options.acceleration, "largest acceleration, mm/s2 (4000)", positive);
  limit("--jerk", options.jerk, "largest jerk, mm/s3 (20000)", positive);
  limit("--deviation", options.deviation,
        "mm by which corners may be rounded; 0: the tool stops in each (0.01)", numberFromZero());
  limit("--tool-change", options.toolChange, "seconds of a tool change (10)", numberFromZero());
  app.add_flag("--statements", options.statements, "the time of each statement too");
  app.add_flag("--json", options.json, "the result as JSON");
  addFitOption(app, options.fitShare);
  addSourceOptions(app, options.settings);
  addMessageOptions(app, options.settings);
}

/// What the machine file says, and over it the options.
Result<timing::Machine> machineOf(const TimeOptions& options) {
  const Result<std::optional<robot::Machine>> read = loadMachine(options.machine, options.settings);
  if (!read) {
    return read.failure();
  }
  timing::Machine machine = timingMachine(read->has_value() ? &**read : nullptr);
  machine.limits.velocity = options.velocity.value_or(machine.limits.velocity);
  machine.limits.acceleration = options.acceleration.value_or(machine.limits.acceleration);
  machine.limits.jerk = options.jerk.value_or(machine.limits.jerk);
  machine.deviation = options.deviation.value_or(machine.deviation);
  machine.toolChange = options.toolChange.value_or(machine.toolChange);
  return machine;
}

/// Line of the first record of a statement, by its number.
class Lines : public cl::RecordSink {
 public:
  explicit Lines(timing::CutTimer& next) : next_(next) {}
  void accept(const cl::Record& record) override {
    places.emplace(record.isn, record.origin);
    next_.accept(record);
  }
  std::map<int, Span> places;

 private:
  timing::CutTimer& next_;
};

void printTable(const Compilation& job,
                const Lines& lines,
                const timing::TimeTable& table,
                bool statements) {
  std::cout << fmt::format(
      "total {:.3f} s\n"
      "   cutting {:.3f} s, {:.3f} mm\n"
      "   rapid {:.3f} s, {:.3f} mm\n"
      "   dwell {:.3f} s\n"
      "   {} tool changes {:.3f} s\n"
      "   {} moves\n",
      table.total(), table.cutting, table.cuttingLength, table.rapid, table.rapidLength,
      table.dwell, table.changes, table.toolChanges, table.moves);
  if (!statements) {
    return;
  }
  for (const auto& [isn, seconds] : table.statements) {
    const Span& at = lines.places.at(isn);
    std::cout << fmt::format("   {:>10.3f} s  {}:{}\n", seconds, job.sources.name(at.buffer),
                             job.sources.locate(at.buffer, at.begin).line);
  }
}

void printJson(const Compilation& job, const Lines& lines, const timing::TimeTable& table) {
  nlohmann::ordered_json all = {{"total", table.total()},
                                {"cutting", table.cutting},
                                {"rapid", table.rapid},
                                {"dwell", table.dwell},
                                {"toolChanges", table.toolChanges},
                                {"changes", table.changes},
                                {"moves", table.moves},
                                {"cuttingLength", table.cuttingLength},
                                {"rapidLength", table.rapidLength}};
  for (const auto& [isn, seconds] : table.statements) {
    const Span& at = lines.places.at(isn);
    all["statements"].push_back({{"isn", isn},
                                 {"line", job.sources.locate(at.buffer, at.begin).line},
                                 {"seconds", seconds}});
  }
  std::cout << all.dump(1) << '\n';
}
}  // namespace

int runTime(const Invocation& invocation) {
  CLI::App app(
      "Tells how long a machine takes for the path of a part program: speed limited by feed, "
      "curvature and corners,\nacceleration and jerk by the machine (MACHLM in the program, or the "
      "options), looking ahead over the whole path.",
      "time");
  TimeOptions options;
  addOptions(app, options);
  if (const auto code = parse(app, invocation.words)) {
    return *code;
  }
  const InterruptFlag& interrupted = invocation.interrupt.flag();
  Compilation job(options.settings);
  Result<timing::Machine> machine = machineOf(options);
  if (!machine) {
    job.log.accept(machine.takeFailure());
    job.log.print(job.sources, job.main, options.settings);
    return static_cast<int>(job.log.exitCode());
  }
  timing::CutTimer timer(*machine, job.log);
  Lines lines(timer);
  const auto fitter = path::makeArcFitter(lines, options.fitShare);
  Result<ClFile> file = ClFile::open(options.input, options.settings.limits);
  if (!file) {
    job.log.accept(file.takeFailure());
    job.log.print(job.sources, job.main, options.settings);
    return static_cast<int>(job.log.exitCode());
  }
  const bool done = readRecords(job, *file, *fitter, interrupted);
  fitter->finish();
  if (done) {
    const timing::TimeTable table = timer.finish();
    if (job.log.errors() == 0) {
      options.json ? printJson(job, lines, table)
                   : printTable(job, lines, table, options.statements);
    }
  }
  job.log.print(job.sources, job.main, options.settings);
  return static_cast<int>(job.log.exitCode());
}

}  // namespace arelem::app
