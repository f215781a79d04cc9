// Random scenes of motion; tests/README.md tells how to use it.
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "tests/random/runner.h"

namespace {
using namespace arelem;

void addOptions(CLI::App& app, scenes::Request& request) {
  // `./dev random` gives some of them, and its caller others.
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.add_option("--seed", request.seed, "scenes follow from it, their pair and their number (1)");
  app.add_option("--each", request.each, "scenes of every pair of kinds (1)");
  app.add_option("--pair", request.pair, "PART,DRIVE: only scenes of this pair of kinds");
  app.add_option("--kinds", request.kinds, "KIND,...: only scenes of pairs of these kinds")
      ->delimiter(',')
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.add_option("--first", request.first, "number of the first scene of every pair (0)");
  app.add_option("--only", request.only,
                 "SEED:PART,DRIVE,NUMBER: this one scene, with its program");
  app.add_option("--jobs", request.jobs, "threads (one for each core)");
  app.add_option("--found", request.found,
                 "folder for the programs of scenes that fail, and of that of --only");
  app.add_option("--table", request.table,
                 "table of counts: goes on behind the scenes that it has, and adds to it");
  app.add_option("--commit", request.commit, "of the motion: told in the head of the table");
  app.add_flag("--anew", request.anew, "forgets what table and list of failures have");
  app.add_option("--failures", request.failures,
                 "list of scenes that are known to fail; with --table it is added to");
  app.add_flag("--again", request.again, "runs the scenes of the list of failures once more");
  app.add_option("--minutes", request.minutes, "begins no scene after this time");
  app.add_flag("--times", request.times, "tells at the end what the scenes of each pair cost");
  app.add_option("--slow", request.slow, "tells of scenes that take longer, seconds");
}
}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Random scenes of tool, drive, part and check surface: proven, and the same moved.");
  scenes::Request request;
  addOptions(app, request);
  CLI11_PARSE(app, argc, argv);
  try {
    return scenes::run(request) ? 0 : 1;
  } catch (const std::exception& e) {
    fmt::print(stderr, "random_scenes: {}\n", e.what());
    return 2;
  }
}
