#include "runtime/film/surface_map.h"

#include <algorithm>
#include <cmath>

#include "runtime/film/bursts.h"
#include "runtime/region/region.h"
#include "runtime/spray/surface/mesh_surface.h"

namespace arelem::film {

namespace {
constexpr double surfaceCells = 200.0;
constexpr double usualSurfaceCells = 60'000.0;
constexpr double mostSurfaceCells = 250'000.0;
constexpr double cellsOfLine = 12.0;  // in the half width of the footprint
constexpr std::size_t mostSampledTriangles = 50'000;
constexpr double roughCells = 60.0;  // in the longer way
constexpr double fewestCells = 12.0;
constexpr double roughLooks = 4e7;  // of places at bursts
constexpr std::size_t roughTriangles = 4'000;
constexpr int mostDivisions = 200;  // of a triangle's side

double shareOf(std::size_t i, std::size_t count) {
  return (static_cast<double>(i) + 0.5) / static_cast<double>(count);
}

/// `cell` 0: fine enough for the picture and for the lines, as far as that is not too slow.
void divide(Map& map, double lengthU, double lengthV, double cell, double halfWidth) {
  const double fine = std::min(std::max(lengthU, lengthV) / surfaceCells, halfWidth / cellsOfLine);
  const double most = cell > 0.0 ? mostSurfaceCells : usualSurfaceCells;
  map.cell = std::max(cell > 0.0 ? cell : fine, std::sqrt(lengthU * lengthV / most));
  map.columns = static_cast<std::size_t>(std::max(1.0, std::round(lengthU / map.cell)));
  map.rows = static_cast<std::size_t>(std::max(1.0, std::round(lengthV / map.cell)));
}

/// The films of the cells on the work, whose places are in order.
void setFilms(Map& map, const Bursts& spray, const std::vector<Bursts::Place>& places) {
  const std::vector<double> films = spray.filmsAt(places);
  map.film.assign(map.onWork.size(), 0.0);
  std::size_t next = 0;
  for (std::size_t i = 0; i < map.onWork.size(); ++i) {
    if (map.onWork[i]) {
      map.film[i] = films[next++];
    }
  }
}

Map patchMap(const spray::Sprayed& s, const Bursts& spray, double cell) {
  const spray::Patch& patch = *s.patch;
  Map map;
  divide(map, longestWay(patch, true), longestWay(patch, false), cell, s.gun.footprint.across);
  map.onWork.assign(map.columns * map.rows, false);
  const double du = (patch.u1 - patch.u0) / static_cast<double>(map.columns);
  const double dv = (patch.v1 - patch.v0) / static_cast<double>(map.rows);
  std::vector<Bursts::Place> places;
  for (std::size_t r = 0; r < map.rows; ++r) {
    for (std::size_t c = 0; c < map.columns; ++c) {
      const double u = patch.u0 + (patch.u1 - patch.u0) * shareOf(c, map.columns);
      const double v = patch.v0 + (patch.v1 - patch.v0) * shareOf(r, map.rows);
      const bool kept = patch.keeps(u, v);
      map.onWork[r * map.columns + c] = kept;
      if (kept) {
        places.push_back({patch.at(u, v), patch.normal(u, v)});
      }
      const Vec3 across = patch.at(u + du / 2.0, v) - patch.at(u - du / 2.0, v);
      const Vec3 up = patch.at(u, v + dv / 2.0) - patch.at(u, v - dv / 2.0);
      map.areas.push_back(across.cross(up).norm());
    }
  }
  setFilms(map, spray, places);
  return map;
}

/// Meshes are looked at along their mean normal, closed ones along z.
region::Frame eyeOf(const spray::MeshSurface& mesh) {
  const Vec3 mean = mesh.meanNormal();
  return region::frameOf(mean.norm() > 0.0 ? mean : Vec3(Vec3::UnitZ()), Vec3::Zero());
}

/// A mesh as it is seen along its mean normal (along z where it closes on itself).
class MeshPicture {
 public:
  MeshPicture(const spray::Sprayed& s, double cell) : mesh_(*s.mesh), frame_(eyeOf(*s.mesh)) {
    const auto [left, right] = mesh_.range(frame_.x);
    const auto [bottom, top] = mesh_.range(frame_.y);
    divide(map_, right - left, top - bottom, cell, s.gun.footprint.across);
    map_.low = {left, bottom};
    const std::size_t count = map_.columns * map_.rows;
    heights_.assign(count, -HUGE_VAL);
    seen_.resize(count);
    map_.film.assign(count, 0.0);
    map_.onWork.assign(count, false);
    map_.areas.assign(count, 0.0);
  }

  Map run(const Bursts& spray) {
    for (std::size_t t = 0; t < mesh_.mesh().triangles.size(); ++t) {
      look(t);
    }
    std::vector<Bursts::Place> places;
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      if (map_.onWork[i]) {
        places.push_back({seen_[i].place, seen_[i].normal});
      }
    }
    setFilms(map_, spray, places);
    return std::move(map_);
  }

