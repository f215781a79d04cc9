#include "app/film_warnings.h"

#include <cmath>

#include "app/pipeline.h"

#include "ir/diag/render_text.h"
#include "ir/diag/spray.h"
#include "runtime/film/map.h"
#include "runtime/film/surface_map.h"

namespace arelem::app {

namespace {
constexpr double noticedShare = 0.02;  // of the area of a surface
constexpr double noticedMean = 0.15;   // of the film
constexpr double micrometers = 1e3;
}  // namespace

void warnOfFilms(Compilation& job) {
  for (const auto& sprayed : job.evaluation.sprayed) {
    if (sprayed->planar) {
      continue;
    }
    const film::Statistics rough = film::roughStatistics(*sprayed);
    const bool uneven = rough.astray >= noticedShare;
    if (!uneven && std::abs(rough.mean / rough.wanted - 1.0) <= noticedMean) {
      continue;
    }
    // What is told has the figures that the report has.
    const film::Statistics film = film::mapOf(*sprayed, 0.0).statistics;
    if (!uneven) {
      job.log.accept(diagnose(sprayed->origin, diag::SprayMean, micrometers * film.mean,
                              sprayed->label(), micrometers * film.wanted)
                         .withHelp("PAST sprays over the edges; `arelem spray --film film.png` "
                                   "shows where it lacks"));
      continue;
    }
    job.log.accept(
        diagnose(sprayed->origin, diag::SprayUneven, micrometers * film.smallest,
                 micrometers * film.largest, sprayed->label(), 100.0 * film.astray,
                 micrometers * film.wanted, micrometers * film.mean)
            .withHelp("`arelem spray --film film.png` shows where; other lines, a smaller STEP or "
                      "narrower LIMITS make it more even"));
  }
}

}  // namespace arelem::app
