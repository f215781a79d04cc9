#include "app/path_options.h"

#include "app/number_check.h"

namespace arelem::app {

void addFitOption(CLI::App& app, double& share) {
  app.add_option("--fit", share,
                 "puts arcs, helices and longer lines in the place of cut vectors, for this share "
                 "of INTOL + OUTTOL (0 to 1)")
      ->check(shareOfOne())
      ->type_name("SHARE");
}

}  // namespace arelem::app