 private:
  /// The cells under a triangle that faces the eye, where none is nearer.
  void look(std::size_t t) {
    const Vec3 normal = mesh_.spanned(t);
    const double facing = normal.dot(frame_.normal);
    if (!(facing > 0.0)) {
      return;
    }
    std::array<spray::Vec2, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = frame_.inPlane(mesh_.mesh().vertices[mesh_.mesh().triangles[t][i]]);
    }
    const spray::Vec2 low = p[0].cwiseMin(p[1]).cwiseMin(p[2]);
    const spray::Vec2 high = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
    const auto first = [&](double x, double from) {
      return static_cast<std::size_t>(std::max(0.0, std::floor((x - from) / map_.cell)));
    };
    for (std::size_t r = first(low.y(), map_.low.y());
         r < map_.rows && map_.middle(0, r).y() <= high.y(); ++r) {
      for (std::size_t c = first(low.x(), map_.low.x());
           c < map_.columns && map_.middle(c, r).x() <= high.x(); ++c) {
        see(t, p, map_.middle(c, r), r * map_.columns + c, normal.norm() / facing);
      }
    }
  }

  void see(std::size_t t,
           const std::array<spray::Vec2, 3>& p,
           const spray::Vec2& eye,
           std::size_t cell,
           double slope) {
    const auto twice = [](const spray::Vec2& a, const spray::Vec2& b, const spray::Vec2& c) {
      return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
    };
    const double whole = twice(p[0], p[1], p[2]);
    const Vec3 shares =
        Vec3(twice(eye, p[1], p[2]), twice(p[0], eye, p[2]), twice(p[0], p[1], eye)) / whole;
    if (!(shares.minCoeff() >= 0.0)) {
      return;
    }
    const spray::LinePoint point = mesh_.at(t, shares);
    const double height = frame_.normal.dot(point.place);
    if (height > heights_[cell]) {
      heights_[cell] = height;
      seen_[cell] = point;
      map_.onWork[cell] = true;
      map_.areas[cell] = map_.cell * map_.cell * slope;
    }
  }

  const spray::MeshSurface& mesh_;
  region::Frame frame_;
  Map map_;
  std::vector<double> heights_;
  std::vector<spray::LinePoint> seen_;
};

/// The statistics of a mesh are those of all its triangles, seen or hidden.
Statistics statisticsOf(const spray::Sprayed& s,
                        const Bursts& spray,
                        double cell,
                        std::size_t mostTriangles) {
  const spray::MeshSurface& surface = *s.mesh;
  const std::size_t count = surface.mesh().triangles.size();
  const std::size_t stride = count / mostTriangles + 1;
  Map all;
  std::vector<Bursts::Place> places;
  for (std::size_t t = 0; t < count; t += stride) {
    const double area = surface.spanned(t).norm() / 2.0;
    const auto n =
        static_cast<int>(std::clamp(std::ceil(std::sqrt(area) / cell), 1.0, double{mostDivisions}));
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < 2 * (n - i) - 1; ++k) {
        // The middles of the n * n small triangles, row by row.
        const double up = (i + (k % 2 == 0 ? 1.0 : 2.0) / 3.0) / n;
        const double over = (k / 2 + (k % 2 == 0 ? 1.0 : 2.0) / 3.0) / n;
        const spray::LinePoint point = surface.at(t, {1.0 - up - over, over, up});
        places.push_back({point.place, point.normal});
        all.areas.push_back(area / (n * n) * static_cast<double>(stride));
      }
    }
  }
  all.film = spray.filmsAt(places);
  all.onWork.assign(all.film.size(), true);
  measure(all, s.film);
  return all.statistics;
}
}  // namespace

spray::Vec2 placeInMap(const spray::Sprayed& s,
                       const Map& map,
                       const Vec3& place,
                       const spray::Vec2& uv) {
  if (s.mesh) {
    return eyeOf(*s.mesh).inPlane(place);
  }
  const spray::Patch& p = *s.patch;
  const spray::Vec2 shares((uv.x() - p.u0) / (p.u1 - p.u0), (uv.y() - p.v0) / (p.v1 - p.v0));
  return map.low + map.cell * shares.cwiseProduct(spray::Vec2(static_cast<double>(map.columns),
                                                              static_cast<double>(map.rows)));
}

Statistics roughStatistics(const spray::Sprayed& s) {
  const Bursts spray(s);
  // Where lines lie very close, fewer places tell as much.
  const double near = std::max<double>(1.0, static_cast<double>(spray.mostNear()));
  const double cells = std::clamp(std::sqrt(roughLooks / near), fewestCells, roughCells);
  if (s.mesh) {
    const double cell = std::sqrt(s.mesh->area()) / cells;
    return statisticsOf(s, spray, cell, roughTriangles);
  }
  const double longest = std::max(longestWay(*s.patch, true), longestWay(*s.patch, false));
  Map map = patchMap(s, spray, longest / cells);
  measure(map, s.film);
  return map.statistics;
}

Map surfaceMapOf(const spray::Sprayed& s, double cell) {
  if (!s.mesh) {
    Map map = patchMap(s, Bursts(s), cell);
    measure(map, s.film);
    return map;
  }
  const Bursts spray(s);
  Map map = MeshPicture(s, cell).run(spray);
  map.statistics = statisticsOf(s, spray, map.cell, mostSampledTriangles);
  return map;
}

}  // namespace arelem::film
