#include "app/view/scene_surfaces.h"

#include <algorithm>
#include <limits>
#include <map>

#include "app/view/film_frames.h"
#include "app/view/surface_mesh.h"

#include "ir/words/units.h"
#include "runtime/film/map.h"
#include "runtime/spray/surface/patch.h"
#include "runtime/stencil/film.h"
#include "runtime/stencil/stencil.h"

namespace arelem::app {

namespace {
constexpr std::size_t mostMeshes = 40;
constexpr int meshCells = 56;        // in the longest way of the path
constexpr double meshMargin = 0.08;  // of the path's size
constexpr double leastDepth = 0.10;  // of the size: how deep the box of a flat path is
constexpr double meshRim = 0.08;  // of the size: how far meshes reach beyond the box that is shown
constexpr double filmCells = 160.0;  // in the longest way
constexpr std::size_t mostStrips = 200'000;

struct Used {
  EntityPtr entity;
  bool part = false;  ///< it was a part surface somewhere
};

/// Surfaces that motions run along or to, each once, in order; those with a name first.
std::vector<Used> surfacesOf(const Compilation& job) {
  std::vector<Used> found;
  std::map<std::pair<EntityType, std::vector<double>>, std::size_t> known;
  const auto add = [&](const EntityPtr& e, bool part = false) {
    if (!e) {
      return;
    }
    const auto [place, fresh] = known.try_emplace({e->type, e->canon}, found.size());
    if (fresh) {
      found.push_back({e, part});
    }
    found[place->second].part = found[place->second].part || part;
  };
  for (const runtime::Action& action : job.evaluation.actions) {
    if (const auto* go = std::get_if<runtime::Startup>(&action.body)) {
      for (const auto& use : go->surfaces) {
        add(use.surface);
      }
    } else if (const auto* follow = std::get_if<runtime::Follow>(&action.body)) {
      add(follow->drive);
      for (const auto& check : follow->checks) {
        add(check.use.surface);
      }
    } else if (const auto* part = std::get_if<runtime::PartSurface>(&action.body)) {
      add(part->surface, true);
    }
  }
  std::stable_partition(found.begin(), found.end(),
                        [](const Used& u) { return u.part || !u.entity->name.empty(); });
  return found;
}

/// The box of the path, deep enough that walls can be seen.
bool boxOf(const backend::Scene& scene, Vec3& low, Vec3& high) {
  if (scene.places.empty()) {
    return false;
  }
  low = high = Vec3(scene.places[0], scene.places[1], scene.places[2]);
  for (std::size_t i = 3; i + 2 < scene.places.size(); i += 3) {
    const Vec3 p(scene.places[i], scene.places[i + 1], scene.places[i + 2]);
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double size = (high - low).norm();
  double cutter = 0.0;
  for (const auto& c : scene.cutters) {
    cutter = std::max(cutter, 0.5 * c.diameter);
  }
  const Vec3 margin = Vec3::Constant(meshMargin * size + cutter);
  low -= Vec3(margin.x(), margin.y(), 0.02 * size);
  high += Vec3(margin.x(), margin.y(), 0.0);
  high.z() = std::max(high.z(), low.z() + leastDepth * size);
  return size > 0.0;
}

Vec3 placeOf(const spray::Sprayed& s, const film::Map& map, double column, double row) {
  if (s.planar) {
    const double x = map.low.x() + map.cell * column;
    const double y = map.low.y() + map.cell * row;
    return s.origin3 + x * s.x + y * s.y;
  }
  const spray::Patch& p = *s.patch;
  return p.at(p.u0 + (p.u1 - p.u0) * column / static_cast<double>(map.columns),
              p.v0 + (p.v1 - p.v0) * row / static_cast<double>(map.rows));
}

double longestOf(const spray::Sprayed& s) {
  double size = 1.0;
  for (const spray::Stroke& stroke : s.strokes) {
    size = std::max({size, (stroke.to - s.strokes.front().from).norm(),
                     (stroke.from - s.strokes.front().from).norm()});
  }
  return size;
}

}  // namespace

void addMeshes(const Compilation& job, backend::Scene& scene, const InterruptFlag& interrupted) {
  Vec3 low, high;
  if (!boxOf(scene, low, high)) {
    return;
  }
  for (int k = 0; k < 3; ++k) {
    scene.box.push_back(low[k]);
    scene.box.push_back(high[k]);
  }
  // A mesh ends in whole cells: it reaches beyond the box, where the page cuts it off.
  const Vec3 rim = Vec3::Constant(meshRim * (high - low).norm());
  for (const Used& used : surfacesOf(job)) {
    const Entity& entity = *used.entity;
    if (scene.meshes.size() >= mostMeshes || interrupted) {
      addNote(scene, fmt::format("only the first {} surfaces are shaded", mostMeshes));
      return;
    }
    const auto surface = surface::surfaceOf(entity);
    if (!surface) {
      continue;
    }
    if (auto mesh = meshOf(*surface, low - rim, high + rim, meshCells)) {
      mesh->name = entity.name.empty() ? std::string(spell(entity.type)) : entity.name;
      mesh->auxiliary = entity.name.empty() && !used.part;
      scene.meshes.push_back(*std::move(mesh));
    }
  }
}

void addFilms(const Compilation& job, backend::Scene& scene) {
  const double unit = millimetersOf(scene);
  FilmFrames frames(job);
  for (const auto& sprayed : job.evaluation.sprayed) {
    const path::Affine moved = frames.next(sprayed->origin);
    const film::Map map =
        film::mapOf(*sprayed, sprayed->planar ? longestOf(*sprayed) / filmCells : 0.0);
    backend::SceneFilm film;
    film.name = sprayed->work.empty() ? "SPRAY" : sprayed->work;
    film.wanted = sprayed->film;
    film.columns = map.columns;
    film.rows = map.rows;
    for (std::size_t r = 0; r <= map.rows; ++r) {
      for (std::size_t c = 0; c <= map.columns; ++c) {
        const Vec3 p = moved.point(
            placeOf(*sprayed, map, static_cast<double>(c), static_cast<double>(r)) / unit);
        for (int k = 0; k < 3; ++k) {
          film.corners.push_back(static_cast<float>(p[k]));
        }
      }
    }
    for (std::size_t i = 0; i < map.film.size(); ++i) {
      film.film.push_back(map.onWork[i] ? static_cast<float>(map.film[i])
                                        : std::numeric_limits<float>::quiet_NaN());
    }
    scene.films.push_back(std::move(film));
    scene.gunStandOff = sprayed->gun.standOff / unit;
    scene.gunRadius = sprayed->gun.footprint.across / unit;
  }
}

void addStencilFilms(const Compilation& job, backend::Scene& scene) {
  const double unit = millimetersOf(scene);
  FilmFrames frames(job);
  for (const auto& painted : job.evaluation.stencils) {
    const path::Affine moved = frames.next(painted->origin);
    const auto patches = stencil::filmPatches(painted->tracks, painted->statement.job.gun);
    if (patches.size() > mostStrips) {
      addNote(scene, "the film of a stencil is too long to be shown: use arelem stencil --film");
      continue;
    }
    backend::SceneFilm film;
    film.name = painted->statement.text;
    film.relative = !(painted->meanFilm() > 0.0);
    film.wanted = film.relative ? 1.0 : painted->meanFilm();
    film.strips = true;
    for (const stencil::FilmPatch& patch : patches) {
      for (std::size_t i = 0; i < patch.corner.size(); ++i) {
        const Vec3 onRoad(patch.corner[i].x() / unit, patch.corner[i].y() / unit, 0.0);
        const Vec3 road = painted->across * onRoad.x() + painted->along * onRoad.y();
        const Vec3 p = moved.point(painted->base + road);
        for (int k = 0; k < 3; ++k) {
          film.corners.push_back(static_cast<float>(p[k]));
        }
        film.film.push_back(static_cast<float>(patch.film[i] * film.wanted));
      }
    }
    scene.films.push_back(std::move(film));
  }
}

void addNote(backend::Scene& scene, std::string text) {
  scene.messages.push_back({false, "", std::move(text), 0, 0});
}

double millimetersOf(const backend::Scene& scene) {
  return millimetersOf(scene.unitWord);
}

}  // namespace arelem::app
