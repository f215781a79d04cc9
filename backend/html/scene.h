#pragma once
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "backend/backend.h"
#include "backend/fault_mark.h"
#include "ir/geometry/entity.h"
#include "ir/space/vector.h"

/// What the page of `arelem view` shows: pure numbers and texts, so that it can be made from any
/// run. Lengths in the part unit, seconds.
namespace arelem::backend {

/// How the tool came to a location; the gun is a bit of its own.
enum class SceneMove : std::uint8_t { start = 0, rapid = 1, feed = 2, arc = 3 };
inline constexpr std::uint8_t sceneGunOn = 16;

/// One execution of a motion statement. Deviations are NaN where none is known.
struct SceneStretch {
  std::uint32_t first = 0;           ///< its first location
  std::uint32_t line = 0;            ///< of the statement, from 1; 0 when unknown
  std::uint32_t file = 0;            ///< index into Scene::sources
  float feed = 0.0F;                 ///< as programmed; 0: none
  float inner = 0.0F, outer = 0.0F;  ///< proven bounds of the gap to drive and part surface
  float allowedInner = 0.0F, allowedOuter = 0.0F;
};

struct SceneMesh {
  std::string name;
  bool auxiliary = false;              ///< a nested drive or check surface without a name
  std::vector<float> places, normals;  ///< three a vertex
  std::vector<std::uint32_t> triangles;
};

/// A film over the cells of a grid in space, or over strips.
struct SceneFilm {
  std::string name;
  double wanted = 0.0;    ///< mm
  bool relative = false;  ///< `film` is a multiple of the mean film, which is not known
  bool strips = false;    ///< `corners` has four places a strip, `film` its values there
  std::size_t columns = 0, rows = 0;
  std::vector<float> corners;  ///< (columns + 1)(rows + 1) places, row by row
  std::vector<float> film;     ///< mm, by cells; NaN beside the work
};

struct SceneSource {
  std::string name;
  std::string text;
};

struct SceneMessage {
  bool error = false;
  std::string code, text;
  std::uint32_t file = 0, line = 0;
};

struct SceneCutter {
  std::uint32_t first = 0;  ///< location from which on it is used
  double diameter = 0.0, corner = 0.0;
};

struct Scene {
  std::string title;
  std::string unit;  ///< "mm", "units"
  Word unitWord = Word::MM;
  std::vector<SceneSource> sources;
  std::vector<SceneMessage> messages;
  std::vector<EntityPtr> entities;
  std::vector<Curves> curves;  ///< as in Context
  std::vector<SceneStretch> stretches;
  std::vector<SceneCutter> cutters;
  std::vector<FaultMark> faults;  ///< motions of the first source that are missing
  std::vector<SceneMesh> meshes;
  std::vector<double> box;  ///< low and high of x, y, z: what of the meshes is shown
  std::vector<SceneFilm> films;
  std::vector<double> places;       ///< three a location
  std::vector<float> axes;          ///< three a location, or empty: all along z
  std::vector<std::uint8_t> kinds;  ///< a location: SceneMove, with sceneGunOn
  std::vector<float> seconds;       ///< of the move that ends in a location
  bool timed = false;               ///< `seconds` come from the time law
  double gunStandOff = 0.0;         ///< of a spray gun in the place of the cutter; 0: a cutter
  double gunRadius = 0.0;
};

/// One self-contained page: the viewer that was bundled at build time, and the scene with its
/// arrays as bytes in base64. Nothing of the scene can leave the place where it stands in the page.
void writePage(std::ostream& out, const Scene& scene);

}  // namespace arelem::backend
