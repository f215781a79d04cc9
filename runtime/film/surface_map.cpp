#include "runtime/film/surface_map.h"

#include <algorithm>
#include <cmath>

#include "runtime/spray/surface/surface_lines.h"

namespace arelem::film {

namespace {
constexpr double surfaceCells = 100.0;
constexpr double piecesOfRadius = 8.0;  // of the footprint, in one piece of a stroke
constexpr double mostSurfaceCells = 250'000.0;

/// The gun for a short while: where it stands, where it points, how long.
struct Burst {
  Vec3 nozzle, axis, along;
  double seconds = 0.0;
};

class Spray {
 public:
  explicit Spray(const spray::Sprayed& s)
      : profile_(s.gun.profile()),
        a_(s.gun.footprint.along),
        b_(s.gun.footprint.across),
        d_(s.gun.standOff > 0.0 ? s.gun.standOff : 1e6),
        flow_(s.chosen.operation.flow * s.gun.efficiency) {
    const double piece = std::max(a_, b_ / piecesOfRadius) / piecesOfRadius;
    for (const spray::Stroke& stroke : s.strokes) {
      if (stroke.painting) {
        divide(stroke, piece);
      }
    }
  }

  [[nodiscard]] double filmAt(const Vec3& place, const Vec3& normal) const {
    double film = 0.0;
    for (const Burst& burst : bursts_) {
      film += one(burst, place, normal);
    }
    return film;
  }

 private:
  void divide(const spray::Stroke& s, double piece) {
    const Vec3 step = s.to - s.from;
    const double length = step.norm();
    const auto count = static_cast<int>(std::max(1.0, std::ceil(length / piece)));
    for (int i = 0; i < count; ++i) {
      const double share = (i + 0.5) / count;
      const Vec3 axis = (s.normalFrom + share * (s.normalTo - s.normalFrom)).normalized();
      bursts_.push_back(
          {s.from + share * step + d_ * axis, axis, step / length, length / count / s.speed});
    }
  }

  /// Film that one burst leaves: the density of the footprint at the stand-off, carried along the
  /// ray to the place.
  [[nodiscard]] double one(const Burst& burst, const Vec3& place, const Vec3& normal) const {
    const Vec3 ray = place - burst.nozzle;
    const double depth = -ray.dot(burst.axis);
    if (!(depth > 0.0) || !(normal.dot(ray) < 0.0)) {
      return 0.0;
    }
    const Vec3 lateral = (ray + depth * burst.axis) * (d_ / depth);
    const double y = lateral.dot(burst.axis.cross(burst.along)) / b_;
    if (!(std::abs(y) < 1.0)) {
      return 0.0;
    }
    const double half = std::max(a_, b_ / piecesOfRadius / piecesOfRadius) * std::sqrt(1.0 - y * y);
    if (!(std::abs(lateral.dot(burst.along)) < half)) {
      return 0.0;
    }
    const double length = ray.norm();
    const double nearer = d_ / depth;
    const double met = -normal.dot(ray) / length;
    const double left = depth / length;
    return flow_ * burst.seconds * profile_.density(y) / (b_ * 2.0 * half) * nearer * nearer * met /
           left;
  }

  spray::Profile profile_;
  double a_, b_, d_, flow_;
  std::vector<Burst> bursts_;
};
}  // namespace

Map surfaceMapOf(const spray::Sprayed& s, double cell) {
  const spray::Patch& patch = *s.patch;
  const double lengthU = longestWay(patch, true);
  const double lengthV = longestWay(patch, false);
  Map map;
  map.cell = cell > 0.0 ? cell : std::max(lengthU, lengthV) / surfaceCells;
  map.cell = std::max(map.cell, std::sqrt(lengthU * lengthV / mostSurfaceCells));
  map.columns = static_cast<std::size_t>(std::max(1.0, std::round(lengthU / map.cell)));
  map.rows = static_cast<std::size_t>(std::max(1.0, std::round(lengthV / map.cell)));
  map.onWork.assign(map.columns * map.rows, true);
  const Spray spray(s);
  for (std::size_t r = 0; r < map.rows; ++r) {
    for (std::size_t c = 0; c < map.columns; ++c) {
      const double u = patch.u0 + (patch.u1 - patch.u0) * (static_cast<double>(c) + 0.5) /
                                      static_cast<double>(map.columns);
      const double v = patch.v0 + (patch.v1 - patch.v0) * (static_cast<double>(r) + 0.5) /
                                      static_cast<double>(map.rows);
      map.film.push_back(spray.filmAt(patch.at(u, v), patch.normal(u, v)));
    }
  }
  measure(map, s.film);
  return map;
}

}  // namespace arelem::film
