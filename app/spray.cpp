#include "ir/diag/spray.h"

#include <filesystem>
#include <iostream>

#include "app/command.h"
#include "app/film_file.h"
#include "app/numbered_file.h"
#include "app/options.h"
#include "app/picture_file.h"
#include "app/progress_bar.h"
#include "app/spray_report.h"
#include <unistd.h>

#include "ir/diag/output.h"

namespace arelem::app {

namespace {
struct SprayOptions {
  Settings settings;
  std::string file;
  std::vector<std::string> films;
  double cell = 0.0;
  bool json = false;
  bool table = false;
};

constexpr double cellNoticed = 1.001;

void show(Compilation& job, const SprayOptions& options) {
  const auto& all = job.evaluation.sprayed;
  std::vector<backend::ReportedSpray> reports;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const film::Map map = film::mapOf(*all[i], options.cell);
    reports.push_back(reported(job, *all[i], &map));
    if (options.cell > 0.0 && map.cell > options.cell * cellNoticed) {
      job.log.accept(
          diagnose(all[i]->origin, diag::FilmCells, options.cell, all[i]->label(), map.cell));
    }
    const backend::FilmPicture picture =
        options.films.empty() ? backend::FilmPicture() : pictureOf(*all[i], map);
    for (const std::string& path : options.films) {
      putPicture(job.log, numbered(path, i, all.size()),
                 [&](std::ostream& out) { return writeFilm(out, path, picture); });
    }
  }
  if (options.json) {
    writeSprayJson(std::cout, reports);
    return;
  }
  for (const backend::ReportedSpray& one : reports) {
    options.table ? writeSprayTable(std::cout, one) : writeSprayText(std::cout, one);
  }
  if (reports.empty()) {
    std::cerr << "arelem: the program has no SPRAY statement\n";
  }
}
}  // namespace

int runSpray(const Invocation& invocation) {
  CLI::App app(
      "What the SPRAY statements of a part program amount to: passes, times, paint, cost, film.",
      "spray");
  SprayOptions options;
  app.add_option("FILE", options.file, "a part program; - is standard input")->required();
  app.add_flag("--json", options.json, "an array, one object a statement, with all trials");
  app.add_flag("--table", options.table, "the trials of MINCST as a table");
  app.add_option("--film", options.films,
                 "picture or table of the simulated film: .png, .svg, .csv; may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
  app.add_option("--cell", options.cell,
                 "cells of the film, mm; default: 400 in the longer way (200 of a surface), or as "
                 "many as show the passes")
      ->check(aboveZero())
      ->type_name("MM");
  addSourceOptions(app, options.settings);
  addMessageOptions(app, options.settings);
  if (const auto code = parse(app, invocation.words)) {
    return *code;
  }
  if (const std::string objection = objectionToFilms(options.films); !objection.empty()) {
    printUsageError("spray", objection);
    return static_cast<int>(ExitCode::wrongUse);
  }
  const InterruptFlag& interrupted = invocation.interrupt.flag();
  Compilation job(options.settings);
  job.progress = progressOnTerminal();
  if (load(job, options.file, interrupted) && evaluate(job, interrupted)) {
    show(job, options);
  }
  job.log.print(job.sources, job.main, options.settings);
  return static_cast<int>(job.log.exitCode());
}

}  // namespace arelem::app
