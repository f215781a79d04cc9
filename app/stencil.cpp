#include <filesystem>
#include <iostream>

#include "app/command.h"
#include "app/film_file.h"
#include "app/numbered_file.h"
#include "app/options.h"
#include "app/picture_file.h"
#include "app/stencil_report.h"

#include "backend/film/picture.h"
#include "ir/diag/output.h"

namespace arelem::app {

namespace {
struct StencilOptions {
  Settings settings;
  std::string file;
  std::vector<std::string> films;
  std::vector<std::string> shares;
  double cell = 0.0;
  bool json = false;
};

std::string suffixOf(const std::string& path) {
  return std::filesystem::path(path).extension().string();
}

bool writeStencilFilm(std::ostream& out,
                      const std::string& path,
                      const stencil::Painted& painted,
                      double cell) {
  if (suffixOf(path) == ".svg") {
    writeCellsSvg(out, filmPictureOf(painted));
    return true;
  }
  if (suffixOf(path) == ".csv") {
    writeCellsCsv(out, painted);
    return true;
  }
  const double wanted = painted.meanFilm() > 0.0 ? painted.meanFilm() : 1.0;
  const film::Map map = stencil::filmMap(
      stencil::filmPatches(painted.tracks, painted.statement.job.gun), cell, wanted);
  backend::FilmPicture picture = pictureOf(map, wanted);
  picture.relative = !(painted.meanFilm() > 0.0);
  picture.title = painted.statement.text;
  return writeFilm(out, path, picture);
}

void show(Compilation& job, const StencilOptions& options) {
  const auto& all = job.evaluation.stencils;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const std::string& path : options.films) {
      putPicture(job.log, numbered(path, i, all.size()), [&](std::ostream& out) {
        return writeStencilFilm(out, path, *all[i], options.cell);
      });
    }
    for (const std::string& path : options.shares) {
      putPicture(job.log, numbered(path, i, all.size()), [&](std::ostream& out) {
        writeCellsSvg(out, sharePictureOf(*all[i]));
        return true;
      });
    }
  }
  if (options.json) {
    return printStencilsJson(std::cout, job);
  }
  for (const auto& painted : all) {
    printStencil(std::cout, job, *painted);
  }
  if (all.empty()) {
    std::cerr << "arelem: the program has no STENCL statement\n";
  }
}

std::string objectionTo(const StencilOptions& options) {
  if (std::string objection = objectionToFilms(options.films); !objection.empty()) {
    return objection;
  }
  for (const std::string& path : options.shares) {
    if (suffixOf(path) != ".svg") {
      return "shares are drawn as .svg, not as `" + path + "`";
    }
  }
  return "";
}
}  // namespace

int runStencil(const Invocation& invocation) {
  CLI::App app(
      "What the STENCL statements of a part program amount to: strokes, times, tilt, film.",
      "stencil");
  StencilOptions options;
  app.add_option("FILE", options.file, "a part program; - is standard input")->required();
  app.add_flag("--json", options.json, "an array, one object a statement");
  app.add_option(
         "--film", options.films,
         "film over its mean: contours .svg, picture .png, table of cells .csv; may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
  app.add_option("--shares", options.shares,
                 "how the paint's halves share the area of each cell: .svg; may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
  app.add_option("--cell", options.cell, "cells of the .png, mm; default: 1500 in the longer way")
      ->check(aboveZero())
      ->type_name("MM");
  addSourceOptions(app, options.settings);
  addMessageOptions(app, options.settings);
  if (const auto code = parse(app, invocation.words)) {
    return *code;
  }
  if (const std::string objection = objectionTo(options); !objection.empty()) {
    printUsageError("stencil", objection);
    return static_cast<int>(ExitCode::wrongUse);
  }
  const InterruptFlag& interrupted = invocation.interrupt.flag();
  Compilation job(options.settings);
  if (load(job, options.file, interrupted) && evaluate(job, interrupted)) {
    show(job, options);
  }
  job.log.print(job.sources, job.main, options.settings);
  return static_cast<int>(job.log.exitCode());
}

}  // namespace arelem::app
