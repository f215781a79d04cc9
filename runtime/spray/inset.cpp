#include "runtime/spray/inset.h"

#include <cmath>
#include <functional>

#include "ir/diag/spray.h"

namespace arelem::spray {

namespace {
constexpr int scanSteps = 1000;
constexpr int bisections = 60;

/// The largest place u in 0 ... 1 where a falling function comes down to the level.
Result<double> lastAbove(const std::function<double(double)>& f, double level, double overlap) {
  for (int i = scanSteps; i >= 0; --i) {
    double low = static_cast<double>(i) / scanSteps;
    if (f(low) < level) {
      continue;
    }
    double high = static_cast<double>(i + 1) / scanSteps;
    for (int k = 0; k < bisections && i < scanSteps; ++k) {
      const double middle = (low + high) / 2.0;
      (f(middle) >= level ? low : high) = middle;
    }
    return low;
  }
  return fail(diag::InsetImpossible, overlap, f(0.0) / level);
}
}  // namespace

Result<double> insetByEdge(const Profile& profile, double overlap) {
  const double level = 1.0 / (2.0 * (1.0 - overlap));
  return lastAbove([&profile](double u) { return profile.density(u); }, level, overlap);
}

Result<double> insetByMean(const Profile& profile, double overlap) {
  const double level = 1.0 / (2.0 * (1.0 - overlap));
  const double middle = profile.share(0.0);
  return lastAbove(
      [&](double u) { return u == 0.0 ? profile.density(0.0) : (profile.share(u) - middle) / u; },
      level, overlap);
}

EdgeFilm edgeFilm(const Profile& profile, double overlap, double inset) {
  const double spacing = 2.0 * (1.0 - overlap);
  EdgeFilm film;
  for (int k = 0; inset + k * spacing <= 1.0; ++k) {
    const double u = inset + k * spacing;
    film.atEdge += spacing * profile.density(u);
    film.mean += inset == 0.0 ? spacing * profile.density(u)
                              : spacing * (profile.share(u) - profile.share(k * spacing)) / inset;
  }
  return film;
}

}  // namespace arelem::spray
