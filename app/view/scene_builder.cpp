#include "app/view/scene_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "app/view/path_trace.h"
#include "app/view/surface_mesh.h"

#include "runtime/certify/certificate.h"
#include "runtime/film/map.h"
#include "runtime/spray/surface/patch.h"

namespace arelem::app {

namespace {
constexpr std::size_t mostMeshes = 40;
constexpr int meshCells = 56;                  // in the longest way of the path
constexpr double meshMargin = 0.08;            // of the path's size
constexpr double leastDepth = 0.10;            // of the size: how deep the box of a flat path is
constexpr double filmCells = 160.0;            // in the longest way
constexpr std::uint64_t mostProven = 300'000;  // cut vectors; proofs of longer paths take minutes
constexpr std::size_t mostMessages = 500;

std::string unitOf(const Compilation& job) {
  for (const runtime::Action& action : job.evaluation.actions) {
    const auto* pass = std::get_if<runtime::Pass>(&action.body);
    const auto* units = pass == nullptr ? nullptr : std::get_if<cl::Units>(&pass->body);
    if (units != nullptr) {
      std::string text(spell(units->unit));
      std::transform(text.begin(), text.end(), text.begin(),
                     [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      return text;
    }
  }
  return "units";
}

double millimetersOf(const std::string& unit) {
  return unit == "cm" ? 10.0 : unit == "inches" ? 25.4 : unit == "feet" ? 304.8 : 1.0;
}

void addSources(const Compilation& job, backend::Scene& scene) {
  for (std::uint32_t i = 0; i < job.sources.size(); ++i) {
    const BufferId buffer{i};
    scene.sources.push_back(
        {std::string(job.sources.name(buffer)), std::string(job.sources.text(buffer))});
  }
}

void addMessages(const Compilation& job, backend::Scene& scene) {
  for (const Diagnostic& d : job.log.all()) {
    if (scene.messages.size() >= mostMessages) {
      return;
    }
    backend::SceneMessage message;
    message.error = d.severity() == Severity::error;
    message.code = d.kind().code;
    message.text = d.message;
    const Span at = d.at;
    if (at.buffer.index < job.sources.size()) {
      message.file = at.buffer.index;
      message.line = job.sources.locate(at.buffer, at.begin).line;
    }
    scene.messages.push_back(std::move(message));
  }
}

void addNote(backend::Scene& scene, std::string text) {
  scene.messages.push_back({false, "", std::move(text), 0, 0});
}

/// The bounds that were proven, for the stretch of the same execution of each statement.
void addBounds(const certify::Certificate& certificate,
               const std::vector<int>& isns,
               backend::Scene& scene) {
  const auto& results = certificate.results();
  std::size_t next = 0;
  for (std::size_t i = 0; i < isns.size(); ++i) {
    std::size_t found = next;
    while (found < results.size() && results[found].isn != isns[i]) {
      ++found;
    }
    if (found == results.size()) {
      continue;
    }
    next = found + 1;
    backend::SceneStretch& stretch = scene.stretches[i];
    for (const auto& guide : {results[found].drive, results[found].part}) {
      if (!guide) {
        continue;
      }
      const auto low = static_cast<float>(guide->result.verdict.least.proven);
      const auto high = static_cast<float>(guide->result.verdict.greatest.proven);
      const bool first = std::isnan(stretch.inner);
      stretch.inner = first ? low : std::min(stretch.inner, low);
      stretch.outer = first ? high : std::max(stretch.outer, high);
      stretch.allowedInner = static_cast<float>(guide->allowed.inner);
      stretch.allowedOuter = static_cast<float>(guide->allowed.outer);
    }
  }
}

/// Surfaces that motions run along or to, each once, in order.
std::vector<EntityPtr> surfacesOf(const Compilation& job) {
  std::vector<EntityPtr> found;
  std::set<std::pair<EntityType, std::vector<double>>> known;
  const auto add = [&](const EntityPtr& e) {
    if (e && known.emplace(e->type, e->canon).second) {
      found.push_back(e);
    }
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
      add(part->surface);
    }
  }
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

void addMeshes(const Compilation& job, backend::Scene& scene, const InterruptFlag& interrupted) {
  Vec3 low, high;
  if (!boxOf(scene, low, high)) {
    return;
  }
  for (const EntityPtr& entity : surfacesOf(job)) {
    if (scene.meshes.size() >= mostMeshes || interrupted) {
      addNote(scene, fmt::format("only the first {} surfaces are shaded", mostMeshes));
      return;
    }
    const auto surface = surface::surfaceOf(*entity);
    if (!surface) {
      continue;
    }
    if (auto mesh = meshOf(*surface, low, high, meshCells)) {
      mesh->name = entity->name.empty() ? std::string(spell(entity->type)) : entity->name;
      scene.meshes.push_back(*std::move(mesh));
    }
  }
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

void addFilms(const Compilation& job, backend::Scene& scene) {
  const double unit = millimetersOf(scene.unit);
  for (const auto& sprayed : job.evaluation.sprayed) {
    const film::Map map =
        film::mapOf(*sprayed, sprayed->planar ? longestOf(*sprayed) / filmCells : 0.0);
    backend::SceneFilm film;
    film.name = sprayed->work.empty() ? "SPRAY" : sprayed->work;
    film.wanted = sprayed->film;
    film.columns = map.columns;
    film.rows = map.rows;
    for (std::size_t r = 0; r <= map.rows; ++r) {
      for (std::size_t c = 0; c <= map.columns; ++c) {
        const Vec3 p =
            placeOf(*sprayed, map, static_cast<double>(c), static_cast<double>(r)) / unit;
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
}  // namespace

backend::Scene buildScene(Compilation& job, const InterruptFlag& interrupted) {
  backend::Scene scene;
  scene.unit = unitOf(job);
  addSources(job, scene);
  PathTrace trace(scene, job.sources);
  certify::Options options;
  options.file = std::string(job.sources.name(job.main));
  options.limits = job.settings.limits;
  options.interrupted = &interrupted;
  CollectingSink faults;  // what the certificate finds is shown as bounds, not as an error
  const auto certificate = certify::makeCertificate(job.evaluation.actions, options, faults);
  cl::Recording path;
  static_cast<void>(execute(job, path, interrupted));
  const bool proven = job.motion.cutVectors <= mostProven && job.motion.complete;
  for (const cl::Record& record : path.records) {
    trace.accept(record);
    if (proven) {
      certificate->accept(record);
    }
  }
  trace.finish();
  if (proven && !interrupted) {
    certificate->finish();
    addBounds(*certificate, trace.isns(), scene);
  } else if (job.motion.cutVectors > mostProven) {
    addNote(scene, fmt::format("deviations of more than {} cut vectors are not proven here: use "
                               "arelem verify",
                               mostProven));
  }
  addMeshes(job, scene, interrupted);
  addFilms(job, scene);
  for (const runtime::Defined& defined : job.evaluation.defined) {
    if (defined.entity && !defined.name.empty()) {
      scene.entities.push_back(defined.entity);
    }
  }
  if (scene.title.empty()) {
    scene.title = std::string(job.sources.name(job.main));
  }
  addMessages(job, scene);
  return scene;
}

}  // namespace arelem::app
